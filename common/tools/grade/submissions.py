"""What students handed in: whose it is, and where their chapters or pictures lie in it.

A learning system writes into a file's name, or a folder's, whose it is. Else a folder in the folder
that was named is a student's, unless work lies in that folder itself. A student's folder is
searched three levels deep, as students pack the same work in many ways: ada/03.png,
ada/out/03_image.png, ada/texmap-main/chapters. Zips are read as folders. Links below the folders
that were named are not followed."""
import collections
import dataclasses
import functools
import os
import re
import shutil
import tempfile
import zipfile
import zlib
from pathlib import Path

from results import clean, counted, nfc, shown_name

MOST_LEVELS, MOST_ENTRIES, MOST_BYTES = 3, 20000, 1 << 28  # bytes: of a zip, unpacked
# Folders in which no student's pictures lie, but perhaps other ones of the same names.
PASSED_OVER = ('__macosx', 'assets', 'build', 'cmake-build-debug', 'common', 'docs', 'node_modules',
               'tests')
# The one folder that a site, or a student, packs all in.
PACKING = re.compile(
    'bilder|homework|hw|images|pictures|png|screenshots|.*-(main|master)|.*(texmap|texture).*')
# How learning systems name what students handed in. Canvas adds -1 to the name of a file that is
# handed in again.
SYSTEMS = {
    'Moodle': r'(?P<who>.+)_(?P<id>\d+)_assign(?P<part>[a-z]+_[a-z]+)_?(?P<rest>.*)',
    'Blackboard': r'(?P<who>.+)_attempt_(?P<when>\d{4}(?:-\d\d){5})(?:_(?P<rest>.+)|\.txt)',
    'Canvas': r'(?!\d\d?_)(?P<who>.+?)(?P<late>_LATE)?_(?P<id>\d+)_\d+_(?P<rest>.+?)'
              r'(?:-(?P<when>\d+))?(?P<ending>\.\w+)?'}


@dataclasses.dataclass
class Entry:
    """What lies in a folder. A zip counts as a folder."""
    name: str  # of a zip without its ending; of a learning system's file, as the student named it
    path: str
    is_folder: bool
    is_link: bool = False
    when: str = ''  # of several files of a name the one with the largest counts


@dataclasses.dataclass
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


@functools.cache
def scratch():
    """A folder that is removed at the end."""
    return tempfile.TemporaryDirectory(prefix='grade-')


NAMED = set()  # folders with what was unpacked of zips that the instructor named


@functools.cache
def unpacked(path):
    """The folder with what is of use in a zip; of other files it has the names. None if the zip
    cannot be read."""
    folder, left = tempfile.mkdtemp(dir=scratch().name), MOST_BYTES
    try:
        with zipfile.ZipFile(path) as packed:
            for info in packed.infolist()[:MOST_ENTRIES]:
                # without this flag it is in UTF-8, too, if Apple's systems made it
                name = info.filename
                name = name if info.flag_bits & 0x800 else name.encode('cp437').decode(
                    'utf-8', 'surrogateescape')
                parts = [part for part in name.replace('\\', '/').split('/')
                         if part not in ('', '.', '..')]
                if not parts or any(is_passed_over(part) and part != 'common' for part in parts):
                    continue
                target = Path(folder, *parts)
                (target if info.is_dir() else target.parent).mkdir(parents=True, exist_ok=True)
                if re.search(r'\.(png|jpe?g|[hc]pp|[hc]|in[cl]|txt|zip)$', name.lower()):
                    left -= info.file_size
                    if left < 0:
                        return None
                    with packed.open(info) as source, open(target, 'wb') as made:
                        shutil.copyfileobj(source, made)
                elif not info.is_dir():
                    target.touch()
    except (OSError, EOFError, RuntimeError, ValueError, zipfile.BadZipFile, zlib.error):
        return None
    return folder


def entry_of(path, is_named=False):
    """The entry at a path. Of a zip that is not read it is the file: one that is broken or too
    large, or lies in a student's zip."""
    name, is_link = os.path.basename(path), os.path.islink(path)
    is_folder = not is_link and os.path.isdir(path)
    if name.lower().endswith('.zip') and not (is_link or is_folder):
        may_be_read = not path.startswith(scratch().name) or path.startswith(tuple(NAMED))
        folder = may_be_read and unpacked(path)
        NAMED.update([folder] if folder and is_named else [])
        return Entry(name[:-4], folder, True) if folder else Entry(name, path, False)
    return Entry(name, path, is_folder, is_link)


def entries_of(folder):
    """The entries of a folder in the order of their names; none if it may not be read."""
    try:
        with os.scandir(folder) as found:
            paths = [entry.path for entry, _ in zip(found, range(MOST_ENTRIES))]
    except OSError:
        return []
    there = set(paths)  # a zip next to what was unpacked from it is not read again
    return [entry_of(path) for path in sorted(paths, key=os.fsencode)
            if not (path.lower().endswith('.zip') and path[:-4] in there)]


