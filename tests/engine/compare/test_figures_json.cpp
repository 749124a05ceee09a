// The figures as JSON: the exact text, numbers that read back, and no locale in it.
#include <doctest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <locale>
#include <sstream>
#include <string>

#include "engine/compare/figures_json.hpp"
#include "engine/measure/text.hpp"

using namespace texmap;

namespace {

/// Writes numbers as in many countries: 1.234,5
struct CommaNumbers : std::numpunct<char> {
  [[nodiscard]] char do_decimal_point() const override { return ','; }
  [[nodiscard]] char do_thousands_sep() const override { return '.'; }
  [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

double read_back(const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double value = 0;
  in >> value;
  CHECK(in.eof());
  return value;
}

Figures some_figures() {
  Image a(1300, 2, {100, 100, 100});
  Image b = a;
  b.at(1200, 1) = {100, 103, 96};
  return measure(a, b);
}

}  // namespace

TEST_CASE("a number is as short as it can be and reads back to the same bits") {
  CHECK(round_trip(0) == "0");
  CHECK(round_trip(0.1) == "0.1");
  CHECK(round_trip(255) == "255");
  CHECK(round_trip(-0.25) == "-0.25");
  CHECK(round_trip(1.0 / 3) == "0.3333333333333333");
  std::uint64_t state = 1;
  for (int i = 0; i < 20000; ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    double value = 0;
    std::memcpy(&value, &state, sizeof value);
    if (!std::isnormal(value)) continue;
    if (read_back(round_trip(value)) != value) FAIL_CHECK(round_trip(value));
  }
}

TEST_CASE("the figures of pictures that differ") {
  const Figures f = some_figures();
  const std::string expected =
      "{\n"
      "  \"width\": 1300,\n"
      "  \"height\": 2,\n"
      "  \"pixels_compared\": 2600,\n"
      "  \"pixels_different\": 1,\n"
      "  \"share_different\": 0.0003846153846153846,\n"
      "  \"box\": {\"left\": 1200, \"top\": 1, \"width\": 1, \"height\": 1},\n"
      "  \"largest_difference\": {\"levels\": 4, \"column\": 1200, \"row\": 1, \"a\": [100, 100, "
      "100], \"b\": [100, 103, "
      "96]},\n"
      "  \"mean_absolute_error\": " +
      round_trip(7.0 / 7800) +
      ",\n"
      "  \"root_mean_square_error\": " +
      round_trip(std::sqrt(25.0 / 7800)) +
      ",\n"
      "  \"psnr\": \"finite\",\n"
      "  \"psnr_db\": " +
      round_trip(f.peak_signal_to_noise) +
      ",\n"
      "  \"ssim\": " +
      round_trip(f.structural_similarity) +
      ",\n"
      "  \"flip\": " +
      round_trip(f.flip) +
      ",\n"
      "  \"mean_a\": 100,\n"
      "  \"mean_b\": " +
      round_trip(779999.0 / 7800) +
      "\n"
      "}\n";
  CHECK(figures_json(f) == expected);
}

TEST_CASE("equal pictures: null where there is nothing to say, and a word for infinity") {
  const std::string json = figures_json(measure(Image(3, 3, {1, 2, 3}), Image(3, 3, {1, 2, 3})));
  for (const char* part : {"\"box\": null,", "\"largest_difference\": null,",
                           "\"psnr\": \"infinite\",\n  \"psnr_db\": null,", "\"ssim\": 1,",
                           "\"flip\": 0,", "\"mean_a\": 2,", "\"mean_b\": 2\n}"}) {
    CAPTURE(part);
    CHECK(json.find(part) != std::string::npos);
  }
}

TEST_CASE("a locale with a decimal comma and thousands points changes nothing") {
  const std::string before = figures_json(some_figures());
  const std::locale old =
      std::locale::global(std::locale(std::locale::classic(), new CommaNumbers));
  std::ostringstream proof;
  proof << 1234.5;
  CHECK(proof.str() == "1.234,5");  // otherwise this test proves nothing
  const std::string after = figures_json(some_figures());
  std::locale::global(old);
  CHECK(after == before);
}
