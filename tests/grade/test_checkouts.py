#!/usr/bin/env python3
"""Grading checkouts from the command line on: students' code that is right, wrong, attacks, loops
and cheats.

usage: test_checkouts.py PROGRAMS WORK [TEST...]
PROGRAMS: the folder of judge_pictures, WORK: kept for the next time

Each attack is also run without a box, where it must succeed: else the test would show nothing.
Status 77 where there are no boxes."""
import base64
import csv
import json
import os
import random
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path
from unittest import mock

sys.dont_write_bytecode = True
TREE = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TREE / 'common/tools/grade'))
import build_and_run  # noqa: E402
from box import Boxes, Ended, Limits  # noqa: E402
from results import NOT_CONTAINED, GradeError  # noqa: E402

ITEM = '01_plain_spheres'
GOLDEN = TREE / 'tests/golden' / f'{ITEM}.png'
LESSON = (TREE / 'chapters' / ITEM / 'lesson.hpp').read_text()
MINE = LESSON + 'inline constexpr int mine = 1;\n'
COLOR = 'template <class Real>\n  Color<Real> operator()(const Ray<Real>& ray) const {\n'
WORD = 'kept-' + os.urandom(8).hex()
EMPTY = 'int main() {}\n'

TOUCH = '''#include <unistd.h>
void touch(int megabytes) {
  volatile char* block = new char[megabytes << 20];
  for (int i = 0; i < megabytes << 20; i += 4096) block[i] = 1;
}
void wait() { for (;;) sleep(1000); }
'''
# What a program of the student's could do, done by a shell in its place.
SHELL = ('#include <unistd.h>\n'
         'int main() { return execl("/bin/sh", "sh", "-c", R"~(%s)~", nullptr); }\n')
# Says first what it could read: a file, and of every process the environment.
ATTACKS = '''exec 2>/dev/null
echo $(cat @secret@; cat /proc/[0-9]*/environ | grep -aq @word@ && echo environment:@word@
env | grep -q @word@ && echo own:@word@)
: >>@golden@ && touch @golden@
echo forged >>@results@
echo changed >>@neighbor@
rm -r @removable@
bash -c ': >/dev/tcp/127.0.0.1/@port@'
setsid sh -c ': >up; exec sleep @sleep@' </dev/null >/dev/null &
while [ ! -e up ] && kill -0 $!; do sleep 0.1; done
kill -KILL @victim@
exit 3'''
# Tries each way to memory that no process is seen to have, and names those that are open.
UNCOUNTED = '''import ctypes, mmap, os, socket
c = ctypes.CDLL(None)
for name, way in {'memfd': lambda: os.memfd_create(''),
                  'segment': lambda: c.shmctl(c.shmget(0, 4096, 0o600), 0, None),
                  'semaphores': lambda: c.semctl(c.semget(0, 1, 0o600), 0, 0),
                  'queue': lambda: c.msgctl(c.msgget(0, 0o600), 0, None),
                  'pages': lambda: mmap.mmap(-1, 4096),
                  'zero': lambda: mmap.mmap(os.open('/dev/zero', os.O_RDWR), 4096),
                  'pair': socket.socketpair,
                  'socket': lambda: socket.socket(socket.AF_UNIX)}.items():
    try:
        if way() != -1: print(name)
    except (OSError, ValueError):
        pass
'''
# Writes to all files that its command line could name, before main(), and ends.
FORGED = '''#include <cstdio>
#include <unistd.h>
__attribute__((constructor)) void forge(int count, char** words) {
  for (int i = 1; i < count; ++i) {
    std::FILE* file = std::fopen(words[i], "wb");
    if (file == nullptr) continue;
    %s
    std::fclose(file);
  }
  _exit(0);
}
'''


def running(seconds):
    """The processes that sleep so long."""
    found = []
    for process in Path('/proc').iterdir():
        try:
            if process.name.isdigit() and (
                process / 'cmdline').read_bytes() == f'sleep\0{seconds}\0'.encode():
                found.append(int(process.name))
        except OSError:
            pass  # it has just ended
    return found


