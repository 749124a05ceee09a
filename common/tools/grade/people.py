"""Who the students are, by a class list, and the points that an instructor gave by hand: two tables
that are read."""
import contextlib
import csv
import dataclasses
import io
import re
import unicodedata
from pathlib import Path

from results import GradeError, clean, counted, nfc
from submissions import Submission, search

# How the exports of learning systems, and people, head the columns, without accents: in English,
# German, French, Spanish, Norwegian and Chinese. Brackets behind a word, as "Apellido(s)", go.
HEADS = {
    'id': 'folder|id|sid|identifier|id[- ]?number|user ?id|user ?name|login( id)?|orgdefinedid|'
          'sis (user|login) id|student[- _]?(id|no|number)|e-?mail([- ]ad(d)?resse?)?|id-?nummer|'
          '(matrikel|student|kandidat)-?(nummer|nr[.]?)|anmeldename|benutzername|nutzername|'
          'teilnehmernummer|kennung|(numero|n.|no) (d.)?(identification|etudiant)|identifiant|'
          'matricule|nom d.utilisateur|id (de l.)?etudiant|'
          '(adresse (de )?)?(courriel|e-?mail|messagerie)|numero de (id|identificacion|matricula)|'
          'matricula|identificador|identifikator|id del? (estudiante|usuario)|'
          '(nombre de )?usuario|(direccion de )?(correo|e-?mail)( electronico)?|dni|brukernavn|'
          'nia|e-?post(adresse)?|学号|学生 ?(id|编号|号)|编号|工号|用户名|'
          '登录名?|登录id|id号|识别号|身份标识|'
          '(电子)?(邮件|邮箱)(地址)?|學號|使用者名稱|電子郵件',
    'name': 'student|name|person|full name|student name|display name|vollstandiger name|'
            'vor- und nachname|nachname, ?vorname|last name, ?first name|nom|nom complet|'
            'nom et prenom|etudiant(.e)?|nombre|nombre completo|'
            'nombre y apellidos|apellidos y nombre|estudiante|alumno|navn|fullt navn|'
            '姓名|全名|学生|学生姓名|名字|名称|學生',
    'last': 'last ?name|surname|family name|last|nachname|familienname|nom d(e famille|.usage)|'
            'apellidos?|etternavn|姓|姓氏',
    'first': 'first ?names?|given names?|first|vorname|prenom|prenoms|nombre de pila|fornavn|名',
    'group': '(group|team)( ?name)?|groups|gruppen?|gruppenname|groupes?|equipe|grupos?|equipo|'
             'gruppenavn|小组|组|分组|小组名称|組',
    'chapter': 'chapter|exercise', 'points': 'points', 'note': 'note'}
# The name of what there is no other column for: "Nom" beside "Prénom" is the last name.
SHORT = 'name|nom|nombre|navn|名字'
# The first that the text can be, and in which a line is a head.
ENCODINGS = 'utf-8-sig', 'gb2312', 'cp1252', 'gb18030', 'latin-1'
NOBODY = ('points possible', 'student, test', 'test student')  # lines of Canvas's gradebook


@dataclasses.dataclass(eq=False)
class Line:
    """A line of a table."""
    number: int
    cells: dict  # by the kind of a column: what is in those columns

    def cell(self, kind):
        return next(iter(self.cells.get(kind, [])), '')

    @property
    def person(self):
        """The name as one says it."""
        name = self.cell('name') or ', '.join(filter(None, (self.cell('last'), self.cell('first'))))
        last, comma, first = name.partition(',')
        blank = ' ' * (not re.match('[\u3400-\u9fff]', last))  # 王, 小明 is 王小明
        words = [first.strip(), last.strip()][::1 if blank else -1]
        return nfc(blank.join(words) if comma else name)

    @property
    def ids(self):
        """All that could be the student's id: Moodle's "Participant 12345" is 12345, the address
        ada@x.org is ada."""
        words = [word for cell in self.cells.get('id', [])
                 for word in (cell, cell.partition('@')[0], *re.findall(r' (\d+)$', cell))]
        return {nfc(word).strip('#= "').casefold() for word in words}


def plain(text):
    """The text in small letters without accents."""
    return ''.join(letter for letter in unicodedata.normalize('NFKD', text.casefold())
                   if not unicodedata.combining(letter))


