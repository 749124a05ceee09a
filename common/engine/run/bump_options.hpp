// The options of the chapter with bumps.
#pragma once
#include <string>

#include "texture/bilinear.hpp"
#include "texture/bump.hpp"
#include "texture/light_image.hpp"
#include "texture/normal_map.hpp"

namespace texmap {

struct Offer;
class Chosen;
class CommandLine;

enum class HeightKind {
  image,  ///< of an image in (u, v)
  uv,     ///< waves in (u, v), which crowd together at the poles
  space,  ///< waves in space, which know no poles
};

enum class BumpPicture {
  globe,  ///< a globe with bumps
  sheet,  ///< eight ways to read one normal map, by three programs: bump or dent?
  poles,  ///< a pole with waves in (u, v), and with waves in space
  daily,  ///< the daily exercise's normal map, and the same as it was meant
};

struct BumpOptions {
  BumpPicture picture = BumpPicture::globe;
  HeightKind height = HeightKind::image;
  std::string image = "earth_relief.png";
  double relief = 0.06;
  BumpForm form = BumpForm::exact;
  SlopeFrom slopes = SlopeFrom::duals;
  double step = 1e-3;
  std::string normals;  ///< the file of a normal map in place of heights; empty: none
  Green green = Green::up;
  const CommandLine* declared = nullptr;  ///< where

  void declare(Offer& offer);
  /// The height image. Errors: FileError with the file and where it was looked for.
  [[nodiscard]] SharedLight load() const;
  /// The normal map as a texture of bytes / 255, without decoding.
  /// Errors: FileError as for load(); UsageError if all is gray, or most normals point inward.
  [[nodiscard]] BilinearTexture load_normals(VAxis v_axis) const;
  /// Errors: UsageError for options that do not go together.
  void check(const Chosen& chosen) const;
  /// True if the globe has its texture; waves and foreign normals are seen best in white.
  [[nodiscard]] bool paints(const Chosen& chosen) const;
  /// Gives bumps the chosen relief, form, slopes and step.
  template <class Height>
  void apply_to(Bumps<Height>& bumps) const {
    bumps.relief = relief;
    bumps.form = form;
    bumps.slopes = slopes;
    bumps.step = step;
  }
};

}  // namespace texmap
