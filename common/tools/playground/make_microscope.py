#!/usr/bin/env python3
"""Makes what the error microscope of the book's cover loads: make_microscope.py MODULE OUT writes
both MODULE and a map in OUT/cover.js."""
import os
import sys
import zlib

sys.dont_write_bytecode = True
from make_playground import HERE, in_15_bits, read, write_script  # noqa: E402

if len(sys.argv) != 3:
    raise SystemExit(__doc__)
# to make it again: convert assets/earth.png -quality 60
earth = read(os.path.join(HERE, "cover_earth.jpg"))
packed = zlib.compress(read(sys.argv[1]), 9)
write_script(os.path.join(sys.argv[2], "cover.js"),
             f'texmapCover("{in_15_bits(packed)}", "{in_15_bits(earth)}");\n')
