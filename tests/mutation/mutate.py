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
import signal
import subprocess
import sys
import time
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
SKIPPED_FILES = {"common/tools/fit_kernels.cpp"}
# What judges the text of the project, or builds it once more, and what measures time.
SKIPPED_LABELS = {"bench", "closure", "grade", "learn", "mutation", "pages", "steps"}
HEAVY_LIBRARY = "claims"  # what links it takes Boost's numbers and minutes to compile: --extremes

NOBODY = 65533  # not the 65534 that tests become themselves
MOST_MEMORY = 6 << 30
TOO_LONG = ' (too long)'

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

    def __repr__(self):
        return self.text


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


def limit_memory():
    """A mutant that never stops to ask for memory must not take all of it."""
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))


class Build:
    """A copy of the project, its build, and what depends on which file."""

    def __init__(self, work, jobs, extremes, quick):
        self.tree, self.folder, self.store = work / 'tree', work / 'build', work / 'clean'
        self.jobs, self.extremes, self.quick = jobs, extremes, quick

    def copy_project(self):
        listed = run(['git', '-C', PROJECT, 'ls-files', '-co', '--exclude-standard', '-z'])
        wanted = {name for name in listed.stdout.split('\0') if name and (PROJECT / name).is_file()}
        for name in wanted:
            source, copy = PROJECT / name, self.tree / name
            if not copy.is_file() or copy.read_bytes() != source.read_bytes():
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(source, copy)
                os.utime(copy)
        for folder, _, names in os.walk(self.tree):
            for name in names:
                path = Path(folder) / name
                if str(path.relative_to(self.tree)) not in wanted:
                    path.unlink()

    def configure(self):
        query = self.folder / '.cmake/api/v1/query/codemodel-v2'
        query.parent.mkdir(parents=True, exist_ok=True)
        query.touch()
        done = run(['cmake', '-S', self.tree, '-B', self.folder, '-G', 'Ninja', '-D', 'CMAKE_BUILD_TYPE=Release',
                    '-D', 'CMAKE_CXX_FLAGS_RELEASE=-O1'])
        if done.returncode != 0:
            sys.exit(done.stdout + 'error: cmake failed (mutation testing needs CMake and Ninja)')
        self.read_targets()

    def read_targets(self):
        reply = self.folder / '.cmake/api/v1/reply'
        index = json.loads(max(reply.glob('index-*.json')).read_text())
        name = next(o['jsonFile'] for o in index['objects'] if o['kind'] == 'codemodel')
        model = json.loads((reply / name).read_text())['configurations'][0]
        read = {t['id']: json.loads((reply / t['jsonFile']).read_text()) for t in model['targets']}
        self.needs = {t['name']: {read[d['id']]['name'] for d in t.get('dependencies', []) if d['id'] in read}
                      for t in read.values()}
        self.artifact = {t['name']: self.folder / t['artifacts'][0]['path'] for t in read.values()
                         if t['type'] == 'EXECUTABLE'}
        self.all_needs = {}
        for target in self.needs:
            self.all_needs[target] = self.closure(target)
        self.heavy = {t for t in self.needs if HEAVY_LIBRARY in self.all_needs[t]}
        # What a build of everything leaves out.
        self.left_out = {t for t in self.artifact if t.startswith('bench_') or t == 'test_bench_pages'}

    def closure(self, target):
        seen, open_ = {target}, [target]
        while open_:
            for other in self.needs[open_.pop()] - seen:
                seen.add(other)
                open_.append(other)
        return seen

    def read_tests(self):
        shown = run(['ctest', '--test-dir', self.folder, '--show-only=json-v1'])
        tests = json.loads(shown.stdout)['tests']
        target_of = {str(path): target for target, path in self.artifact.items()}
        self.target_of_test, self.scripts = {}, []
        for test in tests:
            command = test.get('command', [''])
            labels = set()
            for item in test.get('properties', []):
                if item['name'] == 'LABELS':
                    labels.update(item['value'])
            if labels & SKIPPED_LABELS:
                continue
            target = target_of.get(command[0])
            if target is None:
                if any('common' in word or self.folder.name in word for word in command) or 'golden' in labels:
                    self.scripts.append(test['name'])
            elif target not in self.left_out and (self.extremes or target not in self.heavy):
                self.target_of_test[test['name']] = target
        self.scripts.sort(key=lambda name: (not name.startswith('golden'), name == 'faults', name))

    def targets(self):
        """What is built before the first mutant."""
        return sorted(t for t, path in self.artifact.items()
                      if t not in self.left_out and (self.extremes or t not in self.heavy)
                      and (not self.quick or path.parent.name == 'tests'))

    def make(self, targets, quiet=True):
        command = ['ninja', '-C', self.folder, '-j', self.jobs, *targets]
        if not quiet:
            return subprocess.run([str(word) for word in command], check=False).returncode == 0
        return run(command).returncode == 0

    def read_dependencies(self):
        """For each file of the project the targets that compile it, and what that takes."""
        self.objects_of = {}
        current = ''
        for line in run(['ninja', '-C', self.folder, '-t', 'deps']).stdout.splitlines():
            if line.startswith(' '):
                path = os.path.normpath(os.path.join(self.folder, line.strip()))
                if path.startswith(str(self.tree) + os.sep):
                    self.objects_of.setdefault(os.path.relpath(path, self.tree), set()).add(current)
            elif ':' in line:
                current = line.split(':')[0]
        self.seconds_to_make = {}
        for line in (self.folder / '.ninja_log').read_text().splitlines()[1:]:
            start, end, _, output, _ = line.split('\t')
            self.seconds_to_make[output] = (int(end) - int(start)) / 1000

    @staticmethod
    def target_of_object(name):
        found = re.search(r'CMakeFiles/([^/]+)\.dir/', name)
        return found[1] if found else ''

    # Files of the clean build are kept, and put back with their times: no mutant is compiled twice.

    def state(self):
        seen = {}
        for folder, folders, names in os.walk(self.folder):
            if folder == str(self.folder) and 'Testing' in folders:
                folders.remove('Testing')
            for name in names:
                path = os.path.join(folder, name)
                status = os.lstat(path)
                seen[path] = (status.st_mtime_ns, status.st_size)
        return seen

    def keep(self):
        if self.store.exists():
            shutil.rmtree(self.store)
        shutil.copytree(self.folder, self.store, symlinks=True, ignore=shutil.ignore_patterns('Testing'))
        self.clean_state = self.state()
        self.clean_bytes = {t: digest(path) for t, path in self.artifact.items() if path.is_file()}

    def put_back(self):
        now = self.state()
        for path, seen in now.items():
            if path not in self.clean_state:
                os.unlink(path)
        for path, seen in self.clean_state.items():
            if now.get(path) != seen:
                os.makedirs(os.path.dirname(path), exist_ok=True)
                shutil.copy2(os.path.join(self.store, os.path.relpath(path, self.folder)), path,
                             follow_symlinks=False)

    def changed(self, target):
        """False where the program is the same to the byte as without the mutant."""
        path = self.artifact[target]
        return not path.is_file() or digest(path) != self.clean_bytes.get(target)

    def ctest(self, names, *more):
        """Runs tests, never as root: a mutant could replace /dev/null by a file."""
        pattern = '^(' + '|'.join(re.escape(name) for name in names) + ')$'
        user = {}
        if os.geteuid() == 0:
            user = {'user': NOBODY, 'group': NOBODY, 'extra_groups': []}
            logs = self.folder / 'Testing'
            logs.mkdir(exist_ok=True)
            for path in [logs, *logs.rglob('*'), self.folder / 'tests', self.folder / 'bin']:
                os.chown(path, NOBODY, NOBODY)
        return run(['ctest', '--test-dir', self.folder, '-R', pattern, '-j', self.jobs, *more],
                   preexec_fn=limit_memory, **user)

    def run_tests(self, names, limit):
        """The first test that fails; None if all pass."""
        done = self.ctest(names, '--timeout', limit, '--stop-on-failure')
        failed = re.findall(r'Test +#\d+: (\S+) \.*\** *(?:Failed|Not Run|Exception|Subprocess)', done.stdout)
        late = re.findall(r'Test +#\d+: (\S+) \.*\** *\**Timeout', done.stdout)
        if done.returncode == 0:
            return None
        return failed[0] if failed else late[0] + TOO_LONG if late else names[0]

    def times_of_tests(self, names):
        """How long each test takes; those that fail without a mutant are left out, with a warning."""
        done = self.ctest(names)
        times = {}
        for name, verdict, seconds in re.findall(
                r'Test +#\d+: (\S+) \.*\** *(\S.*?) +([\d.]+) sec', done.stdout):
            if verdict.startswith('Passed') or 'Skipped' in verdict:
                times[name] = float(seconds)
            else:
                print(f'{name} fails without a change, and is left out')
        return times


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


