"""What students handed in: whose it is, and where their chapters or pictures lie in it.

A tree of files becomes students by a table of rules: a learning system, a drive or a form writes
into a file's name, or a folder's, whose it is. Else a folder in the folder that was named is a
student's, unless work lies in that folder itself. A student's folder is searched three levels deep,
as students pack the same work in many ways: ada/03.png, ada/out/03_image.png,
ada/texmap-main/chapters. Archives are read as folders. Links below the folders that were named are
not followed."""
import atexit
import bz2
import collections
import contextlib
import dataclasses
import functools
import gzip
import lzma
import os
import re
import shutil
import subprocess
import tarfile
import tempfile
import time
import zipfile
import zlib
from pathlib import Path

from results import clean, counted, nfc, shown_name

# bytes and entries: of an archive, unpacked, with those in it; archives: in each other
MOST_LEVELS, MOST_ENTRIES, MOST_BYTES, MOST_ARCHIVES = 3, 20000, 1 << 28, 3
# Folders in which no student's pictures lie, but perhaps other ones of the same names.
PASSED_OVER = ('__macosx', 'assets', 'build', 'cmake-build-debug', 'common', 'docs', 'node_modules',
               'tests', 'working files', 'feedback attachment(s)')
# The one folder that a site, or a student, packs all in.
PACKING = re.compile(
    'bilder|homework|hw|images|pictures|png|screenshots|.*-(main|master)|.*(texmap|texture).*')
# A folder for each time that a student handed in; what is in the newest counts.
VERSION = re.compile(r'(?:version|versi[oó]n|versjon|attempt|versuch|abgabe|tentative|'
                     r'intento|forsøk|v|版本|提交)[ _-]*\d{1,4}|'
                     r'\d{4}-\d\d?-\d\d?(\D.*)?', re.I)
# Not so if it is one of several students': "2026-11-20 Jane Doe" of an e-mail.
DATE_AND_NAME = re.compile(r'[\d-]{8,}\W+(?:[^\W\d_]{2,}\W+[^\W\d_]{2}|[^\W\x00-\xff])')
# The sign of a file that is there again: "03 (2).png" of browsers and drives, "03_v2.png".
AGAIN = r'(?: ?\((\d{1,3})\)|[ _-]v(\d{1,3}))'
# What is in a name beside its student: CHAPTER stands for a chapter's own name, NUMBER for its
# number. Who, id and when are the student's name, number, and the time or number of a version.
# Canvas adds -1 to the name of a file that is handed in again.
SYSTEMS = {
    'Moodle': r'(?P<who>.+)_(?P<id>\d+)_assign(?P<part>[a-z]+_[a-z]+)_?(?P<rest>.*)',
    'Blackboard': r'(?P<who>.+)_attempt_(?P<when>\d{4}(?:-\d\d){5})(?:_(?P<rest>.+)|\.txt)',
    'Brightspace': r'(?P<id>\d+)-\d+ - (?P<who>.+?) - (?P<when>[^-]*\d{4}[^-]*?)'
                   r'(?: ?- (?P<rest>.+))?',
    'Canvas': r'(?:anon(?P<late>_LATE)?_(?P<who>[A-Za-z0-9]{5})_\d+|'
              r'(?!\d\d?_)(?P<who2>.+?)(?P<late2>_LATE)?_(?P<id>\d+)_(?:\d+|(?P<part>text\.html)))'
              r'(?(part)|_(?P<rest>.+?)(?:-(?P<when>\d+))?(?P<ending>\.\w+)?)',
    'Sakai': r'(?P<who>[^()]+, ?[^()]+)\((?P<id>[^()]+)\)'}
# The same where no system made the names: they count if several have a file of the same chapter.
OTHERS = {
    'a form': r'(?P<rest>(?:CHAPTER|NUMBER)(?:AGAIN)?)(?: - (?P<who>\D.*?)|'
              r'_(?P<who2>\D\S* .+?|[^\x00-\x7f]+?))(?P<ending>\.\w+)',
    'chapters': r'(?P<who>\S.*?)(?:(?<=[^\x00-\x7f])| ?- ?|[ _]+)(?P<rest>CHAPTER.*)',
    'a drive': r'(?P<who>\S.*?) - (?P<rest>.+)',
    'numbers': r'(?P<who>\S.*?)(?:(?<=[^\x00-\x7f])|-|[ _]+)'
               r'(?P<rest>NUMBER(?:AGAIN)?(?:\.\w+)?)'}
NOBODY = re.compile(r'(?:chapter|kapitel|ch|kap|screen ?shot|bildschirmfoto|picture|image|img|pic|'
                    r'bild|homework|hw|exercise|old|new|alt|neu|finale?|my|render|output|out|'
                    r'result|texture|globe|cop(y|ie|ia)|kopie?|副本)s?|\W*', re.I)
