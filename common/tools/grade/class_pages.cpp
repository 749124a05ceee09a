// The pages of a class: the table of all students, and a page for a student.
#include "class_pages.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "engine/measure/text.hpp"
#include "safe_text.hpp"
#include "tools/page/page.hpp"

namespace texmap::grade {
namespace {

constexpr const char* table_style = R"css(
body { max-width: none; }
.grades { width: 100%; border-collapse: separate; border-spacing: 0; }
.grades th, .grades td { padding: .2rem .3rem; font-size: .8rem; line-height: 1.3; }
.grades td { min-width: 3rem; }
.grades .name { min-width: 8rem; max-width: 16rem; overflow-wrap: anywhere; }
.grades thead { position: sticky; top: 0; background: var(--paper); }
.grades thead td { color: var(--soft); font-size: .8rem; border-bottom: 2px solid var(--line); }
.grades .points { white-space: nowrap; font-weight: 600; }
.grades button { border: 0; padding: 0; background: none; color: inherit; font: inherit;
  cursor: pointer; text-decoration: underline dotted; }
@page { size: landscape; margin: 1cm; }
@media print {
  .grades thead { position: static; }
  .grades tr { break-inside: avoid; }
  .grades button { display: contents; } /* or Chromium leaves it out where a head stands again */
}
)css";

// A compiler's message is one long line.
constexpr const char* notes_style = R"css(
pre { white-space: pre-wrap; overflow-wrap: anywhere; }
)css";

// A cell is sorted by its data-key, a number, or by its text.
constexpr const char* sort_script = R"js(
const table = document.querySelector(".grades");
const heads = [...table.querySelectorAll("thead th")];
const collator = new Intl.Collator(undefined, { numeric: true });
heads.forEach((head, column) => head.querySelector("button").addEventListener("click", () => {
  const down = head.getAttribute("aria-sort") === "ascending";
  const key = (row) => row.cells[column].dataset.key ?? row.cells[column].textContent;
  const rows = [...table.tBodies[0].rows];
  rows.sort((a, b) => collator.compare(key(a), key(b)) * (down ? -1 : 1));
  table.tBodies[0].append(...rows);
  for (const other of heads) other.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", down ? "descending" : "ascending");
}));
)js";

std::string colored(const char* element, bool good, const std::string& text_of_it,
                    const std::string& attributes = {}) {
  std::string html = "<";
  html.append(element).append(good ? " class=\"good\"" : " class=\"bad\"").append(attributes);
  html.append(">").append(page::escaped_foreign(text_of_it)).append("</").append(element);
  return html.append(">");
}

std::string warning_of(bool contained) {
  return contained ? "" : page::verdict(false, page::escaped_foreign(not_contained));
}

/// Whether the chapters' tests ran for anybody.
bool has_tests(const Class& all) {
  return std::any_of(all.students.begin(), all.students.end(), [](const Student& student) {
    return std::any_of(student.rows.begin(), student.rows.end(),
                       [](const Row& row) { return row.exercise.empty() && row.tests_run > 0; });
  });
}

/// "149 right", and below it the words that most students share: "37 mirrored".
std::string sum_of(const Class& all, std::size_t column) {
  constexpr std::size_t most_words = 3;
  std::map<std::string, std::size_t> count;
  std::size_t rows = 0, wrong = 0;
  for (const Student& student : all.students) {
    if (column >= student.rows.size()) continue;
    ++rows;
    const Row& row = student.rows[column];
    if (row.right()) continue;
    ++wrong;
    // Shares of pixels and numbers of tests differ from student to student.
    ++count[row.word.starts_with("differs")  ? "differ"
            : row.word.starts_with("tests ") ? "fail tests"
                                             : row.word];
  }
  if (count.empty()) return "all right";
  std::vector<std::pair<std::size_t, std::string>> words;
  words.reserve(count.size());
  for (const auto& [word, students] : count) words.emplace_back(students, word);
  std::stable_sort(words.begin(), words.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string html = text("%zu right", rows - wrong);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i == most_words) return html + text("<br>%zu other", wrong);
    html += text("<br>%zu ", words[i].first) + page::escaped_foreign(words[i].second);
    wrong -= words[i].first;
  }
  return html;
}

std::string head_of_table(const Class& all) {
  std::string html = "<thead><tr>";
  const auto column = [&html](const std::string& name, const char* attributes) {
    html.append("<th scope=\"col\"").append(attributes).append("><button type=\"button\">");
    html.append(page::escaped_foreign(name)).append("</button></th>");
  };
  column("Points", " aria-sort=\"ascending\"");
  column("Student", " class=\"name\"");
  for (const Item& item : all.items)
    column(item.number, (" title=\"" + page::escaped_foreign(item.name) + "\"").c_str());
  if (has_tests(all)) column("Tests", "");
  html += "</tr>\n<tr><td>";
  double points = 0, of = 0;
  for (const Student& student : all.students) {
    points += student.points();
    of += student.of();
  }
  if (of > 0) html += text("mean %.0f %%", 100 * points / of);
  html += text("</td><td>all %zu</td>", all.students.size());
  for (std::size_t i = 0; i < all.items.size(); ++i)
    html.append("<td>").append(sum_of(all, i)).append("</td>");
  if (has_tests(all)) html += "<td></td>";
  return html.append("</tr></thead>\n");
}

