#!/usr/bin/env python3
"""Makes what the live pictures load, out of modules and pictures.

usage: make_playground.py all BIN OUT           of BIN/module_NAME.wasm: OUT/module_NAME.js, and OUT/playground.html
       make_playground.py script FILE.png OUT   OUT calls texmapLive.file("FILE.png", ...)
"""
import base64
import gzip
import lzma
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))


def read(path):
    with open(path, "rb") as file:
        return file.read()


def source(name):
    return read(os.path.join(HERE, name)).decode("utf-8")


def base64_of(data):
    return base64.b64encode(data).decode("ascii")


def module_script(path, name):
    # Without a time in gzip's header the same module gives the same script.
    return f'texmapLive.module("{name}", "{base64_of(gzip.compress(read(path), 9, mtime=0))}");\n'


def file_script(path, name=None):
    return f'texmapLive.file("{name or os.path.basename(path)}", "{base64_of(read(path))}");\n'


def colors():
    # The book's, light and dark: what stands before the first rule of all elements.
    return read(os.path.join(HERE, "..", "book", "book.css")).decode("utf-8").split("* {")[0].strip()


def shorter(script):
    # The page is small enough to be mailed; who wants to read the script finds it in the project.
    lines = (re.sub("(^|  )//.*", "", line).strip() for line in script.splitlines())
    return "\n".join(line for line in lines if line)


def packed_modules(modules):
    # Both in one stream, without the padding to words that this format expects.
    data = [read(path) for _, path in modules]
    filters = [{"id": lzma.FILTER_LZMA1, "preset": 9 | lzma.PRESET_EXTREME, "pb": 0}]
    text = base64_of(lzma.compress(b"".join(data), format=lzma.FORMAT_ALONE, filters=filters))
    sizes = ", ".join(f'["{name}", {len(one)}]' for (name, _), one in zip(modules, data))
    return f'texmapLive.packed([{sizes}], "{text}");\n'


def page(folder):
    """Chapters 02 to 06 in one file."""
    modules = [(name, os.path.join(folder, f"module_{name}.wasm")) for name in ("spheres", "loader")]
    # The chapters ask for earth.png; the bytes say that it is a JPEG.
    scripts = [packed_modules(modules), file_script(os.path.join(HERE, "small_earth.jpg"), "earth.png")]
    parts = {
        "colors": colors(),
        "css": source("live.css"),
        "live": shorter(source("unlzma.js")) + "\n" + shorter(source("live.js")),
        "scripts": "".join(f"<script>{script.strip()}</script>\n" for script in scripts),
    }
    return re.sub(r"\{\{(\w+)\}\}", lambda mark: parts[mark[1]], source("playground.html"))


def write(path, text):
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write(text)


def main(words):
    if len(words) == 3 and words[0] == "all":
        for name in sorted(os.listdir(words[1])):
            match = re.fullmatch(r"module_(\d\d|loader)\.wasm", name)
            if match:
                write(os.path.join(words[2], f"module_{match[1]}.js"), module_script(os.path.join(words[1], name), match[1]))
        write(os.path.join(words[2], "playground.html"), page(words[1]))
    elif len(words) == 3 and words[0] == "script":
        write(words[2], file_script(words[1]))
    else:
        raise SystemExit(__doc__.strip())


if __name__ == "__main__":
    main(sys.argv[1:])
