#!/usr/bin/env python3
"""The book as a server sends it whose policy forbids styles, scripts and pictures that are no
files: what the first screen shows, addresses that hold a state, and from a number to its code,
and mistakes on purpose.

usage: test_served.py BOOK ROOT     as test_book.py
"""
import functools
import http.server
import json
import re
import shlex
import subprocess
import sys
import tempfile
import threading
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.append(str(Path(__file__).resolve().parents[1] / "browser"))
from browser import run_checks, typed_paths  # noqa: E402

FILES_ALONE = "default-src 'self'"
WITH_WASM = FILES_ALONE + "; script-src 'self' 'wasm-unsafe-eval'"
LIVE = "$('.live, .budget, .hero')"
DONE = f"{LIVE}?.dataset.state === 'done'"
SAYS = "$('.live-says').textContent"
COMMAND = "$('.live-command code').textContent"
# What moves by itself, as parts of the window.
SHIFTS = """window.shift = 0; new PerformanceObserver((list) => {
  for (const one of list.getEntries()) if (!one.hadRecentInput) shift += one.value;
}).observe({type: "layout-shift", buffered: true});"""
BOTTOM = "(what) => $(what)?.getBoundingClientRect().bottom ?? 0"


class Place:
    """The book, and a server with a policy."""

    def __init__(self, book, root, out):
        self.root, self.out, self.policy = root, out, WITH_WASM
        subprocess.run([book, root, out], stdout=subprocess.DEVNULL, check=True)
        self.chapters = sorted(page.name for page in out.glob("[0-9][0-9]_*.html"))
        place = self

        class Handler(http.server.SimpleHTTPRequestHandler):
            def end_headers(self):
                self.send_header("Content-Security-Policy", place.policy)
                super().end_headers()

            def log_message(self, *_):
                pass

        self.server = http.server.ThreadingHTTPServer(
            ("127.0.0.1", 0), functools.partial(Handler, directory=out))
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def open(self, browser, page, is_file=False):
        browser.open("about:blank")
        browser.open(f"file://{self.out}/{page}" if is_file
                     else f"http://127.0.0.1:{self.server.server_port}/{page}")


def check_screens(place, browser):
    """With WebAssembly allowed all lives, without a message: the picture and its control are in the
    first screen, and nothing moves when they come."""
    browser.call("Page.addScriptToEvaluateOnNewDocument", source=SHIFTS)
    for width, height in ((1280, 900), (360, 800)):
        browser.size(width, height)
        for page in [*place.chapters, "index.html", "symptoms.html"]:
            for _ in range(3):  # a page that comes in two pieces may move once
                place.open(browser, page)
                browser.wait("true" if page[:2] in ("00", "sy") else DONE, 60)
                shift = browser.run("shift")
                if shift <= 0.05:
                    break
            else:
                yield f"{page}, {width} wide: {shift:.3f} of the window moves"
            for what in (".live-most, #budget, #extreme",
                         ".live-picture > canvas, .budget-plot svg"):
                bottom = browser.run(f"({BOTTOM})({what!r})")
                if not 0 < bottom <= height and "01" <= page[:2] <= "13" and not (
                        width < 400 and what.startswith(".live-picture")):
                    yield f"{page}, {width} wide: {what} ends at {bottom}"
    styled = [page for page in place.out.rglob("*.html") if "diff" not in page.parts and re.search(
        r'<[^>]* (style|on\w+)="|<style|<script>|data:', page.read_text())]
    if styled:
        yield f"not in files of their own: {styled[:5]}"


def check_forbidden(place, browser):
    """Where the policy forbids WebAssembly the pages say so, and the still picture is there."""
    place.policy = FILES_ALONE
    for page in [*place.chapters[1:], "index.html"]:
        place.open(browser, page)
        browser.wait("document.body.textContent.includes('policy forbids WebAssembly')", 30)
        if browser.run("$$('main img, main svg').every((one) => "
                       "one.getBoundingClientRect().height < 100)"):
            yield f"{page}: no picture"


