// Makes the book, every page of the course as HTML with contents, search, pictures and sources:
// out/index.html and the pages that it leads to. Its pages have copies of the golden pictures,
// because the reader may draw out/NN_name.png again, changed.
// usage: book ROOT OUT [--print]
//        --print: also OUT/print.html, the pages of students and instructors in one, for paper
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "engine/files/json.hpp"
#include "engine/files/load_image.hpp"
#include "engine/files/save_png.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"
#include "highlight.hpp"
#include "markdown.hpp"
#include "microscope.hpp"
#include "sheets.hpp"
#include "tools/diagnose/cards.hpp"
#include "tools/diagnose/page_slips.hpp"
#include "tools/diagnose/wrong_program.hpp"
#include "tools/page/page.hpp"

namespace texmap::book {
namespace {

namespace fs = std::filesystem;

std::string contents_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path.generic_string());
  return {std::istreambuf_iterator<char>(file), {}};
}

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + path.generic_string());
}

void replace_first(std::string& in, const std::string& what, const std::string& by) {
  const std::size_t at = in.find(what);
  if (at != std::string::npos) in.replace(at, what.size(), by);
}

/// What stands between two texts, or nothing if there are no such texts.
std::string between(const std::string& in, const std::string& before, const std::string& after) {
  const std::size_t at = in.find(before);
  const std::size_t end = at == std::string::npos ? at : in.find(after, at + before.size());
  return end == std::string::npos ? "" : in.substr(at + before.size(), end - at - before.size());
}

/// Cards in place of each table that begins with `your picture`: that picture, then how it is drawn
/// right if the row has that too, then the reader's words, the cause, the change and the chapter.
/// A card is named by its picture.
std::string with_cards(const std::string& html) {
  const std::string table =
      "<div class=\"scroll\" tabindex=\"0\"><table>\n<thead>\n<tr>\n<th>your picture";
  const std::size_t at = html.find(table);
  const std::size_t end = html.find("</table></div>", at);
  if (at == std::string::npos || end == std::string::npos) return html;
  std::string cards = "<div class=\"cards wide\">\n";
  for (std::size_t row = html.find("<tr>\n<td>", at); row < end;
       row = html.find("<tr>\n<td>", row + 1)) {
    std::string card = html.substr(row + 5, html.find("</tr>", row) - row - 5);
    const std::size_t words = card.rfind("/>", card.find("</td>")) + 3;
    const bool has_right = card.find("<img", 9) < words;  // the first is at 4
    card.insert(words, std::string("<span>yours</span>") + (has_right ? "<span>right</span>" : "") +
                           "</div><h3>… ");
    const std::string file = between(card, "src=\"", ".png\"");
    replace_first(card, "<td>",
                  "<article id=\"" + file.substr(file.rfind('-') + 1) + "\"><div class=\"two\">");
    replace_first(card, "</td>", "</h3>");
    replace_all(card, "<td>", "<p>");
    replace_all(card, "</td>", "</p>");
    cards += card + "</article>\n";
  }
  return html.substr(0, at) + cards + with_cards(html.substr(end + 8));
}

/// A page of the book, made from a page of Markdown.
struct Page {
  std::string source;   ///< from the root: chapters/03_image_texture/README.md
  std::string file;     ///< in the book: 03_image_texture.html
  std::string chapter;  ///< its folder's name, if it is a chapter's
  Converted converted{};

  [[nodiscard]] const std::string& title() const { return converted.sections.front().title; }
};

/// The lines of a text, without blanks around each.
std::vector<std::string> lines_of(const std::string& whole) {
  std::vector<std::string> lines;
  std::istringstream rest(whole);
  for (std::string line; std::getline(rest, line);) lines.push_back(trimmed(line));
  return lines;
}

/// Where lines stand in a source, counted from 1: the first place that does not end before the
/// first line with a name. Marks of exercises are left out, as pages leave them out. 0: nowhere.
std::size_t line_of(const std::vector<std::string>& source, const std::vector<std::string>& piece,
                    const std::string& name) {
  std::size_t named = 0;
  while (named < source.size() && source[named].find(name) == std::string::npos) ++named;
  for (std::size_t start = 0; start < source.size(); ++start) {
    std::size_t same = 0;
    std::size_t end = start;
    for (; end < source.size() && same < piece.size(); ++end) {
      if (source[end].rfind("// solution", 0) == 0 || source[end].rfind("// start: ", 0) == 0)
        continue;
      if (source[end] != piece[same]) break;
      ++same;
    }
    if (same == piece.size() && source[start] == piece[0] && end > named) return start + 1;
  }
  return 0;
}

/// Pages under one heading of the contents.
struct Part {
  std::string title;
  std::vector<std::size_t> pages;  ///< indices
};

constexpr std::array readers_pages{"docs/symptoms.md",    "docs/how_to_change_things.md",
                                   "docs/commands.md",    "docs/glossary.md",
                                   "docs/conventions.md", "docs/sources.md",
                                   "docs/install.md"};
constexpr std::array instructors_pages{"docs/teaching.md", "docs/grading.md"};
constexpr std::array engineers_pages{
    "README.md",         "docs/architecture.md", "common/README.md", "docs/numbers.md",
    "docs/numerics.md",  "docs/measurements.md", "assets/README.md", "docs/known_faults.md",
    "docs/platforms.md", "docs/packages.md",     "CONTRIBUTING.md",  "CHANGELOG.md"};