def kinds_of(cells, columns):
    """For each cell of a head the kind of the column; columns has those that are named by hand."""
    words = [re.sub(r'[(（/:].*', '', plain(cell).strip(' #"*\ufeff')).strip() for cell in cells]
    kinds = [next((kind for kind, names in HEADS.items() if re.fullmatch(names, word)), '')
             for word in words]
    if columns:
        return [columns.get(cell.strip().casefold(), '') for cell in cells]
    for given, other in (('first', 'last'), ('last', 'first')):
        if given in kinds and other not in kinds:
            kinds = [other if re.fullmatch(SHORT, word) else kind
                     for kind, word in zip(kinds, words)]
    return kinds


def lines_of(path, needed, typed=''):
    """The lines of a table with commas, semicolons or tabs. Its head is the first line with a
    column of each needed kind. Typed: name=HEAD,id=HEAD says which columns these are."""
    columns = {}
    for word in filter(None, typed.split(',')):
        kind, _, head = word.partition('=')
        if kind not in ('name', 'first', 'last', 'id', 'group') or not head:
            raise GradeError(f"--columns takes such as name=Student,id=Number, not '{word}'; it "
                             'knows name, first, last, id and group')
        columns[nfc(head).strip().casefold()] = kind
    data = Path(path).read_bytes()
    if data[:2] == b'PK':
        raise GradeError(f'{clean(str(path))} is a spreadsheet: save it as CSV')
    heads = []
    for encoding in ('utf-16', ) if data[:2] in (b'\xff\xfe', b'\xfe\xff') else ENCODINGS:
        with contextlib.suppress(UnicodeError, csv.Error):
            text = data.decode(encoding)
            comma = max(';\t,', key=text.count)  # "Last name, First name;ID" has as many of two
            table = [[nfc(cell).strip() for cell in cells] for cells in csv.reader(
                io.StringIO(text, newline=''), delimiter=comma)]
            heads = heads or next((cells for cells in table if any(cells)), [])
            for number, cells in enumerate(table):
                kinds = kinds_of(cells, columns)
                if any(set(kinds) >= set(one.split()) for one in needed):
                    return read_lines(table, number, kinds)
    raise GradeError(
        f"{clean(str(path))}: no line names the columns {' or '.join(needed)}. Its first line has: "
        f"{', '.join(map(clean, heads))}. Heads such as Student, Full name, Last name and First "
        'name, ID or Email would do; --columns name=HEAD,id=HEAD names others')


def read_lines(table, head, kinds):
    """The lines of persons behind the head."""
    lines = []
    for number, cells in enumerate(table[head + 1:], head + 2):
        found = {}
        for kind, cell in zip(kinds, cells):
            found.setdefault(kind, []).extend([cell] if cell else [])
        line = Line(number, found)
        if (line.person or line.ids) and line.cell('name').casefold() not in NOBODY:
            lines.append(line)
    return lines


def keys(name):
    """What is the same for all ways to write a name: its words without accents in any order, as
    one; Canvas leaves out the blanks."""
    words = re.findall(r'[^\W_]+', plain(name))
    return {''.join(words[i:] + words[:i]) for i in range(len(words))}


