"""Who the students are, by a class list, and the points that an instructor gave by hand: two tables
that are read."""
import csv
import dataclasses
import io
import re
import unicodedata
from pathlib import Path

from results import GradeError, clean, nfc
from submissions import Submission

# How the exports of learning systems, and people, head the columns.
HEADS = {'id': 'folder|id|identifier|id[- ]?number|user ?id|user ?name|login( id)?|'
               'sis (user|login) id|student ?id|orgdefinedid|e-?mail([- ]ad(d)?resse?)?|id-?nummer|'
               'matrikelnummer|anmeldename|benutzername|nutzername|teilnehmernummer',
         'name': 'student|name|person|full name|student name|display name|vollständiger name|'
                 'vor- und nachname',
         'last': 'last ?name|surname|family name|last|nachname|familienname',
         'first': 'first ?name|given name|first|vorname',
         'chapter': 'chapter|exercise', 'points': 'points', 'note': 'note'}
NOBODY = ('points possible', 'student, test', 'test student')  # lines of Canvas's gradebook


@dataclasses.dataclass
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
        return nfc(f'{first.strip()} {last.strip()}' if comma else name)

    @property
    def ids(self):
        """All that could be the student's id: Moodle's "Participant 12345" is 12345, the address
        ada@x.org is ada."""
        words = [word for cell in self.cells.get('id', [])
                 for word in (cell, cell.partition('@')[0], *re.findall(r' (\d+)$', cell))]
        return {nfc(word).casefold() for word in words}


def lines_of(path, needed):
    """The lines of a table with commas, semicolons or tabs. Its head is the first line with a
    column of each needed kind."""
    data = Path(path).read_bytes()
    try:
        text = data.decode('utf-16' if data[:2] in (b'\xff\xfe', b'\xfe\xff') else 'utf-8-sig')
    except UnicodeError:
        text = data.decode('cp1252', 'replace')
    comma = max(',;\t', key=text.count)
    head, lines = None, []
    for number, cells in enumerate(csv.reader(io.StringIO(text, newline=''), delimiter=comma), 1):
        if head is None:
            words = [nfc(cell).strip().casefold() for cell in cells]
            kinds = [next((kind for kind, names in HEADS.items() if re.fullmatch(names, word)), '')
                     for word in words]
            head = kinds if any(set(kinds) >= set(one.split()) for one in needed) else None
            continue
        found = {}
        for kind, cell in zip(head, cells):
            found.setdefault(kind, []).extend([cell.strip()] if cell.strip() else [])
        line = Line(number, found)
        if (line.person or line.ids) and line.cell('name').casefold() not in NOBODY:
            lines.append(line)
    if head is None:
        raise GradeError(f"{clean(str(path))}: no line names the columns {' or '.join(needed)}")
    return lines


def keys(name):
    """What is the same for all ways to write a name: its words without accents in any order, as
    one; Canvas leaves out the blanks."""
    plain = ''.join(letter for letter in unicodedata.normalize('NFKD', name.casefold())
                    if not unicodedata.combining(letter))
    words = re.findall(r'[^\W_]+', plain)
    return {''.join(words[i:] + words[:i]) for i in range(len(words))}


def join_class_list(path, submissions):
    """Sets ids and persons from a class list: by id, then by name, if nobody else has that name.
    Adds who handed in nothing. Says who these are, and who is not in the list."""
    people = lines_of(path, ['id', 'name', 'last first'])
    names = {id(one): keys(one.person) for one in [*people, *submissions]}

    def named_as(one, others):
        return [other for other in others if names[id(one)] & names[id(other)]]
    by_id = {id(one): [person for person in people
                       if nfc(one.id or one.name).casefold() in person.ids] for one in submissions}
    by_name = {id(one): named_as(one, people) for one in submissions}
    # Where names and ids contradict each other more often than not, the list's ids are others than
    # the files'.
    agree = [any(person in by_name[one] for person in found) for one, found in by_id.items()
             if found and by_name[one]]
    has_ids = 2 * sum(agree) >= len(agree)
    taken, joined = [], {}
    for step in ('id', 'name'):
        for one in submissions:
            free = [person for person in by_name[id(one)] if person not in taken]
            if step == 'id' and has_ids:
                joined[id(one)] = by_id[id(one)][:1]
            elif step == 'name' and not joined.get(id(one)) and not (
                one.id and has_ids and sum(agree)):
                alone = len(free) == 1 and len([other for other in named_as(one, submissions)
                                                if not joined.get(id(other))]) == 1
                joined[id(one)] = free if alone else []
        taken = [person for found in joined.values() for person in found]
    for one in submissions:
        for person in joined[id(one)]:
            one.person, one.id = person.person or one.person, one.id or person.cell('id')
            one.name = one.name if one.kind == 'folders' else one.person
    unknown = [one for one in submissions if not joined[id(one)]]
    missing = [person for person in people if person not in taken and not named_as(person, unknown)]
    submissions += [Submission('', person.person or person.cell('id'), 'the class list alone',
                               person.cell('id'), person.person,
                               'handed in nothing') for person in missing]
    return [f'{words}: ' + '; '.join(clean(f'{one.name} ({one.id})' if one.id else one.name)
                                     for one in found) for words, found in {
        'not in the class list, or there are several of the name': unknown,
        'handed in nothing': submissions[len(submissions) - len(missing):]}.items() if found]


def read_overrides(path, students, items):
    """Sets the points that an instructor wrote into a table: of a chapter or an exercise, or of all
    if that column is empty."""
    for line in lines_of(path, ['name points', 'id points', 'last first points']):
        where = f'{clean(str(path))}, line {line.number}: '
        who = {nfc(word).casefold() for word in (line.cell('name'), line.person) if word} | line.ids
        found = [student for student in students if who & {
            nfc(word).casefold()
            for word in (student.folder, student.name, student.id, student.person) if word}]
        if len(found) != 1:
            raise GradeError(f"{where}{'no student is' if not found else 'several students are'} "
                             f"{line.cell('name') or line.cell('id')}")
        chapter, points = line.cell('chapter'), line.cell('points').replace(',', '.')
        if not re.fullmatch(r'\d{1,4}(\.\d+)?', points):
            raise GradeError(f"{where}'{points}' is no number of points")
        places = [item for item in items if chapter in item.names]
        if chapter and not places:
            continue  # of another run
        found[0].by_hand[places[0].name if places else ''] = (float(points), line.cell('note'))
