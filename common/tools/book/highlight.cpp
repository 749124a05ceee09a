#include "highlight.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <sstream>
#include <string_view>

#include "engine/files/text.hpp"
#include "markdown.hpp"

namespace texmap::book {
namespace {

/// With a blank before and after each.
constexpr std::string_view keywords =
    " auto bool break case catch char class concept const constexpr continue decltype default "
    "delete do double else enum explicit extern false float for friend if inline int long "
    "namespace new noexcept nullptr operator override private protected public requires return "
    "short signed sizeof static struct switch template this throw true try typename union "
    "unsigned using virtual void while #include #define #pragma #if static_assert ";

/// Longer lines take the margin, too.
constexpr std::ptrdiff_t columns_of_text = 58;

/// Text between tags, where only these two signs mean something else.
std::string escaped_text(std::string html) {
  replace_all(html, "&", "&amp;");
  replace_all(html, "<", "&lt;");
  return html;
}

/// Words in an element with a short name, for a file has thousands; book.css colors it.
std::string element(const std::string& name, const std::string& words) {
  return "<" + name + ">" + escaped_text(words) + "</" + name + ">";
}

/// The line in an element that names the rows it calculates: data-row="u|v".
std::string named_by_rows(const std::string& line, const std::string& html, const Place& place) {
  std::string names;
  for (const auto& [name, piece] : place.rows) {
    if (line.find(piece) == std::string::npos) continue;
    if (!names.empty()) names += '|';
    names += escaped_markup(name);
  }
  return names.empty() ? html : "<span data-row=\"" + names + "\">" + html + "</span>";
}

bool is_of_a_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '#';
}

/// A line of C++ or of a build script as HTML: comments, texts and keywords in spans.
std::string highlighted_line(const std::string& line) {
  std::string html;
  for (std::size_t i = 0; i < line.size();) {
    std::size_t end = i + 1;
    if (line.compare(i, 2, "//") == 0) {
      return html + element("i", line.substr(i));
    }
    if (line[i] == '"') {
      while (end < line.size() && line[end] != '"') end += line[end] == '\\' ? 2U : 1U;
      end = end < line.size() ? end + 1 : line.size();
      html += element("u", line.substr(i, end - i));
    } else if (is_of_a_word(line[i])) {
      while (end < line.size() && is_of_a_word(line[end])) ++end;
      const std::string word = line.substr(i, end - i);
      const bool is_keyword = keywords.find(" " + word + " ") != std::string_view::npos;
      html += is_keyword ? element("b", word) : escaped_text(word);
    } else {
      html += escaped_text(line.substr(i, 1));
    }
    i = end;
  }
  return html;
}

}  // namespace

std::string trimmed(const std::string& line) {
  const std::size_t first = line.find_first_not_of(' ');
  return first == std::string::npos ? ""
                                    : line.substr(first, line.find_last_not_of(' ') + 1 - first);
}

std::string highlighted_block(const std::string& code, const std::string& language,
                              const Place& place) {
  std::string html;
  std::ptrdiff_t longest = 0;
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line);) {
    const auto begins = [](char c) { return (c & 0xC0) != 0x80; };  // a character of UTF-8
    longest = std::max(longest, std::count_if(line.begin(), line.end(), begins));
    if (language == "diff" && !line.empty() && line[0] != ' ') {
      html += line[0] == '-' ? "<span class=\"removed\">" : "<span class=\"added\">";
      html += escaped_text(line) + "</span>\n";
    } else if (place.known.count(trimmed(line)) != 0) {
      html += named_by_rows(line, "<s>" + highlighted_line(line) + "</s>", place) + "\n";
    } else {
      const bool is_cpp = language == "cpp";
      html += named_by_rows(line, is_cpp ? highlighted_line(line) : escaped_text(line), place);
      html += "\n";
    }
  }
  return std::string("<div class=\"code") + (longest > columns_of_text ? " wide" : "") +
         (language == "indented" ? " indented" : "") + "\">" + place.html +
         "<pre tabindex=\"0\"><code>" + html + "</code></pre></div>\n";
}

std::string highlighted_file(const std::string& code, bool is_cpp,
                             const std::set<std::size_t>& named) {
  std::string html = highlighted_block(code, is_cpp ? "cpp" : "");
  const std::string code_begins = "<code>";
  std::size_t line = 1;
  std::size_t at = html.find(code_begins) + code_begins.size();
  for (const std::size_t next : named) {
    for (; line < next; ++line) at = html.find('\n', at) + 1;
    html.insert(html.find('\n', at), "</span>");
    html.insert(at, "<span id=\"L" + std::to_string(line) + "\">");
  }
  return "<div class=\"file\">" + html + "</div>\n";
}

}  // namespace texmap::book
