"""What grading finds out, and how it is written: text made safe, tables, files for learning
systems."""
from __future__ import annotations  # for Python 3.9

import dataclasses
import html
import itertools
import json
import os
import re
import unicodedata
from xml.sax.saxutils import quoteattr


class GradeError(Exception):
    """Nothing can be graded, or no more; the text says why, and what helps."""


NOT_CONTAINED = ("NOT CONTAINED: students' programs ran with your rights and could change any "
                 "file, this one too.")


# --- Text from students ---------------------------------------------------------------------------

# Control characters, marks that turn the direction of writing, and what stands for bytes that are
# no UTF-8.
HARMFUL = '\x00-\x1f\x7f-\x9f\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069'
BROKEN = re.compile('[\ud800-\udfff]')
# What a formula begins with, also as the wide and small forms of East Asian writing; blanks may
# stand before it.
FORMULA = re.compile('^([ \u00a0\u2000-\u200d\u2028\u2029\u202f\u205f\u2060\u3000\ufeff"]*)'
                     '(?=[-=+@\u2212\uff1d\uff0b\uff0d\uff20\ufe66\ufe62\ufe63\ufe6b])')


def clean(text):
    """The text on one line, without control characters and without marks that turn the direction of
    writing."""
    return re.sub(f'[{HARMFUL}]', '', re.sub('[\n\t\u2028\u2029]', ' ', BROKEN.sub('\ufffd', text)))


def clean_lines(text):
    """As clean(), but with line ends and at most 4000 characters, as learning systems refuse long
    texts; these end in "..."."""
    cut = text[:4000] + ('...' if len(text) > 4000 else '')
    return re.sub(f'(?!\n)[{HARMFUL}]', '', BROKEN.sub('\ufffd', cut))


def shown_name(name):
    """A file's name to be shown: a byte that is not UTF-8 as its Latin-1 letter, as in archives
    from older Windows systems, or as \\xNN."""
    def letter(broken):
        byte = ord(broken[0]) & 0xff
        return chr(byte) if byte >= 0xa0 else f'\\x{byte:02X}'
    return BROKEN.sub(letter, name)


def nfc(name):
    """A person's name as all systems but Apple's write it: an umlaut is one letter."""
    return unicodedata.normalize('NFC', clean(shown_name(name)))


def csv_cell(text):
    """A cell as RFC 4180 has it, always quoted. What a spreadsheet could take for a formula gets an
    apostrophe in front."""
    return '"' + FORMULA.sub(r"\1'", clean(text)).replace('"', '""') + '"'


def escaped(text):
    """A text that somebody else wrote as HTML."""
    return html.escape(re.sub(f'(?![\n\t])[{HARMFUL}]', '\ufffd',
                              BROKEN.sub('\ufffd', text))).replace('&#x27;', "'")


def first_word(note):
    """The word that a note begins with: "stripes" of "stripes: no squares; tried on +z". A name
    such as std::fmod stays whole."""
    return re.split('[:;] ', note, maxsplit=1)[0]


def with_word(word, note):
    """The note with the word in front, if it does not begin with it."""
    again = not word or note == word or note.startswith((f'{word}:', f'{word};'))
    return note if again else f'{word}: {note}' if note else word


def padded(text, columns):
    """The text with at least one blank up to so many columns of a terminal; East Asian characters
    take two."""
    wide = sum(unicodedata.east_asian_width(letter) in 'WF' for letter in text)
    return text + ' ' * max(1, columns - len(text) - wide)


def number(value):
    """A number of points: whole if it is."""
    return int(value) if value == int(value) else round(value, 3)


def counted(count, thing):
    return f'{count} {thing}' + ('' if count == 1 else 's')