class Case(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.at = Path(place.name)
        self.out = self.at / 'out'

    def student(self, name, main=None, lesson=None, at='chapters'):
        """A checkout with chapter 01; its main.cpp or its lesson is another."""
        at = self.at / 'class' / name / at / ITEM
        shutil.copytree(TREE / 'chapters' / ITEM, at)
        for file, text in (('main.cpp', main), ('lesson.hpp', lesson)):
            if text is not None:
                (at / file).write_text(text)
        return at

    def start(self, *options, environment=None):
        """Begins to grade all students."""
        command = [sys.executable, TREE / 'common/tools/grade/grade.py', '--programs', PROGRAMS,
                   '--work', WORK, '--out', self.out, '--class', *options, self.at / 'class']
        return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                env=environment, umask=0o077)

    def grade(self, *options, environment=None):
        """Grades all students; the rows of grades.csv by student, of a second item by student and
        item."""
        grading = self.start(*options, environment=environment)
        self.printed, self.said = grading.communicate()
        self.assertEqual(grading.returncode, 0, self.said)
        with open(self.out / 'grades.csv', encoding='utf-8-sig', newline='') as file:
            lines = [line for line in file if not line.startswith('"NOT')]
        rows = {}
        for row in csv.DictReader(lines):
            student = row['student']
            rows[(student, row['chapter']) if student in rows else student] = row
        return rows

    def expect(self, rows, expected):
        """A row for each student: run or build, verdict, second_picture_ok, and a pattern for the
        note."""
        self.assertEqual(set(rows), set(expected))
        for name, (how, verdict, second, note) in expected.items():
            with self.subTest(name):
                row = rows[name]
                self.assertRegex(row['run'] or row['build'], f'^({how})$')
                self.assertRegex(row['verdict'], f'^({verdict})$')
                self.assertEqual(row['second_picture_ok'], second)
                self.assertRegex(row['note'], note)
                self.assertEqual(row['contained_by'], 'bwrap')
                self.assertEqual(row['points'] == row['of'], verdict == 'ok')


