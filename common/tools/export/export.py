#!/usr/bin/env python3
"""A student's copy of the course: some chapters, without solutions, answers and what only
instructors and engineers need.

usage: ./course export --chapters 00-06 FOLDER
--chapters: 02, 00-06 or 01-04,08; FOLDER is made, or is empty

KEPT decides: the last pattern that fits a path counts, and a folder NN_name or a file NN_... of a
chapter that is not exported never fits. Pages lose their answers, the rows of chapters that are not
there, lines with commands that the copy lacks, and links that would lead nowhere: these become
text. The tests of a chapter get the lessons beside it that they read: tests/neighbors/."""
import argparse
import fnmatch
import os
import pathlib
import re
import shutil
import subprocess
import sys

KEPT = """
    course CMakeLists.txt CMakePresets.json README.md LICENSE vcpkg.json
    .clang-format .gitattributes .gitignore
    chapters/* common/* docs/*.md docs/live/* assets/*
    tests/CMakeLists.txt tests/doctest_main.cpp tests/support/* tests/closure/*
    tests/number/test_number.cpp tests/math/* tests/sampling/* tests/scene/* tests/texture/*
    tests/published/*
    tests/chapters/*_[0-9][0-9]* tests/golden/programs.sh tests/golden/*.png
    tests/exercises/[0-9][0-9]_[0-9].hpp tests/extremes/digits.hpp tests/packs/wide.sh
    !docs/teaching.md !docs/grading.md !docs/pictures/* !assets/*pp !assets/CMakeLists.txt
    !assets/sources/* !assets/*sum* !assets/sky.sha256
    !common/tools/diagrams/* !common/tools/export/*
    !common/tools/grade/* !common/tools/pages/*
    !common/tools/playground/* common/tools/playground/live.js common/tools/playground/live.css
    !*~ !*.orig !*.rej !*.bak !*.sw? !*/.* !*/#*
""".split()
PICTURES = ('.png', '.svg', '.jpg')  # further ones are kept if a page shows them
OF_CHAPTER = re.compile(
    r'(?:^|/)(?:test_|symptoms_|chapter_)?(\d\d)_|(?:^|/)(?:symptoms|chapter|thumb)_(\d\d)\.')
# Lines of ./course help, which may go on, and of pages: commands that the copy lacks.
LACKING = re.compile(
    r'^(?:(?:\|.*| *)\./course (?:grade|export|pages|playground|bench|numbers|assets|steps)\b'
    r'|The tests of the benchmarks ).*\n(?: {30}.*\n)*', re.M)
ANSWER = re.compile(r'<details><summary>Answer</summary>.*?</details>\n*', re.S)
SOLUTION = re.compile(r'^ *// solution\n(?:(?! *// start: ).*\n)*', re.M)
LINK = re.compile(r'(!?)\[([^\[\]]*)\]\(([^()\s]+)\)')


class Wrong(Exception):
    pass


def chosen_of(words, there):
    """The numbers of the chapters that `00-06,08` names."""
    chosen = set()
    for word in words.split(','):
        ends = re.fullmatch(r'(\d\d?)(?:-(\d\d?))?', word)
        if not ends:
            raise Wrong(f"'{words}' names no chapters: write 02, 00-06 or 01-04,08")
        chosen |= {f'{n:02}' for n in range(int(ends[1]), int(ends[2] or ends[1]) + 1)}
    missing = sorted(chosen - set(there))
    if missing or not chosen:
        raise Wrong(
            f"there is no chapter {missing[0] if missing else words}; ./course list shows them")
    return sorted(chosen)


def files_in(root):
    for parent, folders, names in os.walk(root):
        folders[:] = [name for name in folders
                      if name not in ('.git', '.ci', '.github', 'build', 'out', '__pycache__')]
        yield from (os.path.relpath(os.path.join(parent, name), root) for name in names)


def is_left_out(path, chosen):
    number = OF_CHAPTER.search(path)
    return number is not None and (number[1] or number[2]) not in chosen


def is_kept(path, chosen):
    fitting = [pattern for pattern in KEPT if fnmatch.fnmatchcase(path, pattern.lstrip('!'))]
    return bool(fitting) and not fitting[-1].startswith('!') and not is_left_out(path, chosen)


def target_of(path, url):
    return os.path.normpath(os.path.join(os.path.dirname(path), url.split('#')[0]))


def without_dead_links(text, path, is_there):
    def leads(url):
        return '://' in url or url.startswith(('#', 'mailto:')) or is_there(target_of(path, url))

    def shown(link):
        picture, words, url = link.groups()
        return link[0] if leads(url) or not re.search('[./]', url) else '' if picture else words

    def row_stays(line):
        first = re.match(r'\| \[[^\]]*\]\((chapters/[^)]*)\)', line)
        image = re.match(r'(?:<a href="[^"]*">)?<img src="([^"]*)"', line)
        return not (first and not leads(first[1]) or image and not leads(image[1]))

    lines = ''.join(line for line in LACKING.sub('', text).splitlines(keepends=True)
                    if row_stays(line))
    pieces = re.split(r'(^```.*?^```$)', lines, flags=re.M | re.S)  # text and blocks of code
    return ''.join(piece if piece.startswith('```') else LINK.sub(shown, piece) for piece in pieces)


