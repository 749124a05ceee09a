#!/usr/bin/env python3
"""The book, a page of ./course diff and the gallery in a real browser, in light and dark, 360, 1280
and 1920 pixels wide: everything fits, can be read, is there, and works.

usage: test_book.py BOOK ROOT BIN
BOOK makes the book, ROOT is the project, BIN has the chapters' programs. Status 77 where no browser
is installed. out/ as a whole is small enough to be sent: the book, the chapters' pictures, the
turntable and the pages of ./course diff."""
import html
import json
import pathlib
import re
import shlex
import shutil
import struct
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "browser"))
from browser import Browser, Fault, typed_paths  # noqa: E402

MOST_KB = 10752  # 10.5 MB of 1024 KB each

# What is wrong with the page that is shown. Contrast: WCAG 2.1.
LOOK = """(async () => {
  const faults = [];
  const start = (e) => e.outerHTML.slice(0, 80);
  for (const e of $$("details")) e.open = true;
  const width = document.documentElement.scrollWidth;
  if (width > innerWidth) {
    const wide = $$("main *").find(
      (e) => e.getBoundingClientRect().right > innerWidth + 1 && !e.closest("pre, .scroll"));
    faults.push(`too wide: ${width}, ${wide ? start(wide) : "?"}`);
  }
  for (const image of document.images) image.loading = "eager";
  const end = performance.now() + 2000;
  while ([...document.images].some((image) => !image.complete) &&
    performance.now() < end) await new Promise((done) => setTimeout(done, 20));
  for (const image of document.images) {
    if (!image.hasAttribute("alt")) faults.push(`no alt text: ${start(image)}`);
    if (!image.naturalWidth) faults.push(`no picture: ${image.getAttribute("src")}`);
  }
  for (const e of $$("[src], link[href]")) {
    if (/^https?:/.test(e.getAttribute("src") || e.getAttribute("href"))) faults.push(
      `needs the network: ${start(e)}`);
  }
  for (const e of $$("math")) {
    const outside = [...e.querySelectorAll("*")].some((one) => !one.matches("mi, mn, mo, mtext") &&
      [...one.childNodes].some((n) => n.nodeType === 3));
    if (e.children.length !== 1 || outside || e.querySelector(
      "mi:empty, mfrac > :nth-child(3)")) faults.push(`a formula: ${start(e)}`);
  }
  const ids = $$("[id]").map((e) => e.id);
  if (new Set(ids).size !== ids.length) faults.push("an id is used twice");
  for (const e of $$("button, input, summary, a")) {
    if (!(e.textContent.trim() || e.labels?.length || e.getAttribute("aria-label") ||
      e.querySelector("img"))) faults.push(`no name: ${start(e)}`);
  }
  const numbers = (color) => color.match(/[\\d.]+/g).map(Number);
  const luminance = (rgb) => {
    const [r, g, b] = rgb.slice(0, 3).map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92
      : ((c / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const background = (e) => {
    for (; e; e = e.parentElement) {
      const color = numbers(getComputedStyle(e).backgroundColor);
      if (color.length === 3 || color[3] === 1) return color;
    }
    return [255, 255, 255];
  };
  const contrast = (a, b) => {
    const [dark, light] = [luminance(a), luminance(b)].sort((x, y) => x - y);
    return (light + 0.05) / (dark + 0.05);
  };
  for (const e of $$("#search, main button, main select")) {
    const ratio = contrast(numbers(getComputedStyle(e).borderTopColor), background(
      e.parentElement));
    if (ratio < 3) faults.push(`contrast of a border ${ratio.toFixed(2)}: ${start(e)}`);
  }
  const seen = new Set();
  for (const e of $$("body *")) {
    if (![...e.childNodes].some((n) => n.nodeType === 3 && n.textContent.trim())) continue;
    const style = getComputedStyle(e);
    if (parseFloat(style.fontSize) < 11) faults.push(`letters of ${style.fontSize}: ${start(e)}`);
    const key = style.color + background(e) + style.fontSize;
    if (seen.has(key) || style.display === "none" || e.matches("script, style")) continue;
    seen.add(key);
    const ratio = contrast(numbers(style.color), background(e));
    if (ratio < (parseFloat(style.fontSize) >= 24 ? 3 : 4.5)) faults.push(
      `contrast ${ratio.toFixed(2)}: ${start(e)}`);
  }
  for (const e of $$("img[src$='.svg'], img[data-letters]")) {
    if (e.clientWidth < 10.9 / (e.dataset.letters || 13) * e.naturalWidth) faults.push(
      `letters shrink below 11 px: ${start(e)}`);
  }
  for (const e of $$(".crops svg")) if (e.clientWidth < 125) faults.push(
    `a crop is ${e.clientWidth} px wide: ${start(e)}`);
  return faults;
})()"""

