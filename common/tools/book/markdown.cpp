#include "markdown.hpp"

#include <cmark-gfm-core-extensions.h>
#include <cmark-gfm.h>

#include <cctype>
#include <cstdlib>
#include <map>
#include <memory>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "engine/files/text.hpp"
#include "formula.hpp"

namespace texmap::book {
namespace {

struct Free {
  void operator()(cmark_node* node) const { cmark_node_free(node); }
  void operator()(cmark_parser* parser) const { cmark_parser_free(parser); }
  void operator()(cmark_iter* iter) const { cmark_iter_free(iter); }
  void operator()(char* text) const { std::free(text); }
};
template <class T>
using Owned = std::unique_ptr<T, Free>;

constexpr int options = CMARK_OPT_UNSAFE;  // the pages are ours, and fold answers by HTML

std::string text_or_empty(const char* text) { return text == nullptr ? "" : text; }

Owned<cmark_node> parsed(const std::string& markdown) {
  cmark_gfm_core_extensions_ensure_registered();
  const Owned<cmark_parser> parser(cmark_parser_new(options));
  for (const char* name : {"table", "autolink", "strikethrough"}) {
    cmark_syntax_extension* extension = cmark_find_syntax_extension(name);
    if (extension == nullptr) throw std::runtime_error(std::string("cmark-gfm lacks ") + name);
    cmark_parser_attach_syntax_extension(parser.get(), extension);
  }
  cmark_parser_feed(parser.get(), markdown.data(), markdown.size());
  return Owned<cmark_node>(cmark_parser_finish(parser.get()));
}

/// All words of a node, without markup and without comments.
std::string words_of(cmark_node* node) {
  std::string words;
  const Owned<cmark_iter> iter(cmark_iter_new(node));
  while (cmark_iter_next(iter.get()) != CMARK_EVENT_DONE) {
    cmark_node* here = cmark_iter_get_node(iter.get());
    const cmark_node_type type = cmark_node_get_type(here);
    if (type == CMARK_NODE_TEXT || type == CMARK_NODE_CODE)
      words += text_or_empty(cmark_node_get_literal(here));
    if (type == CMARK_NODE_SOFTBREAK || type == CMARK_NODE_LINEBREAK) words += ' ';
  }
  return words;
}

/// The name that GitHub gives a heading: letters and digits in lower case, blanks as hyphens.
std::string slug(const std::string& title) {
  std::string name;
  for (const char c : title) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ' || c == '-') {
      name += '-';
    } else if (byte >= 128 ? byte != 0xC2 && byte != 0xB7 : std::isalnum(byte) != 0 || c == '_') {
      name += static_cast<char>(byte < 128 ? std::tolower(byte) : byte);
    }
  }
  return name;
}

void replace_by_html(cmark_node* node, const std::string& html,
                     cmark_node_type type = CMARK_NODE_HTML_BLOCK) {
  cmark_node* block = cmark_node_new(type);
  cmark_node_set_literal(block, html.c_str());
  if (cmark_node_replace(node, block) == 0) {
    cmark_node_free(block);
    throw std::runtime_error("cmark-gfm does not replace a node");
  }
  cmark_node_free(node);
}

/// HTML as a formula sets it: a minus sign for a hyphen, and x_a and 2^k with their letters lowered
/// and raised. No line ends within a point, a color or a pair, nor around a times sign.
std::string with_signs(std::string text) {
  static const std::regex comma(R"((\([^() ]{1,24}), )");  // one of two commas, then the other
  static const std::regex minus(R"((^|[ (^,|=/·±])-(?=[^ -]|$))"), times(R"((\d) × (?=\d))");
  static const std::regex low(R"((^|[^\w.])(?:([A-Za-z])_([a-z]+)|([a-z]+)_([a-z]))(?![\w(]))");
  static const std::regex high(R"(\^(\(([^()]+)\)|((?:−)?\w+(?:\.\d+)?)))");
  text = std::regex_replace(std::regex_replace(text, minus, "$1−"), times, "$1\u00a0×\u00a0");
  text = std::regex_replace(std::regex_replace(text, comma, "$1,\u00a0"), comma, "$1,\u00a0");
  replace_all(text, " - ", " − ");
  return std::regex_replace(std::regex_replace(text, low, "$1$2$4<sub>$3$5</sub>"), high,
                            "<sup>$2$3</sup>");
}

