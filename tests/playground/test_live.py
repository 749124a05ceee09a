#!/usr/bin/env python3
"""The live pictures in a real browser, from file://: the same bytes as the programs, and what happens when something goes wrong.

usage: test_live.py ROOT BIN LIVE [--self-test] [CHECK ...]
ROOT is the project, BIN has the chapters' programs, LIVE what ./course playground makes. Status 77 where there is no browser, or no LIVE. --self-test spoils what each check looks at, and demands that the check notices.
"""
import base64
import math
import os
import re
import shlex
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import zlib

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "browser"))
from browser import Browser, Fault, installed  # noqa: E402

# The default picture of each chapter comes first; then what a reader sets on its page, from the default each.
SETTINGS = {
    "01": [{"show": "normal"}, {"number": "float"}],
    "02": [{"show": "uv"}, {"spheres": "plain"}, {"samples": "4"}],
    "03": [{"show": "object"}, {"spheres": "plain"}],
    "04": [{"convention": "daily"}, {"convention": "lecture", "rounding": "lecture"}],
    "05": [{"degrees": "-135"}, {"degrees": "180", "convention": "daily"}, {"spheres": "hybrid", "number": "float"}],
    "06": [{"degrees": "40", "blend": "0.5"}, {"blend": "0"}, {"shininess": 2.5}, {"highlight": "lecture", "degrees": "0"},
           {"scene": "lecture"}, {"scene": "lecture", "highlight": "lecture", "degrees": "77"}, {"samples": "16", "blend": "1"},
           {"rounding": "lecture", "number": "float"}],
}
CHAPTERS = ["01", "02", "03", "04", "05", "06"]


