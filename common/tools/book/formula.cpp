#include "formula.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string_view>
#include <vector>

#include "engine/files/text.hpp"
#include "engine/files/utf8.hpp"
#include "markdown.hpp"

namespace texmap::book {
namespace {

constexpr std::u32string_view signs = U"+-±×·=≤≥<>→,∫∇…/";
constexpr std::u32string_view raised = U"⁰¹²³⁴⁵⁶⁷⁸⁹";
constexpr std::u32string_view lowered = U"₀₁₂₃₄₅₆₇₈₉";

bool is_in(std::u32string_view set, char32_t c) {
  return c != 0 && set.find(c) != std::u32string_view::npos;
}
bool is_digit(char32_t c) { return c >= U'0' && c <= U'9'; }
bool is_latin(char32_t c) { return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z'); }

std::string utf8(std::u32string_view characters) {
  std::string text;
  for (const char32_t c : characters) append_utf8(text, c);
  return text;
}

std::string element(const std::string& name, const std::string& inside) {
  return "<" + name + ">" + inside + "</" + name + ">";
}

/// A piece of a row.
struct Item {
  std::string base{};    ///< MathML
  std::string inside{};  ///< of a group: without its parentheses
  std::string sub{}, sup{};
  char32_t sign = 0;   ///< of an operator
  std::string word{};  ///< of a name of two letters and more
  bool after_blank = false;

  [[nodiscard]] std::string html() const {
    if (!sub.empty() && !sup.empty()) return element("msubsup", base + sub + sup);
    if (!sub.empty()) return element("msub", base + sub);
    return sup.empty() ? base : element("msup", base + sup);
  }
  /// As a part of a fraction, under a root or raised, where parentheses are not needed.
  [[nodiscard]] std::string bare() const {
    return inside.empty() || !sup.empty() ? html() : element("mrow", inside);
  }
};
using Row = std::vector<Item>;

/// A sign that ends what a fraction with blanks takes.
bool ends_run(const Row& row, std::size_t i) {
  const bool is_spaced =
      (i == 0 || row[i].after_blank) && i + 1 < row.size() && row[i + 1].after_blank;
  return row[i].sign == U',' || row[i].sign == U'∫' || (row[i].sign != 0 && is_spaced);
}

std::string html_of(const Row& row);

/// Replaces fractions by items: those without blanks, or then the others.
void join_fractions(Row& row, bool with_blanks) {
  for (std::size_t i = 1; i + 1 < row.size(); ++i) {
    if (row[i].sign != U'/' || row[i].after_blank != with_blanks) continue;
    // What stands between two pieces ends a fraction: a sign, or else a blank.
    const auto ends = [&row, with_blanks](std::size_t sign, std::size_t blank) {
      return with_blanks ? ends_run(row, sign) : row[blank].after_blank || row[sign].sign != 0;
    };
    std::size_t first = i - 1;
    std::size_t last = i + 1;
    while (first > 0 && !ends(first - 1, first)) --first;
    while (last + 1 < row.size() && !ends(last + 1, last + 1)) ++last;
    const auto part = [&row](std::size_t from, std::size_t to) {
      if (from == to) return row[from].bare();
      return element("mrow", html_of({row.begin() + std::ptrdiff_t(from),
                                      row.begin() + std::ptrdiff_t(to) + 1}));
    };
    row[first] = {.base = element("mfrac", part(first, i - 1) + part(i + 1, last)),
                  .after_blank = row[first].after_blank};
    row.erase(row.begin() + std::ptrdiff_t(first) + 1, row.begin() + std::ptrdiff_t(last) + 1);
    i = first;
  }
}

/// Replaces words in a row, `light along a ray`, by one item.
void join_prose(Row& row) {
  const auto is_word = [&row](std::size_t i) {
    const bool is_call = i + 1 < row.size() && !row[i + 1].after_blank && row[i + 1].sign == 0;
    return i < row.size() && !row[i].word.empty() && row[i].base == row[i].html() && !is_call &&
           row[i].word.find_first_of("._0123456789") == std::string::npos;
  };
  for (std::size_t first = 0; first < row.size(); ++first) {
    std::string words = row[first].word;
    std::size_t end = first + 1;
    for (; is_word(first) && end < row.size() && row[end].after_blank; ++end) {
      const bool is_article = row[end].base == "<mi>a</mi>" && is_word(end + 1);
      if (!is_article && !is_word(end)) break;
      words.append(" ").append(is_article ? "a" : row[end].word);
    }
    if (end < first + 2) continue;
    row[first].base = element("mtext", words);
    row.erase(row.begin() + std::ptrdiff_t(first) + 1, row.begin() + std::ptrdiff_t(end));
  }
}

std::string html_of(const Row& row) {
  std::string html;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const Item& item = row[i];
    const bool follows_sign = i == 0 || row[i - 1].sign != 0;
    if (item.sign == 0) {
      const bool has_name = !follows_sign && !(item.word + row[i - 1].word).empty();
      html += (has_name && item.after_blank ? "<mspace width=\".22em\"/>" : "") + item.html();
      continue;
    }
    // A sign at the begin or the end of a cell has the space of a sign between two things, too.
    const bool is_tight = item.sign == U'·' && !item.after_blank;
    const bool is_before = (item.sign == U'-' && follows_sign) || is_in(U"∫∇", item.sign);
    html += is_before  ? "<mo form=\"prefix\">"
            : is_tight ? "<mo lspace=\".08em\" rspace=\".08em\">"
                       : "<mo form=\"infix\">";
    html += (item.sign == U'-' ? "−" : escaped_markup(utf8({&item.sign, 1}))) + "</mo>";
  }
  return html;
}

/// Reads a cell: a formula without columns.
class Reader {
 public:
  explicit Reader(std::u32string_view rest) : rest_(rest) {}

