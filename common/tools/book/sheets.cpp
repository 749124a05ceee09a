#include "sheets.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "engine/files/text.hpp"
#include "markdown.hpp"

namespace texmap::book {
namespace {

template <class... Words>
std::string joined(const Words&... words) {
  std::string all;
  ((all += words), ...);
  return all;
}

/// What a sheet has at a place: a picture, or a line of text, which has no size.
struct Piece {
  std::string words;
  int left = 0, top = 0, width = 0, height = 0;
};

/// A sheet, and its golden picture in the book. Its pieces are taken in the order in which they
/// were laid.
struct Reader {
  std::string file;
  int width = 0, height = 0;
  std::vector<std::string> names;  ///< of chapter 14's exhibits
  std::vector<Piece> pieces;
  std::size_t next = 0;

  /// @param lines  behind the sheet's name
  void read(std::istringstream lines) {
    std::string line;
    std::getline(lines, line);
    std::istringstream head(line);
    head >> width >> height;
    for (std::string name; head >> name;) names.push_back(name);
    while (std::getline(lines, line) && line.rfind("sheet ", 0) != 0) {
      Piece& piece = pieces.emplace_back();
      std::istringstream words(line);
      words >> piece.words;
      const bool is_text = piece.words == "text";
      piece.words = is_text ? line.substr(5) : "";
      if (!is_text) words >> piece.left >> piece.top >> piece.width >> piece.height;
    }
  }
  [[nodiscard]] bool more() const { return next < pieces.size(); }
  [[nodiscard]] bool at_words() const { return more() && pieces[next].width == 0; }
  const Piece& take(bool words) {
    if (!more() || at_words() != words)
      throw std::runtime_error("docs/sheets.txt does not go with " + file);
    return pieces[next++];
  }
  std::string words() {
    std::string words = escaped_markup(take(true).words);
    replace_all(words, "e-", "e-\u2060");  // a joiner: no line ends within 2.0e-01
    return words;
  }

  const Piece& picture() { return take(false); }
  std::string picture(const std::string& label) { return shown(picture(), label); }

