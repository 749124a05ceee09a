// Tests of common/engine/kernels/budget.hpp: what a budget reads as, and what it buys.
#include "engine/kernels/budget.hpp"

#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/app/lesson.hpp"
#include "engine/kernels/biquadratic.hpp"
#include "engine/kernels/kernel_plan.hpp"

namespace texmap::test {
namespace {

TEST_CASE("a budget is exact, a number of texels or a number of levels") {
  CHECK(parse_budget("exact").unit == Budget::Unit::exact);
  CHECK(parse_budget("texels=0.01").unit == Budget::Unit::texels);
  CHECK(parse_budget("texels=0.01").limit == 0.01);
  CHECK(parse_budget("levels=1").unit == Budget::Unit::levels);
  CHECK(parse_budget("levels=1").limit == 1);
  CHECK(parse_budget("levels=.5").limit == 0.5);
  CHECK(parse_budget("texels=1e-6").limit == 1e-6);
  CHECK(parse_budget("levels=255").limit == 255);
}

TEST_CASE("anything else is refused, with what would do and what was given") {
  for (const char* text :
       {"",           "Exact",      "exact ",     " exact",     "exact=1",       "texels",
        "texels=",    "texels=0",   "texels=-1",  "texels=+1",  "texels= 1",     "texels=1 ",
        "texels=1x",  "texels=0x1", "texels=inf", "texels=nan", "texels=1e999",  "texels=1,5",
        "levels=256", "levels=",    "pixels=1",   "TEXELS=1",   "levels=1e-999", "levels=1\n"}) {
    CAPTURE(text);
    const std::string expected = std::string(
                                     "a budget is 'exact', 'texels=X' or 'levels=X' with a number "
                                     "X above 0 and up to 255, not '") +
                                 text + "'";
    CHECK_THROWS_WITH_AS(static_cast<void>(parse_budget(text)), expected.c_str(),
                         std::invalid_argument);
  }
}

TEST_CASE("the text of a budget reads as the same budget") {
  for (const char* text : {"exact", "texels=0.01", "levels=1", "texels=1e-06", "levels=0.1",
                           "texels=0.3333333333333333"}) {
    CHECK(to_text(parse_budget(text)) == text);
  }
}

constexpr Size sizes[] = {{8192, 4096}, {4096, 8192}, {1, 8192}, {8192, 1}};

TEST_CASE(
    "a choice states the error of its own kernel, along the side of the texture where it is "
    "worse") {
  int found = 0;
  for (const Size size : sizes) {
    for (const double texels : {100.0, 1.0, 0.1, 0.01, 0.001}) {
      const UvChoice choice =
          choose_uv_kernel({Budget::Unit::texels, texels}, size.width, size.height);
      if (choice.number != KernelNumber::float_) continue;
      CAPTURE(choice.text);
      ++found;
      const UvError worst = with_uv_mapping(choice.degree, []<class Mapping>(const Mapping&) {
        if constexpr (requires { Mapping::template worst<float>; }) {
          return Mapping::template worst<float>;
        } else {
          return UvError{};
        }
      });
      CHECK(choice.worst_texels == std::max(worst.u * size.width, worst.v * size.height));
      CHECK(choice.worst_levels ==
            doctest::Approx(255 * (worst.u * size.width + worst.v * size.height)));
    }
  }
  CHECK(found == 18);  // two of them need double
}

TEST_CASE("known budgets buy known kernels") {
  struct Row {
    const char* budget;
    int width, height;
    KernelNumber number;
    int degree;
  };
  const Row table[] = {
      {"texels=0.01", 8192, 4096, KernelNumber::float_, 11},
      {"texels=0.001", 8192, 4096, KernelNumber::float_, 13},
      {"texels=0.001", 8192, 4096, KernelNumber::float_, 13},
      {"texels=0.01", 1024, 512, KernelNumber::float_, 9},
      {"texels=0.5", 1024, 512, KernelNumber::float_, 5},
      {"levels=1", 1024, 512, KernelNumber::float_, 11},
      {"levels=1", 8192, 4096, KernelNumber::float_, 13},
      {"texels=0.0001", 8192, 4096, KernelNumber::double_, 23},
      {"texels=1e-9", 8192, 4096, KernelNumber::double_, 29},
      {"texels=1e-14", 8192, 4096, KernelNumber::reference, 0},
      {"exact", 2, 1, KernelNumber::reference, 0},
  };
  for (const Row& row : table) {
    const UvChoice choice = choose_uv_kernel(parse_budget(row.budget), row.width, row.height);
    CAPTURE(choice.text);
    CHECK(choice.number == row.number);
    CHECK(choice.degree == row.degree);
  }
}

TEST_CASE("the text says the budget, the size, the kernel, its worst case and its cost") {
  CHECK(choose_uv_kernel(parse_budget("texels=0.01"), 8192, 4096).text ==
        "(u, v) for texels=0.01 on 8192x4096: polynomials in float, arc tangent of degree 11, unit "
        "vectors; at worst 0.004 "
        "texels and 1.7 levels; 0.029 of the reference's time");
  CHECK(choose_uv_kernel(parse_budget("exact"), 64, 32).text ==
        "(u, v) for exact on 64x32: the reference formula in double, by the C library, at cost 1");
  CHECK(choose_srgb_kernel(parse_budget("levels=1")).text ==
        "sRGB bytes for levels=1: a polynomial of 6 terms; at worst 1 levels");
}

TEST_CASE("a surface's kernel, its smoothing and its light keep to the budget together") {
  const double rounding = 0.3 * static_cast<double>(std::numeric_limits<float>::epsilon());
  for (const char* text : {"levels=0.5", "levels=1", "levels=20", "texels=0.01", "texels=1"}) {
    for (const auto [width, height] : {Size{64, 32}, Size{2048, 1024}, Size{512, 4096}}) {
      CAPTURE(text);
      const Budget budget = parse_budget(text);
      const auto [mapping, smoothing, words] = choose_surface_kernel(budget, width, height);
      if (smoothing.most_curvature_error == 0) continue;  // the mapping uses up the budget
      CHECK(smoothing.most_curvature_error > 0);
      const bool levels = budget.unit == Budget::Unit::levels;
      const double u =
          width *
          (Smoothing::turns_per_curvature_error * smoothing.most_curvature_error + rounding);
      const double v =
          height *
          (Smoothing::half_turns_per_curvature_error * smoothing.most_curvature_error + rounding);
      const double worst = Biquadratic<double>::worst_growth *
                               (levels ? mapping.worst_levels : mapping.worst_texels) +
                           (levels ? 255 * (u + v) : std::max(u, v)) +
                           Smoothing::direction_per_normal_error * smoothing.most_normal_error * 64;
      CHECK(worst <= budget.limit * (1 + 1e-12));
      if (levels) CHECK(worst > 0.9 * budget.limit);
    }
  }
  CHECK(choose_surface_kernel(parse_budget("levels=1"), 2048, 1024).smoothing.most_curvature_error >
        1e-6);
  CHECK(choose_surface_kernel(parse_budget("exact"), 2048, 1024).smoothing.most_curvature_error ==
        0);
}

TEST_CASE("each power kernel is bought by its stated error, and not by less") {
  const auto terms_for = [](double levels) {
    return choose_power_kernel({Budget::Unit::levels, levels}).terms;
  };
  const auto check = [&](int terms, int next, double worst) {
    CHECK(terms_for(worst) == terms);
    CHECK(terms_for(std::nextafter(worst, 0)) == next);
    CHECK(choose_power_kernel({Budget::Unit::levels, worst}).worst_levels == worst);
  };
  check(3, 4, PowerKernel<3>::worst_levels<float>);
  check(4, 6, PowerKernel<4>::worst_levels<float>);
  check(6, 8, PowerKernel<6>::worst_levels<float>);
  check(8, 0, PowerKernel<8>::worst_levels<float>);
}

TEST_CASE(
    "colors are exact where the budget is none of levels, and otherwise as cheap as it allows") {
  for (const char* text : {"exact", "texels=100", "levels=0.0001"}) {
    CHECK(choose_srgb_kernel(parse_budget(text)).terms == 0);
    CHECK(choose_power_kernel(parse_budget(text)).terms == 0);
  }
  CHECK(choose_srgb_kernel(parse_budget("levels=0.99")).terms == 0);
  CHECK(choose_srgb_kernel(parse_budget("levels=1")).terms == 6);
  CHECK(choose_srgb_kernel(parse_budget("levels=2")).terms == 4);
  CHECK(choose_srgb_kernel(parse_budget("levels=8")).terms == 3);
  CHECK(choose_power_kernel(parse_budget("levels=1")).terms == 3);
  CHECK(choose_power_kernel(parse_budget("levels=0.1")).terms == 4);
  CHECK(choose_power_kernel(parse_budget("levels=0.01")).terms == 6);
}

TEST_CASE("texels become roots where they take no more than half of the budget") {
  const double worst = RootTexture::worst_levels;
  CHECK(choose_texel_kernel({Budget::Unit::levels, 2 * worst}).roots);
  CHECK(choose_texel_kernel({Budget::Unit::levels, 2 * worst}).worst_levels == worst);
  CHECK_FALSE(choose_texel_kernel({Budget::Unit::levels, 1.99 * worst}).roots);
  CHECK(choose_texel_kernel({Budget::Unit::levels, 1.99 * worst}).worst_levels == 0);
  CHECK_FALSE(choose_texel_kernel({Budget::Unit::texels, 200}).roots);
  CHECK_FALSE(choose_texel_kernel({}).roots);
}

TEST_CASE("a texture without a size is refused") {
  CHECK_THROWS_WITH_AS(static_cast<void>(choose_uv_kernel({}, 0, 4)),
                       "a texture is at least 1x1, not 0x4", std::invalid_argument);
  CHECK_THROWS_WITH_AS(static_cast<void>(choose_uv_kernel({}, 4, 0)),
                       "a texture is at least 1x1, not 4x0", std::invalid_argument);
}

}  // namespace
}  // namespace texmap::test
