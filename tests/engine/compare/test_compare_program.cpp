// The program compare from outside: its statuses, what it prints and what it writes.
#include <doctest.h>

#include <string>

#include "engine/compare/difference.hpp"
#include "engine/files/load_image.hpp"
#include "engine/files/save_png.hpp"
#include "support/running.hpp"
#include "support/temporary_folder.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

const std::string program = "'" TEXMAP_COMPARE "' ";

/// A folder with pictures a and b of 100 x 100, where 2 pixels of b are off by 5 levels and 1 by 1,
/// and another one of 99 x 100.
struct Desk {
  TemporaryFolder folder;
  Image a = Image(100, 100, {31, 20, 9});
  Image b = a;

  Desk() {
    b.at(10, 20).r += 5;
    b.at(12, 25).g -= 5;
    b.at(50, 21).b += 1;
    save_png(a, folder / "a.png");
    save_png(b, folder / "b.png");
    save_png(Image(99, 100), folder / "narrow.png");
    save_png(Image(100, 100), folder / "black.png");
  }

  /// Runs the program in the folder.
  [[nodiscard]] Outcome compare(const std::string& words) const {
    return run("cd '" + folder.path() + "' && " + program + words);
  }
};

}  // namespace

TEST_CASE("the tolerant rule: how far, and how many") {
  const Desk desk;
  for (const auto& [rule, status] : {std::pair{"", 1},
                                     {"--pixels-off-by-more-than 5", 0},
                                     {"--pixels-off-by-more-than 4", 1},
                                     // 2 of 10,000
                                     {"--pixels-off-by-more-than 1 --at-most 0.0002", 0},
                                     {"--pixels-off-by-more-than 1 --at-most 0.02%", 0},
                                     {"--pixels-off-by-more-than 1 --at-most 0.00019", 1},
                                     {"--pixels-off-by-more-than 1 --at-most 0.019%", 1},
                                     {"--pixels-off-by-more-than 0 --at-most 0.0002", 1},
                                     {"--at-most=3e-2%", 0},
                                     {"--at-most 1", 0},
                                     {"--at-most 100%", 0}}) {
    CHECK(desk.compare("a.png b.png --quiet " + std::string(rule)).status == status);
  }
  CHECK(desk.compare("b.png a.png --pixels-off-by-more-than 1 --at-most 0.02%")
            .out.ends_with("off by more than 1: 2 pixels, 0.02% of all allowed: the same\n"));
  CHECK(desk.compare("--quiet a.png b.png").out.empty());
}

TEST_CASE("2 for trouble, with the reason first and nothing on stdout") {
  const Desk desk;
  put(desk.folder / "text.png", {'h', 'e', 'l', 'l', 'o'});
  // What cannot be written is found before anything is read; of several files, the first is named.
  for (const auto& [words, reason] :
       {std::pair{"a.png narrow.png", "the pictures differ in size: 100 x 100 and 99 x 100 pixels"},
        {"a.png b.png --mask narrow.png",
         "the mask differs from the pictures in size: 99 x 100 and 100 x 100 pixels"},
        {"a.png b.png --mask black.png", "the mask leaves out every pixel"},
        {"text.png a.png",
         "cannot load 'text.png': it is not a PNG or JPEG file, whatever its name says"},
        {"a.png b.png --mask none.png", "cannot load 'none.png': there is no such file"},
        {"none.png nothing.png", "cannot load 'none.png': there is no such file"},
        {"none.png b.png --map no/map.png",
         "cannot write 'no/map.png': the folder 'no' does not exist"},
        {"none.png b.png --json no/f.json",
         "cannot write 'no/f.json': the folder 'no' does not exist"},
        {"a.png", "B.png is missing"},
        {"a.png ''", "B.png must not be empty"},
        {"a.png b.png --mad x", "there is no option --mad"},
        {"a.png b.png --pixels-off-by-more-than 256",
         "--pixels-off-by-more-than takes a whole number from 0 to 255, not '256'"},
        {"a.png b.png --at-most 1.1", "--at-most takes a number from 0 to 1, not '1.1'"},
        {"a.png b.png --at-most 101%", "--at-most takes a number from 0 to 100, not '101'"},
        {"a.png b.png --at-most %", "--at-most takes a number from 0 to 100, not ''"}}) {
    const Outcome outcome = desk.compare(words);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.starts_with("error: " + std::string(reason) + "\n"));
  }
  CHECK(desk.folder.size() == 5);  // the four pictures and the text: nothing was written
  CHECK(has(desk.compare("a.png").err, "usage: compare A.png [B.png] [options]"));
}

TEST_CASE("a stdout that takes nothing is trouble") {
  const Desk desk;
  if (run("echo x >/dev/full").status == 0) return;  // no such device here
  CHECK(desk.compare("a.png a.png >/dev/full").status == 2);
  CHECK(desk.compare("a.png b.png >/dev/full").status == 2);
  CHECK(desk.compare("a.png b.png --quiet >/dev/full").status == 1);
}

