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