MONTHS = {month: number for number, months in enumerate(
    'jan ene|feb fév|mar mär|apr avr abr|may mai|jun juin|jul juil|aug aoû ago|sep|oct okt|nov|'
    'dec déc dez dic des'.split('|'), 1) for month in months.split()}
ARCHIVE = re.compile(r'\.(?:zip|tar|tgz|txz|tbz2?|tar\.(?:gz|bz2|xz)|7z|rar)$', re.I)
# Programs for archives that Python does not read: how they list names, and write out one file.
# PATH and NAME are no options, whatever a student calls them.
PROGRAMS = {'unrar': ('lb -p- -- PATH', 'p -inul -p- -@ -- PATH NAME')} | dict.fromkeys(
    ('7z', '7zz'), ('l -ba -slt -sccUTF-8 -p- -- PATH', 'x -so -spd -p- -- PATH NAME')) | {
        'bsdtar': ('-tf PATH', '-xOf PATH -- NAME')}


@dataclasses.dataclass
class Entry:
    """What lies in a folder. An archive counts as a folder."""
    name: str  # of an archive without its ending; of a system's file, as the student named it
    path: str
    is_folder: bool
    is_link: bool = False
    when: tuple = ()  # the number of a version, or its time; the largest counts


@dataclasses.dataclass(eq=False)
class Submission:
    """What one student handed in."""
    folder: str  # as the instructor named it
    name: str
    kind: str = 'folders'  # such as "Canvas's flat files"
    id: str = ''  # the learning system's
    person: str = ''
    note: str = ''
    parts: list = dataclasses.field(default_factory=list)  # the entries in it
    checkout: str = ''  # holds chapters/ or the chapters; empty for pictures
    # by the item's name: the file, and why it cannot be taken
    pictures: dict = dataclasses.field(default_factory=dict)
    seen: str = ''  # pictures and code that lie there, by name, where no checkout is
    why: str = ''  # no file of it fits a chapter of the course: the reason
    other_ids: tuple = ()
    versions: dict = dataclasses.field(default_factory=dict)  # notes, by the item's name


@functools.cache
def scratch():
    """A folder that is removed at the end."""
    place = tempfile.TemporaryDirectory(prefix='grade-')
    atexit.register(place.cleanup)
    return place


NAMED = set()  # folders with what was unpacked of archives that the instructor named
ROOM = {}  # by folder: bytes and entries that are left for archives in it, and how deep it is
WHY_NOT = {}  # by path: why an archive is not read, if there is a remedy


@contextlib.contextmanager
def output_of(program, words, path, name=''):
    command = [{'PATH': path, 'NAME': name}.get(word, word) for word in words.split()]
    with subprocess.Popen([program, *command], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL,
                          env=os.environ | {'LC_ALL': 'C.UTF-8'}) as process:
        try:
            yield process.stdout
        finally:
            process.kill()


def members_of_zip(path, _):
    with zipfile.ZipFile(path) as packed:
        for info in packed.infolist():
            name = info.filename
            if not info.flag_bits & 0x800:  # Apple's are in UTF-8, too, and Windows's in its own
                raw = name.encode('cp437')
                for code in ('utf-8', 'gb2312', 'cp850')[:1 if info.create_system else None]:
                    with contextlib.suppress(UnicodeError):
                        name = raw.decode(code)
                        break
                else:
                    name = raw.decode('utf-8', 'surrogateescape')
            if info.external_attr >> 28 != 0o12:  # a link
                yield name, time.mktime((*info.date_time, 0, 0, -1)), lambda: packed.open(info)


def members_of_tar(path, most):
    reader = next((reader for ending, reader in {'gz': gzip, 'xz': lzma, 'bz': bz2, 'bz2': bz2}
                   .items() if path.lower().endswith(ending)), None)
    with tempfile.TemporaryFile(dir=scratch().name) as plain:
        with reader.open(path) if reader else open(path, 'rb') as source:
            copied(source, plain, 2 * most)
        plain.seek(0)
        with tarfile.open(fileobj=plain, mode='r:') as packed:
            for info in packed:
                if info.isfile():
                    yield info.name, info.mtime, lambda: packed.extractfile(info)


def members_by_program(path, most):
    kind = path[-3:].lower().strip('.')
    fit = [name for name in PROGRAMS if (kind == 'rar' or name != 'unrar') and shutil.which(name)]
    if not fit:
        WHY_NOT[path] = (f'a .{kind} needs the program {"unrar, " * (kind == "rar")}7z, 7zz or '
                         'bsdtar (Debian: libarchive-tools); install one, or ask for a zip')
        raise ValueError
    for program in fit:
        to_list, to_read = PROGRAMS[program]
        with output_of(program, to_list, path) as listed:
            names = os.fsdecode(listed.read(most)).splitlines()
        names = [name.removeprefix('Path = ') for name in names
                 if '-slt' not in to_list or name.startswith('Path = ')]
        folders = {folder for name in names for folder in map(str, Path(name).parents)}
        for name in names:
            if os.path.normpath(name) in folders:
                continue
            asked = re.sub(r'([*?\[\]\\])', r'\\\1', name) if program == 'bsdtar' else name
            yield name, 0, lambda: output_of(program, to_read, path, asked)
        if names:
            return
    raise ValueError


