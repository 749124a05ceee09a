// Pages of the course's programs: pictures next to each other, tables, code before and after.
#include "tools/page/page.hpp"

#include <algorithm>
#include <cstddef>

#include "engine/files/save_png.hpp"
#include "engine/files/text.hpp"
#include "engine/files/utf8.hpp"

namespace texmap::page {
namespace {

// Blue and orange, which most color-blind readers tell apart.
constexpr const char* common_style = R"css(
:root { color-scheme: light dark; --ink: #1b1f24; --soft: #57606a; --paper: #fff; --card: #f4f6f8;
  --line: #d0d7de; --good: #0b5cad; --bad: #a8410a; --added: #0072b226; --removed: #d55e0026; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6e9ec; --soft: #a8b0ba; --paper: #15181c; --card: #1f242a; --line: #3a424b;
    --good: #7fb7ff; --bad: #ff9f6b; --added: #3a9ad944; --removed: #d55e0055; }
}
* { box-sizing: border-box; }
body { font: 1rem/1.5 system-ui, sans-serif; margin: 0 auto; padding: 1rem; max-width: 76rem;
  color: var(--ink); background: var(--paper); }
h1 { font-size: 1.5rem; line-height: 1.25; margin: .5rem 0; overflow-wrap: anywhere; }
h2 { font-size: 1.15rem; margin: 2rem 0 .5rem; overflow-wrap: anywhere; }
a { color: var(--good); }
img { max-width: 100%; height: auto; display: block; }
button { font: inherit; padding: .3rem .9rem; }
:focus-visible { outline: 3px solid var(--good); outline-offset: 2px; }
.verdict { padding: .6rem .9rem; border-left: .5rem solid; }
.verdict.good { border-color: var(--good); }
.verdict.bad { border-color: var(--bad); }
td.good, span.good { color: var(--good); font-weight: 600; }
td.bad, span.bad { color: var(--bad); font-weight: 600; }
figure { margin: 0; }
figcaption { color: var(--soft); overflow-wrap: anywhere; }
.row { display: grid; gap: 1rem; align-items: start;
  grid-template-columns: repeat(auto-fit, minmax(min(15rem, 100%), 1fr)); }
.slider .pair { position: relative; width: fit-content; max-width: 100%; }
.pair img + img { position: absolute; inset: 0; width: 100%; height: 100%;
  clip-path: inset(0 0 0 var(--cut, 50%)); }
.pair::after { content: ""; position: absolute; top: 0; bottom: 0; left: var(--cut, 50%);
  width: 2px; background: #fff; outline: 1px solid #000; }
.controls { display: flex; flex-wrap: wrap; gap: .5rem 1.5rem; align-items: center;
  margin: .5rem 0; }
.controls input { width: min(30rem, 70vw); vertical-align: middle; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; }
th, td { padding: .25rem .8rem .25rem 0; text-align: left; vertical-align: top;
  border-bottom: 1px solid var(--line); }
td { font-variant-numeric: tabular-nums; }
pre { font-size: .85rem; line-height: 1.4; overflow-x: auto; padding: .5rem;
  border: 1px solid var(--line); background: var(--card); color: var(--soft); }
pre span { display: block; min-width: fit-content; }
.removed, .added { color: var(--ink); }
.removed { background: var(--removed); }
.added { background: var(--added); }
)css";

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// @param tag  its name, and attributes behind it
std::string in_tag(const std::string& tag, const std::string& html) {
  return "<" + tag + ">" + html + "</" + tag.substr(0, tag.find(' ')) + ">";
}

}  // namespace

const char* const slider_script = R"js(
for (const slider of document.querySelectorAll(".slider")) {
  const pair = slider.querySelector(".pair");
  const range = slider.querySelector("input");
  const [blink, before, after] = slider.querySelectorAll("button");
  let timer = 0;
  const cut = (percent) => pair.style.setProperty("--cut", percent + "%");
  const stop = () => {
    clearInterval(timer);
    timer = 0;
    blink.textContent = "Blink";
    blink.setAttribute("aria-pressed", "false");
  };
  const go_to = (percent) => { stop(); range.value = percent; cut(percent); };
  range.addEventListener("input", () => go_to(range.value));
  before.addEventListener("click", () => go_to(100));
  after.addEventListener("click", () => go_to(0));
  blink.addEventListener("click", () => {
    if (timer) { go_to(range.value); return; }
    let shows_after = false;
    const turn = () => { shows_after = !shows_after; cut(shows_after ? 0 : 100); };
    turn();
    timer = setInterval(turn, 700);
    blink.textContent = "Stop";
    blink.setAttribute("aria-pressed", "true");
  });
}
)js";

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string encoded;
  encoded.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = bytes.size() - i < 3 ? bytes.size() - i : 3;
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8U | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      encoded += k <= count ? digits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return encoded;
}

