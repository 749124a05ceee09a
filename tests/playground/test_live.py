#!/usr/bin/env python3
"""The live pictures in a real browser, from file://: the same bytes as the programs, and what
happens when something goes wrong.

usage: test_live.py ROOT BIN LIVE [CHECK ...]
ROOT is the project, BIN has the chapters' programs, LIVE what ./course playground makes. Status 77
where there is no browser, or no LIVE."""
import base64
import json
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
from pathlib import Path

sys.dont_write_bytecode = True
sys.path += [str(Path(__file__).resolve().parents[2] / folder)
             for folder in ("tests/browser", "common/tools/grade")]
from browser import run_checks, typed_paths, without_live  # noqa: E402
from pictures import png  # noqa: E402

# The default picture of each chapter comes first; then what a reader sets on its page, from the
# default each.
SETTINGS = {
    "01": [{"show": "normal"}, {"number": "float"}],
    "02": [{"show": "uv"}, {"spheres": "plain"}, {"samples": "4"}],
    "03": [{"show": "object"}, {"spheres": "plain"}],
    "04": [{"convention": "daily"}, {"convention": "lecture", "rounding": "lecture"}],
    "05": [{"degrees": "-135"}, {"degrees": "180", "convention": "daily"},
           {"spheres": "hybrid", "number": "float"}],
    "06": [{"degrees": "40", "blend": "0.5"}, {"blend": "0"}, {"shininess": 2.5},
           {"highlight": "lecture", "degrees": "0"},
           {"scene": "lecture"}, {"scene": "lecture", "highlight": "lecture", "degrees": "77"},
           {"samples": "16", "blend": "1"}, {"rounding": "lecture", "number": "float"}],
    "07": [{"samples": 3, "sampler": "multi-jitter"},
           {"seed": "5", "sky": "gradient", "defocus": "3", "samples": 5},
           {"sky": "gradient", "gamma": "sqrt", "samples": 2}],
    "08": [{"degrees": "33", "wrap": "clamp"}, {"weights": "heron", "number": "float"},
           {"show": "uv"}],
    "09": [{"filter": "ewa", "taps": "3"}, {"filter": "nearest", "scene": "globe"},
           {"wrap": "clamp", "filter": "stochastic"}],
    "10": [{"projection": "octahedral"}, {"projection": "plane", "show": "uv"}],
    "11": [{"relief": "-0.05", "bump": "blinn"},
           {"slopes": "central", "convention": "daily", "degrees": "-20"}],
    "12": [{"light": "uniform", "samples": 3}, {"light": "mis", "exposure": "-2", "samples": 5},
           {"light": "coefficients", "degrees": "90", "samples": 2}],
}
STATE = "$('.live')?.dataset.state"
CANVAS = "$('.live-picture > canvas')"
SAYS = "$('.live-says').textContent"
COMMAND = "$('.live-command code').textContent"
# Rows of the loupe, and the chapters that explain them.
FIRST_IN = (("02", "u"), ("02", "v"), ("02", "square"), ("03", "texel"), ("05", "n rotated"),
            ("06", "r"), ("06", "highlight"))
LOUPE = "$('.live-loupe')"
# Keeps the page's workers, and what each said, on a machine of four cores.
WORKERS = """window.workers = [];
  window.Worker = class extends Worker { constructor(...all) { super(...all); workers.push(this);
    this.said = [];
    this.addEventListener("message", ({data: {kind, id, last, pass}}) => { this.said.push({kind, id,
      last, pass}); }); } };
  Object.defineProperty(navigator, "hardwareConcurrency", {value: 4});"""
BOX = (f"(({{left, top, width, height}}) => [left, top, width, "
       f"height])({CANVAS}.getBoundingClientRect())")