  /// Nothing if a rule does not understand it.
  std::optional<std::string> read() {
    std::string html = html_of(row(0));
    return is_understood_ ? std::optional(html) : std::nullopt;
  }

 private:
  [[nodiscard]] char32_t at(std::size_t i) const { return i < rest_.size() ? rest_[i] : 0; }
  std::u32string_view take(std::size_t count) {
    const std::u32string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(taken.size());
    return taken;
  }
  void fail() {
    is_understood_ = false;
    rest_ = {};
  }

  /// Items up to the sign that closes a group, or to the end.
  Row row(char32_t close) {
    Row row;
    for (bool after_blank = false; !rest_.empty() && at(0) != close;) {
      if (at(0) == U' ') {
        take(1);
        after_blank = true;
        continue;
      }
      if (!row.empty() && row.back().sign == 0 && modify(row.back())) continue;
      if (at(0) == U'.' && at(1) == U'.' && at(2) == U'.') {
        take(3);
        row.push_back({.base = "<mo>…</mo>", .after_blank = after_blank});
      } else if (is_in(signs, at(0))) {
        const bool is_second = !row.empty() && row.back().sign != 0 && !after_blank;
        const bool may_follow = row.empty() || row.back().sign == U'-' || is_in(U"-∇", at(0));
        if (is_second && (!may_follow || row.back().sign == at(0))) fail();
        if (!rest_.empty()) row.push_back({.sign = take(1)[0], .after_blank = after_blank});
      } else {
        row.push_back(atom());
        row.back().after_blank = after_blank;
      }
      after_blank = false;
    }
    if (close != 0) at(0) == close ? void(take(1)) : fail();
    join_prose(row);
    join_fractions(row, false);
    join_fractions(row, true);
    if (row.empty() || (close != 0 && row.back().sign != 0)) fail();
    return row;
  }

  /// Takes a power, an index, a prime or a degree sign.
  bool modify(Item& item) {
    if (is_in(raised, at(0)) || is_in(lowered, at(0))) {
      const std::u32string_view digits = is_in(raised, at(0)) ? raised : lowered;
      std::u32string number;
      for (; is_in(digits, at(0)); take(1)) number += U'0' + char32_t(digits.find(at(0)));
      (digits == raised ? item.sup : item.sub) = element("mn", utf8(number));
    } else if (at(0) == U'^' || at(0) == U'_') {
      std::string& place = take(1)[0] == U'^' ? item.sup : item.sub;
      place = atom().bare();
    } else if (at(0) == U'\'' || at(0) == U'°') {
      const std::string sign = take(1)[0] == U'°' ? "°" : "′";
      item.base = element("mrow", item.base + "<mo lspace=\"0\" rspace=\"0\">" + sign + "</mo>");
    } else {
      return false;
    }
    return true;
  }

