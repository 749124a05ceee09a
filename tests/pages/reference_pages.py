#!/usr/bin/env python3
"""The pages that list things list what is there: docs/sources.md, docs/glossary.md and docs/teaching.md.

usage: reference_pages.py ROOT            checks the pages of the tree ROOT
       reference_pages.py --self-test     checks that each kind of fault is noticed

sources.md    Each row of its maps links our files and a test: the text of the link is the title of a TEST_CASE in the linked file, or the
              name of an add_test in a .cmake file.
glossary.md   The terms are in alphabetical order, each once, each with a sentence and a link to a page.
teaching.md   Each chapter has its row.
"""
import pathlib
import re
import sys
import tempfile

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
    return {''.join(re.findall(r'"([^"]*)"', case)) for case in cases} | set(re.findall(r'add_test\(NAME (\S+)', text))


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


def faults_of(root):
    chapters = sorted(path.parent.name[:2] for path in root.glob('chapters/*/README.md'))
    docs = root / 'docs'
    return [f'docs/{name}.md: {fault}' for name, faults in (
        ('sources', faults_of_sources(docs / 'sources.md')), ('glossary', faults_of_glossary(docs / 'glossary.md')),
        ('teaching', faults_of_teaching(docs / 'teaching.md', chapters))) for fault in faults]


def self_test():
    head = MAP + ' what we do differently, and why |\n|---|---|---|---|\n'
    row = '| u | [a.hpp](../common/a.hpp) | [a law](../tests/t.cpp) | |\n'
    files = {'common/a.hpp': '', 'tests/t.cpp': 'TEST_CASE(\n    "a "\n    "law") {', 'chapters/00_a/README.md': '# 00\n',
             'docs/sources.md': (head + row + '\n') * DOCUMENTS,
             'docs/glossary.md': TERMS + ' chapter |\n|---|---|---|\n| (a, b) | One. | [00](../chapters/00_a/README.md) |\n'
                                 '| Ball | Two. | [00](../chapters/00_a/README.md) |\n',
             'docs/teaching.md': '| chapter |\n|---|\n| 00 |\n'}
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)

        def faults(name='', old='', new=''):
            for path, text in files.items():
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text(text.replace(old, new, 1) if path == name else text)
            return ' '.join(faults_of(root))

        assert faults() == '', faults()
        for name, old, new, words in (
                ('docs/sources.md', 'a law', 'no law', 'has no test "no law"'),
                ('docs/sources.md', 'a.hpp)', 'b.hpp)', 'there is no ../common/b.hpp'),
                ('docs/sources.md', '[a law](../tests/t.cpp)', 'a law', 'is missing'),
                ('docs/sources.md', '| u |', '| u | v |', '5 cells'),
                ('docs/sources.md', MAP, '| map |', '4 maps, not 5'),
                ('docs/glossary.md', '(a, b)', 'cube', '"Ball" comes too late'),
                ('docs/glossary.md', '(a, b)', 'ball', '"Ball" comes too late, or twice'),
                ('docs/glossary.md', 'One.', '', 'lacks a sentence'),
                ('docs/glossary.md', '00_a', '01_a', 'leads nowhere'),
                ('docs/teaching.md', '00', '01', 'chapter 00 has no row')):
            assert words in faults(name, old, new), (words, faults(name, old, new))
    print('what is wrong in a list is noticed')


if __name__ == '__main__':
    if sys.argv[1:] == ['--self-test']:
        self_test()
    elif len(sys.argv) == 2:
        found = faults_of(pathlib.Path(sys.argv[1]))
        print('\n'.join(found) or 'all rows are in order')
        sys.exit(1 if found else 0)
    else:
        sys.exit(__doc__)
