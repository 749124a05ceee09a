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
FAILED = r'Test +#\d+: (\S+) \.*\** *(?:Failed|Not Run|Exception|Subprocess|Timeout)'  # in ctest's report
NOBODY = 65533  # not the 65534 that tests become themselves
MOST_MEMORY = 6 << 30

# --- Tokens -----------------------------------------------------------------------------------

TOKEN = re.compile(
    r'(?P<comment>//[^\n]*|/\*.*?\*/)'
    r'|(?P<string>(?:u8|[uUL])?R"(?P<mark>[^(]*)\(.*?\)(?P=mark)"|(?:u8|[uUL])?"(?:\\.|[^"\\\n])*")'
    r"|(?P<char>'(?:\\.|[^'\\\n])*')"
    r"|(?P<number>0[xX][0-9a-fA-F.]+(?:[pP][+-]?\d+)?[uUlLfF]*|(?:\d[\d']*\.?\d*|\.\d+)(?:[eE][+-]?\d+)?[uUlLfF]*)"
    r'|(?P<name>[A-Za-z_]\w*)'
    r'|(?P<operator><<=|>>=|<=>|->\*?|::|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|[-+*/%<>=!&|^~?:;,.(){}\[\]])',
    re.S)
PREPROCESSOR = re.compile(r'^[ \t]*#(?:[^\n\\]|\\.)*(?:\\\n(?:[^\n\\]|\\.)*)*', re.M)


class Token:
    def __init__(self, kind, text, start):
        self.kind, self.text, self.start = kind, text, start
        self.end = start + len(text)
        self.in_function = False

def tokens_of(text):
    """All tokens but comments and preprocessor lines; each knows if it is inside of a function."""
    blank = PREPROCESSOR.sub(lambda found: re.sub(r'[^\n]', ' ', found[0]), text)
    tokens = [Token(found.lastgroup if found.lastgroup != 'mark' else 'string', found[0], found.start())
              for found in TOKEN.finditer(blank) if found.lastgroup != 'comment']
    braces = []  # for each open brace: is it the body of a type or of a namespace?
    for i, token in enumerate(tokens):
        if token.text == '}' and braces:
            braces.pop()
        token.in_function = bool(braces) and not braces[-1]
        if token.text == '{':
            braces.append(opens_type(tokens, i))
    return tokens


def opens_type(tokens, i):
    """Is the brace at `i` that of a namespace, a struct and the like?"""
    start = i
    while start > 0 and tokens[start - 1].text not in (';', '{', '}', ')'):
        start -= 1
    words = tokens[start:i]
    for k, word in enumerate(words):
        before = words[k - 1].text if k > 0 else ''
        if word.text in ('namespace', 'struct', 'union', 'enum'):
            return True
        if word.text == 'class' and before not in ('<', ','):
            return True
    return False


def closing(tokens, i):
    """The place of the bracket that closes the one at `i`."""
    depth = 0
    for k in range(i, len(tokens)):
        if tokens[k].text in ('(', '[', '{'):
            depth += 1
        elif tokens[k].text in (')', ']', '}'):
            depth -= 1
            if depth == 0:
                return k
    return len(tokens) - 1


# --- Changes of a token -------------------------------------------------------------------------

BINARY = {'+': '-', '-': '+', '*': '/', '/': '*', '%': '*', '<': '<=', '<=': '<', '>': '>=', '>=': '>',
          '==': '!=', '!=': '==', '&&': '||', '||': '&&', '+=': '-=', '-=': '+=', '*=': '/=', '/=': '*=',
          '<<': '>>', '>>': '<<', '&': '|', '|': '&', '^': '&', '<<=': '>>=', '>>=': '<<=', '|=': '&=',
          '&=': '|=', '^=': '|='}
NAMES = {'true': 'false', 'false': 'true', 'min': 'max', 'max': 'min', 'sin': 'cos', 'cos': 'sin',
         'floor': 'ceil', 'ceil': 'floor'}