# The characters a line of paragraphs of at least four lines; the last line is half full.
MEASURE = """(() => {
  const counts = [];
  for (const p of $$("main > p:not([class], :has(> img, > .crops))")) {
    const lines = Math.round(p.clientHeight / parseFloat(getComputedStyle(p).lineHeight));
    if (lines >= 4) counts.push(p.textContent.length / (lines - 0.5));
  }
  return counts;
})()"""

# Per page: what is done, and what the page then shows.
USES = {
    "01_plain_spheres.html": [
        (
            "document.activeElement.dispatchEvent(new KeyboardEvent('keydown', {key: '/', "
            "bubbles: true}))", "document.activeElement.id === 'search'"),
        ("find('lambert')", "$$('#found a').some((a) => "
                            "a.getAttribute('href').startsWith('01_plain_spheres.html'))"),
        # nothing is found in an empty box
        ("$('#found').onclick = (event) => { event.preventDefault(); window.went = true; }; "
         "find(''); document.activeElement.dispatchEvent(new KeyboardEvent('keydown', "
         "{key: 'Enter', bubbles: true}))", "$('#found').hidden && !window.went"),
        # The phrase first, and marked as one; whole words before those that begin so; nothing
        # within a word.
        ("find('Half a  texel')",
         "texts('#found li:first-child small mark').join() === 'half a texel'"),
        ("find('ray')", "/ ray( |$)/i.test(texts('#found a')[0].split('…')[0]) && texts('#found "
                        "mark').every((mark) => /^rays?$/i.test(mark))"),
        ("find('texel half')", "texts('#found mark').includes('texel') && texts('#found "
                               "mark').includes('half')"),
        ("find('lamber')", "texts('#found mark').some((mark) => /^lambert$/i.test(mark))"),
        ("find('exel')", "$('#found').textContent.startsWith('Nothing')"),
        ("find('qqqzzz')", "$('#found').textContent.startsWith('Nothing')"),
        ("delete window.DecompressionStream; find('lambert')",
         "$('#found').textContent.startsWith('Search needs a newer browser')"),
        ("document.activeElement.dispatchEvent(new KeyboardEvent('keydown', {key: 'Escape', "
         "bubbles: true})); document.activeElement.blur()",
         "$('#found').hidden"),
        ("document.activeElement.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight', "
         "bubbles: true}))", "location.href.endsWith('02_checkerboard_uv.html')"),
    ],
    "diff/02-03/index.html": [
        ("{ const s = $('.slider input'); s.value = 25; s.dispatchEvent(new "
         "Event('input')); }", "cut() === '25%'"),
        ("$$('.slider button')[1].click()", "cut() === '100%'"),
        ("$$('.slider button')[2].click()", "cut() === '0%'"),
        ("$('.slider button').click()",
         "$('.slider button').getAttribute('aria-pressed') === 'true'"),
        ("$('.slider button').click()",
         "$('.slider button').getAttribute('aria-pressed') === 'false'"),
        ("", "$$('input, button, pre[tabindex]').filter((e) => { "
             "e.focus(); return document.activeElement === e; }).length === 5"),
    ],
    "gallery.html": [
        ("",
         "$$('figure img').filter((e) => e.naturalWidth).length >= 15"),
    ],
    "index.html": [
        ("", "texts('.path span').slice(0, 3).join() === '●●○,○○●,○○○'"),
        ("", "texts('.path li').length === 15 && texts('.path li').every((e) => e.includes('?') "
             "&& e.includes('hour'))"),
        ("", "texts('.path li > p:nth-of-type(1)').every((e) => /[0-9]|One/.test(e)) && "
             "texts('.path li')[1].includes('changes 76 of 480,000 pixels')"),
    ],
    "symptoms.html": [
        ("find('normal')", "$('#found').getBoundingClientRect().left >= 0 && "
                           "texts('#found a').length > 3"),
        ("$('h1').dispatchEvent(new PointerEvent('pointerdown', {bubbles: true}))",
         "$('#found').hidden"),
        ("", "texts('.cards article').length >= 19 && !texts('th').length"),
        ("", "texts('.two')[0].trim() === 'yoursright' && texts('.cards h3')[0].startsWith('… "
             "mirrored') && texts('.cards a')[0] === 'chapter 04'"),
        ("", "texts('.two').every((e) => e.trim() === 'yoursright') && "
             "$$('.two img').length === 2 * texts('.two').length"),
        ("", "$$('.cards article').every((e) => e.querySelector('img').src.includes('-' + e.id + "
             "'.png')) && !!document.getElementById('mirrored')"),
    ],
    # Formulas. Fractions with blanks take all between two signs, without blanks their neighbors;
    # parentheses fall away.
    "02_checkerboard_uv.html": [("", "fraction('atan2(z,x)', '2π') && fraction('1', '2') && "
                                     "fraction('atan2(x2+z2,−y)', 'π')")],
    "06_phong_texture_blend.html": [("", "fraction('|r−e|2', '2')")],
    "07_earth_by_sampling.html": [("", "fraction('x+0.055', '1.055') && fraction('cosθ', 'π') && "
                                       "texts('mtext').includes('if it misses')")],
    "09_texture_filtering.html": [
        ("", "texts('.trio figcaption')[0] === 'nearest: 1 read, 30.4 % off'"),
        ("", "fraction('|puqv−qupv|', 'longer') && texts('msqrt').includes('(A−B2)2+C2') && "
             "texts('msubsup').includes('pu2')")],
    "10_projections.html": [
        ("", "fraction('(p−c)·a', '2a·a')"),
        # Bars on common axes: twice as long for twice the number.
        ("", "texts('.bars th').join('|') === 'layout|largest texel, 0 to 2|stretch, 0 to "
             "3|seams, 0 to 600'"),
        ("", "$$('.bars td[data-head=seams]').every((e) => "
             "Math.abs(e.querySelector('.bar').width.baseVal.value * 6 - "
             "parseFloat(e.textContent)) < 0.5) && $$('.bars .open').length === 4"),
    ],
    "12_environment_map.html": [("", "fraction('2π', 'width') && texts('mi').includes('albedo')")],
    "04_uv_conventions.html": [("", "texts('.quad figcaption')[0] === 'daily exercise: u runs "
                                    "west, v runs south, a picture on it is mirrored'")],
    "13_speed_for_accuracy.html": [
        # The plot has what the reader's ./course run 13 measured.
        ("", "$$('.budget-point').length === 3 && $('.budget-front').points.numberOfItems === 2"),
        ("$('[aria-label^=\"float-pack, degree 5\"]').dispatchEvent(new MouseEvent('click'))",
         "/0.21 texels off. 5,747 pixels .* 20 times as fast/.test(texts('.budget-says')[0])"),
    ],
    "14_numerical_extremes.html": [
        ("$('#exhibit-turns').scrollIntoView()",
         "texts('.names [aria-current]').join() === 'turns'"),
        ("", "texts('.pairs strong').join() === 'from-1e5,pole,needle,small' && texts('.pairs "
             "figcaption')[1].endsWith('acos magnifies the rounding of y')"),
        ("", "texts('.exhibits article').length === 20 && shown('.pairs .two "
             "span')[0].startsWith('published, float29669 wrong, 2000 texels off') && "
             "texts('sup').includes('k − 23')"),
        ("$('.pairs svg').dispatchEvent(new MouseEvent('click', {bubbles: true}))",
         "shown('.pairs .two span').slice(0, 5).join('|').startsWith('published, double2 wrong, "
            "0.11 texels off|robust, double0 wrong, 1.2e-11 texels off||published, float')"),
    ],
    "05_y_rotation.html": [
        ("", "fraction('β', '360°') && texts('.flow')[0].startsWith('direction → rotate') && "
             "texts('td').includes('(−1,\u00a00,\u00a00)')"),
        ("$('button[data-frames]').click()",
         "/_00[1-9].png$/.test(turning().src)"),
        ("$('button[data-frames]').click()",
         "turning().getAttribute('src') === '05_y_rotation_000.png'"),
        ("Object.defineProperty(navigator, 'clipboard', {value: {writeText(words) { window.copied "
         "= words; }}}); $('.command button').click()",
         "copied === './course run 05 --degrees 30' && texts('.command button')[0] === 'Copied'"),
        ("",
         "$$('.command button').every((e) => e.offsetHeight >= 36)"),
    ],
}
HELPERS = """
function find(words) { const box = $('#search'); box.value = words;
  box.dispatchEvent(new Event('input')); }
function shown(what) { return $$(what).filter(
  (e) => e.getClientRects().length).map((e) => e.textContent.replaceAll("\\u2060", "")); }
function cut() { return $('.pair').style.getPropertyValue('--cut'); }
function texts(what) { return $$(what).map((e) => e.textContent); }
function fraction(above, below) { return $$("mfrac").some((e) =>
  e.children[0].textContent === above && e.children[1].textContent === below); }
function turning() { return $('button[data-frames]').closest(
  'figure').querySelector('img'); }"""