/// chapters/03_image_texture/README.md -> 03_image_texture, docs/numbers.md -> numbers.
std::string name_of(const fs::path& source) {
  if (source.filename() != "README.md") return source.stem().string();
  return source.has_parent_path() ? source.parent_path().filename().string() : "about";
}

class Book {
 public:
  Book(fs::path root, fs::path out, bool with_print)
      : root_(std::move(root)), out_(std::move(out)), with_print_(with_print) {}

  /// Errors: std::runtime_error if a page cannot be read or written.
  void make() {
    live_ = fs::exists(root_ / "docs/live/modules.js");
    find_pages();
    const fs::path sheets = root_ / "docs/sheets.txt";
    const std::string list = fs::exists(sheets) ? contents_of(sheets) : "";
    for (Page& page : pages_) {
      page.converted = html_of_markdown(
          contents_of(root_ / page.source),
          [&](const std::string& url) { return resolved(page.source, url); },
          [&](const std::string& mark, const std::string& code) {
            return located(page.source, mark, code);
          });
      for (const std::string& one : page.converted.faults) fault(page.source + ": " + one);
      if (page.converted.sections.empty())
        throw std::runtime_error(page.source + " does not begin with a title");
      const fs::path measured = out_ / (page.chapter + ".json");
      page.converted.html = with_sheet(list, page.chapter, page.converted.html);
      if (fs::exists(measured)) {  // for page_13.js
        page.converted.html += "<script type=\"application/json\" id=\"measured\">" +
                               contents_of(measured) + "</script>\n";
      }
    }
    check_names();
    for (std::size_t i = 0; i < pages_.size(); ++i) write_page(i);
    write_sources();
    write_index();
    write_live();
    fs::remove(out_ / "print.html");
    if (with_print_) write_print();
    for (const char* const copied : {"book.css", "sheets.css", "cover.js", "favicon.svg"})
      write(out_ / copied, contents_of(folder() / copied));
    write(out_ / "sizes.css", sizes_);
    write(out_ / "source.css", "@import \"book.css\";\n" + line_numbers());
    write(out_ / "book.js", search_index() + contents_of(folder() / "book.js"));
  }

  /// Links and pictures that lead nowhere.
  [[nodiscard]] const std::vector<std::string>& faults() const { return faults_; }

  [[nodiscard]] std::string made() const {
    return text("%zu pages, %zu sources and %zu pictures are in ", pages_.size(), sources_.size(),
                pictures_.size());
  }

 private:
  [[nodiscard]] fs::path folder() const { return root_ / "common/tools/book"; }

  void add(Part& part, const fs::path& source) {
    const bool is_chapter = *source.begin() == "chapters";
    const std::string name = name_of(source);
    part.pages.push_back(pages_.size());
    pages_.push_back({source.generic_string(), name + ".html", is_chapter ? name : ""});
  }

  template <class Sources>
  void add_part(const std::string& title, const Sources& sources) {
    Part part{title, {}};
    for (const auto& source : sources) {
      if (fs::exists(root_ / source)) add(part, source);
    }
    if (!part.pages.empty()) parts_.push_back(part);
  }

  void find_pages() {
    std::set<fs::path> chapters;
    for (const auto& entry : fs::directory_iterator(root_ / "chapters")) {
      if (fs::exists(entry.path() / "README.md"))
        chapters.insert(fs::relative(entry.path() / "README.md", root_));
    }
    add_part("Chapters", chapters);
    add_part("When something is wrong, or new", readers_pages);
    add_part("For instructors", instructors_pages);
    add_part("For engineers", engineers_pages);
    std::set<fs::path> rest;
    for (const auto& entry : fs::directory_iterator(root_ / "docs")) {
      const fs::path source = fs::relative(entry.path(), root_);
      if (source.extension() == ".md" && page_of(source) == nullptr) rest.insert(source);
    }
    for (const fs::path& source : rest) add(parts_.back(), source);
  }

  [[nodiscard]] const Page* page_of(const fs::path& source) const {
    for (const Page& page : pages_)
      if (page.source == source.generic_string()) return &page;
    return nullptr;
  }

  /// What an address on a page leads to in the book; nothing, which makes a link plain text, if it
  /// is in a chapter that is not there. What else leads nowhere is a fault.
  std::string resolved(const std::string& from, const std::string& url) {
    if (url.find("://") != std::string::npos || url.rfind("mailto:", 0) == 0) return url;
    const std::size_t hash = url.find('#');
    std::string anchor = hash == std::string::npos ? "" : url.substr(hash);
    const std::string file = url.substr(0, hash);
    if (file.empty()) {
      named_.push_back({from, from, anchor});
      return anchor;
    }
    fs::path target = (fs::path(from).parent_path() / file).lexically_normal();
    if (!target.has_filename()) target = target.parent_path();
    if (fs::is_directory(root_ / target)) target /= "README.md";
    if (const Page* const page = page_of(target)) {
      // a state of a live picture is no heading: #degrees=63
      if (anchor.find('=') == std::string::npos) named_.push_back({from, page->source, anchor});
      return page->file + anchor;
    }
    if (is_of_no_chapter(target.generic_string())) return "";
    if (!fs::is_regular_file(root_ / target)) {
      faults_.push_back(from + ": " + url + " leads nowhere");
      return url;
    }
    const std::string extension = target.extension().string();
    if (extension == ".png" || extension == ".svg" || extension == ".jpg") return picture(target);
    sources_[target.generic_string()];
    return "source/" + flat(target) + ".html" + anchor;
  }

