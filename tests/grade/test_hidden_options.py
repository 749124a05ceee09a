#!/usr/bin/env python3
"""The second picture that a checkout must draw shows what the first hides.

usage: test_hidden_options.py TREE PROGRAM_OF_04
"""
import random
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
tree, program = sys.argv[1:]
sys.path.insert(0, f'{tree}/common/tools/grade')
import build_and_run  # noqa: E402


def picture(options):
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / 'picture.png'
        subprocess.run([program, *options, '--quiet', '--out', file], check=True)
        return file.read_bytes()


# Chapter 04's first picture is a sheet with all conventions, whatever the lesson begins with.
chosen = build_and_run.hidden_options('04_uv_conventions', '', '', random.Random(1))
assert picture(chosen) == picture([*chosen, '--convention', 'rtiow'])
assert picture(chosen) != picture([*chosen, '--convention', 'daily'])
print("chapter 04's second picture is drawn in the lesson's own convention")
