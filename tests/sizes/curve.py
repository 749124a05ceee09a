#!/usr/bin/env python3
"""Memory against texels: the most that programs take with textures of 2^16 to 2^27 texels.

usage: curve.py BIN [--write]    BIN holds the chapters' programs. Prints a table in Markdown;
--write puts it into docs/measurements.md and tests/bench/groups.txt. Needs /proc.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / 'common/tools/grade'))
from pictures import png  # noqa: E402

WAYS = {  # the table's columns
    '03': ['03_image_texture', '--texture'],
    '04': ['04_uv_conventions', '--texture'],
    '09': ['09_texture_filtering', '--texture'],
    '10 `--projection cube`': ['10_projections', '--projection', 'cube', '--texture'],
    '11 `--relief-image`': ['11_bump_and_normal_maps', '--relief-image'],
}


def peak(command):
    """The most memory of a program, in bytes."""
    most = 0
    with subprocess.Popen(command) as running:
        status = pathlib.Path(f'/proc/{running.pid}/status')
        while running.poll() is None:
            found = re.search(r'VmHWM:\s*(\d+)', status.read_text())
            most = max(most, int(found[1]) << 10) if found else most
            time.sleep(0.002)
    assert running.returncode == 0, command
    return most


def main():
    lines = ['| texels | ' + ' | '.join(WAYS) + ' |', '|---' * (len(WAYS) + 1) + '|']
    with tempfile.TemporaryDirectory() as folder:
        texture, out = pathlib.Path(folder, 'texture.png'), pathlib.Path(folder, 'out.png')
        small = ['--width', '64', '--height', '48', '--quiet', '--out', out]
        for power in range(16, 28):
            texels, width = 1 << power, 1 << (power + 1) // 2
            ramps = bytes(i // 3 * 255 // width for i in range(3 * width)) * (texels // width)
            texture.write_bytes(png(width, texels // width, ramps))  # a small file
            line = f'| 2^{power} |'
            for program, *options in WAYS.values():
                most = peak([pathlib.Path(sys.argv[1], program), *options, texture, *small])
                line += f' {most / 2**20:.0f} MiB, {most / texels:.1f} |'
            lines.append(line)
            print(line, flush=True)
    if '--write' in sys.argv:
        for page in (ROOT / 'docs/measurements.md', ROOT / 'tests/bench/groups.txt'):
            table = '\n'.join(lines) + '\n'
            page.write_text(re.sub(r'\| texels .*\n(\|.*\n)*', lambda _: table, page.read_text()))


if __name__ == '__main__':
    main()
