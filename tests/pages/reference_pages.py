#!/usr/bin/env python3
"""The pages that list things list what is there, and no page names what is gone.

usage: reference_pages.py ROOT     checks the pages of the tree ROOT, and first finds planted faults

every page    Paths, names and commands in code type are in the sources; options, chapters and
              exercises are there. Numbers of lines are steps.sh's limit or chapter 00's length.
sources.md    Each row of its maps links our files and a test: the link's text is the title of a
              TEST_CASE in the linked file, or the name of an add_test in a .cmake file.
glossary.md   The terms are in alphabetical order, each once, with a sentence and a link to a page.
teaching.md   Each chapter of README.md has its row.
platforms.md  Chapters and golden pictures are those of platforms.sh, stages those of .ci/run.
numbers.md    Its functions are the course's.
CHANGELOG.md  Its version is that of CMakeLists.txt, vcpkg.json and CITATION.cff, with its day.
"""
import os
import pathlib
import re
import sys

MAP = '| in the document | our file | test |'
TERMS = '| term | meaning |'
LINK = re.compile(r'\[([^\]]+)\]\(([^)]+)\)')
DOCUMENTS = 5
NAMED = ('cpp', 'hpp', 'in', 'py', 'sh', 'cmake', 'js', 'yml')  # pages may leave out their folder
SOURCES = (*NAMED, 'course', 'run', 'run_autograder', 'txt', 'json')
# What programs write, helpers of tests, and the planted faults.
UNREAD = 'docs/|tests/(?!exercises/|golden/).*pp$|tests/pages/reference'
# What a page makes up as an example, and what other programs have.
NOT_OURS = re.compile(
    r'15_marble|[a-z] 15$|02[._]4|twice_places|globe\.cpp|classroom|Your[A-Z]|--second|nlohmann/'
    r'|bookworm|Identifier|Username|_onlinetext|submission_metadata|Submitted files'
    r'|--(args|install|posix|x-feature)')
OPTION = r'(?<![\w-])--[a-z][\w-]*'
EXERCISES = r'(?:hapters?|xercises?|course [a-z]+)((?:,? (?:and |or |to )?\d\d(?:\.\d)?(?![.\d]))+)'
PLANTED = [  # a line of a page, and what is said of it
    ('`scene/gone.hpp` of `common/scene/`', 'there is no scene/gone.hpp'),
    ('`gone.cpp`, `box.py`, `chapters/NN_name/`', 'there is no gone.cpp'),
    ('`Sphere<>::is_gone` and `uv_rtiow(p)`', 'nothing is named is_gone'),
    ('`./course gone`, `./course run 02`', 'there is no ./course gone'),
    ('--gone and --zoom', 'there is no --gone'),
    ('chapters 01, 02 and 99; exercise 02.1', 'there is no 99'),
    ('exercises 02.1, 02.9', 'there is no 02.9'),
    ('at most 80 lines, but some hundred lines', 'nothing checks "hundred lines"')]


def read(file):
    return file.read_text(encoding='utf-8')


def tables(page):
    """The tables of a page: head line, and rows as pairs of a line's number and its cells."""
    found = []
    rows = None
    for number, line in enumerate(read(page).splitlines(), 1):
        if not line.startswith('|'):
            rows = None
        elif rows is None:
            rows = []
            found.append((line, rows))
        elif not set(line) <= set('|- '):
            rows.append((number, [cell.strip() for cell in line.split('|')[1:-1]]))
    return found


def titles_of(text):
    """The titles of all tests in a file of tests or of CMake."""
    cases = re.findall(r'TEST_CASE(?:_TEMPLATE)?\(\s*((?:"[^"]*"\s*)+)', text)
    titles = {''.join(re.findall(r'"([^"]*)"', case)) for case in cases}
    return titles | set(re.findall(r'add_(?:test\(NAME |check\()(\S+)', text))


def linked(page, target):
    return (page.parent / target.split('#')[0]).resolve()


