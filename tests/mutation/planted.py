#!/usr/bin/env python3
"""Plants known faults of well-known renderers in common/ and sees a test fail for each.

Reads tests/mutation/planted.txt. Works in a copy of the project (build/planted/tree) with a build
of its own.
--write also writes docs/known_faults.md, with the name of the test that failed.
"""
import argparse
import re
import sys

from mutate import PROJECT, copy_project, run

PAGE = PROJECT / 'docs' / 'known_faults.md'


class Fault:
    """One entry of planted.txt or symptoms.txt: what to change, and which suite must notice."""

    def __init__(self, name, lines, needed):
        self.name = name
        self.fields = {}
        self.old, self.new = [], []
        for line in lines:
            if line.startswith('- '):
                self.old.append(line[2:])
            elif line.startswith('+ '):
                self.new.append(line[2:])
            elif line.strip():
                key, _, value = line.partition(': ')
                self.fields[key] = value
        missing = {'what', 'file', *needed} - set(self.fields)
        if missing or not self.old:
            sys.exit(f'[{name}] lacks {", ".join(sorted(missing)) or "the lines to change"}')

    def place(self, text):
        """Where a file's text has the lines."""
        # Lines are found whatever their indentation, so that a reformatted file is still
        # understood.
        pattern = r'\n[ \t]*'.join(re.escape(line.strip()) for line in self.old)
        found = list(re.finditer(pattern, text))
        if len(found) != 1:
            sys.exit(f'[{self.name}]: its lines are {len(found)} times in {self.fields["file"]}')
        return found[0].span()

    def plant(self, tree):
        """Changes the file; returns its text from before."""
        path = tree / self.fields['file']
        text = path.read_text()
        start, end = self.place(text)
        path.write_text(text[:start] + '\n'.join(self.new) + text[end:])
        return path, text


def faults_of(path, needed):
    parts = re.split(r'^\[(.+)\]\n', path.read_text(), flags=re.M)[1:]
    return [Fault(name, lines.splitlines(), needed) for name, lines in zip(parts[::2], parts[1::2])]


def build(folder, suites, jobs):
    return run(['cmake', '--build', folder, '--parallel', jobs, '--target', *suites])


def first_failure(output):
    """The name of the first test case that failed, from doctest's report."""
    found = re.search(r'TEST CASE:\s+(.+?)\n(?:.*\n)*?.*(?:ERROR|FATAL ERROR|CRASH)', output)
    return ' '.join(found[1].split()) if found else 'the suite stopped'


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('names', nargs='*', help='faults to plant; without names, all of them')
    parser.add_argument('--jobs', type=int, default=2)
    parser.add_argument('--write', action='store_true', help='write docs/known_faults.md')
    parser.add_argument('--check', action='store_true', help='only see that their lines are there')
    arguments = parser.parse_args()
    faults = faults_of(PROJECT / 'tests' / 'mutation' / 'planted.txt', ('found in', 'suite'))
    if arguments.names:
        faults = [fault for fault in faults if fault.name in arguments.names]
    if arguments.check:
        symptoms = faults_of(PROJECT / 'tests' / 'mutation' / 'symptoms.txt', ())
        for fault in [*faults, *symptoms]:
            fault.place((PROJECT / fault.fields['file']).read_text())
        return
    tree = PROJECT / 'build' / 'planted' / 'tree'
    copy_project(tree)
    folder = tree.parent / 'build'
    configured = run(['cmake', '-S', tree, '-B', folder, '-D', 'CMAKE_BUILD_TYPE=Release', '-D',
                      'CMAKE_CXX_FLAGS_RELEASE=-O1'])
    if configured.returncode != 0:
        sys.exit(configured.stdout)
    suites = sorted({fault.fields['suite'] for fault in faults})
    built = build(folder, suites, arguments.jobs)
    if built.returncode != 0:
        sys.exit(built.stdout[-4000:])
    for suite in suites:
        if run([folder / 'tests' / suite]).returncode != 0:
            sys.exit(f'{suite} fails before anything is planted')

    unseen, rows = [], []
    for fault in faults:
        path, text = fault.plant(tree)
        suite = fault.fields['suite']
        built = build(folder, [suite], arguments.jobs)
        if built.returncode != 0:
            sys.exit(f'{fault.name} does not compile:\n' + built.stdout[-3000:])
        tested = run([folder / 'tests' / suite], timeout=600)
        path.write_text(text)
        noticed = first_failure(tested.stdout) if tested.returncode != 0 else None
        print(f'{fault.name}: {"noticed: " + noticed if noticed else "NOT NOTICED by " + suite}',
              flush=True)
        if not noticed:
            unseen.append(fault.name)
        rows.append((fault, noticed or '**none**'))
    if arguments.write and not arguments.names:
        write_page(rows)
    print(f'{len(faults)} faults planted, {len(faults) - len(unseen)} noticed')
    sys.exit(1 if unseen else 0)


def write_page(rows):
    lines = ['# Known faults', '',
             'Faults that were found in well-known renderers and programs. `python3 '
             'tests/mutation/planted.py` plants each of them in a copy of this',
             'project and runs one suite, which must fail. This page is written by the same '
             'program with `--write`.', '',
             '| fault | found in | planted in | the test that fails |', '|---|---|---|---|']
    for fault, noticed in rows:
        lines.append(f'| {fault.fields["what"]} | {fault.fields["found in"]} | '
                     f'`{fault.fields["file"]}` | {noticed} (`{fault.fields["suite"]}`) |')
    PAGE.write_text('\n'.join(lines) + '\n')


if __name__ == '__main__':
    main()