def copied(source, made, left):
    """Copies a file; returns how many bytes are left."""
    while piece := source.read(1 << 16):
        left -= len(piece)
        if left < 0:
            raise ValueError('too large')
        made.write(piece)
    return left


def short_name(part):
    """The name of a file or folder, without its middle if a file system has no room for it."""
    name = os.fsencode(part)
    return part if len(name) <= 255 else (name[:200] + name[-50:]).decode(errors='ignore')


@functools.cache
def unpacked(path):
    """The folder with what is of use in an archive; of other files it has the names. None if it
    cannot be read. Nothing is written but plain files in that folder."""
    is_inside = path.startswith(scratch().name)
    outer = Path(path).relative_to(scratch().name).parts[0] if is_inside else ''
    room, depth = ROOM.get(outer, ([], 0))
    if depth >= MOST_ARCHIVES:
        return None
    folder = tempfile.mkdtemp(dir=scratch().name)
    if not outer or os.path.join(scratch().name, outer) in NAMED:
        room = [MOST_BYTES, MOST_ENTRIES]
    ROOM[os.path.basename(folder)] = room, depth + 1
    members = members_of_zip if path.lower().endswith('.zip') else (
        members_by_program if path.lower().endswith(('.7z', '.rar')) else members_of_tar)
    try:
        for name, when, source in members(path, MOST_BYTES):
            room[1] -= 1
            parts = [part for part in name.replace('\\', '/').split('/')
                     if part not in ('', '.', '..')]
            if room[1] < 0 or not parts or any(is_passed_over(part) and part != 'common'
                                               for part in parts):
                continue
            target = Path(folder, *map(short_name, parts[:20] + parts[20:][-1:]))
            # a file and a folder of the same name: the first of them is there
            with contextlib.suppress(FileExistsError, NotADirectoryError, IsADirectoryError):
                (target if name.endswith('/') else target.parent).mkdir(parents=True, exist_ok=True)
                if re.search(r'\.(png|jpe?g|[hc]pp|[hc]|in[cl]|txt|yml)$',
                             name.lower()) or ARCHIVE.search(name):
                    with source() as packed, open(target, 'wb') as made:
                        room[0] = copied(packed, made, room[0])
                    os.utime(target, (when, when))
                else:
                    target.touch()
    except (OSError, EOFError, OverflowError, RuntimeError, ValueError, tarfile.TarError,
            zipfile.BadZipFile, zlib.error, lzma.LZMAError):
        return None
    return folder


def entry_of(path, is_named=False):
    """The entry at a path. Of an archive that is not read it is the file."""
    name, is_link = os.path.basename(path), os.path.islink(path)
    is_folder = not is_link and os.path.isdir(path)
    if ARCHIVE.search(name) and not (is_link or is_folder):
        folder = unpacked(path)
        NAMED.update([folder] if folder and is_named else [])
        return Entry(ARCHIVE.sub('', name), folder, True) if folder else Entry(name, path, False)
    return Entry(name, path, is_folder, is_link)


def without_unpacked(paths):
    """Without archives that lie next to what was unpacked from them."""
    there = set(map(os.path.normpath, paths))
    return [path for path in paths if not (
        ARCHIVE.search(path) and os.path.normpath(ARCHIVE.sub('', path)) in there)]


def entries_of(folder):
    """The entries of a folder in the order of their names; none if it may not be read."""
    try:
        with os.scandir(folder) as found:
            paths = [entry.path for entry, _ in zip(found, range(MOST_ENTRIES))]
    except OSError:
        return []
    return [entry_of(path) for path in without_unpacked(sorted(paths, key=os.fsencode))]


def is_passed_over(name):
    return name.startswith('.') or name.lower() in PASSED_OVER


def is_code(name):
    return name.lower().endswith(('.hpp', '.cpp'))


def has_chapters(folder):
    return any(entry.is_folder and re.match('[0-9][0-9]_.', entry.name)
               for entry in entries_of(folder))


