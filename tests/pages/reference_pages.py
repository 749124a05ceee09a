#!/usr/bin/env python3
"""The pages that list things list what is there.

usage: reference_pages.py ROOT     checks the pages of the tree ROOT

sources.md    Each row of its maps links our files and a test: the text of the link is the title of a TEST_CASE in the linked file, or the
              name of an add_test in a .cmake file.
glossary.md   The terms are in alphabetical order, each once, each with a sentence and a link to a page.
teaching.md   Each chapter of README.md has its row.
platforms.md  Chapters and golden pictures of a system are those of platforms.sh.
CHANGELOG.md  Its first version is that of CMakeLists.txt, vcpkg.json and CITATION.cff, its day that of CITATION.cff.
"""
import pathlib
import re
import sys

MAP = '| in the document | our file | test |'
TERMS = '| term | meaning |'
LINK = re.compile(r'\[([^\]]+)\]\(([^)]+)\)')
DOCUMENTS = 5


def tables(page):
    """The tables of a page: head line, and rows as pairs of a line's number and its cells."""
    found = []
    rows = None
    for number, line in enumerate(page.read_text(encoding='utf-8').splitlines(), 1):
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
    return {''.join(re.findall(r'"([^"]*)"', case)) for case in cases} | set(re.findall(r"add_(?:test\(NAME |check\()(\S+)", text))


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
            elif (text, target) in tests and text not in titles_of(file.read_text(encoding='utf-8')):
                yield f'{number}: {target} has no test "{text}"'


def faults_of_glossary(page):
    before = ''
    for number, cells in (row for head, rows in tables(page) if head.startswith(TERMS) for row in rows):
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


def faults_of_platforms(root, rows):
    golden = [file.name[:2] for file in (root / 'tests/golden').glob('*.png')]
    script = (root / 'tests/platforms/platforms.sh').read_text(encoding='utf-8')
    for system, programs in re.findall(r'^  (\w+)\)\n.*?chapters="(.*?)"', script, re.M | re.S):
        chapters = [program[:2] for program in programs.split()]
        wanted = [f'`{system}`', ' '.join(chapters), f'{sum(map(chapters.count, golden))} equal']
        if not any(set(wanted) <= set(cells) for cells in rows):
            yield f'no row with the cells {wanted}'


def faults_of_version(root):
    files = ('CMakeLists.txt', 'vcpkg.json', 'CITATION.cff', 'CHANGELOG.md')
    cmake, vcpkg, citation, changelog = [(root / file).read_text(encoding='utf-8') for file in files]
    version = re.search(r'project\(.*? VERSION ([\d.]+)', cmake)[1]
    day = re.search(r'date-released: (\S*)|$', citation)[1]
    for text, line in ((vcpkg, f'"version": "{version}"'), (citation, f'\nversion: {version}\n'),
                       (changelog.split('\n## ')[1], f'{version}, {day}\n')):
        if line not in text:
            yield f'CMakeLists.txt has version {version}, and one of {files[1:]} does not say {line.strip()}'


def faults_of(root):
    chapters = re.findall(r'\]\(chapters/(\d\d)_', (root / 'README.md').read_text(encoding='utf-8'))
    docs = root / 'docs'
    return [f'docs/{name}.md: {fault}' for name, faults in (
        ('sources', faults_of_sources(docs / 'sources.md')), ('glossary', faults_of_glossary(docs / 'glossary.md')),
        ('teaching', faults_of_teaching(docs / 'teaching.md', chapters)), ('platforms', faults_of_platforms(root, [cells for _, table in tables(docs / 'platforms.md') for _, cells in table])))
        for fault in faults] + list(faults_of_version(root))


if __name__ == '__main__':
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    found = faults_of(pathlib.Path(sys.argv[1]))
    print('\n'.join(found) or 'all rows are in order')
    sys.exit(1 if found else 0)