def page_names(names):
    """A file name for each student, on any system: no two are equal in any case. All but letters,
    digits, - and _ becomes _."""
    pages = {'index': ''}  # by their small letters
    for name in names:
        plain = re.sub(rb'[^A-Za-z0-9_-]', b'_', os.fsencode(name)[:80]).decode()
        plain = plain if re.search('[A-Za-z0-9]', plain) else 'student'
        others = (f'{plain}-{n}' for n in itertools.count(2))
        page = next(page for page in itertools.chain([plain], others) if page.lower() not in pages)
        pages[page.lower()] = page
    return list(pages.values())[1:]


@dataclasses.dataclass(frozen=True)
class Item:
    """Something that is graded: a chapter, or an exercise such as 02.1."""
    name: str  # 03_image_texture
    number: str  # 03: what stands in the head of a table
    golden: str = ''  # the chapter's picture
    has_tests: bool = False  # a checkout's tests are worth a point
    exercise: str = ''  # the file of an exercise, in a checkout
    # the points that it has; None: one for an exercise, one for a picture and one for its tests
    worth: float | None = None

    @property
    def names(self):
        """What it is called on the command line."""
        return self.name, self.number, self.number.removeprefix('0')


@dataclasses.dataclass
class Row:
    """One student's result for one item. Words are the student's or the compiler's: not yet
    escaped."""
    item: Item
    word: str = ''  # ok, mirrored, differs 2.5 %, missing, does not build, ...
    note: str = ''  # the reason in words
    # ok, missing, does not build; empty for a folder of pictures, like the next two
    build: str = ''
    run: str = ''  # ok, crashed SIGSEGV, hang, ...
    containment: str = ''  # bwrap, none
    cpu_seconds: str = ''
    limit_cpu_seconds: str = ''
    figures: dict | None = None  # how far the picture is from the golden one
    picture_ok: bool = False
    hidden: str = ''  # yes, no: the second picture; empty if there was none
    with_tests: bool = False
    tests_passed: int = 0
    tests_run: int = 0
    shown: str = ''  # HTML: the part of a wrong picture that a page shows
    unchanged: bool = False  # the files are those that were handed out
    written: str = ''  # a hash of the files, without blanks and comments, if they are not
    same_as: str = ''  # other students with these files
    by_hand: float | None = None  # points that the instructor gave

    def add_note(self, note):
        self.note += ('; ' if self.note and note else '') + note

    @property
    def tests(self):
        return f'{self.tests_passed} of {self.tests_run}' if self.tests_run else ''

    @property
    def tests_ok(self):
        return 0 < self.tests_run == self.tests_passed

    @property
    def picture_point(self):
        return self.picture_ok and self.hidden != 'no'

    @property
    def parts(self):
        """Whether what has points is right: an exercise; of a chapter the picture, and the tests if
        they count."""
        if self.item.exercise:
            return [self.tests_ok]
        return [self.picture_point, self.tests_ok] if self.with_tests else [self.picture_point]

    @property
    def of(self):
        return len(self.parts) if self.item.worth is None else number(self.item.worth)

    @property
    def points(self):
        return number(self.of * sum(self.parts) / len(self.parts) if self.by_hand is None
                      else self.by_hand)

    @property
    def right(self):
        return all(self.parts) if self.by_hand is None else self.points >= self.of


@dataclasses.dataclass
class Student:
    folder: str  # as the instructor named it
    name: str
    page: str  # name of the page's file without .html; unique in a class
    note: str
    all_rows: list  # for each item; None until it is graded
    id: str = ''
    person: str = ''
    # points and a note, by the name of an item; '': all of the student's
    by_hand: dict = dataclasses.field(default_factory=dict)

    @property
    def rows(self):
        return [row for row in self.all_rows if row]

    @property
    def points(self):
        return number(self.by_hand[''][0] if '' in self.by_hand
                      else sum(row.points for row in self.rows))

    @property
    def of(self):
        return number(sum(row.of for row in self.rows))

    @property
    def notes(self):
        by_hand = 'points by hand' + (self.by_hand[''][1]
                                      and ': ' + self.by_hand[''][1]) if '' in self.by_hand else ''
        return '; '.join(filter(None, (self.note, self.unfinished, by_hand)))

    @property
    def contained(self):
        return all(row.containment != 'none' for row in self.rows)

    @property
    def has_page(self):
        """A page shows something that the table does not."""
        return bool(self.folder) and (bool(self.note) or any(not row.right or row.note
                                                             for row in self.rows))

    @property
    def unfinished(self):
        """Empty; or that the run was ended before all was graded."""
        done, of = len(self.rows), len(self.all_rows)
        return f'ended with {done} of {of} graded' if done < of else ''