class Chapters(Case):
    def test_pictures_of_programs_that_end_and_do_not_end(self):
        picture = base64.b64encode(GOLDEN.read_bytes()).decode()
        for name, main in {'spin': SHELL % 'while :; do :; done',
                           'sleep': SHELL % 'exec sleep 1000',
                           'crash': 'int main() { volatile int* nothing = nullptr; return '
                                    '*nothing; }\n',
                           'unlinked': 'int nowhere();\nint main() { return nowhere(); }\n',
                           'hoard': TOUCH + 'int main() { for (;;) touch(16); }\n',
                           # Each of its processes has little memory; all of them have too much.
                           'crowd': TOUCH + 'int main() { for (int i = 0; i < 20; ++i) '
                                            'if (fork() == 0) touch(100), wait(); wait(); }\n',
                           # Fills the box, and says how much went in.
                           'fill': SHELL % 'for i in $(seq 100); do head -c 4M /dev/urandom >$i '
                                           '2>/dev/null || break; done; '
                                           'echo $(du -sm .) MB; exit 1',
                           'forks': '#include <unistd.h>\nint main() { for (;;) fork(); }\n',
                           'linked': SHELL % 'ln -s /usr/include/stdio.h picture.png',
                           'copycat': SHELL % f'echo {picture} | base64 -d >picture.png',
                           'loud': SHELL % 'yes'}.items():
            self.student(name, main)
        self.student('honest', lesson=MINE)
        private = self.student('private', lesson=MINE + '// for me alone\n')
        for path in [private, *private.rglob('*')]:
            path.chmod(0o700 if path.is_dir() else 0o600)
        beside = self.student('untouched')
        (beside / 'lesson_old.hpp').write_text(MINE)
        (beside / '._lesson.hpp').write_bytes(b'\0')
        self.student('same', lesson=MINE.replace('\n', ' // the same\n', 3),
                     at='texmap-main/chapters')
        self.student('dark', lesson=LESSON.replace(COLOR, COLOR + '    return {};\n'))
        self.student('broken', lesson=LESSON + 'this does not compile\n')
        (self.student('without', lesson=MINE) / 'main.cpp').unlink()
        (self.student('missing') / 'lesson.hpp').unlink()
        rows = self.grade('--chapters', '1', '--no-tests', '--megabytes', '500')
        right = ('ok', 'ok', 'yes', '^$')
        self.expect(rows, {
            'spin': ('hang', 'hang', '', 'it was stopped after 5 s of CPU time: it is too slow'),
            'sleep': ('hang', 'hang', '', 'it waited for 10 s and did'),
            'crash': ('crashed SIGSEGV', 'crashed SIGSEGV', '',
                      'it ended by signal SIGSEGV: an index'),
            'unlinked': ('does not build', 'does not build', '',
                         'undefined reference to .*nowhere'),
            'hoard': ('too much memory', 'too much memory', '', '.*'),
            'crowd': ('too much memory', 'too much memory', '', '.*'),
            'forks': ('hang|too many processes', 'hang|too many processes', '', '.*'),
            'fill': (r'failed \(1\)', r'failed \(1\)', '', r'^([0-9]|[1-5][0-9]|6[0-4]) \. MB'),
            'linked': ('ok', 'no picture', 'no', '^it left no picture'),
            'loud': ('ok|hang', 'no picture|hang', rows['loud']['second_picture_ok'], '.*'),
            # One that carries the golden picture is right in the first alone.
            'copycat': ('ok', 'second picture', 'no', '^the picture is right, but a second one, '
                                                      'drawn with other settings, is not$'),
            'honest': right, 'private': right, 'same': right, 'without': right,
            'dark': ('ok', 'black', 'no', '^black: nothing was drawn; [0-9]+ pixels are off'),
            'broken': ('does not build', 'does not build', '',
                       f'^chapters/{ITEM}/lesson.hpp:[0-9:]+ error: '),
            'untouched': ('unchanged', 'unchanged', '', '^what was handed out, but for blanks and '
                                                        'comments$'),
            'missing': ('missing', 'missing', '', f'^there is no chapters/{ITEM}/lesson.hpp$')})
        self.assertGreaterEqual(float(rows['honest']['limit_seconds']), 5)
        self.assertRegex(self.printed,
                         r'0 of 1 +missing +nothing of what was asked for is in its chapters\n')
        self.assertFalse((self.out / 'honest.html').exists())  # nothing is to be seen there
        self.assertIn('error:', (self.out / 'broken.html').read_text())
        # The same checkouts once more: nothing is built or run but the course's own, so that even
        # the times are the same.
        again = self.grade('--chapters', '1', '--no-tests', '--megabytes', '500')
        for name in rows:
            self.assertEqual(again[name], rows[name])
        self.assertNotIn('takes minutes', self.said)
        self.assertEqual({name: row['same_as'] for name, row in rows.items() if row['same_as']}, {
            'honest': 'private, same, without', 'private': 'honest, same, without',
            'same': 'honest, private, without', 'without': 'honest, private, same'})
        self.assertEqual([rows[name]['unchanged'] for name in ('untouched', 'honest', 'missing')],
                         ['yes', 'no', ''])

    def test_causes_that_the_compiler_and_the_tests_do_not_say(self):
        self.assertIn(COLOR, LESSON)
        own = self.student('own', lesson=LESSON + 'const int made = my_uv();\n')
        (own.parents[1] / 'common/texture').mkdir(parents=True)
        (own.parents[1] / 'common/texture/uv.hpp').write_text('int my_uv();\n')
        (self.student('wide') / 'lesson.hpp').write_text(LESSON, encoding='utf-16')
        (self.student('lines') / 'lesson.hpp').write_bytes(MINE.replace('\n', '\r\n').encode())
        linked = self.student('linked') / 'lesson.hpp'
        linked.rename(linked.with_name('mine.hpp'))
        linked.symlink_to('mine.hpp')
        # as in the tests
        self.student('named', lesson=LESSON + '\nnamespace texmap {\ninline int picture = 0;\n}\n')
        for name, other in {'crash': 'volatile int* nothing = nullptr;\n    *nothing = 1;\n',
                            'end': 'std::exit(0);\n',
                            'dark': 'if (objects.size() > 2) return {};\n',
                            'chatty': 'std::puts("a lesson that prints a line for every '
                                      'pixel");\n'}.items():
            self.student(name, lesson='#include <cstdio>\n#include <cstdlib>\n'
                         + LESSON.replace(COLOR, COLOR + other))
        every = ('tests: every pixel has the color that an independent program computes for the '
                 'ray through its center')
        rows = self.grade('--chapters', '1', '--no-second-picture')
        self.expect(rows, {
            'own': ('does not build', 'does not build', '',
                    "^your common/ is not used in grading; common/texture/uv.hpp differs from the "
                    "course's; .*my_uv"),
            'wide': ('does not build', 'does not build', '',
                     '^lesson.hpp is not in UTF-8 but probably in UTF-16: save it as UTF-8; '),
            'lines': ('ok', 'ok', '', '^$'), 'chatty': ('ok', 'ok', '', '^$'),
            'linked': ('missing', 'missing', '', 'is a symbolic link'),
            'named': ('ok', 'tests 0 of [0-9]+', '', '^the tests do not build with this lesson: '
                                                     '.*error: '),
            'crash': ('crashed SIGSEGV', 'crashed SIGSEGV', '', f'; {every}: it crashed: SIGSEGV'),
            'end': ('ok', 'no picture', '', '; tests: their program ended before all were run$'),
            'dark': ('ok', 'differs .*|black', '', f'^{every}: ')})
        self.assertEqual({row['of'] for row in rows.values()}, {'2'})
        for row in rows.values():
            self.assertNotRegex(row['note'], 'CHECK|: ;|^tests: *$')

    def test_of_chapter_04_the_second_picture_is_drawn_in_the_lessons_own_convention(self):
        # Its first picture is a sheet with all conventions, whatever the lesson begins with.
        def picture(*options):
            file = self.at / 'picture.png'
            subprocess.run([PROGRAMS / '04_uv_conventions', *options, '--quiet', '--out', file],
                           check=True)
            return file.read_bytes()
        chosen = build_and_run.hidden_options('04_uv_conventions', '', '', random.Random(1))
        self.assertEqual(picture(*chosen), picture(*chosen, '--convention', 'rtiow'))
        self.assertNotEqual(picture(*chosen), picture(*chosen, '--convention', 'daily'))