class Place:
    """A folder with a page for each chapter, as the book has them."""

    def __init__(self, root, programs, made):
        self.root, self.programs, self.folder = root, programs, Path(tempfile.mkdtemp())
        tools = root / "common/tools"
        live = self.folder / "live"
        live.mkdir()
        for file in (*(tools / "playground").glob("*.[cj]s*"), *made.glob("*.js")):
            shutil.copy(file, live)
        for file in (tools / "book/book.css", made / "playground.html"):
            shutil.copy(file, self.folder)
        for chapter in SETTINGS:
            program = self.program(chapter)
            shutil.copy(root / f"tests/golden/{program}.png", self.folder)
            self.write(chapter, f"""<main data-live="{chapter}"><h1>Chapter {chapter}</h1>
<p><img src="{program}.png" alt="The chapter's picture"></p><p>Words below.</p></main>""")

    def write(self, chapter, body):
        (self.folder / f"{chapter}.html").write_text(
            f"""<!doctype html><html lang="en"><meta charset="utf-8"><title>{chapter}</title>
<link rel="icon" href="data:,"><meta name="viewport" content="width=device-width">
<link rel="stylesheet" href="book.css"><link rel="stylesheet" href="live/live.css">
<script src="live/live.js" defer></script>{body}</html>
""")

    def program(self, chapter):
        return next(folder.name for folder in sorted((self.root / "chapters").iterdir())
                    if folder.name.startswith(chapter + "_"))

    def unlike(self, drawn, words, *size):
        """How a picture differs from what ./course run, words and an own size draw; nothing if it
        does not."""
        mine, native = self.folder / "mine.png", self.folder / "native.png"
        mine.write_bytes(png(*drawn))
        if size:
            words = [*words, "--width", str(size[0]), "--height", str(size[1])]
        subprocess.run([self.programs / self.program(words[2]), *words[3:], "--quiet", "--out",
                        native], check=True, cwd=self.folder)
        said = subprocess.run([self.programs / "compare", mine, native], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)
        words = f"{words} at {drawn[0]} x {drawn[1]}: {said.stdout.strip()}"
        return [] if said.returncode == 0 else [words]

    def variant(self, name, chapter, old, new):
        """The page of a chapter with another text."""
        text = (self.folder / f"{chapter}.html").read_text().replace(old, new)
        (self.folder / name).write_text(text)
        return name

    def open(self, browser, page):
        browser.open(f"file://{self.folder}/{page}")

    def show(self, browser, page):
        """Opens a page and waits for its picture."""
        self.open(browser, page)
        settle(browser)


def settle(browser, also="true"):
    browser.wait(f"{STATE} === 'done' && {also}")


def press(browser, button):
    browser.run(f"$$('.live button').find((b) => b.textContent === '{button}').click()")


def change(browser, **options):
    """Moves controls as a hand does: the value, then its event. On a slow machine the full picture
    may come in place of the small one."""
    for option, value in options.items():
        browser.run(f"""(() => {{
          const field = $("#live--{option}");
          if (field.disabled) field.parentElement.querySelector("input[type=checkbox]").click();
          field.value = {str(option == "shininess").lower()} || (field.type === "range" &&
            "{option}" === "samples") ? Math.log10({value!r}) : {value!r};
          field.dispatchEvent(new Event(field.type === "range" ? "input" : "change",
            {{bubbles: true}}));
        }})()""")
        settle(browser)


def pixels(browser, canvas=CANVAS):
    """Columns, rows and RGB bytes of a canvas."""
    columns, rows, text = browser.run(f"""(() => {{
      const {{width, height}} = {canvas};
      const copy = new OffscreenCanvas(width, height).getContext("2d",
        {{willReadFrequently: true}});
      copy.drawImage({canvas}, 0, 0);
      const rgba = copy.getImageData(0, 0, width, height).data;
      let text = "";
      for (let i = 0; i < rgba.length; i += 4) text += String.fromCharCode(rgba[i], rgba[i + 1],
        rgba[i + 2]);
      return [width, height, btoa(text)];
    }})()""")
    return columns, rows, base64.b64decode(text)


def check_pixels(place, browser):
    """Small and full pictures equal those that the command shown draws."""
    for chapter, settings in SETTINGS.items():
        place.show(browser, f"{chapter}.html")
        for setting in [{}] + settings:
            press(browser, "Reset")
            settle(browser)
            change(browser, **setting)
            words = shlex.split(browser.run(COMMAND))
            if words[:3] != ["./course", "run",
                             chapter] or any("--" + name not in words for name in setting):
                yield f"{chapter} {setting}: the command is {words}"
                continue
            yield from place.unlike(pixels(browser), words)
            if "--samples" not in words:  # a small picture takes one ray a pixel, or a few samples
                small = pixels(browser, "$('.live').small")
                drawn_by = json.loads(
                    browser.run("$('.live').small.dataset.words"))
                yield from place.unlike(small, words[:3] + drawn_by, *small[:2])