  Item atom() {
    std::size_t end = 1;
    if (at(0) == U'(' || at(0) == U'|') {
      const char32_t close = take(1)[0] == U'(' ? U')' : U'|';
      const std::string inside = html_of(row(close));
      const bool is_tall = inside.find("<mfrac") + 1 != 0 || inside.find("<msqrt") + 1 != 0;
      const std::string mark = is_tall ? "<mo>" : "<mo stretchy=\"false\">";
      const std::string group = mark + (close == U')' ? "(" : "|") + "</mo>" + inside + mark +
                                utf8({&close, 1}) + "</mo>";
      return {.base = element("mrow", group), .inside = close == U')' ? inside : ""};
    }
    if (at(0) == U'√') {
      take(1);
      return {.base = element("msqrt", atom().bare())};
    }
    if (is_digit(at(0))) {
      while (is_digit(at(end)) || (at(end) == U'.' && is_digit(at(end + 1)))) ++end;
      return {.base = element("mn", utf8(take(end)))};
    }
    if (at(0) >= U'α' && at(0) <= U'ω') return {.base = element("mi", utf8(take(1)))};
    if (!is_latin(at(0))) return fail(), Item{};
    while (is_latin(at(end)) || is_digit(at(end)) || (at(end) == U'.' && is_latin(at(end + 1))))
      ++end;
    if (end > 1 && at(end) == U'_' && is_latin(at(end + 1)) && is_latin(at(end + 2)))
      for (++end; is_latin(at(end));) ++end;  // polar_angle: no index
    const std::string name = utf8(take(end));
    return {.base = element("mi", name), .word = end > 1 ? name : ""};
  }

  std::u32string_view rest_;
  bool is_understood_ = true;
};

/// What a formula has and a command has not.
bool has_formula(const std::string& block) {
  for (const char* sign : {" = ", " - ", " + ", "(", "·", "→", "²"})
    if (block.find(sign) != std::string::npos) return true;
  return false;
}

}  // namespace

std::optional<std::string> html_of_formulas(const std::string& block) {
  if (!has_formula(block)) return std::nullopt;
  if (block.find("→") != std::string::npos && block.find_first_of("=+-") == std::string::npos) {
    std::string way = block;  // words, which may wrap
    replace_all(way, "  ", " ");
    return "<p class=\"flow\">" + way + "</p>\n";
  }
  if (const std::size_t gap = block.find("\n\n"); gap != std::string::npos) {
    const std::optional<std::string> first = html_of_formulas(block.substr(0, gap + 1));
    const std::optional<std::string> rest = html_of_formulas(block.substr(gap + 2));
    return first && rest ? std::optional(*first + *rest) : std::nullopt;
  }
  std::vector<std::u32string> lines(1);
  for (std::string_view rest = std::string_view(block).substr(0, block.size() - 1);
       !rest.empty();) {
    const char32_t c = take_character(rest);
    c == U'\n' ? void(lines.emplace_back()) : lines.back().push_back(c);
  }
  // A column begins after two blanks, but not after a sign; in the other lines, too, if there is a
  // blank.
  std::set<std::size_t> columns{std::u32string::npos};
  for (const std::u32string& line : lines) {
    for (std::size_t i = line.find(U"  "); i < line.size(); i = line.find(U"  ", i)) {
      const bool follows_sign = i > 0 && line[i - 1] != U',' && is_in(signs, line[i - 1]);
      i = std::min(line.find_first_not_of(U' ', i), line.size());
      if (!follows_sign) columns.insert(i);
    }
  }
  std::string rows;
  for (const std::u32string& line : lines) {
    std::string cells;
    std::size_t first = 0;
    std::size_t span = 1;
    for (const std::size_t column : columns) {
      const std::size_t end = std::min(column, line.size());
      if (end < line.size() && line[end - 1] != U' ' && ++span > 0)
        continue;  // the next column is within a word
      std::u32string_view cell = std::u32string_view(line).substr(first, end - first);
      cell = cell.substr(0, cell.find_last_not_of(U' ') + 1);  // without the blanks at its end
      const bool is_wide = end - first > cell.size() + 2 && !cell.empty();
      const std::optional<std::string> html = cell.empty() ? "" : Reader(cell).read();
      if (!html) return std::nullopt;
      cells += "<mtd" + (span > 1 ? text(" columnspan=\"%zu\"", span) : "") + "><mrow>" + *html +
               (is_wide ? "<mspace width=\"1.2em\"/>" : "") + "</mrow></mtd>";
      first = end;
      span = 1;
    }
    rows += element("mtr", cells);
  }
  if (lines.size() == 1)  // formulas of their own: a narrow screen sets each in a line
    replace_all(rows, "</mtd><mtd>", "</mtd></mtr></mtable></math> <math><mtable><mtr><mtd>");
  return "<div class=\"formula\"><math><mtable>" + rows + "</mtable></math></div>\n";
}

}  // namespace texmap::book
