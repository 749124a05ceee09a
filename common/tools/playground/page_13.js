// Chapter 13's live picture: an error budget as a slider, with the chapter's own ways to draw the
// globe, by the times of ./course run 13 or of the page's table until the reader times them in this
// browser; and the same (u, v) by the reader's graphics processor, held against double.
"use strict";
if (typeof document === "undefined") importScripts("live.js");
(() => {
const {element, svg, rounded, small, copied, painted, hire, open, unpacked, isHired, begin,
  placed, inWords, isPlace, checkAddress} = texmapLive.of;

// ---- What the worker can do.
function worker() {
  let code;
  const json = (start) => JSON.parse(code.answer(start));
  const pixels = (start, count) => code.memory().slice(start, start + 4 * count);
  return {
    async load(packed, picture) {
      code = await open(await WebAssembly.compile(await unpacked(packed)));
      return code.lend([picture], (start) => json(code.calls.begin(start, picture.length)));
    },
    compare: (way) => json(code.calls.compare(way)),
    picture: (way, count) => pixels(code.calls.draw(way), count),
    pictures: (way, count) => [pixels(code.calls.draw(way), count),
      pixels(code.calls.show_changes(way), count)],
    time(way) {
      const began = performance.now();
      code.calls.draw(way);
      return performance.now() - began;
    },
    choose: (limit, times) => code.lend([new Uint8Array(times.buffer)],
      (start) => json(code.calls.choose(limit, start))),
    coefficients: (degree) => json(code.calls.coefficients(degree)),
    directions(ofMap, count) {
      const start = code.calls.probe(ofMap);  // the memory may move
      return new Float32Array(code.memory().slice(start, start + 16 * count).buffer);
    },
    judge(places, ofMap, count) {
      code.calls.probe(ofMap);
      const found = code.lend([new Uint8Array(places.buffer)],
        (start) => json(code.calls.judge(start)));
      return {...found, picture: pixels(code.calls.judged(), count)};
    },
  };
}
// ---- Words.
const named = ({number, kernel}) => `${number}, ${kernel === "reference" ? "atan2" : kernel}`;
const counted = (count, what) => `${count.toLocaleString("en")} ${what}${count === 1 ? "" : "s"}`;
const dot = ({number}, x, y, r) => number.endsWith("-pack") ? svg("rect",
  {x: x - r, y: y - r, width: 2 * r, height: 2 * r}) : svg("circle", {cx: x, cy: y, r});
// What is known of a way: its time, double with atan2 = 1, and its bound. By ./course run 13 on
// this machine, with its widest packs, or else by the page's table.
function stated(places, {number, kernel}) {
  const degree = Number(kernel.split(" ")[1] || 0);
  const own = places?.findLast((one) =>
    one.filter === "nearest" && one.number === number && one.degree === degree);
  if (places) return own ? {times: [own.time], bound: own.texels_bound} : {times: []};
  const name = `${number.endsWith("-pack") ? `pack of ${number.split("-")[0]}s` : number}, `
    + (kernel === "reference" ? "with atan2" : `polynomial of ${kernel}`);
  const row = [...document.querySelectorAll("main tr")]
    .find((one) => one.cells.length === 5 && one.cells[0].textContent === name);
  const [, time, , bound] = row ? [...row.cells].map((one) => parseFloat(one.textContent)) : [];
  return row ? {times: [time], bound} : {times: []};
}
const median = (list) => [...list].sort((a, b) => a - b)[list.length >> 1];

// ---- The plot: time across, texels off at most up, both logarithmic.
const plotWidth = 460, plotHeight = 330, left = 62, bottom = 46;
const most = 1, least = 1e-12;
const upFor = (bound) => 12 + (plotHeight - bottom - 12) * Math.log10(most / Math.max(bound,
  least)) / Math.log10(most / least);
function plotted(ways, front, chosen, limit, choose) {
  const known = ways.filter((way) => way.times.length)
    .sort((a, b) => (b === ways[chosen]) - (a === ways[chosen]) || b.bound - a.bound);
  const plain = ways[0].times.length ? Math.min(...ways[0].times) : 1;
  const ratio = (time) => time / plain;
  const reach = known.map((way) => ratio(median(way.times)));
  const first = Math.min(0.5, ...known.map((way) => ratio(Math.min(...way.times)))) * 0.75,
    last = Math.max(1.2, ...reach) * 1.1;
  const acrossFor = (time) =>
    left + (plotWidth - left - 14) * Math.log(ratio(time) / first) / Math.log(last / first);
  const drawing = svg("svg", {viewBox: `0 0 ${plotWidth} ${plotHeight}`, role: "group",
    "aria-label": "Time and error of each way; each point is a button"});
  for (let power = -12; power <= 0; power += 3) {
    const y = upFor(10 ** power);
    drawing.append(svg("line", {x1: left, x2: plotWidth - 14, y1: y, y2: y, class: "budget-grid"}),
      svg("text", {x: left - 8, y: y + 4, "text-anchor": "end"}, power ? `1e−${-power}` : "1"));
  }
  for (const part of [0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.4, 2]) {
    if (part < first || part > last) continue;
    const x = acrossFor(part * plain);
    drawing.append(svg("line",
      {x1: x, x2: x, y1: 12, y2: plotHeight - bottom, class: "budget-grid"}),
    svg("text", {x, y: plotHeight - bottom + 18, "text-anchor": "middle"}, String(part)));
  }
  drawing.append(svg("text", {x: (left + plotWidth) / 2, y: plotHeight - 6,
    "text-anchor": "middle"}, "time; double with atan2 = 1"));
  drawing.append(svg("rect", {x: left, width: plotWidth - left - 14, y: upFor(limit),
    height: plotHeight - bottom - upFor(limit), class: "budget-allowed"}));
  drawing.append(svg("line",
    {x1: left, x2: plotWidth - 14, y1: upFor(limit), y2: upFor(limit), class: "budget-limit"}));
  const at = (way) => [acrossFor(Math.min(...way.times)), upFor(way.bound)];
  const path = front.map((i) => ways[i]).filter((way) => known.includes(way))
    .map((way) => at(way).join(","));
  if (path.length > 1)
    drawing.append(svg("polyline", {points: path.join(" "), class: "budget-front"}));
  // A label stands beside, above or below its point where it covers nothing; the chosen point has
  // one in any case.
  const words = [], high = matchMedia("(max-width: 32rem)").matches ? 17 : 14,
    size = (way) => way === ways[chosen] ? 8 : 5;
  const taken = known.flatMap((way) => {
    const [x, y] = at(way), r = size(way) + 2;
    return [[x - r, y - r, x + r, y + r], [x, y - 2, acrossFor(median(way.times)), y + 2]];
  });
  taken.push([left, upFor(limit) - 1, plotWidth, upFor(limit) + 1]);
  for (const way of known) {
    const [x, y] = at(way), text = way.kernel.replace("reference", "atan2").replace("degree ", ""),
      wide = 0.62 * high * text.length, r = size(way) + 5;
    const boxes = [[x - r - wide, y - high / 2], [x - wide / 2, y - r - high],
      [x - wide / 2, y + r], [acrossFor(median(way.times)) + r, y - high / 2]]
      .map(([a, b]) => [a, b, a + wide, b + high]);
    const place = boxes.find((one) => one[0] > left && one[2] < plotWidth
      && !taken.some((other) => one[0] < other[2] && other[0] < one[2] && one[1] < other[3]
        && other[1] < one[3]))
      || way === ways[chosen] && boxes[0];
    if (place) {
      taken.push([place[0] - 6, place[1], place[2] + 6, place[3]]);
      words.push(svg("text", {x: place[0], y: place[3] - 0.15 * high,
        class: way === ways[chosen] ? "chosen" : ""}, text));
    }
    const point = svg("g", {tabindex: 0, role: "button",
      "aria-label": `${named(way)}: at most ${small(way.bound)} texels off`,
      class: `budget-point ${way.number.split("-")[0]}${ways[chosen] === way ? " chosen" : ""}`});
    point.append(svg("line", {x1: x, x2: acrossFor(median(way.times)), y1: y, y2: y}),
      dot(way, x, y, size(way)),
      svg("title", {}, named(way)));
    point.onclick = () => choose(way);
    point.onkeydown = (event) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      choose(way);
    };
    drawing.append(point);
  }
  drawing.append(...words);  // above all points
  return drawing;
}

// ---- The graphics processor: (u, v) of the directions in a texture, as floats in another.
const head = `#version 300 es
precision highp float;
precision highp sampler2D;
uniform sampler2D directions;
out vec4 place;
const float pi = 3.14159265358979;
float turn(vec3 n) { return 0.5 - atan(n.z, n.x) / (2.0 * pi); }
`;
const tail = `
void main() {
  vec4 n = texelFetch(directions, ivec2(gl_FragCoord.xy), 0);
  place = vec4(uv(n.xyz), 0.0, 1.0);
}`;
const built = [
  ["atan, acos", "vec2 uv(vec3 n) { return vec2(turn(n), acos(-n.y) / pi); }"],
  ["atan, asin", "vec2 uv(vec3 n) { return vec2(turn(n), 0.5 + asin(n.y) / pi); }"],
  ["atan for u and v, as the course",
    "vec2 uv(vec3 n) { return vec2(turn(n), atan(length(n.xz), -n.y) / pi); }"],
];
const literal = (value) => /[.e]/.test(String(value)) ? String(value) : `${value}.0`;
const horner = (list, x) => list.reduceRight((sum, power) => sum === "" ? literal(power)
  : `${literal(power)} + ${x} * (${sum})`, "");
// FastUnitMapping, as common/engine/fast/turns.hpp has it.
const byPolynomials = ({tangent, cosine}) => `
vec2 uv(vec3 n) {
  vec2 wide = abs(n.xz);
  float t = min(wide.x, wide.y) / max(max(wide.x, wide.y), 1e-37);
  float s = t * t, c = abs(n.y);
  float eighth = t * (${horner(tangent, "s")});
  float quarter = wide.y > wide.x ? 0.25 - eighth : eighth;
  float part = n.x < 0.0 ? quarter : 0.5 - quarter;
  float pole = sqrt(n.x * n.x + n.z * n.z) * (${horner(cosine, "c")});
  return vec2(n.z < 0.0 ? 1.0 - part : part, n.y > 0.0 ? 1.0 - pole : pole);
}`;
function graphics() {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl || !gl.getExtension("EXT_color_buffer_float")) return null;
  const shader = (kind, text) => {
    const made = gl.createShader(kind);
    gl.shaderSource(made, text);
    gl.compileShader(made);
    if (!gl.getShaderParameter(made, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(made));
    return made;
  };
  const texture = (width, height, data) => {
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, height, 0, gl.RGBA, gl.FLOAT, data);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
      gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
    return gl.getParameter(gl.TEXTURE_BINDING_2D);
  };
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  return {
    name: gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER),
    // Two floats for each direction.
    async places(formula, directions, width, height) {
      const program = gl.createProgram();
      gl.attachShader(program, shader(gl.VERTEX_SHADER, `#version 300 es
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}`));
      gl.attachShader(program, shader(gl.FRAGMENT_SHADER, head + formula + tail));
      gl.linkProgram(program);
      gl.useProgram(program);
      const into = texture(width, height, null);
      gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, into, 0);
      texture(width, height, directions);
      gl.viewport(0, 0, width, height);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      // By a buffer: the page answers meanwhile.
      const four = new Float32Array(4 * width * height);
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, gl.createBuffer());
      gl.bufferData(gl.PIXEL_PACK_BUFFER, four.byteLength, gl.STREAM_READ);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, 0);
      const done = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
      gl.flush();
      while (gl.clientWaitSync(done, 0, 0) === gl.TIMEOUT_EXPIRED)
        await new Promise((give) => { setTimeout(give, 5); });
      gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, four);
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
      return new Float32Array(2 * width * height).map((_, i) => four[4 * (i >> 1) + (i & 1)]);
    },
  };
}

