// What a program with slips draws of the stage.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/files/text.hpp"
#include "slip_tables.hpp"
#include "stage.hpp"

namespace texmap::slips {

/// The slip of the light with this number; nullptr for 0. Those of the highlight are the last.
inline const mistakes::LightMistake* light_slip(int row) {
  constexpr int before = static_cast<int>(std::size(mistakes::of_light));
  if (row == 0) return nullptr;
  return row <= before ? &mistakes::of_light[row - 1] : &mistakes::of_highlight[row - 1 - before];
}

/// The rows of a place's table; of angles only how many quarters there are.
[[nodiscard]] inline const std::vector<Named>& rows_of(int place) {
  const auto all = [](const auto& table) {
    return std::vector<Named>(std::begin(table), std::end(table));
  };
  const auto lights = [] {
    std::vector<Named> rows(1);
    for (const auto& one : mistakes::of_light) rows.push_back({one.words, ""});
    for (const auto& one : mistakes::of_highlight) rows.push_back({one.words, ""});
    return rows;
  };
  static const std::array<std::vector<Named>, places> tables{
      all(of_turned),  all(of_pole), all(of_mirrored), std::vector<Named>(4), all(of_upside),
      all(of_u),       all(of_v),    all(of_texel),    all(of_reading),       all(of_squares),
      all(of_shadows), lights(),     all(of_sky),      all(of_bytes),         all(of_flip)};
  return tables.at(static_cast<std::size_t>(place));
}

/// Place and row of the first slip whose words begin so; nothing: there is none.
[[nodiscard]] inline std::optional<std::pair<int, int>> row_named(std::string_view begin) {
  for (int place = 0; place < places && !begin.empty(); ++place) {
    const std::vector<Named>& rows = rows_of(place);
    for (std::size_t row = 1; row < rows.size(); ++row) {
      if (rows[row].words != nullptr && std::string_view(rows[row].words).starts_with(begin))
        return std::pair(place, static_cast<int>(row));
    }
  }
  return {};
}

/// What a row is called. Of `degrees` the row is the angle.
[[nodiscard]] inline Slip slip_of(int place, int row) {
  if (place == degrees) {
    const std::string end = ": u begins at another place, or the globe is turned";
    if (row == 180) {
      return {"half a turn off: u begins on the other side, or the globe is turned",
              "`u + 0.5`, minus 1 from 1 on"};
    }
    if (row % 90 == 0) {  // what is drawn has another u by so much
      const double more = uv_rtiow(rotation_y(row)(Vec3d{1, 0, 0})).u - 0.5;
      return {"a quarter turn off" + end,
              more > 0 ? "`u = u - 0.25`, plus 1 below 0" : "`u = u + 0.25`, minus 1 from 1 on"};
    }
    return {text("turned by %d degrees", row) + end, ""};
  }
  const Named& named = rows_of(place).at(static_cast<std::size_t>(row));
  return {named.words, named.change};
}

/// Which row of each table, 0 for right; `degrees` is an angle, and `light` a row of light_slip.
struct Way {
  std::array<int, places> row{};
  bool on_squares = true;                   ///< whether the slips of (u, v) reach the checkerboards
  std::optional<PhongMaterial> material{};  ///< in place of the lesson's, as the picture has it
  std::optional<double> blend{};            ///< of the globe's texture with its light
};

inline Vec3d axes_of(const Way& way, const Vec3d& d) {
  Vec3d p = way.row[pole] == 1   ? Vec3d{d.z, d.x, d.y}
            : way.row[pole] == 2 ? Vec3d{d.y, d.z, d.x}
                                 : d;
  if (way.row[degrees] != 0) p = rotation_y(way.row[degrees])(p);
  if (way.row[mirrored] != 0) p.z = -p.z;
  if (way.row[upside] != 0) p.y = -p.y;
  return p;
}

/// A direction with its coordinates exchanged in a ring: y is then another axis.
constexpr Vec3d next_axes(const Vec3d& d) { return {d.y, d.z, d.x}; }
/// The direction on the globe, turned as a wrong program does.
///
/// @param turned  as it should be
inline Vec3d turned_by(int way, const RotationY& turn, const Vec3d& turned) {
  const RotationY back{turn.cosine, -turn.sine};
  const Vec3d own = back(turned);
  switch (way) {
    case not_turned:
      return own;
    case other_way:
      return back(own);
    case twice:
      return turn(turned);
    case about_x:
    case about_x_back:
      return next_axes((way == about_x ? turn : back)(next_axes(next_axes(own))));
    case about_z:
    case about_z_back:
      return next_axes(next_axes((way == about_z ? turn : back)(next_axes(own))));
    case x_overwritten: {
      const double x = turn(own).x;
      return {x, own.y, turn(Vec3d{x, own.y, own.z}).z};
    }
    case z_overwritten: {
      const double z = turn(own).z;
      return {turn(Vec3d{own.x, own.y, z}).x, own.y, z};
    }
    default:
      return turned;
  }
}

/// A program on the stage that goes some way.
class WrongProgram {
 public:
  /// @param stage  which must outlive this
  explicit WrongProgram(const StageView& stage) : stage_(stage) {}

