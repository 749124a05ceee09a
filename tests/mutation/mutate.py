#!/usr/bin/env python3
"""Mutation testing of common/: changes one token at a time and sees whether a test notices.

Works in a copy of the project (build/mutation/tree) with a build of its own; needs Ninja, and is fast with ccache. Writes
build/mutation/survivors.txt. tests/mutation/equivalent.txt names changes that change nothing.
"""
import argparse
import fnmatch
import hashlib
import json
import os
import re
import resource
import shutil
import subprocess
import sys
import time
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
WORK = PROJECT / 'build/mutation'
TREE, BUILD = WORK / 'tree', WORK / 'build'
SKIPPED_FILES = {'common/tools/fit_kernels.cpp'}
# What judges the text of the project, or builds it once more, and what measures time.
SKIPPED_LABELS = '^(bench|closure|grade|learn|mutation|pages|steps|exhaustive|extremes)$'
FAILED = r'Test +#\d+: (\S+) \.*\** *(?:Failed|Not Run|Exception|Subprocess|Timeout)'  # in ctest's report
NOBODY = 65533  # not the 65534 that tests become themselves
MOST_MEMORY = 6 << 30

TOKEN = re.compile(
    r'(?P<ignored>//[^\n]*|/\*.*?\*/|^[ \t]*#(?:[^\n\\]|\\.|\\\n)*|static_assert\(.*?\);|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\')'
    r"|(?P<number>0[xX][0-9a-fA-F.]+(?:[pP][+-]?\d+)?[uUlLfF]*|(?:\d[\d']*\.?\d*|\.\d+)(?:[eE][+-]?\d+)?[uUlLfF]*)"
    r'|(?P<member>(?<=\.)[a-z_]+\b(?!\())|(?P<name>[A-Za-z_]\w*)'
    r'|(?P<operator>(?<= )(?:<<=|>>=|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|[-+*/%<>&|^])(?= )|\+\+|--|(?<=[(, ])[-!](?=[\w(]))|[^\w\s]', re.M | re.S)
OPERATORS = {'+': '-', '-': '+', '*': '/', '/': '*', '%': '*', '<': '<=', '<=': '<', '>': '>=', '>=': '>', '==': '!=', '!=': '==',
             '&&': '||', '||': '&&', '+=': '-=', '-=': '+=', '*=': '/=', '/=': '*=', '<<': '>>', '>>': '<<', '&': '|', '|': '&',
             '^': '&', '<<=': '>>=', '>>=': '<<=', '|=': '&=', '&=': '|=', '^=': '|=', '++': '--', '--': '++', '!': ''}
NAMES = {'true': 'false', 'false': 'true', 'min': 'max', 'max': 'min', 'sin': 'cos', 'cos': 'sin', 'floor': 'ceil', 'ceil': 'floor'}
MEMBERS = {'x': 'y', 'y': 'z', 'z': 'x', 'u': 'v', 'v': 'u', 'r': 'g', 'g': 'b', 'b': 'r', 'a': 'b', 'width': 'height',
           'height': 'width', 'row': 'column', 'column': 'row', 'high': 'low', 'low': 'high', 'first': 'second', 'second': 'first'}


def other_number(text):
    """n + 1 for a whole number, one power of two more for a hexadecimal fraction, half of any other number."""
    hexadecimal, power = text.lower().startswith('0x'), 'p' in text.lower()
    body = text.rstrip('uUlL' if hexadecimal and not power else 'uUlLfF')
    suffix = text[len(body):]
    if power:
        mantissa, exponent = re.split('[pP]', body)
        return f'{mantissa}p{int(exponent) + 1}{suffix}'
    if hexadecimal:
        return f'{int(body, 16) + 1:#x}{suffix}'
    if re.fullmatch(r"[\d']+", body):
        return f"{int(body.replace(chr(39), '')) + 1}{suffix}"
    return (repr(float(body) / 2) if float(body) != 0 else '1.0') + suffix


