// The live page of chapter 09: compares two filters, shows the texels that a filter reads, and
// draws the usual mistakes.
#pragma once
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "09_texture_filtering/sheet.hpp"

namespace texmap::chapter_09 {

struct Lesson;
/// Without a budget: a page chooses the filter by its knob.
inline void choose_scene(Lesson& lesson, Chosen& chosen);

}  // namespace texmap::chapter_09

#include "09_texture_filtering/lesson.hpp"

inline void texmap::chapter_09::choose_scene(Lesson& lesson, Chosen&) { keep_scene(lesson); }

#include "figure.hpp"
#include "live.hpp"
#include "math/srgb.hpp"

namespace texmap::live {

/// A read of a texel: where it is on level 0, in texels, and its weight.
struct TexelRead {
  double x, y, wide, high, weight;
};

/// A pyramid without texels that writes down what is read. A filter is linear in the texels' light,
/// so its result with light 1 in one read and 0 in all others is the weight of that read.
struct ProbedPyramid : Pyramid {
  std::vector<TexelRead>* reads = nullptr;
  std::size_t* number = nullptr;  ///< of the next read
  std::size_t lit = 0;
};
template <class Real>
Color<Real> texel_light(const ProbedPyramid& pyramid, const PyramidLevel<Real>& level,
                        const Real& column, const Real& row) {
  const PyramidLevel<int>& whole = pyramid.levels.front();
  const double wide = whole.width / level.width, high = whole.height / level.height;
  const std::size_t number = (*pyramid.number)++;
  if (number == pyramid.reads->size())
    pyramid.reads->push_back({column * wide, row * high, wide, high, 0});
  return gray(Real(number == pyramid.lit ? 1 : 0));
}

/// The reads of a filter at a pixel's (u, v), with their weights.
[[nodiscard]] inline std::vector<TexelRead> reads_of(const FilteredTexture& texture, Filter filter,
                                                     const Uv<Dual<double>>& uv) {
  std::vector<TexelRead> reads;
  std::size_t number = 0;
  Filtered<ProbedPyramid> probe;
  probe.pyramid.levels = texture.pyramid.levels;
  probe.pyramid.reads = &reads;
  probe.pyramid.number = &number;
  probe.filter = filter;
  probe.wrap = texture.wrap;
  probe.taps = texture.taps;
  probe.v_axis = texture.v_axis;
  for (std::size_t i = 0; i == 0 || i < reads.size(); ++i) {
    number = 0;
    probe.pyramid.lit = i;
    const double weight = probe.filtered(uv).r;
    reads[i].weight = weight;
  }
  return reads;
}

/// What a program with a mistake takes for a pixel. To add one, add its row and the one in
/// `of_pages` of option_slips.hpp.
struct WrongPixel {
  const char* name;
  double across = 1, down = 1;      ///< by which the slopes of its column and row are multiplied
  bool has_means_of_bytes = false;  ///< in the pyramid's levels
};
inline constexpr WrongPixel wrong_pixels[] = {
    {"twice", 2, 2},       {"half", 0.5, 0.5},
    {"right-alone", 1, 0}, {"no-texels", 0, 0},  // so much less than a texel that it is nothing
    {"bytes", 1, 1, true},
};

/// The lesson with the pixels of a mistake.
struct WithPixel : chapter_09::Lesson {
  WrongPixel pixel{};

  template <class Real>
  Color<Real> operator()(Ray<Real> ray) const {
    if constexpr (requires { ray.direction.x.dx; }) {
      for (Real* one : {&ray.direction.x, &ray.direction.y, &ray.direction.z}) {
        one->dx *= static_cast<decltype(one->dx)>(pixel.across);
        one->dy *= static_cast<decltype(one->dy)>(pixel.down);
      }
    }
    return chapter_09::Lesson::operator()(ray);
  }
};

/// A pyramid of the same texels; the other levels are means of bytes.
[[nodiscard]] inline Pyramid with_means_of_bytes(const Pyramid& right) {
  const auto by = [](auto curve) {
    return [curve](const Color<float>& c) {
      return Color<float>{curve(c.r), curve(c.g), curve(c.b)};
    };
  };
  Pyramid wrong = pyramid_of(image_of(right.original.width, right.original.height,
                                      [&, encoded = by(srgb_encode<float>)](int column, int row) {
                                        return encoded(right.original.at(column, row));
                                      }));
  LightImage smaller = wrong.smaller;
  std::transform(smaller.pixels.begin(), smaller.pixels.end(), smaller.pixels.begin(),
                 by(srgb_decode<float>));
  wrong.original = right.original;
  wrong.smaller = std::move(smaller);
  return wrong;
}

struct TwoFilters {
  Filter other = Filter::nearest;
  const WrongPixel* mistake = nullptr;

  void declare(CommandLine& line) {
    declare_mistakes(line, mistake, wrong_pixels);
    line.choice("--beside", other, "nearest|bilinear|trilinear|anisotropic|ewa|stochastic",
                "the filter left of the line");
  }
  /// Takes what the lesson before has loaded, if only how it is read has changed: a pyramid takes
  /// longer than a picture.
  static bool take_over(WithPixel& lesson, WithPixel& before) {
    const auto loaded = [](const chapter_09::Lesson& one) {
      return std::tie(one.texture.name, one.filtering.floor_file, one.filtering.wrap,
                      one.filtering.scene);
    };
    if (loaded(lesson) != loaded(before) || before.pixel.has_means_of_bytes) return false;
    lesson.stage = before.stage;
    lesson.objects.swap(before.objects);
    std::swap(lesson.ground, before.ground);
    read_by(lesson, lesson.filtering.filter, lesson.filtering.taps);
    return true;
  }

