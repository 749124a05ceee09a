// The exercises of chapter 03, and what strangers write for them.
#include "starts/03.hpp"

const std::vector<double> texmap::test::answers{1100, 12644e2 / (2048 * 1024)};

TEST_CASE("03: strangers' answers get their words") {
  column_of("width - 1", [](D u, int w) { return std::lround(u * (w - 1)); });
  column_of("numbered from 0", [](D u, int w) { return clamp<int>(floor(u * w) + 1, 0, w - 1); });
  column_of("less than 0", [](D u, int w) { return u * w >= w ? w - 1 : int(u * w); });
  column_of("other end", [](D u, int w) { return clamp(int(u * w) % w, 0, w); });

  // As the textbook has it. It differs where v is on the edge of a row, and is right, too.
  row_of.right([](D v, int h) { return min(int((1 - clamp(v, 0.0, 1.0)) * h), h - 1); });
  row_of("upside down", [](D v, int h) { return v < 0 ? 0 : min(int(v * h), h - 1); });
  row_of("half a texel", [](D v, int h) { return clamp(int((1 - v) * h + 0.5), 0, h - 1); });
  row_of("you forgot the - 1", [](D v, int h) { return h - clamp(int(v * h), 0, h - 1); });

  const auto by_first_byte = [](const char* text, auto first) {
    color_of(text, [=](const Bytes& bytes, int w, int c, int r) {
      const int i = first(w, c, r);
      return Color{bytes[i] / 256., bytes[i + 1] / 256., bytes[i + 2] / 256.};
    });
  };
  by_first_byte("256", [](int w, int c, int r) { return 3 * (r * w + c); });
  by_first_byte("row whole rows, each", [](int w, int c, int r) { return 3 * (r + c); });
  by_first_byte("row above", [](int w, int c, int r) { return 3 * (w * (r - 1) + c); });
  by_first_byte("column and row are exchanged", [](int w, int c, int r) { return w * c + r; });
}

TEST_CASE("before and after the bytes of a picture there are zeros") {
  const texmap::Image image(2, 1, {1, 2, 3});
  const Bytes bytes(image);
  CHECK(bytes[5] == 3);
  CHECK(bytes[6] == 0);
  CHECK(bytes[-1] == 0);
}
