// The groups of small works: (u, v), textures, spheres, colors.
#include <cmath>
#include <numbers>
#include <random>

#include "engine/measure/text.hpp"
#include "jobs.hpp"

namespace texmap::bench {
namespace {

using Fill = void (*)(Columns& columns);

/// Adds a line with a row for each variant: a function of columns that `fill` fills.
///
/// @param rows, repeats  so few rows that all columns stay in the first cache, but for a texture's
void add_line(Group& group, const std::string& line, const std::string& set,
              std::string_view letters, const std::function<Function()>& function, Fill fill,
              const std::string& note = "", std::size_t rows = 512, int repeats = 32) {
  const auto make = [=] {
    const auto job = std::make_shared<Job>(function(), rows, repeats);
    fill(job->input);
    return job;
  };
  const double per_run = static_cast<double>(rows) * repeats;
  for (const Variant& variant : variants_of(letters))
    group.rows.push_back(row_of(line, set, variant, per_run, make, note));
}

/// Unit vectors, evenly spread over the sphere and the same each time, from a column on.
void fill_with_directions(Columns& columns, std::size_t first) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0, 1);
  for (std::size_t row = 0; row < columns.rows(); ++row) {
    const double turn = 2 * std::numbers::pi * part(random);
    const double height = 2 * part(random) - 1;
    const double radius = std::sqrt(1 - height * height);
    columns.set(first, row, radius * std::cos(turn));
    columns.set(first + 1, row, radius * std::sin(turn));
    columns.set(first + 2, row, height);
  }
}
void directions(Columns& columns) { fill_with_directions(columns, 0); }

/// Rays from 8 radii away in the direction, and then aside.
void rays_to_a_sphere(Columns& columns) {
  fill_with_directions(columns, 3);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> aside(-1.25, 1.25);
  for (std::size_t row = 0; row < columns.rows(); ++row) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      columns.set(axis, row, -8 * columns.at<double>(3 + axis)[row] + aside(random));
  }
}

/// Even steps from 0 to 1, in no order.
void parts(Columns& columns) {
  const std::size_t rows = columns.rows();
  for (std::size_t row = 0; row < rows; ++row)
    columns.set(0, row, static_cast<double>(row * 97 % rows) / static_cast<double>(rows - 1));
}

constexpr std::size_t walk_side = 128;  // look-ups along a row, and rows

/// A walk over a picture of 4096 by 2048 texels such as a globe's picture makes: one and a half
/// texels at a step.
void walk(Columns& columns) {
  for (std::size_t i = 0; i < columns.rows(); ++i) {
    const auto along = static_cast<double>(i % walk_side);
    const auto down = static_cast<double>(i / walk_side);
    columns.set(0, i, 0.4 + 1.5 * (along + 0.2 * down) / 4096);
    columns.set(1, i, 0.6 - 1.5 * (down - 0.1 * along) / 2048);
  }
}

TextureFunction noise_texture(TexelLight light, bool as_roots) {
  Image image(4096, 2048);
  std::uint32_t at = 0;
  for (Rgb8& texel : image.pixels) {
    const std::uint32_t bits = hash_bits(at++);
    texel = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
             static_cast<std::uint8_t>(bits >> 16)};
  }
  const auto exact = std::make_shared<const LightTexture>(ImageTexture{image}, light);
  return {exact, {exact.get(), as_roots ? RootTexture(*exact) : RootTexture()}};
}

/// The stated worst case of a polynomial, as in common/engine/kernels/kernel_plan.cpp.
template <class T>
std::string worst_texels(int degree) {
  return with_uv_mapping(degree, [](const auto& mapping) -> std::string {
    using Mapping = std::decay_t<decltype(mapping)>;
    if constexpr (requires { Mapping::template worst<T>; }) {
      const UvError worst = Mapping::template worst<T>;
      return text("%.1e", std::max(worst.u * 8192, worst.v * 4096));
    }
    return "";
  });
}

}  // namespace

void Job::run(const Variant& variant) const {
  run_in_number(*this, variant.number, variant.instructions);
}