MEMBERS = {'x': 'y', 'y': 'z', 'z': 'x', 'u': 'v', 'v': 'u', 'r': 'g', 'g': 'b', 'b': 'r', 'a': 'b',
           'width': 'height', 'height': 'width', 'row': 'column', 'column': 'row', 'high': 'low',
           'low': 'high', 'first': 'second', 'second': 'first', 'front': 'back', 'back': 'front'}
ASSIGNMENTS = {'=', '+=', '-=', '*=', '/=', '%=', '|=', '&=', '^=', '<<=', '>>='}
NOT_A_CALL = {'if', 'for', 'while', 'switch', 'return', 'sizeof', 'catch', 'alignas', 'decltype',
              'noexcept', 'requires', 'static_assert', 'constexpr', 'operator', 'defined'}


def other_number(text):
    """n + 1 for a whole number, 0 for 1 and half of any other number."""
    whole_hex = text.lower().startswith('0x') and 'p' not in text.lower()
    body = text.rstrip('uUlL' if whole_hex else 'uUlLfF')
    suffix = text[len(body):]
    lower = body.lower()
    if lower.startswith('0x'):
        if 'p' in lower:
            mantissa, exponent = re.split('[pP]', body)
            return f'{mantissa}p{int(exponent) + 1}{suffix}'
        return f'{int(body, 16) + 1:#x}{suffix}'
    if re.fullmatch(r"[\d']+", body):
        digits = body.replace("'", '')
        value = int(digits, 8) if len(digits) > 1 and digits[0] == '0' else int(digits)
        return f'{value + 1}{suffix}' if len(digits) == 1 or digits[0] != '0' else f'0{value + 1:o}{suffix}'
    value = float(body)
    return (repr(value / 2) if value != 0 else '1.0') + suffix


def change_of(text, tokens, i):
    """The change of the token at `i`: (kind, start, end, new text), or None."""
    token = tokens[i]
    before = tokens[i - 1] if i > 0 else None
    after = tokens[i + 1] if i + 1 < len(tokens) else None
    spaced = text[token.start - 1:token.start].isspace() and text[token.end:token.end + 1].isspace()
    if token.kind == 'number':
        return 'constant', token.start, token.end, other_number(token.text)
    if token.kind == 'string' and len(token.text) > 2 and not token.text.endswith(')"'):
        return 'string', token.start, token.end, token.text[:-1] + '~"'
    if token.kind == 'name':
        if before is not None and before.text in ('.', '->'):
            if after is not None and after.text != '(' and token.text in MEMBERS:
                return 'member', token.start, token.end, MEMBERS[token.text]
        elif token.text in NAMES:
            return 'name', token.start, token.end, NAMES[token.text]
        if token.text in ('if', 'while') and after is not None and after.text == '(':
            return negation(text, tokens, i + 1)
        return removal(text, tokens, i)
    if token.kind == 'operator':
        if token.text in BINARY and spaced:
            return 'operator', token.start, token.end, BINARY[token.text]
        if token.text in ('++', '--'):
            return 'operator', token.start, token.end, '--' if token.text == '++' else '++'
        if token.text in ('-', '!') and not text[token.end:token.end + 1].isspace():
            if before is not None and before.text != 'operator':
                return 'operator', token.start, token.end, ''
        if token.text == '(' and before is not None and before.kind == 'name':
            return swap(text, tokens, i)
    return None


def negation(text, tokens, i):
    """if (x) becomes if (!(x)); what comes before a ; in the brackets stays."""
    end = closing(tokens, i)
    first = i + 1
    for k in range(i + 1, end):
        if tokens[k].text == ';':
            first = k + 1
    if first >= end or any(token.text == '{' for token in tokens[first:end]):
        return None
    start, stop = tokens[first].start, tokens[end].start
    if first == i + 1 and end - first > 1 and tokens[first].kind == 'name' and tokens[first + 1].kind == 'name':
        return None  # it declares something
    return 'condition', start, stop, '!(' + text[start:stop] + ')'