class Exercises(Case):
    def test_are_judged_by_the_values_of_the_students_function(self):
        solution = (TREE / 'tests/exercises/02_1.hpp').read_text()
        start = subprocess.run(['sh', 'common/tools/check/check.sh', 'start', '02.1'], cwd=TREE,
                               capture_output=True, text=True, check=True)
        right = solution + '// right, and names _exit\n'
        for name, text in {'right': right, 'capital': right, 'bare': right, 'copies': start.stdout,
                           'mirrored': solution.replace('atan2(-p.z', 'atan2(p.z'),
                           'start': start.stdout, 'broken': 'this does not compile\n',
                           'ends': f'#include <unistd.h>\n{solution}const int ended = [] {{ '
                                   f'_exit(0); return 0; }}();\n',
                           'loops': re.sub('(?m)^  const double v',
                                           r'  for (volatile int i = 0;; i = 1 - i) {} \g<0>',
                                           solution),
                           # Two write a verdict themselves: in words, and as values.
                           'words': FORGED % 'std::fputs("right\\n", file);' + solution,
                           'values': FORGED % 'for (int i = 0; i < 400 * 300 * 3 + 1000; ++i) '
                                              'std::fputc(0, file);' + solution}.items():
            chapters = {'capital': 'Chapters', 'bare': ''}.get(name, 'chapters')
            file = self.at / 'class' / name / chapters / '02_checkerboard_uv/exercises/1_mine.hpp'
            file.parent.mkdir(parents=True)
            file.write_text(text)
        own = self.at / 'class/copies/chapters/02_checkerboard_uv/exercises/1_where_on_the_map.hpp'
        own.write_text(right)
        rows = self.grade('--chapters', '02.2,2.1', '--seconds', '2', '--format', 'gradescope')
        judged = {name: rows.pop(name) for name in list(rows) if isinstance(name, str)}
        self.assertEqual({row['verdict'] for row in rows.values()}, {'missing'})  # nobody has 02.2
        read = '^read this file: it has _exit, which no exercise needs$'
        self.expect(judged, {
            **{name: ('ok', 'ok', '', read) for name in ('right', 'capital', 'bare')},
            'copies': ('ok', 'ok', '',
                       f'{read[:-1]}; .*/{own.name} is graded, and not .*/1_mine.hpp$'),
            'mirrored': ('ok', 'u runs the other way', '', r'^u runs the other way: your map is '
                                                           r'mirrored; tried: on \+z'),
            'start': ('unchanged', 'unchanged', '', '^what was'),
            'ends': ('ok', 'no verdict', '', '^no verdict: the program ended'),
            'loops': ('hang', 'hang', '', '.*'),
            'broken': ('does not build', 'does not build', '', 'error: '),
            'words': ('ok', 'no verdict', '',
                      '^no verdict: what the program left are not its values'),
            'values': ('ok', 'no verdict|u is the same everywhere', '', '.*')})
        tests = json.loads((self.out / 'mirrored.results.json').read_text())['tests']
        self.assertEqual([test['number'] for test in tests], ['2.E1', '2.E2'])
        self.assertIn('4 right<br>', (self.out / 'index.html').read_text())
        self.assertIn('there is no chapters/02_checkerboard_uv/exercises/2_a_walk_on_the_map.hpp',
                      (self.out / 'right.html').read_text())


