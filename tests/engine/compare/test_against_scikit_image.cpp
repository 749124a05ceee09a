// Our figures against those of scikit-image, where it is installed.
#include <doctest.h>

#include <cmath>
#include <string>

#include "engine/compare/difference.hpp"
#include "engine/compare/other_tools.hpp"
#include "engine/picture/save_png.hpp"
#include "support/running.hpp"
#include "support/temporary_folder.hpp"

using namespace texmap;
using namespace texmap::test;

TEST_CASE("SSIM and PSNR are those of scikit-image") {
  if (run("python3 -c 'import skimage.metrics'").status != 0)
    return skip("there is no python3-skimage here");
  for (const Pair& pair : pairs()) {
    CAPTURE(pair.name);
    const TemporaryFolder folder;
    save_png(pair.a, folder / "a.png");
    save_png(pair.b, folder / "b.png");
    const std::string script =
        "from skimage.io import imread\n"
        "from skimage.metrics import structural_similarity, peak_signal_noise_ratio\n"
        "a, b = imread(\"a.png\"), imread(\"b.png\")\n"
        "print(repr(float(structural_similarity(a, b, gaussian_weights=True, sigma=1.5, "
        "use_sample_covariance=False,"
        " channel_axis=2, data_range=255))))\n"
        "print(repr(float(peak_signal_noise_ratio(a, b, data_range=255))))\n";
    put(folder / "figures.py", {script.begin(), script.end()});
    const Outcome theirs = run("cd '" + folder.path() + "' && python3 figures.py");
    CAPTURE(theirs.err);
    REQUIRE(theirs.status == 0);
    const Figures ours = measure(pair.a, pair.b);
    // With these options its window is the paper's, cut off at 3.5 sigma, which is 5 pixels; its
    // mean leaves out 5 pixels at each edge, as ours does. Variances are differences of numbers
    // near 255^2, so doubles agree to about 1e-12.
    CHECK(std::abs(number(theirs.out) - ours.structural_similarity) < 1e-12);
    CHECK(number(theirs.out.substr(theirs.out.find('\n') + 1)) ==
          doctest::Approx(ours.peak_signal_to_noise).epsilon(1e-12));
  }
}