TEST_CASE("what is printed is the table and the verdict to the byte, without lines of no meaning") {
  const Desk desk;
  const Outcome same = desk.compare("a.png a.png");
  CHECK(same.err.empty());
  CHECK(same.out ==
        "size                 100 x 100 pixels, 10000 compared\n"
        "different            0 of 10000 pixels by more than one level (0 %), 0 by one\n"
        "mean absolute error  0 levels\n"
        "RMSE                 0 levels\n"
        "PSNR                 infinite dB\n"
        "SSIM                 1 (1: equal)\n"
        "mean value           20 and 20 levels\n"
        "off by more than 0: 0 pixels, 0 of all allowed: the same\n");
  CHECK_FALSE(has(desk.compare("a.png b.png").out, "SSIM"));
  CHECK(desk.compare("a.png b.png --all").out ==
        "size                 100 x 100 pixels, 10000 compared\n"
        "different            2 of 10000 pixels by more than one level (0.02 %), 1 by one\n"
        "within               columns 10 to 50, rows 20 to 25\n"
        "largest difference   5 levels at column 10, row 20: (31, 20, 9) and (36, 20, 9)\n"
        "mean absolute error  0.000366667 levels\n"
        "RMSE                 0.0412311 levels\n"
        "PSNR                 75.8263 dB\n"
        "SSIM                 0.9999658092 (1: equal)\n"
        "mean value           20 and 20 levels\n"
        "off by more than 0: 3 pixels, 0 of all allowed: they differ\n");
}

TEST_CASE("the mean, least and largest byte of each channel in a part of a picture") {
  const Desk desk;
  CHECK(desk.compare("--mean 10,20,5,6 b.png").out ==
        "columns 10 to 14, rows 20 to 25: 5 x 6 pixels\n"
        "red    mean 31.17, least 31, largest 36\n"
        "green  mean 19.83, least 15, largest 20\n"
        "blue   mean 9.00, least 9, largest 9\n");
  CHECK(desk.compare("b.png --mean 99,99,1,1").status == 0);
  for (const auto& [words, reason] :
       {std::pair{"--mean 99,0,2,1",
                  "the rectangle ends at column 100, row 0; the picture has 100 x 100 pixels"},
        {"--mean 0,0,1,101",
         "the rectangle ends at column 0, row 100; the picture has 100 x 100 pixels"},
        {"--mean 0,0,1", "--mean takes X,Y,W,H such as 350,250,100,100, not '0,0,1'"},
        {"--mean 0,0,1,1,1", "--mean takes a whole number from 1 to 16384, not '1,1'"},
        {"--mean 0,0,0,1", "--mean takes a whole number from 1 to 16384, not '0'"},
        {"--mean -1,0,1,1", "--mean takes a whole number from 0 to 16384, not '-1'"},
        {"b.png --mean 0,0,1,1", "B.png and --mean do not go together"},
        {"--mean 0,0,1,1 --all", "--all and --mean do not go together"}}) {
    const Outcome outcome = desk.compare("a.png " + std::string(words));
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.starts_with("error: " + std::string(reason) + "\n"));
  }
}

TEST_CASE("the map, the figures as JSON and the mask are those of the library") {
  const Desk desk;
  Image mask(100, 100, {0, 0, 1});  // only black leaves out
  mask.at(10, 20) = {};
  save_png(mask, desk.folder / "mask.png");
  CHECK(desk.compare("a.png b.png --quiet --mask mask.png --map map.png --json f.json").status ==
        1);
  CHECK(load_image(desk.folder / "map.png") == difference_map(desk.a, desk.b, mask));
  CHECK(text_in(desk.folder / "f.json") == R"({
  "width": 100,
  "height": 100,
  "pixels_compared": 9999,
  "pixels_different": 2,
  "share_different": 0.00020002000200020003,
  "box": {"left": 12, "top": 21, "width": 39, "height": 5},
  "largest_difference": {"levels": 5, "column": 12, "row": 25, "a": [31, 20, 9], "b": [31, 15, 9]},
  "mean_absolute_error": 0.00020002000200020003,
  "root_mean_square_error": 0.029440674958310088,
  "psnr": "finite",
  "psnr_db": 78.75184835996947,
  "ssim": 0.999982547970944,
  "mean_a": 20,
  "mean_b": 19.999866653332
}
)");
  // With all that differs left out, the pictures are the same.
  for (const auto& [column, row] : {std::pair{12, 25}, {50, 21}}) mask.at(column, row) = {};
  save_png(mask, desk.folder / "mask.png");
  CHECK(desk.compare("a.png b.png --quiet --mask mask.png --json f.json").status == 0);
  for (const char* part : {"\"box\": null,", "\"largest_difference\": null,",
                           "\"psnr\": \"infinite\",\n  \"psnr_db\": null,\n  \"ssim\": 1,"})
    CHECK(has(text_in(desk.folder / "f.json"), part));
}