# --- One mutant -----------------------------------------------------------------------------------

class Judge:
    def __init__(self, build, times):
        self.build, self.times, self.quick = build, times, build.quick
        self.objects = set().union(*build.objects_of.values())

    def stages(self, path):
        """Groups of tests, the likeliest and cheapest first: [(tests, targets to build)]."""
        build = self.build
        header = path[:-4] + '.hpp' if path.endswith('.cpp') else path
        touched = {build.target_of_object(name) for name in build.objects_of.get(path, ())}
        near = touched | {build.target_of_object(name) for name in build.objects_of.get(header, ())}

        def cost(test):
            target = build.target_of_test[test]
            compiling = sum(build.seconds_to_make.get(name, 0) for name in build.objects_of.get(path, ())
                            if build.target_of_object(name) in build.all_needs[target])
            return compiling + self.times[test]

        depending = [test for test, target in build.target_of_test.items()
                     if test in self.times and build.all_needs[target] & touched]
        stem = Path(path).stem
        room = Path(path).parts[1:-1]

        def rooms_apart(target):
            """How many folders of the file's room a suite's own folder does not share."""
            shared = 0
            for name in self.own_objects(target):
                folder = Path(name.split('.dir/')[-1]).parts[:-1]
                shared = max(shared, len(os.path.commonprefix([room, folder])))
            return len(room) - shared

        def rank(test):
            target = build.target_of_test[test]
            words = set(stem.split('_')) & set(test.split('_'))  # read_jpeg and test_check_jpeg
            return (test != 'test_' + stem, target not in near, rooms_apart(target), not words,
                    cost(test))

        ordered = sorted(depending, key=rank)
        groups = [[test] for test in ordered if test == 'test_' + stem]
        others = [test for test in ordered if test != 'test_' + stem]
        size = self.build.jobs
        close = [test for test in others if build.target_of_test[test] in near]
        far = [test for test in others if build.target_of_test[test] not in near]
        if self.quick:
            far = [test for test in far if cost(test) < 60 or test == 'test_golden']
        for some in (close, far):
            groups += [some[i:i + size] for i in range(0, len(some), size)]
        stages = [(group, sorted({build.target_of_test[test] for test in group})) for group in groups]
        scripts = [] if self.quick else [name for name in build.scripts if name in self.times]
        for name in scripts:
            stages.append(([name], build.targets() if name == scripts[0] else []))
        return stages

    def own_objects(self, target):
        return [name for name in self.objects if f'/{target}.dir/' in name]

    def verdict(self, mutant):
        """'killed by NAME', 'SURVIVED', 'did not compile' or 'the same program'."""
        any_changed = False
        for tests, targets in self.stages(mutant.path):
            if targets and not self.build.make(targets):
                return 'did not compile'
            any_changed = any_changed or any(
                self.needs_running(test) for test in tests if test in self.build.target_of_test)
            if targets and not any_changed:  # before the scripts: a program alone may have changed
                any_changed = any(self.build.changed(t) for t in targets)
            wanted = [test for test in tests
                      if test not in self.build.target_of_test or self.needs_running(test)]
            if not wanted or not any_changed:
                continue
            limit = 30 + 10 * max(self.times[test] for test in wanted)
            failed = self.build.run_tests(wanted, limit)
            if failed is not None and not failed.endswith(TOO_LONG):
                failed = self.build.run_tests([failed], limit)  # by chance alone it does not count
            if failed is not None:
                return 'killed by ' + failed
        return 'SURVIVED' if any_changed or self.quick else 'the same program'

    def needs_running(self, test):
        """A suite with the same programs has the same result."""
        target = self.build.target_of_test[test]
        return any(self.build.changed(t) for t in self.build.all_needs[target] if t in self.build.artifact)


