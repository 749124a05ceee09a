#!/bin/sh
# The gallery and a page of ./course diff in a real browser: nothing is too wide, everything has a name, and the controls work.
# usage: test_pages.sh COMPARE_STEPS GALLERY_CMAKE CHAPTERS_FOLDER BIN_FOLDER     Status 77 where no browser is installed.
set -eu
compare_steps=$1
gallery=$2
chapters=$3
bin=$4
browser=""
for name in chromium chromium-browser google-chrome; do
  if command -v "$name" >/dev/null 2>&1; then browser=$name; break; fi
done
if [ -z "$browser" ]; then
  echo "skipped: no browser (chromium or google-chrome) is installed"
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0
failed=0

# check NAME EXPECTED GOT
check() {
  if [ "$2" = "$3" ]; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "FAIL: $1: expected '$2', got '$3'"
  fi
}

# page_says WIDTH FILE SCRIPT: what the script leaves in the attribute data-result of the page, drawn WIDTH pixels wide.
page_says() {
  {
    sed -e '/^<\/body>$/d' -e '/^<\/html>$/d' "$2"
    printf '%s\n' "<script>addEventListener('load', async () => {" \
      "const wait = (ms) => new Promise((done) => setTimeout(done, ms));" \
      "document.body.dataset.result = String(await (async () => { $3 })()); });</script></body></html>"
  } >"${2%.html}-probe.html"
  "$browser" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking \
    --disable-component-update --disable-sync --user-data-dir="$work/browser" --window-size="$1",900 --virtual-time-budget=8000 \
    --dump-dom "file://${2%.html}-probe.html" 2>/dev/null | sed -n 's/.*<body[^>]*data-result="\([^"]*\)".*/\1/p' | head -n 1
}

mkdir -p "$work/out"
names=""
for folder in "$chapters"/[0-9][0-9]_*/; do
  name=$(basename "$folder")
  case "$name" in
    00_*) "$bin/$name" --out "$work/out/$name.png" ;;
    *) "$bin/$name" --quiet --width 160 --height 120 --out "$work/out/$name.png" ;;
  esac
  names="$names${names:+;}$name"
done
"$bin/05_y_rotation" --quiet --width 80 --height 60 --turntable 4 --out "$work/out/05_y_rotation.png"
"$compare_steps" --quiet --width 160 --height 120 --out "$work/out/diff"
cmake "-DCHAPTERS=$names" "-DFOLDER=$chapters" "-DGALLERY=$work/out" -P "$gallery" >/dev/null

too_wide='return document.documentElement.scrollWidth <= innerWidth;'
unnamed='return [...document.querySelectorAll("img")].filter((i) => !i.alt).length;'
page=$work/out/index.html
count=$(echo "$names" | tr ';' '\n' | wc -l)
for width in 500 1280; do
  check "the gallery fits into $width pixels" true "$(page_says $width "$page" "$too_wide")"
  check "a page of differences fits into $width pixels" true "$(page_says $width "$work/out/diff/02-03/index.html" "$too_wide")"
done
check "every picture of the gallery has an alternative text" 0 "$(page_says 1280 "$page" "$unnamed")"
check "every picture is there" "$count" "$(page_says 1280 "$page" 'return [...document.querySelectorAll("section img")].filter((i) => i.complete).length;')"
neighbours=$(find "$work/out/diff" -name index.html | wc -l)
check "every chapter that follows another links to its step" "$neighbours" "$(page_says 1280 "$page" 'return document.querySelectorAll("a[href^=diff]").length;')"
check "the turntable plays and stops" "true Stop,05_y_rotation.png Turn the globe" "$(page_says 1280 "$page" '
  const button = document.querySelector("button[data-frames]"); const image = button.closest("section").querySelector("img");
  button.focus(); button.click(); await wait(350); const playing = /_00[0-3].png$/.test(image.src) + " " + button.textContent;
  button.click(); await wait(200); return playing + "," + image.getAttribute("src") + " " + button.textContent;')"

page=$work/out/diff/02-03/index.html
check "every picture of a comparison has an alternative text" 0 "$(page_says 1280 "$page" "$unnamed")"
check "a comparison needs no network" 0 "$(page_says 1280 "$page" 'return [...document.querySelectorAll("[src],[href]")].filter((e) => !/^data:/.test(e.getAttribute("src") || e.getAttribute("href"))).length;')"
check "the slider moves the cut" "25%" "$(page_says 1280 "$page" 'const s = document.querySelector(".slider input"); s.value = 25; s.dispatchEvent(new Event("input")); return document.querySelector(".pair").style.getPropertyValue("--cut");')"
check "before and after show one picture each" "100%,0%" "$(page_says 1280 "$page" 'const cut = () => document.querySelector(".pair").style.getPropertyValue("--cut"); document.querySelectorAll(".slider button")[1].click(); const a = cut(); document.querySelectorAll(".slider button")[2].click(); return a + "," + cut();')"
check "blinking starts and stops" "true,false" "$(page_says 1280 "$page" 'const b = document.querySelector(".slider button"); b.click(); const on = b.getAttribute("aria-pressed"); b.click(); return on + "," + b.getAttribute("aria-pressed");')"
check "every control can be reached with the keyboard" 5 "$(page_says 1280 "$page" 'let n = 0; for (const e of document.querySelectorAll("input, button, pre[tabindex]")) { e.focus(); n += document.activeElement === e ? 1 : 0; } return n;')"
# The check can fail: a page with a box of 3000 pixels is too wide.
sed 's|</body>|<div style="width:3000px">wide</div></body>|' "$page" >"$work/out/wide.html"
check "a page that is too wide is noticed" false "$(page_says 1280 "$work/out/wide.html" "$too_wide")"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -ge 14 ]
