"""What students handed in: whose folder it is, and where their chapters or pictures lie in it.

Learning systems and students pack the same work in many ways: ada/03.png, ada/out/03_image.png, ada/texmap-main/chapters. So a folder is
searched three levels deep; of several places the one nearest to the top counts. Links below the folders that were named are not followed.
"""
import dataclasses
import os
import re

from results import clean, counted, shown_name

MOST_LEVELS, MOST_ENTRIES = 3, 20000
# Folders in which no student's pictures lie, but perhaps other ones of the same names.
PASSED_OVER = ('__macosx', 'assets', 'build', 'cmake-build-debug', 'common', 'docs', 'node_modules', 'tests')
# The one folder that a site, or a student, packs all in.
PACKING = re.compile('bilder|homework|hw|images|pictures|png|screenshots|.*-(main|master)|.*(texmap|texture).*')


@dataclasses.dataclass
class Submission:
    """One student's folder."""
    folder: str  # as the instructor named it
    name: str
    note: str = ''
    checkout: str = ''  # holds chapters/ or the chapters; empty for pictures
    pictures: dict = dataclasses.field(default_factory=dict)  # by the item's name: the file, and why it cannot be taken
    seen: str = ''  # pictures and code that lie there, by name, where no checkout is


def entries_of(folder):
    """The entries of a folder in the order of their names; none if it may not be read."""
    try:
        with os.scandir(folder) as found:
            entries = [entry for entry, _ in zip(found, range(MOST_ENTRIES))]
    except OSError:
        return []
    return sorted(entries, key=lambda entry: os.fsencode(entry.name))


def is_folder(entry):
    return entry.is_dir(follow_symlinks=False)


def is_passed_over(name):
    return name.startswith('.') or name.lower() in PASSED_OVER


def is_code(name):
    return name.lower().endswith(('.hpp', '.cpp'))


def has_chapters(folder):
    return any(is_folder(entry) and re.match('[0-9][0-9]_.', entry.name) for entry in entries_of(folder))


def is_chapter(items, folder):
    """Whether this is the folder of a chapter that is graded. The name alone does not say so: a student's folder, or one of pictures, can
    have it. So there must be code in it."""
    if not any(folder.name == item.name or f'/{folder.name}/' in item.exercise for item in items):
        return False
    return any(is_code(entry.name) or is_folder(entry) and entry.name == 'exercises' for entry in entries_of(folder))


def misfit(stem, item):
    """How well a file's name says that it is an item's picture: 0 best, then 1, 2, 3; None if it does not say so."""
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
    """What a folder and those in it hold, down to so many levels."""

    def __init__(self, items, folder, levels):
        self.items = items
        self.checkout = ''
        self.candidates = {}  # by the item's name: misfit, level, path and whether it is a link
        self.entries = 0
        self.seen = []  # names of pictures that fit nothing
        self.code = ''  # the first file of code outside a chapter
        self.look_into(folder, 0, levels)

    def look_into(self, folder, level, levels):
        below, holds_chapters = [], False
        for entry in entries_of(folder):
            self.entries += 1
            if self.entries > MOST_ENTRIES:
                return
            if is_folder(entry):
                if entry.name.lower() == 'chapters' and has_chapters(entry):
                    # Who builds it knows chapters/ in small letters, or takes the folder itself.
                    self.checkout = self.checkout or (folder if entry.name == 'chapters' else entry.path)
                elif is_chapter(self.items, entry):
                    holds_chapters = True
                elif not is_passed_over(entry.name):
                    below.append(entry.path)
            self.take_picture(entry, level)
            if not self.code and is_code(entry.name):
                self.code = entry.name
        if holds_chapters and not self.checkout:
            self.checkout = folder
        for path in below if level < levels and not self.checkout else ():
            self.look_into(path, level + 1, levels)

    def take_picture(self, entry, level):
        stem, ending = os.path.splitext(entry.name)
        if ending.lower() != '.png':
            return
        fits = False
        for item in self.items:
            fit = None if item.exercise else misfit(stem, item)
            if fit is not None:
                self.candidates.setdefault(item.name, []).append((fit, level, entry.path, entry.is_symlink()))
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
            words += ('; ' if words else '') + f"{clean(shown_name(self.code))}, but not in a chapter's folder"
        return words

    def pictures(self):
        """Of the candidates the one whose name fits best, then the one nearest to the top."""
        result = {}
        for item, candidates in self.candidates.items():
            (fit, level, path, is_link), *others = sorted(candidates, key=lambda one: one[:2])
            name, why_not = os.path.basename(path), ''
            if is_link:
                why_not = f'{name} is a link; links are not followed'
            elif others and fit >= 2 and others[0][:2] == (fit, level):
                why_not = f'{name} or {os.path.basename(others[0][2])}? Name the picture {item}.png'
            result[item] = (path, why_not)
        return result


def submission_of(items, path, folder):
    result = Submission(shown_name(folder), shown_name(os.path.basename(path)))
    if os.path.islink(path):
        result.note = 'the folder is a link; links are not followed'
        return result
    try:
        os.scandir(path).close()
    except OSError as error:
        result.note = f'the folder cannot be read: {error.strerror}'
        return result
    search = Search(items, path, MOST_LEVELS)
    result.checkout = search.checkout
    if not search.checkout:
        result.pictures, result.seen = search.pictures(), search.what_else()
    if search.entries > MOST_ENTRIES:
        result.note = f'the folder has more than {MOST_ENTRIES} files; not all were looked at'
    return result


def find_submissions(folders, items, one=False, each=False):
    """The submissions in the folders that were named, and what is to be said of those that could be read in two ways.

    The rule: folders in a folder are a class, if no chapters lie next to them. Where a picture lies next to them, or other folders were
    named, too, there must be work in them."""
    found, remarks = [], []
    for folder in folders:
        path = os.path.realpath(folder)
        below = []  # folders that may be students', not parts of a student's tree
        for entry in entries_of(path):
            name = entry.name.lower()
            if entry.is_dir() and not (name in ('out', 'chapters') or is_passed_over(name) or is_chapter(items, entry) or
                                       any(name == item.name.lower() for item in items)):
                below.append(entry)
        with_work = sum(is_folder(entry) and Search(items, entry.path, MOST_LEVELS - 1).has_work() for entry in below)
        here = [Search(items, place, 0) for place in (path, os.path.join(path, 'out'))]
        has_checkout = any(search.checkout for search in here)
        own = [candidate[0][2] for search in here for _, candidate in sorted(search.candidates.items())]
        is_packed = len(below) == 1 and PACKING.fullmatch(below[0].name.lower())
        if len(folders) > 1:
            is_class = with_work > 1 and not own
        else:
            is_class = len(below) > 1 and with_work > 0 if own else below and not is_packed
        is_class = is_class and not has_checkout
        is_unclear = with_work < 2 or own if is_class else with_work > bool(len(folders) > 1 or is_packed or has_checkout)
        if one or each:
            is_class, is_unclear = each, False
        name = clean(shown_name(folder))
        if is_unclear and is_class:
            nobodys = f"; {clean(shown_name(os.path.basename(own[0])))} is nobody's" if own else ''
            remarks.append(f'{name} is graded as a class of {counted(len(below), "student")}{nobodys}; --one grades it as one '
                           "student's folder")
        elif is_unclear:
            remarks.append(f"{name} is graded as one student's folder; --class grades each folder in it as a student's")
        if is_class:
            found += [submission_of(items, entry.path, os.path.join(folder, entry.name)) for entry in below]
        else:
            found.append(submission_of(items, path, folder))
    return found, remarks
