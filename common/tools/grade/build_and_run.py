"""Builds and runs students' chapters and exercises on Linux, kept from everything else.

docs/grading.md says what is contained and what is not.

A student's code runs in a box (box.py), and so does the compiler that reads it. Golden pictures,
results, other students and the home folder are not in there.
"""
import concurrent.futures
import dataclasses
import functools
import hashlib
import json
import os
import random
import re
import shlex
import shutil
import stat
import subprocess
import sys
import tempfile
import threading
from pathlib import Path

from box import BOX, ENVIRONMENT, Boxes, Limits
from pictures import png
from results import GradeError

# A chapter's suites, of which the first that reads its lesson counts. Chapter 13's times itself: a
# busy machine would fail it.
SUITES = ('symptoms_{item:.2}.cpp', 'test_{item}.cpp')
UNTESTED = ('13',)
# What no exercise needs: a file that has one of these and is right should be read.
SUSPECT = (
    r'constructor|_[eE]xit|syscall|\basm\b|fopen|fstream|environ|/proc|check::|'
    r'exercises_of_chapter')
SUFFIXES = ('.hpp', '.cpp', '.h', '.c', '.inc', '.inl')
MOST_FILES, MOST_FILE_BYTES = 100, 1 << 20  # taken of a student's chapter
# of CPU: the least limit of a run; a file; the course's own lesson
FLOOR_SECONDS, COMPILE_SECONDS, COURSE_SECONDS = 5, 120, 900
CPU_FACTOR = 10  # the limit of a run, in times of the course's own lesson


@dataclasses.dataclass
class Unit:
    """One file that is compiled: its command without source and object, and the chapter's files
    that it read."""
    command: list
    source: str
    object: str
    read: list


def digest(*pieces):
    return hashlib.sha256(b'\0'.join(hashlib.sha256(piece).digest()
                                     for piece in pieces)).hexdigest()


def replace(path, data):
    """Writes a file all at once."""
    part = path.with_suffix('.part')
    part.write_bytes(data)
    os.replace(part, path)


def sources_in(folder, most=MOST_FILES):
    """The C++ files of a chapter, or of a folder: so many regular files of moderate size, no links,
    and none that is hidden, as Apple's ._lesson.hpp. By name, with their bytes."""
    found = {}
    for parent, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders
                            if not os.path.islink(os.path.join(parent, name)))
        for name in sorted(names):
            path = os.path.join(parent, name)
            status = os.lstat(path)
            if name.endswith(SUFFIXES) and name[0] != '.' and stat.S_ISREG(
                status.st_mode) and status.st_size < MOST_FILE_BYTES and len(found) < most:
                found[os.path.relpath(path, folder)] = Path(path).read_bytes()
    return found


def is_exercise(item):
    return re.fullmatch(r'\d\d\.\d', item) is not None


def chapters_in(folder):
    """The chapters of a folder: in its chapters/, or the folder itself holds them."""
    inner = Path(folder) / 'chapters'
    return inner if os.path.lexists(inner) else Path(folder)


def dependencies(text):
    """The files that a compiler's .d file names: blanks in a name have a backslash in front."""
    words = re.split(r'(?<!\\)\s+', text.replace('\\\n', ' ').strip())[1:]
    return [re.sub(r'\\([ #])|\$(\$)', r'\1\2', word) for word in words]


def exercises_in(folder, item, shipped=''):
    """The files of an exercise, which are found by its number, that of the shipped name first: of
    each the folder, its name and its bytes. Links are not followed."""
    found = [(at, name, text)
             for at in sorted(chapters_in(folder).glob(f'{item[:2]}_*/exercises'))
             if not any(os.path.islink(place) for place in (at, at.parent, at.parent.parent))
             for name, text in sources_in(at).items()
             if re.fullmatch(item[3] + r'_[^/]*\.hpp', name)]
    return sorted(found, key=lambda file: file[1] != shipped)


def run_to_end(command, stopping, **streams):
    """Runs a program that Ctrl-C does not reach, and ends it when this one is to stop. Its
    status."""
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, start_new_session=True,
                          **streams) as process:
        while not stopping.is_set():
            try:
                return process.wait(0.05)
            except subprocess.TimeoutExpired:
                pass
        os.killpg(process.pid, 15)
    raise KeyboardInterrupt


