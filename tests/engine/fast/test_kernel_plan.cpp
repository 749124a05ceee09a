// Tests of engine/fast/budget.hpp and kernel_plan.hpp: what a budget reads as and buys, and that
// drawing uses it.
#include "engine/fast/kernel_plan.hpp"

#include <doctest.h>

#include "engine/fast/biquadratic.hpp"
#include "number/kinds/pack.hpp"
#include "support/dice.hpp"
#include "support/lanes.hpp"

namespace texmap::test {
namespace {

constexpr int degrees[] = {5, 9, 17, 23, 35};

/// The stated worst error of the mapping of a degree; none for the reference.
template <class T>
UvError worst_of_degree(int degree) {
  return with_uv_mapping(degree, []<class Mapping>(const Mapping&) -> UvError {
    if constexpr (requires { Mapping::template worst<T>; }) return Mapping::template worst<T>;
    return {};
  });
}

/// Distance of two turns.
double apart(double a, double b) { return std::abs(a - b - std::round(a - b)); }

TEST_CASE_TEMPLATE(
    "a planned mapping is the turned mapping in every convention, within its kernel's bound", Real,
    float, double, Pack<float>, Pack<double>) {
  using T = Scalar<Real>;
  const double slack = 2 * static_cast<double>(std::numeric_limits<T>::epsilon());
  Dice dice;
  const auto any = [&] {
    return from_lanes<Real>([&](std::size_t) { return static_cast<T>(dice.between(-1, 1)); });
  };
  for (const Convention convention : {Convention::daily, Convention::rtiow, Convention::lecture}) {
    for (const double angle : {0.0, 37.0, 90.0, -200.5}) {
      const Rotated<ConventionMapping> exact{rotation_y(angle), {convention}};
      const auto check = [&](int degree, const Vec3<Real>& p) {
        const Uv<Real> is = PlannedMapping{degree, convention, exact.rotation}(p);
        const Uv<Real> should = exact(p);
        const UvError worst = worst_of_degree<T>(degree);
        for (std::size_t i = 0; i < lanes<Real>; ++i) {
          const auto u = static_cast<double>(lane(is.u, i));
          CAPTURE(degree);
          CAPTURE(angle);
          REQUIRE((u >= 0 && u < 1));
          REQUIRE(apart(u, static_cast<double>(lane(should.u, i))) <= worst.u + slack);
          REQUIRE(std::abs(static_cast<double>(lane(is.v, i) - lane(should.v, i))) <=
                  worst.v + slack);
        }
        if (degree == 0) REQUIRE(alike(lane_of(is, 0), lane_of(should, 0)));
      };
      for (int i = 0; i < 200; ++i) {
        const Vec3<Real> p = normalize(Vec3<Real>{any(), any(), any()});
        check(0, p);
        for (const int degree : degrees) check(degree, p);
      }
    }
  }
  // The bound is not idle: the cheapest kernel is off by more than the next one may be.
  double off = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto p = dice.direction<double>();
    off = std::max(off, apart(PlannedMapping{5}(p).u, uv_rtiow(p).u));
  }
  CHECK(off > worst_of_degree<double>(9).u);
}

TEST_CASE(
    "a budget is exact, a number of texels or a number of levels, and anything else refused") {
  const auto is = [](const char* text, Budget::Unit unit, double limit) {
    return parse_budget(text).unit == unit && parse_budget(text).limit == limit &&
           parse_budget(to_text(parse_budget(text))).limit == limit;
  };
  CHECK(is("exact", Budget::Unit::exact, 0));
  CHECK(is("texels=0.01", Budget::Unit::texels, 0.01));
  CHECK(is("texels=1e-6", Budget::Unit::texels, 1e-6));
  CHECK(is("levels=.5", Budget::Unit::levels, 0.5));
  CHECK(is("levels=255", Budget::Unit::levels, 255));
  for (const char* text : {"", "Exact", "exact ", "exact=1", "texels", "texels=", "texels=0",
                           "texels=-1", "texels=+1", "texels= 1", "texels=1x", "texels=nan",
                           "texels=1,5", "levels=256", "pixels=1", "levels=1e-1299"}) {
    CAPTURE(text);
    const std::string expected =
        "a budget is 'exact', 'texels=X' or 'levels=X' with a number X above 0 and up to 255, not "
        "'" +
        std::string(text) + "'";
    CHECK_THROWS_WITH_AS(static_cast<void>(parse_budget(text)), expected.c_str(),
                         std::invalid_argument);
  }
}

TEST_CASE("known budgets buy known kernels, which keep them, and the next cheaper would not") {
  struct Row {
    const char* budget;
    int width, height, degree;
  };
  const Row table[] = {
      {"texels=0.01", 8192, 4096, 17},   {"texels=0.001", 8192, 4096, 17},
      {"texels=0.01", 1024, 512, 9},     {"texels=0.5", 1024, 512, 5},
      {"texels=0.01", 4096, 8192, 17},   {"texels=100", 1, 8192, 5},
      {"levels=1", 1024, 512, 17},       {"levels=1", 8192, 4096, 17},
      {"texels=0.0001", 8192, 4096, 23}, {"texels=1e-9", 8192, 4096, 35},
      {"texels=1e-14", 8192, 4096, 0},   {"exact", 2, 1, 0},
  };
  for (const Row& row : table) {
    const Budget budget = parse_budget(row.budget);
    const Polynomial choice = choose_uv_kernel(budget, row.width, row.height);
    CAPTURE(choice.text);
    CHECK(choice.terms == row.degree);
    if (row.degree == 0) continue;
    const auto worst_texels = [&row](int degree) {
      const UvError worst =
          degree < 23 ? worst_of_degree<float>(degree) : worst_of_degree<double>(degree);
      return std::max(worst.u * row.width, worst.v * row.height);
    };
    CHECK(choice.worst_texels == worst_texels(row.degree));
    CHECK(choice.worst_levels >= 255 * choice.worst_texels);
    const bool texels = budget.unit == Budget::Unit::texels;
    CHECK((texels ? choice.worst_texels : choice.worst_levels) <= budget.limit);
    const auto* cheaper = std::find(std::begin(degrees), std::end(degrees), row.degree);
    if (texels && cheaper != std::begin(degrees)) CHECK(worst_texels(cheaper[-1]) > budget.limit);
  }
  CHECK_THROWS_WITH_AS(static_cast<void>(choose_uv_kernel({}, 0, 4)),
                       "a texture is at least 1x1, not 0x4", std::invalid_argument);
}

TEST_CASE("a highlight is as cheap as a budget of levels allows, and otherwise exact") {
  for (const char* text : {"exact", "texels=100", "levels=0.0001"})
    CHECK(plan_highlight(parse_budget(text)).power_terms == 0);
  const auto power = [](double worst, int terms, int next) {
    const auto bought = [](double levels) {
      return plan_highlight({Budget::Unit::levels, levels}).power_terms;
    };
    CHECK(bought(worst) == terms);
    CHECK(bought(std::nextafter(worst, 0)) == next);
  };
  power(PowerKernel<3>::worst_levels<float>, 3, 6);
  power(PowerKernel<6>::worst_levels<float>, 6, 0);
  for (const double versine : {0.0, 0.001, 0.02, 0.5}) {
    const auto by = [versine](int terms) { return PlannedPower{terms, 50}(versine); };
    CHECK(by(3) == PowerKernel<3>(50)(versine));
    CHECK(by(6) == PowerKernel<6>(50)(versine));
  }
}

const Image earth(2048, 1024);

TEST_CASE("texels become words where they are read four times as often as there are texels") {
  const auto texels = static_cast<double>(earth.pixels.size());
  const auto roots = [](const char* budget, double reads) {
    return plan_surface(parse_budget(budget), earth, reads).root_texels;
  };
  CHECK(roots("levels=1", 4 * texels));
  CHECK_FALSE(roots("levels=1", 4 * texels - 1));
  CHECK(roots("levels=0.39", 1e12));
  CHECK_FALSE(roots("levels=0.37", 1e12));  // more than half of the budget
  CHECK_FALSE(roots("texels=1", 1e12));
}

TEST_CASE("what the parts of a plan are off by is together within the budget, and not idle") {
  for (const char* text : {"levels=0.9", "levels=1", "levels=8", "texels=0.5", "texels=1"}) {
    for (const double reads : {0.0, 1e12}) {
      const Budget budget = parse_budget(text);
      const bool levels = budget.unit == Budget::Unit::levels;
      const KernelPlan plan = plan_surface(budget, earth, reads);
      CAPTURE(plan.text);
      CHECK(plan.floats_are_enough);
      CHECK(plan.smoothing.most_curvature_error > 0);
      const UvError uv = worst_of_degree<float>(plan.uv_degree);
      // A patch has the mapping's errors nearly threefold, its own, and a rounding.
      const auto patch = [&](double of_mapping, double of_bends, int texels) {
        return texels * (Biquadratic<double>::worst_growth * of_mapping +
                         of_bends * plan.smoothing.most_curvature_error +
                         0.3 * static_cast<double>(std::numeric_limits<float>::epsilon()));
      };
      const double u = patch(uv.u, Smoothing::turns_per_curvature_error, earth.width);
      const double v = patch(uv.v, Smoothing::half_turns_per_curvature_error, earth.height);
      const double directions =
          64 * Smoothing::direction_per_normal_error * plan.smoothing.most_normal_error;
      const double worst =
          levels ? (plan.root_texels ? RootTexture::worst_levels : 0) + 255 * (u + v) + directions
                 : std::max(u, v);
      CHECK(worst <= budget.limit * (1 + 1e-12));
      CHECK(worst > 0.6 * budget.limit);
    }
  }
}

TEST_CASE("a plan says in a line each what was chosen") {
  CHECK(plan_surface({}, Image(64, 32), 1e12).text ==
        "texels for exact: as they are, decoded by a table\n"
        "(u, v) for exact on 64x32: the reference formula in double, at cost 1\n");
  CHECK(plan_surface(parse_budget("texels=0.04"), Image(8192, 4096), 0).text ==
        "texels for exact: as they are, decoded by a table\n"
        "(u, v) for texels=0.01 on 8192x4096: polynomials in float, arc tangent of degree 17, unit "
        "vectors; at worst 0.0009 texels and 0.38 levels; 0.039 of the reference's time\n"
        "pixels for texels=0.04: polynomials through nine probes for each that bends the picture "
        "by less than 0.00015; at worst 0.04 texels with (u, v)\n");
  const auto warns_of_edges = [](const char* budget, int width) {
    return plan_surface(parse_budget(budget), Image(width, 1), 0).text.ends_with("neighbor\n");
  };
  CHECK(warns_of_edges("levels=1", 8192));
  CHECK_FALSE(warns_of_edges("levels=1e-12", 8192));  // buys nothing
  CHECK(plan_highlight(parse_budget("levels=1"))
            .text.find("Phong's power for levels=1: a "
                       "polynomial of 3 terms; at worst ") == 0);
}

}  // namespace
}  // namespace texmap::test
