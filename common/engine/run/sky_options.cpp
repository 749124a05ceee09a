// The options of a sky that is a picture, and the choice of how its light is gathered.
#include "engine/run/sky_options.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/draw/sample_random.hpp"
#include "engine/fast/prepared_scene.hpp"
#include "engine/files/file_error.hpp"
#include "engine/files/find_texture.hpp"
#include "engine/files/load_light.hpp"
#include "engine/files/text.hpp"
#include "engine/run/chosen.hpp"
#include "engine/run/command_line.hpp"

namespace texmap {

void SkyOptions::declare(Offer& offer) {
  CommandLine& line = offer.line;
  line.text("--sky", "FILE", name,
            "the picture of the sky, twice as wide as high: Radiance .hdr, PNG or JPEG");
  line.choice<std::optional<SkyLighting>>(
      "--light", chosen,
      {{"auto", std::nullopt},
       {"uniform", SkyLighting::uniform},
       {"cosine", SkyLighting::cosine},
       {"importance", SkyLighting::importance},
       {"mis", SkyLighting::mis},
       {"coefficients", SkyLighting::coefficients}},
      "how matte surfaces sample the sky's light; auto chooses what suits the sky");
  line.flag("--caustics", matte.caustics,
            "also draw the light that mirrors throw on matte surfaces; this is right in the mean, "
            "but leaves very bright dots");
  line.decimal("--exposure", exposure, -30, 30,
               "multiply the sky's light by 2 to this power (stops)");
  line.decimal("--degrees", degrees, -1e300, 1e300,
               "rotates the sky about the vertical axis by this angle");
  line.flag("--sky-mirrored", mirrored,
            "exchanges the picture's left and right, for panoramas that come out mirrored");
  line.choice("--filter", filter, "nearest|bilinear",
              "how the sky is read between the centers of its texels");
}

SkyNoise noise_of(const SkyLight& sky) {
  if (sky.is_constant() || !(sky.sampler.total() > 0)) return {};
  const LightImage& map = sky.picture.map();
  std::vector<OnCircle<double>> around;
  around.reserve(static_cast<std::size_t>(map.width));
  for (int column = 0; column < map.width; ++column)
    around.push_back(on_circle(0.5 - (column + 0.5) / map.width));
  std::array<double, 6> light{}, by_cosine{}, by_sky{};  // the last two are the halves of mis
  SkyNoise second;  // moments of one sample's light, summed over the axes
  std::size_t texel = 0;
  for (const SkyBand& band : sky.sampler.bands()) {
    const double below_pole = (band.from + band.to) / 2;
    const double y = band.y_sign * (1 - below_pole);
    const double radius = std::sqrt(below_pole * (2 - below_pole));
    for (const OnCircle<double>& turned : around) {
      const double density =
          static_cast<double>(sky.sampler.probabilities()[texel]) / band.solid_angle;
      const double above_mean =
          static_cast<double>(sky.above_mean.probabilities()[texel++]) / band.solid_angle;
      if (density == 0) continue;
      const std::array direction = {radius * turned.cosine, y, radius * turned.sine};
      for (std::size_t axis = 0; axis < 3; ++axis) {  // one of its two ways faces the texel
        const double lambert = std::abs(direction[axis]) / std::numbers::pi;
        if (lambert == 0) continue;
        const double sent = density * sky.sampler.total() * lambert;
        const std::size_t faces = 2 * axis + (direction[axis] < 0 ? 1 : 0);
        const double both = lambert + above_mean;
        light[faces] += sent * band.solid_angle;
        by_cosine[faces] += sent * band.solid_angle * lambert / both;
        by_sky[faces] += sent * band.solid_angle * above_mean / both;
        const double square_of_it = sent * sent * band.solid_angle;
        second.cosine += square_of_it / lambert;
        second.mis += square_of_it / both;
      }
    }
  }
  const auto squared = [](const std::array<double, 6>& of_axes) {
    return std::inner_product(of_axes.begin(), of_axes.end(), of_axes.begin(), 0.0);
  };
  const double right = squared(light);
  const auto relative = [right](double moment, double mean) {
    return std::sqrt(std::max(moment - mean, 0.0) / right);
  };
  return {relative(second.cosine, right),
          relative(second.mis, squared(by_cosine) + squared(by_sky))};
}

SkyLighting best_lighting(const SkyNoise& noise, double cost) {
  return square(noise.mis) * cost < square(noise.cosine) ? SkyLighting::mis : SkyLighting::cosine;
}

SkyLight SkyOptions::load(const Chosen& user) {
  std::string note;
  LightImage map = load_light(find_texture(name), &note);
  if (!note.empty()) user.note(name + " " + note + "\n");
  if (mirrored) {
    for (auto row = map.pixels.begin(); row != map.pixels.end(); row += map.width)
      std::reverse(row, row + map.width);
  }
  const auto factor = static_cast<float>(pow(2.0, exposure));
  for (Color<float>& texel : map.pixels) texel = texel * factor;
  Environment picture(std::move(map), filter, degrees);
  if (picture.map().width % 2 != 0 && !picture.is_constant()) {
    throw FileError("cannot load texture '" + name + "': it is " +
                    std::to_string(picture.map().width) +
                    " pixels wide, and the width of a sky must be even");
  }
  SkyLight sky(std::move(picture));
  if (chosen) {
    matte.way = *chosen;
    return sky;
  }
  const SkyNoise noise = noise_of(sky);
  matte.way = best_lighting(noise);
  user.say(
      text("the error of one sample is %s times the right light by cosine, %s by mis: --light %s\n",
           shown(noise.cosine, 3).c_str(), shown(noise.mis, 3).c_str(),
           matte.way == SkyLighting::mis ? "mis" : "cosine"));
  return sky;
}

template TEXMAP_TWO_WIDTHS TEXMAP_FLATTEN Color<double> light_under_sky(
    const std::vector<PreparedObject<double, Coat>>&, Ray<double>, const SkyLight&,
    const MatteLight&, int, SampleRandom<double>&);

}  // namespace texmap