def faults_of_sources(page):
    maps = [rows for head, rows in tables(page) if head.startswith(MAP)]
    if len(maps) != DOCUMENTS:
        yield f'{len(maps)} maps, not {DOCUMENTS}'
    for number, cells in (row for rows in maps for row in rows):
        if len(cells) != 4:
            yield f'{number}: {len(cells)} cells, not 4'
            continue
        ours, tests = LINK.findall(cells[1]), LINK.findall(cells[2])
        if not ours or not tests:
            yield f'{number}: a file or a test is missing'
        for text, target in ours + tests:
            file = linked(page, target)
            if not file.is_file():
                yield f'{number}: there is no {target}'
            elif (text, target) in tests and text not in titles_of(read(file)):
                yield f'{number}: {target} has no test "{text}"'


def faults_of_glossary(page):
    before = ''
    for number, cells in (row for head, rows in tables(page) for row in rows if TERMS in head):
        term = re.sub('[^a-z0-9 ]', '', cells[0].lower())
        if term <= before:
            yield f'{number}: "{cells[0]}" comes too late, or twice'
        before = term
        if len(cells) != 3 or not cells[1].endswith('.') or not LINK.search(cells[2]):
            yield f'{number}: "{cells[0]}" lacks a sentence or a link'
        elif not linked(page, LINK.search(cells[2])[2]).is_file():
            yield f'{number}: the link of "{cells[0]}" leads nowhere'
    if not before:
        yield 'there are no terms'


def faults_of_teaching(page, chapters):
    rows = {cells[0] for _, table in tables(page) for _, cells in table}
    for chapter in chapters:
        if chapter not in rows:
            yield f'chapter {chapter} has no row'


class Tree:
    """What pages may name."""

    def __init__(self, root):
        files = []
        for folder, folders, names in os.walk(root):
            folders[:] = [name for name in folders if name not in ('.git', 'build', 'out')]
            inside = pathlib.Path(folder).relative_to(root)
            files += [(inside / name).as_posix() for name in names]
        parents = {str(one) for file in files for one in pathlib.PurePosixPath(file).parents}
        self.paths = '\n'.join(['', *files, *parents, ''])
        self.folders = {one.split('/')[-1] for one in parents}
        self.words = set()  # not those of comments
        for file in files:
            if re.split('[./]', file)[-1] in SOURCES and not re.match(UNREAD, file):
                text = read(root / file)
                comment = '//.*' if file.endswith(('pp', 'js', 'in')) else r'(?m)(?:^|\s)#.*'
                self.words |= {*re.findall(rf'\w+|{OPTION}', re.sub(comment, '', text))}
        first = round(read(root / 'chapters/00_one_file/main.cpp').count('\n'), -1)
        course = re.findall(r'(?m)^ +([a-z |-]+)\)', read(root / 'course'))
        self.commands = ' | '.join(course).split(' | ')
        steps = read(root / 'common/tools/steps/steps.sh')
        self.counts = (f'at most {steps.split("longest_lesson=")[1][:2]}', f'about {first}')

    def has(self, path):
        path = re.sub('NN_name', 'NN_*', re.sub('NAME|TARGET|K(?=_)', '*', path.rstrip('/')))
        pattern = re.escape(path).replace('NN', r'\d\d').replace(r'\*', '[^/\n]*')
        return re.search(f'[/\n]{pattern}\n', self.paths)

    def lacks(self, code):
        """What a piece in code type names, and the tree does not have."""
        for command in re.findall(r'^\./course ([a-z]+)', code):
            if command not in self.commands:
                yield f'there is no ./course {command}'
        for path in re.findall(r'(?:^|\s)(?:\./)?(?:course/)?([\w.*-]+(?:/[\w.*-]+)*)', code):
            first, *rest = path.split('/')
            ours = first in self.folders if rest else re.search(rf'\w\.({"|".join(NAMED)})$', path)
            if ours and not self.has(path):
                yield f'there is no {path}'
        for name, call in re.findall(r'(?<![\w./-])([A-Za-z_]\w*)(\(?)(?![\w./-])', code):
            if call or name == code or re.search(r'\w\w_|[a-z][A-Z]', name):
                stem = re.sub(r'^(test|draw|check|replay)_', '', name)  # CMake adds these
                if not {name, stem} & self.words:
                    yield f'nothing is named {name}'


