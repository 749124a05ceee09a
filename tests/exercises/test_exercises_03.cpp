// The exercises of chapter 03, and what strangers write for them.
#include "solutions/03.hpp"

const std::vector<double> texmap::test::answers{1100, 12644e2 / (2048 * 1024)};

TEST_CASE("03: strangers' answers get their words") {
  const auto by_x = [](const char* text, auto of) {  // of the place in the picture, 0 to 1
    column_of(text,
              [=](D u, int w, D left, D right) { return of((u - left) / (right - left), w); });
  };
  by_x("width - 1", [](D x, int w) { return std::lround(x * (w - 1)); });
  by_x("numbered from 0", [](D x, int w) { return clamp<int>(floor(x * w) + 1, 0, w - 1); });
  by_x("less than 0", [](D x, int w) { return x * w >= w ? w - 1 : int(x * w); });
  by_x("other end", [](D x, int w) { return clamp(int(x * w) % w, 0, w); });
  column_of("of a whole map", [](D u, int w, D, D) { return min(w - 1, int(u * w)); });

  const auto in_picture = [](auto row) {  // the rows of the pictures above are right
    return [=](D v, int h, int picture) { return picture * h + row(v, h); };
  };
  // As the textbook has it. It differs where v is on the edge of a row, and is right, too.
  row_of.right(in_picture([](D v, int h) { return min(int((1 - clamp(v, 0., 1.)) * h), h - 1); }));
  row_of("upside down", in_picture([](D v, int h) { return v < 0 ? 0 : min(int(v * h), h - 1); }));
  row_of("half a texel",
         in_picture([](D v, int h) { return clamp(int(h - v * h + 0.5), 0, h - 1); }));
  row_of("you forgot the - 1",
         in_picture([](D v, int h) { return h - clamp(int(v * h), 0, h - 1); }));
  row_of("limit the number", in_picture([](D v, int h) { return h - 1 - int(floor(v * h)); }));
  row_of("limit the number", [](D v, int h, int picture) {
    return v < 0 || v > 1 ? -1 : picture * h + h - 1 - min(int(v * h), h - 1);
  });
  row_of("has height rows, not one",
         [](D v, int h, int picture) { return picture + h - 1 - clamp(int(v * h), 0, h - 1); });

  const auto by_first_byte = [](const char* text, auto first) {
    color_of(text, [=](const Bytes& bytes, int length, int c, int r) {
      const int i = first(length, c, r);
      return Color{bytes[i + 2] / 256., bytes[i + 1] / 256., bytes[i] / 256.};
    });
  };
  by_first_byte("256", [](int length, int c, int r) { return r * length + 3 * c; });
  by_first_byte("and not texels", [](int length, int c, int r) { return 3 * (r * length + c); });
  by_first_byte("row above", [](int length, int c, int r) { return length * (r - 1) + 3 * c; });
  color_of("red is the third", [](const Bytes& bytes, int length, int c, int r) {
    const int i = r * length + 3 * c;
    return Color{bytes[i] / 255., bytes[i + 1] / 255., bytes[i + 2] / 255.};
  });
}

TEST_CASE("before and after the bytes of a picture there are zeros") {
  const texmap::Image image(2, 1, {1, 2, 3});
  const Bytes bytes(image);
  CHECK(bytes[5] == 1);
  CHECK(bytes[6] == 0);
  CHECK(bytes[-1] == 0);
}

TEST_CASE("a column outside of the picture is said to be outside") {
  const std::function<int(D, int, D, D)> width = [](D, int w, D, D) { return w; };
  CHECK(texmap::check::exercises_of_chapter().exercises[0].verdict(width).got ==
        "8, outside: there are 0 to 7");
}