  /// True for a place chapters/NN_name/... if no chapter has this number: somebody deleted it.
  [[nodiscard]] bool is_of_no_chapter(const std::string& path) const {
    if (path.rfind("chapters/", 0) != 0 || path.size() < 12 || path[11] != '_') return false;
    return std::none_of(pages_.begin(), pages_.end(), [&](const Page& page) {
      return page.chapter.substr(0, 2) == path.substr(9, 2);
    });
  }

  /// Where a page's code is from: its file and its line, with a link, and which of its lines the
  /// chapter before has in its lesson. The page's mark begins with <!-- code: FILE NAME.
  Place located(const std::string& from, const std::string& mark, const std::string& code) {
    std::istringstream words(mark);
    std::string file, name;
    words >> name >> name >> file >> name;
    fs::path source;
    for (const fs::path& folder : {fs::path(from).parent_path(), fs::path("common"), fs::path()})
      if (source.empty() && fs::exists(root_ / folder / file)) source = folder / file;
    if (source.empty()) return fault(from + ": there is no " + file);
    const std::vector<std::string> lines = lines_of(contents_of(root_ / source));
    const std::vector<std::string> piece = lines_of(code);
    const std::size_t line = line_of(lines, piece, name.substr(name.rfind(':') + 1));
    if (line == 0) return fault(from + ": " + source.generic_string() + " has not its code");
    sources_[source.generic_string()].insert(line);
    const std::string where = text("%s:%zu", source.generic_string().c_str(), line);
    const std::string address = text("source/%s.html#L%zu", flat(source).c_str(), line);
    Place place{"<div class=\"place\"><a href=\"" + address + "\">" + where + "</a>", {}};
    if (source.filename() == "lesson.hpp") {
      const std::set<std::string> before = lesson_before(source);
      for (const std::string& one : piece) {
        const bool has_letters = one.find_first_not_of(" {}();,") != std::string::npos;
        if (has_letters && before.count(one) != 0) place.known = before;
      }
      if (!place.known.empty()) place.html += "<span>gray: as in the chapter before</span>";
    }
    place.html += "</div>";
    return place;
  }

  /// The lines of the lesson of the chapter before; none if there is no such lesson.
  [[nodiscard]] std::set<std::string> lesson_before(const fs::path& lesson) const {
    fs::path before;
    for (const Page& page : pages_) {
      const fs::path other = fs::path(page.source).replace_filename("lesson.hpp");
      if (other == lesson) break;
      if (fs::exists(root_ / other)) before = other;
    }
    if (before.empty()) return {};
    const std::vector<std::string> lines = lines_of(contents_of(root_ / before));
    return {lines.begin(), lines.end()};
  }

  Place fault(const std::string& what) {
    faults_.push_back(what);
    return {};
  }

  static std::string flat(const fs::path& path) {
    std::string name = path.generic_string();
    std::replace(name.begin(), name.end(), '/', '-');
    return name;
  }

  std::string picture(const fs::path& target) {
    // A copy also where the chapter's program has drawn it: the reader may draw it again, changed.
    std::string place = "pictures/" + flat(target);
    if (pictures_.insert(place).second) {
      fs::create_directories(out_ / "pictures");
      fs::copy_file(root_ / target, out_ / place, fs::copy_options::overwrite_existing);
    }
    return place;
  }

  /// Every # of a link within the book names a heading.
  void check_names() {
    for (const auto& [from, to, anchor] : named_) {
      const auto is_it = [&id = anchor](const Section& one) { return "#" + one.id == id; };
      if (anchor.empty() || std::ranges::any_of(page_of(to)->converted.sections, is_it)) continue;
      faults_.push_back(text("%s: %s has no heading %s", from.c_str(), to.c_str(), anchor.c_str()));
    }
  }

  /// The names of a part's pages, with links.
  [[nodiscard]] std::string contents(const Part& part) const {
    std::string html = "<h2>" + escaped_markup(part.title) + "</h2>\n<ul>\n";
    for (const std::size_t i : part.pages) {
      html += "<li><a href=\"" + pages_[i].file + "\">" + escaped_markup(pages_[i].title()) +
              "</a></li>\n";
    }
    return html + "</ul>\n";
  }

  /// The begin of a page, without the tags that HTML need not have: 280 pages have it. Servers may
  /// forbid styles and pictures that are no files.
  static std::string head_of(const std::string& title, const std::vector<const char*>& sheets,
                             const std::string& up = "") {
    std::string html =
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
        escaped_markup(title) + "</title>\n<link rel=\"icon\" href=\"" + up + "favicon.svg\">\n";
    for (const char* const sheet : sheets)
      html += "<link rel=\"stylesheet\" href=\"" + up + sheet + "\">\n";
    return html;
  }

  /// The page with rules of sizes.css in place of styles within its tags.
  std::string with_rules(std::string html) {
    const std::string begin = " style=\"";
    for (std::size_t at = 0; (at = html.find(begin, at)) != std::string::npos;) {
      const std::string style = between(html.substr(at), begin, "\"");
      const auto [rule, is_new] = rules_.insert({style, rules_.size()});
      const std::string name = text("data-size=\"%zu\"", rule->second);
      if (is_new) sizes_.append("[").append(name).append("] { ").append(style).append("; }\n");
      html.replace(at + 1, begin.size() + style.size(), name);
    }
    return html;
  }