COLUMNS = ('student chapter build run seconds pixels_off share_off rmse ssim picture_ok tests '
           'note verdict points of second_picture_ok '
           'limit_seconds contained_by folder unchanged same_as id person').split()


def csv_line(cells):
    return ','.join(csv_cell(str(cell)) for cell in cells) + '\r\n'


def grades_csv_line(student, row):
    figures = [''] * 4
    if row.figures:
        figures = [form % row.figures[name] for name, form in
                   {'pixels_off': '%d', 'share_off': '%.8f', 'rmse': '%.6f',
                    'ssim': '%.6f'}.items()]
    picture_ok = '' if row.item.exercise else 'yes' if row.picture_ok else 'no'
    return csv_line([student.name, row.item.name, row.build, row.run, row.cpu_seconds, *figures,
                     picture_ok, row.tests, row.note, row.word,
                     row.points, row.of, row.hidden, row.limit_cpu_seconds, row.containment,
                     student.folder,
                     'yes' if row.unchanged else 'no' if row.written else '', row.same_as,
                     student.id, student.person])


def table(students, head, lines):
    """After the byte order mark, without which a spreadsheet would not read UTF-8. The first line
    says so if nothing was contained."""
    warning = '' if all(student.contained for student in students) else csv_line([NOT_CONTAINED])
    return '\ufeff' + warning + csv_line(head) + ''.join(lines)


def grades_csv(students):
    return table(students, COLUMNS,
                 [grades_csv_line(student, row) for student in students for row in student.rows])


def points_csv(students):
    def with_whom(student):
        return '; '.join(f'{row.item.number}: {row.same_as}' for row in student.rows if row.same_as)
    return table(students, ['folder', 'name', 'points', 'of', 'chapters', 'page', 'note', 'id',
                            'person', 'unchanged', 'same_as'],
                 [csv_line([student.folder, student.name, student.points, student.of,
                            len(student.rows), student.page, student.notes,
                            student.id, student.person,
                            ' '.join(row.item.number for row in student.rows if row.unchanged),
                            with_whom(student)]) for student in students])


def say_who_has_the_same(students):
    """Sets same_as: the names of others whose files of an item are equal, but for blanks and
    comments; at most three."""
    who = {}
    for student in students:
        for row in student.rows:
            if row.written:
                who.setdefault((row.item, row.written), []).append((student, row))
    for found in who.values():
        for student, row in found:
            others = [other.name for other, _ in found if other is not student]
            row.same_as = ', '.join(others[:3]) + (f' and {len(others) - 3} more'
                                                   if others[3:] else '')


# --- Learning systems -----------------------------------------------------------------------------
# Each format is a list of tests. A row of the grades makes one test for the picture, worth one
# point, and one for the chapter's suite, if it ran. An exercise is one test.

@dataclasses.dataclass
class Test:
    name: str
    number: str  # 3.1; of an exercise 3.E1
    item: str
    file: str  # in the student's checkout
    points: float
    of: float
    passed: bool
    broken: bool  # the program could not be built
    message: str  # why it failed
    seconds: float


def why_of_tests(row):
    """How many passed and the first that failed, which the note has behind "tests: "."""
    found = re.search('(?:^|; )tests: (.*)', row.note, re.DOTALL)
    why = found[1] if found else with_word(row.word, row.note)
    return f'{row.tests} tests passed' + (f': {why}' if why else '')