class Chapters:
    """The chapters and exercises of the course, and which of them are asked for."""

    def __init__(self, known, asked):
        self.known, self.asked = known, {item.name for item in asked}
        own = '|'.join(self.own_name(item) for item in known if not item.exercise) or '$.'
        fill = {'CHAPTER': f'(?:{own})', 'NUMBER': r'(?:0?\d|1\d)(?!\d)',
                'AGAIN': AGAIN.replace('(\\d', '(?:\\d')}
        self.others = {rule: re.sub('CHAPTER|NUMBER|AGAIN', lambda word: fill[word[0]], pattern)
                       for rule, pattern in OTHERS.items()}
        self.own = re.compile(f'(?<![0-9])(?:{own})', re.I)

    @staticmethod
    def own_name(item):
        """The chapter's own name as a pattern; blanks do for its bars."""
        return re.escape(item.name).replace('_', '[ _-]+')

    def is_chapter(self, folder):
        """Whether this is the folder of a chapter. The name alone does not say so: a student's
        folder, or one of pictures, can have it. So there must be code in it."""
        if not any(folder.name == item.name or f'/{folder.name}/' in item.exercise
                   for item in self.known):
            return False
        return any(is_code(entry.name) or entry.is_folder and entry.name == 'exercises'
                   for entry in entries_of(folder.path))

    def fits(self, stem, is_jpeg):
        """The chapters whose picture it may be, by its name, with how well it says so, and the
        number of this version."""
        again = re.fullmatch(f'(.+?){AGAIN}', stem, re.I)
        for name, version in ([(again[1], int(again[2] or again[3]))] if again else []) + [
                (stem, 0)]:
            fits = [(item, misfit(name, item)) for item in self.known if not item.exercise]
            own = self.own.search(name)
            if own:  # other numbers are those of people
                fits = [(item, 2 if fit is None else fit) for item, fit in fits
                        if re.fullmatch(self.own_name(item), own[0], re.I)]
            # a photo may have any number
            fits = [(item, fit + 4 * is_jpeg) for item, fit in fits
                    if fit is not None and not (is_jpeg and fit > 2)]
            if fits:
                return fits, version
        return [], 0


def misfit(stem, item):
    """How well a file's name says that it is an item's picture: 0 best, then 1, 2, 3; None if it
    does not say so."""
    name = stem.lower()
    if name == item.name.lower():
        return 0
    name = re.sub('^chapter[ _-]*|^kapitel[ _-]*', '', name)
    either = (item.number, item.number.removeprefix('0'))
    if name in either:
        return 1
    if re.match(item.number + r'(?![0-9]|\.[0-9])', name):
        return 2
    numbers = re.findall('[0-9]+', name)
    return 3 if len(numbers) == 1 and numbers[0] in either else None


class Search:
    """What entries hold, down to so many levels of folders below them."""

    def __init__(self, chapters, entries, levels, folder=''):
        self.chapters = chapters
        self.checkouts = []  # when, and the folder
        # by the item's name: misfit, level, when, number of the version, time, path, name and
        # whether it is a link
        self.candidates = {}
        self.entries = 0
        self.seen = []  # names of pictures that fit nothing of what is asked for
        self.others = []  # of other files
        self.known = False  # whether a picture fits any chapter
        self.code = ''  # the first file of code outside a chapter
        self.deeper = ''  # the first folder that is not read
        self.look_into(entries, folder, 0, levels)

    def look_into(self, entries, folder, level, levels, when=()):
        below, holds_chapters = [], False
        for entry in entries:
            self.entries += 1
            if self.entries > MOST_ENTRIES:
                return
            if entry.is_folder:
                if entry.name.lower() == 'chapters' and has_chapters(entry.path):
                    # Who builds it knows chapters/ in small letters, or takes the folder itself.
                    self.checkouts.append((entry.when or when, folder if entry.path == os.path.join(
                        folder, 'chapters') else entry.path))
                elif (entry.path == os.path.join(folder, entry.name)
                      and self.chapters.is_chapter(entry)):
                    holds_chapters = True
                elif not is_passed_over(entry.name):
                    below.append(entry)
                continue
            self.take_picture(entry, level, entry.when or when)
            if not self.code and is_code(entry.name):
                self.code = entry.name
        if holds_chapters and not self.checkouts:
            self.checkouts.append((when, folder))
        for part in below:
            version = VERSION.fullmatch(part.name) or re.search(f'{AGAIN}$', part.name, re.I)
            is_level = not version and part.path == os.path.join(folder, part.name)  # no archive
            if is_level and level == levels:
                self.deeper = self.deeper or part.name
            elif not self.checkouts or version or part.when or when:
                self.look_into(entries_of(part.path), part.path, level + is_level, levels,
                               (part.when or when) + (time_of(part.name) if version else ()))

    def take_picture(self, entry, level, when):
        stem, ending = os.path.splitext(entry.name)
        stamp = re.match(r'(20\d{12})_(?=.)', stem)  # ILIAS's: 20261120134507_03.png
        if stamp:
            stem, when = stem[stamp.end():], (*when, int(stamp[1]))
        is_jpeg = ending.lower() in ('.jpg', '.jpeg')
        if ending.lower() in ('.bmp', '.ppm', '.gz') or ARCHIVE.search(entry.name):
            why = f': {WHY_NOT[entry.path]}' if entry.path in WHY_NOT else ''
            is_archive = ARCHIVE.search(entry.name)
            self.seen.append(entry.name + (', which is not read' if is_archive else '') + why)
        elif ending.lower() != '.png' and not is_jpeg:
            self.others.append(entry.name)
        else:
            fits, version = self.chapters.fits(stem, is_jpeg)
            self.known = self.known or bool(fits)
            fits = [(item, fit) for item, fit in fits if item.name in self.chapters.asked]
            for item, fit in fits:
                self.candidates.setdefault(item.name, []).append(
                    (fit, level, when, version, os.lstat(entry.path).st_mtime, entry.path,
                     entry.name, entry.is_link))
            self.seen += [] if fits else [entry.name]

    @property
    def checkout(self):
        """The newest; of those of a time the first."""
        return max(self.checkouts, key=lambda one: one[0], default=((), ''))[1]

    def has_work(self):
        return bool(self.checkout or self.candidates or self.seen or self.code)

    def what_else(self):
        """What lies there under other names, at most four pictures."""
        words = ', '.join(clean(shown_name(name)) for name in self.seen[:4])
        if self.seen[4:]:
            words += f' and {counted(len(self.seen) - 4, "picture")} more'
        if self.code:
            words += ('; ' if words
                      else '') + f"{clean(shown_name(self.code))}, but not in a chapter's folder"
        return words

    def why_nothing(self):
        """Why no file fits a chapter, in words; empty if one does."""
        if self.checkouts or self.known:
            return ''
        if self.seen or self.code:
            return self.what_else() + (
                ': no name or number of a chapter, or several' if self.seen
                and not self.code and not ARCHIVE.search(self.seen[0].partition(',')[0]) else '')
        if self.deeper and not self.others:
            return f'{clean(shown_name(self.deeper))}: no folder as deep as this one is read'
        return ', '.join(clean(shown_name(name)) for name in self.others[:3]) + (
            ': no picture and no code' if self.others else '')

    def pictures(self):
        """Of the candidates the newest version; of it the one whose name fits best, then the one
        nearest to the top. Adds a note where there are several versions."""
        pictures, notes = {}, {}
        for item, candidates in self.candidates.items():
            def rank(one):
                fit, level, when, version, modified, *_ = one
                return (fit < 4, when, -fit, -level, version, modified)
            first = max(candidates, key=rank)
            fit, level, when, version, _, path, name, is_link = first
            same = [one for one in candidates if one[:3] == first[:3]]
            others = [one[6] for one in same
                      if one[3] == version and one[6].lower() != name.lower()]
            if is_link:
                pictures[item] = path, f'{name} is a link; links are not followed'
            elif others and fit % 4 >= 2:
                pictures[item] = (path, ' or '.join(sorted([name, others[0]]))
                                  + f'? Name the picture {item}.png')
            else:
                pictures[item] = path, ''
                count = len({one[2] for one in candidates}) + len({one[3:6] for one in same}) - 1
                above, shown = path.split(os.sep)[-2:]
                shown = f'{above}/{name}' if (when or not version) and shown == name else shown
                if count > 1:
                    notes[item] = f'the newest of {count}: {clean(shown_name(shown))}'
        return pictures, notes