def export(root, folder, chosen):
    kept = {path for path in files_in(root) if is_kept(path, chosen)}
    pages = {path: (root / path).read_text(encoding='utf-8') for path in sorted(kept)
             if path.endswith('.md')}

    def is_somebodys(path):  # an exercise that its chapter's page does not name
        chapter, _, name = path.partition('/exercises/')
        return path.startswith('chapters/') and name and name not in pages.get(
            f'{chapter}/README.md', name)
    kept = {path for path in kept if not is_somebodys(path)}
    written = {f'tests/exercises/{path[9:11]}_{path.partition("/exercises/")[2][0]}.hpp'
               for path in kept if path.startswith('chapters/') and '/exercises/' in path}
    for path in sorted(kept):
        if re.match(r'tests/exercises/\d\d_\d\.hpp$', path) and path not in written:
            print(f'left out: {path}, since its chapter\'s page names no file of it',
                  file=sys.stderr)
            kept.remove(path)
    for path, text in pages.items():
        pages[path] = text = ANSWER.sub('\n', text)
        for url in [link[3]
                    for link in LINK.finditer(text)] + re.findall(r'<img src="([^"]*)"', text):
            target = target_of(path, url)
            if url.endswith(PICTURES) and (root / target).is_file() and not (target.startswith(
                ('tests/golden/', 'docs/pictures/thumb_')) and is_left_out(target, chosen)):
                kept.add(target)
    folders = {str(parent) for path in kept for parent in pathlib.PurePath(path).parents}
    for path in sorted(kept):
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        data = (root / path).read_bytes()
        if path in pages:
            data = without_dead_links(pages[path], path,
                                      lambda target: target in kept or target in folders).encode()
        elif path == 'course':
            data = LACKING.sub('', data.decode()).encode()
        elif path.startswith('tests/exercises/'):
            data = SOLUTION.sub('', data.decode()).encode()
        (folder / path).write_bytes(data)
        (folder / path).chmod((root / path).stat().st_mode & 0o777)
    for path in sorted(kept):
        if path.startswith('tests/chapters/') and OF_CHAPTER.search(path):
            for name in re.findall(r'^#include "(\d\d_\w+)/', (root / path).read_text(), re.M):
                if f'chapters/{name}' not in folders:
                    shutil.copytree(root / 'chapters' / name, folder / 'tests/neighbors' / name,
                                    ignore=lambda _, names: [one for one in names
                                                             if not one.endswith('.hpp')],
                                    dirs_exist_ok=True)
    exercises = sorted(path[16:20].replace('_', '.') for path in kept
                       if path.startswith('tests/exercises/'))
    for exercise in exercises:  # in this tree somebody may have written an answer
        file = next(folder.glob(f'chapters/{exercise[:2]}_*/exercises/{exercise[3]}_*.hpp'))
        subprocess.run(['sh', 'common/tools/check/check.sh', 'start', exercise, file], cwd=root,
                       check=True)
    write_workflow(folder, chosen, exercises)
    return exercises


def write_workflow(folder, chosen, exercises):
    """Writes classroom.yml with a step for each exercise and for the tests of each chapter."""
    steps = {f'e{exercise.replace(".", "_")}': f'./course check {exercise}'
             for exercise in exercises}
    steps |= {f't{number}': f'./course test {number}' for number in chosen}
    results = '\n'.join(f'          {name.upper()}_RESULTS: ${{{{ steps.{name}.outputs.result }}}}'
                        for name in steps)
    head, step, report = re.split('@EACH@\n|@END@\n',
                                  pathlib.Path(__file__).with_name('classroom.yml').read_text())
    place = folder / '.github/workflows'
    place.mkdir(parents=True)
    (place / 'classroom.yml').write_text(head.replace('@FIRST@', chosen[0]) + ''.join(
        step.replace('@ID@', name).replace('@WORDS@', words) for name, words in steps.items()) +
        report.replace('@RESULTS@', results).replace('@IDS@', ','.join(steps)))


def main():
    parser = argparse.ArgumentParser(prog='./course export',
                                     usage='%(prog)s --chapters 00-06 FOLDER', allow_abbrev=False)
    parser.add_argument('--chapters', required=True)
    parser.add_argument('folder', type=pathlib.Path)
    words = parser.parse_args()
    root = pathlib.Path(__file__).resolve().parents[3]
    folder = words.folder.resolve()
    try:
        chosen = chosen_of(words.chapters,
                           [path.name[:2] for path in root.glob('chapters/[0-9][0-9]_*')])
        if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
            raise Wrong(f'{words.folder} is there and not empty')
        if folder.is_relative_to(root) and folder.relative_to(root).parts[:1] not in (
            ('build',), ('out',)):
            raise Wrong('the folder must be outside of the course')
        exercises = export(root, folder, chosen)
    except (Wrong, OSError) as error:
        print(f'error: {error}', file=sys.stderr)
        return 2
    print(f'{words.folder}: chapters {", ".join(chosen)} with {len(exercises)} exercises. Try it '
          'there: ./course check')
    return 0


if __name__ == '__main__':
    sys.exit(main())