def check_files(place, browser):
    """A bad file is refused in words, and the picture before stays; a good one, chosen or dropped,
    is drawn as the program draws it: textures, a mesh, a normal map, a sky."""
    header = struct.pack(">4sIIBBBBB", b"IHDR", 2000000000, 2000000000, 8, 2, 0, 0, 0)
    one = png(1, 1, bytes(3))
    bad = {"no picture.png": b"these are words", "empty.png": b"", "large.png": b"",
           "huge.png": one[:12] + header + struct.pack(">I", zlib.crc32(header)) + one[33:]}
    tent = "v 0 0 0\nv 2 0 0\nv 1 2 1\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n"
    # The chapter, which of its files, a good one, bad ones, and what is set.
    for chapter, nth, (name, data), bad_files, more in (
            ("06", 1, ("my map.png", png(4, 2, bytes([*range(0, 240, 20), *range(240, 0, -20)]))),
             bad, {}),
            ("03", 1, ("glass.png", png(4, 2, bytes([*range(0, 256, 16), *range(240, -16, -16)]))),
             bad, {}),
            ("08", 2, ("tent.obj", tent.encode()), {"bad.obj": b"f 1 2 3\n"}, {}),
            ("11", 3, ("up.png", png(4, 2, bytes((128, 128, 255)) * 8)),
             {"inward.png": png(4, 2, bytes((128, 128, 9)) * 8)}, {}),
            ("12", 1, ("sky.png", png(4, 2, bytes(range(0, 240, 10)))),
             {"odd.png": png(3, 1, bytes(range(9)))}, {"samples": 3})):
        for file, content in {name: data, **bad_files}.items():
            (place.folder / file).write_bytes(content)
            if file == "large.png":
                os.truncate(place.folder / file, (64 << 20) + 1)

        def choose(file):
            browser.choose_file(f".live-open:nth-child({nth}) input", str(place.folder / file))

        def refused(file, before):
            choose(file)
            browser.wait(f"{SAYS}.includes({file!r}) && /done|refused/.test({STATE})", 20)
            words = browser.run(SAYS)
            end = time.monotonic() + 10  # the page draws the picture before once more
            while not (stays := pixels(browser) == before) and time.monotonic() < end:
                time.sleep(0.1)
            stays = stays and file not in browser.run(COMMAND)
            if "own_" in words or len(words) < 20 or not stays:
                yield f"{file}: {words!r}, and the picture {'stays' if stays else 'changes'}"

        place.show(browser, f"{chapter}.html")
        change(browser, **more)
        before = pixels(browser)
        for file in bad_files:
            yield from refused(file, before)
        change(browser, show="uv")
        change(browser, show="color")
        if pixels(browser) != before:
            yield "after a bad file the picture cannot be drawn again"

        def drop():
            browser.run(f"""(() => {{
              const bytes = Uint8Array.from(atob("{base64.b64encode(data).decode()}"),
                (c) => c.charCodeAt(0));
              // The second counts, although the first is still read.
              for (const name of ["before.png", "{name}"]) {{
                const dataTransfer = new DataTransfer();
                dataTransfer.items.add(new File([bytes], name));
                {CANVAS}.dispatchEvent(new DragEvent("drop", {{dataTransfer, bubbles: true,
                  cancelable: true}}));
              }}
            }})()""")

        for k in range(3):  # the same again, too
            drop() if chapter == "03" and k == 0 else choose(name)
            settle(browser, f"{COMMAND}.includes('{name}')")
            drawn = pixels(browser)
            yield from place.unlike(drawn, shlex.split(browser.run(COMMAND)), *drawn[:2])
        opened = browser.run(f"$('.live-open:nth-child({nth}) > span').textContent")
        if not opened.startswith(name) or ("transparent" in opened) != (chapter == "03"):
            yield f"the page says of {name}: {opened!r}"
        if drawn == before:
            yield f"{chapter}: the picture stays as it was"
        yield from refused(file, drawn)
    # What is not drawn yet stays, too.
    place.show(browser, "07.html")
    browser.run("{ const field = $('#live--samples'); field.value = field.max; "
                "field.dispatchEvent(new Event('input')); }")
    browser.choose_file(".live-open input", str(place.folder / "no picture.png"))
    browser.wait(f"{SAYS}.includes('no picture.png') && "
                 "$('#live--samples').ariaValueText === '1024'", 20)


