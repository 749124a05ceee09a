#!/usr/bin/env python3
"""Students' code that attacks, loops and cheats, and what build_and_run.py makes of it.

usage: test_build_and_run.py TREE BUILD WORK    BUILD: a learn build of the tree, WORK: kept for the next time

Each attack is also run without a box, where it must succeed: else the test would show nothing. Status 77 where there are no boxes.
"""
import os
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
HERE = Path(__file__).resolve().parent
ITEM = '01_plain_spheres'
WORD = 'kept-' + os.urandom(8).hex()
EMPTY = 'int main() {}\n'

SPIN = 'int main() { for (volatile int i = 0;; i = 1 - i) {} }\n'
SLEEP = '#include <unistd.h>\nint main() { for (;;) sleep(1000); }\n'
CRASH = 'int main() { volatile int* nothing = nullptr; return *nothing; }\n'
TOUCH = '''#include <unistd.h>
void touch(int megabytes) {
  volatile char* block = new char[megabytes << 20];
  for (int i = 0; i < megabytes << 20; i += 4096) block[i] = 1;
}
'''
HOARD = TOUCH + 'int main() { for (;;) touch(16); }\n'
# Each of its processes has little memory; all of them have too much.
CROWD = TOUCH + '''int main() {
  for (int i = 0; i < 20; ++i) {
    if (fork() == 0) {
      touch(100);
      for (;;) sleep(1000);
    }
  }
  for (;;) sleep(1000);
}
'''
FORKS = '#include <unistd.h>\nint main() { for (;;) fork(); }\n'
# Fills the box, and says how much went in.
FILL = '''#include <cstdio>
#include <cstring>
int main() {
  static char block[1 << 20];
  std::memset(block, 1, sizeof block);
  int written = 0;
  for (int name = 0; name < 100; ++name) {
    std::FILE* file = std::fopen(std::to_string(name).c_str(), "wb");
    for (int i = 0; file != nullptr && i < 32 && std::fwrite(block, sizeof block, 1, file) == 1; ++i) ++written;
    if (file != nullptr) std::fclose(file);
  }
  std::printf("%d MB\\n", written);
  return 1;
}
'''.replace('#include <cstring>', '#include <cstring>\n#include <string>')
# Before main() it leaves the bytes of the golden picture, which are in the program.
COPYCAT = '''#include <cstdio>
#include <cstdlib>
#include <cstring>
static const unsigned char golden[] = {@bytes@};
struct Cheat {
  Cheat() {
    std::FILE* file = std::fopen("picture.png", "wb");
    std::fwrite(golden, sizeof golden, 1, file);
    std::fclose(file);
    std::_Exit(0);
  }
} cheat;
int main() {}
'''
# Writes a letter for each child that it gets, out of 300. They wait, a minute at most.
CHILDREN = '''#include <unistd.h>
int main() {
  for (int i = 0; i < 300; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      sleep(60);
      _exit(0);
    }
    if (child > 0 && write(1, "c", 1) != 1) return 1;
  }
}
'''
# Names each way to memory that no process is seen to have.
UNCOUNTED = '''#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/msg.h>
#include <sys/sem.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <fcntl.h>
#include <unistd.h>
#include <cstdio>
int main() {
  int ends[2];
  const auto got = [](const char* name, bool is) { if (is) std::puts(name); };
  const auto shared = [](int flags, int file) {
    return mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | flags, file, 0) != MAP_FAILED;
  };
  got("memfd", memfd_create("", 0) >= 0);
  const int segment = shmget(IPC_PRIVATE, 4096, 0600), semaphores = semget(IPC_PRIVATE, 1, 0600), queue = msgget(IPC_PRIVATE, 0600);
  got("segment", segment >= 0);
  got("semaphores", semaphores >= 0);
  got("queue", queue >= 0);
  shmctl(segment, IPC_RMID, nullptr);
  semctl(semaphores, 0, IPC_RMID);
  msgctl(queue, IPC_RMID, nullptr);
  got("pages", shared(MAP_ANONYMOUS, -1));
  got("zero", shared(0, open("/dev/zero", O_RDWR)));
  got("pair", socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0);
  got("socket", socket(AF_UNIX, SOCK_STREAM, 0) >= 0);
}
'''
LINKED = '#include <unistd.h>\nint main() { return symlink("/usr/include/stdio.h", "picture.png"); }\n'