def run(*words):
    subprocess.run([str(word) for word in words], check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)


def made_up_way(number, degree, time, bound, changed, levels, command):
    """As chapter 13 writes what it measured."""
    return {"command": command, "number": number, "instructions": "baseline", "degree": degree,
            "filter": "nearest", "time": time,
            "texels_bound": bound, "changed": changed, "levels": levels}


def make_out(book, root, programs, out):
    """What ./course makes in out/, with golden pictures in place of drawing them again; and the
    gallery, for who has no cmark-gfm."""
    out.mkdir()
    names = [folder.name for folder in sorted((root / "chapters").glob("[0-9][0-9]_*/"))]
    for name in names:
        golden = root / "tests" / "golden" / f"{name}.png"
        if golden.exists():
            shutil.copy(golden, out)
        else:
            run(programs / name, "--out", out / golden.name)
    turntable = re.search(r"05_y_rotation_000\.png (--turntable [^)]*)\)",
                          (root / "chapters" / "CMakeLists.txt").read_text())
    run(programs / "05_y_rotation", "--quiet", "--out", out / "05_y_rotation.png",
        *shlex.split(turntable[1]))
    run(programs / "compare_steps", "--quiet", "--shared", "--drawn", out, "--out", out / "diff")
    run("cmake", f"-DCHAPTERS={';'.join(names)}", f"-DFOLDER={root / 'chapters'}",
        f"-DGALLERY={out}", "-P", root / "common/tools/gallery.cmake")
    (out / "index.html").rename(out / "gallery.html")
    places = [made_up_way("double", 0, 1, 1.6e-11, 0, 0, "run double"),
              made_up_way("double", 23, 1.5, 7e-9, 0, 0, "run 23"),
              made_up_way("float-pack", 5, 0.05, 0.21, 5747, 156, "run packs")]
    (out / "13_speed_for_accuracy.json").write_text(json.dumps({"places": places}))
    (out / "exercises").mkdir()
    # as ./course check writes it
    (out / "exercises" / "passed.txt").write_text("01.1 1 2\n02.3 1 2\n01.2 1 2\n")
    run(book, root, out)


