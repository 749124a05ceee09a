#!/usr/bin/env python3
"""Makes what the error microscope of the book's cover loads: make_microscope.py MODULE OUT writes
both MODULE and a map in OUT/cover.js."""
import pathlib
import sys
import zlib

sys.dont_write_bytecode = True
from make_playground import HERE, in_15_bits, write_script  # noqa: E402

if len(sys.argv) != 3:
    raise SystemExit(__doc__)
# to make it again: convert assets/earth.png -quality 60
earth = (HERE / "cover_earth.jpg").read_bytes()
module, out = map(pathlib.Path, sys.argv[1:])
packed = zlib.compress(module.read_bytes(), 9)
write_script(out / "cover.js",
             f'texmapCover("{in_15_bits(packed)}", "{in_15_bits(earth)}");\n')
