// Tests of common/kernels/budget.hpp: what a budget reads as, and what it buys.
#include "budget.hpp"

#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "biquadratic.hpp"

namespace texmap {
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
  for (const char* text : {"",           "Exact",      "exact ",     " exact",     "exact=1",       "texels",
                           "texels=",    "texels=0",   "texels=-1",  "texels=+1",  "texels= 1",     "texels=1 ",
                           "texels=1x",  "texels=0x1", "texels=inf", "texels=nan", "texels=1e999",  "texels=1,5",
                           "levels=256", "levels=",    "pixels=1",   "TEXELS=1",   "levels=1e-999", "levels=1\n"}) {
    CAPTURE(text);
    const std::string expected =
        std::string("a budget is 'exact', 'texels=X' or 'levels=X' with a number X above 0 and up to 255, not '") + text + "'";
    CHECK_THROWS_WITH_AS(static_cast<void>(parse_budget(text)), expected.c_str(), std::invalid_argument);
  }
}

TEST_CASE("the text of a budget reads as the same budget") {
  for (const char* text : {"exact", "texels=0.01", "levels=1", "texels=1e-06", "levels=0.1", "texels=0.3333333333333333"}) {
    CHECK(to_text(parse_budget(text)) == text);
  }
}

TEST_CASE("a choice keeps to its budget, and the kernel before it does not") {
  for (const Directions directions : {Directions::any, Directions::unit}) {
    for (const int width : {16, 256, 1024, 8192, 16384}) {
      int dearest = 0;
      for (const double texels : {100.0, 1.0, 0.1, 0.01, 0.001, 1e-6, 1e-9, 1e-14}) {
        const Budget budget{Budget::Unit::texels, texels};
        const UvChoice choice = choose_uv_kernel(budget, width, width / 2, directions);
        CHECK(choice.worst_texels <= texels);
        const int rank = choice.degree == 0 ? 1000 : choice.degree;
        CHECK(rank >= dearest);
        dearest = rank;
      }
    }
  }
}

TEST_CASE("a choice states the error of its own kernel, along the side of the texture where it is worse") {
  struct Size {
    int width, height;
  };
  for (const Size size : {Size{8192, 4096}, Size{4096, 8192}, Size{1, 8192}, Size{8192, 1}}) {
    CAPTURE(size.width);
    CAPTURE(size.height);
    const auto stated = [&](const UvChoice& choice, const UvError& worst) {
      CHECK(choice.worst_texels == std::max(worst.u * size.width, worst.v * size.height));
      CHECK(choice.worst_levels == doctest::Approx(255 * (worst.u * size.width + worst.v * size.height)));
    };
    for (const double texels : {100.0, 1.0, 0.1, 0.01, 0.001}) {
      const Budget budget{Budget::Unit::texels, texels};
      for (const Directions directions : {Directions::any, Directions::unit}) {
        const UvChoice choice = choose_uv_kernel(budget, size.width, size.height, directions);
        const bool any = directions == Directions::any;
        if (choice.degree == 5) stated(choice, any ? FastMapping<5>::worst<float> : FastUnitMapping<5>::worst<float>);
        if (choice.degree == 9) stated(choice, any ? FastMapping<9>::worst<float> : FastUnitMapping<9>::worst<float>);
        if (choice.degree == 11) stated(choice, any ? FastMapping<11>::worst<float> : FastUnitMapping<11>::worst<float>);
        if (choice.degree == 13) stated(choice, any ? FastMapping<13>::worst<float> : FastUnitMapping<13>::worst<float>);
      }
    }
  }
}