class Attacks(Case):
    """The same attacks in a box, and in none."""

    def attack(self, kind):
        """Whether each attack reached what it aimed at."""
        aims = self.at / 'aims'
        (aims / 'removable').mkdir(parents=True)
        (aims / 'secret').write_text(f'file:{WORD}')
        (aims / 'key.hpp').write_text(f'key_{WORD.replace("-", "_")}\n')
        (aims / 'neighbor.html').write_text('page')
        self.out.mkdir()
        results = self.out / 'eve.results.json'
        listener = socket.create_server(('127.0.0.1', 0))
        listener.settimeout(0.1)
        victim = subprocess.Popen(['sleep', '1000'])
        sleep = f'{1000 + os.getpid()}.{time.monotonic_ns() % 1000000}'
        before = GOLDEN.stat()
        text = SHELL % ATTACKS
        for name, value in {'golden': GOLDEN, 'results': results,
                            'neighbor': aims / 'neighbor.html', 'removable': aims / 'removable',
                            'secret': aims / 'secret', 'word': WORD, 'sleep': sleep,
                            'port': listener.getsockname()[1], 'victim': victim.pid}.items():
            text = text.replace(f'@{name}@', str(value))
        self.student('attacker', text)
        self.student('key', lesson=LESSON + f'#include "{aims}/key.hpp"\n')
        self.student('assembler', f'asm(".incbin \\"{GOLDEN}\\"");\n' + EMPTY)
        os.symlink(aims / 'key.hpp',
                   self.student('link', lesson=LESSON + '#include "own.hpp"\n') / 'own.hpp')
        rows = self.grade('--chapters', '1', '--containment', kind, '--no-second-picture',
                          '--no-tests', *(['--trust-students'] if kind == 'none' else []),
                          environment=dict(os.environ, GRADER_KEY=WORD))
        note = rows['attacker']['note']
        left = running(sleep)
        for process in left:
            os.kill(process, signal.SIGKILL)
        try:
            listener.accept()[0].close()
            connected = True
        except TimeoutError:
            connected = False
        listener.close()
        done = {'golden overwritten': GOLDEN.stat().st_mtime_ns != before.st_mtime_ns,
                'results forged': results.exists(),
                "neighbor's page": (aims / 'neighbor.html').read_text() != 'page'
                or not (aims / 'removable').exists(), 'file printed': f'file:{WORD}' in note,
                'key included': WORD.replace('-', '_') in rows['key']['note'],
                'environment read': f'environment:{WORD}' in note or f'own:{WORD}' in note,
                'network': connected,
                'left processes': bool(left),
                'process killed': victim.poll() is not None,
                'golden by the assembler': rows['assembler']['build'] == 'ok'}
        victim.kill()
        victim.wait()
        os.utime(GOLDEN, ns=(before.st_atime_ns, before.st_mtime_ns))
        self.assertEqual({row['contained_by'] for row in rows.values()}, {kind})
        self.assertEqual(rows['attacker']['build'], 'ok', note)
        self.assertEqual(rows['link']['build'], 'does not build')
        self.assertNotIn(WORD.replace('-', '_'), rows['link']['note'])
        texts = [self.printed,
                 *((self.out / name).read_text(encoding='utf-8-sig')
                   for name in ('grades.csv', 'points.csv', 'index.html'))]
        self.assertEqual([NOT_CONTAINED in text.replace('&#39;', "'")[:5000] for text in texts],
                         [kind == 'none'] * 4)
        return done

    def test_succeed_where_nothing_contains_them(self):
        self.assertEqual([name for name, reached in self.attack('none').items() if not reached], [])

    def test_are_not_run_where_nothing_contains_them_unless_trusted(self):
        self.student('waits', EMPTY)
        (self.at / 'class/bob').mkdir()
        shutil.copy(GOLDEN, self.at / 'class/bob')
        grading = self.start('--chapters', '1', '--containment', 'none')
        _, said = grading.communicate()
        self.assertEqual(grading.returncode, 2)
        self.assertIn('  none: it contains nothing\n', said)
        self.assertIn('--trust-students runs it NOT CONTAINED', said)
        # what was graded before stays
        self.assertRegex((self.out / 'points.csv').read_text(), '"bob","1","2"')
        self.assertNotIn('waits', (self.out / 'grades.csv').read_text())

    def test_are_contained_by_bwrap(self):
        self.assertEqual([name for name, reached in self.attack('bwrap').items() if reached], [])

    def test_what_waits_ends_when_the_run_is_ended(self):
        seconds = f'{2000 + os.getpid()}.{time.monotonic_ns() % 1000000}'
        self.student('waits', f'#include <unistd.h>\nint main() {{ execl("/bin/sleep", "sleep", '
                              f'"{seconds}", nullptr); }}\n')
        grading = self.start('--chapters', '1', '--no-tests', '--no-second-picture')
        deadline = time.monotonic() + 300
        while not running(seconds) and grading.poll() is None and time.monotonic() < deadline:
            time.sleep(0.05)
        self.assertTrue(running(seconds))
        grading.send_signal(signal.SIGTERM)
        grading.communicate()
        self.assertEqual(grading.returncode, 130)
        self.assertEqual(running(seconds), [])
        self.assertNotIn('waits', (self.out / 'grades.csv').read_text())