def removal(text, tokens, i):
    """Without the call or assignment that begins at `i`."""
    if not tokens[i].in_function or i == 0 or tokens[i].text in NOT_A_CALL:
        return None
    if tokens[i - 1].text not in (';', '{', '}', ')', 'else'):
        return None
    if tokens[i - 1].text == ')' and i + 1 < len(tokens) and tokens[i + 1].text in ('(', '{'):
        pass  # if (...) call();
    k = i + 1
    while k < len(tokens) and tokens[k].text in ('.', '->', '::', '['):
        k = closing(tokens, k) + 1 if tokens[k].text == '[' else k + 2
    if k >= len(tokens) or tokens[k].text not in ASSIGNMENTS | {'(', '++', '--'}:
        return None
    while k < len(tokens) and tokens[k].text != ';':
        k = closing(tokens, k) + 1 if tokens[k].text in ('(', '[', '{') else k + 1
        if k < len(tokens) and tokens[k].text in ('}', ')', ']'):
            return None
    if k >= len(tokens):
        return None
    return 'removal', tokens[i].start, tokens[k].end, ';'


def swap(text, tokens, i):
    """The first two arguments of the call at `i` change places."""
    if not tokens[i].in_function or tokens[i - 1].text in NOT_A_CALL:
        return None
    end = closing(tokens, i)
    parts, first, k = [], i + 1, i + 1
    while k <= end and len(parts) < 2:
        if tokens[k].text in ('(', '[', '{'):
            k = closing(tokens, k) + 1
            continue
        if k == end or tokens[k].text == ',':
            if k == first:
                return None
            parts.append((tokens[first].start, tokens[k - 1].end))
            first = k + 1
        k += 1
    if len(parts) < 2:
        return None
    (a, b), (c, d) = parts
    if text[a:b] == text[c:d]:
        return None
    return 'swap', a, d, text[c:d] + text[b:c] + text[a:b]


def inside_static_assert(tokens):
    """The places that only the compiler judges."""
    inside = set()
    for i, token in enumerate(tokens):
        if token.text == 'static_assert':
            inside.update(range(i, closing(tokens, i + 1) + 1))
    return inside


class Mutant:
    def __init__(self, path, text, kind, start, end, new):
        self.path, self.kind, self.start, self.end, self.new = path, kind, start, end, new
        self.line = text.count('\n', 0, start) + 1
        first = text.rfind('\n', 0, start) + 1
        last = text.find('\n', end)
        last = len(text) if last < 0 else last
        self.old_lines = stripped(text[first:last])
        self.new_lines = stripped(text[first:start] + new + text[end:last])
        self.change = shortened(text[start:end]) + ' -> ' + (shortened(new) or 'nothing')
        same_before = text.count(text[first:last], 0, first)
        self.key = '|'.join([path, *self.old_lines, *self.new_lines, str(same_before)])

    def chance(self, word):
        """A number from 0 to 1 that depends on the change and the word alone."""
        return int(hashlib.sha256(f'{word}|{self.key}'.encode()).hexdigest()[:13], 16) / 16 ** 13

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
    judged = inside_static_assert(tokens)
    found = []
    for i in range(len(tokens)):
        change = None if i in judged else change_of(text, tokens, i)
        if change is not None and text[change[1]:change[2]] != change[3]:
            found.append(Mutant(path, text, *change))
    return found


def is_of_a_table(mutant):
    """A row of constants: tables of coefficients and letters would make up most of the sample."""
    return mutant.kind == 'constant' and mutant.old_lines[0].count(',') >= 5


def sample(mutants, seed):
    """The mutants in the order of the seed; few of strings and of tables, which are much the same."""
    kept = [m for m in mutants if m.chance('share') < (
        0.05 if m.kind == 'string' else 0.1 if is_of_a_table(m) else 1)]
    return sorted(kept, key=lambda m: m.chance(seed))