def check_addresses(place, browser):
    """An address holds settings and a pixel: they are set, in the command's order, and come back.
    Nonsense gives the page's begin, and a line; a heading stays."""
    place.policy, begin = WITH_WASM, "./course run 05"
    said = subprocess.run([place.root / "course", "run", "05", *"--convention daily --degrees=63 "
                           "--link".split()], stdout=subprocess.PIPE, text=True).stdout.strip()
    if not said.endswith("/out/05_y_rotation.html#convention=daily&degrees=63"):
        yield f"./course run 05 --link prints {said}"
    for is_file in (False, True):
        for asked, command, becomes, says in (
                ("degrees=63&convention=daily&pixel=444,277",
                 begin + " --degrees 63 --convention daily", None, ""),
                (said.partition("#")[2], begin + " --degrees 63 --convention daily",
                 "#degrees=63&convention=daily", ""),
                ("look-for", begin, "#look-for", ""),
                ("degrees=63&colour=red", begin, "", '"colour=red"'),
                ("degrees=63x", begin, "", '"degrees=63x"'),
                ("convention=none&pixel=4,4", begin, "", '"convention=none"'),
                ("pixel=4000,2", begin, "", "beyond the picture")):
            place.open(browser, "05_y_rotation.html#" + asked, is_file)
            becomes = "#" + asked if becomes is None else becomes
            browser.wait(f"{DONE} && {COMMAND} === {command!r} && location.hash === {becomes!r}",
                         20)
            if says not in browser.run(SAYS) or not says and browser.run(SAYS):
                yield f"{asked}: the page says {browser.run(SAYS)!r}"
            if "277" in asked:
                browser.wait("$('.live-loupe').textContent.includes('column 444, row 277')", 20)
        place.open(browser, "06_phong_texture_blend.html#scene=lecture", is_file)  # presets others
        browser.wait(f"{DONE} && {COMMAND} === './course run 06 --scene lecture'", 20)
        place.open(browser, "05_y_rotation.html", is_file)
        browser.wait(DONE, 20)
        # A moved slider is in the address, and an address of hand moves the slider.
        field = "$('#live--degrees')"
        browser.run(f"{field}.value = 12; {field}.dispatchEvent(new Event('input'))")
        browser.wait(f"{DONE} && location.hash === '#degrees=12'", 20)
        browser.run("location.hash = 'degrees=77&samples=4'")
        browser.wait(f"{field}.value === '77' && {COMMAND}.endsWith('--samples 4')", 20)
        place.open(browser, "05_y_rotation.html?only=picture#degrees=63", is_file)
        browser.wait(DONE, 20)
        browser.size(320, 600)
        if browser.run("$$('header, h1, main > p').some((one) => "
                       "one.getClientRects().length) || document.documentElement.scrollWidth > 320 "
                       f"|| ({BOTTOM})('.live-most') > 600"):
            yield "?only=picture shows more than the picture, or it does not fit"
        browser.size(1280, 900)


def check_own_addresses(place, browser):
    """The cover and the pages of 13 and 14 keep their settings in the address, too, and say what
    they do not know."""
    place.policy = WITH_WASM
    for page, asked, field, value, other, becomes in (
            ("index.html", "#radii=100", ".far input", "200", "500", "#radii=100000"),
            ("13_speed_for_accuracy.html", "#budget=-6", "#budget", "-6", "-3", "#budget=-3"),
            ("14_numerical_extremes.html", "#exhibit=pole&at=0.5&number=double", "#extreme", "0.5",
             "1.25", "#exhibit=pole&at=1.25&number=double")):
        place.open(browser, page + asked)
        browser.wait(f"{DONE} && $({field!r}).value === {value!r}", 60)
        move = (f"((one) => {{ one.value = {other}; one.dispatchEvent(new Event('input')); }})"
                f"($({field!r}))")
        browser.run(move)
        browser.wait(f"location.hash === {becomes!r}", 10)
        browser.run("location.hash = 'main'")  # a place on the page
        if browser.run("Boolean($('.live-says'))"):
            yield f"{page}: a place's address is taken for a setting"
        browser.run("location.hash = 'radii=x&budget=x&at=x'")
        browser.wait("$('.live-says')?.textContent.includes('=x')", 10)
        browser.run(move)
        browser.wait("!$('.live-says')", 10)
        if page[:2] == "14":
            browser.run("location.hash = 'exhibit=pole&number=half'")
            browser.wait("$('.live-says')?.textContent.includes('=half')", 10)
        if page[:2] in ("13", "14"):  # what a worker that is gone owes
            browser.run("void dispatchEvent(new PromiseRejectionEvent('unhandledrejection', "
                        "{promise: Promise.resolve(), reason: new Error('no memory')}))")
            browser.wait("$('.budget').textContent.includes('stopped (no memory)')", 10)


