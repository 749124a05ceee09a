#!/bin/sh
# The book in a real browser, in light and dark, 360 and 1280 pixels wide: everything fits, can be read and is there.
# out/ as a whole is small enough to be sent: the book, the chapters' pictures, the turntable and the pages of ./course diff.
# usage: test_book.sh BOOK ROOT BIN     Status 77 where no browser is installed.
set -eu
book=$1
root=$2
bin=$3
browser=""
for name in chromium chromium-browser google-chrome; do
  if command -v "$name" >/dev/null 2>&1; then
    browser=$name
    break
  fi
done
if [ -z "$browser" ]; then
  echo "skipped: no browser (chromium or google-chrome) is installed"
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

# What ./course draws, with golden pictures in place of drawing them again.
mkdir "$work/out"
for folder in "$root"/chapters/[0-9][0-9]_*/; do
  name=$(basename "$folder")
  if [ -f "$root/tests/golden/$name.png" ]; then
    cp "$root/tests/golden/$name.png" "$work/out/"
  else
    "$bin/$name" --out "$work/out/$name.png" >/dev/null
  fi
done
turntable=$(sed -n 's/.* 05_y_rotation_000.png \(--turntable [^)]*\)).*/\1/p' "$root/chapters/CMakeLists.txt")
# shellcheck disable=SC2086  # options
"$bin/05_y_rotation" --quiet --out "$work/out/05_y_rotation.png" ${turntable:?is not in chapters/CMakeLists.txt}
"$bin/compare_steps" --quiet --shared --drawn "$work/out" --out "$work/out/diff"
"$bin/pack_png" "$work/out"
"$book" "$root" "$work/out"
size=$(find "$work/out" -type f -exec cat {} + | wc -c)
size=$((size / 1024))
[ "$size" -lt 8192 ] || {
  echo "FAIL: out/ has $size KB, more than 8 MB"
  failed=1
}
# The lines of all sources have numbers, which stand in book.css; a page has 18 lines around its source.
numbers=$(grep -o '[0-9][0-9]*\\a' "$work/out/book.css" | wc -l)
longest=$(for page in "$work/out"/source/*.html; do wc -l <"$page"; done | sort -n | tail -n 1)
[ "$numbers" -gt $((longest - 25)) ] || {
  echo "FAIL: book.css numbers $numbers lines, and a source page has $longest"
  failed=1
}
cp "$root/tests/pages/book_probe.html" "$work/out/"
files=$(cd "$work/out" && find . -maxdepth 1 -name '*.html' ! -name book_probe.html | sed 's|^\./||' | sort | tr '\n' ',' | sed 's/,$//')
count=$(echo "$files" | tr ',' '\n' | wc -l)

# probe SCHEME: 1 is light, 0 is dark.
probe() {
  "$browser" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking \
    --disable-component-update --disable-sync --allow-file-access-from-files --user-data-dir="$work/browser$1" \
    --blink-settings=preferredColorScheme="$1" --window-size=1400,1000 --virtual-time-budget=240000 --enable-logging=stderr \
    --dump-dom "file://$work/out/book_probe.html#$files" 2>"$work/log$1" |
    sed -n 's/.*<body[^>]*data-result="\([^"]*\)".*/\1/p' | sed 's/&quot;/"/g; s/&lt;/</g; s/&gt;/>/g; s/&amp;/\&/g' | head -n 1
}

for scheme in 1 0; do
  result=$(probe "$scheme")
  looked=$(echo "$result" | sed -n 's/.*"looked":\([0-9]*\).*/\1/p')
  if [ "$looked" != $((2 * count)) ]; then
    echo "FAIL: ${looked:-none} of $((2 * count)) views were looked at"
    failed=1
  fi
  case "$result" in
    *'"faults":[]'*) ;;
    *)
      echo "FAIL: $result"
      failed=1
      ;;
  esac
  if grep -E 'CONSOLE.*(Error|error)' "$work/log$scheme"; then
    echo "FAIL: the console shows an error"
    failed=1
  fi
done

# The check can fail: a page with a broken picture, pale words and a box of 3000 pixels.
cat >"$work/out/wrong.html" <<'HTML'
<!doctype html><html lang="en"><body style="background:#fff"><main><p style="color:#bbb">pale</p><img src="none.png" alt="none">
<div style="width:3000px">wide</div></main></body></html>
HTML
files=wrong.html
result=$(probe 1)
for fault in "too wide" "no picture" "contrast 1.9"; do
  case "$result" in
    *"$fault"*) ;;
    *)
      echo "FAIL: a wrong page is not noticed: $fault ($result)"
      failed=1
      ;;
  esac
done
# And a link that leads nowhere stops the making of the book.
mkdir -p "$work/root/chapters/01_a" "$work/root/docs" "$work/root/common/tools"
cp -R "$root/common/tools/book" "$root/common/tools/turntable.js" "$work/root/common/tools/"
printf '# 01\n\n[a](none.md) [b](#none)\n' >"$work/root/chapters/01_a/README.md"
if "$book" "$work/root" "$work/wrong" >"$work/said" 2>&1; then
  echo "FAIL: a link that leads nowhere is not noticed"
  failed=1
fi
for fault in 'none.md leads nowhere' 'has no heading #none'; do
  grep -q "$fault" "$work/said" || {
    echo "FAIL: a fault of a link is not named: $fault"
    failed=1
  }
done
echo "$count pages, $size KB"
[ "$failed" -eq 0 ]