  /// For the bar: this chapter between its neighbors.
  [[nodiscard]] std::string near(std::size_t i) const {
    const auto link = [&](std::size_t to, const char* rel, const char* before, const char* after) {
      if (to >= pages_.size() || pages_[to].chapter.empty()) return std::string();
      return text("<a rel=\"%s\" href=\"%s\" title=\"", rel, pages_[to].file.c_str()) +
             escaped_markup(pages_[to].title()) + "\">" + before + pages_[to].chapter.substr(0, 2) +
             after + "</a>\n";
    };
    return "<nav class=\"near\" aria-label=\"Chapters\">\n" + link(i - 1, "prev", "← ", "") +
           "<b>" + pages_[i].chapter.substr(0, 2) + "</b>\n" + link(i + 1, "next", "", " →") +
           "</nav>\n";
  }

  /// A whole HTML page.
  /// @param up  the way from it to the book's folder: "" or "../"
  [[nodiscard]] std::string framed(const std::string& title, const std::string& body,
                                   std::size_t current, const std::string& up = "") {
    const std::string sized_body = with_rules(body);
    std::vector<const char*> sheets{up.empty() ? "book.css" : "source.css"};
    if (body.find("class=\"sheet ") != std::string::npos) sheets.push_back("sheets.css");
    if (sized_body != body) sheets.push_back("sizes.css");
    const std::string live = up.empty() ? live_chapter(current) : "", own = own_script(live);
    if (!live.empty()) sheets.push_back("live/live.css");
    std::string html =
        head_of(title, sheets, up) +
        "<a class=\"skip\" href=\"#main\">To the text</a>\n<header>\n<a class=\"home\" href=\"" +
        up + "index.html\">Texture Mapping, Step by Step</a>\n<a href=\"" + up +
        "index.html#contents\">Contents</a>\n";
    if (current < pages_.size() && !pages_[current].chapter.empty()) html += near(current);
    if (page_of("docs/symptoms.md") != nullptr)
      html += "<a href=\"" + up + "symptoms.html\">My Earth is …</a>\n";
    if (up.empty()) {
      html +=
          "<div class=\"search\"><input id=\"search\" type=\"search\" placeholder=\"Search (/)\" "
          "aria-label=\"Search the book\" autocomplete=\"off\"><ul id=\"found\" "
          "hidden></ul></div>\n";
    }
    html += "</header>\n<main id=\"main\"";
    if (!live.empty() && own.empty()) {
      html.append(" data-live=\"").append(live).append("\"");
      html.append(rows_elsewhere(current)).append(slips_of(live));
    }
    html.append(">\n").append(sized_body).append("</main>\n");
    if (up.empty()) html += "<script src=\"book.js\"></script>\n";
    std::vector<std::string> scripts;
    if (live_ && body.find("class=\"hero ") != std::string::npos)
      scripts = {"live/live.js", "cover.js", "live/cover.js"};
    if (!live.empty()) scripts = {"live/live.js"};
    if (!own.empty()) scripts.push_back("live/" + own);
    for (const std::string& script : scripts)
      html.append("<script src=\"").append(script).append("\" defer></script>\n");
    return html;
  }

  /// The pages before a page that have the lines for rows of its loupe, where it has none itself:
  /// data-rows="u=02_checkerboard_uv.html#row-1|v=...". The nearest one counts.
  [[nodiscard]] std::string rows_elsewhere(std::size_t current) const {
    std::map<std::string, std::string> file_of;
    for (std::size_t i = 0; i < current; ++i) {
      for (const auto& [name, id] : pages_[i].converted.rows)
        file_of[name] = pages_[i].file + "#" + id;
    }
    std::string list;
    for (const auto& [name, file] : file_of) {
      if (pages_[current].converted.rows.count(name) != 0) continue;
      if (!list.empty()) list += '|';
      list.append(name).append("=").append(file);
    }
    return list.empty() ? "" : " data-rows=\"" + list + "\"";
  }

  /// The mistakes that a live picture can draw, and their lines of code: data-slips="[...]".
  [[nodiscard]] static std::string slips_of(const std::string& chapter) {
    std::vector<Json> list;
    std::set<std::string> known;
    const auto add = [&](const std::vector<std::string>& typed, const slips::Slip& slip,
                         const char* right, const char* wrong) {
      if (!known.insert(slip.words).second) return;  // 12 has two with the same words
      std::string name;
      for (const slips::Card& card : slips::cards) {
        if (slip.words.find(card.words) != std::string::npos) name = card.name;
      }
      list.push_back(Json::object({{"typed", Json::list({typed.begin(), typed.end()})},
                                   {"words", slip.words},
                                   {"change", slip.change},
                                   {"card", name},
                                   {"right", right},
                                   {"wrong", wrong}}));
    };
    for (const slips::PageSlip* one : slips::of_chapter(chapter, slips::on_pages)) {
      const auto [place, row] = slips::row_named(one->begins).value();
      const slips::Slip slip = slips::slip_of(place, row);
      add({"--mistake", slip.words}, slip, one->right, one->wrong);
    }
    const auto add_options = [&](const auto& all) {
      for (const slips::OptionSlip* one : slips::of_chapter(chapter, all))
        add(one->typed(), {one->words, one->change}, one->right, one->wrong);
    };
    add_options(slips::of_pages);
    add_options(slips::of_options);
    if (list.empty()) return "";
    return " data-slips=\"" + escaped_markup(Json::list(list).text) + "\"";
  }