def faults_of_files(out):
    # Pictures that the reader draws and changes are no part of the book, which has copies of its
    # own.
    drawn = [path for path in out.glob("[0-9][0-9]_*.png")
             if (out / "pictures" / f"tests-golden-{path.name}").exists()]
    size = sum(path.stat().st_size for path in out.rglob("*") if path.is_file()
               and path not in drawn) // 1024
    print(f"the book: {size} KB")
    if (out / "book.css").stat().st_size > 16384:
        yield "book.css is larger than 16 KB"
    if size >= MOST_KB:
        yield f"the book has {size} KB, more than {MOST_KB}"
    # A picture without its size moves the text when it arrives.
    for page in out.glob("*.html"):
        for picture in re.findall(r'<img [^>]*loading="lazy" src="pictures/[^>]*>',
                                  page.read_text()):
            if page.name not in ("index.html", "print.html",
                                 "gallery.html") and " width=" not in picture:
                yield f"{page.name}: a picture without a width: {picture[:120]}"
    # The lines of all sources have numbers, which stand in source.css; a page has 19 lines around
    # its source.
    numbers = len(re.findall(r"\d\\a", (out / "source.css").read_text()))
    longest = max(page.read_text().count("\n") for page in (out / "source").glob("*.html"))
    if numbers <= longest - 25:
        yield f"source.css numbers {numbers} lines, and a source page has {longest}"


