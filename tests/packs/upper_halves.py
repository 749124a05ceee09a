#!/usr/bin/env python3
"""Wide code leaves the upper halves of the vector registers clean where plain code goes on.

usage: upper_halves.py PROGRAM...      77 if there is no objdump, or no program has wide instructions

A function that uses ymm or zmm registers must run vzeroupper before it returns to a plain function and before it calls one: until
then every plain instruction pays, up to eight times, and what is timed next to wide code is timed wrong. The check follows each
function's branches. A function that takes or gives packs in registers may leave them in use if only wide functions call it.
"""
import re
import shutil
import subprocess
import sys

FUNCTION = re.compile(r'^([0-9a-f]+) <(.*)>:$')
LINE = re.compile(r'^\s+([0-9a-f]+):\s+(\S+)\s*(.*)$')
TARGET = re.compile(r'^([0-9a-f]+)(?: <|$)')
UPPER = re.compile(r'%[yz]mm(?:\d|1[0-5])\b')  # 16 to 31 cost nothing


def functions_of(program):
    """{address: (name, [(address, instruction, operands)])} for all functions of a program."""
    listing = subprocess.run(['objdump', '-d', '--no-show-raw-insn', program], check=True, capture_output=True, text=True).stdout
    functions = {}
    lines = []
    for text in listing.splitlines():
        function = FUNCTION.match(text)
        if function:
            lines = []
            functions[int(function[1], 16)] = (function[2], lines)
            continue
        line = LINE.match(text)
        if line:
            words = line[2], line[3]
            if words[0] in ('bnd', 'notrack', 'rep', 'repz', 'lock'):  # a prefix
                words = (line[3].split(None, 1) + [''])[:2]
            lines.append((int(line[1], 16), *words))
    # A compiler moves what seldom runs to a part of its own.
    by_name = {name: lines for name, lines in functions.values()}
    parts = [at for at, (name, _) in functions.items() if name.endswith('.cold') and name[:-5] in by_name]
    for at in parts:
        name, lines = functions.pop(at)
        by_name[name[:-5]] += lines
    return functions


def faults_of(program):
    """Names of functions that hand dirty registers to plain code, with the place; None if nothing is wide."""
    functions = functions_of(program)
    wide = {at for at, (_, lines) in functions.items() if any(UPPER.search(operands) for _, _, operands in lines)}
    if not wide:
        return None
    called_by_plain = set()
    for at, (_, lines) in functions.items():
        for _, instruction, operands in lines:
            target = TARGET.match(operands)
            if target and int(target[1], 16) != at and at not in wide and instruction.startswith(('call', 'jmp')):
                called_by_plain.add(int(target[1], 16))

    leaves_dirty = set()  # of the wide functions; grows until nothing changes
    while True:
        faults = []
        dirty_exits = set()
        for at in wide:
            name, lines = functions[at]
            places = {address: i for i, (address, _, _) in enumerate(lines)}
            # Where a function begins, and where exceptions and tables of jumps land, they are clean.
            dirty_at = {}
            waiting = [(i, False) for i in range(len(lines) - 1, -1, -1)]
            while waiting:
                i, dirty = waiting.pop()
                while i < len(lines) and dirty_at.get(i, -1) < dirty:
                    dirty_at[i] = dirty
                    address, instruction, operands = lines[i]
                    target = TARGET.match(operands)
                    target = int(target[1], 16) if target else None
                    if instruction in ('vzeroupper', 'vzeroall'):
                        dirty = False
                    elif UPPER.search(operands):
                        dirty = True
                    elif instruction.startswith('call') or (instruction == 'jmp' and target is not None and target not in places):
                        if target in wide:
                            dirty = target in leaves_dirty
                        elif dirty:
                            faults.append(f'{name}: {address:x} calls plain code')
                            dirty = False
                    if instruction.startswith('ret') or (instruction == 'jmp' and target is not None and target not in places):
                        if dirty:
                            dirty_exits.add(at)
                        break
                    if instruction.startswith('j'):
                        if target in places:
                            waiting.append((places[target], dirty))
                        if instruction == 'jmp':
                            break
                    i += 1
        if dirty_exits <= leaves_dirty:
            break
        leaves_dirty |= dirty_exits
    faults += [f'{functions[at][0]}: returns to plain code' for at in sorted(leaves_dirty & called_by_plain)]
    return faults


def main():
    if len(sys.argv) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    if not shutil.which('objdump'):
        print('skipped: no objdump')
        return 77
    found = 0
    tried = 0
    for program in sys.argv[1:]:
        faults = faults_of(program)
        if faults is None:
            continue
        tried += 1
        for fault in faults:
            print(f'FAIL: {program}: {fault} while upper halves are in use')
        found += len(faults)
    if tried == 0:
        print('skipped: no program has wide instructions')
        return 77
    print(f'{tried} programs with wide instructions, {found} faults')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
