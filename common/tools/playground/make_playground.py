#!/usr/bin/env python3
"""Makes what the live pictures load, out of modules and pictures.

usage: make_playground.py BIN ASSETS OUT     BIN/module_NAME.wasm in OUT/modules.js, ASSETS' textures in OUT/earth.js and others,
                                             and OUT/playground.html: chapters 02 to 06 in one file
"""
import base64
import lzma
import os
import re
import struct
import sys
import zlib

HERE = os.path.dirname(os.path.abspath(__file__))
TEXTURES = ["earth.png"]
ON_THE_PAGE = ["02", "03", "04", "05", "06", "loader"]


def read(path):
    with open(path, "rb") as file:
        return file.read()


def source(name):
    return read(os.path.join(HERE, name)).decode("utf-8")


def packed(data, literal_context):
    """LZMA, without the padding to words that this format expects: a fifth smaller than gzip, which browsers unpack."""
    filters = [{"id": lzma.FILTER_LZMA1, "preset": 9 | lzma.PRESET_EXTREME, "pb": 0, "lc": literal_context, "lp": 0}]
    return lzma.compress(data, format=lzma.FORMAT_ALONE, filters=filters)


def in_base64(data):
    return base64.b64encode(data).decode("ascii")


def in_15_bits(data):
    """Fifteen bits a character, U+3400 to U+B3FF: in UTF-16 a fifteenth more than the bytes, where base64 takes a third more."""
    bits = int.from_bytes(data, "big") << -8 * len(data) % 15
    count = -(-8 * len(data) // 15)
    text = bytearray()
    for start in range(0, count, 1024):  # a long number is slow to take apart
        some = min(1024, count - start)
        part = bits >> 15 * (count - start - some) & (1 << 15 * some) - 1
        for i in range(some):
            text += (0x3400 + (part >> 15 * (some - 1 - i) & 0x7FFF)).to_bytes(2, "little")
    return text.decode("utf-16-le")


def modules_script(folder, names, as_text):
    """One stream for all: what the chapters share is in it once."""
    data = [read(os.path.join(folder, f"module_{name}.wasm")) for name in names]
    sizes = ", ".join(f'["{name}", {len(one)}]' for name, one in zip(names, data))
    return f'texmapLive.modules([{sizes}], "{as_text(packed(b"".join(data), 3))}");\n'


def unfiltered(kind, line, before):
    """A row of a PNG with three bytes a pixel. Source: the PNG specification, section 9."""
    for i in range(len(line) if kind else 0):
        left = line[i - 3] if i >= 3 else 0
        up = before[i]
        corner = before[i - 3] if i >= 3 else 0
        if kind == 1:
            line[i] = (line[i] + left) & 255
        elif kind == 2:
            line[i] = (line[i] + up) & 255
        elif kind == 3:
            line[i] = (line[i] + (left + up) // 2) & 255
        else:
            guess = left + up - corner
            nearest = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))
            line[i] = (line[i] + nearest[2]) & 255
    return line


def pixels(path):
    """Columns, rows and the RGB bytes of a PNG with 8 bits a channel, not interlaced, as the course writes them."""
    data = read(path)
    stream, at = b"", 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        part = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            columns, rows, depth, color, _, _, interlace = struct.unpack(">IIBBBBB", part)
        elif kind == b"IDAT":
            stream += part
        at += length + 12
    if (depth, color, interlace) != (8, 2, 0):
        raise SystemExit(f"error: {path} is not a plain RGB picture")
    raw = zlib.decompress(stream)
    step = 3 * columns
    before, result = bytes(step), bytearray()
    for row in range(rows):
        start = row * (step + 1)
        before = unfiltered(raw[start], bytearray(raw[start + 1:start + 1 + step]), before)
        result += before
    return columns, rows, bytes(result)


def texture_script(path):
    columns, rows, data = pixels(path)
    return f'texmapLive.texture("{os.path.basename(path)}", {columns}, {rows}, "{in_15_bits(packed(data, 4))}");\n'


def file_script(path, name):
    return f'texmapLive.file("{name}", "{in_base64(read(path))}");\n'


def colors():
    """The book's, light and dark: what stands before the first rule of all elements."""
    return read(os.path.join(HERE, "..", "book", "book.css")).decode("utf-8").split("* {")[0].strip()


def page(folder):
    # The chapters ask for earth.png; the bytes say that it is a JPEG.
    scripts = [modules_script(folder, ON_THE_PAGE, in_base64), file_script(os.path.join(HERE, "small_earth.jpg"), "earth.png")]
    live = source("live.js").encode("utf-8")
    parts = {
        "colors": colors(),
        "css": source("live.css"),
        "unlzma": source("unlzma.js"),
        "live": in_base64(packed(live, 3)),
        "size": str(len(live)),
        "scripts": "".join(f"<script>{script.strip()}</script>\n" for script in scripts),
    }
    return re.sub(r"\{\{(\w+)\}\}", lambda mark: parts[mark[1]], source("playground.html"))


def write(path, text, encoding="utf-8"):
    with open(path, "w", encoding=encoding, newline="\n") as file:
        file.write(text)


def write_script(path, text):
    write(path, "\ufeff" + text, "utf-16-le")  # the mark tells browsers, whatever the page's encoding


def main(words):
    if len(words) != 3:
        raise SystemExit(__doc__.strip())
    folder, assets, out = words
    names = sorted(name[7:-5] for name in os.listdir(folder) if re.fullmatch(r"module_(\d\d|loader)\.wasm", name))
    write_script(os.path.join(out, "modules.js"), modules_script(folder, names, in_15_bits))
    for texture in TEXTURES:
        write_script(os.path.join(out, texture.replace(".png", ".js")), texture_script(os.path.join(assets, texture)))
    write(os.path.join(out, "playground.html"), page(folder))


if __name__ == "__main__":
    main(sys.argv[1:])