class Course:
    """The instructor's tree and its learn build."""

    def __init__(self, tree, work, stopping):
        self.tree, self.work, self.build, self.stopping = tree, work, work / 'build', stopping
        self.chapters, self.tests = tree / 'chapters', tree / 'tests'

    def make(self, items):
        """Builds what all students share and the course's own lessons; returns what they were made
        from, as a hash."""
        log = self.work / 'build.log'
        exercises = {'exercise_' + item.replace('.', '_'): item for item in items
                     if is_exercise(item)}
        chapters = set(items) - set(exercises.values())
        built = sorted(chapters.union(*map(self.compared_with, chapters)))
        targets = built + ['00_one_file'] + sorted(
            {'check_' + item[:2] for item in exercises.values()})
        first = '' if (self.work / 'cache').exists() else '; the first time takes minutes'
        print(f'building the course\'s own lessons{first}', file=sys.stderr, flush=True)
        if not shutil.which('cmake'):
            raise GradeError('the course itself cannot be built: there is no cmake on your PATH')
        with open(log, 'wb') as out:
            for command in (['cmake', '-S', self.tree, '-B', self.build, '-G', 'Unix Makefiles',
                             '-D', 'CMAKE_BUILD_TYPE=Release',
                             '-D', 'TEXMAP_LEARN=ON', '-D', 'CMAKE_EXPORT_COMPILE_COMMANDS=ON'],
                            ['cmake', '--build', self.build, '--parallel', str(os.cpu_count() or 1),
                             '--target', 'compare', *targets]):
                if run_to_end(command, self.stopping, stdout=out, stderr=out):
                    raise GradeError(f'the course itself cannot be built: see {log}')
        self.units = {item: [] for item in [*built, *exercises.values()]}
        for entry in json.loads((self.build / 'compile_commands.json').read_text()):
            words = shlex.split(entry['command'])
            made = os.path.normpath(os.path.join(entry['directory'],
                                                 words.pop(words.index('-o') + 1)))
            target = re.search(r'/CMakeFiles/([^/]+)\.dir/', made)[1]
            item = exercises.get(target, re.sub('(_code|_wide)$', '', target))
            if item in self.units and is_exercise(item):
                # it is not compiled for the course, and always for a student
                read = [entry['file']]
            elif item in self.units and '/chapters/CMakeFiles/' in made:
                # ccache writes them relative
                read = [os.path.normpath(os.path.join(entry['directory'], name))
                        for name in dependencies(Path(made + '.d').read_text())]
                if entry['file'] not in read:
                    raise GradeError(f'{made}.d does not name {entry["file"]}: what has to be '
                                     'compiled again is not known')
            else:
                continue
            here = str(self.folder(item)) + '/'
            words = words[:words.index('-o')] + words[words.index('-o') + 1:words.index('-c')]
            self.units[item].append(Unit(words, entry['file'], made,
                                         [name[len(here):] for name in read
                                          if name.startswith(here)]))
        archives = sorted((self.build / 'common').glob('*.a'))
        self.shared = [self.tree / 'common', self.build / 'CMakeFiles' / 'learn_headers.dir',
                       *archives]
        pieces = [subprocess.run(['c++', '--version'], capture_output=True, check=True).stdout]
        for folder in ('common', 'chapters', 'assets', 'tests/golden', 'tests/support',
                       'tests/chapters', 'tests/exercises'):
            for path in sorted((self.tree / folder).rglob('*')):
                if path.is_file():
                    pieces += [str(path).encode(), path.read_bytes()]
        return digest(*pieces)

    def folder(self, item):
        """Where the course's own lesson is, or its own file of an exercise."""
        return exercises_in(self.tree, item)[0][0] if is_exercise(item) else self.chapters / item

    def has(self, item):
        return bool(exercises_in(self.tree, item)) if is_exercise(item) else (
            self.chapters / item / 'lesson.hpp').is_file()

    def own(self, item):
        """The files of the course's own lesson; of an exercise the solution, under the name that
        the student's file has."""
        if not is_exercise(item):
            return sources_in(self.chapters / item)
        solution = self.tests / 'exercises' / f'{item.replace(".", "_")}.hpp'
        return {exercises_in(self.tree, item)[0][1]: solution.read_bytes()}

    @functools.cache
    def handed_out(self, item):
        """What students begin with. The course's own file of an exercise may have an answer."""
        if not is_exercise(item):
            return self.own(item)
        start = subprocess.run(['sh', 'common/tools/check/check.sh', 'start', item], cwd=self.tree,
                               capture_output=True, check=True)
        return {exercises_in(self.tree, item)[0][1]: start.stdout}

    def link(self, item):
        """The command that links the item's program, with whole paths and without -o."""
        at, target = self.build / 'chapters', item
        if is_exercise(item):
            at, target = self.build / 'common/tools/check', 'exercise_' + item.replace('.', '_')
        words = shlex.split((at / 'CMakeFiles' / f'{target}.dir' / 'link.txt').read_text())
        where = words.index('-o')
        return [os.path.normpath(at / word) if word.endswith(('.o', '.a')) else word
                for word in words[:where] + words[where + 2:]]

    def suite(self, item):
        """The chapter's suite, or None."""
        suites = [self.tests / 'chapters' / name.format(item=item) for name in SUITES]
        fit = [suite for suite in suites if suite.is_file()
               and f'"{item}/lesson.hpp"' in suite.read_text()]
        return fit[0] if fit and not item.startswith(UNTESTED) else None

    def compared_with(self, item):
        """The other chapters that the suite reads."""
        suite = self.suite(item)
        names = set(re.findall(r'"(\d\d_\w+)/', suite.read_text())) if suite else set()
        return [name for name in sorted(names) if name != item
                and (self.chapters / name / 'main.cpp').is_file()]

    def test_command(self, item, program):
        """How a suite of the chapter is compiled, but for source and object; it can run the
        chapter's program."""
        cache = (self.build / 'CMakeCache.txt').read_text()
        doctest = re.search('^doctest_INCLUDE_DIR:PATH=(.*)$', cache, re.MULTILINE)
        folders = [self.chapters, self.tests, self.tests / 'support',
                   *([doctest[1]] if doctest else [])]
        texts = {'CHAPTER': program, 'ASSETS_DIR': self.tree / 'assets', 'TESTS_DIR': self.tests,
                 'BIN_DIR': BOX,
                 'DIFFERING_DIR': 'differing', 'ONE_FILE': self.build / 'bin' / '00_one_file'}
        main = next(unit for unit in self.units[item] if unit.object.endswith('/main.cpp.o'))
        words = [word for word in main.command if not word.startswith('-DTEXMAP_CHAPTER=')]
        return words + [f'-DTEXMAP_{name}="{text}"'
                        for name, text in texts.items()] + [f'-I{folder}' for folder in folders]

    def neighbors(self, item):
        """The chapters that a lesson may include; an exercise includes none."""
        return [] if is_exercise(item) else [path for path in sorted(self.chapters.iterdir())
                                             if path.is_dir() and path.name != item]