def tests_of(student):
    tests = []
    for row in student.rows:
        item, chapter = row.item, int(row.item.name[:2])
        seconds = float(row.cpu_seconds or 0)
        why = with_word(row.word, row.note)
        made = [('the picture', f'{chapter}.1', why),
                ('the tests', f'{chapter}.2', why_of_tests(row) if row.tests_run else why)]
        if item.exercise:  # 2.E1, because 2.1 is the picture of chapter 02
            made = [('the exercise', f'{chapter}.E{item.name[3:]}', why)]
        parts = row.parts
        if row.by_hand is not None:
            made, parts = [('by hand', made[0][1], why)], [row.points / row.of if row.of else 1]
        of = row.of / len(parts)
        for (what, place, message), share in zip(made, parts):
            tests.append(Test(f'{item.name}: {what}', place, item.name,
                              item.exercise or f'chapters/{item.name}/lesson.hpp',
                              number(of * share), number(of), share >= 1,
                              row.build == 'does not build',
                              '' if share >= 1 else clean_lines(message), seconds))
            seconds = 0.0  # counted once
    return tests


def as_json(value):
    return json.dumps(value, indent=2, ensure_ascii=False) + '\n'


def gradescope_json(student):
    tests = tests_of(student)
    warning = '' if student.contained else NOT_CONTAINED + '\n'
    return as_json({
        'score': student.points, 'execution_time': round(sum(test.seconds for test in tests), 2),
        'output': f'{warning}{student.points} of {student.of} points', 'output_format': 'text',
        'test_output_format': 'text', 'visibility': 'visible', 'stdout_visibility': 'hidden',
        'tests': [{'name': test.name, 'number': test.number, 'score': test.points,
                   'max_score': test.of,
                   'status': 'passed' if test.passed else 'failed', 'output': test.message,
                   'output_format': 'text', 'tags': [test.item],
                   'visibility': 'visible'} for test in tests],
        'extra_data': {'folder': clean(student.folder)}})


def classroom_json(student):
    tests = tests_of(student)
    broken = bool(tests) and all(test.broken for test in tests)  # then no test says more
    return as_json({
        'version': 1, 'status': 'error' if broken else 'pass' if all(test.passed for test in tests)
        else 'fail', 'max_score': student.of,
        'tests': [{'name': test.name, 'status': 'pass' if test.passed else 'error'
                   if test.broken else 'fail', 'score': test.points,
                   'message': test.message, 'test_code': f'./course grade --chapters {test.item}',
                   'filename': test.file, 'line_no': 1,
                   'duration': 1000 * test.seconds} for test in tests]})


def classroom_notices(student):
    """The same as two notices that any program of a workflow may print."""
    report = json.dumps({'totalPoints': student.points, 'maxPoints': student.of})
    return (f'::notice title=Autograding complete::Points {student.points}/{student.of}\n'
            f'::notice title=Autograding report::{report}\n')


def junit_xml(student):
    """With the fields that ctest --output-junit writes."""
    def element(tag, **attributes):
        return f'<{tag}' + ''.join(f' {key}={quoteattr(clean(str(value)))}'
                                   for key, value in attributes.items())
    tests, cases = tests_of(student), ''
    for test in tests:
        cases += '  ' + element('testcase', name=test.name, classname=test.item,
                                time=f'{test.seconds:.3f}', status='run' if test.passed else 'fail')
        fault = element('error' if test.broken else 'failure', message=test.message)
        cases += '/>\n' if test.passed else f'>\n    {fault}/>\n  </testcase>\n'
    failed = [test for test in tests if not test.passed]
    errors = sum(test.broken for test in failed)
    suite = element('testsuite', name=student.name, tests=len(tests), failures=len(failed) - errors,
                    errors=errors, disabled=0, skipped=0,
                    time=f'{sum(test.seconds for test in tests):.3f}')
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{suite}>\n{cases}</testsuite>\n'


FORMATS = {'gradescope': ('results.json', gradescope_json),
           'classroom': ('classroom.json', classroom_json), 'junit': ('junit.xml', junit_xml)}
