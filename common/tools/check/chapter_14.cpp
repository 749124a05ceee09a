// The exercise of chapter 14. Its picture has a can from twelve distances.
#include "exercises.hpp"

namespace texmap::check {
namespace {

std::function<float(float, float, float, float, float)> discriminant;

/// With the products of floats exact, as they are in double.
double exact(float fx, float fz, float dx, float dz, float r) {
  const double aside = double(fx) * double(dz) - double(fz) * double(dx);
  return (square(double(dx)) + square(double(dz))) * square(double(r)) - square(aside);
}
float right_discriminant(float fx, float fz, float dx, float dz, float r) {
  return static_cast<float>(exact(fx, fz, dx, dz, r));
}

Slips<float> wrong_discriminants(float fx, float fz, float dx, float dz, float r) {
  const float a = dx * dx + dz * dz, b = fx * dx + fz * dz, c = fx * fx + fz * fz - r * r;
  const float right = right_discriminant(fx, fz, dx, dz, r), product = fx * dz, other = fz * dx;
  const auto without = [=](float aside) {  // in two orders
    return std::vector{a * r * r - aside * aside, a * (r * r) - aside * aside};
  };
  const double aa = square(double(dx)) + square(double(dz)), rr = square(double(r));
  const double aside_square = aa * rr - exact(fx, fz, dx, dz, r);
  const double bb = double(fx) * double(dx) + double(fz) * double(dz);
  const float t = -b / a, x = fx + t * dx, z = fz + t * dz;
  const float near_b = x * dx + z * dz, near_c = x * x + z * z - r * r;
  const auto less = [=](double all, double square) { return static_cast<float>(all - square); };
  return {
      {"this is the textbook's: b b and a c are large, and their difference keeps no digits",
       {b * b - a * c, 4 * b * b - 4 * a * c, std::fma(b, b, -a * c)}},
      {"fx dz and fz dx cancel, and their rounding errors are left: keep these errors, too",
       without(product - other)},
      {"one of the two products is still rounded: keep its error, too",
       without(std::fma(fx, dz, -other))},
      {"one of the two products is still rounded: keep its error, too",
       without(std::fma(-fz, dx, product))},
      {"this is the textbook's in double: far enough away it keeps no digits either",
       less(square(bb), aa * (square(double(fx)) + square(double(fz)) - rr))},
      {"t d is rounded before it is added: let std::fma start the ray near the can",
       near_b * near_b - a * near_c},
      {"d has any length: a r r, and the square of fx dz - fz dx, go with its square",
       {less(rr, aside_square), right / a}},
      {"it is a r r - the square of fx dz - fz dx",
       {{"the square is missing", less(aa * rr, sqrt(aside_square))},
        {"the sign is wrong", -right},
        {"this is four times as much", 4 * right},
        {"the product is f . d, not f x d", a * r * r - b * b}}},
  };
}

constexpr Place<float, float, float, float, float> discriminant_places[] = {
    {"from 2 radii away straight at the axis: a r r", {-2, 0, 1, 0, 1}},
    {"past the axis at half of the radius: 3/4", {-3, 0.5F, 1, 0, 1}},
    {"past the can, at twice the radius: below 0", {-3, 2, 1, 0, 1}},
    {"with a direction of length 2: four times as much", {-3, 0.5F, 2, 0, 1}},
    {"a can of the radius 3", {-8, 1, 1, 0, 3}},
    {"from 1,000 radii away, with a slanted ray", {-800.3F, -599.9F, 0.8F, 0.6F, 1}},
    {"from 100,000 radii away", {-80000.3F, -60000.4F, 0.8F, 0.6F, 1}},
    {"a can of the radius 10, from 10,000 radii away, near its axis",
     {-50000.6F, 86600.9F, 0.5F, -0.866F, 10}},
    {"from ten million radii away: floats are 1/2 apart there",
     {-8000001.F, -6000000.F, 0.8F, 0.6F, 1}},
    {"from ten million radii on another side", {-3000000.F, 9539392.F, 0.3F, -0.9539392F, 1}},
    {"from 100,000 radii on another side", {70710.5F, -70711.2F, -0.7F, 0.7F, 1}},
};

/// The can from 1.5 to 100,000 radii away, bright where the ray passes near its axis.
Image cans() {
  return panels([](int panel, double x, double y) {
    const double distance = 1.5 * pow(100000 / 1.5, panel / 11.);
    const double beside = 2.6 * (x - 0.5) + 0.1 * (y - 0.5);
    const auto fx = static_cast<float>(0.6 * distance), fz = static_cast<float>(0.8 * distance);
    const double to_x = 0.8 * beside - double(fx), to_z = -0.6 * beside - double(fz);
    const double way = std::hypot(to_x, to_z);
    const auto found = double(
        discriminant(fx, fz, static_cast<float>(to_x / way), static_cast<float>(to_z / way), 1));
    if (!(found >= 0) || abs(y - 0.5) > 0.4) return 0.9;
    return ceil(5.5 * sqrt(found)) / 8;
  });
}

}  // namespace

ExercisesOfChapter all_exercises_of_chapter() {
  return {"14",
          {exercise(discriminant, cans,
                    {right_discriminant, wrong_discriminants, discriminant_places})},
          {}};
}

}  // namespace texmap::check