def join_class_list(path, submissions, chapters, columns=''):
    """Sets ids and persons from a class list: by id, then by name, if nobody else has that name. A
    group's work is that of each in it. Who has several submissions gets one. Adds who handed in
    nothing. Says who these are, and who is not in the list; and, if most of both are so, that the
    list was not understood."""
    people = lines_of(path, ['id', 'name', 'last first'], columns)
    names = {one: keys(one.person) for one in people}

    def named_as(one):
        # the name, or what is behind a hyphen, which may be behind a group: "Group 1-Jane Doe"
        words = one.person.split('-')
        found = ([person for person in people if keys('-'.join(words[i:])) & names[person]]
                 for i in range(len(words)))
        return next(filter(None, found), [])

    by_name, joined, by_id = {}, {}, {}
    for one in list(submissions):
        names[one] = keys(one.person)
        by_name[one] = named_as(one)
        members = [person for person in people if not by_name[one] and any(
            names[one] & keys(group) for group in person.cells.get('group', []))]
        if members:
            here = submissions.index(one)
            submissions[here:here + 1] = copies = [dataclasses.replace(
                one, name=person.person, id=person.cell('id')) for person in members]
            for copy, person in zip(copies, members):
                joined[copy], by_name[copy] = [person], [person]
                names[copy] = names[person]
    for one in submissions:
        ids = {nfc(word).casefold() for word in (one.id or one.name, *one.other_ids)}
        by_id[one] = [person for person in people if ids & person.ids]
    # Where names and ids contradict each other more often than not, the list's ids are others than
    # the files'.
    agree = [any(person in by_name[one] for person in found) for one, found in by_id.items()
             if found and by_name[one]]
    has_ids = 2 * sum(agree) >= len(agree)
    taken = [person for found in joined.values() for person in found]
    for step in ('id', 'name'):
        for one in submissions:
            # whose id is not in the list is in no line with another one
            is_other = one.id and has_ids and sum(agree)
            free = [person for person in by_name[one] if person not in taken
                    and not (is_other and person.ids)]
            if joined.get(one):
                continue
            if step == 'id' and has_ids:
                joined[one] = by_id[one][:1]
            elif step == 'name':
                rivals = [other for other in submissions
                          if {*free} & {*by_name[other]} and not joined.get(other)]
                joined[one] = free if len(free) == 1 and rivals == [one] else []
        taken = [person for found in joined.values() for person in found]
    for person in people:
        first, *more = [one for one in submissions if person in joined.get(one, [])] or [None]
        for one in more:
            first.parts = first.parts + one.parts
            submissions.remove(one)
        if more:
            search(chapters, first)
        if first:
            first.person, first.id = person.person or first.person, first.id or person.cell('id')
            first.name = first.name if first.kind == 'folders' else first.person
    unknown = [one for one in submissions if not joined.get(one)]
    missing = [person for person in people if person not in taken
               and not any(person in by_name[one] for one in unknown)]
    alarm = []
    if 2 * len(unknown) > len(submissions) and 2 * len(missing) > len(people):
        alarm = [f'NOT UNDERSTOOD: {len(unknown)} of {counted(len(submissions), "student")} are '
                 f"not in the class list. Its first one is read as name '{people[0].person}', id "
                 f"'{people[0].cell('id')}': --columns names others"]
    submissions += [Submission('', person.person or person.cell('id'), 'the class list alone',
                               person.cell('id'), person.person,
                               'handed in nothing') for person in missing]
    nothing = submissions[len(submissions) - len(missing):]
    return [f'{words}: ' + '; '.join(clean(f'{one.name} ({one.id})' if one.id else one.name)
                                     for one in found) for words, found in {
        'not in the class list, or there are several of the name': unknown,
        'handed in nothing': nothing}.items() if found], alarm


def read_overrides(path, students, items, known, is_for_all):
    """Sets the points that an instructor wrote into a table: of a chapter or an exercise, or of all
    if that column is empty. Says who is not among the students, if the table is for all runs."""
    absent = []
    for line in lines_of(path, ['name points', 'id points', 'last first points']):
        where = f'{clean(str(path))}, line {line.number}: '
        who = {nfc(word).casefold() for word in (line.cell('name'), line.person) if word} | line.ids
        found = [student for student in students if who & {
            nfc(word).casefold()
            for word in (student.folder, student.name, student.id, student.person) if word}]
        name = line.cell('name') or line.person or line.cell('id')
        if not found and is_for_all:
            absent.append(f'{name} (line {line.number})')
            continue
        if len(found) != 1:
            raise GradeError(f"{where}{'no student is' if not found else 'several students are'} "
                             f"{name}")
        chapter, points = line.cell('chapter'), line.cell('points').replace(',', '.')
        if not re.fullmatch(r'\d{1,4}(\.\d+)?', points):
            raise GradeError(f"{where}'{points}' is no number of points")
        places = [item for item in items if chapter in item.names]
        if chapter and not any(chapter in item.names for item in known):
            raise GradeError(f"{where}there is no chapter and no exercise '{chapter}'")
        if chapter and not places:
            continue  # of another run
        found[0].by_hand[places[0].name if places else ''] = (float(points), line.cell('note'))
    more = f' and {len(absent) - 3} more' if absent[3:] else ''
    return (f"{clean(str(path))}: who is not graded in this run: {', '.join(absent[:3])}{more}\n"
            if absent else '')