def is_passed_over(name):
    return name.startswith('.') or name.lower() in PASSED_OVER


def is_code(name):
    return name.lower().endswith(('.hpp', '.cpp'))


def has_chapters(folder):
    return any(entry.is_folder and re.match('[0-9][0-9]_.', entry.name)
               for entry in entries_of(folder))


def is_chapter(items, folder):
    """Whether this is the folder of a chapter that is graded. The name alone does not say so: a
    student's folder, or one of pictures, can have it. So there must be code in it."""
    if not any(folder.name == item.name or f'/{folder.name}/' in item.exercise for item in items):
        return False
    return any(is_code(entry.name) or entry.is_folder and entry.name == 'exercises'
               for entry in entries_of(folder.path))


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

    def __init__(self, items, entries, levels, folder=''):
        self.items = items
        self.checkout = ''
        # by the item's name: misfit, level, when, path, name and whether it is a link
        self.candidates = {}
        self.entries = 0
        self.seen = []  # names of pictures that fit nothing
        self.code = ''  # the first file of code outside a chapter
        self.look_into(entries, folder, 0, levels)

    def look_into(self, entries, folder, level, levels):
        below, holds_chapters = [], False
        for entry in entries:
            self.entries += 1
            if self.entries > MOST_ENTRIES:
                return
            if entry.is_folder:
                if entry.name.lower() == 'chapters' and has_chapters(entry.path):
                    # Who builds it knows chapters/ in small letters, or takes the folder itself.
                    self.checkout = self.checkout or (
                        folder if entry.path == os.path.join(folder, 'chapters') else entry.path)
                elif entry.path == os.path.join(folder,
                                                entry.name) and is_chapter(self.items, entry):
                    holds_chapters = True
                elif not is_passed_over(entry.name):
                    below.append(entry)
                continue
            self.take_picture(entry, level)
            if not self.code and is_code(entry.name):
                self.code = entry.name
        if holds_chapters and not self.checkout:
            self.checkout = folder
        for part in below if level < levels else ():
            if not self.checkout:
                inner = entries_of(part.path)
                self.look_into([dataclasses.replace(entry, when=part.when) for entry in inner],
                               part.path, level + 1, levels)

    def take_picture(self, entry, level):
        stem, ending = os.path.splitext(entry.name)
        if ending.lower() in ('.bmp', '.ppm', '.zip', '.rar', '.7z', '.gz'):
            self.seen.append(entry.name
                             + (', which is not read' if ending.lower() == '.zip' else ''))
        jpeg = ending.lower() in ('.jpg', '.jpeg')
        if ending.lower() != '.png' and not jpeg:
            return
        fits = False
        for item in self.items:
            fit = None if item.exercise else misfit(stem, item)
            if fit is not None and not (jpeg and fit > 2):  # a photo may have any number
                fit += 4 * jpeg  # any PNG is better
                self.candidates.setdefault(item.name,
                                           []).append((fit, level, entry.when, entry.path,
                                                       entry.name, entry.is_link))
                fits = True
        if not fits:
            self.seen.append(entry.name)

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

    def pictures(self):
        """Of the candidates the one whose name fits best, then the one nearest to the top, then the
        newest."""
        result = {}
        for item, candidates in self.candidates.items():
            newest_first = sorted(candidates, key=lambda one: (len(one[2]), one[2]), reverse=True)
            (*rank, path, name, is_link), *others = sorted(newest_first, key=lambda one: one[:2])
            why_not = ''
            if is_link:
                why_not = f'{name} is a link; links are not followed'
            elif others and rank[0] % 4 >= 2 and list(others[0][:3]) == rank:
                why_not = f'{name} or {others[0][4]}? Name the picture {item}.png'
            result[item] = (path, why_not)
        return result


def search(items, submission, path=''):
    """Finds the work in the parts of a submission."""
    found = Search(items, submission.parts, MOST_LEVELS, path)
    submission.checkout = found.checkout
    if not found.checkout:
        submission.pictures = found.pictures()
        submission.seen = found.what_else() or submission.seen
    if found.entries > MOST_ENTRIES:
        submission.note = f'the folder has more than {MOST_ENTRIES} files; not all were looked at'
    return submission


def submission_of(items, entry, folder):
    """That of a student who has a folder, or something that should be one."""
    result = Submission(shown_name(folder), shown_name(entry.name), person=nfc(entry.name))
    if entry.is_link:
        result.note = 'the folder is a link; links are not followed'
        return result
    try:
        os.scandir(entry.path).close()
    except OSError as error:
        result.note = f'the folder cannot be read: {error.strerror}'
        return result
    result.parts = entries_of(entry.path)
    return search(items, result, entry.path)


