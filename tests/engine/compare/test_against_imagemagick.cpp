// Our figures against those of ImageMagick 6, where it is installed.
#include <doctest.h>

#include <string>

#include "engine/compare/difference.hpp"
#include "engine/compare/other_tools.hpp"
#include "engine/measure/text.hpp"
#include "engine/picture/save_png.hpp"
#include "support/running.hpp"
#include "support/temporary_folder.hpp"

using namespace texmap;
using namespace texmap::test;

TEST_CASE("MAE, RMSE and PSNR are those of ImageMagick") {
  // Version 7 prints another format. SSIM is not compared: version 6 has none, and version 7
  // includes windows beyond the edges.
  if (run("compare -version | grep -q 'ImageMagick 6'").status != 0)
    return skip("there is no ImageMagick 6 here");
  for (const Pair& pair : pairs()) {
    CAPTURE(pair.name);
    const TemporaryFolder folder;
    save_png(pair.a, folder / "a.png");
    save_png(pair.b, folder / "b.png");
    const auto theirs = [&folder](const std::string& metric) {
      return run("cd '" + folder.path() + "' && MAGICK_PRECISION=15 compare -metric " + metric +
                 " a.png b.png null:")
          .err;
    };
    // "1234.5 (0.0188)": in 65535ths, and in brackets as a share of the whole range.
    const auto share = [&theirs](const std::string& metric) {
      const std::string text = theirs(metric);
      return number(text.substr(text.find('(') + 1));
    };
    const Figures ours = measure(pair.a, pair.b);
    // Both are doubles all the way; sums of a million terms may differ in the thirteenth digit.
    CHECK(share("MAE") * 255 == doctest::Approx(ours.mean_absolute_error).epsilon(1e-12));
    CHECK(share("RMSE") * 255 == doctest::Approx(ours.root_mean_square_error).epsilon(1e-12));
    CHECK(number(theirs("PSNR")) == doctest::Approx(ours.peak_signal_to_noise).epsilon(1e-12));
    CHECK(number(theirs("AE")) == static_cast<double>(ours.pixels_different));
  }
}

TEST_CASE("our PNG files are read without a warning, and with the same pixels") {
  if (run("identify -version && compare -version").status != 0)
    return skip("there is no ImageMagick here");
  for (const Pair& pair : pairs()) {
    CAPTURE(pair.name);
    const TemporaryFolder folder;
    save_png(pair.a, folder / "a.png");
    const Outcome identified = run("identify -regard-warnings '" + (folder / "a.png") + "'");
    CHECK(identified.status == 0);
    CHECK(identified.err == "");
    // The same pixels in the simplest of all formats, which needs no decoder.
    std::string plain = text("P6 %d %d 255\n", pair.a.width, pair.a.height);
    for (const Rgb8& pixel : pair.a.pixels) {
      for (const std::uint8_t channel : {pixel.r, pixel.g, pixel.b})
        plain.push_back(static_cast<char>(channel));
    }
    put(folder / "a.ppm", {plain.begin(), plain.end()});
    CHECK(run("cd '" + folder.path() + "' && compare -metric AE a.png a.ppm null:").err == "0");
  }
}
