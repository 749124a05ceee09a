#!/usr/bin/env python3
"""The live pictures of chapters 13 and 14 in a real browser. 13's figures are the program's, it keeps to the slider, and it measures
shaders. 14's pictures are the program's; published formulas break where the course's hold.

usage: test_pages.py ROOT BIN LIVE     as test_live.py
"""
import base64
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.append(str(Path(__file__).resolve().parents[2] / "tests/browser"))
from browser import Browser, installed  # noqa: E402

SECTION = "document.querySelector('.budget')"
CARD = "document.querySelector('.budget-card')"
# The bounds of the chapter's polynomials in texels of 2048 by 1024, and for what the language leaves open one pixel of its picture.
MOST = {"degree 5": 0.2, "degree 9": 0.0051, "degree 17": 0.0003}


def page_in(folder, root, made, chapter):
    (folder / "live").mkdir(exist_ok=True)
    for file in (*(root / "common/tools/playground").glob("*.[cj]s*"), *made.glob("*.js")):
        shutil.copy(file, folder / "live")
    shutil.copy(root / "common/tools/book/book.css", folder)
    page = folder / f"{chapter}.html"
    page.write_text(f"""<!doctype html><html lang="en"><meta charset="utf-8"><title>{chapter}</title><link rel="icon" href="data:,">
<meta name="viewport" content="width=device-width"><link rel="stylesheet" href="book.css"><link rel="stylesheet" href="live/live.css">
<script src="live/live.js" defer></script><script src="live/page_{chapter}.js" defer></script><main><h1>{chapter}</h1><p><img src="data:," alt=""></p></main></html>
""")
    return page.as_uri()


def faults_of_13(browser, native):
    ways = browser.run(f"{SECTION}.ways")
    if len(ways) != 24:
        yield f"{len(ways)} ways"
    for way in ways:
        degree = 0 if way["kernel"] == "reference" else int(way["kernel"].split()[1])
        row = next(one for one in native if (one["number"], one["degree"]) == (way["number"], degree))
        for key, other in (("bound", "texels_bound"), ("worst", "worst_texels")):
            if abs(way[key] - row[other]) > 1e-3 * row[other]:  # the judges have 64 and 113 binary digits
                yield f"{way['number']} {degree}: {key} {way[key]}, the program's {row[other]}"
        for key in ("changed", "may_change", "levels"):
            if way[key] != row[key]:
                yield f"{way['number']} {degree}: {key} {way[key]}, the program's {row[key]}"
    if browser.run(f"{SECTION}.dataset.way === undefined || !{SECTION}.querySelector('svg')"):
        yield "it chooses nothing by itself"
    for power in (-10.5, -6, -2, -0.5):
        browser.run(f"""(async () => {{ const slider = document.querySelector("#budget"); slider.value = {power};
          delete {SECTION}.dataset.way; slider.dispatchEvent(new Event("input")); }})()""")
        browser.wait(f"{SECTION}.dataset.way !== undefined", 20)
        way = ways[int(browser.run(f"{SECTION}.dataset.way"))]
        if way["bound"] > 10 ** power * 1.0001:
            yield f"for {power} it takes {way['kernel']}, which may be {way['bound']} off"
    browser.run(f"{CARD}.querySelector('button').click()")
    browser.wait(f"{CARD}.dataset.state === 'done' || /refused|no graphics/.test({CARD}.textContent)", 60)
    rows = browser.run(f"[...{CARD}.querySelectorAll('tr')].slice(1).map((row) => [...row.cells].map((cell) => cell.textContent))")
    if len(rows) != 6:
        yield f"{len(rows)} formulas of the graphics processor: {browser.run(CARD + '.textContent')[-300:]}"
    for name, worst, *_ in rows:
        if not 0 < float(worst.replace("−", "-")) <= MOST.get(name, 1):
            yield f"the shader by {name} is {worst} texels off"
    browser.size(360, 780)
    if browser.run("document.documentElement.scrollWidth") > 360:
        yield "too wide for 360 pixels"


def faults_of_14(browser, folder, programs):
    def turn(field, value, event):
        browser.run(f"""(() => {{ const field = document.querySelector("{field}"); field.value = {value};
          {SECTION}.dataset.state = ""; field.dispatchEvent(new Event("{event}")); }})()""")
        browser.wait(f"{SECTION}.dataset.state === 'done'", 60)

    names = browser.run("[...document.querySelectorAll('#exhibit option')].map((one) => one.textContent.split(':')[0])")
    for i, name in enumerate(names):
        turn("#exhibit", i, "change")
        unlike = int(browser.run(f"{SECTION}.dataset.published"))
        if unlike < 1000:
            yield f"{name}: the published formula holds, {unlike} pixels are wrong"
        for side, formulas in enumerate(("published", "robust")):
            # The program's needle has another picture on it, and the published pole is the C library's acos.
            if name == "needle" or (name, formulas) == ("pole", "published"):
                continue
            mine, native = folder / "mine.png", folder / "native.png"
            mine.write_bytes(base64.b64decode(browser.run(f"{SECTION}.querySelectorAll('canvas')[{side}].toDataURL()").split(",")[1]))
            subprocess.run([programs / "14_numerical_extremes", "--exhibit", name, "--formulas", formulas, "--number", "float", "--width", "320",
                            "--height", "240", "--quiet", "--out", native], check=True)
            said = subprocess.run([programs / "compare", mine, native], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            if said.returncode != 0:
                yield f"{name}, {formulas}: {said.stdout.strip()}"
        least, most = browser.run("['min', 'max'].map((end) => Number(document.querySelector('#extreme')[end]))")
        for k in range(5):
            turn("#extreme", least + (most - least) * k / 4, "input")
            unlike = int(browser.run(f"{SECTION}.dataset.course"))
            if unlike > 100:
                yield f"{name} at {k}/4 of the slider: {unlike} pixels of the course's float are wrong"
    browser.size(360, 780)
    if browser.run("document.documentElement.scrollWidth") > 360:
        yield "too wide for 360 pixels"


def main(words):
    root, programs, made = (Path(word).resolve() for word in words)
    if not installed() or not (made / "module_13.js").exists():
        print("skipped: no browser (chromium or google-chrome) is installed, or ./course playground has made nothing")
        return 77
    folder = Path(tempfile.mkdtemp())
    try:
        subprocess.run([programs / "13_speed_for_accuracy", "--rounds", "1", "--seconds", "1", "--quiet", "--out", folder / "13.png"], check=True)
        native = [row for row in json.loads((folder / "13.json").read_text())["places"] if row["filter"] == "nearest"]
        faults = []
        with Browser("--enable-unsafe-swiftshader") as browser:
            browser.open(page_in(folder, root, made, "13"))
            browser.wait(f"{SECTION}?.dataset.state === 'done' && {CARD}.childElementCount > 0", 110)
            faults += faults_of_13(browser, native)
            browser.size(1280, 800)
            browser.open(page_in(folder, root, made, "14"))
            browser.wait(f"{SECTION}?.dataset.state === 'done'", 60)
            faults += [*faults_of_14(browser, folder, programs), *browser.log]
    finally:
        shutil.rmtree(folder)
    for fault in faults:
        print(f"FAIL: {fault}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