  /// A picture as a piece of the sheet's, at most twice as large. Half a pixel at each edge is
  /// left out, because enlarging would mix it with the panel beside it.
  ///
  /// @param more  further attributes
  [[nodiscard]] std::string shown(const Piece& piece, const std::string& label,
                                  const std::string& more = "") const {
    return joined(text("<svg viewBox=\"%d.5 %d.5 %d %d\" style=\"max-width: %dpx\"", piece.left,
                       piece.top, piece.width - 1, piece.height - 1, 2 * piece.width),
                  more, " role=\"img\" aria-label=\"", label, "\"><image href=\"", file,
                  text("\" width=\"%d\" height=\"%d\"/></svg>", width, height));
  }
};

std::string figure(const std::string& picture, const std::string& caption) {
  return "<figure>" + picture + "<figcaption>" + caption + "</figcaption></figure>\n";
}

std::string strong(const std::string& words) { return "<strong>" + words + "</strong>"; }

/// "name: more", with the name in strong letters.
std::string named(const std::string& words) {
  const std::size_t name = std::min(words.find(':'), words.size());
  return strong(words.substr(0, name)) + words.substr(name);
}

/// Chapter 04: four globes; what else the sheet shows of each document goes to `rest`.
std::string conventions(Reader reader, std::string& rest) {
  std::array<std::string, 4> globes;
  std::string maps, parts;
  for (std::string& globe : globes) {
    const std::string title = reader.words();
    globe = reader.picture(title);
    std::string words = reader.words();
    maps +=
        figure(reader.picture(joined(title, ", ", words)), joined(strong(title), "<br>", words));
    for (int part = 0; part < 4; ++part) {
      words = reader.words();
      parts +=
          figure(reader.picture(joined(title, ", ", words)), joined(strong(words), "<br>", title));
    }
  }
  rest = "<div class=\"sheet wide quad\">\n" + maps + "</div>\n<div class=\"sheet wide four\">\n" +
         parts + "</div>\n";
  std::string html = "<div class=\"sheet wide quad\">\n";
  for (const std::string& globe : globes) html += figure(globe, named(reader.words()));
  return html + "</div>\n";
}

/// Chapter 09: each filter's picture under its name, its reads and its error.
std::string filters(Reader reader) {
  std::string html = "<div class=\"sheet wide trio\">\n";
  while (reader.more()) {
    const std::string words = reader.words();
    html += figure(reader.picture(words), named(words));
  }
  return html + "</div>\n";
}

/// "largest texel 1.571" in two: what it is, and the number, or that there is no bound.
std::array<std::string, 2> head_and_number(const std::string& words) {
  const std::size_t at = std::min(words.find("no bound"), words.rfind(' ') + 1);
  return {words.substr(0, at - 1), words.substr(at)};
}

/// Chapter 10: a row for each layout, with its three figures as bars on common axes; then a globe.
std::string layouts(Reader reader) {
  constexpr std::array axes{2, 3, 600};
  std::string html = "<table class=\"sheet wide bars\">\n<thead><tr><th>layout</th>";
  for (std::size_t k = 0; k < axes.size(); ++k) {
    html += joined("<th>", head_and_number(reader.pieces.at(k + 1).words)[0],
                   text(", 0 to %d</th>", axes[k]));
  }
  html += "</tr></thead>\n<tbody>\n";
  while (reader.pieces.size() - reader.next > 4) {
    const std::string name = reader.words();
    std::string bars;
    for (const int axis : axes) {
      const auto [head, number] = head_and_number(reader.words());
      const bool is_open = number == "no bound";
      bars += joined(
          "<td data-head=\"", head, "\">", number,
          text("<svg viewBox=\"0 0 100 1\" preserveAspectRatio=\"none\" "
               "aria-hidden=\"true\"><rect width=\"100\" height=\"1\"/>"
               "<rect width=\"%.1f\" height=\"1\" class=\"%s\"/></svg></td>\n",
               is_open ? 100 : 100 * std::atof(number.c_str()) / axis, is_open ? "open" : "bar"));
    }
    const std::string map = reader.picture("the Earth in the layout " + name);
    html += joined("<tr><td><span>", name, "</span><div class=\"two\">", map,
                   reader.picture("equal circles in the layout " + name), "</div></td>\n", bars,
                   "</tr>\n");
  }
  std::string caption = reader.words();
  while (reader.at_words()) caption += "; " + reader.words();
  return html + "</tbody></table>\n<div class=\"sheet wide\">" +
         figure(reader.picture(caption), caption) + "</div>\n";
}

/// Chapter 13: what each way changes, and what the colors mean.
std::string ways(Reader reader) {
  std::string html = "<div class=\"sheet wide four\">\n";
  const std::size_t panels = 16;
  for (std::size_t i = 0; i < panels; ++i) {
    const Piece& picture = reader.picture();
    const std::string name = reader.words();
    std::string caption = strong(name);
    while (reader.at_words() && reader.pieces[reader.next].words.rfind("Differences", 0) != 0)
      caption += "<br>" + reader.words();
    html += figure(reader.shown(picture, name), caption);
  }
  html += "</div>\n<p class=\"legend wide\">" + reader.words();
  while (reader.more()) {
    const std::string color = reader.shown(reader.picture(), "", " width=\"22\" height=\"14\"");
    html += " <span>" + color + " " + reader.words() + "</span>";
  }
  return html + "</p>\n";
}

/// Chapter 14: each exhibit as a pair of pictures, in float; a click shows the pair in double.
std::map<std::string, std::string> pairs_of(Reader reader) {
  std::map<std::string, std::string> all;
  for (const std::string& name : reader.names) {
    const std::string what = reader.words();
    std::string pictures, words;
    for (int variant = 0; variant < 4; ++variant) {
      const char* const number = variant < 2 ? "in-float" : "in-double";
      const Piece& picture = reader.picture();
      const std::string by = reader.words();
      words += joined("<span class=\"", number, "\">", by, "<br>", reader.words(), "</span>");
      pictures += reader.shown(picture, joined(name, ", ", by), joined(" class=\"", number, "\""));
    }
    all[name] = joined("<figure><label class=\"two\"><input type=\"checkbox\" aria-label=\"", name,
                       " in double\">", pictures, words,
                       "<span class=\"swap\" aria-hidden=\"true\"></span></label><figcaption>",
                       strong(name), " ", what);
  }
  return all;
}

/// All that stands between two texts.
std::vector<std::string> all_between(const std::string& in, const std::string& before,
                                     const std::string& after) {
  std::vector<std::string> all;
  for (std::size_t at = in.find(before); at != std::string::npos; at = in.find(before, at)) {
    at += before.size();
    all.push_back(in.substr(at, in.find(after, at) - at));
  }
  return all;
}

/// Chapter 14's page: the four pairs that show most in place of the sheet, and all of them in place
/// of the table, which has their causes.
std::string exhibits(const Reader& reader, std::string page, const std::string& picture) {
  const std::map<std::string, std::string> pairs = pairs_of(reader);
  const std::string before = "<div class=\"scroll\" tabindex=\"0\">";
  const std::size_t at = page.find(before + "<table>\n<thead>\n<tr>\n<th>exhibit");
  if (at == std::string::npos) throw std::runtime_error("chapter 14's page has no exhibits");
  const std::string after = "</table></div>";
  const std::string table = page.substr(at, page.find(after, at) + after.size() - at);
  const std::vector<std::string> heads = all_between(table, "<th>", "</th>");
  std::string all, list;
  std::map<std::string, std::string> causes;
  for (const std::string& row : all_between(table, "<tr>\n<td>", "</tr>")) {
    const std::vector<std::string> cells = all_between("<td>" + row, "<td>", "</td>");
    std::string said;
    for (std::size_t k = 1; k < heads.size(); ++k)
      said += "<p><span>" + heads[k] + "</span> " + cells.at(k) + "</p>";
    for (const std::string& name : all_between(cells[0], "<code>", "</code>")) {
      causes[name] = cells.at(2);
      list += joined("<a href=\"#exhibit-", name, "\">", name, "</a>\n");
      all += joined("<article id=\"exhibit-", name, "\">", pairs.at(name),
                    "</figcaption></figure><div>", said, "</div></article>\n");
      said.clear();  // once for all exhibits of a row
    }
  }
  replace_all(page, table,
              joined("<div class=\"sheet wide exhibits\">\n<nav class=\"names\" "
                     "aria-label=\"Exhibits\">\n",
                     list, "</nav>\n", all, "</div>"));
  std::string four = "<p>Four of the exhibits:</p>\n<div class=\"sheet wide pairs\">\n";
  for (const char* const name : {"from-1e5", "pole", "needle", "small"})
    four += pairs.at(name) + ": " + causes[name] + "</figcaption></figure>\n";
  replace_all(page, picture, four + "</div>");
  return page;
}

}  // namespace

std::string with_sheet(const std::string& list, const std::string& chapter, std::string page) {
  const std::string head = "sheet " + chapter + " ";
  const std::size_t begin = list.find(head);
  Reader reader;
  reader.file = "pictures/tests-golden-" + chapter + ".png";
  const std::size_t image = page.find("<img loading=\"lazy\" src=\"" + reader.file);
  if (begin == std::string::npos || image == std::string::npos) return page;
  reader.read(std::istringstream(list.substr(begin + head.size())));
  const std::size_t at = page.rfind("<p", image);
  const std::string picture = page.substr(at, page.find("</p>", image) + 4 - at);
  const std::string number = chapter.substr(0, 2);
  if (number == "14") return exhibits(reader, page, picture);
  std::string rest;
  page.replace(at, picture.size(),
               number == "04"   ? conventions(reader, rest)
               : number == "09" ? filters(reader)
               : number == "10" ? layouts(reader)
                                : ways(reader));
  const std::string look = "<h2 id=\"look-for\">Look for</h2>\n";
  const std::size_t below = page.find(look);
  if (below != std::string::npos) page.insert(below + look.size(), rest);
  return page;
}

}  // namespace texmap::book
