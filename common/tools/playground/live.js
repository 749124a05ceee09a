// Live pictures: a chapter's own code, as WebAssembly, draws in a worker what a form below the
// picture asks for. Plain scripts only, and no fetch: pages are opened as files. Where a browser
// lacks something, the still picture stays.
"use strict";
const texmapLive = (() => {

// ---- For workers: what a script packed, and a module.
const unpacked = (bytes) =>
  new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate")))
    .arrayBuffer();
// An instance of the module with what a page can tell it and ask it. Its memory moves when it
// grows, so each access takes the buffer again.
async function open(module) {
  const imports = {};
  for (const {module: from, name} of WebAssembly.Module.imports(module))
    (imports[from] ??= {})[name] = () => 0;
  const own = {
    memory: () => new Uint8Array(own.calls.memory.buffer),
    text: (start) =>
      new TextDecoder().decode(own.memory().slice(start, own.memory().indexOf(0, start))),
    answer(start) {
      const text = own.text(start);
      if (text[0] === "!") throw {refusal: text.slice(1)};
      return text;
    },
    // Calls `use` with copies of texts and bytes in the module's memory, each ended by 0.
    lend(things, use) {
      const starts = [];
      try {
        for (const thing of things) {
          const bytes = typeof thing === "string" ? new TextEncoder().encode(thing) : thing;
          const start = own.calls.take(bytes.length + 1);
          if (!start) throw {refusal: "there is not enough memory for this"};
          starts.push(start);
          own.memory().set(bytes, start);
          own.memory()[start + bytes.length] = 0;
        }
        return use(...starts);
      } finally {
        starts.forEach(own.calls.give_back);
      }
    },
  };
  if (imports.page) imports.page.number = (text) => Number(own.text(text));
  own.calls = (await WebAssembly.instantiate(module, imports)).exports;
  own.calls._initialize();
  return own;
}

const ofWorkers = `const unpacked = ${unpacked};\n${open}\n`;

// ---- The worker of chapters 01 to 12.
function worker() {
  let module, code;   // compiled; an instance that draws
  let used = "";      // the words and width that the module is set to
  let flatUsed = "";  // the flat texture that the page has
  let size = [0, 0];  // of that picture
  let notes = "";     // on the files in it, a line each
  let job = null;     // the drawing that waits
  let drawing = false;
  const channel = new MessageChannel();
  // Lets messages in: setTimeout would wait 4 ms.
  const pause = () => new Promise((done) => {
    channel.port1.onmessage = done;
    channel.port2.postMessage(0);
  });

  function set(words, widest) {
    const lines = words.map((word) => word + "\n").join("");
    if (used !== lines + widest) {
      const answer = code.lend([lines], (text) => code.answer(code.calls.set(text, widest)));
      const end = answer.indexOf("\n");
      size = answer.slice(0, end).split(" ").map(Number);
      notes = answer.slice(end + 1);
    }
    used = lines + widest;
  }
  // Draws in strips, and lets messages in between; a picture of many samples in passes, and then
  // the picture beside it. A full picture is given up for a newer request; a small one is not, or a
  // fast hand would see none. Of several workers each draws the same rows in all passes: one band
  // after `parts` bands.
  async function draw({id, words, widest, small, whole, part = 0, parts = 1}) {
    if (!words) return;  // this was only to give up the one before
    set(words, widest);
    const began = performance.now();
    const passes = size[2], all = passes + (size[4] ? 1 : 0);
    for (let pass = small || whole ? passes - 1 : 0, most = 16, first = null; pass < all;) {
      set(words, widest);  // a look may have set something else meanwhile
      const isBeside = pass === passes;
      const [columns, rows] = isBeside ? size.slice(3) : size;
      const band = Math.ceil(rows / (small ? 1 : 4 * parts));
      first ??= part * band;
      const count = Math.min(most, rows - first, band - first % band);
      const from = performance.now();
      const start = code.calls.rows(first, count, pass);
      const strip = code.memory().slice(start, start + 4 * columns * count);
      const after = first + count, next = after % band ? after : after + (parts - 1) * band;
      const ends = next >= rows;
      const last = ends && pass === all - 1;
      postMessage({kind: "rows", id, columns, rows, first, strip, small, part, isBeside, ends, last,
        pass, passes, notes, took: performance.now() - began}, [strip.buffer]);
      if (last) return;
      const took = Math.max(performance.now() - from, 0.1);
      // 50 ms, 15 ms
      most = Math.max(1, Math.min(4 * count, Math.round((small ? 50 : 15) / took * count)));
      first = next;
      // a pass takes as long as all before it
      if (ends) { ++pass; first = null; most = Math.ceil(most / 2); }
      await pause();
      if (job && !small) return;
    }
  }
  // The detail of a flat texture, and the whole if the page does not have it.
  function flats({object, aspect, detail}, texture) {
    const flat = (window, columns, rows) => {
      const start = code.calls.flat(object, ...window, columns, rows);
      return {columns, bytes: code.memory().slice(start, start + 4 * columns * rows)};
    };
    const width = Math.min(700, 350 * aspect);
    const whole = flatUsed !== (flatUsed = `${texture} ${object}`)
      && flat([0, 0, 1, 1], Math.ceil(width), Math.ceil(width / aspect));
    return {whole, detail: flat(detail, 180, 180)};
  }
  const keepPixels = (name, note, pixels, width, height) => code.lend([name, note, pixels],
    (text, said, start) => code.answer(code.calls.keep_picture(text, said, start, width, height)));
  const can = {
    async load({packed}) {
      module = await WebAssembly.compile(await unpacked(packed));
      code = await open(module);
    },
    // An instance lives for one file: what decoding it needed is free afterwards.
    async keep({name, shown, bytes, option, isRaw}) {
      if (isRaw) {
        code.lend([name, bytes],
          (text, start) => code.answer(code.calls.keep_file(text, start, bytes.length)));
        postMessage({kind: "kept", name, bytes, shown, option, isRaw});
        return;
      }
      const loader = await open(module);
      const [width, height, ...note] = loader.lend([shown, bytes],
        (text, start) => loader.answer(loader.calls.decode(text, start, bytes.length))).split(" ");
      const start = loader.calls.pixels();
      keepPixels(name, note.join(" "), loader.memory().subarray(start, start + 3 * width * height),
        Number(width), Number(height));
      postMessage({kind: "kept", name, bytes, shown, option});
    },
    drop: ({name, isRaw}) => isRaw
      ? code.lend([name], (text) => code.answer(code.calls.keep_file(text, 0, 0)))
      : keepPixels(name, "", new Uint8Array(3), 1, 1),
    begin({chapter}) {
      used = "";
      postMessage({kind: "options",
        options: JSON.parse(code.answer(code.calls.begin(Number(chapter))))});
    },
    // From a place on the picture beside to a pixel, and what that pixel meets.
    find({words, widest, x, y}) {
      set(words, widest);
      const at = JSON.parse(code.answer(code.calls.find(x, y)));
      if (!at || at.some((place, i) => place < -0.5 || place > size[i] - 0.5))
        postMessage({kind: "seen", seen: {spot: [x, y]}});
      else can.look({words, widest, column: Math.round(at[0]), row: Math.round(at[1])});
    },
    look({words, widest, column, row, texture}) {
      set(words, widest);
      const seen = JSON.parse(code.answer(code.calls.look(column, row)));
      postMessage({kind: "seen", column, row, seen, flats: seen.map && flats(seen.map, texture)});
    },
    async draw(message) {
      job = message;
      if (drawing) return;
      drawing = true;
      while (job) {
        const now = job;
        job = null;
        await attempt(() => draw(now), now);
      }
      drawing = false;
    },
  };
  // A refusal in words is an answer; anything else is the end of this worker.
  async function attempt(act, {kind, id}) {
    try {
      await act();
    } catch (error) {
      postMessage(error.refusal ? {kind: "refused", of: kind, id, reason: error.refusal}
        : {kind: "lost", reason: String(error)});
    }
  }
  let before = Promise.resolve();  // what others wait for
  onmessage = ({data}) => {
    const done = before.then(() => attempt(() => can[data.kind](data), data));
    if (data.kind !== "draw") before = done;
  };
}

// ---- Which controls there are. A chapter has those that its module offers; the choices' words
// come from the module, and what is told below a control that a picture does not explain.
const early = "01 02 03 04 05 06";
const controls = [
  {option: "--samples", label: "Samples", range: [1, 1024, Math.log10(2) / 30], log: true,
    whole: true, in: "07 12"},
  {option: "--sampler", label: "Pattern"},
  {option: "--light", label: "Directions", told: "how a matte surface picks a sample's direction"},
  {option: "--seed", label: "Seed", range: [0, 20, 1], whole: true, told: true},
  {option: "--beside", label: "Filter, left", here: (value) => `${value} left of the line`},
  {option: "--filter", label: "Filter, right", in: "09"},
  {option: "--projection", label: "Layout", told: "of the map"},
  {option: "--relief", label: "Relief", range: [-0.2, 0.2, 0.005],
    told: "the height of white, in radii"},
  {option: "--lamp-around", label: "Lamp right °", range: [-180, 180, 1],
    here: (value) => `the lamp at ${value}°`},
  {option: "--lamp-up", label: "Lamp up °", range: [-90, 90, 1],
    here: (value) => `the lamp ${value}° up`},
  {option: "--bump", label: "Normals",
    told: "of the raised surface, by Blinn's formula of 1978, or the globe's own"},
  {option: "--green", label: "Green is", told: "in a normal map: first open one"},
  {option: "--degrees", label: "Rotation °", range: [-180, 180, 1], turns: true},
  {option: "--exposure", label: "Exposure", range: [-6, 6, 0.1], told: "one more: twice the light"},
  {option: "--weights", label: "Weights",
    told: "from signed areas, as in the article from the sides, or, wrong, in the picture"},
  {option: "--normals", label: "Shading", told: "of a mesh whose corners have normals"},
  {option: "--wrap", label: "Wrap mode", in: "08 09",
    told: "what the texture shows where u or v is beyond 0 to 1"},
  {option: "--sky", label: "Sky"},
  {option: "--defocus", label: "Lens blur", range: [0, 10, 0.1], told: "degrees; 0: all is sharp"},
  {option: "--focus", label: "Sharp at", range: [2, 30, 0.1],
    told: "the distance from the eye; first set a lens blur"},
  {option: "--taps", label: "Most reads", range: [1, 64, 1], whole: true,
    told: "places along a pixel's footprint, for the last three filters; anisotropic reads up to "
      + "8 texels at each"},
  {option: "--squares", label: "Squares", range: [1, 40, 1], here: (value) => `Squares ${value}`},
  {option: "--convention", label: "Convention", told: true},
  {option: "--rounding", label: "Rounding", told: true},
  {option: "--blend", label: "Blend", range: [0, 1, 0.01], off: true,
    told: "the share of the texture; off: multiplied"},
  {option: "--shininess", label: "Shininess", range: [1, 1000, 0.01], log: true, whole: true,
    told: "larger: a smaller spot"},
  {option: "--highlight", label: "Highlight", told: true, names: {lecture: "lecture's slides"}},
  {option: "--scene", label: "Scene", names: {lecture: "lecture's globe", book: "globe alone"}},
  {option: "--show", label: "Show"},
  {option: "--eye", label: "Eye distance ×", range: [1, 1e7, 0.01], log: true, more: true,
    told: "the picture is enlarged as much, so that rounding shows: try it in float",
    here: (value) => `Eye distance × ${value}`},
  {option: "--number", label: "Number type", only: ["double", "float"], more: true,
    in: early + " 08", told: "double keeps 16 digits, float 7"},
  {option: "--spheres", label: "Sphere formula", more: true, in: early,
    told: "they differ only in float and from far away",
    names: {plain: "plain (textbook)", robust: "robust (course)", hybrid: "hybrid (far eye)"}},
  {option: "--samples", label: "Rays per pixel", only: ["1", "4", "16"], more: true},
  {option: "--bounces", label: "Bounces", range: [1, 50, 1], whole: true, more: true,
    told: "surfaces that a path of light may meet"},
  {option: "--shift", label: "Motion", range: [-2, 2, 0.05], more: true,
    told: "how far the scene moves up during the exposure"},
  {option: "--gamma", label: "Light to bytes", more: true, told: true},
  {option: "--decode", label: "Bytes to light", more: true,
    told: "of the texture; raw: as they are"},
  {option: "--slopes", label: "Slopes", more: true},
];
// The files that a reader may choose: what the button says and takes, and whether the module reads
// them itself.
const pictureFiles = "image/png,image/jpeg";
const fileControls = [
  {option: "--texture", button: "Open texture…", takes: pictureFiles,
    hint: "a PNG or JPEG; or drop it on the picture"},
  {option: "--floor", button: "Open floor…", takes: pictureFiles,
    hint: "a PNG or JPEG for the floor"},
  {option: "--mesh", button: "Open mesh…", takes: ".obj",
    hint: "an OBJ file with texture coordinates", isRaw: true},
  {option: "--sky", button: "Open sky…", takes: ".hdr," + pictureFiles,
    hint: "a Radiance .hdr, PNG or JPEG, twice as wide as high", isRaw: true},
  {option: "--relief-image", button: "Open heights…", takes: pictureFiles,
    hint: "a PNG or JPEG, twice as wide as high", isRaw: true},
  {option: "--normals", button: "Open normals…", takes: pictureFiles,
    hint: "a normal map in place of heights", isRaw: true},
];
// Chapters whose second picture lies on the first, up to a line.
const lies = {"09": true};
// What else the pointer does on a chapter's picture.
const hints = {
  "09": (values) =>
    `Left of the line: ${values["--beside"]}; right: ${values["--filter"]}, which the command `
      + "below draws. Drag the knob under the picture.",
  "10": (values) =>
    "Point at the globe or at the map: the place is marked on both, where it is in sight. The "
      + `map that you save is that of ./course run 10 --to ${values["--projection"]}.`,
  "11": () => "Drag on the globe to move the lamp.",
};
// Chapters whose picture gets better in passes: the option whose choices are compared.
const compared = {"07": "--sampler", "12": "--light"};
// About how much a sample is worth by each choice, where one must be taken for right; coefficients
// are smooth but wrong.
const worth = {coefficients: 0, uniform: 1, cosine: 1, importance: 50, mis: 200, auto: 200,
  random: 1, stratified: 2, "multi-jitter": 3, sobol: 4};
// Chapters whose full pictures up to four workers draw, each with a module and files of its own: at
// most 32 MiB.
const shared = ["07", "12"];
// The first pixel that is explained, in parts of the picture, where it is not in the middle: 11's
// mountains, 12's matte sphere.
const firsts = {"11": [0.54, 0.19], "12": [0.34, 0.5]};
const names = {"--errors": "error in texels"};
// Without this option a program draws a sheet of several pictures; with it, one of this size.
const always = {"04": "--convention", "09": "--filter", "10": "--projection"};
const sizeOfOne = ["--width", "800", "--height", "600"];
// The control that tells most: it stands with the picture, the others follow.
const tellsMost = {"01": "--show", "02": "--squares", "03": "--show", "04": "--convention",
  "05": "--degrees", "06": "--shininess", "07": "--samples", "08": "--wrap", "09": "--filter",
  "10": "--projection", "11": "--relief", "12": "--exposure"};
// What a page begins with in place of the chapter's preset.
const begins = {"10": {"--projection": "cube"}};
// What the lecture's scene presets otherwise.
const sceneSets = {lecture: {"--degrees": "0", "--convention": "lecture", "--shininess": "500",
  "--blend": "0.3"}};
const legends = {
  normal: "x as red, y as green, z as blue, each from −1 to 1",
  uv: "u as red, v as green, each from 0 to 1; gray: no (u, v)",
  object: "one color for each object",
  get "--errors"() {
    return ["How far float's place in the texture is from double's: 10⁻⁵ texel or less ",
      element("i", {className: "live-errors"}),
      " 1 texel or more. White: float meets another object. Gray: no (u, v). A checkerboard counts "
        + "as 2048 × 1024 texels."];
  },
};
// columns of a picture; while the reader drags it has 96 to 480, as many as are drawn in 36 ms
const widest = 800;
// nothing in 01 has (u, v); sheets are not live; color is 11's globe
const lacks = {"01": ["uv", "--errors"], "11": ["sheet", "poles", "daily", "color"]};
const largestFile = 64 << 20;        // bytes; the chapters' own limit

// ---- Small tools.
function element(name, properties = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties))
    key in made ? made[key] = value : made.setAttribute(key, value);
  made.append(...children);
  return made;
}
function svg(name, properties, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(properties)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}
// A formula as MathML: a letter is a variable, more are a name; / is a fraction of the neighbors,
// {…} groups.
function math(text) {
  const signs = text.match(/[a-zα-ωβ]+2?|[\d.]+|\S/gi);
  const make = (name, ...children) => {
    const made = document.createElementNS("http://www.w3.org/1998/Math/MathML", name);
    made.append(...children);
    return made;
  };
  function row(end) {
    const list = [];
    while (signs.length && signs[0] !== end) list.push(term());
    signs.shift();
    return make("mrow", ...list);
  }
  function term() {
    const sign = signs.shift();
    let one = sign === "{" ? row("}") : sign === "√" ? make("msqrt", term())
      : make(/\d/.test(sign[0]) ? "mn" : /[a-zα-ω]/i.test(sign) ? "mi" : "mo", sign);
    if (signs[0] === "²") one = make("msup", one, make("mn", signs.shift() && "2"));
    return signs[0] === "/" ? make("mfrac", one, signs.shift() && term()) : one;
  }
  return make("math", row());
}
// Bytes from base64, or from fifteen bits a character, as make_playground.py writes them; the first
// says if there is a byte too many.
function bytesOf(text) {
  if (text < "\u3400") return Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  const bytes =
    new Uint8Array(Math.floor((text.length - 1) * 15 / 8) - (text.charCodeAt(0) - 0x3400));
  for (let i = 1, at = 0, bits = 0, count = 0; i < text.length; ++i) {
    bits = bits << 15 | text.charCodeAt(i) - 0x3400;
    for (count += 15; count >= 8; bits &= (1 << count) - 1) bytes[at++] = bits >> (count -= 8);
  }
  return bytes;
}
// As the shell reads it.
const quoted = (word) => /^[\w.\/+-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;
const rounded = (value, digits) => String(Number(Number(value).toPrecision(digits)))
  .replaceAll("-", "−");

// ---- What scripts hand over: modules.js and 07.js call texmapLive.modules, earth.js calls
// texmapLive.file.
// none: all is in the page
const inWorker = typeof document === "undefined";
const folder = inWorker ? "" : (document.currentScript.src || "").replace(/[^/]*$/, "");
const arrivals = new Map();
function arrival(name) {
  if (!arrivals.has(name)) {
    const one = {};
    one.promise = new Promise((give, refuse) => Object.assign(one, {give, refuse}));
    arrivals.set(name, one);
  }
  return arrivals.get(name);
}
function fetched(name, script) {
  const one = arrival(name);
  if (folder && !one.asked) {
    one.asked = true;
    document.head.append(element("script",
      {src: folder + script, onerror: () => one.refuse(new Error(`there is no ${script}`))}));
  }
  return one.promise;
}

// ---- Workers. Where pages are served a worker is a script's file, which servers may allow alone;
// from file:// none can be opened, and a Blob of the same functions takes its place.
function engaged(script, ...texts) {
  if (folder && location.protocol !== "file:") return new Worker(folder + script);
  const address = URL.createObjectURL(new Blob([ofWorkers, ...texts]));
  try { return new Worker(address); } finally { URL.revokeObjectURL(address); }
}
// Why a worker stopped: a server's policy may forbid WebAssembly.
const whyLost = (reason) => !/CompileError/.test(reason) ? reason || "its worker did not start"
  : "this server's policy forbids WebAssembly: the script-src of its Content-Security-Policy needs "
    + "'wasm-unsafe-eval'";
// A command's words: no line breaks within one.
const inWords = (words) =>
  words.flatMap((word, i) => [i ? " " : "", element("span", {textContent: word})]);
// What a page says about an address, or a part of it, that means nothing to it.
const unknown = (asked) => `The address asks for "${asked}", which this picture does not know. `
  + "These are the settings it begins with.";
// Whether the address names a heading, and so no setting.
const isPlace = () => Boolean(document.getElementById(location.hash.slice(1)));
// For the pages of single chapters: says behind an element if an address is not known.
function checkAddress(place, isKnown) {
  document.querySelector(".live-says")?.remove();
  if (!isKnown && location.hash && !isPlace()) place.after(element("p",
    {className: "live-says live-fault", role: "status", textContent: unknown(location.hash)}));
}
// For the pages of single chapters: a worker that answers one call after another, each by its
// name and what it takes.
function answering(can) {
  let before = Promise.resolve();
  onmessage = ({data: [id, call, ...given]}) => {
    before = before.then(async () => {
      try {
        postMessage([id, await can[call](...given)]);
      } catch (error) {
        postMessage([id, null, error.refusal || String(error)]);
      }
    });
  };
}
// Gives how to ask it, and its answer to the chapter's module and the map of the Earth.
async function hire(worker, chapter) {
  const [{bytes: packed}, {bytes: picture}] = await Promise.all(
    [fetched(`module_${chapter}`, `module_${chapter}.js`), fetched("earth.png", "earth.js")]);
  const hand = engaged(`page_${chapter}.js`, `(${answering})((${worker})())`);
  const waiting = new Map();
  let last = 0;
  const fail = (reason) => {
    for (const {refuse} of waiting.values()) refuse(new Error(whyLost(reason)));
  };
  hand.onmessage = ({data: [id, answer, fault]}) => {
    const {give, refuse} = waiting.get(id);
    waiting.delete(id);
    fault ? refuse(new Error(whyLost(fault))) : give(answer);
  };
  hand.onerror = (event) => fail(event.message);
  const ask = (...call) => new Promise((give, refuse) => {
    waiting.set(++last, {give, refuse});
    hand.postMessage([last, ...call]);
  });
  return [ask, await ask("load", packed, picture)];
}
const small = (value) => value === 0 ? "0" : value < 1e-3 ? value.toExponential(1).replace("-", "−")
  : rounded(value, 2);
// Copies what an element shows, for a button that then says so.
async function copied(button, name, shown) {
  try {
    await navigator.clipboard.writeText(shown.textContent);
  } catch {
    getSelection().selectAllChildren(shown);
    document.execCommand("copy");
  }
  button.textContent = "Copied";
  setTimeout(() => { button.textContent = name; }, 2000);
}
function painted(canvas, pixels, width, height) {
  Object.assign(canvas, {width, height});
  canvas.getContext("2d").putImageData(new ImageData(new Uint8ClampedArray(pixels.buffer),
    width), 0, 0);
}

// Where a pointer is on an element, in parts of its width and its height.
function partsOf({clientX, clientY}, target) {
  const {left, top, width, height} = target.getBoundingClientRect();
  return [(clientX - left) / width, (clientY - top) / height];
}
// The largest difference of a channel at each pixel of two pictures.
const differences = (a, b) => Array.from({length: a.length / 4}, (_, i) =>
  Math.max(Math.abs(a[4 * i] - b[4 * i]), Math.abs(a[4 * i + 1] - b[4 * i + 1]),
    Math.abs(a[4 * i + 2] - b[4 * i + 2])));

// Puts a section where the page keeps its place, or below the head of a page that keeps none.
function placed(section) {
  const place = document.querySelector(".live-place"), main = document.querySelector("main");
  const above = place || main.querySelector(".head, .tabs") || main.querySelector("h1");
  above.after(section);
  place?.remove();
}

// ---- A live picture, its form and its loupe. Its place is there before the module is.
async function live(main, script) {
  // The chapter's picture: what comes after the first heading is a diagram.
  const first = main.querySelector("img"), heading = main.querySelector("h2");
  const image = first && heading
    && heading.compareDocumentPosition(first) & Node.DOCUMENT_POSITION_FOLLOWING ? null : first;
  // A paragraph that has only the picture goes with it. A sheet of several pictures stays, above
  // the live one.
  const frame = image && image.parentElement !== main && image.parentElement.childNodes.length === 1
    ? image.parentElement : image;
  const still = always[main.dataset.live] ? null : frame;
  const shape = still && image.height / image.width || 0.75;
  const canvas = element("canvas", {tabIndex: 0, role: "img",
    "aria-label": (image ? image.alt : "The chapter's picture")
      + ". Arrow keys show how a pixel gets its color."});
  const paper = canvas.getContext("2d", {willReadFrequently: true});
  const small = element("canvas");
  const smallPaper = small.getContext("2d", {willReadFrequently: true});
  const mark = element("div", {className: "live-mark", hidden: true});
  const zoomed = element("canvas", {width: 11, height: 11});
  const around = element("figure", {className: "live-around"}, zoomed,
    element("figcaption", {textContent: "the pixels around it"}));
  const facts = element("table");
  const second = element("canvas", {width: 3, height: 2});  // until 10's map is there
  const hasMap = main.dataset.live === "10";
  const secondPaper = second.getContext("2d", {willReadFrequently: true});
  // Where two pictures lie on each other: the line between them, which a slider moves.
  const line = element("input",
    {type: "range", className: "live-line", min: 0, max: 100, step: 0.1, value: 50, hidden: true,
      ariaLabel: "Where the line between the two pictures is", oninput: moveLine});
  const spot = element("div", {className: "live-mark", hidden: true});
  const secondFrame = element("div", {className: "live-second", hidden: !hasMap}, second, spot);
  // The still picture, until there is another. By their presets 07 and 12 draw this one: it covers
  // their noisy passes until the last one.
  const stand = element("img",
    {src: image?.src || "", alt: "", className: "live-stand", hidden: !still});
  const picture = element("div", {className: "live-picture"}, canvas, ...(image ? [stand] : []),
    line, mark);
  const refining = element("progress", {max: 1, ariaLabel: "Samples drawn"});
  const refined = element("p", {className: "live-refined", hidden: true}, refining, " ",
    element("span"));
  const trace = element("figure", {className: "live-trace", hidden: true});
  const whole = element("canvas", {role: "img"}),
    detail = element("canvas", {"aria-hidden": true}), mapSays = element("figcaption");
  const map = element("figure", {className: "live-map"}, whole, detail, mapSays);
  const drawn = element("figure", {className: "live-map"});
  const loupe = element("div", {className: "live-loupe", hidden: true, ariaLive: "polite"}, map,
    drawn, facts);
  const room = element("div", {}, loupe);
  const mostRow = element("fieldset", {className: "live-rows live-most", ariaLabel: "Change this"});
  const beside = element("div", {className: "live-beside"}, mostRow, secondFrame, room);
  const legend = element("p", {className: "live-legend"});
  const isWide = matchMedia("(min-width: 52rem)");  // the loupe is beside the picture
  const byTouch = matchMedia("(hover: none) and (pointer: coarse)").matches;
  const hint = byTouch
    ? "Tap a pixel to see how it gets its color. A tap on its numbers closes them."
    : "Point at a pixel to see how it gets its color. A click holds it, arrow keys move it (with "
      + "Shift by ten pixels), Esc closes.";
  const letsGo = `held: ${byTouch ? "a tap here" : "a click or Esc"} lets go`;
  const says = element("p", {className: "live-says", role: "status"});
  const again = element("button", {type: "button", textContent: "Try again", hidden: true,
    onclick: () => { startOver(); start(); }});
  const rows = element("div", {className: "live-rows"});
  const moreRows = element("div", {className: "live-rows"});
  const more = element("details", {}, element("summary", {textContent: "More"}), moreRows);
  const command = element("code");
  const copy = element("button", {type: "button", textContent: "Copy",
    onclick: () => copied(copy, "Copy", command)});
  const link = element("button", {type: "button", textContent: "Copy link", onclick: () => {
    toAddress();
    hereOnly.textContent = location.href;
    copied(link, "Copy link", hereOnly);
  }});
  const hereOnly = element("span");
  const openers = element("span", {className: "live-openers"});
  const save = element("button",
    {type: "button", textContent: "Save the map", onclick: () => second.toBlob((blob) =>
      element("a",
        {href: URL.createObjectURL(blob), download: `${values["--projection"]}.png`}).click())});
  const panel = element("fieldset", {}, element("legend", {textContent: "Change the picture"}),
    rows, more,
    element("div", {className: "live-actions"}, openers, save, element("button",
      {type: "button", textContent: "Reset", onclick: () => { startOver(); change(); }})),
    element("p", {className: "live-command"}, command, " ", copy, " ", link, " ", hereOnly));
  const form = element("form", {onsubmit: (event) => event.preventDefault()}, panel);
  const section = element("section", {className: "live live-waits", "aria-label": "Live picture"},
    picture, beside, refined, legend, says, again, form, trace);
  section.small = small;  // for the tests: what was drawn while dragging
  reshape(800, Math.round(800 * shape));
  frame ? frame.after(section) : placed(section);
  main.querySelector(".live-missing")?.remove();
  if (still) still.style.display = "none";
  still?.classList.add("live-still");
  document.querySelector(".live-place")?.remove();
  let packed;
  try {
    packed = await script;
  } catch (error) {
    section.remove();
    if (still) still.style.display = "";
    console.info(`The picture stays still: ${error.message}`);
    return;
  }

  let hand = null;                     // the worker
  // more of them for full pictures, null: none were needed yet; how many still draw the latest one
  let others = null, due = 0;
  let chapter = main.dataset.live;
  let built = "";                      // the chapter whose form is there
  let presets = {}, values = {}, widgets = {};
  // the options that take the reader's files, those of `fileControls`
  let ownFiles = [];
  let notes = "";  // on the files in the picture, a line each
  let carried = {};                    // what the reader chose in chapters before this one
  const files = new Map();             // what the module was given, for a new worker
  let latest = 0, unfinished = false;  // the last drawing asked for
  let looking = null, nextLook = null, pixel = null, pinned = false;
  // the names of the files that the reader chose last; how many there were
  let newest = {}, opened = 0;
  // an option's value before the newest, a file or a typed number that the chapter has not read yet
  let undo = null;
  let example = null;                  // whether the page chose the pixel; null: not yet
  let patience = 0, idle = 0, full = null;
  let draft = 240;                     // columns while the reader drags
  let roomOf = 0;                      // the loupe's width
  // The page's mistakes: what each types more, what is wrong, what is right. The one that is drawn.
  const slips = JSON.parse(main.dataset.slips || "[]");
  let broken = null;
  let attempts = 0;  // to draw one: only the newest goes on once the right picture is there
  // Of the page alone: the program has no option that draws it.
  const isOurs = ({typed}) => typed[0] === "--mistake";
  const wrongs = element("select"), verdict = element("div", {ariaLive: "polite"});

  // -- The worker's life.
  function engage() {
    const one = engaged("live.js#worker", `(${worker})()`);
    one.postMessage({kind: "load", packed});
    for (const [name, file] of files) one.postMessage({kind: "keep", name, ...file});
    return one;
  }
  function start() {
    again.hidden = true;
    say("");
    panel.disabled = mostRow.disabled = false;
    try { hand = engage(); } catch (error) { lost(error.message); return; }
    hand.onmessage = ({data}) => { heard[data.kind](data); wait(); };
    hand.onerror = (event) => lost(event.message);
    ++latest;  // what the old chapter still draws is out of date
    looking = nextLook = null;
    unfinished = true;
    send({kind: "begin", chapter});
  }
  // More workers, once a picture takes long. They help from when they have answered. If one fails,
  // the first draws alone from then on; if one refuses the words, until a picture takes long again.
  function engageOthers() {
    if (others || !shared.includes(chapter)) return;
    for (others = []; others.length + 1 < Math.min(4, navigator.hardwareConcurrency - 1);) {
      const other = engage();
      others.push(other);
      other.onmessage = ({data}) => {
        if (data.kind === "seen") other.isReady = true;
        else if (data.kind === "rows") {
          heard.rows(data);
          wait();
        } else if (data.kind === "lost") dismiss([]);
        else if (data.id === latest) dismiss(null);
      };
      other.onerror = () => dismiss([]);
      other.postMessage({kind: "begin", chapter});
      other.postMessage({kind: "look", words: words(), widest, column: 0, row: 0});
    }
  }
  function dismiss(left) {
    for (const other of others || []) other.terminate();
    others = left;
    if (unfinished) ask(false);
  }
  function send(message) {
    if (!hand) return;
    hand.postMessage(message);
    if (message.kind === "keep" || message.kind === "drop")
      others?.forEach((other) => other.postMessage(message));
    if (!patience) wait();
  }
  // A worker that owes an answer has 30 s for it; in the tests' pages less.
  const allowed = Number(main.dataset.patience || 30);
  function wait() {
    clearTimeout(patience);
    patience = hand && (unfinished || looking) ? setTimeout(() => others?.length ? dismiss([])
      : lost(`no answer for ${allowed} s`), 1000 * allowed) : 0;
  }
  function say(words, isFault = true) {
    says.textContent = words;
    says.classList.toggle("live-fault", isFault && words !== "");
  }
  function lost(reason) {
    for (const one of [hand, ...others || []]) one?.terminate();
    hand = others = null;
    clearTimeout(idle);
    stopTurning();
    unfinished = false;
    looking = nextLook = null;
    closeLoupe();
    panel.disabled = mostRow.disabled = true;
    if (still) { still.style.display = ""; canvas.hidden = stand.hidden = true; }
    say(`The live picture stopped (${whyLost(reason)}). ${still ? "This is the still one." : ""}`);
    again.hidden = /CompileError/.test(reason);
    form.hidden = section.classList.contains("live-waits");  // there was no picture yet
    section.dataset.state = "lost";
  }
  const heard = {
    async options({options}) {
      const mine = hand;
      unfinished = false;  // now it is the page that waits, perhaps for a slow network
      const found = Object.fromEntries(options.map((option) => [option.name, option]));
      try {
        for (const {words, preset} of options) {  // the files that the chapter begins with
          if (words !== "FILE" || !/^\w+\.\w+$/.test(preset) || files.has(preset)) continue;
          const file = await fetched(preset, preset.replace(/\.\w+$/, ".js"));
          if (mine !== hand) return;
          files.set(preset, {shown: preset, isRaw: preset.endsWith(".hdr"), ...file});
          send({kind: "keep", name: preset, ...files.get(preset)});
        }
      } catch (error) {
        lost(error.message);
        return;
      }
      const odd = built !== chapter && (build(found), carryOver(), fromAddress());
      change();
      if (odd) say(odd);
    },
    rows({id, columns, rows, first, strip, small: isSmall, part, isBeside, ends, last, pass, passes,
      notes: said, took}) {
      const data = new ImageData(new Uint8ClampedArray(strip.buffer), columns);
      if (isBeside) {
        if (!isSmall && id !== latest) return;
        if (!broken) showBeside(data, first, rows);  // else the right picture is there
      } else if (isSmall) {
        if (first === 0) Object.assign(small, {width: columns, height: rows});
        smallPaper.putImageData(data, 0, first);
        if (ends) showSmall(columns, rows);
      } else if (id === latest) {  // not a strip of what is out of date
        if (pass === 0) fit(columns, rows);
        paper.putImageData(data, 0, first);
        if (ends) full = [columns, rows];
        if (took > 300) engageOthers();
        if (passes > 1 && part === 0)
          showProgress(pass, passes, ends ? 1 : (first + data.height) / rows);
        else if (passes === 1) refined.hidden = trace.hidden = true;
      } else if (id === tracing) {
        if (first === 0) traced = new Uint8ClampedArray(4 * columns * rows);
        traced.set(strip, 4 * columns * first);
        if (last) addPoint();
      }
      // A whole multiple of 16 keeps the shape; halfway there, since a first picture is slow.
      if (last && isSmall)
        draft = Math.max(96,
          Math.min(480, 16 * Math.round((draft + draft * Math.sqrt(36 / took)) / 32)));
      if (!last || id !== latest || --due) return;
      unfinished = false;
      if (notes !== said) {
        notes = said;
        refresh();
      }
      if (isSmall) return;
      if (undo) forgetFiles(undo.option, values[undo.option]);
      undo = null;
      stand.hidden = true;
      section.dataset.state = "done";
      save.disabled = Boolean(broken);  // the second picture is no map then
      if (pixel?.column >= columns || pixel?.row >= rows) {
        closeLoupe();
        say(`The address names a pixel beyond the picture of ${columns} × ${rows}.`);
      }
      // Until the reader points, a pixel of the middle sphere is the example, where the loupe
      // covers nothing.
      if (example === null) {
        example = isWide.matches && !main.querySelector("[name=live-chapter]");
        const [right, down] = firsts[chapter] || [0.53, 0.46];
        if (example)
          pixel ??= {column: Math.floor(right * canvas.width),
            row: Math.floor(down * canvas.height)};
      }
      if (pixel?.column !== undefined) look(pixel);
      if (passes > 1) beginCurve();
    },
    seen({column, row, seen, flats}) {
      looking = null;
      if (flats) keepFlats(flats);
      if (pixel && pixel.column === undefined && column !== undefined) pixel = {column, row};
      if (nextLook) look(nextLook);
      else if (column === undefined) closeLoupe();
      else if (pixel) showLoupe(column, row, seen);
      const at = !broken && seen.spot;
      spot.hidden = !at;
      if (at) Object.assign(spot.style, {left: `${100 * at[0]}%`, top: `${100 * at[1]}%`});
    },
    refused({of, id, reason}) {
      if (of === "look" || of === "find") { looking = null; return; }
      if (of === "draw" && id !== latest) return;
      unfinished = false;
      for (const [name, {shown}] of files) reason = reason.replaceAll(name, shown);
      const wrong = Object.keys(widgets).find((one) => reason.startsWith(`${one} takes `));
      // two were changed at once
      if (wrong && wrong !== undo?.option) undo = {option: wrong, before: preset(wrong)};
      if (undo && of === "draw") {  // a file that cannot be read has changed nothing
        files.delete(values[undo.option]);
        values[undo.option] = undo.before;
        if (undo.wrap) values["--wrap"] = undo.wrap;
        const fault = widgets[undo.option]?.fault;
        undo = null;
        if (fault) { fault.textContent = reason; change(); return; }
        refresh();
      }
      say(reason);
      section.dataset.state = "refused";
    },
    kept({name, shown, bytes, option, isRaw}) {
      if (!option || files.has(name)) return;  // one of the chapter's, or given again
      // the reader has chosen another since, or none
      if (newest[option] !== name) { send({kind: "drop", name, isRaw}); return; }
      // what is wrong in it may show only when it is drawn
      undo = {option, before: values[option]};
      forgetFiles(option, values[option]);
      files.set(name, {shown, bytes, option, isRaw});
      values[option] = name;
      if (option === "--mesh") {  // the program's preset with a file
        undo.wrap = values["--wrap"];
        values["--wrap"] = "repeat";
      }
      change();
    },
    lost: ({reason}) => lost(reason),
  };

  // -- The picture.
  function reshape(width, height) {
    Object.assign(canvas, {width, height});
    picture.style.setProperty("--shape", width / height);
  }
  function fit(columns, rows) {
    if (canvas.width === columns && canvas.height === rows) return;
    reshape(columns, rows);
    if (small.width) paper.drawImage(small, 0, 0, columns, rows);
  }
  function showSmall(columns, rows) {
    if (Math.abs(canvas.width / canvas.height - columns / rows) > 0.01) {
      full = null;
      reshape(columns, rows);
    }
    paper.drawImage(small, 0, 0, canvas.width, canvas.height);
    canvas.hidden = false;
    if (still) still.style.display = "none";
    stand.hidden = !still || !compared[chapter] || given().length > 0;
    if (turning) requestAnimationFrame(turn);
    if (pixel) look(pixel);
  }
  // Each pass has twice the samples of the one before it.
  function showProgress(pass, passes, share) {
    const most = Number(values["--samples"]);
    const before = pass ? 2 ** (pass - 1) : 0, after = Math.min(2 ** pass, most);
    refining.value = (before + (after - before) * share) / most;
    refined.lastChild.textContent = `${share < 1 ? before : after} of ${most} samples`;
    refined.hidden = false;
  }
  // The error against samples. A pattern is one only as a whole, so that each point is a picture of
  // its own, as the program draws it; they are drawn once the picture is there. Curves of the same
  // scene by other choices stay.
  const curves = new Map();
  let curvesOf = "", growing, tracing, traced;
  const rms = (a, b) =>  // alpha is the same
    Math.sqrt(a.reduce((sum, x, i) => sum + (x - b[i]) ** 2, 0) / (0.75 * a.length));
  function beginCurve() {
    const by = compared[chapter];
    const scene = JSON.stringify([canvas.width,
      given().map(({words}) => words)
        .filter(([option]) => ![by, "--samples", "--seed"].includes(option))]);
    if (scene !== curvesOf) curves.clear();
    curvesOf = scene;
    const picture = paper.getImageData(0, 0, canvas.width, canvas.height).data;
    growing = {name: values[by], points: [{samples: Number(values["--samples"]), picture}]};
    nextPoint();
  }
  function nextPoint() {
    const {name, points} = growing, samples = 4 ** (points.length - 1);
    if (!(curves.get(name)?.points.length > points.length)) curves.set(name, growing);
    drawCurves(name);
    tracing = `${latest}, ${samples} samples`;
    if (samples < points.at(-1).samples)
      send({kind: "draw", id: tracing, words: words(samples), widest, whole: true});
  }
  function addPoint() {
    growing.points.splice(-1, 0, {samples: 4 ** (growing.points.length - 1), picture: traced});
    nextPoint();
  }
  function drawCurves(chosen) {
    const all = [...curves.values()],
      score = ({name, points}) => worth[name] * points.at(-1).samples;
    const best = all.reduce((a, b) => score(b) > score(a) ? b : a), right = best.points.at(-1);
    const log = Math.log2;
    const errorOf = (point) => {
      if (point.to !== right)
        Object.assign(point, {to: right, error: rms(point.picture, right.picture)});
      return point.error;
    };
    const lists = all.map(({name, points}) => {
      // Of that choice, or one that draws the same, up to a quarter of the samples: closer, both
      // would err alike.
      const share = errorOf(points.at(-1)) === 0 ? 4 : 1;
      const list = points.filter(({samples}) => share * samples <= right.samples)
        .map((point) => [point.samples, errorOf(point)]);
      const mean = (of) => list.reduce((sum, one) => sum + of(one), 0) / list.length;
      const x = mean(([n]) => log(n)), y = mean(([, error]) => log(error));
      return {name, list,
        slope: mean(([n, error]) => (log(n) - x) * (log(error) - y)) / mean(([n]) =>
          (log(n) - x) ** 2)};
    // the chosen one on top
    }).filter(({list}) => list.length > 1).sort((a) => a.name === chosen ? 1 : -1);
    trace.hidden = !lists.length;
    if (trace.hidden) return;
    const errors = lists.flatMap(({list}) => list.map(([, error]) => log(error)));
    const low = Math.floor(Math.min(...errors)), high = Math.max(low + 1,
        Math.ceil(Math.max(...errors))), wide = Math.ceil(log(right.samples));
    const at = (n) => 34 + 190 * log(n) / wide,
      down = (error) => 150 - 140 * (log(error) - low) / (high - low);
    const ticks = (from, to) => Array.from({length: to - from + 1}, (_, i) => 2 ** (from + i));
    const ends = lists.map(({list}) => down(list.at(-1)[1]) + 4);
    const order = ends.map((_, i) => i).sort((a, b) => ends[a] - ends[b]);
    // names do not overlap
    order.forEach((i, k) => { if (k) ends[i] = Math.max(ends[i], ends[order[k - 1]] + 13); });
    trace.innerHTML = `<svg viewBox="0 -16 320 201" role="img"><text x="34" y="-2">error</text>`
      + `<path class="live-grid" d="${
        ticks(low, high).map((error) => `M34 ${down(error)}H224`).join("")}${
        ticks(0, wide).map((n) => `M${at(n)} 10V150`).join("")}"/>${
        ticks(low, high).map((error) => `<text x="29" y="${down(error) + 4}" `
        + `text-anchor="end">${rounded(error, 3)}</text>`).join("")}${
        ticks(0, wide).filter((n) => log(n) % 2 === 0).map((n) => `<text x="${at(n)}" y="165" `
        + `text-anchor="middle">${n}</text>`).join("")}`
      + `<text x="129" y="181" text-anchor="middle">samples</text>${
        lists.map(({name, list}, i) => `<g${name === chosen ? ' class="chosen"' : ""}><path d="M${
          list.map(([n, error]) => `${at(n)} ${down(error)}`).join("L")}"/>${
          list.map(([n, error]) => `<circle cx="${at(n)}" cy="${down(error)}" r="3"/>`)
            .join("")}<text x="232" y="${ends[i]}">${name}</text></g>`).join("")}</svg>`;
    trace.firstChild.ariaLabel = lists.map(({name, list}) =>
      `Error by ${name}: ${list.map(([n, error]) => `${rounded(error, 3)} at ${n}`).join(", ")}`)
      .join(". ");
    trace.append(element("figcaption", {},
      "Error of the picture of 1, 4, 16, … samples: root mean square of its bytes, 0 to 255, "
        + `against the picture of ${right.samples} samples by ${best.name}, which has an error `
        + "of its own.",
      ...lists.reverse().map(({name, slope}) => element("div",
        {textContent: `${name}: with 4 times as many samples the error is ${rounded(4 ** slope,
          2)} times as large; slope ${rounded(slope.toFixed(2), 3)}`}))));
  }
  function moveLine() {
    secondFrame.style.setProperty("--line", `${line.value}%`);
    line.setAttribute("aria-valuetext", `${line.value} % from the left`);
    if (pixel?.column !== undefined) look(pixel);
  }
  function showBeside(data, first, rows) {
    if (first === 0 && (second.width !== data.width || second.height !== rows))
      Object.assign(second, {width: data.width, height: rows});
    secondPaper.putImageData(data, 0, first);
    secondFrame.hidden = false;
    line.hidden = !lies[chapter];
  }
  // The second picture lies on the first, or follows the control that changes it.
  function cover(isOver) {
    isOver ? line.before(secondFrame) : mostRow.after(secondFrame);
    secondFrame.classList.toggle("live-over", isOver);
  }
  // Asks for a small picture now, and for the full one when the reader rests.
  function change() {
    if (!hand) return;
    refresh();
    clearTimeout(idle);
    section.dataset.state = "drawing";
    save.disabled = true;  // a map that is not complete
    say("");
    ask(true);
    idle = setTimeout(() => ask(false), 200);
  }
  function ask(isSmall) {
    unfinished = true;
    tracing = null;  // a point more of the curve would take this request's place
    const asked = words(isSmall ? 2 : 0);
    if (isSmall) small.dataset.words = JSON.stringify(asked);
    const helpers = isSmall ? [] : (others || []).filter((one) => one.isReady);
    due = 1 + helpers.length;
    if (!isSmall) toAddress();
    const message = {kind: "draw", id: ++latest, words: asked, widest: isSmall ? draft : widest,
      small: isSmall, parts: due};
    for (const one of others || []) one.postMessage({kind: "draw"});  // gives up what it draws
    helpers.forEach((one, i) => one.postMessage({...message, part: i + 1}));
    send(message);
  }

  // -- The options.
  const preset = (option) => sceneSets[values["--scene"]]?.[option]
    ?? (option === "--wrap" && values["--mesh"] ? "repeat" : presets[option]);
  const plainView = () => ["color", "globe", undefined].includes(values["--show"]);
  // Only what differs from the presets. A small picture takes one ray per pixel, or two samples; so
  // do normals and objects, of which there is no mean.
  function given(samples) {
    const list = [];
    for (const [option, {here}] of Object.entries(widgets)) {
      const value = values[option];
      if (value === "" || (value === preset(option) && always[chapter] !== option)) continue;
      if (option === "--samples" && (samples || !plainView())) continue;
      list.push(value === "--errors" ? {words: [value], here: () => "errors in texels"}
        : {words: [option, value], here});
    }
    for (const {option} of ownFiles) if (values[option] !== presets[option])
      list.push({words: [option, values[option]]});
    if (broken)
      list.push({words: broken.typed, ...(isOurs(broken) ? {here: () => "the mistake"} : {})});
    return list;
  }
  const words = (samples) => [...(always[chapter] ? sizeOfOne : []),
    ...given(samples).flatMap((one) => one.words),
    ...(samples && compared[chapter] ? ["--samples", String(samples)] : [])];
  function reset() {
    stopTurning();
    values = {...presets, ...begins[chapter]};
    for (const [option, {first, fault}] of Object.entries(widgets)) {
      values[option] ||= first;
      fault?.replaceChildren();
    }
  }
  function startOver() {
    ++attempts;
    mend();
    carried = {};
    newest = {};
    reset();
    forgetFiles();
  }
  function put(option, value) {
    mend();
    const before = Object.fromEntries(Object.keys(widgets).map((one) => [one, preset(one)]));
    values[option] = value;
    widgets[option].fault?.replaceChildren();
    if (option === "--scene") {  // what stands at the old scene's preset goes to the new one's
      for (const one of Object.keys(widgets))
        if (one !== option && (values[one] || "") === (before[one] || ""))
          values[one] = preset(one);
    }
    change();
  }
  function refresh() {
    for (const [option, widget] of Object.entries(widgets))
      widget.show(values[option], preset(option));
    const off = (option, isOff) => {
      for (const one of widgets[option]?.row.querySelectorAll("input, select")
        || []) one.disabled = isOff;
    };
    off("--samples", !plainView());
    off("--number", values["--show"] === "--errors");
    off("--focus", Number(values["--defocus"]) === 0);
    off("--green", values["--normals"] === "");
    off("--squares", values["--scene"] === "lecture");
    const all = given();
    const native = all.filter((one) => !one.here).flatMap((one) => one.words);
    const typed = ["./course run", chapter,
      ...native.map((word) => quoted(files.get(word)?.shown || word))];
    command.replaceChildren(...inWords(typed));
    copy.textContent = "Copy";
    for (const {option, opened, hint} of ownFiles) {
      const own = values[option] !== presets[option] && files.get(values[option]);
      const noted = notes.split("\n").filter((line) => own && line.startsWith(values[option]))
        .join("; ");
      opened.textContent = own ? (noted || values[option]).replaceAll(values[option], own.shown)
        : hint;
    }
    hereOnly.textContent = all.some((one) => one.here)
      ? `The command draws the picture without what only this page can do: ${all.filter((one) =>
        one.here).map((one) => one.here(one.words[1])).join("; ")}.`
      : main.dataset.note || "";
    legend.replaceChildren(...[legends[values["--show"]]
      || [!broken && hints[chapter]?.(values), hint].filter(Boolean).join(" ")].flat());
  }

  // -- The address: what differs from the page's begin, in the command's words and order, and the
  // pixel that is held. Files of the reader's stay out. The playground has several chapters in one
  // address, and keeps none.
  const hasAddress = !main.querySelector("[name=live-chapter]");
  const usual = (option) =>
    begins[chapter]?.[option] ?? (preset(option) || widgets[option]?.first);
  function toAddress() {
    if (!hasAddress) return;
    const list = given().map(({words}) => words)
      .filter((typed) => typed !== broken?.typed)
      .filter(([option, value]) => value === undefined
        || value !== usual(option) && !files.get(value)?.option)
      .map(([option, value]) =>
        option.slice(2) + (value === undefined ? "" : `=${encodeURIComponent(value)}`));
    if (pinned && pixel?.column !== undefined) list.push(`pixel=${pixel.column},${pixel.row}`);
    const now = list.length ? `#${list.join("&")}` : "";
    // a place on the page stays in the address until there is something to say
    if (now === location.hash || !now && isPlace()) return;
    history.replaceState(history.state, "", now || location.pathname + location.search);
  }
  // Sets what the address says. If a part of it says nothing to this picture, all is as it begins:
  // gives a sentence about it.
  function fromAddress() {
    const asked = location.hash.slice(1);
    if (!hasAddress || !asked || isPlace()) return "";
    carried = {};
    const odd = asked.split("&").filter((part) => {
      const [name, ...rest] = part.split("=");
      let value = rest.join("=");
      try { value = decodeURIComponent(value); } catch { return true; }
      if (name === "pixel" && /^\d+,\d+$/.test(value)) {
        const [column, row] = value.split(",").map(Number);
        pixel = {column, row};
        pinned = true;
        example = false;
        return false;
      }
      const option = name === "errors" ? "--show" : `--${name}`;
      if (name === "errors") value = "--errors";
      const {typed, takes} = widgets[option] || {};
      const isTaken = typed ? /^-?[\d.]+(e[+-]?\d+)?$/i.test(value) : takes?.(value);
      if (isTaken) carried[option] = value;
      return !isTaken;
    });
    if (!odd.length) {
      carryOver();
      return "";
    }
    carried = {};
    closeLoupe();
    return unknown(odd.join("&"));
  }
  addEventListener("hashchange", () => {
    if (!hand || built !== chapter || isPlace()) return;
    section.dataset.state = "drawing";  // else the loupe, closed, takes the new address away
    startOver();
    closeLoupe();
    const odd = fromAddress();
    change();
    if (odd) say(odd);
  });

  // -- The form.
  function build(found) {
    built = chapter;
    section.classList.remove("live-waits");
    widgets = {};
    for (const one of [mostRow, rows, moreRows]) one.replaceChildren();
    presets = Object.fromEntries(Object.values(found).map(({name, preset}) => [name, preset]));
    for (const control of controls) {
      const option = found[control.option];
      if (!option || option.words.startsWith("FILE") || control.option in widgets
        || control.in?.includes(chapter) === false) continue;
      if (control.off) presets[control.option] = "";
      const widget = control.range ? slider(control, option) : choice(control, option,
        "--errors" in found);
      if (!widget) continue;
      widgets[control.option] = Object.assign(widget, {here: control.here});
      (control.option === tellsMost[chapter] ? mostRow : control.more ? moreRows : rows)
        .append(widget.row);
    }
    mostRow.hidden = !mostRow.children.length;
    rows.hidden = !rows.children.length;
    more.hidden = !moreRows.children.length;
    ownFiles = fileControls.filter(({option}) => found[option]?.words === "FILE")
      .map((one) => ({...one, opened: element("span")}));
    openers.replaceChildren(...ownFiles.map(({option, button, takes, opened}) => {
      const choose = element("input", {type: "file", accept: takes,
        onchange: () => { openFile(choose.files[0], option); choose.value = ""; }});
      return element("span", {className: "live-open"},
        element("label", {className: "live-button"}, button, choose), " ", opened);
    }));
    openers.hidden = !ownFiles.length;
    refined.hidden = trace.hidden = line.hidden = true;
    secondFrame.hidden = !hasMap;
    cover(Boolean(lies[chapter]));
    canvas.classList.toggle("live-lamp", "--lamp-up" in found);
    save.hidden = !("--projection" in found);
    moveLine();
    reset();
  }
  const rowOf = ({label, told}, about, id, ...fields) => element("div", {title: about},
    element("label", {htmlFor: id, textContent: label}), ...fields.filter(Boolean),
    ...(told ? [element("small", {textContent: told === true ? about : told})] : []));
  function slider(control, {preset: first, help: about}) {
    const {option, label, range: [least, most, step], log, whole, off, turns} = control;
    const id = "live" + option;
    const to = (value) => log ? Math.log10(value) : value;
    const from = (x) =>
      String(!log ? x : whole ? Math.round(10 ** x) : Number((10 ** x).toPrecision(3)));
    const moved = (value) => {
      stopTurning(); undo = {option, before: values[option]};
      put(option, value);
    };
    const field = element("input",
      {type: "range", id, min: to(least), max: to(most), step, value: to(first),
        oninput: () => moved(from(field.value))});
    // Any number that the chapter takes, also beyond the slider's ends. What it refuses is said
    // here, and the number before stays.
    const fault = element("small", {className: "live-fault", role: "alert"});
    const typed = element("input", {type: "number", step: "any", ariaLabel: `${label}, as a number`,
      onchange: () => Number.isFinite(typed.valueAsNumber) ? moved(String(typed.valueAsNumber))
        : refresh()});
    const box = off && element("input", {type: "checkbox", ariaLabel: `${label}: on`,
      onchange: () => put(option, box.checked ? from(field.value) : "")});
    const play = turns && element("button", {type: "button", className: "live-turn",
      textContent: "Turn", onclick: () => turning ? stopTurning() : startTurning()});
    return {
      row: rowOf(control, about, id, box, field, typed, play, fault),
      field, typed, play, fault, first: "", takes: () => true,
      show(value, preset) {
        if (box) Object.assign(box, {checked: value !== "", disabled: !!preset,
          title: preset ? "this scene always blends" : ""});
        field.disabled = typed.disabled = !!box && value === "";
        if (value !== "") field.value = to(value);
        typed.value = value;
        field.setAttribute("aria-valuetext", value === "" ? "off" : value);
      },
    };
  }
  function choice(control, {words: offered, help}, hasErrors) {
    const {option, only, names: own = {}} = control;
    const id = "live" + option;
    const words = (only && !offered.includes("|") ? only
      : [...offered.split("|"), ...(hasErrors && option === "--show" ? ["--errors"] : [])]
        .filter((word) => !only || only.includes(word)))
      .filter((word) => option !== "--show" || !lacks[chapter]?.includes(word));
    if (words.length < 2) return null;
    const field = element("select", {id, onchange: () => put(option, field.value)},
      ...words.map((value) =>
        element("option", {value, textContent: own[value] || names[value] || value})));
    return {row: rowOf(control, help, id, field), field, first: words[0],
      takes: (value) => words.includes(value), show(value) { field.value = value; }};
  }
  // What the reader chose in another chapter stays chosen where this one offers it.
  function carryOver() {
    for (const option of ["--scene", ...Object.keys(widgets)]) {
      if (option in carried && widgets[option]?.takes(carried[option]))
        values[option] = carried[option];
      else if (widgets[option] && values["--scene"] !== presets["--scene"]) values[option] =
        preset(option) || widgets[option].first;
    }
    for (const {option} of ownFiles) if (files.has(carried[option]))
      values[option] = carried[option];
  }
  function remember() {
    for (const option of Object.keys(widgets)) {
      if (values[option] === (preset(option) || widgets[option].first)) delete carried[option];
      else carried[option] = values[option];
    }
    for (const {option} of ownFiles) carried[option] = values[option];
  }
  // Turns the globe, a picture after another; not for readers who asked for less motion.
  let turning = 0;
  function startTurning() {
    turning = performance.now();
    widgets["--degrees"].play.textContent = "Stop";
    turn(turning);
  }
  function turn(now) {
    if (!turning || document.hidden) { stopTurning(); return; }
    const degrees = Number(values["--degrees"]) + Math.max(1, Math.round((now - turning) * 0.03));
    turning = now;
    put("--degrees", String(degrees > 180 ? degrees - 360 : degrees));
  }
  function stopTurning() {
    turning = 0;
    if (widgets["--degrees"]) widgets["--degrees"].play.textContent = "Turn";
  }
  document.addEventListener("visibilitychange", () => { if (document.hidden) stopTurning(); });

  // -- The reader's own file. It is read under another name than the one before, which stays if the
  // new one is refused.
  async function openFile(file, option) {
    const {isRaw} = ownFiles.find((one) => one.option === option) || {};
    if (!file || !option || !hand) return;
    if (file.size > largestFile) {
      say(`${file.name} has ${Math.ceil(
        file.size / (1 << 20))} MiB, more than the 64 that are allowed.`);
      return;
    }
    const name = newest[option] = `own_${++opened}${option}`;
    let bytes;
    try {
      bytes = new Uint8Array(await file.arrayBuffer());
    } catch (error) {
      say(`${file.name} cannot be read: ${error.message}`);
      return;
    }
    if (newest[option] !== name) return;
    section.dataset.state = "reading";
    unfinished = true;
    send({kind: "keep", name, shown: file.name, bytes, option, isRaw});
  }
  // Those of an option but one, or all.
  function forgetFiles(option, but) {
    for (const [name, file] of [...files]) {
      if (!file.option || name === but || (option && file.option !== option)) continue;
      files.delete(name);
      send({kind: "drop", name, isRaw: file.isRaw});
    }
  }
  section.addEventListener("dragover", (event) => { if (ownFiles.length) event.preventDefault(); });
  section.addEventListener("drop", (event) => {
    event.preventDefault();
    const file = event.dataTransfer.files[0];
    const ending = /\.\w+$/.exec(file?.name)?.[0].toLowerCase();
    openFile(file,
      (ownFiles.find(({takes}) => ending && takes.startsWith(ending)) || ownFiles[0])?.option);
  });

  // -- The loupe: a pixel, and each number between its ray and its color.
  function place(event) {
    const [x, y] = partsOf(event, canvas);
    const inside = (share, n) => Math.max(0, Math.min(n - 1, Math.floor(share * n)));
    return full && {column: inside(x, full[0]), row: inside(y, full[1])};
  }
  function look(where) {
    if (!where || !full || !hand) return;
    pixel = where;
    if (looking) { nextLook = where; return; }
    nextLook = null;
    looking = where;
    const texture = ["--scene", "--squares", "--convention", "--rounding",
      "--texture"].map((one) => values[one]).join();
    send({kind: where.column === undefined ? "find" : "look", words: words(), widest, texture,
      ...where});
  }
  // A place on the picture beside: the answer has its pixel.
  function findFrom(event) {
    const [x, y] = partsOf(event, second);
    if (!lies[chapter] && !pinned) look({x, y});
  }
  second.addEventListener("pointermove", findFrom);
  second.addEventListener("pointerleave", () => { if (!pinned) closeLoupe(); });
  // A finger does not move before it leaves: its tap finds the place, and holds it as a click on
  // the picture does.
  second.addEventListener("click",
    (event) => {
      const holds = !pinned || event.pointerType !== "mouse"; pinned = example = false;
      findFrom(event); pinned = holds && !!pixel;
    });
  // The lamp shines from where the pointer drags it: the picture is half of a ball around the
  // globe.
  function dragLamp(event) {
    if (!("--lamp-up" in widgets) || !event.buttons) return;
    if (!dragged) closeLoupe();
    const [x, y] = partsOf(event, canvas).map((part) => Math.max(-1, Math.min(1, 2 * part - 1)));
    const degrees = (radians) => String(Math.round(radians * 180 / Math.PI));
    values["--lamp-around"] = degrees(Math.atan2(x, Math.sqrt(Math.max(0, 1 - x * x - y * y))));
    put("--lamp-up", degrees(Math.asin(-y)));
    dragged = true;
  }
  let dragged = false, resting = 0;
  canvas.addEventListener("pointerdown", (event) => {
    dragged = false;
    if ("--lamp-up" in widgets) canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", dragLamp);
  function closeLoupe() {
    spot.hidden = true;
    pixel = nextLook = null;
    pinned = example = false;
    loupe.hidden = mark.hidden = true;  // its room stays: nothing below moves
    if (section.dataset.state === "done") toAddress();
  }
  canvas.addEventListener("pointermove",
    (event) => {
      if (!pinned && event.pointerType === "mouse" && !event.buttons) {
        example = false;
        look(place(event));
      }
    });
  canvas.addEventListener("pointerleave", () => { if (!pinned) closeLoupe(); });
  canvas.addEventListener("click", (event) => {
    if (dragged) return;
    pinned = !pinned || event.pointerType !== "mouse"; example = false; look(place(event));
    toAddress();
  });
  canvas.addEventListener("blur",
    ({relatedTarget}) => { if (pinned && !section.contains(relatedTarget)) closeLoupe(); });
  loupe.addEventListener("click", ({target}) => target.closest("a") || closeLoupe());
  // While the loupe is open, arrow keys are its own, wherever the focus is but in a field.
  document.addEventListener("keydown", (event) => {
    const step = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1],
      ArrowDown: [0, 1]}[event.key];
    const isMine = event.target === canvas || pixel && !example
      && !event.target.closest("form, input:not([type=radio]), select, textarea");
    if (step && isMine && full) {
      event.preventDefault();
      event.stopPropagation();
      const far = event.shiftKey ? 10 : 1;
      const from = pixel || {column: full[0] >> 1, row: full[1] >> 1};
      const moved = (at, by, n) => Math.max(0, Math.min(n - 1, at + by * far));
      pinned = true;
      example = false;
      look(pixel ? {column: moved(from.column, step[0], full[0]),
        row: moved(from.row, step[1], full[1])} : from);
      clearTimeout(resting);
      resting = setTimeout(toAddress, 500);
    }
  }, true);
  document.addEventListener("keydown", (event) => { if (event.key === "Escape") closeLoupe(); });
  // A number with its full value within, so that formulas can be checked.
  const number = (value, digits = 5) => element("data",
    {value: String(value), title: String(value), textContent: rounded(value, digits)});
  const vector = (list) => ["(", number(list[0]), ", ", number(list[1]), ", ",
    number(list[2]), ")"];
  const swatch = (color) =>
    [element("span", {className: "live-color"}, element("span",
      {className: "live-swatch", style: `background: rgb(${color})`}), ` ${color.join(" ")}`)];
  // The program's formulas by conventions; chapter 02 derives them, docs/conventions.md relates
  // them.
  const across = {
    daily: ["1/2 + atan2({z}, {x}) / 2π", "1/2 + {atan2(z, x)}/{2π}",
      ([x, , z]) => 0.5 + Math.atan2(z, x) / (2 * Math.PI)],
    rtiow: ["1/2 − atan2({z}, {x}) / 2π", "1/2 − {atan2(z, x)}/{2π}",
      ([x, , z]) => 0.5 - Math.atan2(z, x) / (2 * Math.PI)],
    lecture: ["frac(atan2({x}, {z}) / 2π)", "frac({atan2(x, z)}/{2π})",
      ([x, , z]) => (1 + Math.atan2(x, z) / (2 * Math.PI)) % 1],
  };
  const upward = ["atan2(√({x}² + {z}²), {-y}) / π", "{atan2(√{x² + z²}, −y)}/π",
    ([x, y, z]) => Math.atan2(Math.hypot(x, z), -y) / Math.PI];
  const downward = ["atan2(√({x}² + {z}²), {y}) / π", "{atan2(√{x² + z²}, y)}/π",
    ([x, y, z]) => Math.atan2(Math.hypot(x, z), y) / Math.PI];
  function formula(name, [text, symbols, by], normal, result) {
    // this chapter has another formula
    if (!(Math.abs(by(normal) - result) < 1e-9)) return [name, number(result, 6)];
    const filled = [];
    for (const part of text.split(/(\{-?[xyz]\}²?)/)) {
      const [, sign, axis, power] = /^\{(-?)([xyz])\}(²?)$/.exec(part) || [];
      const value = axis && (sign ? -1 : 1) * normal["xyz".indexOf(axis)];
      filled.push(...(!axis ? [part] : power ? [value < 0 ? "(" : "", number(value),
        value < 0 ? ")²" : "²"] : [number(value)]));
    }
    return [name, math(symbols), " = ", ...filled, " = ", number(result, 6)];
  }
  // filled`n · l = ${x}`: text with numbers.
  const filled = (texts, ...parts) => texts.flatMap((text, i) =>
    [text, ...(i < parts.length ? [parts[i]] : []).flat()
      .map((one) => typeof one === "number" ? number(one) : one)]);
  const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
  // From the light and the paint to the color, as chapters 01 and 06 derive it.
  function shadingOf(seen, color) {
    const {to_light: l, normal: n, ambient, diffuse, paint, specular, shininess, mirrored,
      highlight = 0, blend} = seen;
    const cosine = dot(n, l);  // the module's is 0 in shadow
    const list = [["light l", ...vector(l), ...filled`, n · l = ${cosine}`,
      cosine <= 0 ? ": the lamp is behind the surface" : seen.cosine === 0 ? ": in shadow" : ""]];
    if (ambient === undefined) return list;
    const light = ambient + diffuse * seen.cosine;
    list.push(["lambert", ...filled`${ambient} + ${diffuse} · ${seen.cosine} = ${light}`]);
    if (mirrored) {
      const e = seen.direction.map((x) => -x);
      const bySlides = values["--highlight"] === "lecture";
      const base = dot(mirrored, bySlides ? seen.direction : e);
      list.push(["r", ...vector(mirrored), ...filled`, r · ${bySlides ? "d" : "e"} = ${base}`]);
      list.push(["highlight",
        ...(!bySlides && (cosine <= 0 || base <= 0 || seen.cosine === 0) ? ["0"]
          : filled`${specular} · ${base < 0 ? ["(", base, ")"] : base}^${shininess} = ${
            highlight}`),
        bySlides && base < 0 && shininess % 2
          ? ": a negative number to this power is negative, or no number" : ""]);
    }
    // The channels in numbers, where the picture has this color: one ray, the color itself, double.
    const blends = blend !== undefined && seen.texel;
    const white = Math.min(1, light + highlight);
    return [...list, ...channels(color, paint.map((paint) => {
      const result = blends ? 255 * white * (1 - blend) + paint * blend
        : paint * light + 255 * highlight;
      return [result,
        blends ? filled`${255 * white} · (1 − ${blend}) + ${paint} · ${blend} = ${result}`
          : highlight ? filled`${paint} · ${light} + 255 · ${highlight} = ${result}`
            : filled`${paint} · ${light} = ${result}`];
    }))];
  }
  // Rows for red, green and blue; none if they do not make the pixel's color.
  function channels(color, results) {
    const byteOf = (result) => Math.floor(Math.min(Math.max(result, 0), 255) + 1e-6);
    if (results.some(([result], i) => byteOf(result) !== color[i])) return [];
    return results.map(([result, words], i) => [["red", "green", "blue"][i], ...words,
      result >= 256 ? ", at most 255" : ""]);
  }
  // From what is shown in place of the color to the pixel.
  function shownOf(seen, color) {
    if (values["--show"] === "uv" && seen.uv) {
      const [u, v] = seen.uv;
      return channels(color, [[255 * u, filled`255 u = 255 · ${u} = ${255 * u}`],
        [255 * v, filled`255 v = 255 · ${v} = ${255 * v}`], [0, ["0"]]]);
    }
    if (values["--show"] !== "normal") return [];
    return channels(color,
      seen.normal.map((n, i) => [127.5 * (n + 1), [math(`255 {n + 1}/2`.replace("n", "xyz"[i])),
        ...filled` = 255 · (${n} + 1) / 2 = ${127.5 * (n + 1)}`]]));
  }
  const colorAt = (pen, column, row) => [...pen.getImageData(column, row, 1, 1).data.slice(0, 3)];
  const pixelRow = (column, row, color) => ["pixel", around, `column ${column}, row ${row}: `,
    ...swatch(color), ...(pinned ? [element("br"), element("b", {textContent: letsGo})] : [])];
  function factsOf(column, row, seen) {
    const color = colorAt(paper, column, row);
    const list = [pixelRow(column, row, color),
      [given().some(({words}) => words[0] === "--samples") ? "middle ray" : "ray", "from ",
        ...vector(seen.eye), " along d = ", ...vector(seen.direction)]];
    if (seen.distance === undefined)
      return [...list, ["hit", "nothing: the sky"], ...quadraticOf(seen)];
    const center = seen.center.some((x) => x)
      ? filled`(point − center) / radius, center ${vector(seen.center)}` : ["point / radius"];
    list.push(["hit", seen.objects[seen.object][0], ", radius ", number(seen.radius),
      ", at distance ", number(seen.distance)],
    ...quadraticOf(seen), ["point", ...vector(seen.point)],
    ["normal n", ...vector(seen.normal), " = ", ...center]);
    if (seen.rotated && seen.turn[1] !== 1) {
      const [sine, cosine] = seen.turn;
      const [x, , z] = seen.normal;
      list.push(["n rotated", ...vector(seen.rotated), element("span", {className: "live-formula"},
        element("span", {}, math("x ′ = x cos β + z sin β"),
          ...filled` = ${x} · ${cosine} + ${z} · ${sine}`),
        element("span", {}, math("z ′ = z cos β − x sin β"),
          ...filled` = ${z} · ${cosine} − ${x} · ${sine}`))]);
    }
    if (seen.uv) {
      const [u, v] = seen.uv;
      const normal = seen.rotated || seen.normal;
      const convention = seen.texel && values["--convention"] || "rtiow";
      list.push(formula("u", across[convention], normal, u),
        formula("v", convention === "daily" ? downward : upward, normal, v));
    }
    if (seen.texel) {
      const {column, row, width, height, down, floor, color} = seen.texel;
      const times = (n) => floor ? n : `(${n} − 1)`;
      list.push(["texel", `column ⌊u · ${times(width)}⌋ = ${column}, row ${down ? ""
        : `${height - 1} − `}⌊v · ${times(height)}⌋ = ${row}: `, ...swatch(color)]);
    } else if (seen.paint) {
      list.push(["paint", ...swatch(seen.paint.map(Math.floor))]);
    }
    if (seen.squares && seen.uv) {
      const [across, up] = seen.uv.map((x) => Math.floor(Math.min(x, 1 - 2 ** -53) * seen.squares));
      list.push(["square",
        `⌊${seen.squares} u⌋ + ⌊${seen.squares} v⌋ = ${across} + ${up} = ${across
          + up}, ${(across + up) % 2 ? "odd" : "even"}`]);
    }
    if (seen.float) {
      const {object, uv, apart} = seen.float;
      list.push(["in float",
        ...(object !== seen.object ? [object < 0 ? "nothing: the sky" : seen.objects[object][0]]
          : uv ? filled`u = ${uv[0]}, v = ${uv[1]}: ${apart} texel from double's`
            : ["the same object"]), ". The other rows are in double."]);
    }
    return [...list,
      ...(!plainView() ? shownOf(seen, color) : seen.to_light ? shadingOf(seen, color) : [])];
  }
  // Chapter 01's equation of the ray and the sphere that it meets; or that ahead which it passes at
  // the least distance.
  function quadratic({objects, object, eye, direction: d}) {
    const all = objects.map(([name, radius, center]) => {
      const f = eye.map((x, i) => x - center[i]);
      const a = dot(d, d), b = -dot(f, d), c = dot(f, f) - radius ** 2;
      return {name, radius, f, a, b, c,
        away: b > 0 ? Math.sqrt(Math.max(0, dot(f, f) - b * b / a)) - radius : Infinity};
    });
    return all[object] || all.reduce((one, other) => other.away < one.away ? other : one);
  }
  function quadraticOf(seen) {
    if (chapter !== "01") return [];
    const {name, radius, f, a, b, c} = quadratic(seen);
    const discriminant = b * b - a * c, root = Math.sqrt(discriminant);
    const list = [["f", math("f = eye − center"), " = ", ...vector(f),
      seen.object === undefined ? `, of ${name}: the ray comes nearest to it` : ""],
    ["a, b, c", element("span", {className: "live-formula"},
      element("span", {}, math("a = d · d"), " = ", number(a)),
      element("span", {}, math("b = − f · d"), " = ", number(b)), element("span", {},
        math("c = f · f − r²"), ...filled` = ${dot(f, f)} − ${radius}² = ${c}`))],
    ["discriminant", math("b² − a c"), ...filled` = ${b}² − ${a} · ${c} = ${discriminant}`]];
    return discriminant < 0 ? list : [...list, ["t", math("{b ± √{b² − a c}}/a"),
      ...filled` = ${(b - root) / a} and ${(b + root) / a}; the smaller is what we see`]];
  }
  // The ray's line and the sphere, in radii: where they meet.
  function drawQuadratic(seen) {
    drawn.hidden = chapter !== "01";
    if (drawn.hidden) return;
    const {name, radius, a, b, c} = quadratic(seen);
    // 1 − (distance of the line from the center / radius)²
    const share = (b * b - a * c) / (a * radius ** 2);
    const away = Math.sqrt(Math.max(0, 1 - share)), size = 44 / Math.max(1, away),
      half = Math.sqrt(Math.max(0, share)) * size;
    const y = 52 - away * size;
    const says = share < 0 ? "the ray misses it, no root" : share > 0
      ? "the ray's line cuts it twice, two roots" : "the ray touches it, one root";
    const meets = (x) => `<circle class="live-meets" cx="${120 + x}" cy="${y}" r="4"/>`;
    drawn.innerHTML = `<svg viewBox="0 0 240 104" role="img"
      aria-label="A line and a sphere: ${says}">
      <circle cx="120" cy="52" r="${size}"/><path d="M8 ${y}H228m-8 -4l8 4l-8 4M120 52V${y}"/>
      ${share < 0 ? "" : meets(-half) + meets(half)}
      <text x="126" y="${away * size < 16 ? y - 6 : (52 + y) / 2 + 5}">h</text></svg>`;
    drawn.append(element("figcaption",
      {textContent: `${name}: ${says}. The line passes its center at the distance h.`}));
  }
  // The flat texture with the point in a square and the pixel's outline; and a detail of it.
  let flat = null, part = null;
  function keepFlats({whole: all, detail: some}) {
    const image = ({columns, bytes}) => new ImageData(new Uint8ClampedArray(bytes.buffer), columns);
    if (all) flat = image(all);
    part = image(some);
  }
  function drawMap({map: seen}) {
    map.hidden = !seen;
    if (!seen) return;
    const {at, corners, aspect, detail: [left, top, width, height]} = seen;
    const outlined = (canvas, image, [left, top, width, height], square) => {
      Object.assign(canvas, {width: image.width, height: image.height});
      const pen = canvas.getContext("2d"), dot = canvas.width / canvas.clientWidth;
      pen.putImageData(image, 0, 0);
      for (const turn of [-1, 0, 1]) {  // what goes over the seam comes in on the other side
        const to = ([x, y]) => [(x + turn - left) / width * canvas.width,
          (y - top) / height * canvas.height];
        pen.beginPath();
        for (const corner of corners) pen.lineTo(...to(corner));
        pen.closePath();
        const [x, y] = to(at);
        pen.rect(x - square * dot, y - square * dot, 2 * square * dot, 2 * square * dot);
        for (const [color, size] of [["#000", 3.5], ["#fff", 1.5]])
          Object.assign(pen, {strokeStyle: color, lineWidth: size * dot}).stroke();
      }
    };
    whole.style.width = `${Math.min(22, 11 * aspect)}rem`;
    outlined(whole, flat, [0, 0, 1, 1], 6.5);
    outlined(detail, part, [left, top, width, height], 0);
    whole.setAttribute("aria-label",
      `The flat texture. The pixel's point is ${Math.round(
        100 * at[0])} % from the left and ${Math.round(100 * at[1])} % from the top.`);
    mapSays.textContent = `The pixel's point on the flat texture, and ${corners.length < 4
      ? `the ${corners.length} corners of the pixel that meet it` : "the pixel's outline"}, `
      + `${rounded(detail.clientWidth / (width * whole.clientWidth), 2)} times enlarged`;
  }
  // Where two pictures lie on each other, and this place shows the second.
  const isLeft = (column) => lies[chapter] && !broken && second.width === canvas.width
    && column + 0.5 < canvas.width * line.value / 100;
  // Rows and a drawing that the module made: chapters 07 and on.
  function moduleFacts(column, row, {left, ...right}) {
    const seen = left && isLeft(column) ? left : right;
    const color = colorAt(isLeft(column) ? secondPaper : paper, column, row);
    const parts = (list) => list.map((part) => typeof part === "number" ? number(part) : part);
    return [pixelRow(column, row, color),
      ...(left && !broken ? [["filter", isLeft(column) ? `${values["--beside"]}, left of the line`
        : `${values["--filter"]}, right of the line`]] : []),
      ...(seen.figure ? [["", drawing(seen.figure)]] : []),
      ...seen.rows.map(([name, ...list]) => [name, ...parts(list)])];
  }
  function drawing({says, width, height, shapes}) {
    const unit = Math.max(width, height) / 100;
    const paint = (word) => ({ink: "currentColor", accent: "var(--link)"})[word] || word;
    const shape = {
      dot: (color, cx, cy) => svg("circle",
        {cx, cy, r: 1.2 * unit, fill: paint(color), stroke: "#888", "stroke-width": 0.25 * unit}),
      line: (color, x1, y1, x2, y2) =>
        svg("line", {x1, y1, x2, y2, stroke: paint(color), "stroke-width": 0.7 * unit}),
      box: (color, x, y, width, height) =>
        svg("rect", {x, y, width, height, fill: paint(color), "shape-rendering": "crispEdges"}),
      word: (color, x, y, text) => svg("text",
        {x: x + (x < width / 2 ? -2 : 2) * unit,
          y: y + (y < height / 2 ? -1.5 : 5.5) * unit,  // outside of a corner
          "text-anchor": x < width / 2 ? "end" : "start", fill: paint(color),
          "font-size": 6 * unit}, text),
    };
    const box = `${-unit} ${-unit} ${width + 2 * unit} ${height + 2 * unit}`;
    return element("figure", {className: "live-drawing"},
      svg("svg", {viewBox: box, role: "img", "aria-label": says}, svg("rect",
        {width, height, fill: "none", stroke: "currentColor", "stroke-width": 0.3 * unit}),
      ...shapes.map(([kind, ...rest]) => shape[kind](...rest))),
      element("figcaption", {textContent: says}));
  }
  // -- Rows and the code that calculates them: the page names the rows of its lines.
  const lines = [...main.querySelectorAll("[data-row]")];
  const namesOf = (line) => line.dataset.row.split("|");
  // A row "u, v" has the lines of both.
  const linesOf = (name) => lines.filter((line) =>
    [name, ...name.split(", ")].some((one) => namesOf(line).includes(one)));
  const elsewhere = Object.fromEntries((main.dataset.rows || "").split("|")
    .map((one) => one.split("=")));
  const rowNamed = (name) => [...facts.rows].find((row) => row.dataset.name === name);
  // The row's name, as a link to the line that calculates it, here or on a page before.
  function headOf(name) {
    const [line] = linesOf(name), before = elsewhere[name] || elsewhere[name.split(", ")[0]];
    const link = line ? element("a", {href: `#${line.id || name}`, title: "the code, on this page",
      onclick: (event) => {
        event.preventDefault();  // the address keeps the picture's state
        lightUp(name);
        line.scrollIntoView({block: "center"});
      }})
      : before && element("a", {href: before, title: `the code, on page ${before.slice(0, 2)}`});
    link?.append(name);
    return element("th", {scope: "row"}, link || name);
  }
  function lightUp(name = "") {
    const lit = linesOf(name);
    for (const line of lines) {
      const isLit = lit.includes(line);
      line.classList.toggle("live-lit", isLit);
      for (let fold = isLit && line.closest("details"); fold;
        fold = fold.parentElement.closest("details")) fold.open = true;
      if (isLit) tell(line);
    }
  }
  // At the end of a row's last line in a block of code: what it gave for the pixel in the loupe.
  function tell(line) {
    const ends = (name) => line === linesOf(name).filter((one) =>
      one.closest("pre") === line.closest("pre")).at(-1);
    const said = (name) => {
      const cell = rowNamed(name)?.cells[1], parts = cell?.querySelectorAll(".live-formula > span");
      if (!cell) return [];
      if (parts.length) return [...parts].map((part) => part.textContent);
      const text = cell.textContent;
      const end = cell.querySelector("math") ? text.lastIndexOf(" = ") : -1;
      return [`${name}: ${end < 0 ? text : text.slice(end + 3)}`];
    };
    const value = namesOf(line).filter(ends).flatMap(said).join("; ").slice(0, 160);
    if (value) line.dataset.value = value;
    else delete line.dataset.value;
  }
  for (const kind of ["pointerover", "focusin"]) {
    facts.addEventListener(kind, ({target}) => lightUp(target.closest("tr")?.dataset.name));
    main.addEventListener(kind, ({target}) => {
      const line = target.closest("[data-row]");
      for (const row of facts.rows)
        row.classList.toggle("live-lit", linesOf(row.dataset.name).includes(line));
      if (line) tell(line);
    });
  }
  facts.addEventListener("pointerleave", () => lightUp());
  function showLoupe(column, row, seen) {
    facts.replaceChildren(...(seen.rows ? moduleFacts(column, row, seen) : factsOf(column, row,
      seen)).map(([name, ...what]) => {
      const made = element("tr", {}, ...(name ? [headOf(name)] : []),
        element("td", {colSpan: name ? 1 : 2}, ...what));
      made.dataset.name = name;
      return made;
    }));
    const lens = zoomed.getContext("2d");
    lens.imageSmoothingEnabled = false;
    lens.clearRect(0, 0, 11, 11);
    lens.drawImage(isLeft(column) ? second : canvas, column - 5, row - 5, 11, 11, 0, 0, 11, 11);
    loupe.classList.toggle("live-pinned", pinned);
    // Margins count in widths, and the canvas is as wide as its frame: the mark stays in place when
    // the window changes.
    Object.assign(mark.style, {left: `${100 * (column + 0.5) / full[0]}%`, top: 0,
      marginTop: `calc(${100 * (row + 0.5) / full[0]}% - 7px)`});
    loupe.ariaLive = example ? "off" : "polite";
    loupe.hidden = mark.hidden = false;
    drawMap(seen);
    drawQuadratic(seen);
    room.style.minHeight =
      `${Math.max(loupe.offsetHeight, parseFloat(room.style.minHeight) || 0)}px`;
  }

  // -- Break it: the picture with a usual mistake, and the right one left of a line.
  function mend() {
    if (!broken) return;
    broken = null;
    secondFrame.hidden = line.hidden = true;
    cover(Boolean(lies[chapter]));
    command.parentElement.hidden = false;
    wrongs.value = "";
    verdict.replaceChildren();
  }
  const isDrawn = async () => {
    while (section.dataset.state === "drawing") await new Promise((next) => setTimeout(next, 50));
    return section.dataset.state === "done";
  };
  async function breakIt(slip, isAsked = false) {
    if (!broken) {  // else the right picture is there
      const before = words().join();
      startOver();
      const mine = attempts;
      if (words().join() !== before || section.dataset.state !== "done") change();
      if (!await isDrawn() || mine !== attempts) return false;
      Object.assign(second, {width: canvas.width, height: canvas.height});
      secondPaper.drawImage(canvas, 0, 0);
      cover(true);
    }
    command.parentElement.hidden = isAsked;  // it would tell
    broken = slip;
    change();
    if (!await isDrawn() || broken !== slip) return false;
    secondFrame.hidden = line.hidden = false;
    wrongs.value = slip.words;
    return true;
  }
  // What drew it: the line that was changed, or what is right in words.
  const signed = (lines, sign) => lines.replace(/^/gm, `${sign} `);
  const changed = ({right, wrong}) => element("pre", {}, element("code", {},
    element("span", {className: "removed", textContent: signed(right, "-")}), "\n",
    wrong && element("span", {className: "added", textContent: signed(wrong, "+")})));
  const told = (slip) => [element("b", {textContent: `${slip.words}. `}),
    ...(slip.right ? [changed(slip)] : slip.change ? ["Right: ", ...slip.change.split("`").map(
      (part, i) => i % 2 ? element("code", {textContent: part}) : part), ". "] : []),
    "Left of the line is the right picture. ", changes().words,
    isOurs(slip) ? "The calculation of a pixel is the right one. " : "",
    element("a", {href: `symptoms.html#${slip.card}`, textContent:
      slip.card ? "The card of this mistake" : "More mistakes and their pictures"})];
  // What the mistake changes in words, and whether it can be seen: here and there, or everywhere.
  function changes() {
    const [a, b] = [paper, secondPaper].map((pen) =>
      pen.getImageData(0, 0, canvas.width, canvas.height).data);
    const all = differences(a, b), changed = all.filter((by) => by > 0);
    const most = changed.reduce((one, other) => Math.max(one, other), 0),
      sum = changed.reduce((one, other) => one + other, 0);
    return {isSeen: most >= 24 || sum / all.length >= 5,
      words: `${changed.length.toLocaleString("en")} of ${
        all.length.toLocaleString("en")} pixels change, by at most ${most} of 255. `};
  }
  const without = (list, one) => list.filter((other) => other !== one);
  const drawnBy = (list) => list[Math.floor(Math.random() * list.length)];
  function judge(...words) {
    if (!isWide.matches) {  // else the loupe would part the picture from these words
      closeLoupe();
      room.style.minHeight = "";
    }
    verdict.replaceChildren(...words);
    verdict.scrollIntoView({block: "nearest"});
  }
  async function quiz() {
    let slip = broken;
    do {  // until it can be seen
      slip = drawnBy(without(slips, slip));
      if (!await breakIt(slip, true)) return;
      command.parentElement.hidden = true;
      wrongs.value = "";
    } while (!changes().isSeen);
    const second = drawnBy(without(slips, slip));
    const third = drawnBy(without(without(slips, slip), second));
    const choices = [slip, second, third].filter(Boolean)
      .sort((a, b) => a.words < b.words ? -1 : 1);
    judge("Left of the line is the right picture. What is wrong? ",
      ...choices.map((one) => element("button", {type: "button", textContent: one.words,
        onclick: () => {
          command.parentElement.hidden = false;
          wrongs.value = slip.words;
          judge(one === slip ? "Yes: " : "No, it is: ", ...told(slip));
          guess.focus({preventScroll: true});  // the buttons are gone
        }})));
  }
  wrongs.append(element("option", {value: "", textContent: "nothing is wrong"}),
    ...slips.map(({words}) => element("option", {value: words, textContent: words})));
  wrongs.onchange = async () => {
    const slip = slips.find(({words}) => words === wrongs.value);
    if (!slip) { ++attempts; mend(); change(); return; }
    if (await breakIt(slip)) judge(...told(slip));
  };
  const guess = element("button", {type: "button", textContent: "Which mistake is it?",
    onclick: quiz});
  // Above the form: the picture and the answers are seen together.
  form.before(element("details", {className: "live-break", hidden: !slips.length},
    element("summary", {textContent: "Break it"}),
    element("p", {}, element("label", {}, "A usual mistake: ", wrongs), " ", guess), verdict));

  // The room of the largest loupe is that of a width.
  new ResizeObserver(([{contentRect: {width}}]) => {
    if (width !== roomOf) room.style.minHeight = "";
    roomOf = width;
  }).observe(room);
  // A book's arrow keys turn its pages: not while they move something here.
  section.addEventListener("keydown", (event) => {
    if (event.key.startsWith("Arrow") || event.key === "/") event.stopPropagation();
  });
  for (const one of main.querySelectorAll("input[name=live-chapter]")) {
    one.addEventListener("change", () => {
      remember();
      chapter = one.value;
      stopTurning();
      closeLoupe();
      room.style.minHeight = "";
      clearTimeout(idle);
      hand?.terminate();  // with what it still draws
      start();
    });
  }
  start();
}

