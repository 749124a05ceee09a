// What the pages of all programs are made of.
#include <doctest.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/picture/save_png.hpp"
#include "tools/page/code_difference.hpp"
#include "tools/page/page.hpp"

using namespace texmap;
using page::Change;

namespace {

bool has(const std::string& html, const std::string& words) {
  return html.find(words) != std::string::npos;
}

/// RFC 4648, strictly: whole groups of four, zero bits behind the last byte, and then = alone.
std::vector<std::uint8_t> bytes_of_base64(const std::string& text) {
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int kept = 0;
  REQUIRE(text.size() % 4 == 0);
  for (const char c : text) {
    if (c == '=') continue;
    const std::size_t value =
        std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/").find(c);
    REQUIRE(value != std::string::npos);
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    kept += 6;
    if (kept < 8) continue;
    kept -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> kept & 0xFFU));
  }
  CHECK((bits & ((1U << kept) - 1U)) == 0);
  CHECK(text.size() == (bytes.size() + 2) / 3 * 4);
  CHECK(text.find('=') >= text.size() - 2);
  return bytes;
}

}  // namespace

TEST_CASE("a picture inside a page has the bytes of its file, whatever their number is") {
  const std::string mark = "data:image/png;base64,";
  for (std::uint8_t count = 0; count < 8; ++count) {
    std::vector<std::uint8_t> bytes;
    for (std::uint8_t i = 0; i < count; ++i)
      bytes.push_back(static_cast<std::uint8_t>(251 * (i + 1)));
    const page::Picture shown = page::inside(bytes, 3, 2);
    REQUIRE(shown.address.starts_with(mark));
    CHECK(bytes_of_base64(shown.address.substr(mark.size())) == bytes);
  }
  const Image image(5, 3, {200, 100, 50});
  const page::Picture shown = page::inside(image);
  CHECK(bytes_of_base64(shown.address.substr(mark.size())) == encode_png(image));
  CHECK(has(page::picture(shown, "a \"red\" box"),
            R"(<img width="5" height="3" alt="a &quot;red&quot; box" src="data:image/png)"));
}

TEST_CASE("a page is whole, names itself, loads nothing, and runs a script only if it has one") {
  const std::string plain = page::framed({"a < b", {}, {}}, "<p>body</p>\n");
  CHECK(plain.starts_with("<!doctype html>\n<html lang=\"en\">"));
  CHECK(plain.ends_with("</body>\n</html>\n"));
  CHECK(has(plain, "<title>a &lt; b</title>"));
  CHECK(has(plain, "<h1>a &lt; b</h1>\n<p>body</p>"));
  CHECK(has(plain, "default-src 'none'"));
  CHECK(has(plain, "prefers-color-scheme: dark"));
  CHECK_FALSE(has(plain, "script"));
  CHECK_FALSE(has(plain, "http:"));
  CHECK_FALSE(has(plain, "https:"));
  const std::string more = page::framed({"t", "p { color: red; }", "let x;"}, "");
  CHECK(has(more, "p { color: red; }</style>"));
  CHECK(has(more, "<script>let x;</script>"));
  CHECK(has(more, "script-src 'unsafe-inline'"));
}

TEST_CASE("somebody's text cannot become markup, hide itself or turn the writing's direction") {
  const std::string bad = "\xEF\xBF\xBD";
  const auto shown = [](const std::string& text) { return page::escaped_foreign(text); };
  CHECK(shown("<script>alert(\"1\" & 2)</script>") ==
        "&lt;script&gt;alert(&quot;1&quot; &amp; 2)&lt;/script&gt;");
  CHECK(shown("two\nlines\tand a tab") == "two\nlines\tand a tab");
  CHECK(shown("\x1b[31mred\r\x7f") == bad + "[31mred" + bad + bad);
  CHECK(shown(std::string("a\0b", 3)) == "a" + bad + "b");
  // The first and last characters of each length, and a C1 control character.
  for (const char* text :
       {"\xC2\xA0", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEE\x80\x80", "\xEF\xBF\xBF",
        "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF", "\xC3\xA4\xE2\x82\xAC"}) {
    CHECK(shown(text) == text);
  }
  CHECK(shown("\xC2\x9B") == bad);
  // Too long a form, a surrogate, beyond the last character, cut off, and a byte alone.
  CHECK(shown("\xC0\xBC") == bad + bad);
  CHECK(shown("\xE0\x80\xBC") == bad + bad + bad);
  CHECK(shown("\xED\xA0\x80") == bad + bad + bad);
  CHECK(shown("\xF4\x90\x80\x80") == bad + bad + bad + bad);
  CHECK(shown("\xE2\x82") == bad + bad);
  CHECK(shown("\xE2\x82<") == bad + bad + "&lt;");
  CHECK(shown("\xFF") == bad);
  // One mark for each character: right-to-left override, isolate and mark.
  CHECK(shown("\xE2\x80\xAE") == bad);
  CHECK(shown("\xE2\x81\xA7") == bad);
  CHECK(shown("\xE2\x80\x8F") == bad);
}

TEST_CASE("a path of any bytes is an address that leads to it") {
  CHECK(page::address_of("../03_image_texture.png") == "../03_image_texture.png");
  CHECK(page::address_of("a b/\"c\"#1?%\xC3\xA4.png") == "a%20b/%22c%22%231%3F%25%C3%A4.png");
}

TEST_CASE("captions, names and heads of columns are text; cells and figures are HTML") {
  const page::Picture shown{"a.png", 4, 3};
  CHECK(page::figure(shown, "1 < 2") ==
        "<figure><img width=\"4\" height=\"3\" alt=\"1 &lt; 2\" src=\"a.png\">"
        "<figcaption>1 &lt; 2</figcaption></figure>\n");
  CHECK(has(page::figure(shown, "caption", "said"), "alt=\"said\""));
  CHECK(page::side_by_side({"<p>1</p>", "<p>2</p>"}) ==
        "<div class=\"row\">\n<p>1</p><p>2</p></div>\n");
  CHECK(has(page::slider(shown, "<a>", shown, "b"), "The picture of &lt;a&gt;"));
  CHECK(has(page::table({"x < y"}, {{"<b>1</b>", "<i>2</i>"}}),
            "<thead><tr><th scope=\"col\">x &lt; y</th></tr></thead>\n<tbody>\n"
            "<tr><th scope=\"row\"><b>1</b></th><td><i>2</i></td></tr>\n</tbody>"));
  CHECK_FALSE(has(page::table({}, {{"a"}}), "<thead>"));
  CHECK(page::verdict(true, "<b>x</b>") == "<p class=\"verdict good\"><b>x</b></p>\n");
  CHECK(page::verdict(false, "x") == "<p class=\"verdict bad\">x</p>\n");
}

TEST_CASE("code on a page cannot become part of the page") {
  const std::string html =
      page::code_difference("<script>alert(1)</script>\nsame\n", "a && b\nsame\n");
  CHECK(has(html, "<span class=\"removed\">- &lt;script&gt;alert(1)&lt;/script&gt;</span>"));
  CHECK(has(html, "<span class=\"added\">+ a &amp;&amp; b</span>"));
  CHECK(has(html, "<span>  same</span>"));
}

TEST_CASE("the difference of two texts keeps all that can be kept") {
  const auto changes = page::difference_of("0\na\nb\nc\nd\n", "0\na\nx\nc\nd\ne\n");
  const std::array<std::pair<Change, const char*>, 7> expected = {{{Change::kept, "0"},
                                                                   {Change::kept, "a"},
                                                                   {Change::removed, "b"},
                                                                   {Change::added, "x"},
                                                                   {Change::kept, "c"},
                                                                   {Change::kept, "d"},
                                                                   {Change::added, "e"}}};
  REQUIRE(changes.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(changes[i].change == expected[i].first);
    CHECK(changes[i].text == expected[i].second);
  }
  CHECK(page::difference_of("", "").empty());
  CHECK(page::difference_of("same\n", "same\n").front().change == Change::kept);
  // A line that is there twice is taken once from the front or from the end.
  CHECK(page::difference_of("a\na\n", "a\n").size() == 2);
  CHECK(page::difference_of("a\n", "a\na\n").size() == 2);
}

TEST_CASE("a difference tells both texts, and long ones take no table of all pairs of lines") {
  const auto told = [](const std::string& before, const std::string& after) {
    std::string removed, added;
    for (const page::ChangedLine& line : page::difference_of(before, after)) {
      if (line.change != Change::added) removed.append(line.text).append("\n");
      if (line.change != Change::removed) added.append(line.text).append("\n");
    }
    return removed == before && added == after;
  };
  CHECK(told("a\nb\nc\nb\n", "b\nc\na\nb\n"));
  std::string many = "first\n";
  std::string others = "first\n";
  for (std::size_t i = 0; i < 100 * page::most_differing_lines; ++i) {
    many += "a\n";
    others += "b\n";
  }
  CHECK(told(many + "last\n", others + "last\n"));
  CHECK(page::difference_of(many, others).front().change == Change::kept);
}
