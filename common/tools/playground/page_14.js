// Chapter 14's live picture: an exhibit with a slider, once by the published formula and once by
// the course's.
"use strict";
if (typeof document === "undefined") importScripts("live.js");
(() => {
const {element, small, painted, differences, hire, open, unpacked, isHired, begin, placed, inWords,
  isPlace, checkAddress} = texmapLive.of;

function worker() {
  let code;
  return {
    async load(packed, picture) {
      code = await open(await WebAssembly.compile(await unpacked(packed)));
      return code.lend([picture],
        (start) => JSON.parse(code.answer(code.calls.begin(start, picture.length))));
    },
    draw(dial, value, published, inFloat, width, height) {
      const start = code.calls.draw(dial, value, published, inFloat, width, height);
      return code.memory().slice(start, start + 4 * width * height);
    },
  };
}

const width = 320, height = 240;
// Pixels of another color, by more than a level of 255, as the program's table counts them.
const unlike = (a, b) => differences(a, b).filter((by) => by > 1).length;

async function show() {
  const [ask, dials] = await hire(worker, "14");

  const choice = element("select", {id: "exhibit"},
    ...dials.map(({exhibit, label}, i) =>
      element("option", {value: i, textContent: `${exhibit}: ${label}`})));
  const slider = element("input", {type: "range", id: "extreme", step: 0.01}),
    label = element("label", {htmlFor: "extreme"}), value = element("output", {htmlFor: "extreme"});
  const inDouble = element("input", {type: "checkbox"});
  const sides = ["as published", "this course"].map((name, i) => {
    const canvas = element("canvas", {role: "img", ariaLabel: name}), formula = element("b"),
      wrong = element("span");
    return {published: 1 - i, canvas, formula, wrong, figure: element("figure", {}, canvas,
      element("figcaption", {}, `${name}: `, formula, element("br"), wrong))};
  });
  const note = element("p", {className: "budget-clock"});
  const section = element("section",
    {className: "wide budget", ariaLabel: "The exhibits with sliders"},
    element("p", {className: "budget-row"},
      element("label", {htmlFor: "exhibit",
        textContent: "Ten of the twenty exhibits, each with a slider: "}), choice, " ",
      element("label", {className: "budget-switch"}, inDouble, " both in double")),
    element("p", {className: "budget-row"}, label, ": ", value), slider,
    element("div", {className: "budget-sides"}, ...sides.map(({figure}) => figure)), note);
  placed(section);

  const isWhole = (dial) => dial.exhibit === "highlight";
  const valueOf = (dial) => isWhole(dial) ? Number(slider.value)
    : Math.abs(slider.value - Math.log10(dial.value)) < 0.005 ? dial.value
      : slider.value > slider.max - 0.01 ? dial.most : 10 ** slider.value;
  function choose() {
    const dial = dials[choice.value];
    const at = isWhole(dial) ? (x) => x : Math.log10;
    Object.assign(slider,
      {min: at(dial.least), max: at(dial.most), step: isWhole(dial) ? 1 : 0.01});
    slider.value = at(dial.value);
    label.textContent = dial.label[0].toUpperCase() + dial.label.slice(1);
    for (const side of sides)
      side.formula.textContent = side.published ? dial.published : dial.course;
    change();
  }
  let last = 0, drawing = false, again = false;
  async function change() {
    if (drawing) { again = true; return; }  // the newest setting is drawn next, not all in between
    drawing = true;
    const dial = dials[choice.value], at = valueOf(dial), mine = ++last;
    section.dataset.state = "drawing";
    const shown = isWhole(dial) ? String(at) : at >= 1e7 ? at.toExponential(1).replace("e+", "e")
      : at >= 1000 ? Math.round(at).toLocaleString("en") : small(at);
    value.textContent = shown;
    slider.setAttribute("aria-valuetext", shown);
    const number = inDouble.checked ? 0 : 1;
    const pictures = await Promise.all(sides.map(({published}) => ask("draw", choice.value, at,
      published, number, width, height)));
    sides.forEach(({canvas}, i) => painted(canvas, pictures[i], width, height));
    // while the reader drags, nothing is counted
    const right = again ? null : await ask("draw", choice.value, at, 0, 0, width, height);
    if (right) sides.forEach((side, i) => {
      const count = unlike(pictures[i], right);
      side.wrong.textContent = `${number ? "float" : "double"}: ${count
        ? `${count.toLocaleString("en")} of ${(width * height).toLocaleString("en")} pixels`
        : "no pixel"} unlike the course's in double`;
      section.dataset[side.published ? "published" : "course"] = count;
    });
    const program = `The program's ${dial.exhibit}`;
    note.replaceChildren("Magenta: a place outside the texture, a hole, or a NaN. ",
      ...dial.exhibit === "needle" ? [`${program} has another picture on it.`]
        : at === dial.value ? ["The program draws the published picture: ",
          element("code", {}, ...inWords(["./course", "run", "14", "--exhibit", dial.exhibit,
            "--formulas", "published", "--number", number ? "float" : "double"]))]
          : [`${program} is at ${dial.value < 1e-3 ? dial.value.toExponential(0).replace("-", "−")
            : dial.value.toLocaleString("en")}.`]);
    section.dataset.state = mine === last ? "done" : "drawing";
    drawing = false;
    if (again) { again = false; change(); }
  }
  // The address holds what the reader chose: #exhibit=pole&at=-3.2&number=double.
  const changedBy = (act) => () => {
    act();
    history.replaceState(history.state, "", `#exhibit=${dials[choice.value].exhibit}&at=${
      slider.value}${inDouble.checked ? "&number=double" : ""}`);
    checkAddress(slider, true);
  };
  choice.onchange = changedBy(choose);
  slider.oninput = inDouble.onchange = changedBy(change);
  function fromAddress() {
    const asked = new URLSearchParams(location.hash.slice(1));
    const i = dials.findIndex(({exhibit}) => exhibit === asked.get("exhibit"));
    const at = asked.get("at") ?? "", number = asked.get("number") ?? "float",
      isKnown = i >= 0 && Number.isFinite(Number(at)) && ["float", "double"].includes(number);
    checkAddress(slider, isKnown);
    choice.value = isKnown ? i : 0;
    inDouble.checked = isKnown && number === "double";
    choose();
    if (!isKnown || !at) return;
    slider.value = at;
    change();
  }
  addEventListener("hashchange", () => isPlace() || fromAddress());
  fromAddress();
}
if (!isHired(worker)) begin(show);
})();
