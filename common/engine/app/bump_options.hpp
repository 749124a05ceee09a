// The options of the chapter with bumps.
#pragma once
#include <string>

#include "texture/bump.hpp"
#include "texture/light_image.hpp"

namespace texmap {

class CommandLine;

/// The heights that the chapter knows.
enum class HeightKind {
  image,  ///< of an image in (u, v)
  uv,     ///< waves in (u, v), which crowd together at the poles
  space,  ///< waves in space, which know no poles
};

/// What the chapter draws.
enum class BumpPicture {
  globe,  ///< a globe with bumps
  sheet,  ///< eight ways to read one normal map, by three programs: bump or dent?
  poles,  ///< a pole with waves in (u, v), and with waves in space
  daily,  ///< the daily exercise's normal map, and the same as it was meant
};

/// The user's choices of bumps.
struct BumpOptions {
  BumpPicture picture = BumpPicture::globe;
  HeightKind height = HeightKind::image;
  std::string image = "earth_relief.png";
  double relief = 0.06;
  BumpForm form = BumpForm::exact;
  SlopeFrom slopes = SlopeFrom::duals;
  double step = 1e-3;

  void declare(CommandLine& line);
  /// The height image. Errors: FileError with the file and where it was looked for.
  [[nodiscard]] LightImage load() const;
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