TEST_CASE("known budgets buy known kernels") {
  struct Row {
    const char* budget;
    int width, height;
    Directions directions;
    KernelNumber number;
    int degree;
  };
  const Row table[] = {
      {"texels=0.01", 8192, 4096, Directions::any, KernelNumber::single, 11},
      {"texels=0.001", 8192, 4096, Directions::any, KernelNumber::single, 13},
      {"texels=0.001", 8192, 4096, Directions::unit, KernelNumber::single, 13},
      {"texels=0.01", 1024, 512, Directions::any, KernelNumber::single, 9},
      {"texels=0.5", 1024, 512, Directions::any, KernelNumber::single, 5},
      {"levels=1", 1024, 512, Directions::any, KernelNumber::single, 11},
      {"levels=1", 8192, 4096, Directions::any, KernelNumber::single, 13},
      {"texels=0.0001", 8192, 4096, Directions::any, KernelNumber::twice, 23},
      {"texels=1e-9", 8192, 4096, Directions::any, KernelNumber::twice, 29},
      {"texels=1e-14", 8192, 4096, Directions::any, KernelNumber::reference, 0},
      {"exact", 2, 1, Directions::any, KernelNumber::reference, 0},
  };
  for (const Row& row : table) {
    const UvChoice choice = choose_uv_kernel(parse_budget(row.budget), row.width, row.height, row.directions);
    CAPTURE(choice.text);
    CHECK(choice.number == row.number);
    CHECK(choice.degree == row.degree);
  }
}

TEST_CASE("the text says the budget, the size, the kernel, its worst case and its cost") {
  CHECK(choose_uv_kernel(parse_budget("texels=0.01"), 8192, 4096).text ==
        "(u, v) for texels=0.01 on 8192x4096: polynomials in float, arc tangent of degree 11; at worst 0.0028 texels and 1.4 "
        "levels; 0.037 of the reference's time");
  CHECK(choose_uv_kernel(parse_budget("texels=0.01"), 8192, 4096, Directions::unit).text ==
        "(u, v) for texels=0.01 on 8192x4096: polynomials in float, arc tangent of degree 11, unit vectors; at worst 0.0037 "
        "texels and 1.7 levels; 0.029 of the reference's time");
  CHECK(choose_uv_kernel(parse_budget("exact"), 64, 32).text ==
        "(u, v) for exact on 64x32: the reference formula in double, by the C library, at cost 1");
  CHECK(choose_srgb_kernel(parse_budget("levels=1")).text ==
        "sRGB bytes for levels=1: a polynomial of 6 terms; at worst 1 levels");
}

TEST_CASE("a surface's kernel and its smoothing keep to the budget together") {
  const double growth = Biquadratic<double>::worst_growth;
  const double epsilon = static_cast<double>(std::numeric_limits<float>::epsilon());
  for (const char* text : {"levels=0.5", "levels=1", "levels=20", "texels=0.001", "texels=0.01", "texels=1"}) {
    struct Size {
      int width, height;
    };
    for (const auto [width, height] : {Size{64, 32}, Size{2048, 1024}, Size{512, 4096}}) {
      CAPTURE(text);
      const Budget budget = parse_budget(text);
      const SurfaceChoice choice = choose_surface_kernel(budget, width, height);
      const double u = Smoothing::turns_per_bend * choice.smoothing.most_bend + 0.3 * epsilon;
      const double v = Smoothing::half_turns_per_bend * choice.smoothing.most_bend + 0.3 * epsilon;
      const double light = Smoothing::direction_per_tilt * choice.smoothing.most_tilt * 64;
      if (choice.smoothing.most_bend == 0) {
        CHECK(choice.mapping.degree == choose_uv_kernel(budget, width, height, Directions::unit).degree);
      } else if (budget.unit == Budget::Unit::levels) {
        const double places = growth * choice.mapping.worst_levels + 255 * (u * width + v * height);
        CHECK(places + light <= budget.limit * (1 + 1e-12));
        CHECK(places + light > 0.9 * budget.limit);
      } else {
        CHECK(light == 0);
        CHECK(growth * choice.mapping.worst_texels + std::max(u * width, v * height) <= budget.limit * (1 + 1e-12));
      }
    }
  }
  // Budgets of which a mapping's nine looks use up a quarter, so that roundings may leave less than nothing.
  for (const double texels : {0.0006, 0.001, 0.01, 0.1}) {
    for (const Budget::Unit unit : {Budget::Unit::levels, Budget::Unit::texels}) {
      const UvChoice offer = choose_uv_kernel({Budget::Unit::texels, texels}, 8192, 1, Directions::unit);
      const double worst = unit == Budget::Unit::levels ? offer.worst_levels : offer.worst_texels;
      for (const double more : {1.0 + 1e-9, 1.01, 1.1}) {
        const Smoothing smoothing = choose_surface_kernel({unit, 4 * worst * more}, 8192, 1).smoothing;
        CHECK(smoothing.most_bend >= 0);
        CHECK((smoothing.most_bend > 0 || smoothing.most_tilt == 0));
      }
    }
  }
  CHECK(choose_surface_kernel(parse_budget("levels=1"), 2048, 1024).smoothing.most_bend > 1e-6);
  CHECK(choose_surface_kernel(parse_budget("texels=1e-4"), 2048, 1024).smoothing.most_bend == 0);  // float has no more digits
  CHECK(choose_surface_kernel(parse_budget("exact"), 2048, 1024).smoothing.most_bend == 0);
  CHECK(choose_surface_kernel(parse_budget("exact"), 2048, 1024).smoothing.most_tilt == 0);
  CHECK(choose_surface_kernel(parse_budget("levels=1"), 2048, 1024).text.find("\npixels for levels=1: ") != std::string::npos);
}

