#!/usr/bin/env python3
"""What the pages take from elsewhere, so that text and code cannot drift apart: code and figures.

usage: pages.py ROOT --check|--write|--self-test

In a page, a mark comes before a block of code, and the block is what the source has:

    <!-- code: texture/uv.hpp uv_rtiow -->
    <!-- code: scene/nearest.hpp color_along from "Nearest<Real> nearest" to "background(ray)" -->
    <!-- code: lesson.hpp Lesson::prepare -->

The path is that of a file next to the page, or in common/, or in the whole tree. The name is that
of a function, a structure, an enumeration or a constant; `A::b` is a member; with `from` and `to`,
the lines from the first that holds one text to the next that holds the other; if both texts are
the same, one line. A figure is between two marks inside a line, and is the value of its name in
docs/figures.txt, or a ratio in a table of docs/measurements.md, named by group, line and column:

    in all <!-- figure: 06.pixels_at_50 -->1,234<!-- end --> pixels
    <!-- figure: measured.chapters.07.float-pack_avx2 -->5.1<!-- end --> times as fast
"""
import pathlib
import re
import sys
import tempfile

CODE = re.compile(r'^<!-- code: (?P<file>\S+) (?P<name>[\w:~()]+)'
                  r'(?: from "(?P<first>[^"]*)" to "(?P<last>[^"]*)")? -->$')
FIGURE = re.compile(r'<!-- figure: (?P<name>[\w.-]+) -->(?P<value>.*?)<!-- end -->')
MARK_OF_EXERCISE = re.compile(r'^ *// (solution$|start: )')  # in tests/exercises/
FIGURES = 'docs/figures.txt'  # lines of a name, a blank and the value
MEASURED = 'docs/measurements.md'
MOST_WORDS = 1800  # on the main road of a chapter's page
SKIPPED = re.compile(r'^## Exercises$.*?(?=^## (?!Questions)|\Z)|<details>.*?</details>'
                     r'|^```.*?^```|<!--.*?-->|!\[.*?\]\(.*?\)|^(?:\||    )[^\n]*'
                     r'|</?[a-z][^>]*>|\]\([^)]*\)',
                     re.MULTILINE | re.DOTALL)


class Fault(Exception):
    pass


def pages_of(root):
    """All pages that may hold marks."""
    return sorted([root / 'README.md', *root.glob('chapters/*/README.md'), *root.glob('docs/*.md')])


def find_source(root, page, name):
    for folder in (page.parent, root / 'common', root):
        if (folder / name).is_file():
            return folder / name
    raise Fault(f'there is no file {name}')


def blanked(lines):
    """The lines with comments and texts blanked out, so that braces can be counted."""
    text = re.compile(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])\'|//.*')
    return [text.sub(lambda found: ' ' * len(found[0]), line) for line in lines]


def end_of(plain, start):
    """The line where the definition from `start` ends: braces are closed, `;` or `}` is last."""
    depth = 0
    opened = False
    for i in range(start, len(plain)):
        depth += len(re.findall('[{(]', plain[i])) - len(re.findall('[})]', plain[i]))
        opened = opened or '{' in plain[i]
        text = plain[i].rstrip()
        if depth == 0 and (text.endswith(';') or (opened and text.endswith('}'))):
            return i
    raise Fault('a definition does not end')


def definition(lines, plain, name, first, last):
    """First and last line of what defines `name` between two lines."""
    word = re.escape(name)
    patterns = [rf'^\s*(struct|class|enum class|enum) {word}\b(?!;)',  # a type
                rf'^\s*using {word} =',
                rf'^\s*(?!return\b)[\w:<>,&*\[\] ]*?[\s&*>\]]{word}\([^;]*$',  # more than a line
                rf'^\s*(?!return\b)[\w:<>,&*\[\] ]*?[\s&*>\]]{word}\(.*\{{.*\}}$',  # one line
                rf'^\s*(?!return\b)[\w:<>,&*\[\] ]*?[\s&*>\]]{word}(\{{| = |;)']  # no function
    for pattern in patterns:
        for i in range(first, last + 1):
            if re.match(pattern, plain[i]):
                end = end_of(plain, i)
                start = i
                while start > first and re.match(r'^\s*template <|^\s*requires', lines[start - 1]):
                    start -= 1
                return start, end
    raise Fault(f'nothing is named {name}')


