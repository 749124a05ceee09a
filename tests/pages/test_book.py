#!/usr/bin/env python3
"""The book in a real browser, in light and dark, 360 and 1280 pixels wide: everything fits, can be read and is there.

usage: test_book.py BOOK ROOT BIN
BOOK makes the book, ROOT is the project, BIN has the chapters' programs. Status 77 where no browser is installed.
out/ as a whole is small enough to be sent: the book, the chapters' pictures, the turntable and the pages of ./course diff.
"""
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "browser"))
from browser import Browser, Fault, installed  # noqa: E402

MOST_KB = 8192
ALLOWED_SECONDS = 400  # a view takes 0.1 to 0.5 s
WRONG_PAGE = """<!doctype html><html lang="en"><body style="background:#fff"><main><p style="color:#bbb">pale</p>
<img src="none.png" alt="none"><div style="width:3000px">wide</div></main></body></html>"""


def run(*words):
    subprocess.run([str(word) for word in words], check=True, stdout=subprocess.DEVNULL)


def make_out(book, root, programs, out):
    """What ./course makes in out/, with golden pictures in place of drawing them again."""
    out.mkdir()
    for folder in sorted((root / "chapters").glob("[0-9][0-9]_*/")):
        golden = root / "tests" / "golden" / f"{folder.name}.png"
        if golden.exists():
            shutil.copy(golden, out)
        else:
            run(programs / folder.name, "--out", out / golden.name)
    turntable = re.search(r"05_y_rotation_000\.png (--turntable [^)]*)\)", (root / "chapters" / "CMakeLists.txt").read_text())
    run(programs / "05_y_rotation", "--quiet", "--out", out / "05_y_rotation.png", *shlex.split(turntable[1]))
    run(programs / "compare_steps", "--quiet", "--shared", "--drawn", out, "--out", out / "diff")
    run(programs / "pack_png", out)
    run(book, root, out)


def faults_of_files(out):
    # Pictures that the reader draws and changes are no part of the book, which has copies of its own.
    drawn = [path for path in out.glob("[0-9][0-9]_*.png") if (out / "pictures" / f"tests-golden-{path.name}").exists()]
    size = sum(path.stat().st_size for path in out.rglob("*") if path.is_file() and path not in drawn) // 1024
    print(f"the book: {size} KB")
    if size >= MOST_KB:
        yield f"the book has {size} KB, more than {MOST_KB}"
    # The lines of all sources have numbers, which stand in book.css; a page has 18 lines around its source.
    numbers = len(re.findall(r"\d\\a", (out / "book.css").read_text()))
    longest = max(page.read_text().count("\n") for page in (out / "source").glob("*.html"))
    if numbers <= longest - 25:
        yield f"book.css numbers {numbers} lines, and a source page has {longest}"


def faults_of_pages(out, files, scheme):
    """What the probe says of pages in a color scheme, and what the browser's console shows."""
    with Browser("--allow-file-access-from-files") as browser:
        browser.media(prefers_color_scheme=scheme)
        browser.size(1400, 1000)
        browser.open(f"file://{out}/book_probe.html#{','.join(files)}")
        browser.wait("'result' in document.body.dataset", ALLOWED_SECONDS)
        result = json.loads(browser.run("document.body.dataset.result"))
        if result["looked"] != 2 * len(files):
            yield f"{result['looked']} of {2 * len(files)} views were looked at"
        dark = browser.run("getComputedStyle(document.body).colorScheme + matchMedia('(prefers-color-scheme: dark)').matches")
        if dark.endswith("true") != (scheme == "dark"):
            yield f"the browser does not show {scheme} pages"
        yield from (f"{scheme}: {fault}" for fault in result["faults"] + browser.log)


def faults_unnoticed(book, root, out, work):
    """The check can fail: a page with a broken picture, pale words and a box of 3000 pixels; and links that lead nowhere."""
    (out / "wrong.html").write_text(WRONG_PAGE)
    seen = "\n".join(faults_of_pages(out, ["wrong.html"], "light"))
    for fault in ("too wide", "no picture", "contrast 1.9"):
        if fault not in seen:
            yield f"a wrong page is not noticed: {fault} ({seen})"
    chapter = work / "root" / "chapters" / "01_a"
    chapter.mkdir(parents=True)
    (work / "root" / "docs").mkdir()
    tools = work / "root" / "common" / "tools"
    shutil.copytree(root / "common" / "tools" / "book", tools / "book")
    shutil.copy(root / "common" / "tools" / "turntable.js", tools)
    (chapter / "README.md").write_text("# 01\n\n[a](none.md) [b](#none)\n")
    made = subprocess.run([book, work / "root", work / "wrong"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if made.returncode == 0:
        yield "links that lead nowhere do not stop the making of the book"
    for fault in ("none.md leads nowhere", "has no heading #none"):
        if fault not in made.stdout:
            yield f"a fault of a link is not named: {fault}"


def main(words):
    if len(words) != 3:
        raise SystemExit(__doc__.strip())
    if not installed():
        print("skipped: no browser (chromium or google-chrome) is installed")
        return 77
    book, root, programs = (pathlib.Path(word).resolve() for word in words)
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        out = work / "out"
        make_out(book, root, programs, out)
        faults = list(faults_of_files(out))
        shutil.copy(root / "tests" / "pages" / "book_probe.html", out)
        pages = sorted(page.name for page in out.glob("*.html") if page.name != "book_probe.html")
        print(f"{len(pages)} pages", flush=True)
        try:
            for scheme in ("light", "dark"):
                faults += faults_of_pages(out, pages, scheme)
            faults += faults_unnoticed(book, root, out, work)
        except Fault as fault:
            faults.append(str(fault))
    for fault in faults:
        print(f"FAIL: {fault}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
