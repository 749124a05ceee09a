#!/usr/bin/env python3
"""Students' pictures and checkouts become tables and pages: ./course grade. docs/grading.md says
what an instructor sees of it."""
import argparse
import dataclasses
import os
import re
import signal
import sys
import threading
from pathlib import Path

sys.dont_write_bytecode = True  # the tree stays as it is
import class_pages  # noqa: E402
import people  # noqa: E402
import results  # noqa: E402
from pictures import Pictures  # noqa: E402
from results import GradeError, Item, Row, Student, clean, padded  # noqa: E402
from submissions import (Chapters, find_submissions, not_understood, shortened,  # noqa: E402
                         tell_apart, what_was_read, who_was_found)

TREE = Path(__file__).resolve().parents[3]
# students of whom all pictures of a chapter are compared in a row: equal ones are judged once
TOGETHER = 16


def say(text):
    print(text, end='', file=sys.stderr, flush=True)


class Parser(argparse.ArgumentParser):
    def error(self, message):
        message = re.sub(r'^argument (\S+): ', r'\1 ', message)
        self.exit(2, f'error: {clean(message)}\nusage: grade DIR... [options]     (grade --help '
                     'lists them)\n')


def whole(low, high):
    def read(text):
        if not re.fullmatch('-?[0-9]{1,9}', text) or not low <= int(text) <= high:
            raise argparse.ArgumentTypeError(f'takes a whole number from {low} to {high}, not '
                                             f'\'{text}\'')
        return int(text)
    return read


def place(text):
    if not text:
        raise argparse.ArgumentTypeError('needs a name, and got an empty one')
    return Path(text)


def command_line():
    parser = Parser(prog='grade', description="students' chapters against the golden pictures",
                    usage='grade DIR... [options]', allow_abbrev=False,
                    epilog='exit status: 0 all were graded, whatever the grades; 2 wrong command '
                           'line, or nothing could be graded; 3 less than half of the class '
                           'was understood; 130 ended by Ctrl-C, with what was done until then')
    add = parser.add_argument
    add('folders', metavar='DIR', nargs='*',
        help="a student's checkout or pictures, a folder of such folders, what a learning system "
        'hands out, or a zip of these')
    add('--one', action='store_true', help="each DIR is one student's, whatever is in it")
    add('--class', action='store_true', dest='each',
        help="each folder in a DIR is a student's, whatever lies next to it")
    add('--chapters', metavar='01,02.1',
        help='grade these chapters and exercises only; exercises: all of them')
    add('--points', metavar='02=2,02.1=0.5', default='',
        help='what a chapter or an exercise is worth')
    add('--class-list', metavar='FILE',
        help="a CSV with students' names and ids: says who is missing")
    add('--columns', metavar='name=HEAD,id=HEAD', default='',
        help='which columns of the class list have the name (or first, last), the id, the group')
    add('--dry-run', action='store_true',
        help='say who was found, with which files, and grade nothing')
    add('--overrides', metavar='FILE',
        help='a CSV with points that you gave by hand (default: overrides.csv in the folder of '
             'the results)')
    add('--no-tests', action='store_true',
        help="compare the pictures, do not run the chapters' tests")
    add('--no-second-picture', action='store_true',
        help='do not draw each chapter a second time with other settings')
    add('--seconds', metavar='N', type=whole(0, 86400), default=0,
        help="processor time for a program; 0, the default: ten times what the instructor's takes")
    add('--megabytes', metavar='N', type=whole(64, 1048576), default=2048,
        help='memory for a program (default: %(default)s)')
    add('--jobs', metavar='N', type=whole(0, 1024), default=0,
        help='programs at the same time; 0, the default: one for each processor')
    add('--trust-students', action='store_true',
        help='run checkouts even where nothing can contain them')
    add('--format', choices=['none', *results.FORMATS], default='none',
        help="write each student's grades for a learning system, too")
    add('--out', metavar='FOLDER', type=place, default=TREE / 'out/grades',
        help='where grades.csv, points.csv and index.html go (default: %(default)s)')
    add('--work', metavar='FOLDER', type=place, default=TREE / 'build/grade',
        help='where checkouts are built; kept for the next time (default: %(default)s)')
    add('--programs', metavar='FOLDER', type=place, default=TREE / 'build/learn/bin',
        help='where judge_pictures is (default: %(default)s)')
    version = re.search(r'project\(\S+ VERSION (\S+)',
                        (TREE / 'CMakeLists.txt').read_text(encoding='utf-8'))[1]
    add('--version', action='version', version=f'grade {version} (Texture Mapping, Step by Step)')
    # tests name another course and other boxes
    add('--tree', type=place, default=TREE, help=argparse.SUPPRESS)
    add('--containment', default='bwrap', help=argparse.SUPPRESS)
    options = parser.parse_intermixed_args()
    options.tree = options.tree.resolve()
    if not options.folders:
        parser.error('DIR is missing')
    if options.one and options.each:
        parser.error('--one and --class exclude each other')
    if options.columns and not options.class_list:
        parser.error('--columns says how to read a class list: give --class-list FILE, too')
    for name in ('class_list', 'overrides'):
        file = getattr(options, name)
        if file and not os.path.isfile(file):
            parser.error(f"--{name.replace('_', '-')}: there is no file '{file}'")
    for folder in options.folders:
        if not os.path.exists(folder):
            parser.error(f"there is no folder '{folder}'")
    try:
        return options, with_points(chosen_items(options), options.points,
                                    list(all_items(options.tree)))
    except ValueError as error:
        parser.error(str(error))