class Place:
    """A folder with a page for each chapter, as the book has them."""

    def __init__(self, root, programs, made):
        self.programs = programs
        self.root = root
        self.made = made
        if not os.path.exists(os.path.join(made, "playground.html")):
            print(f"skipped: {made} has no live pictures: ./course playground makes them")
            sys.exit(77)
        self.folder = tempfile.mkdtemp()
        tools = os.path.join(root, "common", "tools", "playground")
        live = os.path.join(self.folder, "live")
        os.mkdir(live)
        for name in ("live.js", "live.css"):
            shutil.copy(os.path.join(tools, name), live)
        for name in os.listdir(made):
            shutil.copy(os.path.join(made, name), live if name.endswith(".js") else self.folder)
        shutil.copy(os.path.join(root, "common", "tools", "book", "book.css"), self.folder)
        for chapter in SETTINGS:
            program = self.program(chapter)
            shutil.copy(os.path.join(root, "tests", "golden", program + ".png"), self.folder)
            with open(os.path.join(self.folder, chapter + ".html"), "w", encoding="utf-8") as file:
                file.write(f"""<!doctype html><html lang="en"><meta charset="utf-8"><title>{program}</title><link rel="icon" href="data:,">
<meta name="viewport" content="width=device-width"><link rel="stylesheet" href="book.css"><link rel="stylesheet" href="live/live.css">
<script src="live/live.js" defer></script><div class="columns"><main data-live="{chapter}"><h1>Chapter {chapter}</h1>
<p><img src="{program}.png" alt="The chapter's picture"></p><p>Words below.</p></main></div></html>
""")

    def program(self, chapter):
        return next(name for name in sorted(os.listdir(os.path.join(self.root, "chapters"))) if name.startswith(chapter + "_"))

    def url(self, chapter):
        return f"file://{self.folder}/{chapter}.html"

    def unlike(self, drawn, chapter, words, columns=0, rows=0):
        """How a picture differs from what the program draws, in words; nothing if it does not. Without a size, the program's own."""
        mine, native = (os.path.join(self.folder, name) for name in ("mine.png", "native.png"))
        with open(mine, "wb") as file:
            file.write(png(*drawn))
        size = ["--width", str(columns), "--height", str(rows)] if columns else []
        subprocess.run([os.path.join(self.programs, self.program(chapter)), *words, *size, "--quiet", "--out", native], check=True,
                       stdout=subprocess.DEVNULL)
        said = subprocess.run([os.path.join(self.programs, "compare"), mine, native], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        return "" if said.returncode == 0 else f"{chapter} {words} at {drawn[0]} x {drawn[1]}: {said.stdout.strip()}"


def png(columns, rows, data, alpha=False):
    """A PNG file of RGB or RGBA bytes, as small as it takes no time to make."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    line = len(data) // rows
    lines = b"".join(b"\0" + data[line * row:line * (row + 1)] for row in range(rows))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", columns, rows, 8, 6 if alpha else 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(lines, 1)) + chunk(b"IEND", b""))


STATE = "document.querySelector('.live')?.dataset.state"
CANVAS = "document.querySelector('.live-picture > canvas')"


def settle(browser, state="done"):
    try:
        browser.wait(f"{STATE} === '{state}'")
    except Fault as fault:
        raise Fault(f"{fault}; it is " + browser.run(f"{STATE} + ': ' + document.querySelector('.live-says')?.textContent") +
                    ", ".join(browser.log)) from fault


def change(browser, option, value):
    """Moves a control as a hand does: its value, then its event."""
    browser.run(f"""(() => {{
      const field = document.getElementById("live--{option}");
      if (field.disabled) field.parentElement.querySelector("input[type=checkbox]").click();
      const log = {str(option in ("shininess", "eye")).lower()};
      field.value = log ? Math.log10({value!r}) : {str(value)!r};
      field.dispatchEvent(new Event(field.type === "range" ? "input" : "change", {{bubbles: true}}));
    }})()""")


def pixels(browser, canvas=CANVAS):
    """Columns, rows and RGB bytes of a canvas."""
    columns, rows, text = browser.run(f"""(() => {{
      const {{width, height}} = {canvas};
      const rgba = {canvas}.getContext("2d").getImageData(0, 0, width, height).data;
      let text = "";
      for (let i = 0; i < rgba.length; i += 4) text += String.fromCharCode(rgba[i], rgba[i + 1], rgba[i + 2]);
      return [width, height, btoa(text)];
    }})()""")
    return columns, rows, base64.b64decode(text)


def check_pixels(place, spoiled):
    """Small and full pictures equal those that the command shown draws."""
    faults, count = [], 0
    with Browser() as browser:
        for chapter in SETTINGS if not spoiled else ["05"]:
            browser.open(place.url(chapter))
            settle(browser)
            for setting in [{}] + SETTINGS[chapter] if not spoiled else [{}]:
                browser.run("[...document.querySelectorAll('.live button')].find((b) => b.textContent === 'Reset').click()")
                settle(browser)
                for option, value in setting.items():
                    change(browser, option, value)
                    settle(browser)  # else, on a slow machine, the full picture may come in place of the small one
                words = shlex.split(browser.run("document.querySelector('.live-command code').textContent"))
                if words[:3] != ["./course", "run", chapter] or any("--" + name not in words for name in setting):
                    faults.append(f"{chapter} {setting}: the command is {words}")
                    continue
                words = words[3:] + (["--degrees", "91"] if spoiled else [])
                for canvas in (CANVAS, "document.querySelector('.live').small"):
                    if canvas != CANVAS and "--samples" in words:
                        continue  # a small picture takes one ray a pixel
                    drawn = pixels(browser, canvas)
                    faults.append(place.unlike(drawn, chapter, words, *(drawn[:2] if canvas != CANVAS else ())))
                    count += 1
        faults += browser.log
    print(f"  {count} pictures compared")
    return faults


def check_rate(place, spoiled):
    """A slider that moves without rest shows a picture for (nearly) each place."""
    with Browser() as browser:
        if spoiled:
            browser.call("Page.addScriptToEvaluateOnNewDocument",
                         source="const post = Worker.prototype.postMessage; Worker.prototype.postMessage = function(m) { if (m.kind !== 'draw' || m.id < 5) post.call(this, m); };")
        browser.open(place.url("06"))
        browser.wait(f"{CANVAS} && !{CANVAS}.hidden")
        shown, seconds = browser.run("""(async () => {
          const section = document.querySelector(".live");
          const field = document.getElementById("live--degrees");
          const began = performance.now();
          const first = Number(section.dataset.pictures);
          for (let i = 0; i < 60 && performance.now() - began < 20000; ++i) {
            const before = section.dataset.pictures;
            field.value = i;
            field.dispatchEvent(new Event("input"));
            const end = performance.now() + 3000;
            while (section.dataset.pictures === before && performance.now() < end) await new Promise((done) => setTimeout(done, 1));
          }
          return [Number(section.dataset.pictures) - first, (performance.now() - began) / 1000];
        })()""")
        print(f"  {shown / seconds:.1f} pictures a second, each shown before the slider moves on")
        return ([] if shown >= 20 else [f"only {shown} pictures arrived"]) + browser.log


def check_memory(place, spoiled):
    """Four hundred pictures leave the page as large as it was."""
    with Browser("--enable-precise-memory-info") as browser:
        browser.open(place.url("06"))
        settle(browser)

        def turn(count):
            browser.run(f"""(async () => {{
              const section = document.querySelector(".live");
              const field = document.getElementById("live--degrees");
              const kept = window.kept ??= [];
              for (let i = 0; i < {count}; ++i) {{
                const before = section.dataset.pictures;
                field.value = i % 180;
                field.dispatchEvent(new Event("input"));
                while (section.dataset.pictures === before) await new Promise((done) => setTimeout(done, 0));
                if ({str(spoiled).lower()}) kept.push(section.small.getContext("2d").getImageData(0, 0, 480, 360));
              }}
            }})()""")
            settle(browser)
            browser.call("HeapProfiler.collectGarbage")

        def resident():  # of the page's process and its worker, in MiB
            total = 0
            for name in os.listdir("/proc"):
                try:
                    with open(f"/proc/{name}/cmdline", "rb") as file:
                        line = file.read()
                    if b"--type=renderer" not in line or browser.home.encode() not in line:
                        continue
                    with open(f"/proc/{name}/statm", encoding="ascii") as file:
                        total += int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")
                except (OSError, ValueError):
                    continue
            return total >> 20

        if not os.path.isdir("/proc/self"):
            return []
        turn(100)
        before = resident()
        turn(200 if spoiled else 400)
        after = resident()
        print(f"  {before} MiB after 100 pictures, {after} MiB after {300 if spoiled else 500}")
        return ([f"the page grew from {before} to {after} MiB"] if after > before + 64 or not before else []) + browser.log


def check_files(place, spoiled):
    """A bad file is refused in words, and the picture before stays; a good one is drawn as the program draws it."""
    def path(name, data):
        with open(os.path.join(place.folder, name), "wb") as file:
            file.write(data)
        return os.path.join(place.folder, name)

    good = path("my map.png", png(4, 2, bytes([*range(0, 240, 20), *range(240, 0, -20)])))
    glass = path("glass.png", png(4, 2, bytes([*range(0, 256, 16), *range(240, -16, -16)]), alpha=True))
    header = struct.pack(">4sIIBBBBB", b"IHDR", 2000000000, 2000000000, 8, 2, 0, 0, 0)
    huge = png(1, 1, bytes(3))
    huge = huge[:12] + header + struct.pack(">I", zlib.crc32(header)) + huge[33:]
    large = path("large.png", b"")
    os.truncate(large, (64 << 20) + 1)
    bad = [path("no picture.png", b"these are words"), path("empty.png", b""), path("huge.png", huge), large]
    faults = []
    with Browser() as browser:
        for chapter in ("06", "03"):
            browser.open(place.url(chapter))
            settle(browser)
            for own in (False, True):  # after the chapter's texture, and after the reader's
                before = pixels(browser)
                for file in bad if not spoiled else [good]:
                    browser.choose_file(".live input[type=file]", file)
                    try:
                        browser.wait(f"document.querySelector('.live-says').textContent.includes({os.path.basename(file)!r})", 2 if spoiled else 20)
                    except Fault as fault:
                        return [str(fault)]
                    words = browser.run("document.querySelector('.live-says').textContent")
                    if "own_" in words or len(words) < 20:
                        faults.append(f"{os.path.basename(file)}: {words!r}")
                    if pixels(browser) != before:
                        faults.append(f"{os.path.basename(file)} changes the picture")
                    if not own and chapter == "06":
                        print(f"  {words}")
                change(browser, "show", "uv")
                change(browser, "show", "color")
                settle(browser)
                if pixels(browser) != before:
                    faults.append("after a bad file the picture cannot be drawn again")
                if own:
                    break
                chosen = good if chapter == "06" else glass
                if chapter == "06":
                    browser.choose_file(".live input[type=file]", chosen)
                else:  # dropped on the picture
                    with open(chosen, "rb") as file:
                        text = base64.b64encode(file.read()).decode("ascii")
                    browser.run(f"""(() => {{
                      const dataTransfer = new DataTransfer();
                      dataTransfer.items.add(new File([Uint8Array.from(atob("{text}"), (c) => c.charCodeAt(0))], "glass.png"));
                      {CANVAS}.dispatchEvent(new DragEvent("drop", {{dataTransfer, bubbles: true, cancelable: true}}));
                    }})()""")
                settle(browser)
                name = os.path.basename(chosen)
                browser.wait(f"{STATE} === 'done' && document.querySelector('.live-command code').textContent.includes('{name}')")
                opened = browser.run("document.querySelector('.live-open > span').textContent")
                if not opened.startswith(name) or ("opaque" in opened) != (chosen == glass):
                    faults.append(f"the page says of {name}: {opened!r}")
                drawn = pixels(browser)
                words = shlex.split(browser.run("document.querySelector('.live-command code').textContent"))[3:]
                words = [chosen if word == name else word for word in words]
                faults.append(place.unlike(drawn, chapter, words, *drawn[:2]))
                if drawn == before:
                    faults.append(f"{chapter}: the picture stays as it was")
        faults += browser.log
    return faults


def check_lost(place, spoiled):
    """A worker that dies, hangs or breaks leaves the still picture; the button brings the live one back."""
    faults = []
    with Browser() as browser:
        browser.call("Page.addScriptToEvaluateOnNewDocument", source="""
          window.workers = [];
          window.Worker = class extends Worker { constructor(...all) { super(...all); workers.push(this); } };""")
        with open(os.path.join(place.folder, "06.html"), encoding="utf-8") as file:
            text = file.read()
        with open(os.path.join(place.folder, "impatient.html"), "w", encoding="utf-8") as file:
            file.write(text.replace('data-live="06"', 'data-live="06" data-patience="4"'))
        browser.open(f"file://{place.folder}/impatient.html")
        settle(browser)
        for name, act in (("ended", "workers.at(-1).terminate()"), ("broken", "workers.at(-1).postMessage({kind: 'none'})")):
            if not spoiled:
                browser.run(act)
            change(browser, "degrees", 33)
            try:
                browser.wait(f"{STATE} === 'lost'", 3 if spoiled else 30)
            except Fault as fault:
                return [str(fault)]
            if browser.run("document.querySelector('main img').getBoundingClientRect().height") < 100 or not browser.run(CANVAS + ".hidden"):
                faults.append(name + ": the still picture is not there")
            print("  " + browser.run("document.querySelector('.live-says').textContent"))
            browser.run("[...document.querySelectorAll('.live button')].find((b) => b.textContent === 'Try again').click()")
            settle(browser)
            change(browser, "degrees", 40)
            settle(browser)
            if browser.run(CANVAS + ".hidden"):
                faults.append(name + ": the picture does not come back")
            faults.append(place.unlike(pixels(browser), "06", ["--degrees", "40"], 800, 600))
        faults += browser.log
    return faults


def check_still(place, spoiled):
    """Without JavaScript, WebAssembly, DecompressionStream or the module's file the page is as it was."""
    faults = []
    heights = {}
    for way in ("no script", "no WebAssembly", "no exceptions", "no unpacking", "no module"):
        with Browser() as browser:
            if way == "no script" and not spoiled:
                browser.call("Emulation.setScriptExecutionDisabled", value=True)
            spoil = {"no WebAssembly": "delete window.WebAssembly", "no exceptions": "WebAssembly.validate = () => false",
                     "no unpacking": "delete window.DecompressionStream"}.get(way)
            if spoil and not spoiled:
                browser.call("Page.addScriptToEvaluateOnNewDocument", source=spoil)
            url = place.url("03")
            if way == "no module":
                with open(os.path.join(place.folder, "03.html"), encoding="utf-8") as file:
                    text = file.read()
                with open(os.path.join(place.folder, "none.html"), "w", encoding="utf-8") as file:
                    file.write(text.replace('"live/live.js"', '"none/live.js"'))
                shutil.copytree(os.path.join(place.folder, "live"), os.path.join(place.folder, "none"))
                os.remove(os.path.join(place.folder, "none", "modules.js"))
                url = f"file://{place.folder}/none.html"
            browser.open(url)
            time.sleep(1)
            browser.call("Emulation.setScriptExecutionDisabled", value=False)
            if browser.run("!!document.querySelector('.live')"):
                faults.append(way + ": there are controls")
            if browser.run("document.querySelector('main img').getBoundingClientRect().height") < 100:
                faults.append(way + ": there is no picture")
            heights[way] = browser.run("document.documentElement.scrollHeight")
            if way != "no module":  # there the browser itself says that a file is missing
                faults += browser.log
    if len(set(heights.values())) != 1:
        faults.append(f"the page has another height: {heights}")
    return faults


def evaluated(text):
    """The value of a formula as the page writes it."""
    text = re.sub(r"\)²", ")**2", text)
    text = re.sub(r"([0-9.e]+)²", r"(\1)**2", text)
    for mark, word in (("−", "-"), ("·", "*"), ("^", "**"), ("√", "sqrt"), ("/ 2π", "/ (2*pi)"), ("π", "pi")):
        text = text.replace(mark, word)
    return eval(text, {"__builtins__": {}, "atan2": math.atan2, "sqrt": math.sqrt, "pi": math.pi, "frac": lambda x: x % 1})  # noqa: S307


def check_loupe(place, spoiled):
    """The loupe's formulas, evaluated, give the module's (u, v), light and the picture's color; keys, pointer and Escape work."""
    faults, count, colors = [], 0, 0
    with Browser() as browser:
        browser.size(1280, 1000)
        for chapter, settings in (("02", [{}]), ("04", [{"convention": "daily"}, {"convention": "lecture"}, {"convention": "rtiow"}]), ("05", [{"degrees": "-135"}]),
                                  ("06", [{"degrees": "33", "convention": "daily"}, {"blend": "0.6", "scene": "stage"}, {"scene": "lecture"}])):
            browser.open(place.url(chapter))
            settle(browser)
            for setting in settings:
                for option, value in setting.items():
                    change(browser, option, value)
                settle(browser)
                browser.run(CANVAS + ".scrollIntoView()")
                box = browser.run(f"(({{left, top, width, height}}) => [left, top, width, height])({CANVAS}.getBoundingClientRect())")
                for across, down in ((0.46, 0.45), (0.5, 0.5), (0.53, 0.55), (0.75, 0.55), (0.1, 0.9)):
                    browser.mouse("mouseMoved", box[0] + box[2] * across, box[1] + box[3] * down)
                    column = browser.run(f"Math.floor({across} * {CANVAS}.width)")
                    near = f"[-1, 0, 1].some((n) => document.querySelector('.live-loupe td')?.textContent.includes(`column ${{{column} + n}},`))"
                    browser.wait(f"!document.querySelector('.live-loupe').hidden && {near}", 20)
                    rows = browser.run("""[...document.querySelectorAll(".live-loupe tr")].map((row) => {
                      const exact = row.cloneNode(true);
                      for (const data of exact.querySelectorAll("data")) data.textContent = data.value;
                      return [row.cells[0].textContent, exact.cells[1].textContent, row.cells[1].textContent];
                    })""")
                    for name, exact, shown in rows:
                        if name in ("lambert", "highlight", "red", "green", "blue") and " = " in exact:
                            left, right = re.sub(", at most 255|: .*", "", exact).split(" = ")
                            colors += name in ("red", "green", "blue")
                            if abs(evaluated(left) - float(right)) > 1e-9:
                                faults.append(f"{chapter} {setting}: {name}: {exact} is {evaluated(left)}")
                        if name not in ("u", "v"):
                            continue
                        parts = exact.split(" = ")
                        if len(parts) != 3:
                            faults.append(f"{chapter} {setting}: no formula in {exact}")
                            continue
                        value = evaluated(parts[1]) + (1e-8 if spoiled else 0)
                        rough = shown.split(" = ")
                        count += 1
                        if abs(value - float(parts[2])) > 1e-9:
                            faults.append(f"{chapter} {setting}: {exact} is {value}")
                        if abs(evaluated(rough[1]) - float(rough[2])) > 1e-4:
                            faults.append(f"{chapter} {setting}: as shown, {shown} is {evaluated(rough[1])}")
        browser.mouse("mouseMoved", 2, 2)
        browser.wait("document.querySelector('.live-loupe').hidden")
        browser.run(CANVAS + ".focus()")
        hidden = "document.querySelector('.live-loupe').hidden"
        text = "document.querySelector('.live-loupe td').textContent"
        browser.key("ArrowRight")
        browser.wait(f"!{hidden} && {text}.includes('column 400, row 200')", 20)
        browser.key("ArrowRight")
        browser.wait(f"{text}.includes('column 401, row 200')", 20)
        browser.key("ArrowUp")
        browser.wait(f"{text}.includes('column 401, row 199')", 20)
        browser.key("Escape")
        browser.wait(hidden, 20)
        # While the pointer holds the loupe open, arrow keys move it, wherever the focus is.
        browser.run("document.activeElement.blur()")
        browser.mouse("mouseMoved", box[0] + box[2] / 2, box[1] + box[3] / 2)
        browser.wait(f"!{hidden} && {text}.includes('column 400')", 20)
        browser.key("ArrowRight")
        browser.wait(f"{text}.includes('column 401')", 20)
        browser.key("Escape")
        # In float the loupe tells what float meets; in the lecture's scene nothing is in shadow.
        facts = "document.querySelector('.live-loupe').textContent"
        change(browser, "number", "float")
        settle(browser)
        browser.mouse("mouseMoved", box[0] + box[2] * 0.4, box[1] + box[3] * 0.7)
        browser.wait(f"!{hidden} && {facts}.includes('in float')", 20)
        if "in shadow" in browser.run(facts):
            faults.append("a shadow in the scene that has none: " + browser.run(facts))
        faults += browser.log
    if count < 30 or colors < 12:
        faults.append(f"only {count} formulas and {colors} colors")
    print(f"  {count} formulas and {colors} colors evaluated")
    return faults


def check_motion(place, spoiled):
    """The globe turns by itself only when asked, not for who asked for less motion, and not where nobody sees it."""
    faults = []
    degrees = "Number(document.getElementById('live--degrees').value)"
    with Browser() as browser:
        browser.media(prefers_reduced_motion="reduce" if not spoiled else "no-preference")
        browser.open(place.url("05"))
        settle(browser)
        if browser.run("getComputedStyle(document.querySelector('.live-turn')).display") != "none":
            faults.append("under reduced motion there is a button that turns the globe")
        browser.media(prefers_reduced_motion="no-preference")
        before = browser.run(degrees)
        browser.run("document.querySelector('.live-turn').click()")
        browser.wait(f"{degrees} !== {before}", 20)
        browser.run("Object.defineProperty(document, 'hidden', {value: true}); document.dispatchEvent(new Event('visibilitychange'))")
        settle(browser)
        if browser.run("document.querySelector('.live-turn').textContent") != "Turn":
            faults.append("the globe turns where nobody sees it")
        faults += browser.log
    return faults


def check_narrow(place, spoiled):
    """At 360 pixels nothing sticks out, whatever is open, and a finger's loupe moves no control."""
    faults = []
    controls = "document.querySelector('.live form').getBoundingClientRect().top + scrollY"
    with Browser() as browser:
        browser.call("Emulation.setTouchEmulationEnabled", enabled=True)
        for chapter in CHAPTERS[:1] if spoiled else CHAPTERS:
            for width in (360, 1280):
                browser.size(width, 900)
                browser.open(place.url(chapter))
                settle(browser)
                browser.run("for (const one of document.querySelectorAll('.live details')) one.open = true")
                change(browser, "show", "--errors" if chapter != "01" else "normal")
                settle(browser)
                before = browser.run(controls)
                browser.run(CANVAS + ".focus()")
                browser.key("ArrowDown")
                browser.wait("!document.querySelector('.live-loupe').hidden", 20)
                if spoiled:
                    browser.run("document.querySelector('.live-command').style.width = '3000px'")
                if width == 360:  # a finger, too, moves the loupe
                    browser.run(CANVAS + ".scrollIntoView()")
                    x, y = browser.run(f"(({{left, top, width, height}}) => [left + 0.1 * width, top + 0.9 * height])({CANVAS}.getBoundingClientRect())")
                    browser.call("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
                    browser.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
                    browser.wait("/column [78]., row 5..:/.test(document.querySelector('.live-loupe').textContent)", 20)
                    moved = browser.run(controls) - before
                    if abs(moved) > 1:
                        faults.append(f"{chapter}: a tap moves the controls by {moved:.0f} pixels")
                wide = browser.run("document.documentElement.scrollWidth")
                out = browser.run("""[...document.querySelectorAll(".live *")].filter((one) => one.getBoundingClientRect().right > innerWidth + 1)
                  .map((one) => one.outerHTML.slice(0, 80))""")
                if wide > width or out:
                    faults.append(f"{chapter} at {width}: {wide} wide, {out[:2]}")
                unnamed = browser.run("""[...document.querySelectorAll(".live input, .live select, .live button")]
                  .filter((one) => !(one.labels?.length || one.ariaLabel || one.textContent.trim())).map((one) => one.outerHTML.slice(0, 80))""")
                if unnamed:
                    faults.append(f"{chapter}: no name: {unnamed}")
        faults += browser.log
    return faults


def check_playground(place, spoiled):
    """playground.html is one file of less than 250 KB; each of its chapters draws, keeps its own options and opens a file."""
    faults = []
    page = os.path.join(place.folder, "playground.html")
    earth = os.path.join(place.folder, "earth.jpg")
    subprocess.run([os.path.join(place.programs, "small_earth"), os.path.join(place.root, "assets", "earth.png"), earth], check=True)
    with open(earth, "rb") as made, open(os.path.join(place.root, "common", "tools", "playground", "small_earth.jpg"), "rb") as kept:
        if made.read() != kept.read():
            faults.append("small_earth.jpg is not what small_earth makes of assets/earth.png")
    size = os.path.getsize(page) + (20000 if spoiled else 0)
    print(f"  {size} bytes")
    if size >= 250000:
        faults.append(f"{size} bytes")
    with Browser() as browser:
        browser.open("file://" + page)
        settle(browser)
        earth = os.path.join(place.root, "assets", "earth.png")
        for chapter in CHAPTERS[1:]:
            browser.run(f"document.querySelector('[name=live-chapter][value=\"{chapter}\"]').click()")
            browser.wait(f"document.querySelector('.live-command code').textContent.startsWith('./course run {chapter}') && {STATE} === 'done'")
            if chapter != "02":
                browser.choose_file(".live input[type=file]", earth)
                browser.wait(f"document.querySelector('.live-command code').textContent.includes('--texture') && {STATE} === 'done'")
            words = shlex.split(browser.run("document.querySelector('.live-command code').textContent"))[3:]
            drawn = pixels(browser)
            faults.append(place.unlike(drawn, chapter, [earth if word == "earth.png" else word for word in words], *drawn[:2]))
        # What the reader chose goes along to the next chapter, and through one that does not offer it.
        change(browser, "degrees", "77")
        change(browser, "convention", "daily" if not spoiled else "rtiow")
        for chapter in ("02", "05"):
            browser.run(f"document.querySelector('[name=live-chapter][value=\"{chapter}\"]').click()")
            browser.wait(f"document.querySelector('.live-command code').textContent.startsWith('./course run {chapter}') && {STATE} === 'done'")
        words = shlex.split(browser.run("document.querySelector('.live-command code').textContent"))[3:]
        if words != ["--degrees", "77", "--convention", "daily", "--texture", "earth.png"]:
            faults.append(f"of what was chosen in 06, 05 has {words}")
        for width in (360, 1366):
            browser.size(width, 768)
            wide = browser.run("document.documentElement.scrollWidth")
            if wide > width:
                faults.append(f"at {width}: {wide} wide")
        faults += browser.log
    return faults


CHECKS = {name[6:]: check for name, check in list(globals().items()) if name.startswith("check_")}


def main(words):
    spoiled = "--self-test" in words
    words = [word for word in words if word != "--self-test"]
    if len(words) < 3:
        raise SystemExit(__doc__.strip())
    if not installed():
        print("skipped: no browser (chromium or google-chrome) is installed")
        sys.exit(77)
    place = Place(*map(os.path.abspath, words[:3]))
    failed = False
    try:
        for name in words[3:] or CHECKS:
            began = time.monotonic()
            print(f"{name}: {CHECKS[name].__doc__.strip()}", flush=True)
            try:
                faults = [fault for fault in CHECKS[name](place, spoiled) if fault]
            except Fault as fault:
                faults = [str(fault)]
            for fault in faults:
                print(f"  {'noticed' if spoiled else 'FAIL'}: {fault}"[:400])
            if spoiled and not faults:
                print("  FAIL: what was spoiled is not noticed")
            failed = failed or (bool(faults) != spoiled)
            print(f"  {time.monotonic() - began:.0f} s", flush=True)
    finally:
        shutil.rmtree(place.folder, ignore_errors=True)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