def random_texture(path, rng):
    """Writes a PNG of 128 x 64 texels in blocks of random colors."""
    colors = [bytes(rng.randrange(256) for _ in range(3)) for _ in range(16 * 8)]
    path.write_bytes(png(128, 64, b''.join(colors[row // 8 * 16 + column // 8] for row in range(64)
                                           for column in range(128))))


def hidden_options(item, offered, texture, rng):
    """Options for a picture that no student has seen: another size, texture, angle."""
    width = rng.randrange(240, 360)
    options = ['--width', str(width), '--height', str(width * 3 // 4 + rng.randrange(-20, 20))]
    # the stage in the lesson's own convention
    options += {'04': ['--rounding', rng.choice(['floor', 'lecture'])],
                '09': ['--filter', rng.choice(['trilinear', 'anisotropic', 'ewa'])],
                '10': ['--projection', rng.choice(['cube', 'octahedral', 'equal-area'])],
                '13': ['--seconds', '1', '--rounds', '1'],
                '14': ['--exhibit', rng.choice(['pole', 'seam', 'turns', 'units'])]}.get(
                    item[:2], [])
    for option, value in (('--texture', texture), ('--sky', texture),
                          ('--degrees', rng.randrange(20, 340))):
        if f'  {option} ' in offered and option + ' constant' not in offered:
            options += [option, str(value)]
    return options + (['--samples', '16'] if '(default: 100)' in offered else [])


def first_error(log):
    """The line that says what is wrong."""
    lines = log.splitlines()
    for pattern in (r'(error|Error):(?! ld returned| linker command)',
                    r'undefined reference|multiple definition|out of memory|error', r'\S'):
        for line in lines:
            if re.search(pattern, line):
                return line.strip()[:300]
    return 'the compiler said nothing'


def failures(log):
    """What doctest prints of each test that failed, from its name on. Of a test that only prints a
    message there is a block, too."""
    blocks = [block.partition('TEST CASE:')[2]
              for block in re.split(r'^=+$|^\[doctest]', log, flags=re.MULTILINE)]
    return [block for block in blocks if re.search(r'^\S+:\d+: (?:FATAL )?ERROR: ', block,
                                                   re.MULTILINE)]


def first_failure(log):
    """The first test that failed, in words: its name, and what it says or what is and should be;
    empty if none says so."""
    first = next(iter(failures(log)), '')
    name, said, *_ = [*re.split(r'^\S+:\d+: (?:FATAL )?ERROR: ', first, flags=re.MULTILINE), '', '']
    asserted = re.match(
        r'[A-Z_]+\( .*(?:is NOT correct!|did NOT throw|threw a DIFFERENT|THREW )', said)
    if asserted:
        values = re.search(r'^ *values: [A-Z_]+\( (.*) \)$', said, re.MULTILINE)
        logged = re.search(r'^ *logged: (.*)', said, re.MULTILINE | re.DOTALL)
        said = [logged[1].strip()] if logged else []
        equal = values and re.fullmatch(r'(.+?)(?: == |, )(?:Approx\( )?(.+?)(?: \))?', values[1])
        if equal:
            said.append(f'it is {equal[1]} here and should be {equal[2]}')
        elif values and values[1] not in ('true', 'false'):
            said.append(f'{values[1]} does not hold')
        said = '; '.join(said)
    said = re.sub('test case (CRASHED|THREW exception)',
                  lambda word: {'C': 'it crashed', 'T': 'it threw'}[word[1][0]], said)
    lines = [[line.strip() for line in text.splitlines() if line.strip()] for text in (name, said)]
    words = ': '.join('; '.join(part) for part in lines if part)
    return re.sub('[:;]? look at differing/.*', '', words)[:400]  # the box's pictures are not kept


def cause(checkout, files, course_common):
    """Why a chapter may not build, if that is not in the compiler's words."""
    for name, text in sorted(files.items()):
        if b'\0' in text:
            return f'{name} is not in UTF-8 but probably in UTF-16: save it as UTF-8'
    own = Path(checkout) / 'common'
    for name, text in () if own.is_symlink() else sources_in(own, 10 * MOST_FILES).items():
        known = course_common / name
        if not known.is_file() or known.read_bytes() != text:
            return (f'your common/ is not used in grading; common/{name} differs from the '
                    'course\'s')
    return ''


class Grader:
    """Judges chapters once each, side by side."""

    def __init__(self, options, course, boxes, made_from):
        self.options, self.course, self.boxes = options, course, boxes
        self.cache = course.work / 'cache'
        self.cache.mkdir(exist_ok=True)
        seed = self.cache / 'seed'  # one for this folder: what was judged before stays judged
        if not seed.exists():
            seed.write_text(str(random.SystemRandom().getrandbits(64)))
        self.seed = seed.read_text()
        self.made_from = digest(made_from.encode(),
                                repr((self.seed, boxes.kind, options.megabytes, options.no_tests,
                                                          options.no_second_picture,
                                      options.seconds)).encode())
        self.lock = threading.Lock()
        self.under_way, self.sums = {}, {}

    def expected(self, path):
        """Stops everything if a picture to compare with is not what it was at the beginning."""
        found = digest(path.read_bytes()) if path.is_file() else ''
        with self.lock:
            if self.sums.setdefault(path, found) != found:
                raise GradeError(f'{path} has changed while students were graded: no grade of '
                                 'this run counts')

    def once(self, key, work):
        """The result of work(), which runs once for each key."""
        with self.lock:
            mine = key not in self.under_way
            future = self.under_way.setdefault(key, concurrent.futures.Future())
        if mine:
            try:
                future.set_result(work())
            except BaseException as error:
                future.set_exception(error)
        return future.result()

    def key(self, item, files):
        """A hash of all that the verdict on these files depends on."""
        return digest(self.made_from.encode(), item.encode(),
                      *(piece for name in sorted(files) for piece in (name.encode(), files[name])))

    def verdict(self, item, folder):
        """What is known of a student's chapter or exercise."""
        own = self.course.own(item)
        if is_exercise(item):
            files = exercises_in(folder, item, next(iter(own)))
            found = {next(iter(own)): text for *_, text in files[:1]}
            needed = str((self.course.folder(item) / next(iter(own))).relative_to(self.course.tree))
        else:
            at = chapters_in(folder) / item
            found = {} if os.path.islink(at) or os.path.islink(at.parent) else sources_in(at)
            needed = f'chapters/{item}/lesson.hpp'
        if Path(needed).name not in found:
            at = chapters_in(folder) / Path(needed).relative_to('chapters')
            if is_exercise(item):
                at = next(chapters_in(folder).glob(f'{item[:2]}_*/exercises/{item[3]}_*.hpp'), at)
            linked = any(os.path.islink(Path(folder, *at.relative_to(folder).parts[:depth]))
                         for depth in (1, 2, 3, 4))
            why = (f'{needed} is a symbolic link or behind one, and links are not followed'
                   if linked else f'there is no {needed}')
            return {'build': 'missing', 'note': why}
        files = own | found
        written = self.written(item, files)
        # whatever else lies beside them
        if self.written(item, {name: files[name] for name in own}) == self.written(
            item, self.course.handed_out(item)):
            return {'build': 'unchanged',
                    'note': 'what was handed out, but for blanks and comments'}
        key = self.key(item, files)
        place = self.cache / key

        def judge():
            if (place / 'verdict.json').exists():
                return json.loads((place / 'verdict.json').read_text())
            course = self.reference(item)
            return course if files == own else self.judge(item, files, place, course)
        result = self.once(key, judge)
        if result['build'] == 'does not build':
            why = cause(folder, found, self.course.tree / 'common')
            result = dict(result, note=why + ('; ' if why else '') + result['note'])
        return dict(result, written=written)

    @staticmethod
    def written(item, files):
        """A hash of what is written in these files, without blanks and comments. A chapter's
        exercises are none of its files."""
        return digest(*(re.sub(rb'("(?:\\.|[^"\\\n])*")|//[^\n]*|/\*.*?\*/|\s+', rb'\1',
                               files[name], flags=re.DOTALL)
                        for name in sorted(files) if is_exercise(item)
                        or not name.startswith('exercises/')))

    def reference(self, item):
        """The course's own lesson or solution, judged in this session: its times are the limits'
        measure."""
        own = self.course.own(item)

        def judge():
            result = self.judge(item, own, self.cache / self.key(item, own), None)
            if result['build'] != 'ok' or result['run'] != 'ok' or is_exercise(item) and result[
                'tests_passed'] != '1':
                raise GradeError(f"the course's own {item}: {result['build']}, {result['run']}: "
                                 f"{result['note']}")
            return result
        return self.once((item, 'reference'), judge)

    def limits(self, course, name):
        """The course's own time for this task, times CPU_FACTOR."""
        if not course:
            return Limits(COURSE_SECONDS, self.options.megabytes)
        return Limits(self.options.seconds or max(FLOOR_SECONDS, CPU_FACTOR * course['cpu'][name]),
                      self.options.megabytes)

    def compile(self, item, sources, files, tests=None):
        """Compiles and links a chapter, or its tests. What the student left as it is in the course
        is not compiled again."""
        course = self.course
        own, new, steps, seen = course.own(item), {}, [], list(course.shared)
        here = str(course.folder(item)) + '/'
        for number, unit in enumerate(course.units[item]):
            main = unit.object.endswith('/main.cpp.o')
            if main and tests:
                new[unit.object] = f'{number}.o'
                words = course.test_command(item, sources.parent / 'program')
                steps.append([words[0], f'-I{sources.parent}', *words[1:], '-o', f'{number}.o',
                              '-c', str(tests)])
                seen += [tests, course.tests / 'support']
            elif is_exercise(item) or any(files[name] != own.get(name) for name in unit.read):
                new[unit.object] = f'{number}.o'
                source = unit.source.replace(here, f'{sources}/')
                if source == unit.source:  # made by CMake: it names the chapter's header
                    source = sources / Path(unit.source).name
                    source.write_text(Path(unit.source).read_text().replace(here, f'{sources}/'))
                steps.append(unit.command + ['-o', f'{number}.o', '-c', str(source)])
        link = [new.get(word, word) for word in course.link(item)]
        seen += [word for word in link if word.endswith(('.o', '.a')) and word.startswith('/')
                 and Path(word) not in seen]
        if tests:
            shared = self.test_objects(item)
            shared = shared + [Path(unit.object) for name in course.compared_with(item)
                               for unit in course.units[name]
                               if not unit.object.endswith('/main.cpp.o')]
            archives = [str(path) for path in course.shared if path.suffix == '.a']
            # packages
            archives += [word for word in link if word.startswith('/') and word.endswith('.a')
                         and word not in archives]
            link += [*map(str, shared), '-Wl,--start-group', *archives, '-Wl,--end-group']
            seen += shared
        steps.append(link + ['-o', 'program'])
        return self.boxes.run(['sh', '-c', ' && '.join(map(shlex.join, steps))],
                              [*seen, sources, *course.neighbors(item)],
                              Limits(COMPILE_SECONDS * len(steps), 6144, 1024), 'program')

    def test_objects(self, item):
        """The objects that all suites share, compiled once."""
        def compile_them():
            made = []
            support = sorted((self.course.tests / 'support').glob('*.cpp'))
            for source in [self.course.tests / 'doctest_main.cpp',
                           *(path for path in support if not path.name.startswith('test_'))]:
                made.append(self.course.work / f'{source.stem}.o')
                log = subprocess.run([*self.course.test_command(item, ''), '-o', made[-1], '-c',
                                      source], capture_output=True, check=False)
                if log.returncode:
                    raise GradeError(f'{source} cannot be compiled: '
                                     f'{first_error(log.stderr.decode())}')
            return made
        return self.once('test_objects', compile_them)

    def judge(self, item, files, place, course):
        """Builds, draws, draws the hidden picture, tests. `course` is the verdict on the course's
        own lesson, None for that one. What others may be reading there is replaced at once."""
        place.mkdir(exist_ok=True)
        with tempfile.TemporaryDirectory(dir=self.course.work) as private:
            sources = Path(private) / self.course.folder(item).relative_to(self.course.chapters)
            sources.mkdir(parents=True)
            for name, text in files.items():
                (sources / name).parent.mkdir(parents=True, exist_ok=True)
                (sources / name).write_bytes(text)

            def clean(text):
                return text.replace(f'{private}/', 'chapters/').replace(f'{self.course.tree}/', '')
            built = self.compile(item, sources, files)
            result = {'build': 'ok', 'run': '', 'note': '', 'cpu': {'build': built.cpu}}
            if built.how != 'ok' or not built.product:
                reason = first_error(built.log) if built.how.startswith(
                    'failed') else f'the compiler: {built.how}, {built.why}'
                result |= {'build': 'does not build', 'note': clean(reason)}
            else:
                program = Path(private) / 'program'
                program.write_bytes(built.product)
                program.chmod(0o755)
                if is_exercise(item):
                    self.check(item, program, course, result)
                    suspect = sorted({word.decode() for text in files.values()
                                      for word in re.findall(SUSPECT.encode(), text)})
                    if not result['note'] and course and suspect:
                        result['note'] = (f'read this file: it has {", ".join(suspect)}, '
                                          'which no exercise needs')
                else:
                    self.run(item, program, place, course, result)
                    if not self.options.no_tests:
                        self.test(item, sources, files, course, result)
                result['note'] = clean(result['note'])
        replace(place / 'verdict.json', json.dumps(result).encode())
        return result

    def run(self, item, program, place, course, result):
        """Draws the chapter's picture and the hidden one."""
        tree = self.course.tree
        always = ['--threads', '1', '--quiet', '--out', 'picture.png']
        # it measures times; the picture is the same
        usual = ['--seconds', '1', '--rounds', '1'] if item.startswith('13') else []
        rng = random.Random(f'{self.seed} {item}')
        texture = program.parent / f'{rng.getrandbits(64):x}.png'
        random_texture(texture, rng)
        pictures = [('picture', usual)]
        if not self.options.no_second_picture:
            offered = course['offered'] if course else self.boxes.run(
                [str(program), '--help'], [program], self.limits(None, '')).log
            result['offered'] = offered
            pictures.append(('hidden_picture', hidden_options(item, offered, texture.name, rng)))
        for name, options in pictures:
            if result['run'] not in ('', 'ok'):
                break
            limits = self.limits(course, name)
            options = [str(texture) if word == texture.name else word for word in options]
            ended = self.boxes.run([str(program), *always, *options],
                                   [program, texture, tree / 'assets'], limits, 'picture.png')
            how, why = ended.how, ended.why
            if how == 'ok' and not ended.product:
                why = 'it left no picture'
            elif how.startswith('failed') and ended.log.strip():
                why = ended.log.strip().splitlines()[0][:200]
            if how in ('ok', 'left processes') and ended.product:
                replace(place / f'{name}.png', ended.product)
                result[name] = str(place / f'{name}.png')
            result['cpu'][name] = ended.cpu
            if name == 'picture':
                limit = self.limits(course or result, name).cpu
                result |= {'run': how, 'cpu_seconds': f'{ended.cpu:.2f}',
                           'limit_cpu_seconds': f'{limit:.1f}', 'note': why}
            elif why:
                result['note'] += ('; ' if result['note'] else '') + (
                    f'the picture of another size and texture: {how}, {why}')
        result['hidden_expected'] = (course or result).get('hidden_picture', '')

    def check(self, item, program, course, result):
        """Tries an exercise's function. Its program writes values and a picture; another one,
        without the student's code, judges them."""
        assets = self.course.tree / 'assets'
        ended = self.boxes.run([str(program), '--values', 'values'], [program, assets],
                               self.limits(course, 'verdict'), 'values')
        result['cpu']['verdict'] = ended.cpu
        how, why, right = ended.how, ended.why, False
        if how != 'ok':
            why = first_error(ended.log) if how.startswith('failed') and ended.log.strip() else why
        elif not ended.product:
            why = 'no verdict: the program ended before the function was tried'
        else:
            values, judge = program.with_name(
                'values'), self.course.build / 'bin' / f'check_{item[:2]}'
            values.write_bytes(ended.product)
            words = [str(judge), '--exercise', item, '--judge', str(values), '--report', 'report']
            judged = self.boxes.run(words, [judge, values, assets], self.limits(None, ''), 'report')
            verdict, _, why = judged.product.decode('utf-8', 'replace').partition('\n')
            right = verdict == 'right'
            if verdict not in ('right', 'not yet'):
                why = f'no verdict: what the program left are not its values ({judged.log.strip()})'
        limit = self.limits(course or result, 'verdict').cpu
        result |= {'run': how, 'cpu_seconds': f'{ended.cpu:.2f}',
                   'limit_cpu_seconds': f'{limit:.1f}',
                   'tests_run': '1', 'tests_passed': '1' if right else '0',
                   'note': '' if right else why.strip()[:300]}

    def test(self, item, sources, files, course, result):
        """Runs the chapter's short suite with the student's lesson in it."""
        tests = self.course.suite(item)
        if not tests or course and 'tests_run' not in course:
            return
        built = self.compile(item, sources, files, tests)
        ended = built
        if built.product:
            program = sources.parent / 'test'
            program.write_bytes(built.product)
            program.chmod(0o755)
            seen = [program, sources.parent / 'program', self.course.tree / 'assets',
                    self.course.build / 'bin' / '00_one_file']
            words = [str(program), '--test-case-exclude=' + (course['left_out'] if course else '')]
            ended = self.boxes.run(words, [path for path in seen if path.exists()],
                                   self.limits(course, 'tests'))
        result['cpu'] |= {'build tests': built.cpu, 'tests': ended.cpu}
        counts = re.search(r'test cases: +(\d+) \| +(\d+) passed',
                           ended.log) if built.product else None
        if not course and not counts:
            print(f"the course's own tests of {item} do not run, and nobody's are counted: "
                  f"{first_error(ended.log)}", file=sys.stderr)
        if not course:  # what fails here is no student's fault
            names = {block.partition('\n')[0].strip().replace(',', '?')
                     for block in failures(ended.log)}
            result['left_out'] = ','.join(sorted(names))
        run = int(course['tests_run']) if course else int(counts[2]) if counts else 0
        passed = min(int(counts[2]), run) if counts else 0
        result |= {'tests_passed': str(passed), 'tests_run': str(run)} if run else {}
        if passed < run:
            if not built.product:
                why = 'the tests do not build with this lesson: ' + first_error(built.log)
            else:
                ending = (f'{ended.how}, {ended.why}' if ended.how != 'ok'
                          else 'their program ended before all were run')
                why = 'tests: ' + (first_failure(ended.log) or ending)
            result['note'] += ('; ' if result['note'] else '') + why

    def result(self, item, folder):
        """What became of a student's chapter or exercise."""
        result = self.verdict(item, folder)
        files = exercises_in(folder, item, next(iter(self.course.own(item)))) if is_exercise(
            item) else []
        if files[1:]:
            shown = [str((at / name).relative_to(folder)) for at, name, _ in files[:2]]
            result['note'] += '; ' * bool(result['note']) + ' is graded, and not '.join(shown)
        for picture in (self.course.tree / 'tests' / 'golden' / f'{item}.png',
                        result.get('hidden_expected')):
            if picture:
                self.expected(Path(picture))
        return dict(result, containment=self.boxes.kind)


def choose_boxes(options, work, stopping):
    """The box in which students' code runs; without one, only students who are trusted are run."""
    boxes = Boxes(options.containment, work, stopping)
    why = 'it contains nothing' if boxes.kind == 'none' else boxes.why_not()
    if not why:
        return boxes
    if not options.trust_students:
        remedy = ('let users make namespaces (unshare --user)'
                  if shutil.which('bwrap', path=ENVIRONMENT['PATH']) else
                  'install bubblewrap')
        raise GradeError(f'students\' code cannot be contained here\n  {boxes.kind}: {why}\n'
                         f'{remedy}; in a container or a virtual machine '
                         'that holds nothing else,\n--trust-students runs it NOT CONTAINED')
    print('NOT CONTAINED: students\' programs can read and change all that you can',
          file=sys.stderr, flush=True)
    return Boxes('none', work, stopping)


def results_of(options, tasks, stopping):
    """Builds and runs each (key, item, folder) of the tasks: yields the key and what became of it,
    in the order in which they end."""
    work = options.work.resolve()
    course = Course(options.tree, work, stopping)
    boxes = choose_boxes(options, work, stopping)
    graded = sorted({item for _, item, _ in tasks if course.has(item)})
    grader = Grader(options, course, boxes, course.make(graded))
    for item in graded:
        grader.expected(course.tree / 'tests' / 'golden' / f'{item}.png')
    with concurrent.futures.ThreadPoolExecutor(options.jobs
                                               or len(os.sched_getaffinity(0))) as pool:
        under_way = {pool.submit(grader.result, item, folder): key for key, item, folder in tasks}
        try:
            for ended in concurrent.futures.as_completed(under_way):
                yield under_way[ended], ended.result()
        except BaseException:
            stopping.set()
            pool.shutdown(cancel_futures=True)
            raise
