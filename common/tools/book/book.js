// Search, keyboard and turntable. `packed_sections`, above, is made from the pages.
const box = document.querySelector("#search");
const found = document.querySelector("#found");
let sections = null; // filled by the first search

const element = (name, properties, ...children) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
};

async function unpacked(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return JSON.parse(await new Response(stream).text());
}

// A text's words in small letters, each between blanks, so that a search finds whole words.
const plain = (text) => ` ${text.toLowerCase().replace(/[^\p{L}\p{N}_]+/gu, " ").trim()} `;

// Sections that hold all words: the whole phrase before single words, a title before its text,
// whole words before those that only begin so. The last word may be unfinished.
function matches(query) {
  const phrase = plain(query);
  const words = phrase.trim().split(" ").filter(Boolean);
  if (words.length === 0) return [];
  const rated = [];
  for (const section of sections) {
    section.plain ??= [plain(section.title), plain(section.words)];
    const inAny = (text) => section.plain.some((one) => one.includes(text));
    if (!words.every((word) => inAny(` ${word}`))) continue;
    const [title, text] = section.plain;
    const whole = words.filter((word) => inAny(` ${word} `)).length / words.length;
    const place = 4 * title.includes(phrase) + 3 * text.includes(phrase) + whole;
    rated.push([2 * place
      + words.filter((word) => title.includes(` ${word} `)).length / words.length, section]);
  }
  rated.sort((a, b) => b[0] - a[0]);
  return rated.slice(0, 12).map(([, section]) => section);
}

// A text in pieces, every second of them found: the phrase, or else its words, and those that begin
// with a longer one.
function foundIn(text, query) {
  const words = plain(query).trim().split(" ");
  const hasPhrase = plain(text).includes(plain(query));
  const rest = "[\\p{L}\\p{N}_]*";
  const singly = [...words, ...words.filter((word) => word.length > 2).map((word) => word + rest)];
  const any = hasPhrase ? words.join("[^\\p{L}\\p{N}_]+") : singly.join("|");
  return text.split(new RegExp(`(?<![\\p{L}\\p{N}_])(${any})(?![\\p{L}\\p{N}_])`, "giu"));
}
const marked = (text, query) =>
  foundIn(text, query).map((part, i) => i % 2 ? element("mark", {textContent: part}) : part);

// The words around what was found first.
function excerpt({words}, query) {
  const pieces = foundIn(words, query);
  const at = pieces.length > 1 ? Math.max(0, pieces[0].length - 50) : 0;
  const from = at && words.indexOf(" ", at) + 1;
  return [from ? "… " : "",
    ...marked(words.slice(from, words.indexOf(" ", from + 130) + 1 || undefined), query), "…"];
}

async function show() {
  found.hidden = !box.value.trim();
  if (found.hidden) return;
  if (typeof DecompressionStream === "undefined") {
    found.textContent = "Search needs a newer browser: this one has no DecompressionStream.";
    return;
  }
  sections ??= await unpacked(packed_sections);
  const list = matches(box.value);
  found.replaceChildren(...list.map((section) => element("li", {},
    element("a", {href: section.url}, ...marked(section.title, box.value),
      element("small", {}, ...excerpt(section, box.value))))));
  if (list.length === 0 && box.value.trim())
    found.textContent = "Nothing holds all of these words.";
}

for (const event of ["input", "focus"]) box.addEventListener(event, show);
document.addEventListener("pointerdown",
  ({target}) => { if (!target.closest(".search")) found.hidden = true; });
document.addEventListener("keydown", (event) => {
  const typing = document.activeElement === box;
  const links = found.hidden ? [] : [...found.querySelectorAll("a")];
  const place = links.indexOf(document.activeElement);
  if (event.key === "/" && !typing) {
    event.preventDefault();
    box.focus();
  } else if (event.key === "Escape") {
    box.value = "";
    show();
  } else if (event.key === "Enter" && typing && links.length) {
    links[0].click();
  } else if ((event.key === "ArrowDown" || event.key === "ArrowUp") && (typing || place >= 0)) {
    event.preventDefault();
    const next = place + (event.key === "ArrowDown" ? 1 : -1);
    (links[next] || box).focus();
  } else if ((event.key === "ArrowLeft" || event.key === "ArrowRight") && !typing && place < 0
    && !event.altKey && !event.ctrlKey &&
             !event.metaKey && !event.shiftKey
               && !document.activeElement.closest("pre, .scroll, input, select")) {
    const link = document.querySelector(event.key === "ArrowLeft" ? "a[rel=prev]" : "a[rel=next]");
    if (link) location.href = link.href;
  }
});

// A button beside each command, which copies it without what two blanks part from it: words about
// it.
const command = /^(\.\/course|cmake|git|cd|sudo|apt-get|brew|pacman|bash|curl) /;
for (const code of document.querySelectorAll(".code > pre > code")) {
  if (code.children.length || !code.textContent.split("\n").some((line) => command.test(line)))
    continue;
  code.replaceChildren(...code.textContent.trimEnd().split("\n").map((line) => {
    if (!command.test(line)) return line + "\n";
    const [typed] = line.split("  ");
    const words = element("span", {}, typed,
      element("i", {textContent: line.slice(typed.length)}));
    const copy = element("button", {textContent: "Copy"});
    copy.setAttribute("aria-label", `Copy ${typed}`);
    copy.addEventListener("click", async () => {
      try {
        await navigator.clipboard.writeText(typed);
      } catch {
        // without the words about it
        getSelection().setBaseAndExtent(words, 0, words, words.childNodes.length - 1);
        document.execCommand("copy");
      }
      copy.textContent = "Copied";
      setTimeout(() => { copy.textContent = "Copy"; }, 2000);
    });
    return element("span", {className: "command"}, words, copy);
  }));
}

// No line ends after the hyphens of an option, nor after a minus sign.
for (const code of document.querySelectorAll(":not(pre) > code, .command > span"))
  code.innerHTML = code.innerHTML.replace(/(?<!\w)--?\w[\w-]*/g, "<span class=\"whole\">$&</span>");

// Plays the pictures of a turntable in place of the still picture; the same button stops it. Who
// asked for less motion turns it picture by picture.
for (const button of document.querySelectorAll("button[data-frames]")) {
  const image = button.parentElement.closest("figure, section").querySelector("img");
  document.querySelector("#the-turntable")?.nextElementSibling.after(button.closest("figure"));
  const frames = button.dataset.frames.split(" ");
  const still = image.getAttribute("src");
  const calm = matchMedia("(prefers-reduced-motion: reduce)");
  let timer = 0, frame = 0;
  const turn = () => { image.src = frames[frame++ % frames.length]; };
  button.addEventListener("click", () => {
    const starts = !timer && !calm.matches;
    clearInterval(timer);
    if (calm.matches) turn();
    else if (!starts) image.src = still;
    timer = starts ? setInterval(turn, 100) : 0;
    button.textContent = starts ? "Stop" : "Turn the globe";
  });
}

// The list of 14's exhibits marks the one that is read.
const names = [...document.querySelectorAll(".names a")];
const reading = new IntersectionObserver((seen) => {
  for (const {isIntersecting, target} of seen) {
    const name = names.find(({hash}) => hash === `#${target.id}`);
    if (isIntersecting) name.setAttribute("aria-current", "true");
    else name.removeAttribute("aria-current");
  }
}, {rootMargin: "-12% 0px -87%"});
for (const {hash} of names) reading.observe(document.querySelector(hash));