std::string framed(const Frame& frame, const std::string& body_html) {
  const std::string title = escaped_foreign(frame.title);
  std::string html =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
      "img-src data: file: 'self'; style-src 'unsafe-inline'";
  if (!frame.script.empty()) html += "; script-src 'unsafe-inline'";
  html.append("\">\n<link rel=\"icon\" href=\"data:,\">\n<title>").append(title);
  html.append("</title>\n<style>").append(common_style).append(frame.style);
  html.append("</style>\n</head>\n<body>\n<main>\n<h1>").append(title).append("</h1>\n");
  html.append(body_html).append("</main>\n");
  if (!frame.script.empty()) html.append("<script>").append(frame.script).append("</script>\n");
  return html.append("</body>\n</html>\n");
}

std::string escaped_foreign(std::string_view text) {
  std::string html;
  html.reserve(text.size());
  while (!text.empty()) {
    const char32_t c = take_character(text);
    if (c < 0x80 && (is_harmless(c) || c == '\n' || c == '\t')) {
      html += escaped_markup(std::string(1, static_cast<char>(c)));
    } else {
      append_utf8(html, is_harmless(c) ? c : replacement_character);
    }
  }
  return html;
}

std::string address_of(std::string_view path) {
  std::string address;
  for (const char c : path) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("/._-~").find(c) != std::string_view::npos;
    address += plain ? std::string(1, c)
                     : text("%%%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return address;
}

Picture inside(const Image& image) {
  return {"data:image/png;base64," + base64(encode_png(image)), image.width, image.height};
}

std::string picture(const Picture& picture, const std::string& alternative) {
  return text("<img width=\"%d\" height=\"%d\" alt=\"", picture.width, picture.height) +
         escaped_foreign(alternative) + "\" src=\"" + picture.address + "\">";
}

std::string figure(const Picture& picture, const std::string& caption,
                   const std::string& alternative) {
  const std::string image = page::picture(picture, alternative.empty() ? caption : alternative);
  return in_tag("figure", image + in_tag("figcaption", escaped_foreign(caption))) + "\n";
}

std::string side_by_side(const std::vector<std::string>& figures_html) {
  std::string html = "\n";
  for (const std::string& figure_html : figures_html) html += figure_html;
  return in_tag("div class=\"row\"", html) + "\n";
}

std::string slider(const Picture& before, const std::string& before_name, const Picture& after,
                   const std::string& after_name) {
  return "<div class=\"slider\">\n<div class=\"pair\">" +
         picture(before, "The picture of " + before_name) +
         picture(after, "The picture of " + after_name) +
         "</div>\n<div class=\"controls\"><label>" + escaped_foreign(before_name) +
         " <input type=\"range\" min=\"0\" max=\"100\" value=\"50\" "
         "aria-label=\"Where the pictures meet\"> " +
         escaped_foreign(after_name) +
         "</label>\n<button type=\"button\" aria-pressed=\"false\">Blink</button>"
         "<button type=\"button\">Before</button><button type=\"button\">After</button>"
         "</div>\n</div>\n";
}

std::string table(const std::vector<std::vector<std::string>>& rows_html) {
  std::string html = "<div class=\"scroll\"><table>\n<tbody>\n";
  for (const std::vector<std::string>& row : rows_html) {
    std::string cells;
    for (const std::string& cell : row)
      cells += in_tag(cells.empty() ? "th scope=\"row\"" : "td", cell);
    html += in_tag("tr", cells) + "\n";
  }
  return html + "</tbody>\n</table></div>\n";
}

std::string verdict(bool good, const std::string& sentence_html) {
  return in_tag(good ? "p class=\"verdict good\"" : "p class=\"verdict bad\"", sentence_html) +
         "\n";
}

std::string code_difference(std::string_view before_text, std::string_view after_text) {
  const std::vector<std::string_view> before = lines_of(before_text);
  const std::vector<std::string_view> after = lines_of(after_text);
  // common[i][j] is the length of the longest common subsequence of the lines from i and from j on.
  // The table grows with the product of the lines: lessons are short.
  std::vector<std::vector<int>> common(before.size() + 1, std::vector<int>(after.size() + 1, 0));
  for (std::size_t i = before.size(); i-- > 0;) {
    for (std::size_t j = after.size(); j-- > 0;) {
      common[i][j] = before[i] == after[j] ? common[i + 1][j + 1] + 1
                                           : std::max(common[i + 1][j], common[i][j + 1]);
    }
  }
  std::string html = "<pre tabindex=\"0\" aria-label=\"The code before and after, line by line\">";
  const auto show = [&html](const char* tag, const char* mark, std::string_view line) {
    html += in_tag(tag, mark + escaped_foreign(line));
  };
  for (std::size_t i = 0, j = 0; i < before.size() || j < after.size();) {
    if (i < before.size() && j < after.size() && before[i] == after[j]) {
      show("span", "  ", before[i++]);
      ++j;
    } else if (j == after.size() || (i < before.size() && common[i + 1][j] >= common[i][j + 1])) {
      show("span class=\"removed\"", "- ", before[i++]);
    } else {
      show("span class=\"added\"", "+ ", after[j++]);
    }
  }
  return html.append("</pre>\n");
}

}  // namespace texmap::page
