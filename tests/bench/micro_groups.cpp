// The groups of small works: (u, v), textures, spheres, samplers, colors.
#include <cmath>

#include "engine/measure/text.hpp"
#include "make_rows.hpp"

namespace texmap::bench {
namespace {

constexpr std::size_t rows = 512;  // so few that all columns stay in the first cache
constexpr int repeats = 32;
constexpr double items = static_cast<double>(rows) * repeats;

/// Adds a line with a row for each variant.
template <class Make, class... Variants>
void add_line(Group& group, const std::string& line, const std::string& set, double per_run,
              const Make& make, const std::string& note, const Variants&... variants) {
  const auto add = [&](const Variant& variant) {
    group.rows.push_back(row_of(line, set, variant, per_run, make, note));
  };
  const auto add_all = [&](const auto& one_or_more) {
    if constexpr (requires { one_or_more.size(); }) {
      for (const Variant& variant : one_or_more) add(variant);
    } else {
      add(one_or_more);
    }
  };
  (add_all(variants), ...);
}

/// A job on `inputs` columns that `fill` fills.
template <class Job, class Fill>
[[nodiscard]] std::shared_ptr<WithColumns<Job>> with_columns(Job job, std::size_t inputs,
                                                             std::size_t outputs,
                                                             const Fill& fill) {
  auto ready = std::make_shared<WithColumns<Job>>(
      WithColumns<Job>{Columns(inputs, rows), Columns(outputs, rows), job});
  fill(ready->input);
  ready->job.input = &ready->input;
  ready->job.output = &ready->output;
  return ready;
}

std::string texels(const UvError& worst) {
  return text("%.1e", std::max(worst.u * 8192, worst.v * 4096));
}

/// The stated worst case of a polynomial, as in common/engine/kernels/kernel_plan.cpp.
template <int Degree, class T>
std::string worst_texels() {
  return texels(FastUnitMapping<Degree>::template worst<T>);
}

}  // namespace

Group uv_group() {
  Group group{
      .name = "uv",
      .title = "(u, v) of unit vectors",
      .text =
          "The base is Next Week's formula in double: std::atan2 and std::acos of the C library, "
          "one vector at a time. `uv_rtiow` is the chapters' own, safe at the poles; the "
          "polynomials are those of `--budget`.",
      .unit = "ns",
      .note = "worst error in texels of 8192 × 4096",
  };
  const auto add = [&group](const std::string& line, UvJob::Formula formula, int degree,
                            const std::string& worst, const auto&... variants) {
    const auto make = [=] {
      const UvJob job{formula, degree, nullptr, nullptr, repeats};
      return with_columns(job, 3, 2, [](Columns& columns) { fill_with_directions(columns, 0); });
    };
    add_line(group, line, "uv", items, make, worst, variants...);
  };
  add("atan2 and acos", UvJob::next_week, 0, "0.3 in float at the poles", in_double, in_float);
  add("uv_rtiow", UvJob::stable, 0, "0.001 in float, 2e-12 in double", in_double, in_float,
      in_double_packs, in_float_packs);
  add("degree 5", UvJob::polynomial, 5, worst_texels<5, float>(), in_float, in_float_packs);
  add("degree 9", UvJob::polynomial, 9, worst_texels<9, float>(), in_float, in_float_packs);
  add("degree 13", UvJob::polynomial, 13, worst_texels<13, float>(), in_float, in_float_packs);
  add("degree 17", UvJob::polynomial, 17, worst_texels<17, float>(), in_float, in_float_packs);
  add("degree 23", UvJob::polynomial, 23, worst_texels<23, double>(), in_double, in_double_packs);
  add("degree 29", UvJob::polynomial, 29, worst_texels<29, double>(), in_double, in_double_packs);
  add("degree 35", UvJob::polynomial, 35, worst_texels<35, double>(), in_double, in_double_packs);
  return group;
}

namespace {

constexpr std::size_t walk_side = 128;  // look-ups along a row, and rows

/// A picture of 4096 by 2048 texels, and a walk over it such as a globe's picture makes: one and a
/// half texels at a step.
struct TextureWork {
  LightTexture exact;
  PlannedTexture texture{&exact};
  Columns input, output;

