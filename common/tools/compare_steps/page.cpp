// The page that shows what changed between two steps.
#include <cstdint>
#include <span>

#include "code_difference.hpp"
#include "comparison.hpp"
#include "engine/compare/difference_map.hpp"
#include "engine/measure/text.hpp"
#include "engine/picture/save_png.hpp"

namespace texmap::steps {
namespace {

constexpr const char* style = R"css(
:root { color-scheme: light dark; }
* { box-sizing: border-box; }
body { font: 1rem/1.5 system-ui, sans-serif; margin: 0 auto; padding: 1rem;
  max-width: 68rem; background: Canvas; color: CanvasText; }
h1 { font-size: 1.5rem; line-height: 1.25; }
h2 { font-size: 1.15rem; margin-top: 2rem; }
img { max-width: 100%; height: auto; display: block; }
.verdict { padding: .6rem .9rem; border-left: .5rem solid; }
.good { border-color: #0072b2; }
.bad { border-color: #d55e00; }
.pair { position: relative; width: fit-content; max-width: 100%; }
.pair img + img { position: absolute; inset: 0; width: 100%; height: 100%;
  clip-path: inset(0 0 0 var(--cut, 50%)); }
.pair::after { content: ""; position: absolute; top: 0; bottom: 0; left: var(--cut, 50%);
  width: 2px; background: #fff; outline: 1px solid #000; }
.controls { display: flex; flex-wrap: wrap; gap: .5rem 1.5rem; align-items: center;
  margin: .5rem 0; }
.controls input { width: min(30rem, 70vw); vertical-align: middle; }
button { font: inherit; padding: .3rem .9rem; }
:focus-visible { outline: 3px solid Highlight; outline-offset: 2px; }
.row { display: flex; flex-wrap: wrap; gap: 1rem; }
.row img { image-rendering: pixelated; }
figure { margin: 0; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; }
th, td { padding: .25rem .8rem .25rem 0; text-align: left; border-bottom: 1px solid #8884;
  vertical-align: top; }
td { font-variant-numeric: tabular-nums; }
pre { font-size: .85rem; line-height: 1.4; overflow-x: auto;
  border: 1px solid #8884; padding: .5rem; }
pre span { display: block; min-width: fit-content; }
.removed { background: #d55e0033; }
.added { background: #0072b233; }
)css";

constexpr const char* script = R"js(
const pair = document.querySelector(".pair");
const slider = document.querySelector("#cut");
const blink = document.querySelector("#blink");
let timer = 0;
const cut = (percent) => pair.style.setProperty("--cut", percent + "%");
slider.addEventListener("input", () => { stop(); cut(slider.value); });
function stop() {
  clearInterval(timer);
  timer = 0;
  blink.textContent = "Blink";
  blink.setAttribute("aria-pressed", "false");
}
blink.addEventListener("click", () => {
  if (timer) { stop(); cut(slider.value); return; }
  let after = false;
  const turn = () => { after = !after; cut(after ? 0 : 100); };
  turn();
  timer = setInterval(turn, 700);
  blink.textContent = "Stop";
  blink.setAttribute("aria-pressed", "true");
});
document.querySelector("#before").addEventListener("click", () => {
  stop(); slider.value = 100; cut(100);
});
document.querySelector("#after").addEventListener("click", () => {
  stop(); slider.value = 0; cut(0);
});
)js";

/// Source: RFC 4648, section 4.
std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string encoded;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = bytes.size() - i < 3 ? bytes.size() - i : 3;
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8U | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      encoded += k <= count ? digits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return encoded;
}

/// A picture inside the page.
std::string picture(const Image& image, const std::string& alternative) {
  return "<img width=\"" + std::to_string(image.width) + "\" height=\"" +
         std::to_string(image.height) + "\" alt=\"" + escaped_markup(alternative) +
         "\" src=\"data:image/png;base64," + base64(encode_png(image)) + "\">";
}

std::string figure(const Image& image, const std::string& caption) {
  return "<figure>" + picture(image, caption) + "<figcaption>" + escaped_markup(caption) +
         "</figcaption></figure>\n";
}

std::string table_row(const std::string& name, const std::string& value) {
  return "<tr><th scope=\"row\">" + name + "</th><td>" + value + "</td></tr>\n";
}

std::string rgb(Rgb8 p) { return text("(%d, %d, %d)", p.r, p.g, p.b); }

std::string figures_table(const Comparison& c) {
  const Figures& f = c.figures;
  std::string rows = table_row(
      "pixels that differ",
      text("%zu of %zu (%.3f %%)", f.pixels_different, f.pixels_compared, 100 * f.share_different));
  rows += table_row("of these, elsewhere", text("%zu", c.changed_elsewhere));
  if (f.pixels_different > 0) {
    rows += table_row("box around them",
                      text("columns %d to %d, rows %d to %d", f.box.left,
                           f.box.left + f.box.width - 1, f.box.top, f.box.top + f.box.height - 1));
    rows += table_row("largest difference", text("%d levels at column %d, row %d: ", f.worst.levels,
                                                 f.worst.column, f.worst.row) +
                                                rgb(f.worst.a) + " became " + rgb(f.worst.b));
  }
  rows += table_row("mean absolute error", text("%.4f levels", f.mean_absolute_error));
  rows += table_row("RMSE", text("%.4f levels", f.root_mean_square_error));
  rows += table_row("PSNR",
                    f.pixels_different == 0 ? "infinite" : text("%.2f dB", f.peak_signal_to_noise));
  rows += table_row("SSIM", text("%.6f", f.structural_similarity));
  rows += table_row("FLIP", text("%.6f", f.flip));
  if (c.pixels_with_uv > 0) {
    rows += table_row("pixels with (u, v) in both", text("%zu", c.pixels_with_uv));
    rows +=
        table_row("largest |du|, |dv|", text("%.6g of a turn, %.6g", c.largest_du, c.largest_dv));
  }
  rows += table_row("drawing", text("%.1f ms became %.1f ms (the least of three)",
                                    c.before.milliseconds, c.after.milliseconds));
  return "<div class=\"scroll\"><table>\n" + rows + "</table></div>\n";
}

std::string code_section(const std::string& before, const std::string& after) {
  std::string html =
      "<pre tabindex=\"0\" aria-label=\"The lesson before and after, line by line\">";
  for (const ChangedLine& line : difference_of(before, after)) {
    const char* kind = line.change == Change::kept    ? "kept"
                       : line.change == Change::added ? "added"
                                                      : "removed";
    const char* mark = line.change == Change::kept    ? "  "
                       : line.change == Change::added ? "+ "
                                                      : "- ";
    html +=
        "<span class=\"" + std::string(kind) + "\">" + mark + escaped_markup(line.text) + "</span>";
  }
  return html + "</pre>\n";
}

std::string head(const std::string& title) {
  const std::string name = escaped_markup(title);
  return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
         "name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         name + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n<h1>" + name + "</h1>\n";
}

std::string title_of(const DrawnStep& before, const DrawnStep& after) {
  return "From " + before.chapter + " to " + after.chapter;
}

}  // namespace

std::string scenes_page(const DrawnStep& before, const DrawnStep& after,
                        const std::string& before_code, const std::string& after_code) {
  std::string html = head(title_of(before, after));
  html +=
      "<p class=\"verdict good\">The two chapters draw different scenes, so no pixels are "
      "compared.</p>\n<h2>Both pictures</h2>\n";
  html += figure(before.picture, "The picture of " + before.chapter);
  html += figure(after.picture, "The picture of " + after.chapter);
  html += "<h2>The code</h2>\n" + code_section(before_code, after_code);
  return html + "</body>\n</html>\n";
}

std::string report_page(const Comparison& c, const std::string& before_code,
                        const std::string& after_code) {
  std::string declared;
  for (const int object : c.may_change)
    declared += (declared.empty() ? "" : ", ") + object_name(object);
  const bool good = c.changed_elsewhere == 0;

  std::string html = head(title_of(c.before, c.after));
  html += "<p class=\"verdict " + std::string(good ? "good" : "bad") + "\">";
  html += good ? "Only what may change has changed"
               : text("%zu pixels changed that should not have", c.changed_elsewhere);
  html += ": the step declares " + escaped_markup(declared.empty() ? "no object" : declared) + ".";
  if (!good)
    html += text(" The first of them is at column %d, row %d.", c.stray_column, c.stray_row);
  html += "</p>\n";

  html += "<h2>Both pictures</h2>\n<div class=\"pair\">" +
          picture(c.before.picture, "The picture of " + c.before.chapter) +
          picture(c.after.picture, "The picture of " + c.after.chapter) + "</div>\n";
  html += "<div class=\"controls\"><label>" + escaped_markup(c.before.chapter) +
          " <input id=\"cut\" type=\"range\" min=\"0\" max=\"100\" value=\"50\" aria-label=\"Where "
          "the pictures meet\"> " +
          escaped_markup(c.after.chapter) + "</label>\n";
  html +=
      "<button id=\"blink\" type=\"button\" aria-pressed=\"false\">Blink</button>"
      "<button id=\"before\" type=\"button\">Before</button><button id=\"after\" "
      "type=\"button\">After</button></div>\n";

  html += "<h2>Figures</h2>\n" + figures_table(c);
  html += "<h2>Where they differ</h2>\n" + figure(difference_map(c.before.picture, c.after.picture),
                                                  "Difference in levels; black is none");
  if (c.figures.pixels_different > 0) {
    html += "<h2>Around the largest difference</h2>\n<div class=\"row\">" +
            figure(zoom(c.before.picture, c.figures.worst.column, c.figures.worst.row), "before") +
            figure(zoom(c.after.picture, c.figures.worst.column, c.figures.worst.row), "after") +
            "</div>\n";
  }
  if (c.pixels_with_uv > 0) {
    html += "<h2>Texture coordinates</h2>\n" +
            figure(uv_difference_map(c),
                   "|du| on the left, |dv| on the right, from black (none) to yellow (half a turn, "
                   "the whole "
                   "height); gray where one of the steps has no (u, v)");
  }
  html += "<h2>The code</h2>\n" + code_section(before_code, after_code);
  return html + "<script>" + script + "</script>\n</body>\n</html>\n";
}

}  // namespace texmap::steps