def all_items(tree):
    """All chapters, each with its exercises behind it."""
    for lesson in sorted((tree / 'chapters').glob('*/lesson.hpp')):
        name = lesson.parent.name
        golden = tree / 'tests/golden' / f'{name}.png'
        if golden.exists():
            # The suite of 13 measures times, and none of that counts.
            has_tests = not name.startswith('13') and (tree / 'tests/chapters'
                                                       / f'test_{name}.cpp').exists()
            yield Item(name, name[:2], str(golden), has_tests)
        exercises = {f'{name[:2]}.{file.name[0]}': file
                     for file in lesson.parent.glob('exercises/?_*.hpp')}
        for number, file in sorted(exercises.items()):
            yield Item(number, number, exercise=file.relative_to(tree).as_posix())


def chosen_items(options):
    """The items that --chapters names, by number or name; without it, the chapters."""
    items = list(all_items(options.tree))
    if options.chapters is None:
        return [item for item in items if not item.exercise]
    chosen = set()
    for word in map(str.strip, options.chapters.split(',')):
        if not word:
            raise ValueError(f"--chapters '{options.chapters}' has a comma with nothing before or "
                             "after it; such as 02,04 is right")
        chosen |= named_items(word, items)
    return [item for item in items if item in chosen]


def named_items(word, items):
    named = {item for item in items if word in item.names or word == 'exercises' and item.exercise}
    if not named:
        raise ValueError(f"there is no chapter '{word}', and no exercise")
    return named


def with_points(items, typed, known):
    """The items with the points of --points; the last word for an item counts."""
    worth = {}
    for word in filter(None, map(str.strip, typed.split(','))):
        name, _, points = word.partition('=')
        if not re.fullmatch(r'[0-9]{1,4}(\.[0-9]+)?', points):
            raise ValueError(f"--points takes such as 02=2,02.1=0.5, not '{word}'")
        worth |= {item.name: float(points) for item in named_items(name, known)}
    return [dataclasses.replace(item, worth=worth.get(item.name)) for item in items]


def lock(folder, other):
    """Keeps a folder for this program until it ends: the open file. Elsewhere than on POSIX it does
    nothing."""
    folder.mkdir(parents=True, exist_ok=True)
    try:
        import fcntl
    except ImportError:
        return None
    file = open(folder / '.lock', 'a')
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise GradeError(f"another ./course grade is using the folder '{folder}'; wait for it, or "
                         "name another folder with "
                         f'{other}') from None
    except OSError:
        pass  # some network file systems have no locks
    return file