class Boxed(Case):
    """What holds in a box, for root, too."""

    def run_in(self, kind, argv, *visible, product=''):
        """How a command ends in a box that nobody watches."""
        with mock.patch('box.usage', return_value=(0.0, 0, 1)):
            boxes = Boxes(kind, WORK, threading.Event())
            return boxes.run(argv, visible, Limits(10, 1024), product)

    def test_gets_no_more_processes_than_it_may(self):
        # A letter for each child that waits.
        ended = self.run_in('bwrap',
                            ['sh', '-c',
                             '(for i in $(seq 300); do sleep 60 2>&1 & printf c; done); :'])
        self.assertRegex(ended.log, '^c{32,63}(?!c)')
        self.assertEqual(ended.how, 'left processes')

    @unittest.skipIf(os.uname().machine not in ('x86_64', 'aarch64'),
                     'no filter of system calls for this machine')
    def test_gets_no_memory_that_is_not_counted(self):
        for kind, ways in {'bwrap': [],
                           'none': ('memfd segment semaphores queue pages zero pair '
                                    'socket').split()}.items():
            ended = self.run_in(kind, [os.path.realpath(sys.executable), '-c', UNCOUNTED],
                                sys.base_prefix)
            self.assertEqual((ended.how, ended.log.split()), ('ok', ways))

    def test_is_found_where_the_system_has_it_and_says_why_it_is_not(self):
        boxes = Boxes('bwrap', WORK, threading.Event())
        with mock.patch.dict(os.environ, PATH=str(self.at)):
            self.assertEqual(boxes.why_not(), '')
        with mock.patch.dict('box.ENVIRONMENT', PATH=str(self.at)):
            self.assertRegex(Boxes('bwrap', WORK, threading.Event()).why_not(),
                             'No such file|not found')

    @unittest.skipIf(os.geteuid() == 0, 'the kernel does not count the processes of root')
    def test_has_processes_whatever_else_the_user_runs(self):
        others = [subprocess.Popen(['sleep', '1000']) for _ in range(70)]
        self.assertEqual([self.run_in(kind, ['sh', '-c', 'true; sh -c true']).how
                          for kind in ('bwrap', 'none')], ['ok', 'ok'])
        for process in others:
            process.kill()
            process.wait()

    def test_reads_and_runs_what_only_the_grader_may_and_changes_nothing(self):
        own = self.at / 'own'
        own.mkdir(mode=0o700)
        (own / 'file').touch(mode=0o700)
        (own / 'file').write_text('#!/bin/sh\necho kept\n')
        for seen in (own, own / 'file'):
            script = f'{own}/file >it; echo changed >>{own}/file || echo unchanged >>it'
            ended = self.run_in('bwrap', ['sh', '-c', script], seen, product='it')
            self.assertEqual((ended.product, ended.how), (b'kept\nunchanged\n', 'ok'))