  /// Where the code of live pictures is; page_NN.js is that of one chapter's page alone, if any.
  [[nodiscard]] fs::path playground() const { return root_ / "common/tools/playground"; }
  [[nodiscard]] std::string own_script(const std::string& number) const {
    std::string name = text("page_%s.js", number.c_str());
    return fs::exists(playground() / name) ? name : "";
  }

  /// The number of a page's chapter if its picture is live, else nothing.
  [[nodiscard]] std::string live_chapter(std::size_t page) const {
    if (page >= pages_.size() || pages_[page].chapter.empty()) return "";
    std::string number = pages_[page].chapter.substr(0, 2);
    const bool has_own =
        fs::exists(root_ / "docs/live" / (number + ".js")) || !own_script(number).empty();
    return has_own || (number <= "06" && number > "00" && live_) ? number : "";
  }

  /// What live pictures load: modules and textures, and the code of their page.
  void write_live() const {
    fs::remove_all(out_ / "live");
    if (!live_) return;
    for (const fs::path& from : {root_ / "docs/live", playground()}) {
      for (const auto& entry : fs::directory_iterator(from)) {
        const fs::path& file = entry.path();
        if (file.extension() == ".js" || file.extension() == ".css")
          write(out_ / "live" / file.filename(), contents_of(file));
      }
    }
  }

  /// What the course's programs made for a chapter: its step, its turntable, its plots.
  [[nodiscard]] std::string made_for(const std::string& chapter) const {
    std::string html;
    const std::string number = chapter.substr(0, 2);
    if (fs::is_directory(out_ / "diff")) {
      for (const auto& entry : fs::directory_iterator(out_ / "diff")) {
        const std::string name = entry.path().filename().string();
        const bool is_its = name.size() == 5 && name.substr(3) == number;
        if (!is_its || !fs::exists(entry.path() / "index.html")) continue;
        html.append("<p><a href=\"diff/").append(name);
        html.append("/index.html\">What changed from chapter ").append(name, 0, 2);
        html.append(" to chapter ").append(number).append(": pictures, figures, code</a></p>\n");
      }
    }
    std::set<std::string> frames, plots;
    if (fs::is_directory(out_)) {
      for (const auto& entry : fs::directory_iterator(out_)) {
        const std::string name = entry.path().filename().string();
        if (name.rfind(chapter + "_", 0) != 0) continue;
        const std::string rest = name.substr(chapter.size() + 1);
        if (rest.size() == 7 && entry.path().extension() == ".png") frames.insert(name);
        if (entry.path().extension() == ".svg") plots.insert(name);
      }
    }
    if (!frames.empty()) {
      std::string list;
      for (const std::string& frame : frames) list += (list.empty() ? "" : " ") + frame;
      html += "<figure><img src=\"" + *frames.begin() +
              "\" alt=\"The globe, turning\"><figcaption><button type=\"button\" "
              "data-frames=\"" +
              list + "\">Turn the globe</button></figcaption></figure>\n";
    }
    for (const std::string& plot : plots) {
      html += "<p><a href=\"" + plot + "\">Measured on this machine: " + escaped_markup(plot) +
              "</a></p>\n";
    }
    return html.empty() ? html
                        : "<section class=\"made\" aria-label=\"Made by your programs\">\n" + html +
                              "</section>\n";
  }

  /// The page with the width and height of its pictures: text does not jump when they arrive. They
  /// shrink until their smallest letters are 11 pixels high.
  [[nodiscard]] std::string sized(std::string html) const {
    const std::string begin = "<img loading=\"lazy\" src=\"";
    for (std::size_t at = 0; (at = html.find(begin, at)) != std::string::npos; ++at) {
      const std::string tag = html.substr(at, html.find('>', at) - at);
      const fs::path file = out_ / between(tag, begin, "\"");
      if (tag.find(" width=") != std::string::npos || !fs::exists(file)) continue;
      const std::string data = contents_of(file);
      std::string width = between(data, " width=\"", "\""),
                  height = between(data, " height=\"", "\"");
      const std::size_t font = data.find("font-size");  // of the smallest letters: 13px or ="12"
      double letters = font == std::string::npos ? 0 : std::atof(&data[font + 11]);
      if (file.extension() == ".png") {  // two numbers of four bytes, the largest first
        const auto number = [&data](std::size_t i) {
          return 256 * static_cast<unsigned char>(data.at(i)) +
                 static_cast<unsigned char>(data.at(i + 1));
        };
        width = std::to_string(number(18));
        height = std::to_string(number(22));
        letters = std::atof(between(tag, "data-letters=\"", "\"").c_str());
        const int columns = (number(18) + 6) / 206;  // of crops of 200 x 150, 6 apart: they wrap
        if (letters > 0 && number(18) == 206 * columns - 6) {
          std::string crops = "<span class=\"crops\" role=\"img\" aria-label=\"" +
                              between(tag, "alt=\"", "\"") +
                              text("\" style=\"--columns: %d\">", columns);
          for (int i = 0; i < columns * ((number(22) + 6) / 156); ++i) {
            crops += text("<svg viewBox=\"%d %d 200 150\"><image width=\"%s\" href=\"",
                          i % columns * 206, i / columns * 156, width.c_str()) +
                     between(tag, begin, "\"") + "\"/></svg>";
          }
          html.replace(at, tag.size() + 1, crops + "</span>");
          continue;
        }
      }
      if (letters > 0) {
        const double least = std::ceil(std::stod(width) * 11 / letters);
        html.insert(at + 4, text(" style=\"min-width: %.0fpx\"", least));
      }
      if (!height.empty())
        html.insert(at + 4, text(" width=\"%s\" height=\"%s\"", width.c_str(), height.c_str()));
    }
    return html;
  }