class Grading:
    """One run: grades students a few at a time and writes what is known as soon as it is."""

    def __init__(self, options, items):
        self.options, self.items, self.out = options, items, options.out
        self.stopping = threading.Event()
        self.stopped = False  # by Ctrl-C
        self.pictures = None
        self.table = None  # grades.csv; that of an earlier run stays until the first row
        self.finished = 0
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, self.stop)

    def stop(self, *_):
        self.stopped = True
        self.stopping.set()
        if self.pictures:
            self.pictures.process.kill()

    def run(self):
        self.find_students()
        if self.options.dry_run:
            for line in shortened(who_was_found(self.submissions, self.items)):
                print(clean(line))
            return
        self.lock = lock(self.out, '--out')
        self.pictures = Pictures(self.options.programs.resolve(), self.stopping)
        for item in self.items:
            if item.golden:
                # what a student's program makes of it later does not count
                self.pictures.compare(item.golden, item.golden)
        if not (self.out / 'grades.csv').exists():
            self.open_table()
        try:
            everybody = range(len(self.students))
            for begin in everybody[::TOGETHER]:
                self.compare_pictures_of(everybody[begin:begin + TOGETHER])
            self.run_checkouts()
        except KeyboardInterrupt:
            pass
        except (GradeError, OSError):
            if self.finished:
                self.write_class()
            raise
        self.write_class()

    def find_students(self):
        chapters = Chapters(list(all_items(self.options.tree)), self.items)
        self.submissions, remarks = find_submissions(self.options.folders, chapters,
                                                     self.options.one, self.options.each)
        if self.submissions:
            print(what_was_read(self.submissions), flush=True)
        self.not_understood = []
        if self.options.class_list and self.submissions:
            more, self.not_understood = people.join_class_list(
                self.options.class_list, self.submissions, chapters, self.options.columns)
            remarks += more
        tell_apart(self.submissions)
        self.not_understood += [] if self.options.one else not_understood(self.submissions)
        for line in shortened(self.not_understood)[:1 if self.options.dry_run else None]:
            print(clean(line), flush=True)
        for remark in remarks:
            say(remark + '\n')
        if not self.submissions:
            raise GradeError('there is nothing to grade: no folder is in there')
        pages = results.page_names([submission.name for submission in self.submissions])
        self.students = [Student(one.folder, one.name, page, '; '.join(
            filter(None, (one.note, one.versions.get('')))), [None] * len(self.items),
                                 one.id, one.person)
                         for one, page in zip(self.submissions, pages)]
        overrides = Path(self.options.overrides or self.out / 'overrides.csv')
        if self.options.overrides or overrides.exists():
            say(people.read_overrides(overrides, self.students, self.items, chapters.known,
                                      is_for_all=not self.options.overrides))
        self.has_checkouts = any(submission.checkout for submission in self.submissions)

    def compare(self, row, picture):
        """Sets the picture's part of a row."""
        answer = self.pictures.compare(picture, row.item.golden)
        row.word, row.picture_ok, row.shown = answer['word'], answer['right'], answer['shown']
        row.figures = answer if answer['measured'] else None
        row.add_note(answer['note'])

    def compare_hidden(self, row, picture, expected):
        """The same for a second picture that the student does not know."""
        second = self.pictures.compare(picture, expected)
        row.hidden = 'yes' if second['right'] else 'no'
        if row.picture_ok and not second['right']:
            row.word, row.shown = 'second picture', second['shown']
            row.add_note(
                'the picture is right, but a second one, drawn with other settings, is not')

    def compare_pictures_of(self, students):
        """Chapter by chapter."""
        for k in range(len(self.items)):
            for i in students:
                if not self.submissions[i].checkout and not self.stopped:
                    self.put(i, k, self.row_of_picture(self.submissions[i], self.items[k]))

    def row_of_picture(self, submission, item):
        row = Row(item)
        path, why_not = submission.pictures.get(item.name, ('', ''))
        if not path:
            row.word, row.note = ('missing',
                                  f'there is no {item.exercise or f"picture {item.name}.png"}')
        elif why_not:
            row.word, row.note = 'unreadable', why_not
        else:
            self.compare(row, path)
        # In a class with checkouts all have the same points to reach.
        row.with_tests = self.has_checkouts and item.has_tests and not self.options.no_tests
        if row.with_tests and not row.word:
            row.word, row.note = ('no tests',
                                  "the picture is right; the tests need the chapter's code")
        row.add_note(submission.versions.get(item.name, ''))
        if row.word == 'missing':
            row.add_note(f'found {submission.seen}' if submission.seen else '')
        return row

    def row_of_result(self, result, item):
        row = Row(item, note=result['note'], build=result['build'], run=result.get('run', ''),
                  containment=result['containment'],
                  unchanged=result['build'] == 'unchanged', written=result.get('written', ''),
                  cpu_seconds=result.get('cpu_seconds', ''),
                  limit_cpu_seconds=result.get('limit_cpu_seconds', ''),
                  tests_passed=int(result.get('tests_passed', 0)),
                  tests_run=int(result.get('tests_run', 0)))
        # Where a chapter is missing or does not compile, who builds it may not know about its
        # tests.
        has_tests = 'tests_run' in result if row.build == 'ok' else item.has_tests
        row.with_tests = has_tests and not self.options.no_tests
        if row.build != 'ok':
            row.word = row.build
        elif item.exercise:
            # The note begins with the word: "u runs the other way: your map is mirrored; tried ..."
            if not row.tests_ok:
                row.word = results.first_word(row.note) if row.run == 'ok' else row.run
        else:
            if result.get('picture'):
                self.compare(row, result['picture'])
            else:
                row.word = 'no picture'
            if row.run != 'ok':
                row.word, row.picture_ok = row.run, False
            elif result.get('hidden_expected'):
                self.compare_hidden(row, result.get('hidden_picture', ''),
                                    result['hidden_expected'])
            if not row.word and row.with_tests and not row.tests_ok:
                row.word = f'tests {row.tests}'
        return row

    def run_checkouts(self):
        tasks = [((i, k), item.name, submission.checkout)
                 for i, submission in enumerate(self.submissions) if submission.checkout
                 for k, item in enumerate(self.items)]
        if not tasks or self.stopped:
            return
        if not sys.platform.startswith('linux'):
            raise GradeError('checkouts need Linux. Folders of the pictures that students\' '
                             'programs drew are graded everywhere')
        from build_and_run import results_of
        self.work_lock = lock(self.options.work, '--work')
        warned = False
        for ended, ((i, k), result) in enumerate(results_of(self.options, tasks, self.stopping), 1):
            if result['containment'] == 'none' and not warned:
                self.progress('')
                print(results.NOT_CONTAINED, flush=True)
                warned = True
            self.put(i, k, self.row_of_result(result, self.items[k]))
            self.progress(f'{ended} of {len(tasks)} done: {clean(self.students[i].name)} '
                          f'{self.items[k].number}')

    def open_table(self):
        self.table = open(self.out / 'grades.csv', 'w', encoding='utf-8', newline='')
        self.table.write(results.table([], results.COLUMNS, []))
        self.table.flush()

    def put(self, i, k, row):
        """Keeps a row; with the last one of a student, writes the student's page."""
        student = self.students[i]
        row.word = row.word or 'ok'
        if row.item.name in student.by_hand:
            row.by_hand, note = student.by_hand[row.item.name]
            row.add_note('points by hand' + (note and f': {note}'))
            row.word = 'by hand' if row.word == 'ok' and not row.right else row.word
        if not self.table:
            self.open_table()
        self.table.write(results.grades_csv_line(student, row))
        self.table.flush()
        student.all_rows[k] = row
        if None in student.all_rows:
            return
        self.finished += 1
        if student.has_page:
            self.write(f'{student.page}.html',
                       class_pages.student_page(self.pictures.pages['page'], student))
        else:  # an earlier run may have written one
            (self.out / f'{student.page}.html').unlink(missing_ok=True)
        for row in student.rows:  # a class has thousands
            row.shown = ''
        if self.options.format != 'none':
            name, written = results.FORMATS[self.options.format]
            self.write(name if len(self.students) == 1 else f'{student.page}.{name}',
                       written(student))
        self.progress('')
        if self.options.format == 'classroom':
            print(results.classroom_notices(student), end='')
        print(self.line_of(i), flush=True)

    def line_of(self, i):
        student = self.students[i]
        wrong = self.nothing_of(i) or ', '.join(f'{row.item.number} {clean(row.word)}'
                                                for row in student.rows if not row.right)
        return (padded(f'[{self.finished}/{len(self.students)}]',
                       10) + padded(f'{student.points} of {student.of}', 10) +
                padded(clean(student.name), 25) + (wrong or 'all right'))

    def nothing_of(self, i):
        """In words, if nothing is there of what was asked for."""
        student, submission = self.students[i], self.submissions[i]
        if any(row.word != 'missing' for row in student.rows):
            return ''
        if student.note:
            return clean(student.note)
        if submission.checkout:
            return 'nothing of what was asked for is in its chapters'
        return (f'missing; found {submission.seen}'
                if submission.seen else 'no chapter and no picture found')

    def write_class(self):
        """The tables and the index of all that is done."""
        self.progress('')
        if not self.table:
            return
        self.table.close()
        students = [student for student in self.students if student.rows]
        results.say_who_has_the_same(students)
        self.write('grades.csv', results.grades_csv(students))
        self.write('points.csv', results.points_csv(students))
        self.write('index.html', class_pages.class_page(self.pictures.pages['page_with_script'],
                                                        self.items, students, len(self.students),
                                                        self.not_understood))
        print(f'Look at {clean(str(self.out / "index.html"))}', flush=True)

    def write(self, name, text):
        """All at once: at any moment the name is that of the whole old or the whole new file."""
        part = self.out / f'.{name}.part'
        part.write_bytes(text.encode('utf-8', 'replace'))
        os.replace(part, self.out / name)

    @staticmethod
    def progress(words):
        if sys.stderr.isatty():
            say('\r\033[K' + words)


def main():
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(encoding='utf-8', errors='replace')
    grading = Grading(*command_line())
    try:
        grading.run()
    except KeyboardInterrupt:
        pass  # before anything was graded
    except (GradeError, OSError) as error:
        grading.progress('')
        say(f'error: {results.clean_lines(str(error))}\n')
        return 2
    return 130 if grading.stopped else 3 if grading.not_understood else 0


if __name__ == '__main__':
    sys.exit(main())
