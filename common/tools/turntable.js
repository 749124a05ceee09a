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