def faults_of_formulas(out):
    """The indented blocks that no rule takes for a formula are listed: each is code, a command or
    what a program prints."""
    formulas = 0
    for page in sorted(out.glob("*.html")):
        text = page.read_text()
        formulas += text.count("<math>")
        for block in re.findall(r'<div class="code[\w ]* indented"><pre '
                                r'tabindex="0"><code>(.*?)</code>', text, re.DOTALL):
            print(f"{page.name}: no formula: {block.splitlines()[0]}")
            if not re.search(r"[;{*]|\./|--|\bbuild\b|error:", block):
                yield f"{page.name} has a formula that no rule understands: {block}"
    if formulas < 60:
        yield f"{formulas} formulas"


def faults_of_places(out, root):
    """Each block of code that a page takes from a file has the file and the line above it, and a
    link to that line."""
    def plain(markup):
        return html.unescape(re.sub("<[^>]*>", "", markup)).strip()
    for source in [*root.glob("chapters/*/README.md"), *root.glob("docs/*.md")]:
        page = out / f"{source.parent.name if source.name == 'README.md' else source.stem}.html"
        places = re.findall(r'<div class="place"><a '
                            r'href="([^"]*)#L(\d+)">([^<]*):\2</a>.*?<code>(.*?)\n',
                            page.read_text())
        marks = len(re.findall("^<!-- code:", source.read_text(), re.MULTILINE))
        if len(places) != marks:
            yield f"{page.name} has {len(places)} places of {marks} pieces of code"
        for link, line, path, first in places:
            shown = re.search(rf'<span id="L{line}">(.*?)</span>\n', (out / link).read_text())
            lines = (root / path).read_text().splitlines()
            if not shown or not plain(shown[1]) == plain(first) == lines[int(line) - 1].strip():
                yield f"{page.name}: {path}:{line} is not: {plain(first)}"


def faults_of_notes(out, root):
    """A note in the margin has the glossary's words, once a page, beside a text with its term."""
    known = dict(re.findall(r"^\| ([^|]+) \| ([^|]+) \| \[",
                            (root / "docs/glossary.md").read_text(), re.MULTILINE))
    count = 0
    for page in sorted(out.glob("[0-9][0-9]_*.html")):
        notes = re.findall(r"<p>((?:(?!</p>).)*)</p>\n<aside class=\"note\"><b>(.*?)</b> (.*?)"
                           r"</aside>", page.read_text(), re.DOTALL)
        count += len(notes)
        if len({term for _, term, _ in notes}) != page.read_text().count('class="note"'):
            yield f"{page.name} has a note twice, or beside no text"
        for text, term, meaning in notes:
            said = html.unescape(re.sub("<[^>]*>", "", text)).replace("\xa0", " ")
            if term not in said or html.unescape(meaning) != known.get(html.unescape(term)):
                yield f"{page.name}: {term!r} is not in {said!r}, or does not mean {meaning!r}"
    if count < 40:
        yield f"only {count} notes in the margins"