def check_hands(place, browser):
    """A drag on 11's globe moves the lamp there, a place on 10's map is found on the globe, and
    09's line and loupe show the other filter."""
    browser.size(1280, 1400)

    def at(page, thing=CANVAS):
        place.show(browser, page)
        browser.run(thing + ".scrollIntoView({block: 'center'})")
        left, top, width, height = browser.run(BOX.replace(CANVAS, thing))
        return lambda kind, x, y, **more: browser.mouse(kind, left + width * x, top + height * y,
                                                        **more)

    mouse = at("11.html")
    for kind, x in (("mousePressed", 0.5), ("mouseMoved", 0.7), ("mouseMoved", 0.75),
                    ("mouseReleased", 0.75)):
        mouse(kind, x, 0.5, button="left", buttons=int(kind != "mouseReleased"), clickCount=1)
    settle(browser)
    lamp = [float(browser.run(f"$('#live--lamp-{way}').value"))
            for way in ("around", "up")]
    if abs(lamp[0] - 30) > 1 or abs(lamp[1]) > 1 or not browser.run(LOUPE + ".hidden"):
        yield f"the lamp is at {lamp}"
    mouse = at("10.html", "$('.live-second > canvas')")
    change(browser, projection="equirect")
    # the eye looks from +z, which is there by --convention rtiow
    for x, shown in ((0.25, True), (0.75, False)):
        mouse("mouseMoved", x, 0.42)
        browser.wait("!$('.live-second .live-mark').hidden && "
                     f"{LOUPE}.hidden === {str(not shown).lower()}", 20)
    for kind in ("mousePressed", "mouseReleased"):
        mouse(kind, 0.25, 0.42, button="left", clickCount=1)
    mouse("mouseMoved", 0.75, 0.42)  # a click on the map holds its place, too
    browser.wait(f"{LOUPE}.textContent.includes('held')", 20)
    change(browser, projection="octahedral")
    yield from place.unlike(pixels(browser, "$('.live-second > canvas')"),
                            ["./course", "run", "10", "--to", "octahedral"])
    browser.run("HTMLAnchorElement.prototype.click = function () { window.saved = this.download; }")
    press(browser, "Save the map")
    browser.wait("window.saved === 'octahedral.png'", 20)
    mouse = at("09.html")
    browser.run("{ const f = $('.live-line'); f.value = 20; f.dispatchEvent(new Event('input')); }")
    clip = browser.run("getComputedStyle($('.live-second > canvas')).clipPath")
    if "80%" not in clip and "100% - 20%" not in clip:
        yield f"the line at 20 % cuts by {clip}"
    for x, words, reads in ((0.15, "nearest, left", "reads1 texel of"),
                            (0.25, "anisotropic, right", "texels")):
        mouse("mouseMoved", x, 0.5)
        browser.wait(f"{LOUPE}.textContent.includes({words!r}) && "
                     f"{LOUPE}.textContent.includes({reads!r})", 20)
        if x < 0.2 and not browser.run(LOUPE + ".querySelector('td').textContent.match(/: *(0 0 "
                                               "0|255 255 255)/)"):
            yield ("left of the line the color is not the nearest square's: "
                   f"{browser.run(LOUPE + '.textContent')}")
    change(browser, beside="ewa")
    if "--beside" in browser.run(COMMAND):  # the program has no such option
        yield "the command names the filter left of the line"


def check_curves(place, browser):
    """The errors that 07 draws against samples are those of the programs' pictures against that of
    most samples by the best pattern."""
    place.open(browser, "07.html")
    told = "$('.live-trace svg')?.ariaLabel"
    stands = "$('.live-stand')?.clientHeight > 0"
    # the still picture, until the last pass
    browser.wait(f"{STATE} === 'drawing' && {stands} && $('.live-stand').naturalWidth === 400")
    settle(browser, f"!({stands})")
    browser.wait(f"{told}?.includes(' at 16')")
    browser.run(f"new MutationObserver(() => window.stood ||= "
                f"{stands}).observe($('.live-refined'), {{subtree: true, childList: true}})")
    change(browser, sampler="random")
    if browser.run("window.stood"):
        yield "by another pattern the still picture stands for one that it is not"
    browser.wait(f"{told}.includes(' at 16, ')")

    def drawn(sampler, samples):
        picture = place.folder / f"{sampler}_{samples}.png"
        subprocess.run([place.programs / place.program("07"), "--sampler", sampler, "--samples",
                        str(samples), "--quiet", "--out", picture], check=True, cwd=place.folder)
        return picture

    for sampler, all_samples in (("random", (1, 4, 16, 64)), ("sobol", (1, 4, 16))):
        listed = re.search(f"Error by {sampler}: ([^a-z]* at [^A-Z]*)", browser.run(told))[1]
        found = {int(samples): float(error)
                 for error, samples in re.findall(r"([\d.]+) at (\d+)", listed)}
        right = {}
        for samples in all_samples:
            said = subprocess.run([place.programs / "compare", drawn(sampler, samples),
                                   drawn("sobol", 64)], stdout=subprocess.PIPE, text=True).stdout
            right[samples] = float(re.search(r"RMSE +([\d.]+)", said)[1])
        if found.keys() != right.keys() or any(abs(found[one] / right[one] - 1) > 0.005
                                               for one in right):
            yield f"{sampler}: the page has {found}, the programs {right}"