# Rows of the loupe without code on a page: they say where the pixel is, or their module alone
# calculates them, about what the program does.
WITHOUT_CODE = {"", "pixel", "filter", "mean light", "spread", "error of the mean", "here"}
# Points at places of the picture in its window; gives each row and where its name leads.
ROWS = """(async () => {
  const canvas = $(".live-picture canvas"), rows = {};
  const box = canvas.getBoundingClientRect();
  for (let i = 1; i < 14; ++i) for (let j = 1; j < 10; ++j) {
    canvas.dispatchEvent(new PointerEvent("pointermove", {clientX: box.left + box.width * i / 14,
      clientY: box.top + box.height * j / 10, bubbles: true, pointerType: "mouse"}));
    await new Promise((done) => setTimeout(done, 25));
    for (const row of $$(".live-loupe tr"))
      rows[row.dataset.name] = row.querySelector("th a")?.getAttribute("href") || "";
  }
  return rows;
})()"""
# Points at a row: gives what lines say at their ends, and whether all that are lit can be seen.
POINT = """((name) => {
  const row = $$(".live-loupe tr").find(
    (one) => one.dataset.name === name);
  row.cells[0].dispatchEvent(new PointerEvent("pointerover", {bubbles: true}));
  const lit = $$("pre .live-lit");
  return [lit.flatMap((one) => one.dataset.value || []),
    lit.every((one) => one.getClientRects().length), row.cells[1].textContent];
})"""


def check_rows(place, browser):
    """Each row of the loupe leads to the code that calculates it, on this page or one before, and
    lights its lines, which say the row's number; each line that is marked has a row."""
    place.policy = WITH_WASM
    for page in [one for one in place.chapters if "01" <= one[:2] <= "12"]:
        seen = {}
        for words in ("", *{"06": ("#scene=lecture",), "12": ("#show=normal",)}.get(page[:2], ())):
            place.open(browser, page + words)
            browser.wait(DONE, 60)
            seen |= browser.run(ROWS)
        for name, leads in seen.items():
            if (not leads) != (name in WITHOUT_CODE):
                yield f"{page}: the row {name!r} leads to {leads!r}"
            file, _, line = leads.partition("#")
            text = (place.out / (file or page)).read_text() if leads else ""
            if leads and f'id="{line}"' not in text:
                yield f"{page}: the row {name!r} leads nowhere: {leads}"
        named = browser.run("$$('[data-row]').flatMap((line) => line.dataset.row.split('|'))")
        known = {part for name in seen for part in (name, *name.split(", "))}
        if set(named) - known:
            yield f"{page}: no row has the lines of {set(named) - known}"
        for name in sorted({one for one in seen if seen[one].startswith("#")} & set(browser.run(
                "$$('.live-loupe tr').map((row) => row.dataset.name)"))):
            values, shown, told = browser.run(f"{POINT}({name!r})")
            said = {part.partition(": ")[2] or part for one in values for part in one.split("; ")}
            if not shown or not any(one in told for one in said):
                yield f"{page}: at {name!r}, {told!r}, the lines say {values}, shown: {shown}"


BROKEN = "$('.live-break')"
VERDICT = f"{BROKEN}.querySelector('div')"
HERE_ONLY = "$('.live-command > span:last-child').textContent"
CHOOSE = f"""((k) => {{ const list = {BROKEN}.querySelector("select");
  list.selectedIndex = k; list.dispatchEvent(new Event("change")); }})"""
# The pixels of a canvas in the picture that are not those of the page's right picture.
UNLIKE = """((canvas) => {
  const {width, height} = $(canvas);
  const pixels = new Uint32Array($(canvas).getContext("2d")
    .getImageData(0, 0, width, height).data.buffer);
  window.right ??= pixels;
  return right.filter((one, i) => one !== pixels[i]).length;
})"""