def faults_of_sheets(out, root):
    """All pictures and all words of a sheet are on its chapter's page, but not the sheet as a
    whole, whose letters are small."""
    for sheet in (root / "docs/sheets.txt").read_text().split("sheet ")[1:]:
        head, *parts = sheet.splitlines()
        chapter, width, height = head.split()[:3]
        page = (out / f"{chapter}.html").read_text()
        words = html.unescape(re.sub("<[^>]*>|\u2060", "", page))
        picture = f"pictures/tests-golden-{chapter}.png"
        size = struct.unpack(">II", (out / picture).read_bytes()[16:24])
        if re.search(f'<img[^>]*{picture}', page) or (int(width), int(height)) != size:
            yield f"{chapter}.html shows {picture}, {size}, in one piece or in another size"
        for part in parts:
            kind, what = part.split(" ", 1)
            if kind == "picture":
                left, top, across, down = map(int, what.split())
                if f'"{left}.5 {top}.5 {across - 1} {down - 1}"' not in page:
                    yield f"{chapter}.html lacks the picture at {what}"
            elif not all(word in words for word in re.split(r"  +| (?=no bound$|[\d.]+°?$)", what)):
                yield f"{chapter}.html lacks: {what}"


def faults_of_pages(out, pages):
    counts = {1920: [], 1280: [], 360: []}
    with Browser() as browser:
        for scheme in ("light", "dark"):
            browser.media(prefers_color_scheme=scheme)
            for page in pages:
                browser.size(1280, 900)
                browser.open(f"file://{out}/{page}")
                for width in (1920, 1280, 360):
                    browser.size(width, 900)
                    yield from (f"{page}, {scheme}, {width} wide: {fault}"
                                for fault in browser.run(LOOK))
                    if scheme == "light":
                        counts[width] += browser.run(MEASURE)
        for width, least, most in ((1920, 66, 72), (1280, 66, 72), (360, 32, 46)):
            mean = sum(counts[width]) / max(1, len(counts[width]))
            print(f"{width} wide: {mean:.1f} characters a line in {len(counts[width])} paragraphs")
            if len(counts[width]) < 20 or not least <= mean <= most:
                yield (f"{width} wide: {mean} characters a line in {len(counts[width])} "
                       f"paragraphs, not {least} to {most}")
        for page, uses in USES.items():
            browser.size(768 if page == "symptoms.html" else 1280, 900)
            browser.open(f"file://{out}/{page}")
            for act, shows in uses:
                browser.run(f"{HELPERS}\n{act}")
                browser.wait(shows, 10)
        yield from browser.log


def faults_of_links(book, root, work):
    """A link that leads nowhere stops the making of the book, and is named."""
    (work / "chapters" / "01_a").mkdir(parents=True)
    (work / "docs").mkdir()
    shutil.copytree(root / "common/tools/book", work / "common/tools/book")
    (work / "chapters/01_a/README.md").write_text("# 01\n\n[a](none.md) [b](#none)\n")
    made = subprocess.run([book, work, work / "out"], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    if (made.returncode == 0 or "none.md leads nowhere" not in made.stdout
        or "has no heading #none" not in made.stdout):
        yield f"links that lead nowhere: status {made.returncode}, {made.stdout}"


def main():
    book, root, programs = typed_paths(__doc__, 3)
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out"
        make_out(book, root, programs, out)
        pages = sorted(page.name for page in out.glob("*.html")) + ["diff/02-03/index.html"]
        print(f"{len(pages)} pages", flush=True)
        faults = [*faults_of_files(out), *faults_of_formulas(out), *faults_of_places(out, root),
                  *faults_of_sheets(out, root), *faults_of_notes(out, root),
                  *faults_of_links(book, root, pathlib.Path(folder) / "root")]
        try:
            for fault in faults_of_pages(out, pages):
                faults.append(fault)
        except Fault as fault:
            faults.append(str(fault))
    for fault in faults:
        print(f"FAIL: {fault}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