def check_more(place, browser):
    """Of 07 and 12 three workers draw a full picture, as the program does, also if one dies or
    breaks; a change stops them all."""
    browser.call("Page.addScriptToEvaluateOnNewDocument", source=WORKERS)
    for chapter, seed, act in (("07", 1, "0"), ("07", 2, "workers[1].terminate()"),
                               ("12", 3, "workers[2].postMessage({kind: 'none'})")):
        place.open(browser, place.variant("impatient.html", chapter, "data-live",
                                          'data-patience="8" data-live'))
        browser.wait(f"{STATE} === 'done' && workers.length === 3 && workers[1].said.at(-1)?.kind "
                     "=== 'seen' && workers[2].said.at(-1)?.kind === 'seen'")
        drag = """(async () => {
          let before;
          const field = $('#live--seed');
          for (let i = %d; i >= 0; --i) {
            field.value = %d + i %% 9; field.dispatchEvent(new Event('input'));
            before ??= workers[1].said.length;
            await new Promise((done) => setTimeout(done, 50));
          }
          return workers[1].said.length - before; })()"""
        browser.run(drag % (0, seed + 1))
        browser.wait("workers.every((one) => one.said.at(-1).pass > 2)")
        if browser.run(drag % (36, seed)) > 6:
            yield f"{chapter}: another worker draws on what is out of date"
        browser.run(act)
        settle(browser)
        yield from place.unlike(pixels(browser), ["./course", "run", chapter, "--seed", str(seed)])


def check_fields(place, browser):
    """A number that the chapter refuses is named beside its field; the one before stays, and other
    controls go on."""
    place.show(browser, "07.html")
    row, other = (f"$('#live--{option}').parentElement"
                  for option in ("samples", "defocus"))
    for field in (row, other):  # the second before the first is refused
        browser.run(f"{{ const field = {field}.querySelector('[type=number]'); field.value = "
                    f"-17.4; field.dispatchEvent(new Event('change')); }}")
    browser.wait(f"{row}.textContent.includes('17.4') && {other}.textContent.includes('17.4')", 20)
    change(browser, seed=3)
    yield from place.unlike(pixels(browser), ["./course", "run", "07", "--seed", "3"])
    change(browser, samples=3)
    if browser.run(f"{row}.textContent.includes('17.4')"):
        yield "the fault is still named when it is mended"


def check_lost(place, browser):
    """A worker that dies or breaks leaves the still picture; the button brings the live one
    back."""
    browser.call("Page.addScriptToEvaluateOnNewDocument", source=WORKERS)
    place.show(browser, place.variant("impatient.html", "06", 'data-live="06"',
                                      'data-live="06" data-patience="4"'))
    for act in ("workers.at(-1).terminate()", "workers.at(-1).postMessage({kind: 'none'})"):
        browser.run(act + "; { const f = $('#live--degrees'); f.value = 33; "
                          "f.dispatchEvent(new Event('input')); }")
        browser.wait(f"{STATE} === 'lost'", 30)
        height = browser.run("$('main img').getBoundingClientRect().height")
        if height < 100 or not browser.run(CANVAS + ".hidden"):
            yield act + ": the still picture is not there"
        press(browser, "Try again")
        settle(browser)
        change(browser, degrees="40")
        if browser.run(CANVAS + ".hidden"):
            yield act + ": the picture does not come back"
        yield from place.unlike(pixels(browser), ["./course", "run", "06", "--degrees", "40"])


def check_still(place, browser):
    """Without JavaScript, WebAssembly, DecompressionStream or the module's file the page is as it
    was."""
    shutil.copytree(place.folder / "live", place.folder / "none")
    (place.folder / "none/modules.js").unlink()
    page = place.variant("none.html", "03", '"live/live.js"', '"none/live.js"')
    heights = {}
    address = f"file://{place.folder}/"
    for lacks, other, log in without_live(address + "03.html", lambda: address + page,
                                          "WebAssembly.validate = () => false"):
        if other.run("!!$('.live') || $('main img').getBoundingClientRect().height < 100"):
            yield f"{lacks}: there are controls, or no picture"
        heights[lacks] = other.run("document.documentElement.scrollHeight")
        yield from log
    if len(set(heights.values())) != 1:
        yield f"the page has another height: {heights}"


