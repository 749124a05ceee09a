// The pages that show what changed between two steps, two chapters or two pictures.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "comparison.hpp"
#include "engine/compare/difference_map.hpp"
#include "engine/measure/text.hpp"
#include "engine/picture/load_image.hpp"
#include "engine/picture/save_png.hpp"
#include "engine/system/system.hpp"
#include "tools/page/page.hpp"

namespace texmap::steps {
namespace {

std::string rgb(Rgb8 p) { return text("(%d, %d, %d)", p.r, p.g, p.b); }

using Rows = std::vector<std::vector<std::string>>;

Rows figure_rows(const Figures& f) {
  Rows rows;
  rows.push_back({"pixels that differ", text("%zu of %zu (%.3f %%)", f.pixels_different,
                                             f.pixels_compared, 100 * f.share_different)});
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
  return rows;
}

/// The map of differences, and the pixels around the largest.
std::string where_they_differ(const Image& a, const Image& b, const Figures& figures,
                              const Pictures& pictures) {
  if (figures.pixels_different == 0) return {};
  std::string html = "<h2>Where they differ</h2>\n";
  html += page::figure(pictures.show(difference_map(a, b), "difference.png"),
                       "Difference in levels; black is none");
  const auto around = [&](const Image& picture, const std::string& name) {
    return page::figure(
        pictures.show(zoom(picture, figures.worst.column, figures.worst.row), name + "_close.png"),
        name);
  };
  html += "<h2>Around the largest difference</h2>\n";
  html += page::side_by_side({around(a, "before"), around(b, "after")});
  return html;
}

std::string texture_coordinates(const Comparison& c, const Pictures& pictures) {
  if (c.pixels_with_uv == 0) return {};
  std::string html = "<h2>Texture coordinates</h2>\n";
  if (c.uv_box.width == 0)
    return html + "<p>Wherever both steps have (u, v), they have the same.</p>\n";
  const Image map = uv_difference_map(c);
  Box dv = c.uv_box;
  dv.left += c.before.picture.width;
  html += page::side_by_side({page::figure(pictures.show(crop(map, c.uv_box), "du.png"),
                                           "|du| from black (none) to yellow (half a turn)"),
                              page::figure(pictures.show(crop(map, dv), "dv.png"),
                                           "|dv| from black (none) to yellow (the whole height)")});
  return html +
         "<p>The part of the picture where they differ; gray where one of the steps has no "
         "(u, v).</p>\n";
}

using Paths = std::vector<std::filesystem::path>;

/// The chapters' pictures, such as 03_image_texture.png, the last first; none of a turntable.
Paths of_chapters(const std::filesystem::path& folder) {
  Paths pictures;
  if (!std::filesystem::is_directory(folder)) return pictures;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = name_of(entry.path().stem());
    const bool is_frame = name.find_last_not_of("0123456789") + 3 == name.size();
    if (entry.path().extension() == ".png" && !is_frame) pictures.push_back(entry.path());
  }
  std::sort(pictures.rbegin(), pictures.rend());
  return pictures;
}

std::string code_section(const std::string& before, const std::string& after) {
  return "<h2>The code</h2>\n" + page::code_difference(before, after);
}

}  // namespace

page::Picture Pictures::show(const Image& image, const std::string& file) const {
  if (folder.empty()) return page::inside(image);
  save_png(image, folder / file);
  return {page::address_of(file), image.width, image.height};
}

page::Picture Pictures::show(const DrawnStep& step, const std::string& file) const {
  const std::string chapter = step.chapter.substr(0, step.chapter.find(' '));
  for (const std::filesystem::path& own : folder.empty() ? Paths{} : of_chapters(drawn)) {
    if (own.stem() <= chapter && load_image(own) == step.picture) return show(own);
  }
  return show(step.picture, file);
}

page::Picture Pictures::show(const std::filesystem::path& file) const {
  const Image image = load_image(file);
  if (folder.empty() || file.parent_path() != drawn)
    return show(image, file.filename().generic_string());
  const std::filesystem::path address =
      std::filesystem::absolute(file).lexically_relative(std::filesystem::absolute(folder));
  return {page::address_of(address.generic_string()), image.width, image.height};
}

std::string code_page(const Code& before, const Code& after, const std::string& why,
                      const Pictures& pictures) {
  std::string html = page::verdict(true, page::escaped_foreign(why));
  std::vector<std::string> figures;
  for (const Code* code : {&before, &after}) {
    if (!code->picture.empty()) {
      figures.push_back(
          page::figure(pictures.show(code->picture), "The picture of " + code->chapter));
    }
  }
  if (!figures.empty()) html += "<h2>Their pictures</h2>\n" + page::side_by_side(figures);
  html += code_section(before.text, after.text);
  return page::framed({"From " + before.chapter + " to " + after.chapter, {}, {}}, html);
}

std::string picture_page(const std::string& a_name, const Image& a, const std::string& b_name,
                         const Image& b, const Figures& figures, const Pictures& pictures) {
  const bool same = figures.pixels_different == 0;
  std::string html =
      page::verdict(same, same ? "The pictures are the same."
                               : text("The pictures differ in %zu of %zu pixels.",
                                      figures.pixels_different, figures.pixels_compared));
  html += "<h2>Both pictures</h2>\n";
  html +=
      page::slider(pictures.show(a, "before.png"), a_name, pictures.show(b, "after.png"), b_name);
  html += "<h2>Figures</h2>\n" + page::table({}, figure_rows(figures));
  html += where_they_differ(a, b, figures, pictures);
  return page::framed({"From " + a_name + " to " + b_name, {}, page::slider_script}, html);
}

std::string report_page(const Comparison& c, const std::string& before_code,
                        const std::string& after_code, const Pictures& pictures) {
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
  html += page::slider(pictures.show(c.before, "before.png"), c.before.chapter,
                       pictures.show(c.after, "after.png"), c.after.chapter);
  Rows rows = figure_rows(c.figures);
  rows.insert(rows.begin() + 1, {"of these, elsewhere", text("%zu", c.changed_elsewhere)});
  if (c.pixels_with_uv > 0) {
    rows.push_back({"pixels with (u, v) in both", text("%zu", c.pixels_with_uv)});
    rows.push_back(
        {"largest |du|, |dv|", text("%.6g of a turn, %.6g", c.largest_du, c.largest_dv)});
  }
  html += "<h2>Figures</h2>\n" + page::table({}, rows);
  html += where_they_differ(c.before.picture, c.after.picture, c.figures, pictures);
  html += texture_coordinates(c, pictures);
  html += code_section(before_code, after_code);
  return page::framed(
      {"From " + c.before.chapter + " to " + c.after.chapter, {}, page::slider_script}, html);
}

}  // namespace texmap::steps