TEST_CASE("the mapping drawn with is the chosen one") {
  const Point p{0.6, 0.48, -0.64};
  for (const Directions directions : {Directions::any, Directions::unit}) {
    for (const double texels : {50.0, 0.5, 0.1, 0.02, 0.01, 0.002, 0.001, 0.0008, 1e-6, 1e-9, 1e-12, 1e-14}) {
      const UvChoice choice = choose_uv_kernel({Budget::Unit::texels, texels}, 8192, 4096, directions);
      CAPTURE(choice.text);
      const Uv<double> exact = uv_rtiow(p);
      const auto map = [&](const auto& mapping) { return mapping(p); };
      const Uv<double> uv = directions == Directions::unit ? with_uv_mapping<Directions::unit>(choice, map)
                                                           : with_uv_mapping<Directions::any>(choice, map);
      CHECK(abs(uv.u - exact.u) * 8192 <= texels);
      CHECK(abs(uv.v - exact.v) * 4096 <= texels);
      if (choice.degree == 0) CHECK(uv.u == exact.u);
    }
  }
}

/// Whether a choice of this degree draws with the mappings of this degree, to the last bit.
template <int Degree>
bool draws_with_its_degree() {
  const Point p{0.6, 0.48, -0.64};
  UvChoice choice = choose_uv_kernel({}, 1, 1);
  choice.degree = Degree;
  const auto map = [&](const auto& mapping) { return mapping(p); };
  const Uv<double> any = with_uv_mapping<Directions::any>(choice, map);
  const Uv<double> unit = with_uv_mapping<Directions::unit>(choice, map);
  return any.u == FastMapping<Degree>{}(p).u && any.v == FastMapping<Degree>{}(p).v &&
         unit.u == FastUnitMapping<Degree>{}(p).u && unit.v == FastUnitMapping<Degree>{}(p).v;
}

TEST_CASE("every degree on offer is drawn with, and no other one in its place") {
  CHECK(draws_with_its_degree<5>());
  CHECK(draws_with_its_degree<7>());
  CHECK(draws_with_its_degree<9>());
  CHECK(draws_with_its_degree<11>());
  CHECK(draws_with_its_degree<13>());
  CHECK(draws_with_its_degree<15>());
  CHECK(draws_with_its_degree<17>());
  CHECK(draws_with_its_degree<23>());
  CHECK(draws_with_its_degree<29>());
  CHECK(draws_with_its_degree<35>());
}

TEST_CASE("each power kernel is bought by its stated error, and not by less") {
  const auto terms_for = [](double levels) { return choose_power_kernel({Budget::Unit::levels, levels}).terms; };
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

TEST_CASE("colors are exact where the budget is none of levels, and otherwise as cheap as it allows") {
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
  CHECK_THROWS_WITH_AS(static_cast<void>(choose_uv_kernel({}, 0, 4)), "a texture is at least 1x1, not 0x4",
                       std::invalid_argument);
  CHECK_THROWS_WITH_AS(static_cast<void>(choose_uv_kernel({}, 4, 0)), "a texture is at least 1x1, not 4x0",
                       std::invalid_argument);
}

}  // namespace
}  // namespace texmap
