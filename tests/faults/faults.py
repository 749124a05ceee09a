#!/usr/bin/env python3
"""Tries every fault that a chapter's program must survive, on the programs themselves, outside of
the tree.

usage: faults.py BIN CORPUS [PART...]   the programs; the textures, good and bad

With TEXMAP_SANITIZED=1 the programs were built with sanitizers: no limits on memory, more time.
Prints a line for each failed and each skipped check. Status 0: at least 100 checks ran and all
passed; 1: not so.
"""
import fnmatch
import functools
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SANITIZED = os.environ.get('TEXMAP_SANITIZED') == '1'
PATIENCE = 60 if SANITIZED else 5  # seconds for what should take one
MOST_MEMORY = 512 << 20
NOBODY = 65534
NAMES = {1: '01_plain_spheres', 2: '02_checkerboard_uv', 3: '03_image_texture',
         4: '04_uv_conventions', 5: '05_y_rotation',
         6: '06_phong_texture_blend', 8: '08_triangle_uv', 12: '12_environment_map'}
CHAPTERS = (1, 2, 3, 4, 5, 6)
SMALL = ['--width', '8', '--height', '6']
REFERENCE = ['--width', '60', '--height', '40']
FULL_SIZE = ['--width', '320', '--height', '240']
LONG_NAME = '0' * 300 + '.png'

# A sanitizer's report must never look like a clean refusal.
os.environ.update(LC_ALL='C', ASAN_OPTIONS='exitcode=99', TSAN_OPTIONS='exitcode=99',
                  UBSAN_OPTIONS='exitcode=99:halt_on_error=1:print_stacktrace=1')
for variable in ('TEXMAP_ASSETS', 'LANGUAGE'):
    os.environ.pop(variable, None)

# --- Wrong command lines: chapters, what is typed, and what the message has behind the option.
# Which texts are no numbers at all,
# --- and what the messages say to the letter, is for test_command_line.

RANGE = '*from [-0-9]*to [-0-9]*'
WORDS = [
    *[(CHAPTERS, typed, '*') for typed in (
        ['--nonsense'], ['--nonsense=3'], ['stray'], ['--out', ''], ['--number', 'single'],
        ['--samples'], ['--height', '16384', '--width', '16384'])],
    ((3, 4, 5, 6), ['--texture', ''], '*'), ((4, 5, 6), ['--convention', 'upside-down'], '*'),
    ((6,), ['--scene', 'moon'], '*'),
    # A chapter takes the options that it has a use for, and no others.
    ((1, 2), ['--texture', 'x.png'], '*'), ((1, 2, 3), ['--convention', 'daily'], '*'),
    ((1, 2, 3), ['--rounding', 'floor'], '*'), ((1, 2, 3, 5, 6), ['--uv-scale', '2x1'], '*'),
    ((4, 8), ['--uv-scale', '2'], '*two numbers such as 1x1*'),
    ((4, 8), ['--uv-offset', '0.25x0'], '*two numbers such as 0,0*'),
    ((4, 8), ['--wrap', 'mirrored'], '*repeat|mirror|clamp*'),
    ((1, 2, 3, 4), ['--degrees', '1'], '*'), ((1, 2, 3, 4, 5), ['--blend', '0.5'], '*'),
    ((1, 2, 3, 4, 5), ['--shininess', '5'], '*'), ((1, 2, 3, 4, 5), ['--scene', 'stage'], '*'),
]
NUMBERS = [(chapters, [option, value], RANGE) for chapters, option, values in [
    (CHAPTERS, '--samples', ['0', 'nan', '']), (CHAPTERS, '--width', ['0', '16385', '2147483648']),
    (CHAPTERS, '--height', ['0', '16385', '2147483648']), (CHAPTERS, '--threads', ['-1', '1025']),
    ((5, 6), '--degrees', ['inf', '90x', '1,5']), ((6,), '--blend', ['-1e-9', '1.0000001', 'nan']),
    ((6,), '--shininess', ['-1', '1e31']), ((4, 8), '--uv-turn', ['inf', '30deg']),
    ((4,), '--uv-offset', ['0,1001', 'nan,0', ',']), ((5,), '--turntable', ['-1', '10000'])]
           for value in values]

# --- Files that are read: the chapter, the option, the noun in messages, the ending, a good file,
# and one that states too much ------