class Mutant:
    def __init__(self, path, text, token, new):
        self.path, self.start, self.end, self.new = path, token.start(), token.end(), new
        self.line = text.count('\n', 0, self.start) + 1
        first, last = text.rfind('\n', 0, self.start) + 1, (text + '\n').find('\n', self.end)
        self.old_line = text[first:last].strip()
        self.new_line = (text[first:self.start] + new + text[self.end:last]).strip()
        self.change = f'{token[0]} -> {new or "nothing"}'
        self.of_a_table = token.lastgroup == 'number' and self.old_line.count(',') >= 5

    def chance(self, word):
        """A number from 0 to 1 that depends on the change and the word alone."""
        key = f'{word}|{self.path}|{self.line}|{self.old_line}|{self.new_line}'
        return int(hashlib.sha256(key.encode()).hexdigest()[:13], 16) / 16 ** 13

    def difference(self):
        return f'{self.path}\n- {self.old_line}\n+ {self.new_line}'

    def __str__(self):
        return f'{self.path}:{self.line}  {self.change}'


def mutants_of(path, text):
    changes = {'number': other_number, 'operator': OPERATORS.get, 'name': NAMES.get, 'member': MEMBERS.get}
    for token in TOKEN.finditer(text):
        new = changes[token.lastgroup](token[0]) if token.lastgroup in changes else None
        if new is not None:
            yield Mutant(path, text, token, new)


def run(command, **options):
    return subprocess.run([str(word) for word in command], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options)


def copy_project(tree):
    """Makes a folder hold what the project's has, and touches nothing that is the same already."""
    listed = run(['git', '-C', PROJECT, 'ls-files', '-co', '--exclude-standard', '-z'])
    wanted = {name for name in listed.stdout.split('\0') if name and (PROJECT / name).is_file()}
    for name in wanted:
        source, copy = PROJECT / name, tree / name
        if not copy.is_file() or copy.read_bytes() != source.read_bytes():
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, copy)
    for path in tree.rglob('*'):
        if path.is_file() and str(path.relative_to(tree)) not in wanted:
            path.unlink()


def ctest(*options):
    """Runs tests, never as root: a mutant could replace /dev/null by a file."""
    user = {}
    if os.geteuid() == 0:
        user = {'user': NOBODY, 'group': NOBODY, 'extra_groups': []}
        (BUILD / 'Testing').mkdir(exist_ok=True)
        for path in [BUILD / 'Testing', *(BUILD / 'Testing').rglob('*'), BUILD / 'tests', BUILD / 'bin']:
            os.chown(path, NOBODY, NOBODY)
    return run(['ctest', '--test-dir', BUILD, '-LE', SKIPPED_LABELS, *options], **user,
               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY)))


class Build:
    """The clean build, and which test runs which program."""

    def __init__(self, jobs):
        self.ninja = ['ninja', '-C', BUILD, '-j', jobs]
        self.everything = [*self.ninja, 'all', 'reader_suites']  # suites of what readers change are not in all
        self.jobs = jobs
        copy_project(TREE)
        configured = run(['cmake', '-S', TREE, '-B', BUILD, '-G', 'Ninja', '-D', 'CMAKE_BUILD_TYPE=Release',
                          '-D', 'CMAKE_CXX_FLAGS_RELEASE=-O1',
                          '-D', 'CMAKE_SUPPRESS_REGENERATION=ON'])  # else Ninja plans nothing before it has asked CMake
        if configured.returncode != 0:
            sys.exit(configured.stdout + 'error: cmake failed (mutation testing needs CMake and Ninja)')
        print('Building and testing without a change; the first time takes minutes', flush=True)
        if subprocess.run([str(word) for word in self.everything], check=False).returncode != 0:
            sys.exit('error: the project does not build')
        # Some scripts need more than this build, or a user with rights: what fails now tells nothing.
        self.left_out = re.findall(FAILED, ctest('-j', jobs).stdout)
        print('Left out, since they fail without a change (of suites, mutants survive that they would find):',
              *self.left_out or ['none'], flush=True)
        self.program_of = {}  # test -> path in the build
        for test in json.loads(ctest('--show-only=json-v1').stdout)['tests']:
            program = Path(test.get('command', ['/'])[0])
            if program.is_relative_to(BUILD) and test['name'] not in self.left_out:
                self.program_of[test['name']] = str(program.relative_to(BUILD))

    def verdict(self, mutant):
        """'killed by NAME', 'SURVIVED', 'did not compile', 'not built here' or 'the same program'."""
        copy = TREE / mutant.path
        text = copy.read_text()
        copy.write_text(text[:mutant.start] + mutant.new + text[mutant.end:])
        planned = run([*self.everything, '-n']).stdout
        stale = re.findall(r'(?:library|executable) (\S+)$', planned, re.M)
        before = {name: (BUILD / name).read_bytes() for name in stale}
        try:
            return self.judged(mutant, before) if stale else 'not built here'  # a file for another system
        finally:
            copy.write_text(text)
            run([*self.ninja, *(name for name in stale if (BUILD / name).read_bytes() != before[name])])

    def judged(self, mutant, before):
        """Builds and runs suite by suite, the file's own first; then everything."""
        own = 'test_' + Path(mutant.path).stem
        suites = [test for test, program in self.program_of.items() if program in before]
        for test in sorted(suites, key=lambda name: name != own):
            program = self.program_of[test]
            if run([*self.ninja, program]).returncode != 0:
                return 'did not compile'
            if (BUILD / program).read_bytes() != before[program] and self.fails('-R', f'^{re.escape(test)}$'):
                return 'killed by ' + test
        if run(self.everything).returncode != 0:
            return 'did not compile'
        if all((BUILD / name).read_bytes() == bytes_before for name, bytes_before in before.items()):
            return 'the same program'
        done = '|'.join(map(re.escape, [*self.program_of, *self.left_out]))
        scripts = self.fails('-E', f'^({done})$', '-j', self.jobs)
        return 'killed by ' + scripts if scripts else 'SURVIVED'

    def fails(self, *which):
        """The first test that fails twice, by chance alone it does not count; None if all pass."""
        done = ctest(*which, '--timeout', 120, '--stop-on-failure')
        return next((name for name in re.findall(FAILED, done.stdout)
                     if ctest('-R', f'^{re.escape(name)}$', '--timeout', 120).returncode != 0), None)


