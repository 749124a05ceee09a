// Tests of engine/kernels/kernel_plan.hpp: what a budget chooses, and that drawing uses it.
#include "engine/kernels/kernel_plan.hpp"

#include <doctest.h>

#include "engine/kernels/biquadratic.hpp"
#include "engine/kernels/srgb_kernel.hpp"
#include "engine/kernels/worst_error.hpp"
#include "support/lanes.hpp"

namespace texmap::test {
namespace {

constexpr int degrees[] = {5, 7, 9, 11, 13, 15, 17, 23, 29, 35};

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
  for (const Convention convention : {Convention::daily, Convention::rtiow, Convention::lecture}) {
    for (const double angle : {0.0, 37.0, 90.0, -200.5}) {
      const Rotated<ConventionMapping> exact{rotation_y(angle), {convention}};
      const auto check = [&](int degree, const Vec3<Real>& p) {
        const Uv<Real> is = planned_mapping(degree, exact)(p);
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
        const Vec3<Real> p = normalize(any_vectors<Real>(dice, -1, 1));
        check(0, p);
        for (const int degree : degrees) check(degree, p);
      }
    }
  }
  // The bound is not idle: the cheapest kernel is off by more than the next one may be.
  double off = 0;
  for (const Vec3<double>& p : unit_vectors<double>(1000))
    off = std::max(off, apart(PlannedMapping{5}(p).u, uv_rtiow(p).u));
  CHECK(off > worst_of_degree<double>(7).u);
}

TEST_CASE("a planned power is the kernel of as many terms") {
  for (const double versine : {0.0, 0.001, 0.02, 0.5}) {
    const auto by = [versine](int terms) { return PlannedPower{terms, 50}(versine); };
    CHECK(by(3) == PowerKernel<3>(50)(versine));
    CHECK(by(4) == PowerKernel<4>(50)(versine));
    CHECK(by(6) == PowerKernel<6>(50)(versine));
    CHECK(by(8) == PowerKernel<8>(50)(versine));
  }
  CHECK(PlannedPower{3, 50}(0.02) != PlannedPower{8, 50}(0.02));
}

const Image earth(2048, 1024);

TEST_CASE("an exact plan is that of the reference formulas") {
  const KernelPlan plan = plan_surface({}, earth, 1e12);
  CHECK(plan.uv_degree == 0);
  CHECK_FALSE(plan.floats_are_enough);
  CHECK(plan.smoothing.most_curvature_error == 0);
  CHECK_FALSE(plan.root_texels);
  CHECK(plan.srgb_terms == 0);
  CHECK(plan_highlight({}).power_terms == 0);
}

TEST_CASE("texels become words where they are read four times as often as there are texels") {
  const Budget budget = parse_budget("levels=1");
  const auto texels = static_cast<double>(earth.pixels.size());
  CHECK(plan_surface(budget, earth, 4 * texels).root_texels);
  CHECK_FALSE(plan_surface(budget, earth, 4 * texels - 1).root_texels);
  CHECK_FALSE(plan_surface(parse_budget("texels=1"), earth, 1e12).root_texels);
}

TEST_CASE("what the parts of a plan are off by is together within the budget, and not idle") {
  struct Row {
    const char* budget;
    double levels;
    int terms;
  };
  const Row table[] = {
      {"levels=0.9", 0.9, 0}, {"levels=1", 1, 6}, {"levels=2", 2, 4}, {"levels=8", 8, 3}};
  for (const Row& row : table) {
    for (const double reads : {0.0, 1e12}) {
      const KernelPlan plan = plan_surface(parse_budget(row.budget), earth, reads);
      CAPTURE(plan.text);
      CHECK(plan.srgb_terms == row.terms);
      const double curve = row.terms == 0   ? 0
                           : row.terms == 6 ? fits::SrgbCurve<6>::worst
                           : row.terms == 4 ? fits::SrgbCurve<4>::worst
                                            : fits::SrgbCurve<3>::worst;
      const double words = plan.root_texels ? RootTexture::worst_levels : 0;
      const UvError uv = plan.floats_are_enough ? worst_of_degree<float>(plan.uv_degree)
                                                : worst_of_degree<double>(plan.uv_degree);
      const double mapping = 255 * (uv.u * earth.width + uv.v * earth.height);
      CHECK(curve + words + mapping <= row.levels);
      CHECK(mapping > 0.02 * row.levels);
      // A patch has the mapping's errors nearly threefold and its own.
      const double patch = 255 * plan.smoothing.most_curvature_error *
                           (Smoothing::turns_per_curvature_error * earth.width +
                            Smoothing::half_turns_per_curvature_error * earth.height);
      CHECK(curve + words + Biquadratic<double>::worst_growth * mapping + patch <= row.levels);
      CHECK(plan.smoothing.most_curvature_error > 0);
    }
  }
  CHECK(plan_surface(parse_budget("texels=1"), earth, 0).srgb_terms == 0);
}

TEST_CASE("a plan says in a line each what was chosen") {
  const std::string text = plan_surface(parse_budget("levels=1"), earth, 1e12).text;
  for (const char* start :
       {"sRGB bytes for levels=1: ", "\ntexels for ", "\n(u, v) for ", "\npixels for "}) {
    CAPTURE(start);
    CHECK(text.find(start) != std::string::npos);
  }
  CHECK(text.back() == '\n');
  CHECK(plan_highlight(parse_budget("levels=1")).text ==
        choose_power_kernel(parse_budget("levels=1")).text + "\n");
}

}  // namespace
}  // namespace texmap::test