std::string table_row(const Class& all, const Student& student) {
  const double share = student.of() > 0 ? 1.0 * student.points() / student.of() : 0;
  std::string html = text("<tr><td class=\"points\" data-key=\"%.0f\">%d of %d", 1e6 * share,
                          student.points(), student.of());
  if (const std::string unfinished = all.unfinished(student); !unfinished.empty())
    html.append("<br>").append(unfinished);
  html += "</td>";
  html += "<th scope=\"row\" class=\"name\"><bdi>";
  const std::string name = page::escaped_foreign(student.name);
  if (student.has_page()) {
    html.append("<a href=\"").append(page::address_of(student.page)).append(".html\">");
    html.append(name).append("</a>");
  } else {
    html += name;
  }
  html += "</bdi></th>";
  std::size_t passed = 0, run = 0;
  for (const Row& row : student.rows) {
    html += colored("td", row.right(), row.right() ? "✓" : row.word);
    if (!row.exercise.empty()) continue;  // its word says it all
    passed += row.tests_passed;
    run += row.tests_run;
  }
  for (std::size_t i = student.rows.size(); i < all.items.size(); ++i) html += "<td></td>";
  if (!has_tests(all)) return html.append("</tr>\n");
  html +=
      run == 0 ? "<td></td>" : text("<td data-key=\"%zu\">%zu of %zu</td>", passed, passed, run);
  return html.append("</tr>\n");
}

std::string section(const Row& row) {
  std::string html = "<h2 id=\"" + page::escaped_foreign(row.item) + "\">";
  html.append(page::escaped_foreign(row.item)).append(": ");
  html.append(colored("span", row.right(), row.right() ? "right" : row.word)).append("</h2>\n");
  if (!row.note.empty()) {
    html.append("<pre>").append(page::escaped_foreign(clean_lines(row.note, 4000)));
    html += "</pre>\n";
  }
  if (row.shown) {
    html += page::side_by_side(
        {page::figure(page::inside(row.shown->is), "is: " + row.shown->where),
         page::figure(page::inside(row.shown->should), "should be"),
         page::figure(page::inside(row.shown->map), "where they differ: black nowhere, yellow most",
                      "the map of differences")});
  }
  std::vector<std::vector<std::string>> figures;
  const auto entry = [&figures](const char* name, const std::string& value) {
    if (!value.empty()) figures.push_back({name, page::escaped_foreign(value)});
  };
  entry("build", row.build);
  entry("run", row.run);
  if (!row.cpu_seconds.empty())
    entry("processor time", row.cpu_seconds + " s of " + row.limit_cpu_seconds + " s");
  if (row.exercise.empty()) entry("tests passed", row.tests());
  if (row.figures && !row.picture_ok) {
    entry("pixels off by more than one level", text("%zu", row.figures->pixels_off));
    entry("RMSE", text("%.3g levels", row.figures->rmse));
    entry("SSIM", text("%.4f", row.figures->ssim));
  }
  return figures.empty() ? html : html + page::table({}, figures);
}

}  // namespace

std::string class_page(const Class& all) {
  std::string html = warning_of(all.contained());
  html += "<p>" + counted(all.students.size(), "folder") + " graded";
  if (all.students.size() < all.asked)
    html += text(" of %zu: the run was ended before the others", all.asked);
  html +=
      ". All figures: <a href=\"grades.csv\">grades.csv</a>, "
      "<a href=\"points.csv\">points.csv</a>. A name with a link has a page.</p>\n"
      "<table class=\"grades\">\n";
  html += head_of_table(all) + "<tbody>\n";
  std::vector<const Student*> sorted;
  sorted.reserve(all.students.size());
  for (const Student& student : all.students) sorted.push_back(&student);
  std::stable_sort(sorted.begin(), sorted.end(), [](const Student* a, const Student* b) {
    return a->points() * b->of() < b->points() * a->of();
  });
  for (const Student* student : sorted) html += table_row(all, *student);
  html += "</tbody>\n</table>\n";
  return page::framed({"Grades", table_style, sort_script}, html);
}

std::string student_page(const Student& student) {
  std::string html = warning_of(student.contained());
  html += page::verdict(student.points() == student.of(),
                        text("%d of %d points", student.points(), student.of()));
  html += "<p><a href=\"index.html\">All students</a></p>\n";
  if (!student.note.empty()) html += "<p>" + page::escaped_foreign(clean(student.note)) + "</p>\n";
  std::string right;
  for (const Row& row : student.rows) {
    if (row.right() && row.note.empty()) {
      right.append(right.empty() ? "" : ", ").append(row.item);
    } else {
      html += section(row);
    }
  }
  if (!right.empty()) html += "<h2>Right</h2>\n<p>" + page::escaped_foreign(right) + "</p>\n";
  return page::framed({"Grades of " + student.name, notes_style, ""}, html);
}

}  // namespace texmap::grade