def read_equivalent():
    """The differences in equivalent.txt, whose blocks are a path, lines with - and +, then the reason."""
    text = re.sub(r'^#.*\n', '', (PROJECT / 'tests/mutation/equivalent.txt').read_text(), flags=re.M)
    return {re.match(r'.*(?:\n[-+] .*)*', block.strip())[0] for block in re.split(r'\n\s*\n', text)}


def chosen_mutants(options):
    names = sorted(str(path.relative_to(PROJECT)) for path in (PROJECT / 'common').rglob('*.[hc]pp'))
    names = [name for name in names if name not in SKIPPED_FILES and any(fnmatch.fnmatch(name, '*' + glob) for glob in options.files)]
    if not names:
        sys.exit('error: no such file in common/')
    mutants = [mutant for name in names for mutant in mutants_of(name, (PROJECT / name).read_text())]
    if options.only:
        return [m for m in mutants if any(f'/{m.path}:{m.line}'.endswith('/' + place) for place in options.only)]
    # Coefficients are much the same, and would be most of the sample.
    return sorted((m for m in mutants if not m.of_a_table or m.chance('share') < 0.1), key=lambda m: m.chance(options.seed))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('--seed', type=int, default=1, help='another number chooses other tokens')
    parser.add_argument('--count', type=int, default=64, help='how many that compile')
    parser.add_argument('--files', nargs='+', metavar='GLOB', default=['*'], help='only in these, such as scene/*.hpp')
    parser.add_argument('--only', nargs='+', metavar='FILE:LINE', help='all mutants of these lines')
    parser.add_argument('--list', action='store_true', help='show the mutants and stop')
    parser.add_argument('--jobs', type=int, default=2, help='programs compiled and run at once')
    options = parser.parse_args()
    mutants = chosen_mutants(options)
    if options.list:
        print('\n'.join(map(str, mutants if options.only else mutants[:options.count])))
        return
    build, equivalent = Build(options.jobs), read_equivalent()
    counts = dict.fromkeys(('killed', 'SURVIVED', 'the same program', 'equivalent', 'did not compile', 'not built here'), 0)
    survivors = WORK / 'survivors.txt'
    survivors.write_text('')
    try:
        for mutant in mutants:
            tried = sum(counts.values()) - counts['did not compile'] - counts['not built here']
            if tried >= options.count and not options.only:
                break
            began = time.monotonic()
            verdict = 'equivalent' if mutant.difference() in equivalent else build.verdict(mutant)
            counts[next(word for word in counts if verdict.startswith(word))] += 1
            print(f'[{tried + 1}/{options.count}] {mutant}  {verdict} ({time.monotonic() - began:.0f} s)', flush=True)
            if verdict == 'SURVIVED':
                with survivors.open('a') as file:
                    file.write(f'# {mutant}\n{mutant.difference()}\n\n')
    except KeyboardInterrupt:
        print('\nstopped; what was done counts')
    print(', '.join(f'{count} {word}' for word, count in counts.items()))


if __name__ == '__main__':
    main()