def named_by_systems(entries):
    """For each entry whose name a learning system made: the entry, the system, and the parts of the
    name."""
    matches = [(entry, system, re.fullmatch(pattern, entry.name)) for entry in entries
               for system, pattern in SYSTEMS.items()]
    found = {entry.path: (entry, system, match.groupdict())
             for entry, system, match in reversed(matches) if match}
    return [found[entry.path] for entry in entries if entry.path in found]


def submissions_of_systems(items, folder, named):
    """Those whose files, or folders, a learning system named."""
    found = {}
    titles = {part['who'] + '_' for _, system, part in named if system == 'Blackboard'}
    title = os.path.commonprefix(sorted(titles)) if len(titles) > 1 else next(iter(titles), '')[:-1]
    title = title[:title.rfind('_') + 1]  # of the assignment; what is behind it is the student's
    for entry, system, part in named:
        who = shown_name(part['who'].removeprefix(title) if system == 'Blackboard' else part['who'])
        whole = entry.is_folder and not part.get('rest')
        new = Submission(shown_name(os.path.join(folder, entry.name)), who,
                         f"{system}'s {'folders' if whole else 'flat files'}",
                         part.get('id') or who, nfc(who))
        one = found.setdefault((system, who, new.id), new)
        if part.get('late'):
            one.note = 'handed in late'
        if system == 'Moodle' and part['part'] != 'submission_file':
            one.seen = 'a text that was typed in'
        elif whole:
            one.parts += entries_of(entry.path)
            one.kind, one.folder = new.kind, new.folder
        elif part.get('rest'):
            name = part['rest'] + (part.get('ending') or '')
            one.parts.append(dataclasses.replace(entry, name=name, when=part.get('when') or ''))
        elif system == 'Blackboard':  # the text that says who it is: "Name: Ada Byron (ada)"
            with open(entry.path, encoding='utf-8-sig', errors='replace') as text:
                said = re.match(r'[^:]*: *(.+?) *\(([^()]+)\)\s*$', text.readline(500))
            if said:
                one.name, one.person, one.id = said[1], nfc(said[1]), said[2]
    for one in found.values():
        one.parts.sort(key=lambda part: (len(part.when), part.when), reverse=True)
        search(items, one)
    return list(found.values())


def students_in(items, folder, entry, single, one, each):
    """The submissions in a folder that was named, and a remark."""
    entries = entries_of(entry.path)
    named = [] if one else named_by_systems(entries)
    taken = {part.path for part, *_ in named}
    below = [part for part in entries if part.path not in taken
             and (part.is_folder or os.path.isdir(part.path)) and not (
        part.name.lower() in ('out', 'chapters', *(item.name.lower() for item in items))
        or is_passed_over(part.name) or
        is_chapter(items, part))]
    if len(below) == 1 and PACKING.fullmatch(
        below[0].name.lower()) and not each and not named_by_systems(entries_of(below[0].path)):
        below = []
    own = Search(items, [part for part in entries if part not in below and part.path not in taken],
                 1, entry.path)
    with_work = [part for part in below if part.is_folder
                 and Search(items, entries_of(part.path), MOST_LEVELS - 1, part.path).has_work()]
    many = len(with_work) > 1
    is_class = ((single or many) and (many and single or not own.candidates)
                and below and not own.checkout)
    if one or not (each or named or is_class):
        remark = (f"{clean(shown_name(folder))} is graded as one student's folder; --class grades "
                  "each folder in it as a student's")
        is_unclear = single and not one and len(with_work) > bool(own.checkout)
        return [submission_of(items, entry, folder)], remark if is_unclear else ''
    found = submissions_of_systems(items, folder, named)
    for part in with_work if named else below:
        shown, inner = os.path.join(folder, part.name), named_by_systems(entries_of(part.path))
        found += submissions_of_systems(items, shown,
                                        inner) if inner else [submission_of(items, part, shown)]
    nobodys = min(own.candidates.items(), default=None)
    return (found,
            f"{clean(shown_name(nobodys[1][0][4]))} is nobody's: it lies next to students' folders"
            if nobodys else '')


def find_submissions(paths, items, one=False, each=False):
    """The submissions in the folders, zips and files that were named, and what is to be said of
    them."""
    top = {path: entry_of(os.path.realpath(path), True) for path in paths}
    # Of a single folder the name says nothing, but for Moodle's.
    named = named_by_systems([one for one in top.values() if len(top) > 1 or not one.is_folder
                              or '_assignsubmission_' in one.name])
    found, remarks = submissions_of_systems(items, os.path.dirname(paths[0]),
                                            [] if one else named), []
    for path, entry in top.items():
        if not one and any(entry is part for part, *_ in named):
            continue
        if not entry.is_folder:
            remarks.append(f'skipped, not a folder: {clean(path)}')
            continue
        more, remark = students_in(items, path, entry, len(paths) == 1, one, each)
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
