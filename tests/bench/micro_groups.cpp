// The groups of small works: (u, v), textures, spheres, colors.
#include <cmath>
#include <numbers>
#include <random>

#include "engine/measure/text.hpp"
#include "jobs.hpp"

namespace texmap::bench {
namespace {

/// Adds lines about one subject, each with a row for each variant: a function of columns that
/// `fill` fills.
struct Lines {
  Group& group;
  const char* set;
  void (*fill)(Columns& columns);
  std::size_t rows = 512;  ///< so few that all columns stay in the first cache, but for a texture's
  int repeats = 32;

  void operator()(const std::string& line, std::string_view letters, const std::string& note,
                  const std::function<Function()>& function) const {
    const auto make = [function, lines = *this] {
      const auto job = std::make_shared<Job>(function(), lines.rows, lines.repeats);
      lines.fill(job->input);
      return job;
    };
    const double per_run = static_cast<double>(rows) * repeats;
    for (const Variant& variant : variants_of(letters))
      group.rows.push_back(row_of(line, set, variant, per_run, make, note));
  }
};

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
  Group group = described("uv");
  const Lines add{group, "uv", directions};
  add("atan2 and acos", "df", "0.3 in float at the poles", [] { return UvFunction{-1}; });
  add("uv_rtiow", "dfDF", "0.001 in float, 2e-12 in double", [] { return UvFunction{0}; });
  for (const int degree : {5, 9, 13, 17, 23, 29, 35}) {
    const bool for_float = degree < 20;
    add("degree " + std::to_string(degree), for_float ? "fF" : "dD",
        for_float ? worst_texels<float>(degree) : worst_texels<double>(degree),
        [=] { return UvFunction{degree}; });
  }
  return group;
}

Group texture_group() {
  Group group = described("texture");
  const Lines add{group, "texture", walk, walk_side * walk_side, 1};
  add("encoded", "dfDF", "", [] { return noise_texture(TexelLight::encoded, false); });
  add("linear", "dfDF", "", [] { return noise_texture(TexelLight::linear, false); });
  add("roots", "dfDF", "", [] { return noise_texture(TexelLight::linear, true); });
  return group;
}

Group spheres_group() {
  Group group = described("spheres");
  const Lines add{group, "spheres", rays_to_a_sphere};
  using enum SphereForm;
  for (const auto& [line, form] :
       {std::pair{"plain", plain}, std::pair{"robust", robust}, std::pair{"hybrid", hybrid}})
    add(line, "dfDF", "", [form = form] { return SphereFunction{{{0.1, 0.2, 0.3}, 1, form}}; });
  return group;
}

Group colors_group() {
  Group group = described("colors");
  const Lines power{group, "power", parts};
  power("Phong's power, formula", "dfDF", "", [] { return PowerFunction{0}; });
  const auto add_powers = [&]<int... terms>(std::integer_sequence<int, terms...>) {
    (power(text("Phong's power, %d terms", terms), "fF",
           text("%.2g levels", PowerKernel<terms>::template worst_levels<float>),
           [] { return PowerFunction{terms}; }),
     ...);
  };
  add_powers(std::integer_sequence<int, 8, 6, 4, 3>());

  const Lines encoding{group, "sRGB", parts};
  encoding("sRGB byte, power", "df", "", [] { return EncodeFunction{-1}; });
  encoding("sRGB byte, exact", "dfF", "0", [] { return EncodeFunction{0}; });
  for (const int terms : {4, 3}) {
    encoding(text("sRGB byte, %d terms", terms), "fF", terms == 3 ? "2 levels" : "1 level",
             [=] { return EncodeFunction{terms}; });
  }
  return group;
}

}  // namespace texmap::bench