def search(chapters, submission, path=''):
    """Finds the work in the parts of a submission."""
    found = Search(chapters, submission.parts, MOST_LEVELS, path)
    submission.checkout, submission.why = found.checkout, found.why_nothing()
    if not found.checkout:
        submission.pictures, submission.versions = found.pictures()
        submission.seen = found.what_else() or submission.seen
    elif len(found.checkouts) > 1:
        shown = clean(shown_name(os.path.basename(found.checkout)))
        submission.versions = {'': f'the newest of {len(found.checkouts)}: {shown}'}
    if found.entries > MOST_ENTRIES:
        submission.note = f'the folder has more than {MOST_ENTRIES} files; not all were looked at'
    return submission


def submission_of(chapters, entry, folder):
    """That of a student who has a folder, or something that should be one."""
    result = Submission(shown_name(folder), shown_name(entry.name), person=nfc(entry.name))
    if entry.is_link:
        result.why = 'the folder is a link; links are not followed'
    elif not entry.is_folder:
        result.name = ARCHIVE.sub('', result.name)
        result.person = nfc(result.name)
        result.why = ': '.join(filter(None, ('the archive cannot be read',
                                             WHY_NOT.get(entry.path))))
    else:
        try:
            os.scandir(entry.path).close()
            result.parts = entries_of(entry.path)
            return search(chapters, result, entry.path)
        except OSError as error:
            result.why = f'the folder cannot be read: {error.strerror}'
    result.note = result.why
    return result


def time_of(words):
    """A time, as numbers that can be compared: of "2026-11-20-13-45-07", "20 nov. 2026 13:45", or
    "Nov 20, 2026 145 PM"; of a version's number this number."""
    words, numbers = words.casefold(), tuple(map(int, re.findall(r'\d+', words)))
    month, noon = re.search('|'.join(MONTHS), words), re.search(r'[ap](?=\.?m\b)', words)
    if not month or len(numbers) < 2:
        return numbers
    clock = int(''.join(f'{number:02}' for number in numbers[2:4]) or 0)
    day, year = sorted(numbers[:2])
    return (year, MONTHS[month[0]], day,
            clock % 1200 + 1200 * (noon[0] == 'p') if noon else clock)