// ---- The section.
async function show() {
  const [ask, facts] = await hire(worker, "13");
  const {width, height} = facts;
  const ways = facts.ways.map((way, index) => ({...way, index, times: []}));

  const shown = element("canvas",
    {width, height, role: "img", ariaLabel: "The globe, drawn in the chosen way"});
  const changed = element("canvas",
    {width, height, role: "img", ariaLabel: "The pixels that the chosen way changes"});
  const slider = element("input",
    {type: "range", id: "budget", min: -12, max: 0, step: 0.05, value: -2});
  const allowed = element("output", {htmlFor: "budget"});
  const says = element("p", {className: "budget-says", ariaLive: "polite"});
  const command = element("code"), copy = element("button", {type: "button", textContent: "Copy"});
  const clock = element("p", {className: "budget-clock"});
  const plot = element("div"),
    key = element("figcaption",
      {textContent: "Up: texels off at most. Each point is a way to draw: filled in float, open in "
        + "double; a square computes a pack at once. A number is the degree of its polynomial. "
        + "The red line is the front: nothing is both faster and more exact. The shaded part "
        + "keeps to the slider. Click a point to see its picture. The slider "
        + "chooses the fastest way that keeps to it; of ways that could be as fast, as far as "
        + "their times spread, the most exact."});
  const table = element("table");
  const again = element("button",
    {type: "button", textContent: "Time all ways in this browser: 5 to 10 s"});
  const measured = element("div"), numbers = element("details", {hidden: true},
      element("summary", {textContent: "All ways in numbers"}),
      element("div", {className: "scroll"}, table)),
    card = element("div", {className: "budget-card"});
  const section = element("section", {className: "wide budget", ariaLabel: "An error budget"},
    element("p", {className: "budget-row"},
      element("label",
        {htmlFor: "budget", textContent: "How far off may a place on the texture be? At most "}),
      allowed, " texels."), slider, measured, says,
    element("p", {className: "live-command"}, command, " ", copy), clock, element("p", {}, again),
    numbers, card);
  measured.append(
    element("div", {className: "budget-pair"}, element("figure", {className: "budget-plot"}, plot,
      key), element("figure", {}, shown,
      element("figcaption", {textContent: "the globe, drawn in this way"})),
    element("figure", {}, changed,
      element("figcaption", {textContent: "what this way changes, enlarged; black: nothing"}))));
  placed(section);

  section.ways = ways;  // for the tests
  const pictures = [];  // of each way, with its changes: 14 MB, so that no drag draws
  const {places} = JSON.parse(document.querySelector("#measured")?.textContent || "{}");
  const known = ways.map((way) => ({...way, ...stated(places, way)}));
  let chosen = 0;
  const limit = () => 10 ** slider.value;
  const isTimed = () => ways[0].times.length > 0;
  function tell(best) {
    const way = ways[chosen];
    const [first, mine] = [0, chosen].map((i) => (isTimed() ? ways : known)[i].times);
    says.replaceChildren(best < 0 ? "Nothing that was tried keeps to that. The most exact: " : "",
      element("b", {textContent: named(way)}),
      `, at most ${small(way.bound ?? known[chosen].bound)} texels off. `,
      way.changed === undefined ? ""
        : `${way.changed ? `${counted(way.changed, "pixel")} of ${(width * height)
          .toLocaleString("en")} differ${way.changed === 1 ? "s" : ""}` : "No pixel differs"}, `
          + `${small(way.worst)} texels off seen.`,
      chosen ? ` ${isTimed() ? "Here" : "There"} ${rounded(Math.min(...first) / Math.min(...mine),
        2)} times as fast as double with atan2.` : "",
      ` The command draws chapter 07's picture in this way${way.budget === "exact" ? ""
        : "; its budget is the polynomial's share of the error, and rounding adds the rest"}.`);
    const typed = `./course run 07 --scene book --number ${way.number}${
      way.budget === "exact" ? "" : ` --budget ${way.budget}`}`;
    command.replaceChildren(...inWords(typed.split(" ")));
    section.dataset.way = way.index;
  }
  // The fastest way that keeps to the slider, or -1, and the front: nothing is both faster and more
  // exact.
  async function found() {
    if (isTimed()) return ask("choose", limit(), Float64Array.from(ways.flatMap((way) =>
      [Math.min(...way.times), median(way.times)])));
    const all = known.filter(({times}) => times.length).sort((a, b) => a.times[0] - b.times[0]);
    return {best: all.find(({bound}) => bound <= limit())?.index ?? -1,
      front: all.filter((one, i) => all.slice(0, i).every((other) => other.bound > one.bound))
        .map(({index}) => index)};
  }
  // The picture at once; what it changes once it is compared with the exact one.
  async function paint() {
    const {index} = ways[chosen];
    if (!pictures[index]) {
      const picture = await ask("picture", index, width * height);
      if (index === chosen) painted(shown, picture, width, height);
      Object.assign(ways[index], await ask("compare", index));
      pictures[index] = await ask("pictures", index, width * height);
    }
    if (index !== chosen) return;
    [shown, changed].forEach((canvas, i) => painted(canvas, pictures[index][i], width, height));
  }
  let newest = 0;
  async function change(way) {
    const mine = ++newest;  // what a later one overtakes says nothing more
    allowed.textContent = small(limit());
    slider.setAttribute("aria-valuetext", `${small(limit())} texels`);
    const {best, front} = await found();
    if (mine !== newest) return;
    const all = isTimed() ? ways : known, exact = all.filter(({times}) => times.length)
      .reduce((a, b) => b.bound < a.bound ? b : a);
    chosen = way ? way.index : best < 0 ? exact.index : best;
    tell(way ? 0 : best);
    const isHeld = plot.contains(document.activeElement);
    plot.replaceChildren(plotted(all, front, chosen, limit(), choose));
    if (isHeld) plot.querySelector(".budget-point.chosen").focus();
    await paint();
    if (mine !== newest) return;
    tell(way ? 0 : best);
    if (!isTimed()) return;
    table.replaceChildren(element("tr", {},
      ...["way", "at most, texels", "seen", "pixels that differ", "time",
        "spread"].map((name) => element("th", {scope: "col", textContent: name}))),
    ...ways.map((one) =>
      element("tr", {}, ...[named(one), small(one.bound), small(one.worst), String(one.changed),
        rounded(Math.min(...one.times) / Math.min(...ways[0].times), 3),
        rounded(median(one.times) / Math.min(...one.times), 3)]
        .map((text) => element("td", {textContent: text})))));
    numbers.hidden = false;
  }
  function choose(way) {
    slider.value = Math.min(0, Math.max(-12, Math.ceil(20 * Math.log10(way.bound)) / 20));
    moved(way);
  }
  async function time() {
    again.disabled = true;
    for (const way of ways) {
      clock.textContent =
        `Comparing with the exact picture, ${way.index + 1} of ${ways.length} …`;
      if (way.changed === undefined) Object.assign(way, await ask("compare", way.index));
    }
    const rounds = 15, times = ways.map(() => []);
    // warms up
    for (const {index} of ways)
      pictures[index] ??= await ask("pictures", index, width * height);
    for (let round = 0; round < rounds; ++round) {
      for (const way of ways) times[way.index].push(await ask("time", way.index));
      clock.textContent = `Measuring: round ${round + 1} of ${rounds} …`;
    }
    for (const way of ways) way.times = times[way.index];  // the plot has the old ones until then
    const busy = ways.filter((way) => median(way.times) > 1.1 * Math.min(...way.times)).length;
    clock.textContent =
      "Timed in this browser, one thread: double with atan2 takes "
      + `${rounded(Math.min(...ways[0].times), 2)} ms for ${width} × ${height} rays, `
      + `the shortest of ${rounds} rounds, all ways in turn. `
      + (busy ? `The machine was busy: ${busy} of ${ways.length} medians are more than 10 % above `
      + "the shortest." : "The medians are within 10 % of the shortest.")
      + " The program of this chapter has wider packs.";
    again.disabled = false;
    again.textContent = "Time again";
    await change();
    section.dataset.timed = rounds;
  }
  function moved(way) {  // the address keeps it
    history.replaceState(history.state, "", `#budget=${slider.value}`);
    checkAddress(slider, true);
    change(way);
  }
  slider.oninput = () => moved();
  const fromAddress = () => {
    const [, asked] = /^#budget=(-?\d+(?:\.\d+)?)$/.exec(location.hash) || [];
    slider.value = asked ?? -2;
    checkAddress(slider, asked);
  };
  addEventListener("hashchange", () => { if (!isPlace()) { fromAddress(); change(); } });
  fromAddress();
  again.onclick = time;
  copy.onclick = () => copied(copy, "Copy", command);
  clock.textContent = places ? "The times are those of ./course run 13 on this machine."
    : "The times are those of one machine, from the table below.";
  await (known.some((way) => way.times.length) ? change() : time());
  section.dataset.state = "done";

  // The reader's graphics processor.
  card.append(element("h3", {textContent: "Your graphics processor"}));
  let machine;
  const measure = element("button", {type: "button", textContent: "Measure it"});
  const results = element("table"),
    errors = element("canvas",
      {role: "img", hidden: true, ariaLabel: "The error of each place on the map"}),
    caption = element("p", {className: "live-legend"});
  card.append(element("p",
    {textContent: "A graphics processor runs small programs, shaders, whose language has atan, "
      + "asin and acos. It does not say how exact they are. Here yours computes (u, v) of half a "
      + "million directions with them, and with the course's polynomials, and the page compares "
      + "each with double. Click a name to see where on the map it is off."}),
  measure, element("div", {className: "scroll"}, results), errors, caption);
  measure.onclick = async () => {
    machine ??= graphics();
    if (!machine) {
      caption.textContent = "This browser gives no graphics processor that writes floats (WebGL 2 "
        + "with EXT_color_buffer_float), so its arc tangent cannot be measured here.";
      return;
    }
    measure.disabled = true;
    try {
      const [across, down] = facts.map;
      const ofMap = await ask("directions", 1, across * down),
        ofPicture = await ask("directions", 0, width * height);
      const formulas = [...built];
      for (const degree of [5, 9, 17])
        formulas.push([`degree ${degree}`, byPolynomials(await ask("coefficients", degree))]);
      results.replaceChildren(element("tr", {}, ...["in the shader", "texels off, at worst",
        "median", "worst beside the seam", "worst near the poles",
        "pixels that differ"].map((name) => element("th", {scope: "col", textContent: name}))));
      const paint = (name, found) => {
        painted(errors, found.picture, across, down);
        errors.hidden = false;
        caption.replaceChildren(`${name}: the error on the map, `,
          element("i", {className: "live-errors"}),
          ` from 10⁻⁵ texel or less to 1 texel or more. By ${machine.name}.`);
      };
      for (const [name, formula] of formulas) {
        const found = await ask("judge", await machine.places(formula, ofMap, across, down), 1,
          across * down);
        const inPicture = await ask("judge",
          await machine.places(formula, ofPicture, width, height), 0, width * height);
        results.append(element("tr", {},
          element("td", {}, element("button",
            {type: "button", textContent: name, onclick: () => paint(name, found)})),
          ...[small(found.worst), small(found.median), small(found.seam), small(found.pole),
            counted(inPicture.changed,
              "pixel")].map((text) => element("td", {textContent: text}))));
        if (errors.hidden) paint(name, found);
      }
      card.dataset.state = "done";
    } catch (error) {
      caption.textContent = `The graphics processor refused: ${error.message}`;
    }
    measure.disabled = false;
  };
}
if (!isHired(worker)) begin(show);
})();
