// Tests of common/engine/draw/render.hpp: bytes, samples, and pictures that do not depend on
// threads or packs.
#include <doctest.h>

#include "engine/draw/render.hpp"
#include "number/kinds/pack2.hpp"
#include "support/shown_values.hpp"

namespace texmap::test {
namespace {

const Camera camera{.eye = {0, 0, 5}, .target = {0, 0, 0}, .fov_y_degrees = 90};

/// A lesson that shows the ray's direction in bright stripes: neighboring pixels always differ.
struct Stripes {
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    const auto stripe = [](const Real& x) { return x * Real(7) - floor(x * Real(7)); };
    return {stripe(ray.direction.x), stripe(ray.direction.y),
            stripe(ray.direction.x * ray.direction.y * Real(5))};
  }
};

/// The same of a lesson with a mesh, for which packs have blocks of pixels.
struct StripesOfMesh : Stripes {
  struct {
    bool mesh = true;
  } scene;
};

TEST_CASE("bytes obey their table") {
  const double inf = std::numeric_limits<double>::infinity();
  const std::pair<double, int> table[] = {{0, 0},
                                          {-0.0, 0},
                                          {-1, 0},
                                          {-inf, 0},
                                          {std::numeric_limits<double>::quiet_NaN(), 0},
                                          {1, 255},
                                          {1.1, 255},
                                          {inf, 255},
                                          {254.9999 / 255, 254},
                                          {0.5, 127},
                                          {0.25, 63},
                                          {0.75, 191},
                                          {0.9999 / 255, 0},
                                          {1.0001 / 255, 1},
                                          {1e-300, 0},
                                          {below_one<double>(), 254},
                                          {0.2, 51}};
  for (const auto& [value, byte] : table) CHECK(int{byte_of(value)} == byte);
}

TEST_CASE_TEMPLATE("a byte that becomes a color becomes the same byte again", Real, float, double,
                   long double) {
  for (int byte = 0; byte < 256; ++byte)
    CHECK(int{byte_of(static_cast<double>(static_cast<Real>(byte) / Real(255)))} == byte);
}

TEST_CASE_TEMPLATE(
    "a number becomes the byte of the double that it is, next to the edges of the levels, too", T,
    float, double) {
  const auto check = [](T channel) {
    const std::uint32_t byte = byte_of(static_cast<double>(channel));
    CHECK(bytes_of(channel) == byte);
    CHECK(uint_lane<Pack<T>>(bytes_of(Pack<T>(channel)), lanes<Pack<T>> - 1) == byte);
  };
  for (int level = -1; level <= 257; ++level) {
    const T edge = static_cast<T>(level) / T(255);
    for (const T channel : {std::nextafter(edge, T(-2)), edge, std::nextafter(edge, T(2))})
      check(channel);
  }
  T channel = 1;
  for (int i = 0; i < 20000; ++i) check(channel *= T(0.9993));
  check(std::numeric_limits<T>::quiet_NaN());
}

TEST_CASE("samples stay in their pixel, fill it evenly and are centered on it") {
  int outside = 0;
  for (const int samples : {16, 256, 65536}) {
    double column = 0, row = 0;
    int quarter[4] = {};
    for (int i = 0; i < samples; ++i) {
      const PixelOffset offset = pixel_offset(i);
      const auto inside = [](double x) { return x >= -0.5 && x < 0.5; };
      outside += inside(offset.column) && inside(offset.row) ? 0 : 1;
      column += offset.column;
      row += offset.row;
      ++quarter[(offset.column < 0 ? 0 : 1) + (offset.row < 0 ? 0 : 2)];
    }
    CAPTURE(samples);
    CHECK(abs(column / samples) <= 2.0 / samples);
    CHECK(abs(row / samples) <= 2.0 / samples);
    for (const int count : quarter) CHECK(abs(count - samples / 4.0) <= 8);
  }
  CHECK(outside == 0);
}

TEST_CASE_TEMPLATE("a pixel is the mean of its samples, the first of them through its center", Real,
                   float, double, long double) {
  const View<> view = view_of(camera, 13, 7);
  for (const int samples : {1, 2, 3, 16}) {
    int asked = 0;
    Color<Real> sum{};
    const auto lesson = [&](const Ray<Real>& ray) {
      const PixelOffset offset = pixel_offset(asked++);
      const Ray<Real> expected = ray_through(view, Real(1 + offset.column), Real(2 + offset.row));
      CHECK(static_cast<double>(ray.direction.x) ==
            doctest::Approx(static_cast<double>(expected.direction.x)));
      const Color<Real> color = Stripes{}(ray);
      sum = sum + color;
      return color;
    };
    const Color<Real> mean = pixel_color<Real>(lesson, view, Real(1), Real(2), samples);
    CHECK(asked == samples);
    CHECK(pixel_offset(0).column == 0);
    const auto off = [&](const Real& is, const Real& total) {
      return abs(is - total / static_cast<Real>(samples));
    };
    CHECK(off(mean.r, sum.r) + off(mean.g, sum.g) + off(mean.b, sum.b) <=
          4 * std::numeric_limits<Real>::epsilon());
    const Image image = render<Real>(Stripes{}, view, {.samples = samples, .threads = 1});
    const Color<Real> drawn = pixel_color<Real>(Stripes{}, view, Real(1), Real(2), samples);
    CHECK(image.at(1, 2) == Rgb8{byte_of(static_cast<double>(drawn.r)),
                                 byte_of(static_cast<double>(drawn.g)),
                                 byte_of(static_cast<double>(drawn.b))});
  }
}

TEST_CASE_TEMPLATE(
    "a picture is the same for packs and on any number of threads, for widths that are no multiple "
    "of a pack",
    T, float, double) {
  for (const int width : {1, 2, 3, 7, 16, 31, 61}) {
    const View<> view = view_of(camera, width, 17);
    CAPTURE(width);
    for (const int samples : {1, 3}) {
      const auto drawn = [&]<class Real, class Lesson = Stripes>(Real, int threads,
                                                                 const Lesson& lesson = {}) {
        return render<Real>(lesson, view, {.samples = samples, .threads = threads});
      };
      const Image alone = drawn(T(), 1);
      CHECK(alone != Image(width, 17));
      for (const int threads : {0, 1, 2, 7}) {
        CHECK(drawn(T(), threads) == alone);
        CHECK(drawn(Pack<T>(T()), threads) == alone);
        CHECK(drawn(Pack2<Pack<T>>(T()), threads, StripesOfMesh{}) == alone);
      }
    }
  }
}

}  // namespace
}  // namespace texmap::test
