// The error microscope of the cover. live/cover.js calls texmapCover with the module and the map;
// where a browser lacks something, or that file is missing, the still picture stays.
"use strict";
// The place of what comes with the module stays free until the module is there, or fails.
const texmapHero = document.querySelector(".hero");
const texmapStays = () => texmapHero.classList.remove("waits");
document.querySelector("script[src='live/cover.js']").onerror = texmapStays;
const texmapCover = async (packed, earth) => {
  const hero = texmapHero;
  const part = (what) => hero.querySelector(what);
  const [canvas, pin, slider, shown, table, said] = ["canvas", ".stage i", "input", ".far span",
    "table", ".said"].map(part);
  const {element, open, unpacked, bytesOf, isPlace, checkAddress, partsOf} = texmapLive.of;
  let code;
  try {
    code = (await open(await WebAssembly.compile(await unpacked(bytesOf(packed))))).calls;
    const map = bytesOf(earth), start = code.take(map.length);
    new Uint8Array(code.memory.buffer).set(map, start);
    if (!code.keep_map(start, map.length)) throw new Error();
  } catch (error) {
    texmapStays();
    if (error.name !== "CompileError") return;
    said.className = "legend";
    said.textContent = "The picture stays still: this server's policy forbids WebAssembly.";
    return;
  }

  // From the eye to the surface: three digits, as the page says them.
  const radii = () => Number((10 ** (slider.value / 100)).toPrecision(3));
  const place = {across: 0.2, down: 0.42};         // of the pixel, in the picture
  const paper = canvas.getContext("2d", {willReadFrequently: true}),
    small = document.createElement("canvas");
  const sketch = small.getContext("2d", {willReadFrequently: true});
  let perPixel = 2e-4;  // milliseconds that a pixel takes
  let idle = 0, asked = 0, telling = 0;

  // ---- The picture.
  function paint(onto, size, first, count) {
    const began = performance.now();
    const start = code.draw(radii(), size, first, count);
    const pixels = new Uint8ClampedArray(code.memory.buffer, start, 4 * size * count);
    onto.putImageData(new ImageData(pixels, size), 0, first);
    perPixel = (performance.now() - began) / (size * count);
  }
  const fullSize = () => Math.max(64, Math.min(620, Math.round(canvas.parentElement.clientWidth)));
  const affordable = () => 20 / perPixel;  // pixels in 20 ms
  // In strips: the hand may move on.
  function full(first = 0) {
    const size = canvas.width,
      count = Math.max(1, Math.min(size - first, Math.floor(affordable() / size)));
    paint(paper, size, first, count);
    if (first + count < size) idle = setTimeout(full, 0, first + count);
    else hero.dataset.state = "done";
  }
  // While the hand moves, as many pixels as it does not wait for; all of them when it rests.
  function change() {
    hero.dataset.state = "drawing";
    clearTimeout(idle);
    const wanted = fullSize();
    if (canvas.width !== wanted) canvas.width = canvas.height = wanted;
    small.width = small.height = Math.min(wanted,
      Math.max(64, Math.floor(Math.sqrt(affordable()))));
    paint(sketch, small.width, 0, small.width);
    paper.drawImage(small, 0, 0, wanted, wanted);
    idle = setTimeout(full, 150);
    look();
  }
  function soon() {
    asked ||= requestAnimationFrame(() => { asked = 0; change(); });
  }

  // ---- A pixel's numbers. All of them are exact here: whole multiples of 2^-256.
  const unit = 2n ** 256n;
  const exact = (...parts) =>
    parts.reduce((sum, one) => sum + BigInt(Math.trunc(one * 2 ** 256)), 0n);
  const magnitude = (number) => number < 0n ? -number : number;
  // A number times 10^places, rounded.
  const rounded = (number, places) => {
    const [up, down] = places < 0 ? [1n, 10n ** BigInt(-places)] : [10n ** BigInt(places), 1n];
    const whole = (2n * magnitude(number) * up + unit * down) / (2n * unit * down);
    return number < 0n ? -whole : whole;
  };
  // A number's text in two pieces: the second begins at the first place where it, rounded, is not
  // the true number, rounded.
  function pieces(number, truth, places, grouped) {
    const digits = String(magnitude(rounded(number, places))).padStart(places + 1, "0");
    const before = digits.length - places;
    const text = [rounded(number, places) < 0n ? "−" : "", ""];
    let wrong = truth === null ? 1 : 0;
    for (let i = 0; i < digits.length; ++i) {
      const at = i - before + 1;
      if (!wrong && rounded(number, at) !== rounded(truth, at)) wrong = 1;
      // a line may end here
      const mark = at === 1 ? "." : grouped && i > 0 && i < before && (before - i) % 3 === 0
        ? ",\u200b" : "";
      text[text[1] ? 1 : 0] += mark;
      text[wrong] += digits[i];
    }
    return text;
  }
  const wrongly = (text) => [element("span", {className: "said",
    textContent: " wrong from here: "}), element("i", {textContent: text})];
  const written = ([right, wrong]) => wrong ? [right, ...wrongly(wrong)] : [right];

  function look() {
    const across = Math.min(canvas.width - 1, Math.floor(place.across * canvas.width));
    const down = Math.min(canvas.width - 1, Math.floor(place.down * canvas.width));
    pin.style.left = `${100 * (across + 0.5) / canvas.width}%`;
    pin.style.top = `${100 * (down + 0.5) / canvas.width}%`;
    const all = new Float64Array(code.memory.buffer,
      code.look(radii(), canvas.width, across, down), 36);
    hero.numbers = {pixel: [canvas.width, across, down], all: [...all]};  // for the tests
    const parts = (column, step) => column < 2 ? [all[9 * column + step]] : [all[18 + 2 * step],
      all[19 + 2 * step]];
    const met = [0, 1, 2].map((column) => Number.isFinite(parts(column, 4)[0]));
    // decimals, so that the points stand in line
    const squares = Math.max(0, Math.min(5, 13 - String(Math.trunc(all[0])).length));
    const ahead = Math.max(0, 7 - String(Math.trunc(radii())).length);
    const cell = (column, row) => {
      if (column === 0 && row === 2 || column === 1 && row < 2) return ["—"];
      if (row > 3 && !met[column]) return row > 4 ? ["—"] : met[2] ? wrongly("miss") : ["miss"];
      const steps = row < 7 ? [row] : [7, 8];
      const [u, v] = [parts(column, 5)[0], parts(column, 6)[0]];
      if (row === 7 && !(u >= 0 && u < 1 && v >= 0 && v <= 1)) return wrongly("none");
      const places = row < 2 || row === 3 && column === 0 ? squares : row === 4 ? ahead
        : row === 7 ? 0 : 5;
      return steps.flatMap((step, i) => {
        const number = parts(column, step);
        if (!Number.isFinite(number[0])) return wrongly("NaN");
        const truth = row > 3 && !met[2] ? null : exact(...parts(2, step));
        return [i ? ", " : "", ...written(pieces(exact(...number), truth, places, row < 7))];
      });
    };
    [...table.tBodies[0].rows].forEach((line, row) => [0, 1, 2].forEach((column) => {
      (line.cells[column + 1] ?? line.insertCell()).replaceChildren(...cell(column, row));
    }));
    const lost = Math.floor(Math.log10(all[18] / Math.abs(all[24])));  // b² over b² - a c
    part(".why b").textContent = lost < 1 ? "here none of them cancels"
      : `here ${lost < 7 ? `${lost} of the` : "all"} 7 digits cancel`;
    table.caption.firstChild.textContent =
      `Point at any pixel. This is column ${across}, row ${down}.`;
    shown.textContent = `${radii().toLocaleString("en")} ${radii() === 1
      ? "radius" : "radii"}`;
    slider.setAttribute("aria-valuetext", `${shown.textContent} from the surface`);
  }
  // For screen readers and the address, when the hand rests.
  function tell() {
    clearTimeout(telling);
    telling = setTimeout(() => {
      if (slider.value !== slider.defaultValue || location.hash.startsWith("#radii")) {
        history.replaceState(history.state, "", `#radii=${radii()}`);
        checkAddress(slider, true);
      }
      const [u, column] = [5, 7].map((row) =>
        [...table.tBodies[0].rows[row].cells].map((one) => one.textContent));
      said.textContent = `Pixel ${hero.numbers.pixel.slice(1).join(", ")}. u: published ${u[1]}, `
        + `ours ${u[2]}, true ${u[3]}. Texel: published ${column[1]}, true ${column[3]}.`;
    }, 400);
  }

  // ---- Hands and keys.
  function point(event) {
    const [across, down] = partsOf(event, canvas)
      .map((part) => Math.max(0, Math.min(0.9999, part)));
    Object.assign(place, {across, down});
    look();
  }
  canvas.addEventListener("pointermove", point);
  canvas.addEventListener("pointerdown", point);
  canvas.addEventListener("keydown", (event) => {
    const step = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1],
      ArrowDown: [0, 1]}[event.key];
    if (!step) return;
    event.preventDefault();
    const [, across, down] = hero.numbers.pixel;
    const moved = [across, down].map((one, i) =>
      Math.max(0, Math.min(canvas.width - 1, one + step[i] * (event.shiftKey ? 10 : 1))));
    Object.assign(place,
      {across: (moved[0] + 0.5) / canvas.width, down: (moved[1] + 0.5) / canvas.width});
    look();
    tell();
  });
  slider.addEventListener("input", () => { soon(); tell(); });
  slider.addEventListener("keydown", (event) => {
    const decade = {PageUp: 100, PageDown: -100}[event.key];
    if (!decade) return;
    event.preventDefault();
    slider.valueAsNumber += decade;
    soon();
    tell();
  });
  function fromAddress() {
    const asked = Number(/^#radii=(.+)$/.exec(location.hash)?.[1]), isKnown = asked > 0;
    slider.value = isKnown ? 100 * Math.log10(asked) : slider.defaultValue;
    checkAddress(part(".why h1"), isKnown);
  }
  addEventListener("hashchange", () => { if (!isPlace()) { fromAddress(); change(); } });
  // Where the table is narrow, the true values take the place of ours.
  part("button").addEventListener("click", ({target}) => {
    target.textContent = table.classList.toggle("truth") ? "Show ours" : "Show true values";
  });

  for (const one of [canvas, pin, table, slider.parentElement]) one.hidden = false;
  part("img").hidden = true;
  texmapStays();
  fromAddress();
  change();
  new ResizeObserver(() => {
    if (canvas.width !== fullSize()) change();
  }).observe(canvas.parentElement);
};
