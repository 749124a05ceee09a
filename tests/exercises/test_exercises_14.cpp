// The exercise of chapter 14, and what strangers write for it.
#include "solutions/14.hpp"

const std::vector<double> texmap::test::answers{};

TEST_CASE("14: strangers' answers get their words") {
  discriminant("the textbook's", [](float fx, float fz, float dx, float dz, float r) {
    const float a = dx * dx + dz * dz, b = -(fx * dx + fz * dz), c = fx * fx + fz * fz - r * r;
    return b * b - a * c;
  });
  const auto by_aside = [](const char* text, auto aside) {  // fx dz - fz dx
    discriminant(text, [=](float fx, float fz, float dx, float dz, float r) -> float {
      const auto h = aside(fx, dz, fz, dx);
      return (dx * dx + dz * dz) * r * r - h * h;
    });
  };
  by_aside("keep these errors", [](float a, float b, float c, float d) { return a * b - c * d; });
  by_aside("still rounded",
           [](float a, float b, float c, float d) { return std::fma(a, b, -(c * d)); });
  discriminant("in double", [](D fx, D fz, D dx, D dz, D r) {
    const D a = dx * dx + dz * dz, b = -(fx * dx + fz * dz), c = fx * fx + fz * fz - r * r;
    return b * b - a * c;
  });
  discriminant.right([](float fx, float fz, float dx, float dz, float r) {  // from near the can
    const float a = dx * dx + dz * dz, t = -(fx * dx + fz * dz) / a;
    const float x = std::fma(t, dx, fx), z = std::fma(t, dz, fz), b = x * dx + z * dz;
    return b * b - a * (x * x + z * z - r * r);
  });
}