# --- The copy of the project and its build ------------------------------------------------------

def run(command, **options):
    return subprocess.run([str(word) for word in command], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, **options)


def copy_project():
    listed = run(['git', '-C', PROJECT, 'ls-files', '-co', '--exclude-standard', '-z'])
    wanted = {name for name in listed.stdout.split('\0') if name and (PROJECT / name).is_file()}
    for name in wanted:
        source, copy = PROJECT / name, TREE / name
        if not copy.is_file() or copy.read_bytes() != source.read_bytes():
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, copy)
    for path in TREE.rglob('*'):
        if path.is_file() and str(path.relative_to(TREE)) not in wanted:
            path.unlink()


def digest(path):
    return hashlib.sha256(path.read_bytes()).digest() if path.is_file() else b''


def ctest(*options):
    """Runs tests, never as root: a mutant could replace /dev/null by a file."""
    user = {}
    if os.geteuid() == 0:
        user = {'user': NOBODY, 'group': NOBODY, 'extra_groups': []}
        for path in [BUILD / 'Testing', *(BUILD / 'Testing').rglob('*'), BUILD / 'tests', BUILD / 'bin']:
            path.mkdir(exist_ok=True) if path == BUILD / 'Testing' else None
            os.chown(path, NOBODY, NOBODY)
    return run(['ctest', '--test-dir', BUILD, '-LE', SKIPPED_LABELS, *options], **user,
               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY)))