  /// Keeps the place of a live picture, so that the page does not move when it comes: below the
  /// still one, which takes its place, or below the head.
  static void keep_place(std::string& body) {
    const std::size_t image = body.find("<img ");
    const bool is_still = image < body.find("<h2");
    const std::size_t at = body.find("</p>\n", is_still ? image : body.find("class=\"head\""));
    if (at == std::string::npos) return;
    body.insert(at + 5, is_still ? "<div class=\"wide live-place\"></div>\n"
                                 : "<div class=\"wide live-place live-alone\"></div>\n");
  }

  /// Puts into the margin what a word of the glossary means, at its first use on a page that does
  /// not explain it itself. Everyday words and those of each page are left out.
  void add_notes(std::string& body, const std::string& chapter) const {
    static const std::set<std::string> everyday{
        "floor", "step",  "root", "hit",   "front", "path", "paint",   "frame",  "lesson",
        "stage", "noise", "ray",  "pixel", "pole",  "pack", "texture", "vector", "bound"};
    static const std::regex row(R"(\| ([^|]+) \| ([^|]+) \| \[([^\]]+)\]\(.*)"),
        tags("<code>[^<]*</code>|<[^>]*>");
    std::map<std::string, std::string> meaning;
    for (const std::string& line : lines_of(contents_of(root_ / "docs/glossary.md"))) {
      std::smatch found;
      if (!std::regex_match(line, found, row) || found[3] == chapter ||
          everyday.count(found[1]) != 0)
        continue;
      meaning[found[1]] = found[2];
    }
    std::string html;
    int folds = 0;
    for (std::size_t from = 0; from < body.size();) {
      const std::size_t begin = std::min(body.find("<p>", from), body.size());
      const std::size_t end = std::min(body.find("</p>", begin), body.size() - 4) + 4;
      const std::string before = body.substr(from, begin - from);
      html += body.substr(from, end - from);
      from = end;
      for (const char* const tag : {"<details", "<ul", "<ol", "<table", "<blockquote"})
        folds += count_of(before, tag) - count_of(before, std::string("</") + (tag + 1));
      if (folds != 0) continue;
      const std::string words = std::regex_replace(body.substr(begin, end - begin), tags, " ");
      std::string notes;
      for (auto one = meaning.begin(); one != meaning.end() && notes.empty();) {
        const bool is_there = has_word(words, one->first);
        if (is_there)
          notes = "<b>" + escaped_markup(one->first) + "</b> " + escaped_markup(one->second);
        one = is_there ? meaning.erase(one) : std::next(one);
      }
      if (!notes.empty()) html += "\n<aside class=\"note\">" + notes + "</aside>";
    }
    body = html;
  }
  [[nodiscard]] static int count_of(const std::string& in, const std::string& what) {
    int count = 0;
    for (std::size_t at = in.find(what); at != std::string::npos; at = in.find(what, at + 1))
      ++count;
    return count;
  }
  /// True for the word, or its plural.
  [[nodiscard]] static bool has_word(const std::string& in, const std::string& word) {
    const auto is_letter = [&](std::size_t at) {
      return at < in.size() && (std::isalnum(static_cast<unsigned char>(in[at])) != 0 ||
                                in[at] == '-' || in[at] == '_');
    };
    for (std::size_t at = in.find(word); at != std::string::npos; at = in.find(word, at + 1)) {
      const std::size_t last = at + word.size();
      const bool is_plural = last < in.size() && in[last] == 's';
      if ((at == 0 || !is_letter(at - 1)) && !is_letter(is_plural ? last + 1 : last)) return true;
    }
    return false;
  }

  void write_page(std::size_t i) {
    const Page& page = pages_[i];
    std::string body = sized(with_cards(page.converted.html));
    if (!page.chapter.empty()) {
      replace_first(body, "</h1>\n<p>", "</h1>\n<p class=\"lead\">");
      replace_first(body, "</p>\n<p><em>", "</p>\n<p class=\"head\"><em>");
      if (!live_chapter(i).empty()) {
        keep_place(body);
        add_notes(body, page.chapter.substr(0, 2));
      }
      body += made_for(page.chapter);
    }
    body += "<nav class=\"turn\" aria-label=\"Next and previous page\">";
    if (i > 0) {
      body += "<a rel=\"prev\" href=\"" + pages_[i - 1].file + "\">← " +
              escaped_markup(pages_[i - 1].title()) + "</a>";
    }
    if (i + 1 < pages_.size()) {
      body += "<a rel=\"next\" href=\"" + pages_[i + 1].file + "\">" +
              escaped_markup(pages_[i + 1].title()) + " →</a>";
    }
    body += "</nav>\n";
    write(out_ / page.file, framed(page.title(), body, i));
  }

  /// The numbers of the longest source's lines, once for all sources: each shows as many as it has
  /// lines. Nobody copies them with the code, and screen readers do not read them.
  [[nodiscard]] std::string line_numbers() const {
    std::string numbers;
    for (std::ptrdiff_t line = 1; line <= most_lines_; ++line)
      numbers += std::to_string(line) + "\\a ";
    return ":root { --numbers: \"" + numbers + "\"; }\n";
  }