  void apply(WithPixel& lesson) const {
    if (mistake == nullptr) return;
    lesson.pixel = *mistake;
    if (!mistake->has_means_of_bytes) return;
    const auto make_wrong = [](auto& painted) {
      painted.pyramid = with_means_of_bytes(painted.pyramid);
    };
    make_wrong(lesson.ground.texture);
    for (auto& object : lesson.objects) make_wrong(object.paint.texture);
  }

  [[nodiscard]] Size size_beside(const chapter_09::Lesson& /*lesson*/, const Size& size) const {
    return size;
  }
  [[nodiscard]] Image draw_beside(WithPixel& lesson, const View<>& strip, int /*first*/,
                                  const RenderSettings& how) const {
    const auto [filter, taps] = std::pair(lesson.filtering.filter, lesson.filtering.taps);
    read_by(lesson, other, taps);
    Image drawn = render<double>(lesson, strip, how);
    read_by(lesson, filter, taps);
    return drawn;
  }

  template <class State>
  [[nodiscard]] Members look(const State& state, int column, int row) const {
    const chapter_09::Lesson& lesson = state.lesson;
    using Number = Dual<double>;
    const Ray<Number> ray =
        ray_through(state.whole, Number{double(column), 1.0, 0.0}, Number{double(row), 0.0, 1.0});
    const Ray<double> middle = ray_through(state.whole, double(column), double(row));
    const Surface<double> seen = surface_along(lesson, middle);
    if (seen.object < 0) return {{"rows", Json::list({fact({"hit", "nothing: the sky"})})}};
    const bool is_floor = seen.object == static_cast<int>(lesson.objects.size());
    if (is_floor) {
      return both(lesson.ground.texture, lesson.ground.mapping(point_on(
                                             lesson.floor, ray, distance_to(lesson.floor, ray))));
    }
    const auto& globe = lesson.objects[static_cast<std::size_t>(seen.object)];
    return both(globe.paint.texture,
                globe.paint.mapping(normal_at(globe.shape, ray, distance_to(globe.shape, ray))));
  }

 private:
  /// What the chosen filter reads, and left of the line the other.
  [[nodiscard]] Members both(const FilteredTexture& texture, const Uv<Dual<double>>& uv) const {
    Members all = facts(texture, texture.filter, uv);
    all.emplace_back("left", Json::object(facts(texture, other, uv)));
    return all;
  }
  [[nodiscard]] static Members facts(const FilteredTexture& texture, Filter filter,
                                     const Uv<Dual<double>>& uv) {
    const PyramidLevel<int>& whole = texture.pyramid.levels.front();
    const auto footprint = footprint_of<double>(uv, whole.width, whole.height);
    std::vector<TexelRead> reads = reads_of(texture, filter, uv);
    const bool up = texture.v_axis == VAxis::up;
    const auto in_texels = [](const Dual<double>& x, double n) {
      return Vec3d{(x.value - std::floor(x.value)) * n, x.dx * n, x.dy * n};
    };
    const Vec3d x = in_texels(uv.u, whole.width);
    Vec3d y = in_texels(up ? Dual<double>(1.0) - uv.v : uv.v, whole.height);
    double heaviest = 0, reach = 2;
    for (TexelRead& read : reads) {  // the copy of the picture that is nearest to the pixel
      read.x += whole.width * std::round((x.x - read.x - read.wide / 2) / whole.width);
      read.y += whole.height * std::round((y.x - read.y - read.high / 2) / whole.height);
      heaviest = std::max(heaviest, std::abs(read.weight) / (read.wide * read.high));
      reach = std::max({reach, std::abs(read.x - x.x), std::abs(read.y - y.x),
                        std::abs(read.x + read.wide - x.x), std::abs(read.y + read.high - y.x)});
    }
    const double across = (std::abs(x.y) + std::abs(x.z)) / 2;
    const double down = (std::abs(y.y) + std::abs(y.z)) / 2;
    reach = 1.1 * std::max({reach, std::min(across, 4096.0), std::min(down, 4096.0)});
    Figure figure{"Texels read, bluer where they weigh more; the outline is the pixel", 2 * reach,
                  2 * reach};
    const double left = x.x - reach, top = y.x - reach;
    for (const TexelRead& read : reads) {
      const double share = std::abs(read.weight) / (read.wide * read.high) / heaviest;
      figure.box(read.x - left, read.y - top, read.wide, read.high,
                 "rgba(80,140,220," + std::to_string(0.15 + 0.7 * share) + ")");
    }
    const double corners[][2] = {{-.5, -.5}, {.5, -.5}, {.5, .5}, {-.5, .5}, {-.5, -.5}};
    for (int i = 0; i < 4; ++i) {
      const auto at = [&](const Vec3d& c, const double* p) {
        return c.x + p[0] * c.y + p[1] * c.z;
      };
      figure.line(at(x, corners[i]) - left, at(y, corners[i]) - top, at(x, corners[i + 1]) - left,
                  at(y, corners[i + 1]) - top, "ink");
    }
    const char* texels = reads.size() == 1 ? " texel of the pyramid" : " texels of the pyramid";
    return {{"rows", Json::list({fact({"u, v", uv.u.value, ", ", uv.v.value}),
                                 fact({"footprint", footprint.longer, " × ", footprint.shorter,
                                       " texels of ", whole.width, " × ", whole.height}),
                                 fact({"reads", static_cast<int>(reads.size()), texels})})},
            {"figure", figure.json()}};
  }
};

using Chapter09 = Live<WithPixel, TwoFilters>;

}  // namespace texmap::live