def named_by(chapters, rules, entries):
    """For each entry whose name a rule reads: the entry, the rule, and the parts of the name. A
    chapter's own name is no part of what is before the rest."""
    found = []
    for entry in entries:
        own = chapters.own.search(entry.name)
        for rule, pattern in rules.items():
            match = re.fullmatch(pattern, entry.name, re.S | re.I * (rules is chapters.others))
            part = {key.rstrip('2'): word for key, word in match.groupdict().items() if word
                    } if match else {}
            if match and not ('rest' in part and own and match.start('rest') > own.start()) and (
                    entry.is_folder or 'rest' in part or 'part' in part or rule == 'Blackboard'):
                found.append((entry, rule, part))
                break
    return found


def named_by_systems(chapters, entries):
    """The same for learning systems. Gradescope has a file that says whose a folder is."""
    told = next((entry.path for entry in entries
                 if entry.name == 'submission_metadata.yml' and not entry.is_link), None)
    people, folder = {}, ''
    for line in Path(told).read_text('utf-8', 'replace').splitlines() if told else ():
        begins = re.match(r'([^\s:-][^:]*):\s*$', line)
        folder = begins[1].strip('"\'') if begins else folder
        said = re.match(r'\s*(- )?:(name|sid|email): *(.*?)\s*$', line)
        if said and said[1]:
            people.setdefault(folder, []).append(collections.defaultdict(str))
        if said and folder in people:
            people[folder][-1][said[2]] = re.sub(
                r'\\(?:x([0-9A-F]{2})|u([0-9A-F]{4}))',
                lambda code: chr(int(code[1] or code[2], 16)),
                said[3].strip('"\'').replace("''", "'"))
    found = [(entry, 'Gradescope', {'who': one['name'] or one['email'] or entry.name,
                                    'id': one['sid'] or one['email'], 'email': one['email']})
             for entry in entries for one in people.get(entry.name, [])]
    return found or named_by(chapters, {} if told else SYSTEMS, entries)


def named_by_others(chapters, entries):
    """The same for names that no system made, if several of the students have the same chapter."""
    found, having = [], collections.defaultdict(set)
    for entry, rule, part in named_by(chapters, chapters.others, [
            entry for entry in entries if not (entry.is_link or os.path.isdir(entry.path))]):
        id = re.search(r'(?<![^\W_])[A-Za-z]?\d{4,}(?![^\W_])', part['who'])
        who = part['who'].replace(id[0], '') if id else part['who']
        who = re.sub(r'(?<=[ _-])[ _-]+', '', who).strip(' _-')
        if NOBODY.fullmatch(re.sub(r'\d+', '', who)) and not id:
            continue
        found.append((entry, rule, part | {'who': who or id[0], 'id': id[0] if id else ''}))
        for item, _ in chapters.fits(os.path.splitext(part['rest'])[0], False)[0]:
            having[item.name].add((nfc(who).casefold(), id and id[0]))
    return found if any(len(people) > 1 for people in having.values()) else []


def submissions_of_systems(chapters, folder, named):
    """Those whose files, or folders, are named so."""
    found = {}
    titles = {part['who'] + '_' for _, system, part in named if system == 'Blackboard'}
    title = os.path.commonprefix(sorted(titles)) if len(titles) > 1 else next(iter(titles), '')[:-1]
    title = title[:title.rfind('_') + 1]  # of the assignment; what is behind it is the student's
    for entry, system, part in named:
        who = shown_name(part['who'].removeprefix(title) if system == 'Blackboard' else part['who'])
        is_file = 'rest' in part
        whole = entry.is_folder and not is_file
        kind = 'names of files' if system in OTHERS else (
            f"{system}'s {'folders' if whole else 'flat files'}")
        new = Submission(shown_name(os.path.join(folder, entry.name)), who, kind,
                         part.get('id') or (who if system in SYSTEMS else ''), nfc(who),
                         other_ids=tuple(filter(None, [part.get('email')])))
        one = found.setdefault((system not in OTHERS and system, nfc(who).casefold(), new.id), new)
        when = time_of(part.get('when', ''))
        if part.get('late'):
            one.note = 'handed in late'
        if part.get('part', 'submission_file') != 'submission_file':
            one.seen = 'a text that was typed in'
        elif whole:
            one.parts += [dataclasses.replace(inner, when=when)
                          for inner in entries_of(entry.path)]
            one.kind, one.folder = new.kind, new.folder
        elif is_file:
            name = part['rest'] + part.get('ending', '')
            one.parts.append(dataclasses.replace(entry, name=name, when=when))
        elif system == 'Blackboard':  # the text that says who it is: "Name: Ada Byron (ada)"
            with open(entry.path, encoding='utf-8-sig', errors='replace') as text:
                said = re.match(r'[^:]*: *(.+?) *\(([^()]+)\)\s*$', text.readline(500))
            if said:
                one.name, one.person, one.id = said[1], nfc(said[1]), said[2]
    for one in found.values():
        search(chapters, one)
    return list(found.values())