def evaluated(text):
    """The value of a formula as the page writes it."""
    text = re.sub(r"([0-9.e]+|\))²", r"\1**2", re.sub(r"-([0-9.e]+)²", r"-(\1)**2", text))
    for mark, word in (("−", "-"), ("·", "*"), ("^", "**"), ("√", "sqrt"), ("/ 2π", "/ (2*pi)"),
                       ("π", "pi")):
        text = text.replace(mark, word)
    # noqa: S307
    return eval(text, {"__builtins__": {}, "atan2": math.atan2, "sqrt": math.sqrt, "pi": math.pi,
                       "frac": lambda x: x % 1})


def check_loupe(place, browser):
    """The loupe's formulas, evaluated, give the module's (u, v), light and the picture's color;
    keys, pointer and Escape work."""
    count = 0
    browser.size(1280, 1000)
    for chapter, settings in (("01", [{}]), ("02", [{}]),
                              ("03", [{"show": "uv"}, {"show": "normal"}]),
                              ("04", [{"convention": "daily"}, {"convention": "lecture"}]),
                              ("05", [{"degrees": "-135"}]),
                              ("06", [{"degrees": "33", "convention": "daily"},
                                      {"blend": "0.6", "scene": "stage"}, {"scene": "lecture"},
                                      {"highlight": "lecture"}])):
        place.show(browser, f"{chapter}.html")
        for setting in settings:
            change(browser, **setting)
            browser.run(CANVAS + ".scrollIntoView()")
            left, top, width, height = browser.run(BOX)
            for across, down in ((0.46, 0.45), (0.5, 0.5), (0.53, 0.55), (0.75, 0.55), (0.1, 0.9),
                                 (0.2, 0.1), (0.3, 0.5), (0.72, 0.5), (0.9, 0.7), (0.6, 0.3)):
                browser.mouse("mouseMoved", left + width * across, top + height * down)
                near = (f"[-1, 0, 1].some((n) => {LOUPE}.textContent.includes(`column "
                        f"${{Math.floor({across} * {CANVAS}.width) + n}},`))")
                browser.wait(f"!{LOUPE}.hidden && {near}", 20)
                # A number is shown rounded; its element has all digits.
                rows = browser.run(
                    """$$(".live-loupe tr").map((row) => {
                  const exact = row.cloneNode(true);
                  for (const data of exact.querySelectorAll("data")) data.textContent = data.value;
                  return [row.cells[0].textContent, exact.cells[1].textContent];
                })""")
                names = {name for name, _ in rows}
                if names & {"lambert", "u"} and not {"red", "green", "blue"} <= names:
                    yield (f"{chapter} {setting}: at {across}, {down} the light and the paint do "
                           "not make the pixel's color")
                early = {name for name in names for first, word in FIRST_IN if name == word
                         and chapter < first}
                if early or ("discriminant" in names) != (chapter == "01") or re.search(
                    r"object \d", str(rows)):
                    yield (f"{chapter}: rows of another chapter, or a number for a name: "
                           f"{early or rows}")
                # the smaller root is the module's distance; in the sky there is none
                if chapter == "01":
                    found = dict(rows)
                    line, is_negative = found.get("t", ""), " = -" in found["discriminant"]
                    distance = found["hit"].partition("distance ")[2]
                    roots = re.findall(r"[\d.]+", line.split(" = ")[-1])
                    is_met = bool(distance)
                    if (bool(roots), is_negative) != (is_met, not is_met) or (
                            roots and abs(float(roots[0]) / float(distance) - 1) > 1e-9):
                        yield f"01: the roots {line} of {found['discriminant']} at {distance}"
                for name, exact in rows:
                    parts = re.sub(", at most 255|: .*", "", exact).split(" = ")
                    if name in ("u", "v") and len(parts) != 3:
                        yield f"{chapter} {setting}: no formula in {exact}"
                    elif name in ("u", "v", "lambert", "highlight", "red", "green", "blue",
                                  "discriminant") and len(parts) > 1:
                        count += name in ("u", "v")
                        if abs(evaluated(parts[-2]) - float(parts[-1])) > 1e-9:
                            yield f"{chapter} {setting}: {name}: {exact} is {evaluated(parts[-2])}"
    if count < 30:
        yield f"only {count} formulas"

    def shows(text):
        browser.wait(f"!{LOUPE}.hidden && {LOUPE}.textContent.includes('{text}')", 20)

    browser.mouse("mouseMoved", 2, 2)
    browser.wait(f"{LOUPE}.hidden")
    browser.run(CANVAS + ".focus()")
    for key, text in (("ArrowRight", "column 400, row 200"), ("ArrowRight", "column 401, row 200"),
                      ("ArrowUp", "column 401, row 199")):
        browser.key(key)
        shows(text)
    browser.key("Escape")
    browser.wait(f"{LOUPE}.hidden", 20)
    # While the pointer holds the loupe open, arrow keys move it, wherever the focus is.
    browser.run("document.activeElement.blur()")
    browser.mouse("mouseMoved", left + width / 2, top + height / 2)
    shows("column 400")
    browser.key("ArrowRight")
    shows("column 401")
    # In float the loupe tells what float meets; in the lecture's scene nothing is in shadow.
    browser.key("Escape")
    change(browser, number="float")
    browser.mouse("mouseMoved", left + width * 0.4, top + height * 0.7)
    shows("in float")
    if browser.run(LOUPE + ".textContent.includes('in shadow')"):
        yield "a shadow in the scene that has none"