  void write_sources() {
    for (const auto& [source, named] : sources_) {
      const std::string extension = fs::path(source).extension().string();
      const bool is_cpp = extension == ".hpp" || extension == ".cpp";
      const std::string code = contents_of(root_ / source);
      most_lines_ = std::max(most_lines_, 1 + std::count(code.begin(), code.end(), '\n'));
      const std::string body =
          "<h1>" + escaped_markup(source) + "</h1>\n" + highlighted_file(code, is_cpp, named);
      write(out_ / "source" / (flat(source) + ".html"), framed(source, body, pages_.size(), "../"));
    }
  }

  /// A dot for each exercise of a chapter, full if ./course check has passed it.
  [[nodiscard]] std::string exercises_done(const std::string& chapter) const {
    const std::string number = chapter.substr(0, 2);
    const fs::path file = out_ / "exercises/passed.txt";
    const std::vector<std::string> passed =
        fs::exists(file) ? lines_of(contents_of(file)) : std::vector<std::string>{};
    std::string dots;
    int done = 0, all = 0;
    const fs::path answers = root_ / "tests/exercises";
    for (; fs::exists(answers / text("%s_%d.hpp", number.c_str(), all + 1)); ++all) {
      const std::string exercise = text("%s.%d ", number.c_str(), all + 1);
      const bool is_done = std::any_of(passed.begin(), passed.end(), [&](const std::string& line) {
        return line.rfind(exercise, 0) == 0;
      });
      done += is_done ? 1 : 0;
      dots += is_done ? "●" : "○";
    }
    if (all == 0) return "";
    return text(" <span role=\"img\" aria-label=\"%d of %d exercises done\">%s</span>", done, all,
                dots.c_str());
  }

  /// The error microscope, its still picture drawn here: the browser may lack what draws it again.
  [[nodiscard]] std::string hero() {
    const fs::path map = root_ / "assets/earth.png";
    if (!fs::exists(map)) return "<h1>Texture Mapping, Step by Step</h1>\n";
    const double radii = 1000;  // where the slider of cover.html begins
    fs::create_directories(out_ / "pictures");
    write_file_atomically(
        out_ / "pictures/microscope.png",
        encode_png(microscope::draw({load_image(map)}, radii, 320, 0, 320), Packing::close));
    std::string html = contents_of(folder() / "cover.html");
    if (!live_) replace_first(html, " waits", "");
    if (page_of("chapters/14_numerical_extremes/README.md") == nullptr)
      replace_first(html, "<a" + between(html, "<a", "</a>") + "</a>", "");
    return html;
  }

  /// Lines of code in a file, or in all files of a folder; pages and data are no code.
  static std::ptrdiff_t code_lines(const fs::path& place) {
    std::ptrdiff_t sum = 0;
    if (fs::is_directory(place)) {
      for (const auto& entry : fs::directory_iterator(place)) sum += code_lines(entry.path());
      return sum;
    }
    static const std::set<fs::path> code{
        ".cpp", ".hpp",  ".h",     ".in",    ".py", ".sh",           ".js",
        ".css", ".html", ".cmake", "course", "run", "CMakeLists.txt"};
    if (!fs::exists(place) || code.count(place.extension()) + code.count(place.filename()) == 0)
      return sum;
    const std::string lines = contents_of(place);
    return std::count(lines.begin(), lines.end(), '\n');
  }

  /// Squares with areas as large as all code, the textbook's rooms and the lessons.
  [[nodiscard]] std::string squares() const {
    std::ptrdiff_t lessons = 0, rooms = -code_lines(root_ / "common/number/kinds"), all = 0;
    for (const Page& page : pages_)
      lessons += code_lines(root_ / fs::path(page.source).replace_filename("lesson.hpp"));
    for (const char* room : {"number", "math", "sampling", "scene", "texture", "published"})
      rooms += code_lines(root_ / "common" / room);
    for (const char* part : {"chapters", "common", "tests", "assets", ".ci/run", "course"})
      all += code_lines(root_ / part);
    if (lessons == 0) return "";

    std::string sides, words;
    const auto add = [&](std::ptrdiff_t lines, const char* what) {
      std::string number = std::to_string(lines);
      if (number.size() > 3) number.insert(number.size() - 3, 1, ',');
      const double side = std::sqrt(double(lines) / double(all));
      sides += text("<s style=\"--side: %.4f\"></s>", side);
      words += text("<li style=\"--side: %.4f\"><strong>%s</strong> %s</li>\n", side,
                    number.c_str(), what);
    };
    add(all, "lines in all: the rest checks them, measures them and makes them fast.");
    add(lessons + rooms, "with the textbook, where you look up what a lesson calls.");
    add(lessons, "lines of lessons: you read these.");
    return text("<h2>You read %td lines; the rest checks them</h2>\n", lessons) +
           "<figure class=\"squares wide\"><div role=\"img\" aria-label=\"Three squares, one in "
           "another, their areas to scale\">" +
           sides + "</div>\n<ul>\n" + words + "</ul></figure>\n";
  }