def are_classes(chapters, folders):
    """Whether all of these folders name several people each. Else they are students' own, and what
    a student names as somebody else's is not theirs."""
    def people_in(entry):
        entries = entries_of(entry.path)
        return {nfc(part['who']).casefold() for *_, part in named_by_systems(
            chapters, entries) or named_by_others(chapters, entries)}
    return all(len(people_in(entry)) > 1 for entry in folders)


class Level:
    """What lies in a folder that may be a class. A student's own folder names nobody."""

    def __init__(self, chapters, entry, shown, each=False, own=False):
        self.entry, self.shown = entry, shown
        entries = entries_of(entry.path)
        self.named = [] if own else named_by_systems(chapters, entries)
        taken = {part.path for part, *_ in self.named}
        self.below = [part for part in entries if part.path not in taken
                      and (part.is_folder or os.path.isdir(part.path)) and not (
                          part.name.lower() in ('out', 'chapters', *(
                              item.name.lower() for item in chapters.known))
                          or is_passed_over(part.name) or chapters.is_chapter(part)
                          or VERSION.fullmatch(part.name) and not (
                              each or DATE_AND_NAME.match(part.name)))]
        found = {part.path: Search(chapters, entries_of(part.path), MOST_LEVELS, part.path)
                 for part in self.below if part.is_folder}
        self.with_work = [part for part in self.below
                          if part.path in found and found[part.path].has_work()]
        having = collections.Counter(item for search in found.values() for item in (
            ['a checkout'] if search.checkout else search.candidates))
        unread = [part for part in entries if ARCHIVE.search(part.name) and not part.is_folder
                  and part.path not in taken]
        self.below += unread if self.with_work or len(unread) > 1 else []
        # the names of who may be students: "work (2)" is the work of the same one as "work"
        self.names = [name for name in (re.sub(f'{AGAIN}$', '', part.name, flags=re.I)
                                        for part in self.with_work) if not NOBODY.fullmatch(name)]
        self.many = len(set(self.names)) > 1
        if not (self.named or self.many or each or own):
            self.named = named_by_others(chapters, entries)
            taken = {part.path for part, *_ in self.named}

        def rest():
            return Search(chapters, [part for part in entries if part.path not in taken
                                     and part not in self.below], 1, entry.path)
        self.own = rest()
        # several folders have the same chapter, and nothing lies next to them
        self.may_be_class = max(having.values(), default=0) > 1 and not (
            self.own.candidates or self.own.checkout)
        parts = self.with_work or self.below
        alone = len(parts) == 1 and not (self.named or self.own.candidates or self.own.checkout)
        self.only = parts[0] if alone and parts[0].is_folder else None
        if len(self.below) == 1 and PACKING.fullmatch(
                self.below[0].name.lower()) and not each and not named_by_systems(
                    chapters, entries_of(self.below[0].path)):
            self.below, self.with_work = [], []
            self.own = rest()


def class_level(chapters, entry, shown):
    """The folder with the students: this one, or one below it, while there is only one."""
    level = Level(chapters, entry, shown)
    inner = level.only and class_level(chapters, level.only, os.path.join(shown, level.only.name))
    return inner if inner and (inner.many or inner.named) and not inner.own.checkout else level


def students_in_sections(chapters, folders):
    """The submissions in folders that are sections of a course, each with its students: most have
    several folders with the same chapter, of other names than in the other sections. Else none."""
    levels = [class_level(chapters, part, shown) for shown, part in folders.items()
              if part.is_folder]
    sections = [level for level in levels if level.may_be_class or level.named]
    names = [name for level in sections
             for name in {part['who'] for *_, part in level.named} or level.names]
    if len(sections) < 2 or 2 * len(sections) <= len(folders) or (
            4 * len(set(names)) <= 3 * len(names)):
        return []
    return [student for shown, part in folders.items()
            for student in students_in(chapters, shown, part, True, False, False)[0]]


def students_in(chapters, folder, entry, single, one, each, own=False):
    """The submissions in a folder that was named, and a remark."""
    level = class_level(chapters, entry, folder) if single and not (one or each) else Level(
        chapters, entry, folder, each, own)
    rest, below, named = level.own, level.below, [] if one else level.named
    is_class = ((single or level.many) and (level.many and single or not rest.candidates)
                and below and not rest.checkout)
    if one or not (each or named or is_class):
        remark = (f"{clean(shown_name(folder))} is graded as one student's folder; --class grades "
                  "each folder in it as a student's")
        is_unclear = single and not one and len(level.with_work) > bool(rest.checkout)
        return [submission_of(chapters, entry, folder)], remark if is_unclear else ''
    found = [] if each or named or not single else students_in_sections(
        chapters, {os.path.join(level.shown, part.name): part for part in below})
    if found:
        return found, (f'{clean(shown_name(folder))} is graded as a folder of classes; --class '
                       "grades each folder in it as a student's")
    found = submissions_of_systems(chapters, level.shown, named)
    parts = level.with_work if named else below
    classes = are_classes(chapters, level.with_work)
    for part in parts:
        shown = os.path.join(level.shown, part.name)
        inner = classes and named_by(chapters, SYSTEMS, entries_of(part.path))
        found += (inner and submissions_of_systems(chapters, shown, inner)
                  or [submission_of(chapters, part, shown)])
    nobodys = min(rest.candidates.items(), default=None)
    return (found,
            f"{clean(shown_name(nobodys[1][0][6]))} is nobody's: it lies next to students' folders"
            if nobodys else '')