class Judging(Case):
    def test_goldens_that_change_end_the_run(self):
        grader = build_and_run.Grader.__new__(build_and_run.Grader)
        grader.lock, grader.sums = threading.Lock(), {}
        golden = self.at / 'golden.png'
        golden.write_bytes(b'right')
        grader.expected(golden)
        grader.expected(golden)
        golden.write_bytes(b'wrong')
        with self.assertRaises(GradeError):
            grader.expected(golden)

    def test_the_course_may_lie_in_a_folder_with_blanks(self):
        text = "a\\ b/main.cpp.o: o'b/a\\ b/c\\#.cpp \\\n  /usr/x.hpp\n"
        self.assertEqual(build_and_run.dependencies(text), ["o'b/a b/c#.cpp", '/usr/x.hpp'])

    def test_a_picture_that_is_drawn_again_is_there_at_any_moment(self):
        grader = build_and_run.Grader.__new__(build_and_run.Grader)
        grader.options = mock.Mock(no_tests=True)
        grader.course = mock.Mock(work=self.at, tree=self.at, chapters=self.at)
        grader.course.folder.return_value = self.at / ITEM
        grader.compile = lambda *_: Ended('ok', '', 0.0, '', b'program')
        seen = []
        grader.run = lambda *_: seen.append((self.at / 'place/hidden_picture.png').read_bytes())
        (self.at / 'place').mkdir()
        (self.at / 'place/hidden_picture.png').write_bytes(b'drawn before')
        grader.judge(ITEM, {}, self.at / 'place', None)
        self.assertEqual(seen, [b'drawn before'])
        self.assertEqual(sorted(os.listdir(self.at / 'place')),
                         ['hidden_picture.png', 'verdict.json'])

    def test_a_note_says_of_a_failed_test_its_name_and_what_is_and_should_be(self):
        rule = '=' * 79
        for said, words in {
                'ERROR: CHECK( middle.r == doctest::Approx(83.68).epsilon(0.0001) ) '
                'is NOT correct!\n  values: CHECK( 3 == Approx( 83.68 ) )\n':
                    ': it is 3 here and should be 83.68',
                'FATAL ERROR: REQUIRE( r <= 2 ) is NOT correct!\n'
                '  values: REQUIRE( 3 <= 2 )\n': ': 3 <= 2 does not hold',
                'ERROR: CHECK( a ) is NOT correct!\n  values: CHECK( false )\n': '',
                'ERROR: CHECK( r == 2 ) is NOT correct!\n  values: CHECK( 3 == 2 )\n'
                '  logged: on +z\n': ': on +z; it is 3 here and should be 2',
                'ERROR: u is 3 here and should be 2: '
                'u runs the other way\n': ': u is 3 here and should be 2: u runs the other way',
                'ERROR: 9 pixels differ\n  the first is (0, 0)\n':
                    ': 9 pixels differ; the first is (0, 0)',
                'ERROR: test case THREW exception: oh\n': ': it threw: oh',
                'FATAL ERROR: test case CRASHED: SIGSEGV - Segmentation violation signal\n':
                    ': it crashed: SIGSEGV - Segmentation violation signal'}.items():
            # Before it, a test that only prints a message, which has not failed.
            log = (f'{rule}\na.cpp:1:\nTEST CASE:  noise\n\na.cpp:2: MESSAGE: 64 samples\n\n'
                   f'{rule}\n/t.cpp:5:\nTEST SUITE: laws\nTEST CASE:  a law\n\n/t.cpp:5: {said}\n'
                   f'{rule}\n[doctest] test cases: 2\n')
            self.assertEqual(build_and_run.first_failure(log), f'a law{words}')
            self.assertEqual([block.split('\n')[0].strip()
                              for block in build_and_run.failures(log)], ['a law'])
        self.assertEqual(build_and_run.first_failure('[doctest] test cases: 1 | 1 passed\n'), '')


if __name__ == '__main__':
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    PROGRAMS, WORK = (Path(word).resolve() for word in sys.argv[1:3])
    WORK.mkdir(parents=True, exist_ok=True)
    if Boxes('bwrap', WORK, threading.Event()).why_not():
        print('skipped: bwrap makes no boxes here')
        sys.exit(77)
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
