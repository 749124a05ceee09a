// What changed between two steps, and whether only that changed which the chapters declare: in
// figures, in words, and on the pages of two steps, two chapters or two pictures.
#include "comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "engine/files/load_image.hpp"
#include "engine/files/save_png.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"

namespace texmap::steps {

constexpr std::array object_names = {"middle", "left", "right", "ground"};

static std::string names_of(ObjectSet objects, const std::string& if_empty) {
  std::string names;
  for (int index = 0; const char* const name : object_names) {
    if (objects.contains(index++)) names.append(names.empty() ? "" : ", ").append(name);
  }
  return names.empty() ? if_empty : names;
}

Comparison compare(DrawnStep before, DrawnStep after, ObjectSet may_change) {
  Comparison result;
  result.figures = measure(before.picture, after.picture);
  const auto allowed = [&](int object) { return object >= 0 && may_change.contains(object); };
  for (std::size_t i = 0; i < before.objects.size(); ++i) {
    const Uv<double>&a = before.uv[i], &b = after.uv[i];
    if (!std::isnan(a.u) && !std::isnan(b.u)) {
      const double turns = a.u - b.u;
      result.pixels_with_uv += 1;
      result.largest_du = std::max(result.largest_du, std::abs(turns - std::round(turns)));
      result.largest_dv = std::max(result.largest_dv, std::abs(a.v - b.v));
    }
    if (before.picture.pixels[i] == after.picture.pixels[i]) continue;
    if (allowed(before.objects[i]) || allowed(after.objects[i])) {
      result.changed_inside += 1;
      continue;
    }
    if (result.changed_elsewhere == 0) {
      result.stray_column = static_cast<int>(i) % before.picture.width;
      result.stray_row = static_cast<int>(i) / before.picture.width;
    }
    result.changed_elsewhere += 1;
  }
  result.before = std::move(before);
  result.after = std::move(after);
  result.may_change = may_change;
  return result;
}
std::string report_json(const Comparison& c) {
  std::vector<Json> may_change;
  for (int index = 0; const char* const name : object_names) {
    if (c.may_change.contains(index++)) may_change.emplace_back(name);
  }
  const Json stray = Json::object({{"column", c.stray_column}, {"row", c.stray_row}});
  return Json::object(
             {
                 {"before", c.before.name},
                 {"after", c.after.name},
                 {"only_declared_changed", c.changed_elsewhere == 0},
                 {"may_change", Json::list(may_change)},
                 {"changed_inside", c.changed_inside},
                 {"changed_elsewhere", c.changed_elsewhere},
                 {"first_changed_elsewhere", c.stray_column < 0 ? nullptr : stray},
                 {"pixels_with_uv", c.pixels_with_uv},
                 {"largest_du_turns", c.largest_du},
                 {"largest_dv", c.largest_dv},
                 {"figures", json_of(c.figures)},
             },
             true)
             .text +
         "\n";
}

std::string summary(const Comparison& c, const std::string& page) {
  const Figures& f = c.figures;
  std::string lines = c.before.name + " -> " + c.after.name + "\n";
  if (f.pixels_different == 0) {
    lines += "  changed    0 of " + std::to_string(f.pixels_compared) + " pixels\n";
  } else {
    lines += "  changed    " + differing_pixels(f) +
             text("; columns %d to %d, rows %d to %d\n", f.box.left, f.box.left + f.box.width - 1,
                  f.box.top, f.box.top + f.box.height - 1);
  }
  lines += text("  elsewhere  %zu pixels changed; the step may change: %s\n", c.changed_elsewhere,
                names_of(c.may_change, "nothing").c_str());
  lines += text("  figures    largest %d levels at (%d, %d), RMSE %.2f, PSNR %.1f dB, SSIM %.4f\n",
                f.worst.levels, f.worst.column, f.worst.row, f.root_mean_square_error,
                f.peak_signal_to_noise, f.structural_similarity);
  lines.append("  look at    ").append(page).append("\n");
  return lines;
}

namespace {

/// The pixels around a place, each enlarged to a square, with a frame round the one in the middle.
Image zoom(const Image& picture, int column, int row) {
  constexpr int radius = 7;  // pixels on each side of the middle one
  constexpr int factor = 16;
  constexpr int side = (2 * radius + 1) * factor;
  return image_of(side, side, [&](int x, int y) {
    // A frame of two lines, black in white, round the middle pixel: seen on any color.
    const int off = std::max(std::abs(2 * x + 1 - side), std::abs(2 * y + 1 - side)) / 2;
    const int ring = off - factor / 2;
    if (ring == 0 || ring == 1) return Rgb8{0, 0, 0};
    if (ring == 2 || ring == 3) return Rgb8{255, 255, 255};
    const int from_column = column - radius + x / factor, from_row = row - radius + y / factor;
    const bool inside = from_column >= 0 && from_column < picture.width && from_row >= 0 &&
                        from_row < picture.height;
    return inside ? picture.at(from_column, from_row) : Rgb8{128, 128, 128};
  });
}

/// The map of differences, and the pixels around the largest.
std::string where_they_differ(const Comparison& c, const Pictures& pictures) {
  const WorstPixel& worst = c.figures.worst;
  if (worst.levels == 0) return {};
  const auto around = [&](const DrawnStep& step, const std::string& name) {
    const Image enlarged = zoom(step.picture, worst.column, worst.row);
    return page::figure(pictures.show(enlarged, name + "_close.png"), name);
  };
  const Image map = difference_map(c.before.picture, c.after.picture);
  return "<h2>Where they differ</h2>\n" +
         page::figure(pictures.show(map, "difference.png"), "Difference in levels; black is none") +
         "<h2>Around the largest difference</h2>\n" +
         page::side_by_side({around(c.before, "before"), around(c.after, "after")});
}

std::string code_section(const Code& before, const Code& after) {
  return "<h2>The code</h2>\n" + page::code_difference(before.text, after.text);
}

/// What the step declared, and whether that is so.
std::string verdict_of(const Comparison& c) {
  const bool good = c.changed_elsewhere == 0;
  std::string found = good ? "Only what may change has changed"
                           : text("%zu pixels changed that should not have", c.changed_elsewhere);
  found += ": the step declares " + names_of(c.may_change, "no object") + ".";
  if (!good)
    found += text(" The first of them is at column %d, row %d.", c.stray_column, c.stray_row);
  return page::verdict(good, found);
}

std::string verdict_of_pictures(const Comparison& c) {
  const bool same = c.figures.pixels_different == 0;
  std::string found = same ? "The pictures are the same."
                           : "The pictures differ in " + differing_pixels(c.figures) + ".";
  if (!c.mistake.empty()) found += " " + c.mistake + ".";
  return page::verdict(same, page::escaped_foreign(found));
}

}  // namespace

page::Picture Pictures::show(const Image& image, const std::string& file) const {
  if (folder.empty()) return page::inside(image);
  const std::filesystem::path path = folder / file;
  with_name("cannot write", path,
            [&] { write_file_atomically(path, encode_png(image, Packing::close)); });
  return {page::address_of(file), image.width, image.height};
}

page::Picture Pictures::show(const DrawnStep& step, const std::string& file) const {
  if (folder.empty() || !is_directory(drawn)) return show(step.picture, file);
  const std::string chapter = step.name.substr(0, step.name.find(' '));
  std::filesystem::path own;
  for (const auto& entry : std::filesystem::directory_iterator(drawn)) {
    const std::filesystem::path& path = entry.path();
    if (path.extension() == ".png" && path.stem() <= chapter && path.stem() > own.stem() &&
        load_image(path) == step.picture) {
      own = path;
    }
  }
  return own.empty() ? show(step.picture, file) : show(own);
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
  html += code_section(before, after);
  return page::framed({"From " + before.chapter + " to " + after.chapter, {}, {}}, html);
}

std::string report_page(const Comparison& c, const Code& before, const Code& after,
                        const Pictures& pictures) {
  const bool on_stage = !c.before.objects.empty();
  auto rows = figure_rows(c.figures);
  if (on_stage)
    rows.insert(rows.begin() + 2, {"of these, elsewhere", text("%zu", c.changed_elsewhere)});
  if (c.pixels_with_uv > 0) {
    rows.push_back({"pixels with (u, v) in both", text("%zu", c.pixels_with_uv)});
    rows.push_back(
        {"largest |du|, |dv|", text("%.6g of a turn, %.6g", c.largest_du, c.largest_dv)});
  }
  std::string html = on_stage ? verdict_of(c) : verdict_of_pictures(c);
  html += "<h2>Both pictures</h2>\n";
  html += page::slider(pictures.show(c.before, "before.png"), c.before.name,
                       pictures.show(c.after, "after.png"), c.after.name);
  html += "<h2>Figures</h2>\n" + page::table(rows) + where_they_differ(c, pictures);
  if (on_stage) html += code_section(before, after);
  return page::framed({"From " + c.before.name + " to " + c.after.name, {}, page::slider_script},
                      html);
}

}  // namespace texmap::steps
