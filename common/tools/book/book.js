// Search, keyboard and turntable. `packed_sections`, above, is made from the pages.
const box = document.querySelector("#search");
const found = document.querySelector("#found");
let sections = null; // filled by the first search

async function unpacked(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return JSON.parse(await new Response(stream).text());
}

// Sections that hold all words; a word in a title counts more.
function matches(query) {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  if (words.length === 0) return [];
  const rated = [];
  for (const section of sections) {
    const title = section.title.toLowerCase();
    const text = section.words.toLowerCase();
    if (!words.every((word) => title.includes(word) || text.includes(word))) continue;
    rated.push([words.filter((word) => title.includes(word)).length, section]);
  }
  rated.sort((a, b) => b[0] - a[0]);
  return rated.slice(0, 12).map(([, section]) => section);
}

// The words around the first match.
function excerpt(section, query) {
  const word = query.toLowerCase().split(/\s+/)[0];
  const at = Math.max(0, section.words.toLowerCase().indexOf(word) - 40);
  return (at > 0 ? "… " : "") + section.words.slice(at, at + 110) + " …";
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
  found.replaceChildren(...list.map((section) => {
    const item = document.createElement("li");
    const link = document.createElement("a");
    link.href = section.url;
    link.textContent = section.title;
    const small = document.createElement("small");
    small.textContent = excerpt(section, box.value.trim());
    link.append(small);
    item.append(link);
    return item;
  }));
  if (list.length === 0 && box.value.trim()) found.textContent = "Nothing holds all of these words.";
}

box.addEventListener("input", show);
document.addEventListener("keydown", (event) => {
  const typing = document.activeElement === box;
  const links = [...found.querySelectorAll("a")];
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
  } else if ((event.key === "ArrowLeft" || event.key === "ArrowRight") && !typing && place < 0 && !event.altKey && !event.ctrlKey &&
             !event.metaKey && !event.shiftKey && !document.activeElement.closest("pre, .scroll, input")) {
    const link = document.querySelector(event.key === "ArrowLeft" ? "a[rel=prev]" : "a[rel=next]");
    if (link) location.href = link.href;
  }
});

// Plays the pictures of a turntable in place of the still picture; the same button stops it.
for (const button of document.querySelectorAll("button[data-frames]")) {
  const image = button.parentElement.closest("figure, section").querySelector("img");
  const frames = button.dataset.frames.split(" ");
  const still = image.getAttribute("src");
  let timer = 0;
  button.addEventListener("click", () => {
    if (timer) {
      clearInterval(timer);
      timer = 0;
      image.src = still;
      button.textContent = "Turn the globe";
      return;
    }
    let frame = 0;
    timer = setInterval(() => { image.src = frames[frame++ % frames.length]; }, 100);
    button.textContent = "Stop";
  });
}