def find_submissions(paths, chapters, one=False, each=False):
    """The submissions in the folders, archives and files that were named, and what is to be said
    of them. Chapters: a Chapters, or the items that are asked for."""
    chapters = chapters if isinstance(chapters, Chapters) else Chapters(chapters, chapters)
    paths = without_unpacked(paths)
    top = {path: entry_of(os.path.realpath(path), True) for path in paths}
    # Of a single folder the name says nothing, but for Moodle's.
    several = [one for one in top.values() if len(top) > 1 or not one.is_folder
               or '_assignsubmission_' in one.name]
    named = named_by_systems(chapters, several) or named_by_others(
        chapters, [one for one in several if not one.is_folder])
    found, remarks = submissions_of_systems(chapters, os.path.dirname(paths[0]),
                                            [] if one else named), []
    top = {path: entry for path, entry in top.items()
           if one or not any(entry is part for part, *_ in named)}
    classes = {} if one or each or len(paths) == 1 else {
        path: entry for path, entry in top.items() if entry.is_folder}
    own = len(top) > 1 and not are_classes(chapters, [one for one in top.values() if one.is_folder])
    in_sections = students_in_sections(chapters, classes)
    found += in_sections
    for path, entry in top.items():
        if in_sections and path in classes:
            continue
        if not entry.is_folder:
            remarks.append(f'skipped, not a folder: {clean(path)}'
                           + (f': {WHY_NOT[entry.path]}' if entry.path in WHY_NOT else ''))
            continue
        more, remark = students_in(chapters, path, entry, len(paths) == 1, one, each, own)
        found += more
        remarks += [remark] if remark else []
    return found, remarks


def tell_apart(submissions):
    """Adds the id to names that several students have."""
    names = collections.Counter(submission.name for submission in submissions)
    for submission in submissions:
        if names[submission.name] > 1 and submission.id:
            submission.name += f' ({submission.id})'


def what_was_read(submissions):
    """Such as: 50 students in Canvas's flat files, 200 pictures."""
    kinds = collections.Counter(submission.kind for submission in submissions)
    words = [f'{counted(count, "student")} in {kind}' for kind, count in kinds.items()]
    checkouts = sum(bool(submission.checkout) for submission in submissions)
    words += [counted(checkouts, 'checkout')] if checkouts else []
    return ', '.join(words + [counted(sum(len(submission.pictures) for submission in submissions),
                                      'picture')])


def not_understood(submissions):
    """If no student of a class has a file of a chapter, or less than half of those who handed in
    files: the lines that say so, and why. Else none."""
    files = [one for one in submissions if one.folder and (one.parts or one.why)]
    wrong = [one for one in files if one.why]
    if not submissions or files and 2 * len(wrong) <= len(files):
        return []
    return [f'NOT UNDERSTOOD: {counted(len(files), "student")} with files, {len(wrong)} of them '
            'with none that fits a chapter. Names such as 03_image_texture.png or 03.png do. '
            '--dry-run shows who was found', *(f'  {one.name}: {one.why}' for one in wrong)]


def who_was_found(submissions, items):
    """A line for each student: by turns three with nothing, with several versions, and others."""
    lines, kinds = [], collections.Counter()
    for one in submissions:
        files = [f'{item.number} ' + (why_not or one.versions.get(item.name)
                                      or os.path.basename(path)) for item in items
                 for path, why_not in [one.pictures.get(item.name, ('', ''))] if path]
        files = ['a checkout', *one.versions.values()] if one.checkout else files
        who = f'{one.name} ({one.id})' if one.id not in one.name else one.name
        kind = 0 if not files else 2 - bool(one.versions)
        lines.append((kinds[kind] // 3, kind, '  ' + who + ': ' + ('; '.join(filter(None, files))
                                              or one.why or one.seen or one.note or 'nothing')))
        kinds[kind] += 1
    return [line for *_, line in sorted(lines, key=lambda line: line[:2])]


def shortened(lines, most=9):
    """At most so many lines, of 160 characters, and how many follow."""
    shown = [line if len(line) <= 160 else line[:157] + '...' for line in map(
        shown_name, lines[:most])]
    return shown + ([f'  and {len(lines) - most} more'] if lines[most:] else [])