Group uv_group() {
  Group group{
      .name = "uv",
      .title = "(u, v) of unit vectors",
      .text =
          "The base is Next Week's formula in double: std::atan2 and std::acos of the C library,\n"
          "one vector at a time. `uv_rtiow` is the chapters' own, safe at the poles; the\n"
          "polynomials are those of `--budget`.",
      .unit = "ns",
      .note = "worst error in texels of 8192 × 4096",
  };
  const auto add = [&](const std::string& line, int degree, const char* letters,
                       const std::string& worst) {
    add_line(
        group, line, "uv", letters, [=] { return UvFunction{degree}; }, directions, worst);
  };
  add("atan2 and acos", -1, "df", "0.3 in float at the poles");
  add("uv_rtiow", 0, "dfDF", "0.001 in float, 2e-12 in double");
  for (const int degree : {5, 9, 13, 17})
    add("degree " + std::to_string(degree), degree, "fF", worst_texels<float>(degree));
  for (const int degree : {23, 29, 35})
    add("degree " + std::to_string(degree), degree, "dD", worst_texels<double>(degree));
  return group;
}

Group texture_group() {
  Group group{
      .name = "texture",
      .title = "Look-ups in a texture",
      .text =
          "The nearest texel of a picture of 4096 × 2048, at 128 × 128 places one and a half\n"
          "texels apart. Encoded: bytes / 255; linear: light by the sRGB curve; roots: the same\n"
          "light, kept as its root in ten bits. The base is encoded, in double, one place at a\n"
          "time.",
      .unit = "ns",
  };
  const auto add = [&](const std::string& line, TexelLight light, bool as_roots) {
    add_line(
        group, line, "texture", "dfDF", [=] { return noise_texture(light, as_roots); }, walk, "",
        walk_side * walk_side, 1);
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
          "Rays from 8 radii away, of which about half meet the sphere, in no order. The base is\n"
          "the plain form in double, one ray at a time; `--spheres` chooses.",
      .unit = "ns",
      .seconds = 6,
  };
  for (const auto& [line, form] :
       {std::pair{"plain", SphereForm::plain}, std::pair{"robust", SphereForm::robust},
        std::pair{"hybrid", SphereForm::hybrid}}) {
    const SphereFunction function{{{0.1, 0.2, 0.3}, 1, form}};
    add_line(
        group, line, "spheres", "dfDF", [=] { return function; }, rays_to_a_sphere);
  }
  return group;
}

Group colors_group() {
  Group group{
      .name = "colors",
      .title = "Colors",
      .text =
          "Two subjects, the base of each its first row: Phong's power with exponent 50, against\n"
          "exp and log1p as in `highlight`; bytes of light by the sRGB curve.",
      .unit = "ns",
      .seconds = 10,
      .note = "worst error",
  };
  const auto add_power = [&](const std::string& line, int terms, const char* letters,
                             double levels) {
    const std::string worst = levels > 0 ? text("%.2g levels", levels) : "";
    add_line(
        group, "Phong's power, " + line, "power", letters, [=] { return PowerFunction{terms}; },
        parts, worst);
  };
  add_power("formula", 0, "dfDF", 0);
  add_power("8 terms", 8, "fF", PowerKernel<8>::worst_levels<float>);
  add_power("6 terms", 6, "fF", PowerKernel<6>::worst_levels<float>);
  add_power("4 terms", 4, "fF", PowerKernel<4>::worst_levels<float>);
  add_power("3 terms", 3, "fF", PowerKernel<3>::worst_levels<float>);

  const auto add_encoding = [&](const std::string& line, int terms, const char* letters,
                                const std::string& worst) {
    add_line(
        group, "sRGB byte, " + line, "sRGB", letters, [=] { return EncodeFunction{terms}; }, parts,
        worst);
  };
  add_encoding("power", -1, "df", "");
  add_encoding("exact", 0, "dfF", "0");
  add_encoding("6 terms", 6, "fF", "1 level");
  add_encoding("4 terms", 4, "fF", "1 level");
  add_encoding("3 terms", 3, "fF", "2 levels");
  return group;
}

}  // namespace texmap::bench
