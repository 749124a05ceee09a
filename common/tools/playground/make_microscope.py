#!/usr/bin/env python3
"""Makes what the error microscope of the book's cover loads: its module and its map of the Earth, in one script.

usage: make_microscope.py MODULE OUT
"""
import os
import sys
import zlib

sys.dont_write_bytecode = True
from make_playground import HERE, in_base64, read, write  # noqa: E402


def main(words):
    if len(words) != 2:
        raise SystemExit(__doc__.strip())
    module, out = words
    # To make the map again: convert assets/earth.png -quality 60
    earth = read(os.path.join(HERE, "cover_earth.jpg"))
    write(os.path.join(out, "cover.js"), f'texmapCover("{in_base64(zlib.compress(read(module), 9))}", "{in_base64(earth)}");\n')


if __name__ == "__main__":
    main(sys.argv[1:])