  TextureWork(TexelLight light, bool as_roots)
      : input(2, walk_side * walk_side), output(1, walk_side * walk_side) {
    Image image(4096, 2048);
    for (int row = 0; row < image.height; ++row) {
      for (int column = 0; column < image.width; ++column) {
        const std::uint32_t bits =
            hash_bits(static_cast<std::uint32_t>(row * image.width + column));
        image.at(column, row) = {static_cast<std::uint8_t>(bits),
                                 static_cast<std::uint8_t>(bits >> 8),
                                 static_cast<std::uint8_t>(bits >> 16)};
      }
    }
    exact = {{image}, light};
    if (as_roots) texture.roots = RootTexture(exact);
    for (std::size_t i = 0; i < input.rows(); ++i) {
      const auto along = static_cast<double>(i % walk_side);
      const auto down = static_cast<double>(i / walk_side);
      input.set(0, i, 0.4 + 1.5 * (along + 0.2 * down) / 4096);
      input.set(1, i, 0.6 - 1.5 * (down - 0.1 * along) / 2048);
    }
  }
  void run(const Variant& variant) { bench::run(TextureJob{&texture, &input, &output}, variant); }
};

}  // namespace

Group texture_group() {
  Group group{
      .name = "texture",
      .title = "Look-ups in a texture",
      .text =
          "The nearest texel of a picture of 4096 × 2048, at 128 × 128 places one and a half "
          "texels apart. Encoded: bytes / 255; linear: light by the sRGB curve; roots: the same "
          "light, kept as its root in ten bits. The base is encoded, in double, one place at a "
          "time.",
      .unit = "ns",
  };
  const auto add = [&group](const std::string& line, TexelLight light, bool as_roots) {
    add_line(
        group, line, "texture", static_cast<double>(walk_side * walk_side),
        [=] { return std::make_shared<TextureWork>(light, as_roots); }, "", in_double, in_float,
        in_double_packs, in_float_packs);
  };
  add("encoded", TexelLight::encoded, false);
  add("linear", TexelLight::linear, false);
  add("roots", TexelLight::linear, true);
  return group;
}

Group spheres_group() {
  Group group{
      .name = "spheres",
      .title = "The first point of a sphere along a ray",
      .text =
          "Rays from 8 radii away, of which about half meet the sphere, in no order. The base is "
          "the plain form in double, one ray at a time; `--spheres` chooses.",
      .unit = "ns",
      .seconds = 6,
  };
  const auto add = [&group](const std::string& line, SphereForm form) {
    const auto make = [form] {
      const SphereJob job{Sphere<>{{0.1, 0.2, 0.3}, 1, form}, nullptr, nullptr, repeats};
      return with_columns(job, 6, 1, [](Columns& columns) {
        fill_with_directions(columns, 3);
        std::mt19937 random(8);
        std::uniform_real_distribution<double> aside(-1.25, 1.25);
        for (std::size_t row = 0; row < columns.rows(); ++row) {
          // From 8 radii away in the direction, and then aside.
          for (std::size_t axis = 0; axis < 3; ++axis) {
            columns.set(axis, row, -8 * columns.at<double>(3 + axis)[row] + aside(random));
          }
        }
      });
    };
    add_line(group, line, "spheres", items, make, "", in_double, in_float, in_double_packs,
             in_float_packs);
  };
  add("plain", SphereForm::plain);
  add("robust", SphereForm::robust);
  add("hybrid", SphereForm::hybrid);
  return group;
}

namespace {

struct SamplerWork {
  Sampler sampler;
  Columns output{1, 64};

