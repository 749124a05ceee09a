// Tests of common/engine/render/render.hpp: bytes, samples, and pictures that do not depend on
// threads or packs.
#include <doctest.h>

#include <atomic>
#include <stdexcept>

#include "engine/render/render.hpp"
#include "number/kinds/pack.hpp"
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
  for (const int samples : {16, 256, 4096, 65536}) {
    double column = 0;
    double row = 0;
    int quarter[4] = {};
    for (int i = 0; i < samples; ++i) {
      const PixelOffset offset = pixel_offset(i);
      if (!(offset.column >= -0.5 && offset.column < 0.5 && offset.row >= -0.5 && offset.row < 0.5))
        ++outside;
      column += offset.column;
      row += offset.row;
      ++quarter[(offset.column < 0 ? 0 : 1) + (offset.row < 0 ? 0 : 2)];
    }
    CAPTURE(samples);
    CHECK(abs(column / samples) <= 2.0 / samples);
    CHECK(abs(row / samples) <= 2.0 / samples);
    for (const int count : quarter) CHECK(abs(count - samples / 4.0) <= 8);
  }
  for (const int i : {1000000, std::numeric_limits<int>::max()}) {
    const PixelOffset offset = pixel_offset(i);
    if (!(offset.column >= -0.5 && offset.column < 0.5 && offset.row >= -0.5 && offset.row < 0.5))
      ++outside;
  }
  CHECK(outside == 0);
}

TEST_CASE_TEMPLATE("with one sample a pixel has the color of the ray through its center", Real,
                   float, double, long double) {
  const View<> view = view_of(camera, 13, 7);
  const Image image = render<Real>(Stripes{}, view, {.samples = 1, .threads = 1});
  CHECK(image.width == 13);
  CHECK(image.height == 7);
  for (int row = 0; row < 7; ++row) {
    for (int column = 0; column < 13; ++column) {
      const Color<Real> color =
          Stripes{}(ray_through(view, static_cast<Real>(column), static_cast<Real>(row)));
      const Rgb8 pixel{byte_of(static_cast<double>(color.r)), byte_of(static_cast<double>(color.g)),
                       byte_of(static_cast<double>(color.b))};
      REQUIRE(image.at(column, row) == pixel);
    }
  }
}

TEST_CASE_TEMPLATE("a pixel is the mean of its samples", Real, float, double, long double) {
  const View<> view = view_of(camera, 4, 4);
  for (const int samples : {2, 3, 16}) {
    int asked = 0;
    const auto lesson = [&asked](const Ray<Real>&) {
      ++asked;
      return Color<Real>{static_cast<Real>(asked), Real(asked % 2), Real(1)};
    };
    const Color<Real> color = pixel_color<Real>(lesson, view, Real(1), Real(2), samples);
    CHECK(asked == samples);
    const Real tolerance = Real(4) * std::numeric_limits<Real>::epsilon();
    CHECK(abs(color.r - static_cast<Real>(samples + 1) / Real(2)) <=
          tolerance * static_cast<Real>(samples));
    CHECK(abs(color.g - static_cast<Real>((samples + 1) / 2) / static_cast<Real>(samples)) <=
          tolerance);
    CHECK(abs(color.b - Real(1)) <= tolerance);
  }
}

TEST_CASE("samples look through the points that pixel_offset names") {
  const View<> view = view_of(camera, 4, 4);
  int i = 0;
  const auto lesson = [&](const Ray<double>& ray) {
    const PixelOffset offset = pixel_offset(i++);
    const Ray<double> expected = ray_through(view, 1 + offset.column, 2 + offset.row);
    CHECK(ray.direction.x == expected.direction.x);
    CHECK(ray.direction.y == expected.direction.y);
    return Rgb{};
  };
  static_cast<void>(pixel_color<double>(lesson, view, 1.0, 2.0, 8));
  CHECK(i == 8);
}

TEST_CASE("progress is told of every row") {
  std::atomic<int> told = 0;
  std::atomic<int> most = 0;
  const auto progress = [&](int done, int total) {
    ++told;
    if (total == 37 && done == total) most = done;
  };
  static_cast<void>(render<double>(Stripes{}, view_of(camera, 5, 37),
                                   {.samples = 1, .threads = 2, .progress = progress}));
  CHECK(told == 37);
  CHECK(most == 37);
}

TEST_CASE_TEMPLATE(
    "a picture is the same for packs and on any number of threads, for widths that are no multiple "
    "of a pack",
    T, float, double) {
  for (const int width : {1, 2, 3, 7, 16, 31, 61}) {
    const View<> view = view_of(camera, width, 17);
    CAPTURE(width);
    for (const int samples : {1, 3}) {
      const auto drawn = [&]<class Real>(Real, int threads) {
        return render<Real>(Stripes{}, view, {.samples = samples, .threads = threads});
      };
      const Image alone = drawn(T(), 1);
      CHECK(alone != Image(width, 17));
      for (const int threads : {0, 1, 2, 7}) {
        CHECK(drawn(T(), threads) == alone);
        CHECK(drawn(Pack<T>(T()), threads) == alone);
      }
    }
  }
}

}  // namespace
}  // namespace texmap::test