def code_of(root, page, mark):
    lines = find_source(root, page, mark['file']).read_text(encoding='utf-8').splitlines()
    plain = blanked(lines)
    first, last = 0, len(lines) - 1
    for name in mark['name'].split('::'):
        first, last = definition(lines, plain, name, first, last)
    if mark['first'] is not None:
        begin = next((i for i in range(first, last + 1) if mark['first'] in lines[i]), None)
        if begin is None:
            raise Fault(f'{mark["name"]} has no line with "{mark["first"]}"')
        # The last line comes after the first one, unless both are one.
        after = begin if mark['last'] == mark['first'] else begin + 1
        end = next((i for i in range(after, last + 1) if mark['last'] in lines[i]), None)
        if end is None:
            raise Fault(f'{mark["name"]} has no line with "{mark["last"]}" after the first')
        first, last = begin, end
    piece = [line for line in lines[first:last + 1] if not MARK_OF_EXERCISE.match(line)]
    indent = min(len(line) - len(line.lstrip()) for line in piece if line.strip())
    return [line[indent:] for line in piece]


def joined(text):
    """Figures that begin a line go to the line before: Markdown would take the line for HTML."""
    return re.sub(r'(?<=[^\n])\n(<!-- figure: [^\n]*?<!-- end -->[^\s|]*) ?', r' \1\n',
                  text).replace('\n\n\n', '\n\n')


def renewed(root, page, figures, used):
    """The page's text with what its marks ask for."""
    out = []
    name = page.relative_to(root)
    lines = iter(enumerate(joined(page.read_text(encoding='utf-8')).split('\n'), 1))
    for number, line in lines:
        def value(match):
            name = match['name']
            if name not in figures:
                raise Fault(f'{FIGURES} has no figure {name}')
            used.add(name)
            return f'<!-- figure: {name} -->{figures[name]}<!-- end -->'
        try:
            if line.startswith('<!-- figure:'):
                raise Fault('a paragraph begins with a figure: Markdown takes the line for HTML')
            out.append(FIGURE.sub(value, line))
            if line.startswith('<!-- code:'):
                mark = CODE.match(line)
                if not mark:
                    raise Fault('a mark has the form <!-- code: FILE NAME [from "A" to "B"] -->')
                if next(lines)[1] != '```cpp':
                    raise Fault('after the mark comes a line with ```cpp')
                out += ['```cpp', *code_of(root, page, mark), '```']
                while next(lines)[1] != '```':
                    pass
            elif '<!-- figure:' in FIGURE.sub('', line):
                raise Fault('a figure lacks its <!-- end --> on the same line')
        except Fault as fault:
            raise Fault(f'{name}:{number}: {fault}') from None
        except StopIteration:
            raise Fault(f'{name}:{number}: the block of code does not end') from None
    return '\n'.join(out)


def measured(text):
    """The ratios of docs/measurements.md by group, line and column, in two or three digits."""
    def word(cell):
        return re.sub(r'[^\w.-]+', '_', cell).strip('_')
    ratios = {}
    group = columns = ''
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip('|').split('|')]
        if line.startswith('## '):
            group, columns = line[3:].split(':')[0], ''
        elif group and line.startswith('| ') and not columns:
            columns = cells
        elif group and line.startswith('| '):
            for column, cell in zip(columns, cells):
                ratio = re.search(r'\(([\d.]+)×\)$', cell)
                if ratio:
                    digits = 0 if float(ratio[1]) >= 20 else 1 if float(ratio[1]) >= 1 else 2
                    name = f'measured.{group}.{word(cells[0])}.{word(column)}'
                    ratios[name] = f'{float(ratio[1]):.{digits}f}'
    return ratios


def words_on_the_road(text):
    """The number of words outside folds, pictures, code, formulas, tables and exercises."""
    return sum(any(map(str.isalnum, word)) for word in SKIPPED.sub(' ', text).split())