def box_of(browser, script):
    return browser.run(f"(({{left, top, right, bottom}}) => [left, top, right, "
                       f"bottom])({script}.getBoundingClientRect())")


def check_beside(place, browser):
    """The loupe covers no part of the picture, and its map is in the window with it; a pixel that
    is held stays while a slider moves."""
    for width, height in ((1280, 800), (1920, 1080), (360, 800)):
        browser.size(width, height)
        # whose globe turns in the end
        for chapter in sorted(SETTINGS, key=lambda one: one == "06"):
            place.show(browser, f"{chapter}.html")
            browser.run(CANVAS + ".scrollIntoView()")
            if width > 360:
                column = LOUPE + ".textContent.match(/column \\d+,/)?.[0]"
                browser.wait(f"!{LOUPE}.hidden && {column}")  # with an example
                example = browser.run(column)
                browser.key("ArrowRight")
                time.sleep(0.2)
                if browser.run(column) != example:
                    yield (f"{chapter} at {width}: no example, or an arrow key moves it before "
                           "the reader points at a pixel")
            left, top, right, bottom = box_of(browser, CANVAS)
            for kind in ("mousePressed", "mouseReleased"):
                browser.mouse(kind, (left + right) / 2, (top + bottom) / 2, button="left",
                              clickCount=1)
            browser.wait(f"!{LOUPE}.hidden")
            left, top, right, bottom = box_of(browser, CANVAS)
            its_left, its_top, its_right, its_bottom = box_of(browser, LOUPE)
            if its_left < right and its_right > left and its_top < bottom - 1 and its_bottom > top:
                yield f"{chapter} at {width}: the loupe covers the picture"
            if chapter > "06":  # their loupes have drawings of their own
                continue
            shown = box_of(browser,
                           "$$('.live-map').find((one) => !one.hidden)")
            if shown[1] < 0 or shown[3] > height or shown[3] - shown[1] < 100 or shown[2] > width:
                yield f"{chapter} at {width}: the map or drawing is at {shown}"
    before = browser.run(LOUPE + ".textContent")
    browser.run("$('#live--degrees').focus()")
    change(browser, degrees="100")
    browser.wait(f"!{LOUPE}.hidden && {LOUPE}.textContent !== {before!r}", 20)
    browser.size(1280, 800)
    before = browser.run(LOUPE + ".textContent")
    browser.run(CANVAS + ".focus()")
    browser.key("ArrowRight")
    browser.wait(f"{LOUPE}.textContent !== {before!r}", 20)
    browser.size(360, 800)  # the mark of a wide picture makes no narrow page wider
    if browser.run("document.documentElement.scrollWidth") > 360:
        yield "a page with a held pixel that gets narrower is too wide"


def check_motion(place, browser):
    """The globe turns by itself only when asked, not for who asked for less motion, and not where
    nobody sees it."""
    degrees = "Number($('#live--degrees').value)"
    button = "$('.live-turn')"
    browser.media(prefers_reduced_motion="reduce")
    place.show(browser, "05.html")
    if browser.run(f"getComputedStyle({button}).display") != "none":
        yield "under reduced motion there is a button that turns the globe"
    browser.media(prefers_reduced_motion="no-preference")
    before = browser.run(degrees)
    browser.run(button + ".click()")
    browser.wait(f"{degrees} !== {before}", 20)
    browser.run("Object.defineProperty(document, 'hidden', {value: true}); "
                "document.dispatchEvent(new Event('visibilitychange'))")
    settle(browser)
    if browser.run(button + ".textContent") != "Turn":
        yield "the globe turns where nobody sees it"


