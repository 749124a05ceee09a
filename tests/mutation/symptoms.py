#!/usr/bin/env python3
"""Plants mistakes of students in a copy, one at a time, and sees the chapter's symptoms name each.

Reads tests/mutation/symptoms.txt. Compiles tests/chapters/symptoms_NN.cpp alone, which takes a
second or two: its headers are those of the copy, the libraries those of a build. The first failure
must have the mistake's word and no other's, among at most ten."""
import argparse
import shutil
import sys
import tempfile
from pathlib import Path

import planted

MOST_FAILURES = 10


def tried(fault, tree, arguments, words):
    """What is wrong with how a planted mistake is noticed, or None."""
    chapter, word = fault.name.split(' ', 1)
    suite = f'symptoms_{chapter}'
    program = tree / suite
    compiled = planted.run([
        *arguments.compiler.split(), '-std=c++20', '-O0', '-w', '-pthread', '-DTEXMAP_LEARN',
        '-DTEXMAP_NO_FLATTEN',
        *[f'-I{folder}' for folder in arguments.include], f'-I{tree}/tests', f'-I{tree}/chapters',
        f'-I{tree}/common',
        f'{tree}/tests/chapters/{suite}.cpp', *arguments.link, '-o', program])
    if compiled.returncode != 0:
        return 'does not compile:\n' + compiled.stdout[-3000:]
    tested = planted.run([program], timeout=120)
    failures = [line.partition('ERROR: ')[2] for line in tested.stdout.splitlines()
                if 'ERROR: ' in line]
    named = {other for other in words if other in ''.join(failures[:1])}
    if named != {word} or len(failures) > MOST_FAILURES:
        return f'{suite} shows {len(failures)} failures, the first says {failures[:1]}'
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('names', nargs='*', help='mistakes to plant; without names, all of them')
    parser.add_argument('--compiler', default='c++')
    parser.add_argument('--include', action='append', default=[], metavar='FOLDER',
                        help='where doctest.h is')
    parser.add_argument('--link', action='append', default=[], metavar='FILE',
                        help="doctest's main program, libraries")
    arguments = parser.parse_args()
    faults = planted.faults_of(planted.PROJECT / 'tests' / 'mutation' / 'symptoms.txt', ())
    words = [fault.name.split(' ', 1)[1] for fault in faults]
    wrong = 0
    with tempfile.TemporaryDirectory(prefix='texmap-symptoms-') as folder:
        tree = Path(folder)
        for name in ('common', 'chapters', 'tests/chapters', 'tests/support'):
            shutil.copytree(planted.PROJECT / name, tree / name)
        for fault in faults:
            if arguments.names and fault.name not in arguments.names:
                continue
            path, text = fault.plant(tree)
            trouble = tried(fault, tree, arguments, words)
            path.write_text(text)
            print(f'{fault.name} in {path.name}: {trouble or "named"}', flush=True)
            wrong += trouble is not None
    print(f'{len(faults)} mistakes, {wrong} of them not named')
    sys.exit(wrong > 0 or not faults)


if __name__ == '__main__':
    main()
