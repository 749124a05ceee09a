// The page that shows what changed between two steps.
#include <string>
#include <vector>

#include "comparison.hpp"
#include "engine/compare/difference_map.hpp"
#include "engine/measure/text.hpp"
#include "tools/page/page.hpp"

namespace texmap::steps {
namespace {

std::string rgb(Rgb8 p) { return text("(%d, %d, %d)", p.r, p.g, p.b); }

std::string figures_table(const Comparison& c) {
  const Figures& f = c.figures;
  std::vector<std::vector<std::string>> rows;
  rows.push_back({"pixels that differ", text("%zu of %zu (%.3f %%)", f.pixels_different,
                                             f.pixels_compared, 100 * f.share_different)});
  rows.push_back({"of these, elsewhere", text("%zu", c.changed_elsewhere)});
  if (f.pixels_different > 0) {
    rows.push_back({"box around them",
                    text("columns %d to %d, rows %d to %d", f.box.left,
                         f.box.left + f.box.width - 1, f.box.top, f.box.top + f.box.height - 1)});
    rows.push_back({"largest difference", text("%d levels at column %d, row %d: ", f.worst.levels,
                                               f.worst.column, f.worst.row) +
                                              rgb(f.worst.a) + " became " + rgb(f.worst.b)});
  }
  rows.push_back({"mean absolute error", text("%.4f levels", f.mean_absolute_error)});
  rows.push_back({"RMSE", text("%.4f levels", f.root_mean_square_error)});
  rows.push_back(
      {"PSNR", f.pixels_different == 0 ? "infinite" : text("%.2f dB", f.peak_signal_to_noise)});
  rows.push_back({"SSIM", text("%.6f", f.structural_similarity)});
  rows.push_back({"FLIP", text("%.6f", f.flip)});
  if (c.pixels_with_uv > 0) {
    rows.push_back({"pixels with (u, v) in both", text("%zu", c.pixels_with_uv)});
    rows.push_back(
        {"largest |du|, |dv|", text("%.6g of a turn, %.6g", c.largest_du, c.largest_dv)});
  }
  rows.push_back({"drawing", text("%.1f ms became %.1f ms (the least of three)",
                                  c.before.milliseconds, c.after.milliseconds)});
  return page::table({}, rows);
}

std::string title_of(const DrawnStep& before, const DrawnStep& after) {
  return "From " + before.chapter + " to " + after.chapter;
}

}  // namespace

std::string scenes_page(const DrawnStep& before, const DrawnStep& after,
                        const std::string& before_code, const std::string& after_code) {
  std::string html =
      page::verdict(true, "The two chapters draw different scenes, so no pixels are compared.");
  html += "<h2>Both pictures</h2>\n";
  html += page::side_by_side(
      {page::figure(page::inside(before.picture), "The picture of " + before.chapter),
       page::figure(page::inside(after.picture), "The picture of " + after.chapter)});
  html += "<h2>The code</h2>\n" + page::code_difference(before_code, after_code);
  return page::framed({title_of(before, after), {}, {}}, html);
}

std::string report_page(const Comparison& c, const std::string& before_code,
                        const std::string& after_code) {
  std::string declared;
  for (const int object : c.may_change)
    declared += (declared.empty() ? "" : ", ") + object_name(object);
  const bool good = c.changed_elsewhere == 0;
  std::string found = good ? "Only what may change has changed"
                           : text("%zu pixels changed that should not have", c.changed_elsewhere);
  found += ": the step declares " + escaped_markup(declared.empty() ? "no object" : declared) + ".";
  if (!good)
    found += text(" The first of them is at column %d, row %d.", c.stray_column, c.stray_row);

  std::string html = page::verdict(good, found);
  html += "<h2>Both pictures</h2>\n";
  html += page::slider(page::inside(c.before.picture), c.before.chapter,
                       page::inside(c.after.picture), c.after.chapter);
  html += "<h2>Figures</h2>\n" + figures_table(c);
  html += "<h2>Where they differ</h2>\n" +
          page::figure(page::inside(difference_map(c.before.picture, c.after.picture)),
                       "Difference in levels; black is none");
  if (c.figures.pixels_different > 0) {
    const auto around = [&c](const DrawnStep& step, const char* name) {
      return page::figure(
          page::inside(zoom(step.picture, c.figures.worst.column, c.figures.worst.row)), name);
    };
    html += "<h2>Around the largest difference</h2>\n" +
            page::side_by_side({around(c.before, "before"), around(c.after, "after")});
  }
  if (c.pixels_with_uv > 0) {
    html += "<h2>Texture coordinates</h2>\n" +
            page::figure(page::inside(uv_difference_map(c)),
                         "|du| on the left, |dv| on the right, from black (none) to yellow (half a "
                         "turn, the whole height); gray where one of the steps has no (u, v)");
  }
  html += "<h2>The code</h2>\n" + page::code_difference(before_code, after_code);
  return page::framed({title_of(c.before, c.after), {}, page::slider_script}, html);
}

}  // namespace texmap::steps