def check_narrow(place, browser):
    """At 360 pixels nothing sticks out or is cut, whatever is open, all has a name, and once a
    finger has opened the loupe it moves no control."""
    controls = "$('.live form').getBoundingClientRect().top + scrollY"
    browser.call("Emulation.setTouchEmulationEnabled", enabled=True)
    browser.size(360, 900)
    for chapter in SETTINGS:
        place.show(browser, f"{chapter}.html")
        browser.run("for (const one of $$('.live details')) one.open = true")
        change(browser, show="--errors" if "01" < chapter < "07" else "normal")
        browser.run(CANVAS + ".scrollIntoView()")
        left, top, width, height = browser.run(BOX)
        heights = []
        for across, down in ((0.1, 0.9), (0.5, 0.5), (0.1, 0.1), (0.1, 0.9)):
            browser.call("Input.dispatchTouchEvent", type="touchStart",
                         touchPoints=[{"x": left + across * width, "y": top + down * height}])
            browser.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
            browser.wait(f"[-2, -1, 0, 1, 2].some((n) => {LOUPE}.textContent.includes(`row "
                         f"${{Math.floor({down} * {CANVAS}.height) + n}}:`))", 20)
            heights.append(browser.run(controls))
        browser.key("Escape")
        browser.wait(f"{LOUPE}.hidden", 20)
        # by now the tallest was there
        if max(abs(one - heights[1]) for one in [*heights[2:], browser.run(controls)]) > 1:
            yield f"{chapter}: the controls move: {heights}"
        out = browser.run(
            """$$(".live *")
          .filter((one) => one.getBoundingClientRect().right > innerWidth + 1)
          .map((one) => one.outerHTML.slice(0, 80))""")
        if out or browser.run("document.documentElement.scrollWidth") > 360:
            yield f"{chapter}: too wide: {out[:2]}"
        unnamed = browser.run(
            """$$(".live input, .live select, .live button")
          .filter((one) => !(one.labels?.length || one.ariaLabel || one.textContent.trim())).map(
            (one) => one.outerHTML.slice(0, 80))""")
        if unnamed:
            yield f"{chapter}: no name: {unnamed}"
        small = browser.run("""$$(".live-rows input").filter((one) => {
            if (one.type === "number") one.value = 10000000;
            return one.type === "range" ? one.offsetHeight < 32 : one.scrollWidth > one.clientWidth;
              }).map((one) => one.ariaLabel || one.id)""")
        if small:
            yield f"{chapter}: a slider of less than 32 px, or a number that is cut: {small}"


def check_playground(place, browser):
    """playground.html is one file of less than 900 KB; each of its chapters draws, keeps its own
    options and opens a file."""
    page = place.folder / "playground.html"
    if page.stat().st_size >= 900000:
        yield f"playground.html has {page.stat().st_size} bytes"
    shutil.copy(place.root / "assets/earth.png", place.folder)
    place.show(browser, "playground.html")

    def go_to(chapter):
        browser.run(f"$('[name=live-chapter][value=\"{chapter}\"]').click()")
        settle(browser, f"{COMMAND}.startsWith('./course run {chapter}')")

    for chapter in list(SETTINGS)[1:6]:
        go_to(chapter)
        if chapter != "02":
            browser.choose_file(".live input[type=file]", str(place.folder / "earth.png"))
            settle(browser, f"{COMMAND}.includes('--texture')")
        drawn = pixels(browser)
        yield from place.unlike(drawn, shlex.split(browser.run(COMMAND)), *drawn[:2])
    # What the reader chose goes along to the next chapter, and through one that does not offer it.
    change(browser, degrees="77", convention="daily")
    go_to("02")
    go_to("05")
    words = shlex.split(browser.run(COMMAND))[3:]
    if words != ["--degrees", "77", "--convention", "daily", "--texture", "earth.png"]:
        yield f"of what was chosen in 06, 05 has {words}"
    for width in (360, 1366):
        browser.size(width, 768)
        if browser.run("document.documentElement.scrollWidth") > width:
            yield f"at {width}: too wide"


CHECKS = {name[6:]: check for name, check in list(globals().items()) if name.startswith("check_")}


def main():
    place = Place(*typed_paths(__doc__, 3, lambda *paths: paths[2] / "playground.html"))
    failed = run_checks([CHECKS[name] for name in sys.argv[4:] or CHECKS], place)
    shutil.rmtree(place.folder)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