def run(root, write):
    figures = dict(line.split(' ', 1)
                   for line in (root / FIGURES).read_text(encoding='utf-8').splitlines())
    counted = list(figures)
    if (root / MEASURED).is_file():
        figures |= measured((root / MEASURED).read_text(encoding='utf-8'))
    used = set()
    faults = []
    changed = 0
    for page in root.glob('chapters/*/README.md'):
        name = page.relative_to(root)
        words = words_on_the_road(page.read_text(encoding='utf-8'))
        if words > MOST_WORDS:
            faults.append(f'{name} has {words} words outside its folds, more than {MOST_WORDS}')
    for page in pages_of(root):
        name = page.relative_to(root)
        try:
            text = renewed(root, page, figures, used)
        except Fault as fault:
            faults.append(str(fault))
            continue
        if text != page.read_text(encoding='utf-8'):
            changed += 1
            if write:
                page.write_text(text, encoding='utf-8')
            else:
                faults.append(f'{name} is stale: run ./course pages --write')
    if not write:
        faults += [f'{FIGURES}: no page shows {name}' for name in counted
                   if name not in used and list(root.glob(f'chapters/{name[:2]}_*'))]
    for fault in faults:
        print(f'FAIL: {fault}', file=sys.stderr)
    print(f'{len(pages_of(root))} pages, {len(used)} figures, {changed} '
          f'{"renewed" if write else "stale"}')
    return 1 if faults else 0


def self_test():
    """A page is renewed, and what is wrong with it is said."""
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        (work / 'docs').mkdir()
        (work / 'common/texture').mkdir(parents=True)
        (work / 'chapters').mkdir()
        (work / 'common/texture/uv.hpp').write_text(
            '/// Doc with { a brace.\ntemplate <class Real>\nReal half(Real x) {\n  // } in a '
            'comment\n  if (x) {\n    return x / 2;\n'
            '  }\n  return half(x);\n}\n', encoding='utf-8')
        (work / FIGURES).write_text('02.n 76\n', encoding='utf-8')
        readme = work / 'README.md'

        def renew(text):
            readme.write_text(text, encoding='utf-8')
            return renewed(work, readme, {'02.n': '76'}, set())

        def block(mark, code=''):
            return f'<!-- code: texture/uv.hpp {mark} -->\n```cpp\n{code}```\n'

        whole = ('template <class Real>\nReal half(Real x) {\n  // } in a comment\n  if (x) {\n   '
                 ' return x / 2;\n  }\n  return half(x);\n}\n')
        figure = '<!-- figure: 02.n -->76<!-- end -->'
        assert renew(block('half', 'old\n')) == block('half', whole)
        assert renew('a\n<!-- figure: 02.n --><!-- end -->, b') == f'a {figure},\nb'
        for text, why in (
                ('a\n\n<!-- figure: 02.n -->1<!-- end --> b', 'Markdown takes the line for HTML'),
                (block('third'), 'nothing is named third'),
                (block('half from "while" to "}"'), 'has no line with "while"'),
                ('<!-- code: uv/none.hpp half -->\n```cpp\n```', 'there is no file uv/none.hpp'),
                ('<!-- code: texture/uv.hpp half -->\n\n```cpp\n```', 'comes a line with ```cpp'),
                ('<!-- code: texture/uv.hpp half -->\n```cpp\n', 'does not end'),
                ('a <!-- figure: 02.m -->1<!-- end -->', 'has no figure 02.m'),
                ('a <!-- figure: 02.n -->1', 'lacks its')):
            said = ''
            try:
                renew(text)
            except Fault as fault:
                said = str(fault)
            assert why in said, (text, said)
        road = ('one [two](a.md)\n\n| no |\n\n    no\n```\nno\n```\n'
                '![no](b)\n<details>\nno\n</details>\n')
        assert words_on_the_road(road + '## Exercises\nno\n## Questions\nno\n## Then\n* four') == 4
        renew(block('half', 'old\n'))
        assert run(work, False) == 1
        renew('a <!-- figure: 02.n -->1<!-- end -->\n' + block('half', 'old\n'))
        assert run(work, False) == 1 and run(work, True) == 0 and run(work, False) == 0
        assert '76' in readme.read_text(encoding='utf-8')
    print('marks are renewed, and what is wrong with one is said')
    return 0


def main():
    if len(sys.argv) != 3 or sys.argv[2] not in ('--check', '--write', '--self-test'):
        print('usage: pages.py ROOT --check|--write|--self-test', file=sys.stderr)
        return 2
    return self_test() if sys.argv[2] == '--self-test' else run(pathlib.Path(sys.argv[1]).resolve(),
                                                                sys.argv[2] == '--write')


if __name__ == '__main__':
    sys.exit(main())