  /// The color of a pixel, as light; not a number where it lies beyond the texture.
  [[nodiscard]] Rgb light_of(const Way& way, const Seen& seen) const {
    const auto& row = way.row;
    if (!seen.lit && row[sky] == 0) return seen.color;
    if (!seen.lit) {
      return mix(stage_.sky.below, stage_.sky.above,
                 of_sky[row[sky]].calculate(seen.height, seen.row / (stage_.height - 1.0)));
    }
    mistakes::Lit lit = *seen.lit;
    if (way.material) {
      const bool shines = lit.material.specular > 0;
      lit.material = *way.material;
      if (!shines) lit.material.specular = 0;
    }
    if (row[turned] == inward) {  // the far side is then in the shadow of its own sphere
      lit.normal = -lit.normal;
      lit.light.cosine = 0;
    }
    const bool with_shadow = row[turned] == with_light_and_shadow;  // of its own sphere, too
    if ((row[turned] == with_light || with_shadow) && seen.mapped && !seen.on_checkers) {
      const bool is_hidden = lit.light.cosine == 0 && (with_shadow || lit.cosine() > 0);
      lit.normal = stage_.turn(lit.normal);
      lit.light.cosine = is_hidden ? 0 : std::max(lit.cosine(), 0.0);
    }
    if (row[turned] == undivided) {
      lit.normal = lit.normal * seen.radius;
      lit.light.cosine *= seen.radius;
    }
    if (row[shadows] != 0) lit.light.cosine = std::max(lit.cosine(), 0.0);
    if (seen.mapped) {
      Vec3d d = seen.direction;
      const bool reached = !seen.on_checkers || way.on_squares;
      if (!seen.on_checkers) d = turned_by(row[turned], stage_.turn, d);
      if (reached && row[turned] == from_origin) d = normalize(lit.lamp - lit.to_lamp);
      if (reached && row[turned] == from_point) d = lit.lamp - lit.to_lamp;
      if (reached && row[turned] == inward) d = -d;
      if (reached && row[turned] >= undivided) d.y *= seen.radius;
      if (reached) d = axes_of(way, d);
      const double angle = std::atan2(-d.z, d.x);
      const double v = std::acos(std::clamp(-d.y, -1.0, 1.0)) / pi;
      const Uv<double> uv{of_u[reached ? row[u_form] : 0].calculate(angle, d),
                          of_v[reached ? row[v_form] : 0].calculate(v, d.y)};
      lit.color = seen.on_checkers ? square(row[squares], uv) : in_picture(way, uv);
    }
    if (way.blend && lit.on_globe) {
      return mix(gray(clamp(lit.diffuse() + lit.specular(), 0.0, 1.0)), lit.color, *way.blend);
    }
    const mistakes::LightMistake* slip = light_slip(row[light]);
    return slip == nullptr ? lit.right() : slip->shade(lit);
  }

 private:
  [[nodiscard]] Rgb square(int row, const Uv<double>& uv) const {
    const Checkerboard& board = stage_.checkers;
    const bool odd = of_squares[row].calculate(uv.u * board.squares, uv.v * board.squares);
    return odd ? board.odd : board.even;
  }
  [[nodiscard]] Rgb in_picture(const Way& way, const Uv<double>& uv) const {
    const Image& image = stage_.picture;
    const Uv<double> from = of_texel[way.row[texel]].calculate(uv, image.width, image.height);
    const auto inside = [](double x, int n) {  // NaN gives 0
      return x > 0 ? static_cast<int>(std::min(x, n - 1.0)) : 0;
    };
    const Spot at{inside(from.u, image.width), image.height - 1 - inside(from.v, image.height), uv};
    return of_reading[way.row[reading]].calculate(image, at);
  }

  const StageView& stage_;
};

}  // namespace texmap::slips
