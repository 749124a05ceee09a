#!/usr/bin/env python3
"""Proves with gappa that rounding keeps to the bounds which the kernels state, for each polynomial
and number: a line each.

usage: proofs.py COEFFICIENTS FOLDER
COEFFICIENTS: engine/fast/coefficients.hpp; FOLDER: for the questions, made anew
exit status: 0 all is proven; 1 something is not; 77 gappa is missing (Debian gappa)

In gappa's language a small letter is what the machine has, the same large letter what it would have
without rounding."""
import pathlib
import re
import shutil
import subprocess
import sys
from fractions import Fraction

FORMATS = {'float': ('ieee_32', 24), 'double': ('ieee_64', 53), 'extended': ('x86_80', 64)}
# Of each family of polynomials q(x): its argument, the machine's and the exact one; what makes the
# argument; what uses q and its exact value Q; what is given, and what is to be bounded; how gappa
# may cut the domain into pieces.
FAMILIES = {
    'ArcTangent': ('z', 'Z', 't = rnd(any);\nz rnd= t * t;\nZ = t * t;\n',
                   'e rnd= t * q;\nE = t * Q;\n', 't in [0,1]', '|e - E|', ''),
    'ArcCosine': ('y', 'y', 'y = rnd(any);\n', 'S = sqrt(1 - y * y);\ne rnd= s * q;\nE = S * Q;\n',
                  'y in [0,1] /\\ |s -/ S| <= 2.005@epsilon', '|e - E|',
                  '$ y in (0.2,0.35,0.5,0.6,0.7,0.76,0.82,0.86,0.89,0.92,0.94,0.96,0.98,0.99);\n'),
    'Logarithm': ('w', 'w', 'w = rnd(any);\n', 'e rnd= w * q;\nE = w * Q;\n', 'w in [1b-100,0.5]',
                  '|e -/ E|', '$ w in 8;\n'),
    'Exponential': ('y', 'y', 'y = rnd(any);\n',
                    'r = rnd(1 + rnd(y * q));\nR = 1 + y * Q;\nr2 rnd= r * r;\nR2 = R * R;\nr4 '
                    'rnd= r2 * r2;\nR4 = R2 * R2;\n'
                    'r8 rnd= r4 * r4;\nR8 = R4 * R4;\ne rnd= r8 * r8;\nE = R8 * R8;\n',
                    'y in [-1,0]', '|e - E|', '$ y in 16;\n'),
    'SrgbCurve': ('r', 'r', 'r = rnd(any);\n', '', 'r in [0.0559,1]', '|q - Q|', '$ r in 16;\n')}
# What surrounds the polynomials of turns.hpp: an angle's last steps, in the octant with most of
# them, and the distance from the axis.
SURROUNDINGS = {
    'OctantSteps': ('e = rnd(any);\nq rnd= 0.25 - e;\nQ = 0.25 - e;\nh rnd= 0.5 - q;\nH = 0.5 - '
                    'Q;\nt rnd= 1 - h;\nT = 1 - H;\n', 'e in [0,0.126]', '|t - T|', '0.4375'),
    'FromAxis': ('x = rnd(any_x);\nz = rnd(any_z);\nm = rnd(rnd(x * x) + rnd(z * z));\nM = x * x '
                 '+ z * z;\ns rnd= sqrt(m);\nS = sqrt(M);\n',
                 'x in [1b-60,2] /\\ z in [1b-60,2]', '|s -/ S|', '1.005')}


def rounded(x, digits):
    """The nearest number with so many binary digits."""
    unit = Fraction(1)
    while abs(x) < unit * 2 ** (digits - 1):
        unit /= 2
    return round(x / unit) * unit


def in_binary(x):
    """`x` exactly, as a whole number times a power of two: 3b-4 is 3/16."""
    exponent = 0
    while x.denominator != 1:
        x, exponent = x * 2, exponent - 1
    while x % 2 == 0:
        x, exponent = x / 2, exponent + 1
    return f'{x}b{exponent}'


def question(name, number, lines, domain, goal, bound):
    """Is the goal at most so many epsilons, after these lines?"""
    gappa_name, digits = FORMATS[number]

    def epsilons(text):  # not above the product: no more is proven than what is stated
        return in_binary(Fraction(int(Fraction(text[1]) * 2 ** 20)) / 2 ** (19 + digits))
    asked = re.sub(r'([\d.]+)@epsilon', epsilons, f'{domain} -> {goal} <= {bound}@epsilon')
    return (f'# {name} in {number}: {goal} <= {bound} epsilon\n'
            f'@rnd = float<{gappa_name},ne>;\n{lines}{{ {asked} }}\n')


def question_of_polynomial(family, powers, bound, number):
    """Whether rounding keeps to a bound, about polynomial.hpp's sums term by term."""
    argument, exact, before, after, domain, goal, parts = FAMILIES[family]
    lines = before
    for k, power in enumerate(powers):
        lines += (f'c{k} = {in_binary(rounded(power, FORMATS[number][1]))};\nC{k} = '
                  f'{in_binary(power)};\n')
    lines += f'x2 rnd= {argument} * {argument};\nX2 = {exact} * {exact};\n'
    # The sums of the even powers and of the odd ones; a sum has the number of its last term.
    sums = {}
    for top in (len(powers) - 1, len(powers) - 2):
        machine, whole = f'c{top}', f'C{top}'
        for k in range(top - 2, -1, -2):
            lines += f's{k} = rnd(rnd({machine} * x2) + c{k});\nS{k} = {whole} * X2 + C{k};\n'
            machine, whole = f's{k}', f'S{k}'
        sums[top % 2] = machine, whole
    lines += (f'q = rnd({sums[0][0]} + rnd({sums[1][0]} * {argument}));\nQ = {sums[0][1]} + '
              f'{sums[1][1]} * {exact};\n{after}')
    return question(f'{family}<{len(powers)}>', number, lines, domain, goal, bound) + parts


def questions(coefficients):
    """All questions, by the names of their files."""
    found = re.findall(r'struct (\w+)<\d+> \{\n.*rounding = ([\d.]+);\n.*powers = \{([^}]*)\}',
                       coefficients)
    for number in FORMATS:
        for family, bound, numbers in found:
            powers = [rounded(Fraction(power), 64)
                      for power in re.findall(r'([-+.\de]+)L', numbers)]
            yield f'{family}_{len(powers)}_{number}', question_of_polynomial(family, powers, bound,
                                                                             number)
        for name, (lines, domain, goal, bound) in SURROUNDINGS.items():
            yield f'{name}_{number}', question(name, number, lines, domain, goal, bound)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    if not shutil.which('gappa'):
        print('skipped: the proofs need gappa (Debian gappa)')
        return 77
    coefficients, folder = map(pathlib.Path, sys.argv[1:])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    count = faults = 0
    for name, text in questions(coefficients.read_text()):
        (folder / f'{name}.g').write_text(text)
        # 140 bits are enough for an extended's 64.
        proof = subprocess.run(['gappa', '-Eprecision=140', folder / f'{name}.g'],
                               capture_output=True, text=True, check=False)
        count += 1
        faults += proof.returncode != 0
        print('proven:' if proof.returncode == 0 else 'FAIL:', text.split('\n')[0][2:],
              proof.stdout + proof.stderr if proof.returncode else '')
    print(f'{count - faults} of {count} proofs hold')
    return 1 if faults or not count else 0


if __name__ == '__main__':
    sys.exit(main())