# --- Lists of changes, in the form of survivors.txt ---------------------------------------------

def read_changes(path):
    """[(difference, reason)] of a file with blocks: a path, lines with - and +, then words."""
    changes = []
    if not path.is_file():
        return changes
    for block in re.split(r'\n\s*\n', path.read_text()):
        lines = [line for line in block.strip().split('\n') if line and not line.startswith('#')]
        if lines:
            marked = [line for line in lines[1:] if line.startswith(('- ', '+ '))]
            words = [line for line in lines[1:] if not line.startswith(('- ', '+ '))]
            changes.append(('\n'.join([lines[0], *marked]), ' '.join(words)))
    return changes


# --- The program ------------------------------------------------------------------------------------

def wanted_files(globs):
    names = sorted(str(path.relative_to(PROJECT)) for ending in ('hpp', 'cpp')
                   for path in (PROJECT / 'common').rglob('*.' + ending))
    names = [name for name in names if name not in SKIPPED_FILES]
    if globs:
        names = [name for name in names if any(
            fnmatch.fnmatch(name, glob) or fnmatch.fnmatch(name, '*/' + glob) for glob in globs)]
    if not names:
        sys.exit('error: no such file in common/')
    return names


def chosen(options):
    mutants = [m for name in wanted_files(options.files) for m in mutants_of(name, (PROJECT / name).read_text())]
    if options.survivors:
        again = {difference for difference, _ in read_changes(options.work / 'survivors.txt')}
        return [m for m in mutants if m.difference() in again]
    if options.only:
        places = {tuple(place.rsplit(':', 1)) for place in options.only}
        return [m for m in mutants if any(m.path.endswith(name) and str(m.line) == line for name, line in places)]
    return sample(mutants, options.seed)