START = b'#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n'
TEXELS = bytes.fromhex('80402081 90482480 a050287f b0582c82')
CORNERS = b'v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n'
KINDS = {
    'textures': (3, '--texture', 'texture', 'png', None, b''),
    'skies': (12, '--sky', 'texture', 'hdr', START + b'-Y 2 +X 4\n' + 2 * TEXELS,
              START + b'-Y 4096 +X 4096\n' + TEXELS),
    # 132 fans have more than 2^21 triangles
    'meshes': (8, '--mesh', 'mesh', 'obj', CORNERS + b'f 1/1 2/2 3/3\n',
               CORNERS + 132 * (b'f' + 16000 * b' 1/1' + b'\n'))}
# the last is not UTF-8
ODD_NAMES = ['Erde-äöü', '地球', 'it\'s "quoted"', '-dash', '*', 'no-\udcc3(-\udcff']


class Tries:
    """All tries of a run, in a folder that is removed."""

    def __init__(self, bin_folder, corpus):
        self.bin, self.corpus = Path(bin_folder).resolve(), Path(corpus).resolve()
        self.passed = self.failed = self.skipped = 0
        self.problems = []
        self.T = Path(tempfile.mkdtemp(prefix='texmap-faults.'))
        self.T.chmod(0o755)  # another user has to find the way
        self.cwd = self.T / 'cwd'
        self.cwd.mkdir()
        self.texture = self.corpus / 'png_rgb8_33x31_allfilters.png'
        self.user = {}
        self.memory = 0 if SANITIZED else MOST_MEMORY

    def wrong(self, condition, problem):
        if condition:
            self.problems.append(problem)

    def conclude(self, check):
        """Counts the check under way."""
        if self.problems:
            self.failed += 1
            print(f'FAILED {check}: ' + '; '.join(self.problems)[:500])
        else:
            self.passed += 1
        self.problems = []

    def skip(self, check, why):
        self.skipped += 1
        print(f'skipped {check}: {why}')

    def program(self, chapter):
        return str(self.bin / NAMES[chapter])

    def needs(self, chapter):
        """What a chapter needs to draw one picture without the course's assets."""
        return [] if chapter < 3 else ['--texture', str(self.texture),
                                       *(['--convention', 'rtiow'] if chapter == 4 else [])]

    def run(self, command, memory=0, files=None, **options):
        """Sets status, out and err; `memory` and `files` limit what the program may use, in
        bytes."""
        def limit():
            if memory:
                resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
            if files:
                resource.setrlimit(resource.RLIMIT_FSIZE, (files, files))
        options = {'cwd': self.cwd, 'stdin': subprocess.DEVNULL, 'stdout': subprocess.PIPE,
                   'stderr': subprocess.PIPE, **options}
        self.out = self.err = ''
        try:
            done = subprocess.run([os.fsencode(str(word)) for word in command], timeout=PATIENCE,
                                  preexec_fn=limit, **options)
        except subprocess.TimeoutExpired:
            self.status = 'none in time'
            return
        self.status = done.returncode
        self.out, self.err = ((text or b'').decode(errors='replace')
                              for text in (done.stdout, done.stderr))

    def chapter(self, chapter, *words, **options):
        self.run([self.program(chapter), *self.needs(chapter), *words], **options)

    def expect(self, status, pattern='', lines=1, out=False):
        """The status, stderr as so many lines whose first is like the pattern, and stdout empty
        unless `out`; no file is left."""
        first, *more = self.err.splitlines() or ['']
        self.wrong(self.status != status, f'status {status} expected, got {self.status} ({first})')
        self.wrong(not fnmatch.fnmatchcase(first, pattern),
                   f"a message like '{pattern}' expected, got '{first}'")
        self.wrong(len(more) >= max(lines, 1),
                   f"{lines} lines on stderr expected, then came '{more[-1:]}'")
        self.wrong(not out and self.out != '', f"nothing on stdout expected, got '{self.out[:60]}'")
        found = os.listdir(self.cwd)
        self.wrong(found, f'nothing written expected, got {found}')
        for name in found:
            path = self.cwd / name
            shutil.rmtree(path) if path.is_dir() else path.unlink()

    def same(self, file, other, what='the picture is another one'):
        self.wrong(not (file.is_file() and other.is_file()) or
                   file.read_bytes() != other.read_bytes(), what)

    def only(self, folder, *names):
        """No temporary file is left."""
        found = sorted(os.listdir(folder))
        self.wrong(found != sorted(names), f'only {names} expected in its folder, got {found}')

    def keeps_old(self, folder, *others):
        self.same(folder / 'out.png', self.old, 'the old picture is not as it was')
        self.only(folder, 'out.png', *others)

    def is_whole(self, file):
        """It is a picture that chapter 03 loads."""
        command = [self.program(3), '--quiet', '--texture', file, '--width', '1', '--height', '1',
                   '--out', self.T / 'judge.png']
        return subprocess.run([str(word) for word in command], timeout=PATIENCE,
                              capture_output=True).returncode == 0

    def folder(self, name, *files):
        """A new folder with the old picture under these names."""
        (self.T / name).mkdir()
        for file in files:
            shutil.copy(self.old, self.T / name / file)
        return self.T / name

    def refuses(self, rows):
        for chapters, typed, said in rows:
            for chapter in chapters:
                self.chapter(chapter, *typed)
                self.expect(2, f'error: *{typed[0].split("=")[0]}{said}', lines=2)
                usage = (self.err.splitlines() + ['', ''])[1]
                self.wrong(not usage.startswith(f'usage: {NAMES[chapter]} '),
                           f"then the usage line expected, got '{usage}'")
                self.conclude(f'{NAMES[chapter]} {typed}')

    check_numbers = functools.partialmethod(refuses, NUMBERS)

    def check_words(self):
        self.refuses(WORDS)
        for chapter in CHAPTERS:
            for word in ('--help', '--version'):
                self.run([self.program(chapter), word])
                self.expect(0, out=True)
                self.wrong(NAMES[chapter] not in self.out, "the program's name expected on stdout")
                self.conclude(f'{NAMES[chapter]} {word}')

    def reads(self, kind, file, out='never.png', **options):
        chapter, option = KINDS[kind][:2]
        needs = {'meshes': ['--texture', self.texture], 'skies': ['--samples', '1']}.get(kind, [])
        self.run([self.program(chapter), *needs, option, file, *SMALL, '--out', out],
                 memory=self.memory, **options)

    def refuses_file(self, kind, file, what, said='?*', **options):
        self.reads(kind, file, **options)
        self.expect(1, f"error: cannot load {KINDS[kind][2]} '*': {said}")
        self.conclude(f'{kind}: {what}')

    def loads_file(self, kind, file, what, statuses=(0,)):
        out = self.T / 'loaded.png'
        self.reads(kind, file, out)
        self.wrong(self.status not in statuses,
                   f'status {statuses} expected, got {self.status} ({self.err})')
        self.wrong(self.status == 0 and not out.is_file(), 'a picture expected, got none')
        out.unlink(missing_ok=True)
        self.conclude(f'{kind}: {what}')

    def check_files(self, kind):
        """Files of a kind that are missing, or no files, or cut, or wrong inside."""
        chapter, _, _, ending, content, too_much = KINDS[kind]
        content = content or self.texture.read_bytes()
        if not Path(self.program(chapter)).exists():
            return self.skip(kind, 'there is no program that reads it')
        T = self.T / kind
        T.mkdir()
        good = T / f'good.{ending}'
        good.write_bytes(content)
        self.loads_file(kind, good, 'a good file')
        os.mkfifo(T / 'pipe')
        with open(T / 'sparse', 'wb') as file:
            file.truncate(10 << 30)
        for file, what in [
                (f'missing.{ending}', 'missing'), (self.T / 'loop-a', 'link loop'),
                (LONG_NAME, 'name of 300 characters'),
                (str(T) + '/' + 14 * LONG_NAME, 'path of 4200 characters'),
                (T / 'no-\udcc3(-\udcff.png', 'missing, its name is not UTF-8'),
                (T, 'a folder'), (f'{good}/', 'a file with a slash behind it'),
                (T / 'pipe', 'a pipe'), (T / 'sparse', '10 GiB of nothing'),
                *[(file, file) for file in ('/dev/urandom', '/dev/null', '/dev/tty',
                                            '/proc/cpuinfo', '/proc/self/mem')]]:
            self.refuses_file(kind, file, what)
        for name in ODD_NAMES:
            file = os.fsencode(f'{T}/{name}.{ending}')
            try:
                shutil.copy(good, file)
            except OSError:
                self.skip(f'{kind}: {name!r}', 'the disk takes no such name')
            else:
                self.loads_file(kind, os.fsdecode(file), f'{name!r}')
        # as long as may be, and nothing behind a good beginning
        with open(shutil.copy(good, T / 'tail'), 'r+b') as file:
            file.truncate(64 << 20)
        self.loads_file(kind, T / 'tail', '64 MiB, zeros behind a good file', statuses=(0, 1))
        if self.user is not None:
            secret = Path(shutil.copy(good, T / 'secret'))
            secret.chmod(0)
            # Where the picture goes is looked at first: /dev/null is anybody's.
            self.refuses_file(kind, secret, 'unreadable', '*no permission to read it',
                              out='/dev/null', **self.user)
        # Cut before its last line ends, it is no good file any more; and the picture that was there
        # stays.
        bad = T / f'bad.{ending}'
        size = len(content)
        for what, part in [('a file that states too much', too_much), *[
                (f'the first {length} bytes of a good file', content[:length])
                for length in (1, 8, 33, size // 2, size - 12, size - 2)]]:
            bad.write_bytes(part)
            self.refuses_file(kind, bad, what)
        kept = self.folder(f'kept-{kind}', 'out.png')
        self.reads(kind, bad, kept / 'out.png')
        self.wrong(self.status != 1, f'status 1 expected, got {self.status}')
        self.keeps_old(kept)
        self.conclude(f'{kind}: a bad file, and the old picture')

    def check_textures(self):
        self.check_files('textures')
        for chapter in (4, 5, 6):
            self.run([self.program(chapter), '--texture', 'missing.png', *SMALL, '--out',
                      'never.png'])
            self.expect(1, "error: cannot load texture '*': ?*")
            self.conclude(f'{NAMES[chapter]} missing.png')

    check_skies = functools.partialmethod(check_files, 'skies')
    check_meshes = functools.partialmethod(check_files, 'meshes')

    def cannot_write(self, file, what, chapters=(1,), keeps=None, others=(), size=SMALL, said='?*',
                     **options):
        """Each of the chapters gives up with status 1 and a line about it; `keeps`: a folder with
        the old picture and `others` alone."""
        for chapter in chapters:
            self.chapter(chapter, *size, '--out', file, **options)
            self.expect(1, f"error: cannot write '*': {said}")
            if keeps:
                self.keeps_old(keeps, *others)
            self.conclude(f'output, {NAMES[chapter]}: {what}')

    def check_output(self):
        T = self.T
        empty = self.folder('empty')
        (T / 'to-nowhere.png').symlink_to(T / 'no/such/file.png')
        for chapters, file, what in [
                (CHAPTERS, T / 'no/such/folder/out.png', 'folder missing'),
                (CHAPTERS, self.texture / 'out.png', 'the folder is a file'),
                (CHAPTERS, empty, 'it is a folder'), ((1,), f'{empty}/', 'a slash at the end'),
                ((1,), f'{T}/new/', 'nothing there'), ((1,), f'{empty}/.', 'a folder with a dot'),
                ((1,), LONG_NAME, 'name of 300 characters'), ((1,), T / 'loop-a', 'link loop'),
                ((1,), T / 'to-nowhere.png', 'link into a folder that does not exist')]:
            self.cannot_write(file, what, chapters)
        self.only(empty)

        # A picture that fails to be written in the end, not in the beginning.
        small = self.folder('small', 'out.png')
        self.cannot_write(small / 'out.png', 'no file may grow so large', keeps=small,
                          size=FULL_SIZE, files=512,
                          said='the file would be larger than the system allows')
        disk = self.folder('disk')
        if subprocess.run(['mount', '-t', 'tmpfs', '-o', 'size=16k', 'none', disk],
                          capture_output=True).returncode == 0:
            try:
                shutil.copy(self.old, disk / 'out.png')
                (disk / 'fill').write_bytes(bytes((16 << 10) - 2 * 4096))
                for name in ('out.png', 'new.png'):
                    self.cannot_write(disk / name, f'disk full, {name}', keeps=disk,
                                      others=['fill'], size=FULL_SIZE)
            finally:
                subprocess.run(['umount', disk], check=True)
        else:
            self.skip('output: disk full', 'a small disk cannot be mounted')
        read_only, folder = self.folder('read-only', 'out.png'), self.folder('writable', 'out.png')
        (folder / 'out.png').chmod(0o444)
        read_only.chmod(0o555)
        folder.chmod(0o777)
        if self.user is not None:
            for keeps, name in ((read_only, 'out.png'), (read_only, 'new.png'),
                                (folder, 'out.png')):
                self.cannot_write(keeps / name, f'read-only {keeps.name}/{name}', keeps=keeps,
                                  said='*no permission', **self.user)

        odd = T / 'it\'s a "folder" $HOME * äöü'
        (odd / 'far').mkdir(parents=True)
        shutil.copy(self.old, odd / 'far/target.png')
        (odd / 'link.png').symlink_to('far/target.png')
        (odd / 'fresh.png').symlink_to('far/fresh.png')
        for file in (odd / 'link.png', odd / 'fresh.png', odd / '日本 -.png'):
            self.chapter(1, *REFERENCE, '--out', file)
            self.expect(0, out=True)
            line = f'{file}: 60 x 40 pixels'
            self.wrong(not self.out.startswith(line) or self.out.count('\n') != 1,
                       f"a line '{line}' expected, got '{self.out}'")
            self.same(file, self.reference[1])
            self.wrong(file.is_symlink() != (file.name != '日本 -.png'), 'the link is gone')
            self.conclude(f'output: {file.name}')
        self.chapter(1, '--quiet', *REFERENCE, '--out', T / 'quiet.png', umask=0o027)
        self.expect(0)
        self.wrong((T / 'quiet.png').stat().st_mode & 0o777 != 0o640,
                   'another mode than the umask leaves')
        self.conclude('output: --quiet, umask 027')
        shutil.copy(self.texture, T / 'both.png')  # a picture may be written over its own texture
        self.run([self.program(3), '--texture', T / 'both.png', *REFERENCE, '--out',
                  T / 'both.png'])
        self.same(T / 'both.png', self.reference[3])
        self.conclude('output: over the texture')
        # Of several pictures, one that cannot be written is found before the first is drawn.
        (T / 'turn/t_002.png').mkdir(parents=True)
        self.cannot_write(T / 'turn/t.png', 'the last of three pictures', (5,),
                          size=[*SMALL, '--turntable', '3'])
        self.only(T / 'turn', 't_002.png')
        # The default place, made if missing.
        home = self.folder('home')
        for chapter in CHAPTERS:
            self.chapter(chapter, *REFERENCE, cwd=home)
            self.same(home / f'out/{NAMES[chapter]}.png', self.reference[chapter])
            self.only(home / 'out', f'{NAMES[chapter]}.png')
            shutil.rmtree(home / 'out')
            (home / 'out').write_text('')
            self.chapter(chapter, *REFERENCE, cwd=home)
            self.expect(1, f"error: cannot write 'out/{NAMES[chapter]}.png': ?*")
            (home / 'out').unlink()
            self.conclude(f'output: the default place of {NAMES[chapter]}')

    def check_signals(self):
        folder, new = self.folder('signals'), self.T / 'new.png'
        self.chapter(1, *FULL_SIZE, '--out', new)
        for sent in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGKILL):
            for moment in (0.02, 0.15, 0.4):  # a picture that takes minutes cannot be there
                self.wrong(self.killed(sent, moment, folder, [*FULL_SIZE, '--samples', '65536'],
                                       new), 'it is there')
            self.conclude(f'{sent.name} ends a long render')
            dice = random.Random(sent)
            finished = [self.killed(sent, moment, folder, FULL_SIZE, new)
                        for moment in [0.001 * k for k in range(1, 61, 3)]
                        + [0.06 * dice.random() for _ in range(12)]]
            self.conclude(f'{sent.name}, a small picture ({sum(finished)} of {len(finished)} were '
                          'finished)')
        self.wrong(not self.is_whole(folder / 'out.png'), 'the last picture is not whole')
        self.conclude('the picture after all signals')

    def killed(self, sent, moment, folder, words, new):
        """Sends the signal after so many seconds: out.png is the old picture or the new one, alone
        but for a draft. True: the new one."""
        picture = folder / 'out.png'
        shutil.copy(self.old, picture)
        drawing = subprocess.Popen([self.program(1), *words, '--out', str(picture)],
                                   stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        time.sleep(moment)
        drawing.send_signal(sent)
        said = drawing.communicate(timeout=PATIENCE)[1]
        self.wrong(drawing.returncode not in (0, -sent),
                   f'status {drawing.returncode} after {moment} s')
        # A sanitizer's search for leaks may be at work when the program is killed.
        said = re.sub(rb'==\d+==Unable to get registers from thread \d+\.\n', b'', said)
        self.wrong(said, f"nothing on stderr expected, got '{said[:60]}'")
        is_new = picture.is_file() and picture.read_bytes() == new.read_bytes()
        if not is_new:
            self.same(picture, self.old, 'neither the old picture nor the new one is there')
        for left in folder.glob('.texmap-*'):  # a draft may stay
            left.unlink()
        self.only(folder, 'out.png')
        return is_new

    def check_streams(self):
        picture, missing = self.T / 'stream.png', str(self.T / 'no/x.png')
        draws = [self.program(1), *REFERENCE, '--out', str(picture)]
        gone, end = os.pipe()
        os.close(gone)  # a pipe with a reader that has gone for certain
        with open('/dev/full', 'wb') as full, open(end, 'wb', buffering=0) as broken:
            # Messages must not end up in a texture or a picture that took a stream's number.
            for command, closed, stdout, status in [
                    (draws, [1], None, 0), (draws, [0, 1, 2], None, 0), (draws, [0, 2], None, 0),
                    (draws, [], full, 0),
                    (draws, [], broken, 0), ([self.program(6), '--help'], [], full, 1),
                    ([self.program(6), '--version'], [], full, 1),
                    ([self.program(1), '--samples', 'nan'], [2], None, 2),
                    ([self.program(1), '--out', missing], [1, 2], None, 1),
                    ([self.program(3), '--texture', str(self.corpus / 'bad_one_byte.png'), '--out',
                      str(picture)], [0, 1, 2], None, 1)]:
                words = ''.join(f' {number}>&-' for number in closed)
                self.run(['sh', '-c', f'exec "$@"{words}', 'sh', *command],
                         **({'stdout': stdout} if stdout else {}))
                said = 'error: ?*' if status else 'the picture is written, but not the line ?*'
                self.expect(status, said if stdout else '', out=True)
                if command == draws:
                    self.same(picture, self.reference[1])
                self.wrong(picture.exists() != (command == draws), 'a picture was written')
                picture.unlink(missing_ok=True)
                self.conclude(f'{command[1:]}, closed: {closed}, stdout: {stdout and stdout.name}')

    def check_memory(self):
        if not self.memory:
            return self.skip('memory', 'it cannot be limited here')
        folder = self.folder('starved')
        picture, fed = folder / 'out.png', self.T / 'fed.png'

        def starved(limit, command):
            """Whole picture or a line about memory. True: the picture."""
            shutil.copy(self.old, picture)
            self.run([*command, '--out', picture], memory=limit << 10)
            if self.status == 0:
                self.same(picture, fed, f'at {limit} KiB: status 0, and another picture')
            else:
                self.expect(1, 'error: *memory*')
                self.same(picture, self.old, f'at {limit} KiB: the old picture is not as it was')
            self.only(folder, 'out.png')
            return self.status == 0
        for chapter in (1, 6):
            command = [self.program(chapter), *self.needs(chapter), '--width', '400',
                       '--height', '300']
            # the least that the program is loaded with: below, the system says 127
            low, start = 0, 131072
            while start - low > 4:
                middle = (low + start) // 2
                self.run([self.program(chapter), '--help'], memory=middle << 10)
                is_loaded = self.status not in (127, -signal.SIGSEGV, -signal.SIGABRT)
                low, start = (low, middle) if is_loaded else (middle, start)
            self.run([*command, '--out', fed])
            for threads, more in [('1', [*range(12, 480, 24), *range(500, 1700, 100), 2000, 2600,
                                         4000, 8000]),
                                  ('64', [1000, 4000, 9500, 17500, 26000, 40000, 80000, 150000])]:
                enough = [starved(start + extra, [*command, '--threads', threads])
                          for extra in more]
                self.wrong(len(set(enough)) != 2, 'memory was always or never short')
                self.conclude(f'{NAMES[chapter]}: short of memory, {threads} threads '
                              f'({sum(enough)} of {len(enough)} times enough)')
        huge = [self.program(1), '--width', '8192', '--height', '8192', '--threads', '1']
        self.wrong(starved(150000, huge), 'memory was enough')
        self.conclude('a picture of 2^26 pixels in 150 MB')

    def check_surroundings(self):
        there = self.T / 'there.png'
        environments = {'no TERM, C locale': {'TERM': None, 'LANG': None},
                        'TERM is nonsense': {'TERM': 'nonsense', 'COLUMNS': '0'},
                        'a locale that does not exist': {'LC_ALL': 'xx_YY.UTF-8'}}
        locales = self.folder('locales')  # one that writes 0,5 is made for this
        if shutil.which('localedef') and subprocess.run(
                ['localedef', '-i', 'de_DE', '-f', 'UTF-8', locales / 'de_DE.UTF-8'],
                capture_output=True).returncode == 0:
            environments['a decimal comma'] = {'LOCPATH': str(locales), 'LC_ALL': 'de_DE.UTF-8'}
        else:
            self.skip('a locale with a decimal comma', 'none is installed')
        if not SANITIZED:
            environments['no environment'] = dict.fromkeys(os.environ)
        tries = [(f'--threads {n}', ['--threads', str(n)], {}) for n in (1, 2, 16, 1024)]
        for what, changes in environments.items():  # None removes a variable
            changed = {name: value for name, value in {**os.environ, **changes}.items()
                       if value is not None}
            tries.append((what, [], {'env': changed}))
        tries.append(('no terminal', [], {'start_new_session': True}))
        for chapter in CHAPTERS:
            # with a point, wherever a comma is usual
            numbers = ['--blend', '0.25', '--degrees', '12.5'] if chapter == 6 else []
            expected = self.T / f'expected-{chapter}.png'
            self.chapter(chapter, *REFERENCE, *numbers, '--out', expected)
            self.expect(0, out=True)
            self.conclude(f'{NAMES[chapter]}: as usual')
            for what, words, options in tries:
                there.unlink(missing_ok=True)
                self.chapter(chapter, *REFERENCE, *numbers, *words, '--out', there, **options)
                self.expect(0, out=True)
                self.same(there, expected)
                self.conclude(f'{NAMES[chapter]}: {what}')

    def get_ready(self):
        for chapter in CHAPTERS:
            if not Path(self.program(chapter)).exists():
                sys.exit(f'faults.py: there is no program {self.program(chapter)}')
        (self.T / 'loop-a').symlink_to(self.T / 'loop-b')
        (self.T / 'loop-b').symlink_to(self.T / 'loop-a')
        if os.getuid() == 0:  # somebody whom permissions bind
            self.user = {'user': NOBODY, 'group': NOBODY, 'extra_groups': []}
            self.run([self.program(1), '--version'], **self.user)
            if self.status != 0:
                self.user = None
                self.skip('permissions',
                          'root may do everything, and no other user can run the programs')
        self.reference = {chapter: self.T / f'reference-{chapter}.png' for chapter in CHAPTERS}
        for chapter, file in self.reference.items():
            self.chapter(chapter, *REFERENCE, '--out', file)
            self.expect(0, out=True)
            self.wrong(not self.is_whole(file), 'it is not whole')
            self.conclude(f'{NAMES[chapter]} draws a picture')
        self.old = self.T / 'old.png'
        self.chapter(2, '--width', '40', '--height', '30', '--out', self.old)
        half = self.T / 'half.png'
        half.write_bytes(self.old.read_bytes()[:200])
        self.wrong(self.is_whole(half), 'half a picture counts as whole')
        self.conclude('chapter 03 refuses half a picture')

    def all(self, parts):
        self.get_ready()
        for part in parts or PARTS:
            getattr(self, 'check_' + part)()
            self.only(self.cwd)
            self.conclude(f'{part}: nothing in the current folder')
        print(f'{self.passed} passed, {self.failed} failed, {self.skipped} skipped')
        if self.passed + self.failed < 100:
            print('fewer than 100 checks ran: something is missing')
        return 0 if self.failed == 0 and self.passed >= 100 else 1


PARTS = ('numbers', 'words', 'textures', 'skies', 'meshes', 'output', 'signals', 'streams',
         'memory', 'surroundings')


def main():
    if len(sys.argv) < 3 or not all(os.path.isdir(folder) for folder in sys.argv[1:3]) or not set(
        sys.argv[3:]) <= set(PARTS):
        sys.exit(__doc__)
    tries = Tries(*sys.argv[1:3])
    try:
        return tries.all(sys.argv[3:])
    finally:
        subprocess.run(['chmod', '-R', 'u+rwx', tries.T], check=False)
        shutil.rmtree(tries.T, ignore_errors=True)


if __name__ == '__main__':
    sys.exit(main())
