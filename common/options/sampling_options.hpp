// The options of chapters that gather light over many samples.
#pragma once
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <memory>

#include "gather.hpp"
#include "image_texture.hpp"
#include "srgb_kernel.hpp"
#include "standard_streams.hpp"
#include "studio.hpp"

namespace texmap {

/// How an amount of light becomes a byte.
enum class Transfer {
  srgb,  ///< the curve that screens and files follow
  sqrt,  ///< the books' gamma 2
  stb,   ///< the power 1/2.2, which stb_image undoes
};

/// The byte of an amount of light, rounded to the nearest; the books' square root is cut off, as they do it.
///
/// @param light  any number; below 0 and NaN give 0, above 1 gives 255
/// @param terms  of the polynomial for the sRGB curve: 6 or 4, at most a level off, or 3, at most two; 0 for the exact curve
[[nodiscard]] inline std::uint8_t byte_of_light(double light, Transfer transfer, int terms = 0) {
  const double linear = clamp(light, 0.0, 1.0);
  if (transfer == Transfer::sqrt) return static_cast<std::uint8_t>(256 * std::min(std::sqrt(linear), 0.999));
  if (transfer == Transfer::stb) return static_cast<std::uint8_t>(std::lround(255 * std::pow(linear, 1 / 2.2)));
  return static_cast<std::uint8_t>(terms == 3   ? srgb_byte<3>(linear)
                                   : terms == 4 ? srgb_byte<4>(linear)
                                   : terms == 6 ? srgb_byte<6>(linear)
                                                : srgb_byte_exact(linear));
}

/// The picture that a film shows; `terms` as for byte_of_light.
[[nodiscard]] inline Image develop(const Film& film, Transfer transfer, int terms = 0) {
  Image image(film.width(), film.height());
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      const Rgb light = film.light(column, row);
      image.at(column, row) = {byte_of_light(light.r, transfer, terms), byte_of_light(light.g, transfer, terms),
                               byte_of_light(light.b, transfer, terms)};
    }
  }
  return image;
}

/// What the user can say about samples and light.
struct SamplingOptions {
  SamplerKind sampler = SamplerKind::sobol;
  int seed = 0;
  int bounces = 50;
  double time_limit = 0;    ///< seconds; 0 for none
  double target_error = 0;  ///< in levels of 255; 0 for none
  TexelLight decoding = TexelLight::linear;
  Transfer transfer = Transfer::srgb;
  int srgb_terms = 0;  ///< see byte_of_light; a budget may choose fewer than all

  void declare(CommandLine& line) {
    line.choice<SamplerKind>("--sampler", sampler,
                             {{"random", SamplerKind::random},
                              {"stratified", SamplerKind::stratified},
                              {"multi-jitter", SamplerKind::multi_jitter},
                              {"sobol", SamplerKind::sobol}},
                             "how samples are spread; --samples says how many");
    line.whole("--seed", seed, 0, 1000000000, "another number draws the same light with other errors");
    line.whole("--bounces", bounces, 1, 1000, "how often a path may bounce");
    line.decimal("--time-limit", time_limit, 0, 1e6, "stop after so many seconds; --samples is then the most");
    line.decimal("--target-error", target_error, 0, 255, "stop when the mean error is below so many levels of 255");
    line.choice<TexelLight>(
        "--decode", decoding, {{"srgb", TexelLight::linear}, {"stb", TexelLight::stb}, {"raw", TexelLight::encoded}},
        "from the texture's bytes to light: the sRGB curve, the book's power 2.2 in bytes, or the bytes as they are");
    line.choice<Transfer>("--gamma", transfer, {{"srgb", Transfer::srgb}, {"sqrt", Transfer::sqrt}, {"2.2", Transfer::stb}},
                          "from light to bytes: the sRGB curve, the books' square root, or the power 1/2.2");
  }

  /// Gathers a lesson's light: one pattern of samples, or, if there is a limit, pairs of patterns that double in size until it
  /// is reached. The two of a pair know nothing of each other, so that their difference tells the error, at the price of some
  /// of the evenness of one pattern twice as large.
  template <class Lesson>
  [[nodiscard]] Image gather(Studio& studio, Lesson& lesson) const {
    const auto start = std::chrono::steady_clock::now();
    const bool limited = time_limit > 0 || target_error > 0;
    const int most = limited && !studio.typed("--samples") ? 1 << 20 : studio.samples;
    const auto shared = std::make_shared<Film>(studio.width, studio.height);  // the remark may outlive this function
    Film& film = *shared;
    auto pattern = static_cast<std::uint32_t>(seed);
    studio.remark = [shared]() -> std::string {
      const double error = shared->error_so_far();
      if (!(error < infinity<double>())) return {};
      std::array<char, 60> text{};
      std::snprintf(text.data(), text.size(), ", mean error %.2f levels so far", 255 * error);
      return text.data();
    };
    const auto draw = [&](int count, int in_first_half) {
      lesson.gathering = {Sampler(sampler, count, pattern++), in_first_half, &film};
      studio.samples = count;
      (void)studio.draw(lesson);
      film.count(in_first_half, count - in_first_half);
    };
    if (!limited) draw(most, most / 2);
    for (int pair = 8; limited && film.samples() + 2L * pair <= most; pair = std::min(2 * pair, most_samples)) {
      draw(pair, pair);
      draw(pair, 0);
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      if (target_error > 0 && film.error() * 255 <= target_error) break;
      if (time_limit > 0 && 3 * seconds > time_limit) break;  // the next pair takes twice as long as all before
    }
    studio.remark = {};
    if (!studio.quiet) {
      std::array<char, 100> text{};
      if (film.error() < infinity<double>()) {
        std::snprintf(text.data(), text.size(), "%ld samples a pixel, mean error %s %.2f levels of 255\n", film.samples(),
                      limited ? "about" : "at most about", film.error() * 255);
      } else {
        std::snprintf(text.data(), text.size(), "%ld sample a pixel, which cannot tell its error\n", film.samples());
      }
      print(text.data());
    }
    return develop(film, transfer, srgb_terms);
  }
};

}  // namespace texmap
