#!/usr/bin/env python3
"""Makes what the live pictures load, out of the module and pictures.

usage: make_playground.py MODULES ASSETS OUT
It writes MODULES' chapters_01_to_06.wasm into OUT/modules.js, chapter_NN.wasm into OUT/NN.js,
page_NN.wasm into OUT/module_NN.js, the pictures that they load into OUT/NAME.js, and 02 to 06 in
one file, OUT/playground.html.
"""
import base64
import pathlib
import re
import sys
import zlib

HERE = pathlib.Path(__file__).resolve().parent
FILES = ("earth.png", "crate.png", "earth_relief.png", "sky.hdr")  # of ASSETS


def source(name):
    return (HERE / name).read_bytes().decode("utf-8").strip()


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
    return f'texmapLive.modules("{as_text(zlib.compress(module.read_bytes(), 9))}");\n'


def file_script(data, name, as_text):
    return f'texmapLive.file("{name}", "{as_text(data)}");\n'


def page(module):
    # The chapters ask for earth.png; the bytes say that it is a JPEG. To make it again: convert
    # assets/earth.png -scale 25% -quality 78
    scripts = [module_script(module, in_base64),
               file_script((HERE / "small_earth.jpg").read_bytes(), "earth.png", in_base64)]
    parts = {
        "colors": source("../book/book.css").split("* {")[0].strip(),  # the book's, light and dark
        "css": source("live.css"),
        "live": source("live.js"),
        "scripts": "".join(f"<script>{script.strip()}</script>\n" for script in scripts),
    }
    return re.sub(r"\{\{(\w+)\}\}", lambda mark: parts[mark[1]], source("playground.html")) + "\n"


def write_script(path, text):
    # the mark tells browsers, whatever the page's encoding
    path.write_bytes(("\ufeff" + text).encode("utf-16-le"))


def main(words):
    if len(words) != 3:
        raise SystemExit(__doc__.strip())
    modules, assets, out = map(pathlib.Path, words)
    first = modules / "chapters_01_to_06.wasm"
    write_script(out / "modules.js", module_script(first, in_15_bits))
    for module in modules.glob("chapter_[0-9][0-9].wasm"):
        write_script(out / f"{module.stem[-2:]}.js", module_script(module, in_15_bits))
    for module in modules.glob("page_[0-9][0-9].wasm"):
        name = module.stem.replace("page", "module")
        packed = zlib.compress(module.read_bytes(), 9)
        write_script(out / f"{name}.js", file_script(packed, name, in_15_bits))
    for name in FILES:
        write_script(out / (name.split(".")[0] + ".js"),
                     file_script((assets / name).read_bytes(), name, in_15_bits))
    (out / "playground.html").write_bytes(page(first).encode("utf-8"))


if __name__ == "__main__":
    main(sys.argv[1:])