/// A heading with its name, and its place among the sections.
void convert_heading(cmark_node* node, std::map<std::string, int>& taken, Converted& page) {
  const std::string title = words_of(node);
  const int level = cmark_node_get_heading_level(node);
  std::string id = slug(title);
  const int before = taken[id]++;
  if (before > 0) id += text("-%d", before);
  const Owned<char> plain(cmark_render_html(node, options, nullptr));
  std::string html = with_signs(plain.get());
  html.insert(html.find('>'), " id=\"" + id + "\"");
  page.sections.push_back({level, id, title, ""});
  replace_by_html(node, html);
}

/// What a comment is about: the next block that is no comment.
cmark_node* block_after(cmark_node* comment) {
  cmark_node* next = cmark_node_next(comment);
  while (next != nullptr && cmark_node_get_type(next) == CMARK_NODE_HTML_BLOCK &&
         text_or_empty(cmark_node_get_literal(next)).rfind("<!--", 0) == 0)
    next = cmark_node_next(next);
  return next;
}

/// Names of rows, and a piece of the lines of each: <!-- rows: u @ Real u = | v @ Real v = -->.
std::vector<std::pair<std::string, std::string>> rows_in(const std::string& mark) {
  static const std::regex row(R"((?:rows:|\|) (.+?) @ (.+?)(?= \| | -->))");
  std::vector<std::pair<std::string, std::string>> rows;
  for (std::sregex_iterator at(mark.begin(), mark.end(), row), end; at != end; ++at)
    rows.emplace_back((*at)[1], (*at)[2]);
  return rows;
}

/// Gives the first line of each row an id, which links lead to.
void name_lines(std::string& html, Converted& page) {
  const std::string names_begin = "<span data-row=\"";
  for (std::size_t at = html.find(names_begin); at != std::string::npos;
       at = html.find(names_begin, at + 1)) {
    const std::size_t first = at + names_begin.size();
    std::istringstream names(html.substr(first, html.find('"', first) - first));
    const std::string id = "row-" + std::to_string(page.rows.size() + 1);
    bool is_first = false;
    for (std::string name; std::getline(names, name, '|');)
      is_first = page.rows.emplace(name, id).second || is_first;
    if (is_first) html.insert(at + 5, " id=\"" + id + "\"");
  }
}

}  // namespace

void replace_all(std::string& in, const std::string& what, const std::string& by) {
  for (std::size_t at = in.find(what); at != std::string::npos; at = in.find(what, at + by.size()))
    in.replace(at, what.size(), by);
}

std::string with_resolved(std::string html, const Resolve& resolve) {
  for (const std::string name : {"src=\"", "href=\""}) {
    for (std::size_t at = html.find(name); at != std::string::npos; at = html.find(name, at)) {
      at += name.size();
      const std::size_t end = html.find('"', at);
      if (end == std::string::npos) break;
      html.replace(at, end - at, resolve(html.substr(at, end - at)));
    }
  }
  return html;
}