def summary(results):
    counted = {'killed': 0, 'SURVIVED': 0, 'the same program': 0, 'did not compile': 0, 'equivalent': 0}
    for _, verdict in results:
        for word in counted:
            if verdict.startswith(word):
                counted[word] += 1
    same = counted['the same program'] + counted['equivalent']
    judged = counted['killed'] + counted['SURVIVED']
    score = f"{100 * counted['killed'] / judged:.1f} %" if judged else 'none'
    return (f"{judged + same} mutants: {counted['killed']} killed, {counted['SURVIVED']} survived, {same} equivalent "
            f"({counted['the same program']} of them the same program); {counted['did not compile']} more did not "
            f"compile\nscore: {score} of those that are not equivalent")


def left(started, done, count):
    seconds = (time.monotonic() - started) / max(done, 1) * (count - done)
    return f'{seconds / 60:.0f} min left' if seconds >= 90 else f'{seconds:.0f} s left'


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('--seed', type=int, default=1, help='another number chooses other tokens')
    parser.add_argument('--count', type=int, default=64, help='how many that compile')
    parser.add_argument('--files', nargs='+', metavar='GLOB', help='only in these, such as scene/*.hpp')
    parser.add_argument('--only', nargs='+', metavar='FILE:LINE', help='all mutants of these lines')
    parser.add_argument('--survivors', action='store_true', help='those of survivors.txt once more')
    parser.add_argument('--resume', action='store_true', help='take what was found before from results.json')
    parser.add_argument('--list', action='store_true', help='show the mutants and stop')
    parser.add_argument('--quick', action='store_true', help='only tests that include the file or are cheap')
    parser.add_argument('--extremes', action='store_true', help='also the tests with Boost, which compile for minutes')
    parser.add_argument('--jobs', type=int, default=2, help='programs compiled and run at once')
    parser.add_argument('--minutes', type=float, default=1e9, help='begin no mutant later than that')
    parser.add_argument('--work', type=Path, default=PROJECT / 'build/mutation', metavar='DIR')
    parser.add_argument('--self-test', action='store_true', help='try the changes on a text that is known')
    return parser.parse_args()


def main():
    options = arguments()
    if options.self_test:
        return self_test()
    mutants = chosen(options)
    if options.list:
        for mutant in mutants if options.only or options.survivors else mutants[:options.count]:
            print(mutant)
        return 0
    options.work = options.work.resolve()
    signal.signal(signal.SIGTERM, signal.default_int_handler)

    build = Build(options.work, options.jobs, options.extremes, options.quick)
    build.copy_project()
    build.configure()
    print('Building without a change; the first time takes minutes', flush=True)
    if not build.make(build.targets(), quiet=False):
        sys.exit('error: the project does not build')
    build.read_tests()
    build.read_dependencies()
    build.keep()
    times = known_times(build, options.work / 'times.json')
    build.put_back()
    judge = Judge(build, times)
    equivalent = dict(read_changes(PROJECT / 'tests/mutation/equivalent.txt'))

    results = []
    found = options.work / 'results.json'
    known = json.loads(found.read_text()) if options.resume and found.is_file() else {}
    started, fresh = time.monotonic(), 0
    count = len(mutants) if options.only or options.survivors else options.count
    try:
        for mutant in mutants:
            compiled = sum(verdict != 'did not compile' for _, verdict in results)
            if compiled >= count or time.monotonic() - started > 60 * options.minutes:
                break
            if mutant.path not in build.objects_of:
                continue  # a file for another system
            if mutant.key in known:
                results.append((mutant, known[mutant.key]))
                continue
            remaining = left(started, fresh, fresh + count - compiled) if fresh else '...'
            print(f'[{compiled}/{count}, {remaining}]', end=' ', file=sys.stderr, flush=True)
            fresh += 1
            verdict = judged(build, judge, mutant, equivalent)
            results.append((mutant, verdict))
            print(f'{mutant}  {verdict}', flush=True)
            write_survivors(options.work / 'survivors.txt', results)
            found.write_text(json.dumps({m.key: verdict for m, verdict in results}, indent=1))
    except KeyboardInterrupt:
        print('\nstopped; what was done counts')
    print(summary(results))
    return 0