def running(seconds):
    """The processes that sleep so long."""
    found = []
    for process in Path('/proc').iterdir():
        try:
            if process.name.isdigit() and (process / 'cmdline').read_bytes() == f'sleep\0{seconds}\0'.encode():
                found.append(int(process.name))
        except OSError:
            pass  # it has just ended
    return found


class Case(unittest.TestCase):
    tree = build = work = None

    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.at = Path(cls.place.name)
        cls.golden = cls.tree / 'tests/golden' / f'{ITEM}.png'

    @classmethod
    def tearDownClass(cls):
        cls.place.cleanup()

    def student(self, name, main=None, lesson=None):
        """A checkout with chapter 01; its main.cpp or the end of its lesson is another."""
        at = self.at / 'students' / name / 'chapters' / ITEM
        shutil.copytree(self.tree / 'chapters' / ITEM, at)
        if main is not None:
            (at / 'main.cpp').write_text(main)
        if lesson is not None:
            with open(at / 'lesson.hpp', 'a') as file:
                file.write(lesson)
        return at

    def start(self, *options, environment=None):
        """Begins to grade all students; the process, and the file that gets the rows."""
        plan, results = self.at / 'plan.tsv', self.at / 'results.tsv'
        students = sorted((self.at / 'students').iterdir())
        results.unlink(missing_ok=True)
        plan.write_text(''.join(f'{student.name}\t{student}\t{ITEM}\n' for student in students))
        command = [sys.executable, self.tree / 'common/tools/grade/build_and_run.py', '--tree', self.tree, '--build', self.build,
                   '--work', self.work, '--plan', plan, '--results', results, *options]
        return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment, umask=0o077), results

    def grade(self, *options, environment=None):
        """Grades all students; the rows by student."""
        grading, results = self.start(*options, environment=environment)
        _, self.said = grading.communicate()
        self.assertEqual(grading.returncode, 0, self.said)
        self.text = results.read_text()
        names = ('id item containment build run cpu_seconds limit_cpu_seconds picture expected hidden_picture hidden_expected '
                 'tests_passed tests_run cached note').split()
        rows = [dict(zip(names, line.split('\t'), strict=True)) for line in self.text.splitlines() if not line.startswith('forged')]
        return {row['id']: row for row in rows}

    def tearDown(self):
        shutil.rmtree(self.at / 'students', ignore_errors=True)