Converted html_of_markdown(const std::string& markdown, const Resolve& resolve,
                           const Locate& locate) {
  // Without the marks of figures, which part texts; a picture's title is how high its letters are.
  static const std::regex figures("<!-- (figure: \\S+|end) -->"),
      letters(R"(\)<!-- letters: (\d+) px -->)");
  const Owned<cmark_node> root = parsed(
      std::regex_replace(std::regex_replace(markdown, figures, ""), letters, " \"letters $1\")"));
  cmark_consolidate_text_nodes(root.get());
  Converted page;
  std::map<std::string, int> taken;

  // Addresses first: headings are rendered with the links in them.
  std::vector<cmark_node*> nodes;
  const Owned<cmark_iter> iter(cmark_iter_new(root.get()));
  for (cmark_event_type event; (event = cmark_iter_next(iter.get())) != CMARK_EVENT_DONE;) {
    if (event == CMARK_EVENT_ENTER) nodes.push_back(cmark_iter_get_node(iter.get()));
  }
  std::vector<cmark_node*> blocks, texts;
  std::map<cmark_node*, std::string> marks, rows;  // of the blocks after them
  for (cmark_node* node : nodes) {
    const cmark_node_type type = cmark_node_get_type(node);
    if (type == CMARK_NODE_LINK || type == CMARK_NODE_IMAGE) {
      const std::string url = resolve(text_or_empty(cmark_node_get_url(node)));
      if (url.empty()) {  // its words stay
        while (cmark_node* const word = cmark_node_first_child(node))
          cmark_node_insert_before(node, word);
        cmark_node_free(node);
      } else {
        cmark_node_set_url(node, url.c_str());
      }
    } else if (type == CMARK_NODE_HTML_BLOCK || type == CMARK_NODE_HTML_INLINE) {
      const std::string html = text_or_empty(cmark_node_get_literal(node));
      const bool is_comment = html.rfind("<!--", 0) == 0;
      if (html.rfind("<!-- code: ", 0) == 0) marks[block_after(node)] = html;
      if (html.rfind("<!-- rows: ", 0) == 0) rows[block_after(node)] = html;
      cmark_node_set_literal(node, is_comment ? "" : with_resolved(html, resolve).c_str());
    } else if (const auto in = cmark_node_get_type(cmark_node_parent(node));
               type == CMARK_NODE_TEXT && in != CMARK_NODE_HEADING && in != CMARK_NODE_IMAGE) {
      texts.push_back(node);
    } else if (type == CMARK_NODE_HEADING || type == CMARK_NODE_CODE_BLOCK ||
               type == CMARK_NODE_PARAGRAPH) {
      blocks.push_back(node);
    }
  }
  for (cmark_node* node : blocks) {
    const cmark_node_type type = cmark_node_get_type(node);
    if (type == CMARK_NODE_HEADING) {
      convert_heading(node, taken, page);
    } else if (type == CMARK_NODE_CODE_BLOCK) {
      const std::string code = text_or_empty(cmark_node_get_literal(node));
      int length = 0;
      int offset = 0;
      char fence = 0;
      const bool is_indented = cmark_node_get_fenced(node, &length, &offset, &fence) == 0;
      const std::optional<std::string> formulas =
          is_indented ? html_of_formulas(code) : std::nullopt;
      const std::string language =
          is_indented ? "indented" : text_or_empty(cmark_node_get_fence_info(node));
      const auto mark = marks.find(node);
      Place place = mark == marks.end() ? Place{} : locate(mark->second, code);
      place.rows = rows_in(rows[node]);
      for (const auto& [name, piece] : place.rows) {
        if (code.find(piece) == std::string::npos) {
          page.faults.push_back(
              text("no line for the row '%s' has '%s'", name.c_str(), piece.c_str()));
        }
      }
      std::string html = formulas ? *formulas : highlighted_block(code, language, place);
      name_lines(html, page);
      replace_by_html(node, html);
    } else if (!page.sections.empty()) {
      page.sections.back().words += words_of(node) + " ";
    }
  }

  // Texts last: a search finds them as they are written.
  for (cmark_node* node : texts) {
    const std::string text = escaped_markup(cmark_node_get_literal(node));
    replace_by_html(node, with_signs(text), CMARK_NODE_HTML_INLINE);
  }
  const Owned<char> html(cmark_render_html(root.get(), options, nullptr));
  page.html = html.get();
  replace_all(page.html, "<table>", "<div class=\"scroll\" tabindex=\"0\"><table>");
  replace_all(page.html, "</table>", "</table></div>");
  replace_all(page.html, " title=\"letters ", " data-letters=\"");
  replace_all(page.html, "<img ", "<img loading=\"lazy\" ");
  return page;
}

}  // namespace texmap::book