def faults_of_text(text, tree, page=''):
    """What a page says that no source has, and where."""
    def blank(match):
        return re.sub(r'[^\n]', ' ', match[0])
    text = re.sub('<!--.*?-->', blank, text)
    found = [(at, f'there is no {at[0]}') for at in re.finditer(OPTION, text)
             if at[0] not in tree.words]
    text = re.sub(r'(?ms)^```.*?^```', blank, text)
    if page == 'docs/sources.md':  # the first column is about the documents
        text = re.sub(r'(?m)^\|[^|]*\|', blank, text)
    if page == 'docs/numbers.md':  # the first column has functions
        text = re.sub(r'(?m)^\| (\w+)', r'|`\1`', text)
    found += [(at, fault) for at in re.finditer('`([^`]+)`', text) for fault in tree.lacks(at[1])]
    for at in re.finditer(EXERCISES, text):
        for chapter, exercise in re.findall(r'(\d\d)\.?(\d?)', at[1]):
            file = rf'\nchapters/{chapter}_\w+/' + f'exercises/{exercise}_' * bool(exercise)
            if not re.search(file, tree.paths):
                found.append((at, f'there is no {chapter}' + f'.{exercise}' * bool(exercise)))
    for at in re.finditer(r'(\w* \w*\s*)((?:\d\S*|hundred|dozen)\s+lines)\b', text):
        if not (at[1] + at[2].split()[0]).endswith(tree.counts):
            found.append((at, f'nothing checks "{at[2]}"'))
    return [f'{text.count(chr(10), 0, at.start()) + 1}: {fault}' for at, fault in found
            if not NOT_OURS.search(at[0])]


def faults_of_platforms(root, page):
    run = read(root / '.ci/run')
    stages = ' '.join(re.findall(r'(?m)^(?:long|first)=\((.*)\)', run)).split()
    rows = [cells for _, table in tables(page) for _, cells in table]
    for head, table in tables(page):
        if head.startswith('| what | stage |'):
            yield from (f'.ci/run has no stage {stage}' for _, cells in table
                        for stage in cells[1].split(', ') if stage not in stages)
    golden = [file.name[:2] for file in (root / 'tests/golden').glob('*.png')]
    script = read(root / 'tests/platforms/platforms.sh')
    for system, programs in re.findall(r'^  (\w+)\)\n.*?chapters="(.*?)"', script, re.M | re.S):
        chapters = [program[:2] for program in programs.split()]
        wanted = [f'`{system}`', ' '.join(chapters), f'{sum(map(chapters.count, golden))} equal']
        if not any(set(wanted) <= set(cells) for cells in rows):
            yield f'no row with the cells {wanted}'


def faults_of_version(root):
    files = ('CMakeLists.txt', 'vcpkg.json', 'CITATION.cff', 'CHANGELOG.md')
    cmake, vcpkg, citation, changelog = [read(root / file) for file in files]
    version = re.search(r'project\(.*? VERSION ([\d.]+)', cmake)[1]
    day = re.search(r'date-released: (\S*)|$', citation)[1]
    for text, line in ((vcpkg, f'"version": "{version}"'), (citation, f'\nversion: {version}\n'),
                       (changelog.split('\n## ')[1], f'{version}, {day}\n')):
        if line not in text:
            yield f'CMakeLists.txt has version {version}; one of {files[1:]} lacks {line.strip()}'


def faults_of(root):
    chapters = re.findall(r'\]\(chapters/(\d\d)_', read(root / 'README.md'))
    docs = root / 'docs'
    tree = Tree(root)
    for line, said in PLANTED:
        assert faults_of_text(line, tree) == [f'1: {said}'], (line, faults_of_text(line, tree))
    named = [f'{page}:{fault}' for page in re.findall(r'.*\.md', tree.paths) for fault in
             faults_of_text(read(root / page), tree, page)]
    return named + [f'docs/{name}.md: {fault}' for name, faults in (
        ('sources', faults_of_sources(docs / 'sources.md')),
        ('glossary', faults_of_glossary(docs / 'glossary.md')),
        ('teaching', faults_of_teaching(docs / 'teaching.md', chapters)),
        ('platforms', faults_of_platforms(root, docs / 'platforms.md')))
        for fault in faults] + list(faults_of_version(root))


if __name__ == '__main__':
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    found = faults_of(pathlib.Path(sys.argv[1]))
    print('\n'.join(found) or 'all rows are in order')
    sys.exit(1 if found else 0)
