#!/usr/bin/env python3
"""The lessons that a page tells its reader to change, changed: the page's own code, in the
chapter's own lesson.

usage: changed.py PAGE CHAPTERS OUT NAME...    writes OUT/NAME.hpp for each change

In the page, a mark comes before each piece of a change, and then a block of code:

    <!-- change: stripes 02_checkerboard_uv above "using Checkered" -->
    <!-- change: stripes 02_checkerboard_uv replaces "using Paint" -->
    <!-- change: plain 01_plain_spheres replaces "template <class Real>" to "    });" -->

The code goes above or below the one line of the lesson that has the text, or replaces it, or that
line and all up to the next with the second text. `removes` takes the line away and has no block. A
change has at most fifteen lines of code, and all are tried here."""
import pathlib
import re
import sys

MARK = re.compile(r'^<!-- change: (\w+) ((\d\d)_\w+) (above|below|replaces|removes) "([^"]*)"(?: '
                  r'to "([^"]*)")? -->\n'
                  r'(?:```cpp\n(.*?)^```$)?', re.MULTILINE | re.DOTALL)
MOST = 15


class Fault(Exception):
    pass


def pieces_of(page):
    """Each change's name with its chapter, the chapter's number and its pieces: verb, text, last
    text, lines."""
    changes, blocks = {}, page.count('<!-- code:')
    for mark in MARK.finditer(page):
        name, chapter, number, verb, text, last, block = mark.groups()
        if (block is None) != (verb == 'removes'):
            raise Fault(f'after this mark comes a line with ```cpp, unless it removes: {mark[0]}')
        blocks += block is not None
        change = changes.setdefault(name, (chapter, number, []))
        if change[0] != chapter:
            raise Fault(f'{name} changes two chapters')
        change[2].append((verb, text, last, (block or '').splitlines()))
    if sum(len(pieces) for *_, pieces in changes.values()) != page.count(
        '<!-- change:') or blocks != page.count('```cpp'):
        raise Fault('a mark is none, or code has no mark, so that nothing tries it')
    for name, (_, _, pieces) in changes.items():
        count = sum(len(block) for *_, block in pieces)
        if count > MOST:
            raise Fault(f'{name} has {count} lines, more than {MOST}')
    return changes


def changed(lesson, name, number, pieces):
    """The lesson's text with a change, in a namespace of its own."""
    lines = lesson.split('\n')
    for verb, text, last, block in pieces:
        places = [i for i, line in enumerate(lines) if text in line]
        if len(places) != 1:
            raise Fault(f'{name}: {len(places)} lines of the lesson have "{text}"')
        first = end = places[0]
        if last is not None:
            end = next((i for i in range(first, len(lines)) if last in lines[i]), -1)
            if end < 0:
                raise Fault(f'{name}: no line after "{text}" has "{last}"')
        indent = lines[first][:len(lines[first]) - len(lines[first].lstrip())]
        begin, end = {'above': (first, first),
                      'below': (end + 1, end + 1)}.get(verb, (first, end + 1))
        lines[begin:end] = [indent + line if line else line for line in block]
    return '\n'.join(lines).replace(f'texmap::chapter_{number}', f'texmap::change_{name}')


def run(page, chapters, out, names):
    changes = pieces_of(page.read_text(encoding='utf-8'))
    if sorted(changes) != sorted(names):
        raise Fault(f'{page} has the changes {" ".join(sorted(changes))}; tests draw '
                    f'{" ".join(sorted(names))}')
    out.mkdir(parents=True, exist_ok=True)
    for name, (chapter, number, pieces) in changes.items():
        lesson = (chapters / chapter / 'lesson.hpp').read_text(encoding='utf-8')
        (out / f'{name}.hpp').write_text(changed(lesson, name, number, pieces), encoding='utf-8')


if __name__ == '__main__':
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    try:
        run(*map(pathlib.Path, sys.argv[1:4]), sys.argv[4:])
    except Fault as fault:
        sys.exit(f'error: {fault}')