class Build:
    """The clean build: which test runs which program, and how long each takes to compile and to run."""

    def __init__(self, jobs):
        self.ninja = ['ninja', '-C', BUILD, '-j', jobs]
        self.everything = [*self.ninja, 'all', 'reader_suites']  # suites of what readers change are not in all
        self.jobs = jobs
        copy_project()
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
        print('Left out, since they fail without a change:', *self.left_out or ['none'], flush=True)
        suites = [name for name in self.left_out if name.startswith('test_')]
        if suites:
            print('warning: among them are suites, so mutants may survive that the tests do find:', *suites, flush=True)
        self.program_of = {}  # test -> path in the build
        for test in json.loads(ctest('--show-only=json-v1').stdout)['tests']:
            program = Path(test.get('command', ['/'])[0])
            if program.is_relative_to(BUILD) and test['name'] not in self.left_out:
                self.program_of[test['name']] = str(program.relative_to(BUILD))
        self.seconds = dict.fromkeys(self.program_of, 0.0)
        for line in (BUILD / 'Testing/Temporary/CTestCostData.txt').read_text().splitlines():
            name, *cost = line.split()
            if name in self.seconds and len(cost) == 2:
                self.seconds[name] = float(cost[1])
        for line in (BUILD / '.ninja_log').read_text().splitlines()[1:]:
            start, end, _, output, _ = line.split('\t')
            name = re.search(r'tests/CMakeFiles/(\w+)\.dir/', output)
            if name and name[1] in self.seconds:
                self.seconds[name[1]] += (int(end) - int(start)) / 1000

    def stale(self):
        """What a build would make again, as Ninja says."""
        planned = run([*self.everything, '-n']).stdout
        return re.findall(r'(?:object|library|executable) (\S+)$', planned, re.M)

    def verdict(self, mutant):
        """'killed by NAME', 'SURVIVED', 'did not compile', 'not built here' or 'the same program'."""
        copy = TREE / mutant.path
        text, times = copy.read_text(), copy.stat()
        copy.write_text(text[:mutant.start] + mutant.new + text[mutant.end:])
        stale = self.stale()
        kept = [*stale, '.ninja_log', '.ninja_deps']
        for name in kept:
            (CLEAN / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(BUILD / name, CLEAN / name)
        try:
            return self.judged(mutant, stale) if stale else 'not built here'  # a file for another system
        finally:
            copy.write_text(text)
            os.utime(copy, ns=(times.st_atime_ns, times.st_mtime_ns))
            for name in kept:
                shutil.copy2(CLEAN / name, BUILD / name)

    def judged(self, mutant, stale):
        """Builds and runs suite by suite, the file's own first, then the cheapest; then everything."""
        own = 'test_' + Path(mutant.path).stem
        suites = [test for test, program in self.program_of.items() if program in stale]
        for test in sorted(suites, key=lambda name: (name != own, self.seconds[name])):
            program = self.program_of[test]
            if run([*self.ninja, program]).returncode != 0:
                return 'did not compile'
            if digest(BUILD / program) != digest(CLEAN / program) and self.fails('-R', f'^{re.escape(test)}$'):
                return 'killed by ' + test
        if run(self.everything).returncode != 0:
            return 'did not compile'
        if all(digest(BUILD / name) == digest(CLEAN / name) for name in stale if '.dir/' not in name):
            return 'the same program'
        done = '|'.join(map(re.escape, [*self.program_of, *self.left_out]))
        scripts = self.fails('-E', f'^({done})$', '-j', self.jobs)
        return 'killed by ' + scripts if scripts else 'SURVIVED'

    def fails(self, *which):
        """The first test that fails twice, by chance alone it does not count; None if all pass."""
        done = ctest(*which, '--timeout', 120, '--stop-on-failure')
        for name in re.findall(FAILED, done.stdout):
            if ctest('-R', f'^{re.escape(name)}$', '--timeout', 120).returncode != 0:
                return name
        return None


# --- The program ----------------------------------------------------------------------------------

def read_equivalent():
    """{difference: reason}: blocks of a path, lines with - and +, then words."""
    changes = {}
    for block in re.split(r'\n\s*\n', (PROJECT / 'tests/mutation/equivalent.txt').read_text()):
        lines = [line for line in block.strip().split('\n') if line and not line.startswith('#')]
        if lines:
            marked = [line for line in lines[1:] if line.startswith(('- ', '+ '))]
            changes['\n'.join([lines[0], *marked])] = ' '.join(lines[1 + len(marked):])
    return changes


def all_mutants(globs):
    names = sorted(str(path.relative_to(PROJECT)) for ending in ('hpp', 'cpp')
                   for path in (PROJECT / 'common').rglob('*.' + ending))
    names = [name for name in names if name not in SKIPPED_FILES and (not globs or any(
        fnmatch.fnmatch(name, '*' + glob) for glob in globs))]
    if not names:
        sys.exit('error: no such file in common/')
    return [m for name in names for m in mutants_of(name, (PROJECT / name).read_text())]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('--seed', type=int, default=1, help='another number chooses other tokens')
    parser.add_argument('--count', type=int, default=64, help='how many that compile')
    parser.add_argument('--files', nargs='+', metavar='GLOB', help='only in these, such as scene/*.hpp')
    parser.add_argument('--only', nargs='+', metavar='FILE:LINE', help='all mutants of these lines')
    parser.add_argument('--list', action='store_true', help='show the mutants and stop')
    parser.add_argument('--jobs', type=int, default=2, help='programs compiled and run at once')
    return parser.parse_args()


def main():
    options = arguments()
    mutants = all_mutants(options.files)
    if options.only:
        mutants = [m for m in mutants if any(f'/{m.path}:{m.line}'.endswith('/' + place) for place in options.only)]
    else:
        mutants = sample(mutants, options.seed)
    if options.list:
        print('\n'.join(map(str, mutants if options.only else mutants[:options.count])))
        return 0
    build, equivalent = Build(options.jobs), read_equivalent()
    counts = {'killed': 0, 'SURVIVED': 0, 'the same program': 0, 'equivalent': 0, 'did not compile': 0,
              'not built here': 0}
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
    return 0


if __name__ == '__main__':
    sys.exit(main())