# The page's own second picture, where it has one: how it lies, and its pixels.
SECOND = """(() => { const canvas = document.querySelector(".live-second > canvas");
  return canvas?.checkVisibility() && [canvas.parentElement.className, canvas.toDataURL()]; })()"""


def check_mistakes(place, browser):
    """Break it: each mistake of a page draws another picture, and the right one stays beside it;
    of three the page knows which one it drew; afterwards the page's own second picture is back."""
    place.policy, tried = WITH_WASM, 0
    browser.size(1280, 900)
    for page in place.chapters:
        place.open(browser, page)
        browser.wait("true" if page[:2] == "00" else DONE, 60)
        slips = json.loads(browser.run("$('main').dataset.slips || '[]'"))
        if page[:2] == "12":
            del slips[2:]  # its light takes seconds
        if slips:
            browser.run(f"{UNLIKE}('.live-picture > canvas')")
            browser.run(f"{BROKEN}.open = true")
            usual, second = browser.run(COMMAND), browser.run(SECOND)
        for k, slip in enumerate(slips):
            browser.run(f"{CHOOSE}({k + 1})")
            browser.wait(f"{VERDICT}.textContent.startsWith({json.dumps(slip['words'])})", 60)
            wrong, lost = (browser.run(f"{UNLIKE}({canvas!r})") for canvas in (
                ".live-picture > canvas", ".live-second > canvas"))
            command = browser.run(COMMAND)
            is_typed = shlex.split(command)[-len(slip["typed"]):] == slip["typed"]
            if slip["typed"][0] == "--mistake":  # of the page alone
                is_typed = command == usual and "the mistake" in browser.run(HERE_ONLY)
            shown = browser.run(f"{VERDICT}.textContent")
            if wrong < 500 or lost or not is_typed or f" {wrong:,} of " not in shown or not all(
                    line in shown for line in slip["right"].split("\n")):
                yield f"{page}, {slip}: {wrong} pixels changed, {lost} lost, {command}"
        if page[:2] == "05":  # the second while the right picture of the first is still drawn
            browser.run("{ const one = $('#live--degrees'); one.value = 30; "
                        f"one.dispatchEvent(new Event('input')); }} {CHOOSE}(1); {CHOOSE}(2)")
            browser.wait(f"{VERDICT}.textContent.startsWith({json.dumps(slips[1]['words'])}) && "
                         f"{DONE}", 60)
            if browser.run(f"{UNLIKE}('.live-second > canvas')"):
                yield f"{page}: another mistake's picture stands as the right one"
        for _ in range(2 if slips else 0):
            browser.run(f"{BROKEN}.querySelector('button').click()")
            browser.wait(f"!!{VERDICT}.querySelector('button')", 60)
            is_hidden = browser.run("$('.live-command').hidden")
            if not browser.run(f"{VERDICT}.getBoundingClientRect().bottom <= innerHeight + 1 && "
                               f"({BOTTOM})('.live-picture') > 300"):
                yield f"{page}: the picture and the three answers are not seen together"
            answer = browser.run(f"{VERDICT}.querySelector('button').textContent")
            browser.run(f"{VERDICT}.querySelector('button').click()")
            says = browser.run(f"{VERDICT}.textContent")
            if not is_hidden or not says.startswith(
                    "Yes: " + answer if answer in says else "No, it is: "):
                yield f"{page}: to {answer!r} it says {says!r}"
        if slips:
            browser.run(f"{CHOOSE}(0)")
            browser.wait(f"!{VERDICT}.textContent && {DONE}", 60)
            if browser.run(SECOND) != second:
                yield f"{page}: after its mistakes its second picture is another one"
        tried += len(slips)
    if tried < 20:
        yield f"only {tried} mistakes"


def main():
    book, root = typed_paths(__doc__, 2, lambda _, root: root / "docs/live/modules.js")
    with tempfile.TemporaryDirectory() as folder:
        place = Place(book, root, Path(folder))
        failed = run_checks((check_screens, check_forbidden, check_addresses, check_own_addresses,
                             check_rows, check_mistakes), place)
        place.server.shutdown()
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