// The chapters' module needs exceptions, as in this one: (func (try (do (nop)) (catch_all (nop)))).
const hasExceptions = () => WebAssembly.validate(Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1,
  96, 0, 0, 3, 2, 1, 0, 10, 10, 1, 8, 0, 6, 64, 1, 25, 1, 11, 11));
// A page that shows another page's live picture alone asks for ?only=picture.
if (!inWorker && new URLSearchParams(location.search).get("only") === "picture")
  document.documentElement.classList.add("only");
addEventListener("DOMContentLoaded", () => {
  const main = document.querySelector("main[data-live]");
  if (!main) return;
  if (typeof WebAssembly === "undefined" || !hasExceptions()
    || typeof DecompressionStream === "undefined") {
    document.querySelector(".live-place")?.remove();
    return;
  }
  live(main,
    fetched("modules", main.dataset.live > "06" ? `${main.dataset.live}.js` : "modules.js"));
});

if (inWorker && location.hash) worker();
return {
  modules: (text) => arrival("modules").give(bytesOf(text)),
  file: (name, text) => arrival(name).give({bytes: bytesOf(text)}),
  of: {element, svg, rounded, small, copied, painted, partsOf, differences, hire, open, unpacked,
    bytesOf, inWords, isPlace, checkAddress,
    // Whether this is the worker itself, which then answers.
    isHired: (worker) => inWorker && (answering(worker()), true),
    // A page of a single chapter begins, or says that it may not, or that its worker is gone.
    begin: (start) => addEventListener("DOMContentLoaded", () => {
      start().catch(({message}) => {
        placed(message.includes("policy") ? element("p", {className: "wide live-fault",
          textContent: `The picture stays still: ${message}.`}) : "");
        console.info(`The picture stays still: ${message}`);
      });
      addEventListener("unhandledrejection", ({reason}) =>
        document.querySelector("section.budget")?.append(element("p", {className: "live-fault",
          role: "status", textContent: `The live picture stopped (${reason.message || reason}). `
            + "Load the page again to go on."})), {once: true});
    }), placed},
};
})();
