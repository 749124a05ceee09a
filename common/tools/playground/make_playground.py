#!/usr/bin/env python3
"""Makes what the live pictures load, out of modules and pictures.

usage: make_playground.py script FILE.wasm NAME OUT      OUT calls texmapLive.module(NAME, ...)
       make_playground.py script FILE.png OUT            OUT calls texmapLive.file("FILE.png", ...)
       make_playground.py page FILE.wasm EARTH.png OUT   the page of chapters 02 to 06, in one file
"""
import base64
import gzip
import os
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


def page(module, earth):
    parts = {
        "{{css}}": source("live.css"),
        "{{live}}": source("live.js"),
        "{{module}}": module_script(module, "spheres"),
        # The chapters ask for earth.png; its bytes say what it is.
        "{{earth}}": file_script(earth, "earth.png"),
    }
    text = source("playground.html")
    for mark, part in parts.items():
        if text.count(mark) != 1:
            raise SystemExit(f"error: playground.html has {mark} {text.count(mark)} times")
        text = text.replace(mark, part)
    return text


def main(words):
    if len(words) == 4 and words[0] == "script":
        text = module_script(words[1], words[2])
    elif len(words) == 3 and words[0] == "script":
        text = file_script(words[1])
    elif len(words) == 4 and words[0] == "page":
        text = page(words[1], words[2])
    else:
        raise SystemExit(__doc__.strip())
    with open(words[-1], "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main(sys.argv[1:])
