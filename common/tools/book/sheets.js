
// Chapter 13's plot: each way to draw that was measured is a button, which shows the way's picture,
// its figures and its command.
for (const trade of document.querySelectorAll(".trade")) {
  const made = (tag, className, ...inside) => {
    const element = Object.assign(document.createElement(tag), {className});
    element.append(...inside);
    return element;
  };
  const {places} = JSON.parse(trade.querySelector("script").textContent);
  const {instructions} = places[places.length - 1]; // the widest
  const ways = places.filter((one) => one.filter === "nearest" &&
    (one.instructions === instructions || !one.number.endsWith("pack")));
  const nameOf = ({number, degree}) => `${number}, ${degree ? `degree ${degree}` : "atan2"}`;
  // Where a value is on an axis, 0 to 1: the axis is logarithmic, and 6 % at its ends are free.
  const axisOf = (values) => {
    const [least, most] = [Math.min(...values), Math.max(...values)].map(Math.log);
    return (value) => 0.06 + 0.88 * (Math.log(value) - least) / (most - least);
  };
  const across = axisOf(ways.map((one) => one.time)),
    up = axisOf(ways.map((one) => one.texels_bound));
  const front = ways.filter((one) =>
    !ways.some((other) => other.time <= one.time && other.texels_bound < one.texels_bound));
  front.sort((a, b) => b.time - a.time);
  // Of the front those with a label, where there is room for it.
  const labeled = [];
  for (const one of front) {
    const isNear = (other) => Math.abs(across(other.time) - across(one.time)) < 0.2
      && Math.abs(up(other.texels_bound) - up(one.texels_bound)) < 0.16;
    if (!labeled.some(isNear)) labeled.push(one);
  }

  // Of the sheet: the picture, and the pixels that a way changes, if the sheet has them.
  const panels = [...document.querySelectorAll(".four figure")];
  const picture = panels[0].querySelector("svg");
  const changesOf = ({number, degree, changed}) =>
    panels.slice(0, 4).find((one) => one.textContent.startsWith(
      `${number.split("-")[0]}, ${degree ? `degree ${degree}`
        : "reference formula"}${changed} pixel`))?.querySelector("svg");

  const plot = made("div", "plot"), about = made("div", "about");
  about.setAttribute("aria-live", "polite");
  const line = front.map((one) => `${100 * across(one.time)},${100 - 100 * up(one.texels_bound)}`)
    .join(" ");
  plot.innerHTML =
    `<svg viewBox="0 0 100 100" preserveAspectRatio="none" aria-hidden="true"><polyline `
      + `points="${line}"/></svg>`;
  const buttons = ways.map((one) => {
    const button = made("button",
      front.includes(one) ? "front" : "", made("i"));
    button.type = "button";
    button.style.left = `${100 * across(one.time)}%`;
    button.style.bottom = `${100 * up(one.texels_bound)}%`;
    button.setAttribute("aria-label", nameOf(one));
    if (labeled.includes(one))
      button.append((changesOf(one) || picture).cloneNode(true), made("span", "", nameOf(one)));
    button.addEventListener("click", () => {
      for (const other of buttons) other.setAttribute("aria-pressed", other === button);
      const {changed, levels} = one;
      const change = changed ? `${changed} pixel${changed > 1 ? "s differ"
        : " differs"}, by up to ${levels} levels` : "no pixel differs";
      const pictures = made("div", "two", picture.cloneNode(true));
      if (changesOf(one)) pictures.append(changesOf(one).cloneNode(true));
      about.replaceChildren(pictures, made("p", "", made("strong", "", nameOf(one)), made("br"),
        `${(1 / one.time).toPrecision(2)} times as fast as plain double; `
        + `at most ${one.texels_bound.toPrecision(2)} texels off; ${change}`),
      made("p", "", made("code", "", one.command || "./course run 13")));
    });
    return button;
  });
  plot.append(made("span", "up", "texels off, at most ↑"),
    made("span", "across", "time, plain double = 1 →"), ...buttons);
  for (const time of [0.03, 0.1, 0.3, 1, 3]) {
    const place = across(time);
    if (place > 0 && place < 1)
      plot.append(Object.assign(made("span", "tick", String(time)),
        {style: `left: ${100 * place}%`}));
  }
  for (let power = -14; power < 2; power += 4) {
    const place = up(10 ** power);
    if (place > 0 && place < 1)
      plot.append(Object.assign(made("span", "tick level", `1e${power}`),
        {style: `bottom: ${100 * place}%`}));
  }
  trade.append(made("h3", "", "What ./course run 13 measured"),
    made("figcaption", "",
      "On the machine where it ran, also with packs. Nothing is both faster and more exact than "
        + "a point on the red line. Click a point for its picture and its command."), plot, about);
  // A label or a small picture stands at that side of its point where it covers nothing, or not at
  // all.
  new ResizeObserver(() => {
    const boxOf = (one) => one.getBoundingClientRect(), all = boxOf(plot);
    const taken = buttons.map((one) => boxOf(one.firstChild));
    for (const part of plot.querySelectorAll(".front > :not(i)")) {
      part.style.display = "";
      if (!boxOf(part).width) continue;  // a narrow window shows none
      const isFree = [[], ["aside"], ["turned"], ["aside", "turned"]].some((sides) => {
        for (const side of ["aside", "turned"]) part.classList.toggle(side, sides.includes(side));
        const box = boxOf(part);
        return box.left > all.left && box.right < all.right + 20 && !taken.some((other) =>
          box.left < other.right && other.left < box.right && box.top < other.bottom
          && other.top < box.bottom);
      });
      if (isFree) taken.push(boxOf(part));
      else part.style.display = "none";
    }
  }).observe(plot);
  // the fastest that changes nothing
  buttons[ways.indexOf(front.findLast((one) => !one.changed))].click();
}

// Chapter 14's list says which exhibit is in sight: the last that begins in the window's upper
// quarter or above.
const names = document.querySelectorAll(".names a");
if (names.length) addEventListener("scroll", () => {
  const seen = [...names].findLast((one) =>
    document.getElementById(one.hash.slice(1)).getBoundingClientRect().top < innerHeight / 4);
  for (const one of names) {
    if ((one === seen) === one.hasAttribute("aria-current")) continue;
    one.toggleAttribute("aria-current", one === seen);
    if (one === seen) one.parentElement.scrollTo({left: one.offsetLeft - 40});
  }
}, {passive: true});
