#!/usr/bin/env python3
"""Makes what the live pictures load, out of the module and pictures.

usage: make_playground.py MODULES ASSETS OUT
It writes MODULES' chapters_01_to_06.wasm into OUT/modules.js, chapter_NN.wasm into OUT/NN.js,
page_NN.wasm into OUT/module_NN.js, the pictures that they load into OUT/NAME.js, and 02 to 06 in
one file, OUT/playground.html.
"""
import base64
import os
import re
import sys
import zlib

HERE = os.path.dirname(os.path.abspath(__file__))
FILES = ("earth.png", "crate.png", "earth_relief.png", "sky.hdr")  # of ASSETS


def read(path):
    with open(path, "rb") as file:
        return file.read()


def source(name):
    return read(os.path.join(HERE, name)).decode("utf-8").strip()


def in_base64(data):
    return base64.b64encode(data).decode("ascii")


def in_15_bits(data):
    """Fifteen bits a character, U+3400 to U+B3FF: in UTF-16 a fifteenth more than the bytes, where
    base64 takes a third more. The first character says whether the last byte only fills up:
    browsers unpack no stream with a byte behind it."""
    bits = int.from_bytes(data, "big") << -8 * len(data) % 15
    count = -(-8 * len(data) // 15)
    text = bytearray((0x3400 + count * 15 // 8 - len(data)).to_bytes(2, "little"))
    for start in range(0, count, 1024):  # a long number is slow to take apart
        some = min(1024, count - start)
        part = bits >> 15 * (count - start - some) & (1 << 15 * some) - 1
        for i in range(some):
            text += (0x3400 + (part >> 15 * (some - 1 - i) & 0x7FFF)).to_bytes(2, "little")
    return text.decode("utf-16-le")


def module_script(module, as_text):
    return f'texmapLive.modules("{as_text(zlib.compress(read(module), 9))}");\n'


def file_script(data, name, as_text):
    return f'texmapLive.file("{name}", "{as_text(data)}");\n'


def page(module):
    # The chapters ask for earth.png; the bytes say that it is a JPEG. To make it again: convert
    # assets/earth.png -scale 25% -quality 78
    scripts = [module_script(module, in_base64),
               file_script(read(os.path.join(HERE, "small_earth.jpg")), "earth.png", in_base64)]
    parts = {
        "colors": source("../book/book.css").split("* {")[0].strip(),  # the book's, light and dark
        "css": source("live.css"),
        "live": source("live.js"),
        "scripts": "".join(f"<script>{script.strip()}</script>\n" for script in scripts),
    }
    return re.sub(r"\{\{(\w+)\}\}", lambda mark: parts[mark[1]], source("playground.html")) + "\n"


def write(path, text, encoding="utf-8"):
    with open(path, "w", encoding=encoding, newline="\n") as file:
        file.write(text)


def write_script(path, text):
    # the mark tells browsers, whatever the page's encoding
    write(path, "\ufeff" + text, "utf-16-le")


def main(words):
    if len(words) != 3:
        raise SystemExit(__doc__.strip())
    modules, assets, out = words
    first = os.path.join(modules, "chapters_01_to_06.wasm")
    write_script(os.path.join(out, "modules.js"), module_script(first, in_15_bits))
    for name in sorted(os.listdir(modules)):
        chapter = re.fullmatch(r"chapter_(\d\d)\.wasm", name)
        if chapter:
            write_script(os.path.join(out, f"{chapter[1]}.js"),
                         module_script(os.path.join(modules, name), in_15_bits))
        own = re.fullmatch(r"page_(\d\d)\.wasm", name)
        if own:
            packed = zlib.compress(read(os.path.join(modules, name)), 9)
            write_script(os.path.join(out, f"module_{own[1]}.js"),
                         file_script(packed, f"module_{own[1]}", in_15_bits))
    for name in FILES:
        write_script(os.path.join(out, name.split(".")[0] + ".js"),
                     file_script(read(os.path.join(assets, name)), name, in_15_bits))
    write(os.path.join(out, "playground.html"), page(first))


if __name__ == "__main__":
    main(sys.argv[1:])