def judged(build, judge, mutant, equivalent):
    if mutant.difference() in equivalent:
        return 'equivalent: ' + equivalent[mutant.difference()]
    copy = build.tree / mutant.path
    text, status = copy.read_text(), copy.stat()
    try:
        copy.write_text(text[:mutant.start] + mutant.new + text[mutant.end:])
        began = time.monotonic()
        verdict = judge.verdict(mutant)
        return f'{verdict} ({time.monotonic() - began:.0f} s)' if verdict != 'did not compile' else verdict
    finally:
        copy.write_text(text)
        os.utime(copy, ns=(status.st_atime_ns, status.st_mtime_ns))
        build.put_back()


def write_survivors(path, results):
    blocks = [f'# {mutant}\n{mutant.difference()}\n' for mutant, verdict in results if verdict.startswith('SURVIVED')]
    path.write_text('\n'.join(blocks))


def known_times(build, path):
    """The seconds of each test without a mutant, measured again where a program has changed."""
    names = [*build.target_of_test, *([] if build.quick else build.scripts)]
    known = json.loads(path.read_text()) if path.is_file() else {}
    stamp = {name: digest(build.artifact[build.target_of_test[name]]) if name in build.target_of_test
             else hashlib.sha256(''.join(sorted(build.clean_bytes.values())).encode()).hexdigest()
             for name in names}
    missing = [name for name in names if known.get(name, [''])[0] != stamp[name]]
    if missing:
        print(f'Timing {len(missing)} tests without a change', flush=True)
        for name, seconds in build.times_of_tests(missing).items():
            known[name] = [stamp[name], seconds]
        path.write_text(json.dumps(known, indent=1))
    return {name: known[name][1] for name in names if known.get(name, [''])[0] == stamp[name]}


# --- Does it change what it should? ----------------------------------------------------------------

SAMPLE = '''// a + b in a comment
#include <vector>
#define TWICE(x) ((x) * 2)
namespace n {
struct Point {
  double x = 0.5;
  bool operator==(const Point&) const = default;
};
template <class Real>
Real f(const Real& a, int b) {
  static_assert(sizeof(Real) == 8);
  total.x += min(a, 0x1p-3F) * 10U;
  if (const int c = g(b); !ready && c < 7) {
    show(-b);
  }
  for (int i = 0; i != b; ++i) done = true;
  return "text" + 1e3;
}
}
'''
EXPECTED = '''6: 0.5 -> 0.25
12: total.x += min(a, 0x1p-3F) * 10U; -> ;
12: x -> y
12: += -> -=
12: min -> max
12: a, 0x1p-3F -> 0x1p-3F, a
12: 0x1p-3F -> 0x1p-2F
12: * -> /
12: 10U -> 11U
13: !ready && c < 7 -> !(!ready && c < 7)
13: ! -> nothing
13: && -> ||
13: < -> <=
13: 7 -> 8
14: show(-b); -> ;
14: - -> nothing
16: 0 -> 1
16: != -> ==
16: ++ -> --
16: done = true; -> ;
16: true -> false
17: "text" -> "text~"
17: + -> -
17: 1e3 -> 500.0
'''


def self_test():
    found = ''.join(f'{m.line}: {m.change}\n' for m in mutants_of('sample.cpp', SAMPLE))
    if found != EXPECTED:
        print('FAILED: expected\n' + EXPECTED + 'found\n' + found)
        return 1
    names = wanted_files(None)
    mutants = [m for name in names for m in mutants_of(name, (PROJECT / name).read_text())]
    again = {m.difference() for m in mutants}
    listed = read_changes(PROJECT / 'tests/mutation/equivalent.txt')
    for difference, reason in listed:
        if not reason:
            print('FAILED: equivalent.txt gives no reason for\n' + difference)
            return 1
        if difference not in again:
            print('equivalent.txt names what is no longer there:\n' + difference)
    print(f'{len(mutants)} mutants in {len(names)} files, {len(listed)} known to change nothing')
    return 0


if __name__ == '__main__':
    sys.exit(main())