  void write_index() {
    std::string body =
        hero() +
        "<p class=\"lead\">How a picture is wrapped round a surface, in a ray tracer that is small "
        "enough to read. Each chapter is one program that adds one idea to the chapter before "
        "it.</p>\n<p class=\"wide legend\">○ is an exercise of a chapter; ● is one that "
        "has passed <code>./course check</code>.</p>\n<ol class=\"path wide\" id=\"contents\">\n";
    for (const Page& page : pages_) {
      if (page.chapter.empty()) continue;
      const std::string& html = page.converted.html;
      const std::string drawn = page.chapter + ".png";
      const fs::path thumb = text("docs/pictures/thumb_%s.png", page.chapter.substr(0, 2).c_str());
      std::string shown = fs::exists(out_ / drawn) ? drawn : between(html, "lazy\" src=\"", "\"");
      if (fs::exists(root_ / thumb))
        shown = picture(thumb);  // a close view: small pictures of 02 and 03 look alike
      const std::string number = between(html, "<p><strong>One number.</strong> ", "</p>");
      body += "<li>";
      if (!shown.empty()) body += "<img src=\"" + shown + "\" alt=\"\" loading=\"lazy\">";
      body += "<div><a href=\"" + page.file + "\">" + escaped_markup(page.title()) + "</a><p>" +
              between(html, "</h1>\n<p>", "</p>") + "</p></div><p>" + number + "</p><p>" +
              between(html, "<p><em>", ",") + exercises_done(page.chapter) + "</p></li>\n";
    }
    body += "</ol>\n" + squares();
    for (std::size_t part = 1; part + 1 < parts_.size(); ++part) body += contents(parts_[part]);
    body += "<h2>How it is checked</h2>\n<p><a href=\"checked.html\">" +
            escaped_markup(parts_.back().title) + "</a></p>\n";
    write(out_ / "index.html", framed("Texture Mapping, Step by Step", body, pages_.size()));
    write(out_ / "checked.html",
          framed("How it is checked", "<h1>How it is checked</h1>\n" + contents(parts_.back()),
                 pages_.size()));
  }

  /// The pages of students and instructors in one, for paper: answers are open, and links within it
  /// lead to places of this page.
  void write_print() {
    std::string body = "<h1>Texture Mapping, Step by Step</h1>\n";
    std::size_t printed = pages_.size() - parts_.back().pages.size();
    for (const Page& page : pages_) {
      if (printed-- == 0) break;
      std::string html = page.converted.html;
      replace_all(html, "<details>", "<details open>");
      for (const Section& section : page.converted.sections) {
        const std::string id = " id=\"" + section.id + "\"";
        const std::size_t at = html.find(id);
        if (at != std::string::npos)
          html.replace(at, id.size(), " id=\"" + page.file + "/" + section.id + "\"");
      }
      body += "<section class=\"printed\" id=\"" + page.file + "\">\n" + within(html, page) +
              "</section>\n";
    }
    write(out_ / "print.html",
          head_of("Texture Mapping, Step by Step", {"book.css", "sheets.css", "sizes.css"}) +
              "<main>\n" + with_rules(body) + "</main>\n");
  }

  /// The page's links as places of the printed book.
  [[nodiscard]] std::string within(const std::string& html, const Page& page) const {
    return with_resolved(html, [&](const std::string& url) {
      const std::size_t hash = std::min(url.find('#'), url.size());
      const std::string file = hash == 0 ? page.file : url.substr(0, hash);
      for (const Page& other : pages_) {
        if (other.file != file) continue;
        return "#" + file + (hash < url.size() ? "/" + url.substr(hash + 1) : "");
      }
      return url;
    });
  }

  /// Names and words of all sections, as a zlib stream in text: a third of what they take as they
  /// are. book.js unpacks it when somebody searches.
  [[nodiscard]] std::string search_index() const {
    std::vector<Json> items;
    for (const Page& page : pages_) {
      for (const Section& section : page.converted.sections) {
        const bool is_title = section.level == 1;
        items.push_back(Json::object({
            {"url", is_title ? page.file : page.file + "#" + section.id},
            {"title", is_title ? page.title() : page.title() + " › " + section.title},
            {"words", section.words},
        }));
      }
    }
    const std::string json = Json::list(items, false).text;
    const Bytes bytes(reinterpret_cast<const std::uint8_t*>(json.data()), json.size());
    return "const packed_sections = \"" + page::base64(deflate(bytes, Packing::close)) + "\";\n";
  }

  struct Named {
    std::string from, to, anchor;
  };

  fs::path root_, out_;
  bool with_print_;
  std::ptrdiff_t most_lines_ = 0;  ///< of a source
  std::vector<Page> pages_;
  std::vector<Part> parts_;
  std::vector<Named> named_;  ///< links from one page to a heading of another
  bool live_ = false;         // whether there are live pictures
  std::map<std::string, std::set<std::size_t>> sources_;  ///< and the lines that links lead to
  std::map<std::string, std::size_t> rules_;  ///< styles of single elements, and their numbers
  std::string sizes_;                         ///< the same as a style sheet
  std::set<std::string> pictures_;
  std::vector<std::string> faults_;
};

}  // namespace
}  // namespace texmap::book

int main(int argc, char** argv) {
  const bool with_print = argc == 4 && std::string_view(argv[3]) == "--print";
  if (argc != 3 && !with_print) {
    std::cerr << "usage: book ROOT OUT [--print]\n";
    return 2;
  }
  try {
    texmap::book::Book book(argv[1], argv[2], with_print);
    book.make();
    for (const std::string& fault : book.faults()) std::cerr << "FAIL: " << fault << '\n';
    std::cout << book.made() << argv[2] << "/index.html\n";
    return book.faults().empty() ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 1;
  }
}
