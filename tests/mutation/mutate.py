#!/usr/bin/env python3
"""Mutation testing of common/: changes one token at a time and sees whether a test notices.

Works in a copy of the project (build/mutation/tree) with a build of its own; needs Ninja. Writes
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
TREE, BUILD, CLEAN = WORK / 'tree', WORK / 'build', WORK / 'clean'
SKIPPED_FILES = {'common/tools/fit_kernels.cpp'}
# What judges the text of the project, or builds it once more, and what measures time.
SKIPPED_LABELS = '^(bench|closure|grade|learn|mutation|pages|steps|exhaustive|extremes)$'
# in ctest's report
FAILED = r'Test +#\d+: (\S+) \.*\** *(?:Failed|Not Run|Exception|Subprocess|Timeout)'
NOBODY = 65533  # not the 65534 that tests become themselves
MOST_MEMORY = 6 << 30

# --- Tokens -----------------------------------------------------------------------------------

TOKEN = re.compile(
    r'(?P<comment>//[^\n]*|/\*.*?\*/)'
    r'|(?P<string>(?:u8|[uUL])?R"(?P<mark>[^(]*)\(.*?\)(?P=mark)"|(?:u8|[uUL])?"(?:\\.|[^"\\\n])*")'
    r"|(?P<char>'(?:\\.|[^'\\\n])*')"
    r"|(?P<number>0[xX][0-9a-fA-F.]+(?:[pP][+-]?\d+)?[uUlLfF]*"
    r"|(?:\d[\d']*\.?\d*|\.\d+)(?:[eE][+-]?\d+)?[uUlLfF]*)"
    r'|(?P<name>[A-Za-z_]\w*)'
    r'|(?P<operator><<=|>>=|<=>|->\*?|::|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\|'
    r'|[-+*/%&|^]=|[-+*/%<>=!&|^~?:;,.(){}\[\]])',
    re.S)
PREPROCESSOR = re.compile(r'^[ \t]*#(?:[^\n\\]|\\.)*(?:\\\n(?:[^\n\\]|\\.)*)*', re.M)


class Token:
    def __init__(self, kind, text, start):
        self.kind, self.text, self.start, self.end = kind, text, start, start + len(text)


def tokens_of(text):
    """All tokens but comments and preprocessor lines, between two empty ones; each knows if it is
    inside of a function."""
    blank = PREPROCESSOR.sub(lambda found: re.sub(r'[^\n]', ' ', found[0]), text)
    words = [Token(found.lastgroup.replace('mark', 'string'), found[0], found.start())
             for found in TOKEN.finditer(blank) if found.lastgroup != 'comment']
    tokens = [Token('', '', 0), *words, Token('', '', len(text))]
    braces = []  # for each open brace: is it the body of a type or of a namespace?
    for i, token in enumerate(tokens):
        if token.text == '}' and braces:
            braces.pop()
        token.in_function = bool(braces) and not braces[-1]
        if token.text == '{':
            start = i
            while start > 0 and tokens[start - 1].text not in (';', '{', '}', ')'):
                start -= 1
            before = [''] + [word.text for word in tokens[start:i]]
            braces.append(any(word in ('namespace', 'struct', 'union', 'enum') or word == 'class'
                              and last not in ('<', ',')
                              for last, word in zip(before, before[1:])))
    return tokens


def closing(tokens, i):
    """The place of the bracket that closes the one at `i`."""
    depth = 0
    for k in range(i, len(tokens)):
        depth += (tokens[k].text in OPENING) - (tokens[k].text in CLOSING)
        if depth == 0 and tokens[k].text in CLOSING:
            return k
    return len(tokens) - 1


def behind(tokens, k):
    """The place behind the token at `k`, or behind what its bracket holds."""
    return closing(tokens, k) + 1 if tokens[k].text in OPENING else k + 1


# --- Changes of a token -------------------------------------------------------------------------

BINARY = {'+': '-', '-': '+', '*': '/', '/': '*', '%': '*', '<': '<=', '<=': '<', '>': '>=',
          '>=': '>',
          '==': '!=', '!=': '==', '&&': '||', '||': '&&', '+=': '-=', '-=': '+=', '*=': '/=',
          '/=': '*=',
          '<<': '>>', '>>': '<<', '&': '|', '|': '&', '^': '&', '<<=': '>>=', '>>=': '<<=',
          '|=': '&=', '&=': '|=', '^=': '|='}
NAMES = {'true': 'false', 'false': 'true', 'min': 'max', 'max': 'min', 'sin': 'cos', 'cos': 'sin',
         'floor': 'ceil', 'ceil': 'floor'}
MEMBERS = {'x': 'y', 'y': 'z', 'z': 'x', 'u': 'v', 'v': 'u', 'r': 'g', 'g': 'b', 'b': 'r', 'a': 'b',
           'width': 'height', 'height': 'width', 'row': 'column', 'column': 'row', 'high': 'low',
           'low': 'high', 'first': 'second', 'second': 'first', 'front': 'back', 'back': 'front'}
ASSIGNMENTS = {'=', '+=', '-=', '*=', '/=', '%=', '|=', '&=', '^=', '<<=', '>>='}
OPENING, CLOSING = ('(', '[', '{'), (')', ']', '}')
NOT_A_CALL = {'if', 'for', 'while', 'switch', 'return', 'sizeof', 'catch', 'alignas', 'decltype',
              'noexcept', 'requires', 'static_assert', 'constexpr', 'operator', 'defined'}


def other_number(text):
    """n + 1 for a whole number, one power of two more for a hexadecimal fraction, half of any other
    number."""
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
    value = float(body)
    return (repr(value / 2) if value != 0 else '1.0') + suffix


def change_of(text, tokens, i):
    """The change of the token at `i`: (kind, start, end, new text), or None."""
    token, before, after = tokens[i], tokens[i - 1], tokens[i + 1]
    spaced_behind = text[token.end:token.end + 1].isspace()
    kind = new = None
    if token.kind == 'number':
        kind, new = 'constant', other_number(token.text)
    elif token.kind == 'string' and len(token.text) > 2 and not token.text.endswith(')"'):
        kind, new = 'string', token.text[:-1] + '~"'
    elif (token.kind == 'name' and before.text in ('.', '->') and after.text != '('
          and token.text in MEMBERS):
        kind, new = 'member', MEMBERS[token.text]
    elif token.kind == 'name' and before.text not in ('.', '->') and token.text in NAMES:
        kind, new = 'name', NAMES[token.text]
    elif token.kind == 'name':
        has_condition = token.text in ('if', 'while') and after.text == '('
        return negation(text, tokens, i + 1) if has_condition else removal(tokens, i)
    elif token.text in BINARY and spaced_behind and text[token.start - 1:token.start].isspace():
        kind, new = 'operator', BINARY[token.text]
    elif token.text in ('++', '--'):
        kind, new = 'operator', '--' if token.text == '++' else '++'
    elif token.text in ('-', '!') and not spaced_behind and before.text != 'operator':
        kind, new = 'operator', ''
    elif token.text == '(' and before.kind == 'name':
        return swap(text, tokens, i)
    return kind and (kind, token.start, token.end, new)


def negation(text, tokens, i):
    """if (x) becomes if (!(x)); what comes before a ; in the brackets stays."""
    end = closing(tokens, i)
    first = max([i, *(k for k in range(i + 1, end) if tokens[k].text == ';')]) + 1
    if first >= end or any(token.text == '{' for token in tokens[first:end]):
        return None
    start, stop = tokens[first].start, tokens[end].start
    if first == i + 1 < end - 1 and tokens[first].kind == tokens[first + 1].kind == 'name':
        return None  # it declares something
    return 'condition', start, stop, '!(' + text[start:stop] + ')'


def removal(tokens, i):
    """Without the call or assignment that begins at `i`."""
    begins = tokens[i - 1].text in (';', '{', '}', ')', 'else')
    if not (tokens[i].in_function and begins) or tokens[i].text in NOT_A_CALL:
        return None
    k = i + 1
    while tokens[k].text in ('.', '->', '::', '['):
        k = behind(tokens, k) if tokens[k].text == '[' else k + 2
    if tokens[k].text not in ASSIGNMENTS | {'(', '++', '--'}:
        return None
    while tokens[k].text != ';':
        k = behind(tokens, k)
        if tokens[k].text in CLOSING:
            return None
    return 'removal', tokens[i].start, tokens[k].end, ';'


def swap(text, tokens, i):
    """The first two arguments of the call at `i` change places."""
    end = closing(tokens, i)
    commas, k = [i], i + 1
    while k < end:
        commas += [k] * (tokens[k].text == ',')
        k = behind(tokens, k)
    if not tokens[i].in_function or tokens[i - 1].text in NOT_A_CALL or len(commas) < 2:
        return None
    (a, b), (c, d) = ((tokens[first + 1].start, tokens[last - 1].end)
                      for first, last in zip(commas, [*commas[1:3], end][:2]))
    return None if text[a:b] == text[c:d] else ('swap', a, d, text[c:d] + text[b:c] + text[a:b])


class Mutant:
    def __init__(self, path, text, kind, start, end, new):
        self.path, self.kind, self.start, self.end, self.new = path, kind, start, end, new
        self.line = text.count('\n', 0, start) + 1
        first, last = text.rfind('\n', 0, start) + 1, (text + '\n').find('\n', end)
        self.old_lines = stripped(text[first:last])
        self.new_lines = stripped(text[first:start] + new + text[end:last])
        self.change = shortened(text[start:end]) + ' -> ' + (shortened(new) or 'nothing')
        same_before = text.count(text[first:last], 0, first)
        self.key = '|'.join([path, *self.old_lines, *self.new_lines, str(same_before)])

    def chance(self, word):
        """A number from 0 to 1 that depends on the change and the word alone."""
        return int(hashlib.sha256(f'{word}|{self.key}'.encode()).hexdigest()[:13], 16) / 16 ** 13

    def share(self):
        """How many of its kind are tried: strings, coefficients and letters are much the same, and
        would be most of the sample."""
        of_a_table = self.kind == 'constant' and self.old_lines[0].count(',') >= 5
        return 0.05 if self.kind == 'string' else 0.1 if of_a_table else 1

    def difference(self):
        return '\n'.join([self.path, *('- ' + line for line in self.old_lines),
                          *('+ ' + line for line in self.new_lines)])

    def __str__(self):
        return f'{self.path}:{self.line}  {self.change}  ({self.kind})'


def stripped(lines):
    return [line.strip() for line in lines.split('\n') if line.strip()]


def shortened(text):
    one_line = ' '.join(text.split())
    return one_line if len(one_line) <= 60 else one_line[:57] + '...'


def mutants_of(path, text):
    tokens = tokens_of(text)
    judged = set()  # by the compiler alone
    for i, token in enumerate(tokens):
        if token.text == 'static_assert':
            judged.update(range(i, closing(tokens, i + 1) + 1))
    changes = [change_of(text, tokens, i) for i in range(1, len(tokens) - 1) if i not in judged]
    return [Mutant(path, text, *change) for change in changes if change
            and text[change[1]:change[2]] != change[3]]


# --- The copy of the project and its build ------------------------------------------------------

def run(command, **options):
    return subprocess.run([str(word) for word in command], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, **options)


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


def names(path, headers):
    """Whether a file includes one of the headers by its name."""
    text = path.read_text()
    return any(f'#include "{header}"' in text for header in headers)


def is_clean(name):
    return (BUILD / name).read_bytes() == (CLEAN / name).read_bytes()


def ctest(*options):
    """Runs tests, never as root: a mutant could replace /dev/null by a file."""
    user = {}
    if os.geteuid() == 0:
        user = {'user': NOBODY, 'group': NOBODY, 'extra_groups': []}
        (BUILD / 'Testing').mkdir(exist_ok=True)
        for path in [BUILD / 'Testing', *(BUILD / 'Testing').rglob('*'), BUILD / 'tests',
                     BUILD / 'bin']:
            os.chown(path, NOBODY, NOBODY)
    return run(['ctest', '--test-dir', BUILD, '-LE', SKIPPED_LABELS, *options], **user,
               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, 2 * (MOST_MEMORY,)))


class Build:
    """The clean build: which test runs which program, and how long each takes to compile."""

    def __init__(self, jobs, near):
        self.near = near
        self.ninja = ['ninja', '-C', BUILD, '-j', jobs]
        # suites of what readers change are not in all
        self.everything = [*self.ninja, 'all', 'reader_suites']
        self.jobs = jobs
        copy_project(TREE)
        configured = run(['cmake', '-S', TREE, '-B', BUILD, '-G', 'Ninja', '-D',
                          'CMAKE_BUILD_TYPE=Release', '-D', 'CMAKE_CXX_FLAGS_RELEASE=-O1',
                          # else Ninja plans nothing before it has asked CMake
                          '-D', 'CMAKE_SUPPRESS_REGENERATION=ON'])
        if configured.returncode != 0:
            sys.exit(configured.stdout
                     + 'error: cmake failed (mutation testing needs CMake and Ninja)')
        print('Building and testing without a change; the first time takes minutes', flush=True)
        if subprocess.run([str(word) for word in self.everything], check=False).returncode != 0:
            sys.exit('error: the project does not build')
        # Some scripts need more than this build, or a user with rights: what fails now tells
        # nothing.
        self.left_out = re.findall(FAILED, ctest('-j', jobs).stdout)
        print('Left out, since they fail without a change (of suites, mutants survive that they '
              'would find):', *self.left_out or ['none'], flush=True)
        self.program_of = {}  # test -> path in the build
        for test in json.loads(ctest('--show-only=json-v1').stdout)['tests']:
            program = Path(test.get('command', ['/'])[0])
            if program.is_relative_to(BUILD) and test['name'] not in self.left_out:
                self.program_of[test['name']] = str(program.relative_to(BUILD))
        self.compiled_in = {}  # test -> milliseconds
        for line in (BUILD / '.ninja_log').read_text().splitlines()[1:]:
            start, end, _, output, _ = line.split('\t')
            name = re.search(r'tests/CMakeFiles/(\w+)\.dir/', output)
            if name:
                self.compiled_in[name[1]] = self.compiled_in.get(name[1], 0) + int(end) - int(start)

    def stale(self):
        """What a build would make again, as Ninja says."""
        planned = run([*self.everything, '-n']).stdout
        return re.findall(r'(?:object|library|executable) (\S+)$', planned, re.M)

    def verdict(self, mutant):
        """'killed by NAME', 'SURVIVED', 'did not compile', 'not built here' or 'the same
        program'."""
        copy = TREE / mutant.path
        text, times = copy.read_text(), copy.stat()
        copy.write_text(text[:mutant.start] + mutant.new + text[mutant.end:])
        stale = self.stale()
        kept = [*stale, '.ninja_log', '.ninja_deps']
        for name in kept:
            (CLEAN / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(BUILD / name, CLEAN / name)
        try:
            # a file for another system
            return self.judged(mutant, stale) if stale else 'not built here'
        finally:
            copy.write_text(text)
            os.utime(copy, ns=(times.st_atime_ns, times.st_mtime_ns))
            for name in kept:
                shutil.copy2(CLEAN / name, BUILD / name)

    def judged(self, mutant, stale):
        """Builds and runs suites, the file's own first, then those that name its header, or one
        that names it, then its room's, then the cheapest; then everything, unless only the nearest
        are asked."""
        room = Path(mutant.path).parent.relative_to('common')
        sources = {path.stem: path for path in (TREE / 'tests').rglob('test_*.cpp')}
        header = str(Path(mutant.path).with_suffix('.hpp').relative_to('common'))
        by_others = {str(path.relative_to(TREE / 'common'))
                     for path in (TREE / 'common').rglob('*.hpp') if names(path, {header})}

        def steps(test):  # from its source to the header
            source = sources.get(test)
            return 3 if not source else 1 if names(source, {header}) else 2 if names(
                source, by_others) else 3
        suites = sorted((test for test, program in self.program_of.items() if program in stale),
                        key=lambda test: (test != 'test_' + Path(mutant.path).stem, steps(test),
                                          test in sources
                                          and sources[test].parent != TREE / 'tests' / room,
                                          self.compiled_in.get(test, 0)))
        asked = suites[:self.near] if self.near else suites
        for first in range(0, len(asked), self.jobs):
            batch = asked[first:first + self.jobs]
            if run([*self.ninja, *(self.program_of[test] for test in batch)]).returncode != 0:
                return 'did not compile'
            for test in batch:
                if not is_clean(self.program_of[test]) and self.fails('-R', f'^{re.escape(test)}$'):
                    return 'killed by ' + test
        if len(asked) < len(suites):
            return 'SURVIVED'
        if run(self.everything).returncode != 0:
            return 'did not compile'
        if all(is_clean(name) for name in stale if '.dir/' not in name):
            return 'the same program'
        done = '|'.join(map(re.escape, [*self.program_of, *self.left_out]))
        scripts = self.fails('-E', f'^({done})$', '-j', self.jobs)
        return 'killed by ' + scripts if scripts else 'SURVIVED'

    def fails(self, *which):
        """The first test that fails twice, by chance alone it does not count; None if all pass."""
        done = ctest(*which, '--timeout', 120, '--stop-on-failure')
        return next((name for name in re.findall(FAILED, done.stdout)
                     if ctest('-R', f'^{re.escape(name)}$', '--timeout',
                              120).returncode != 0), None)


def read_equivalent():
    """The differences in equivalent.txt, whose blocks are a path, lines with - and +, then the
    reason."""
    text = re.sub(r'^#.*\n', '', (PROJECT / 'tests/mutation/equivalent.txt').read_text(),
                  flags=re.M)
    return {re.match(r'.*(?:\n[-+] .*)*', block.strip())[0] for block in re.split(r'\n\s*\n', text)}


def all_mutants(globs):
    names = sorted(str(path.relative_to(PROJECT))
                   for path in (PROJECT / 'common').rglob('*.[hc]pp'))
    names = [name for name in names if name not in SKIPPED_FILES
             and any(fnmatch.fnmatch(name, '*' + glob) for glob in globs)]
    if not names:
        sys.exit('error: no such file in common/')
    return [m for name in names for m in mutants_of(name, (PROJECT / name).read_text())]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n\n')[0])
    parser.add_argument('--seed', type=int, default=1, help='another number chooses other tokens')
    parser.add_argument('--count', type=int, default=64, help='how many that compile')
    parser.add_argument('--files', nargs='+', metavar='GLOB', default=['*'],
                        help='only in these, such as scene/*.hpp')
    parser.add_argument('--only', nargs='+', metavar='FILE:LINE', help='all mutants of these lines')
    parser.add_argument('--list', action='store_true', help='show the mutants and stop')
    parser.add_argument('--near', type=int, default=0, metavar='SUITES',
                        help='where more suites include the file, run so many: its own, those '
                        'that name its header, the cheapest; mutants then survive that others '
                        'would find')
    parser.add_argument('--jobs', type=int, default=2, help='programs compiled and run at once')
    options = parser.parse_args()
    mutants = all_mutants(options.files)
    if options.only:
        mutants = [m for m in mutants
                   if any(f'/{m.path}:{m.line}'.endswith('/' + place) for place in options.only)]
    else:
        mutants = sorted((m for m in mutants if m.chance('share') < m.share()),
                         key=lambda m: m.chance(options.seed))
    if options.list:
        print('\n'.join(map(str, mutants if options.only else mutants[:options.count])))
        return
    build, equivalent = Build(options.jobs, options.near), read_equivalent()
    counts = dict.fromkeys(('killed', 'SURVIVED', 'the same program', 'equivalent',
                            'did not compile', 'not built here'), 0)
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
            print(f'[{tried + 1}/{options.count}] {mutant}  {verdict} '
                  f'({time.monotonic() - began:.0f} s)', flush=True)
            if verdict == 'SURVIVED':
                with survivors.open('a') as file:
                    file.write(f'# {mutant}\n{mutant.difference()}\n\n')
    except KeyboardInterrupt:
        print('\nstopped; what was done counts')
    print(', '.join(f'{count} {word}' for word, count in counts.items()))


if __name__ == '__main__':
    main()
