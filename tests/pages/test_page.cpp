// What the pages of all programs are made of.
#include <doctest.h>

#include <algorithm>
#include <array>

#include "engine/files/save_png.hpp"
#include "support/temporary_folder.hpp"
#include "tools/page/page.hpp"

using namespace texmap;
using test::has;

// RFC 4648, section 10, and the digits that letters do not need.
TEST_CASE("bytes are base64 as its document's examples are, and a picture has those of its file") {
  const std::string all = "foobar";
  const std::array<const char*, 7> expected = {"",         "Zg==",     "Zm8=",    "Zm9v",
                                               "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
  for (std::size_t size = 0; size < expected.size(); ++size) {
    const std::string part = all.substr(0, size);
    CHECK(page::base64(std::vector<std::uint8_t>(part.begin(), part.end())) == expected[size]);
  }
  CHECK(page::base64(std::vector<std::uint8_t>{0xFB, 0xFF, 0x00}) == "+/8A");
  const Image image(5, 3, {200, 100, 50});
  const page::Picture shown = page::inside(image);
  CHECK(shown.address == "data:image/png;base64," + page::base64(encode_png(image)));
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

TEST_CASE("captions and names are text; cells and figures are HTML") {
  const page::Picture shown{"a.png", 4, 3};
  CHECK(page::figure(shown, "1 < 2") ==
        "<figure><img width=\"4\" height=\"3\" alt=\"1 &lt; 2\" src=\"a.png\">"
        "<figcaption>1 &lt; 2</figcaption></figure>\n");
  CHECK(has(page::figure(shown, "caption", "said"), "alt=\"said\""));
  CHECK(page::side_by_side({"<p>1</p>", "<p>2</p>"}) ==
        "<div class=\"row\">\n<p>1</p><p>2</p></div>\n");
  CHECK(has(page::slider(shown, "<a>", shown, "b"), "The picture of &lt;a&gt;"));
  CHECK(has(page::table({{"<b>1</b>", "<i>2</i>"}}),
            "<tbody>\n<tr><th scope=\"row\"><b>1</b></th><td><i>2</i></td></tr>\n</tbody>"));
  CHECK(page::verdict(true, "<b>x</b>") == "<p class=\"verdict good\"><b>x</b></p>\n");
  CHECK(page::verdict(false, "x") == "<p class=\"verdict bad\">x</p>\n");
}

TEST_CASE("the difference of two codes keeps all that can be kept, and stays a text") {
  CHECK(has(page::code_difference("0\na\nb\nc\nd\n", "0\na\nx & y\nc\nd\n<e>\n"),
            "line\"><span>  0</span><span>  a</span><span class=\"removed\">- b</span>"
            "<span class=\"added\">+ x &amp; y</span><span>  c</span><span>  d</span>"
            "<span class=\"added\">+ &lt;e&gt;</span></pre>\n"));
  const auto lines = [](const std::string& before, const std::string& after) {
    const std::string html = page::code_difference(before, after);
    return std::count(html.begin(), html.end(), '<') / 2 - 1;
  };
  CHECK(lines("", "") == 0);
  CHECK(lines("a\nb\nc\nb\n", "b\nc\na\nb") == 5);
  // A line that is there twice is taken once.
  CHECK(lines("a\na\n", "a\n") == 2);
  CHECK(lines("a\n", "a\na\n") == 2);
}