class Attacks(Case):
    """The same attacks in a box of each kind, and in none."""

    def attack(self, kind):
        """Whether each attack reached what it aimed at."""
        aims = self.at / 'aims'
        shutil.rmtree(aims, ignore_errors=True)
        (aims / 'removable').mkdir(parents=True)
        (aims / 'secret').write_text(f'file:{WORD}')
        (aims / 'key.hpp').write_text(f'key_{WORD.replace("-", "_")}\n')
        (aims / 'neighbor.html').write_text('page')
        listener = socket.create_server(('127.0.0.1', 0))
        listener.settimeout(0.1)
        victim = subprocess.Popen(['sleep', '1000'])
        sleep = f'{1000 + os.getpid()}.{time.monotonic_ns() % 1000000}'
        before = self.golden.stat()
        text = (HERE / 'attacks.cpp.in').read_text()
        for name, value in {'golden': self.golden, 'results': self.at / 'results.tsv', 'neighbor': aims / 'neighbor.html',
                            'removable': aims / 'removable', 'secret': aims / 'secret', 'word': WORD, 'sleep': sleep,
                            'port': listener.getsockname()[1], 'victim': victim.pid}.items():
            text = text.replace(f'@{name}@', str(value))
        self.student('attacker', text)
        self.student('key', lesson=f'#include "{aims}/key.hpp"\n')
        self.student('assembler', f'asm(".incbin \\"{self.golden}\\"");\n' + EMPTY)
        os.symlink(aims / 'key.hpp', self.student('link') / 'own.hpp')
        with open(self.at / 'students/link/chapters' / ITEM / 'lesson.hpp', 'a') as file:
            file.write('#include "own.hpp"\n')
        rows = self.grade('--containment', kind, '--no-hidden', '--no-tests', *(['--trust-students'] if kind == 'none' else []),
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
        done = {'golden overwritten': self.golden.stat().st_mtime_ns != before.st_mtime_ns,
                'results forged': 'forged\t' in self.text,
                "neighbor's page": (aims / 'neighbor.html').read_text() != 'page' or not (aims / 'removable').exists(),
                'file printed': f'file:{WORD}' in note,
                'key included': WORD.replace('-', '_') in rows['key']['note'],
                'environment read': f'environment:{WORD}' in note or f'own:{WORD}' in note,
                'network': connected,
                'left processes': bool(left),
                'process killed': victim.poll() is not None,
                'golden by the assembler': rows['assembler']['build'] == 'ok'}
        victim.kill()
        victim.wait()
        self.assertEqual({row['containment'] for row in rows.values()}, {kind})
        self.assertEqual(rows['attacker']['build'], 'ok', rows['attacker']['note'])
        self.assertEqual(rows['link']['build'], 'does not build')
        self.assertNotIn(WORD.replace('-', '_'), rows['link']['note'])
        os.utime(self.golden, ns=(before.st_atime_ns, before.st_mtime_ns))
        return done

    def test_succeed_where_nothing_contains_them(self):
        self.assertEqual([name for name, reached in self.attack('none').items() if not reached], [])

    def test_are_not_run_where_nothing_contains_them_unless_trusted(self):
        self.student('waits', SLEEP)
        grading, results = self.start('--containment', 'none')
        _, said = grading.communicate()
        self.assertEqual(grading.returncode, 2)
        self.assertIn('  none: it contains nothing\n', said)
        self.assertIn('--trust-students runs it NOT CONTAINED', said)
        self.assertFalse(results.exists())

    def test_are_contained_by_bwrap(self):
        self.assertEqual([name for name, reached in self.attack('bwrap').items() if reached], [])


class Boxed(Case):
    """What holds in a box of each kind, for root, too."""

    def each(self, argv, *visible, product='', kinds=()):
        """How a command ends in a box of each kind that nobody watches."""
        from box import Boxes, Limits
        with mock.patch('box.usage', return_value=(0.0, 0, 1)):
            return {kind: Boxes(kind, self.work).run(argv, visible, Limits(10, 1024), product) for kind in kinds or KINDS}

    def test_gets_no_more_processes_than_it_may(self):
        program = self.at / 'children'
        subprocess.run([os.environ.get('CXX', 'c++'), '-x', 'c++', '-', '-o', program], input=CHILDREN, text=True, check=True)
        for kind, ended in self.each([str(program)], program).items():
            with self.subTest(kind):
                self.assertRegex(ended.log, '^c{32,63}$')
                self.assertEqual(ended.how, 'left processes')

    @unittest.skipIf(os.uname().machine not in ('x86_64', 'aarch64'), 'no filter of system calls for this machine')
    def test_gets_no_memory_that_is_not_counted(self):
        program = self.at / 'uncounted'
        subprocess.run([os.environ.get('CXX', 'c++'), '-x', 'c++', '-', '-o', program], input=UNCOUNTED, text=True, check=True)
        ways = 'memfd segment semaphores queue pages zero pair socket'.split()
        for kind, ended in self.each([str(program)], program, kinds=[*KINDS, 'none']).items():
            with self.subTest(kind):
                self.assertEqual((ended.how, ended.log.split()), ('ok', ways if kind == 'none' else []))

    def test_is_found_where_the_system_has_it_and_says_why_it_is_not(self):
        from box import Boxes
        with mock.patch.dict(os.environ, PATH=str(self.at)):
            self.assertEqual([kind for kind in KINDS if Boxes(kind, self.work).why_not()], [])
        with mock.patch.dict('box.ENVIRONMENT', PATH=str(self.at)):
            for kind in KINDS:
                self.assertRegex(Boxes(kind, self.work).why_not(), 'No such file|not found')

    @unittest.skipIf(os.geteuid() == 0, 'the kernel does not count the processes of root')
    def test_has_processes_whatever_else_the_user_runs(self):
        others = [subprocess.Popen(['sleep', '1000']) for _ in range(70)]
        for kind, ended in self.each(['sh', '-c', 'true; sh -c true'], kinds=[*KINDS, 'none']).items():
            with self.subTest(kind):
                self.assertEqual(ended.how, 'ok')
        for process in others:
            process.kill()
            process.wait()

    def test_reads_and_runs_what_only_the_grader_may_and_changes_nothing(self):
        own = self.at / 'own'
        own.mkdir(mode=0o700)
        (own / 'file').touch(mode=0o700)
        (own / 'file').write_text('#!/bin/sh\necho kept\n')
        script = f'{own}/file >it; echo changed >>{own}/file || echo unchanged >>it'
        for seen in (own, own / 'file'):
            for kind, ended in self.each(['sh', '-c', script], seen, product='it').items():
                with self.subTest(kind, seen=seen.name):
                    self.assertEqual((ended.product, ended.how), (b'kept\nunchanged\n', 'ok'))


class Goldens(unittest.TestCase):
    def test_that_change_end_the_run(self):
        from build_and_run import CourseError, Grader
        grader = Grader.__new__(Grader)
        grader.lock, grader.sums = threading.Lock(), {}
        with tempfile.TemporaryDirectory() as place:
            golden = Path(place) / 'golden.png'
            golden.write_bytes(b'right')
            self.assertEqual([grader.expected(golden) for _ in range(2)], [str(golden)] * 2)
            golden.write_bytes(b'wrong')
            with self.assertRaises(CourseError):
                grader.expected(golden)


class Notes(unittest.TestCase):
    """What an instructor reads about a failure."""

    def test_say_of_a_failed_test_its_name_and_what_is_and_should_be(self):
        from build_and_run import first_failure
        for said, words in {
                'ERROR: CHECK( middle.r == doctest::Approx(83.68).epsilon(0.0001) ) is NOT correct!\n'
                '  values: CHECK( 3 == Approx( 83.68 ) )\n': 'a law: it is 3 here and should be 83.68',
                'FATAL ERROR: REQUIRE( r <= 2 ) is NOT correct!\n  values: REQUIRE( 3 <= 2 )\n': 'a law: 3 <= 2 does not hold',
                'ERROR: CHECK( a ) is NOT correct!\n  values: CHECK( false )\n': 'a law',
                'ERROR: CHECK( r == 2 ) is NOT correct!\n  values: CHECK( 3 == 2 )\n  logged: on +z\n':
                    'a law: on +z; it is 3 here and should be 2',
                'ERROR: u is 3 here and should be 2: u runs the other way\n': 'a law: u is 3 here and should be 2: u runs the other way',
                'ERROR: 9 pixels differ\n  the first is (0, 0)\n': 'a law: 9 pixels differ; the first is (0, 0)',
                'ERROR: test case THREW exception: oh\n': 'a law: it threw: oh',
                'FATAL ERROR: test case CRASHED: SIGSEGV - Segmentation violation signal\n':
                    'a law: it crashed: SIGSEGV - Segmentation violation signal'}.items():
            rule = '=' * 79 + '\n'
            log = f'{rule}/t.cpp:5:\nTEST SUITE: laws\nTEST CASE:  a law\n\n/t.cpp:5: {said}\n{rule}[doctest] test cases: 1 | 0 passed\n'
            self.assertEqual(first_failure(log), words)
        self.assertEqual(first_failure('[doctest] test cases: 1 | 1 passed\n'), '')

    def test_a_test_that_only_prints_a_message_has_not_failed(self):
        from build_and_run import failures, first_failure
        line = '=' * 79
        log = (f'{line}\na.cpp:1:\nTEST CASE:  noise\n\na.cpp:2: MESSAGE: 64 samples\n\n{line}\na.cpp:5:\nTEST CASE:  a law\n\n'
               f'a.cpp:6: ERROR: CHECK( a ) is NOT correct!\n  values: CHECK( false )\n\n{line}\n[doctest] test cases: 2 | 1 passed\n')
        self.assertEqual([block.split('\n')[0].strip() for block in failures(log)], ['a law'])
        self.assertEqual(first_failure(log), 'a law')


class Causes(Case):
    """What is wrong with a checkout that the compiler does not say."""

    def test_are_said(self):
        own = self.student('own', lesson='const int made = my_uv();\n')
        (own.parents[1] / 'common/texture').mkdir(parents=True)
        (own.parents[1] / 'common/texture/uv.hpp').write_text('int my_uv();\n')
        lesson = (self.tree / 'chapters' / ITEM / 'lesson.hpp').read_text()
        (self.student('wide') / 'lesson.hpp').write_text(lesson, encoding='utf-16')
        (self.student('lines') / 'lesson.hpp').write_bytes(lesson.replace('\n', '\r\n').encode())
        linked = self.student('linked') / 'lesson.hpp'
        linked.rename(linked.with_name('mine.hpp'))
        linked.symlink_to('mine.hpp')
        (self.student('none') / 'lesson.hpp').unlink()
        color = 'template <class Real>\n  Color<Real> operator()(const Ray<Real>& ray) const {\n'
        self.assertIn(color, lesson)
        (self.student('named') / 'lesson.hpp').write_text(lesson + '\nnamespace texmap {\ninline int picture = 0;\n}\n')  # as in the tests
        for name, other in {'crash': color + 'volatile int* nothing = nullptr;\n    *nothing = 1;\n',
                            'end': color + 'std::exit(0);\n',
                            'dark': color + 'if (objects.size() > 2) return {};\n'}.items():
            self.student(name).joinpath('lesson.hpp').write_text('#include <cstdlib>\n' + lesson.replace(color, other))
        rows = self.grade('--no-hidden')
        notes = {name: row['note'] for name, row in rows.items()}
        self.assertRegex(notes['own'], "^your common/ is not used in grading; common/texture/uv.hpp differs from the course's; .*my_uv")
        self.assertRegex(notes['wide'], '^lesson.hpp is not in UTF-8 but probably in UTF-16: save it as UTF-8; ')
        self.assertEqual((rows['lines']['build'], notes['lines']), ('ok', ''))
        self.assertIn('is a symbolic link', notes['linked'])
        self.assertEqual(notes['none'], f'there is no chapters/{ITEM}/lesson.hpp')
        every = 'tests: every pixel has the color that an independent program computes for the ray through its center'
        self.assertRegex(notes['named'], '^the tests do not build with this lesson: .*error: ')
        self.assertRegex(notes['crash'], f'; {every}: it crashed: SIGSEGV')
        self.assertRegex(notes['end'], '; tests: their program ended before all were run$')
        self.assertRegex(notes['dark'], f'^{every}: ')
        for note in notes.values():
            self.assertNotRegex(note, 'CHECK|: ;|^tests: *$')


class Interrupts(Case):
    def test_end_what_runs(self):
        seconds = f'{2000 + os.getpid()}.{time.monotonic_ns() % 1000000}'
        self.student('waits', f'#include <unistd.h>\nint main() {{ execl("/bin/sleep", "sleep", "{seconds}", nullptr); }}\n')
        grading, results = self.start('--no-tests', '--no-hidden')
        deadline = time.monotonic() + 300
        while not running(seconds) and grading.poll() is None and time.monotonic() < deadline:
            time.sleep(0.05)
        self.assertTrue(running(seconds))
        grading.send_signal(signal.SIGTERM)
        grading.communicate()
        self.assertEqual(grading.returncode, 130)
        self.assertEqual(running(seconds), [])
        self.assertEqual(results.read_text(), '')


class Endless(Case):
    def test_end_what_does_not_end(self):
        for name, main in {'spin': SPIN, 'sleep': SLEEP, 'crash': CRASH, 'hoard': HOARD, 'crowd': CROWD, 'forks': FORKS, 'fill': FILL,
                           'linked': LINKED, 'copycat': COPYCAT.replace('@bytes@', ','.join(map(str, self.golden.read_bytes()))),
                           'loud': '#include <cstdio>\nint main() { for (int i = 0; i < 50000000; ++i) std::puts("x"); }\n'}.items():
            self.student(name, main)
        self.student('honest', lesson='// mine\n')
        private = self.student('private', lesson='// for me alone\n')
        for path in [private, *private.rglob('*')]:
            path.chmod(0o700 if path.is_dir() else 0o600)
        self.student('same')
        (self.student('without') / 'main.cpp').unlink()
        (self.student('missing') / 'lesson.hpp').unlink()
        rows = self.grade('--no-tests', '--megabytes', '500')
        how = {name: row['run'] for name, row in rows.items()}
        self.assertEqual(how, {'spin': 'hang', 'sleep': 'hang', 'crash': 'crashed SIGSEGV', 'hoard': 'too much memory',
                               'crowd': 'too much memory', 'forks': how['forks'], 'fill': 'failed (1)', 'linked': 'ok',
                               'copycat': 'ok', 'loud': how['loud'], 'honest': 'ok', 'private': 'ok', 'same': 'ok', 'without': 'ok',
                               'missing': ''})
        self.assertIn(how['forks'], ('hang', 'too many processes'))
        self.assertIn(how['loud'], ('ok', 'hang'))
        self.assertLessEqual(int(rows['fill']['note'].split()[0]), 64)
        self.assertEqual(rows['linked']['picture'], '')
        self.assertEqual(rows['missing']['build'], 'missing')
        for name in ('spin', 'honest'):
            self.assertGreaterEqual(float(rows[name]['limit_cpu_seconds']), 5)
        for name in ('honest', 'private', 'same', 'without'):  # right in both pictures
            self.assertEqual(Path(rows[name]['hidden_picture']).read_bytes(), Path(rows[name]['hidden_expected']).read_bytes())
        # One that carries the golden picture is right in the first alone.
        self.assertEqual(Path(rows['copycat']['picture']).read_bytes(), self.golden.read_bytes())
        self.assertNotEqual(Path(rows['copycat']['hidden_picture']).read_bytes(), Path(rows['copycat']['hidden_expected']).read_bytes())
        # The same checkouts once more: nothing is built or run.
        again = self.grade('--no-tests', '--megabytes', '500')
        self.assertNotIn('takes minutes', self.said)
        self.assertEqual({row['cached'] for name, row in again.items() if name != 'missing'}, {'yes'})
        for name, row in again.items():
            self.assertEqual(dict(row, cached=''), dict(rows[name], cached=''))


def works(kind, work):
    sys.path.insert(0, str(Case.tree / 'common/tools/grade'))
    from box import Boxes
    return not Boxes(kind, work).why_not()


if __name__ == '__main__':
    if len(sys.argv) < 4:
        sys.exit('usage: test_build_and_run.py TREE BUILD WORK [TEST...]')
    Case.tree, Case.build, Case.work = (Path(word).resolve() for word in sys.argv[1:4])
    Case.work.mkdir(parents=True, exist_ok=True)
    KINDS = [kind for kind in ('bwrap',) if works(kind, Case.work)]
    if not KINDS:
        print('skipped: bwrap makes no boxes here')
        sys.exit(77)
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