  explicit SamplerWork(SamplerKind kind) : sampler(kind, 64) {}
  void run(const Variant& variant) { bench::run(SamplerJob{&sampler, &output}, variant); }
};

}  // namespace

Group samplers_group() {
  Group group{
      .name = "samplers",
      .title = "Pairs of numbers from the samplers",
      .text = "64 samples per pixel. The base is `random` in float, one pixel at a time.",
      .unit = "ns",
      .seconds = 6,
  };
  const auto add = [&group](const std::string& line, SamplerKind kind) {
    add_line(
        group, line, "samplers", 64.0 * 64, [kind] { return std::make_shared<SamplerWork>(kind); },
        "", in_float, in_double_packs, in_float_packs);
  };
  add("random", SamplerKind::random);
  add("stratified", SamplerKind::stratified);
  add("multi-jitter", SamplerKind::multi_jitter);
  add("sobol", SamplerKind::sobol);
  return group;
}

namespace {

/// Even steps from 0 to 1, in no order.
void fill_with_parts(Columns& columns) {
  for (std::size_t row = 0; row < columns.rows(); ++row) {
    columns.set(
        0, row,
        static_cast<double>(row * 97 % columns.rows()) / static_cast<double>(columns.rows() - 1));
  }
}

}  // namespace

Group colors_group() {
  Group group{
      .name = "colors",
      .title = "Colors and squares",
      .text =
          "Three subjects, the base of each its first row: bytes of light by the sRGB curve; "
          "Phong's power with exponent 50, against exp and log1p as in `highlight`; the squares "
          "of a checkerboard on a globe, with (u, v) by trigonometry.",
      .unit = "ns",
      .seconds = 10,
      .note = "worst error",
  };
  const auto add_encoding = [&group](const std::string& line, int terms, const std::string& worst,
                                     const auto&... variants) {
    const auto make = [terms] {
      return with_columns(EncodeJob{terms, nullptr, nullptr, repeats}, 1, 1, fill_with_parts);
    };
    add_line(group, line, "sRGB", items, make, worst, variants...);
  };
  add_encoding("sRGB byte, power", -1, "", in_double, in_float);
  add_encoding("sRGB byte, exact", 0, "0", in_double, in_float, in_float_packs);
  add_encoding("sRGB byte, 6 terms", 6, "1 level", in_float, in_float_packs);
  add_encoding("sRGB byte, 4 terms", 4, "1 level", in_float, in_float_packs);
  add_encoding("sRGB byte, 3 terms", 3, "2 levels", in_float, in_float_packs);

  const auto add_power = [&group](const std::string& line, int terms, const std::string& worst,
                                  const auto&... variants) {
    const auto make = [terms] {
      return with_columns(PowerJob{50, terms, nullptr, nullptr, repeats}, 1, 1, fill_with_parts);
    };
    add_line(group, line, "power", items, make, worst, variants...);
  };
  const auto levels = [](double worst) { return text("%.2g levels", worst); };
  add_power("Phong's power, formula", 0, "", in_double, in_float, in_double_packs, in_float_packs);
  add_power("Phong's power, 8 terms", 8, levels(PowerKernel<8>::worst_levels<float>), in_float,
            in_float_packs);
  add_power("Phong's power, 6 terms", 6, levels(PowerKernel<6>::worst_levels<float>), in_float,
            in_float_packs);
  add_power("Phong's power, 4 terms", 4, levels(PowerKernel<4>::worst_levels<float>), in_float,
            in_float_packs);
  add_power("Phong's power, 3 terms", 3, levels(PowerKernel<3>::worst_levels<float>), in_float,
            in_float_packs);

  const auto checker = [] {
    return with_columns(CheckerJob{nullptr, nullptr, repeats}, 3, 1,
                        [](Columns& columns) { fill_with_directions(columns, 0); });
  };
  add_line(group, "checkerboard, trigonometry", "checkerboard", items, checker, "", in_double,
           in_float, in_double_packs, in_float_packs);
  return group;
}

}  // namespace texmap::bench
