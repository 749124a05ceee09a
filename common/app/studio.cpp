// What every chapter's user can choose, and the way from a lesson to a picture on disk.
#include "studio.hpp"

#include <array>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "progress.hpp"
#include "save_png.hpp"
#include "standard_streams.hpp"

namespace texmap {
namespace {

constexpr int longest_side = 16384;
constexpr long most_pixels = 1L << 26;

}  // namespace

Studio::Studio(std::string_view chapter, CommandLine& line, Offered numbers)
    : out("out/" + std::string(chapter) + ".png"), default_out_(out), line_(line) {
  line.text("--out", "FILE", out, "where to put the picture, a PNG");
  line.whole("--width", width, 1, longest_side, "columns of pixels");
  line.whole("--height", height, 1, longest_side, "rows of pixels");
  line.whole("--samples", samples, 1, 65536, "rays a pixel: 1 looks through its center, more smooth the edges");
  line.whole("--threads", threads, 0, 1024, "threads to draw with, 0 for one per core; the picture is the same");
  if (numbers == Offered::all) {
    offer_all_numbers();
  } else {
    number = Number::double_;
    line.choice<Number>("--number", number,
                        {{"float", Number::float_}, {"double", Number::double_}, {"extended", Number::extended}},
                        "the number to calculate with");
  }
  line.flag("--quiet", quiet, "no progress, nothing printed on success");
}

void Studio::offer_all_numbers() {
  line_.choice<Number>(
      "--number", number,
      {{"float", Number::float_},
       {"double", Number::double_},
       {"extended", Number::extended},
       {"float-pack", Number::float_pack},
       {"double-pack", Number::double_pack},
       {"interval", Number::interval}},
      "the number to calculate with; interval draws how sure each pixel is: gray where no rounding can change its "
      "bytes, yellow to violet for 1 to 255 levels of doubt");
  line_.choice<Instructions>(
      "--instructions", instructions,
      {{"baseline", Instructions::baseline}, {"avx2", Instructions::avx2}, {"avx512", Instructions::avx512}},
      "what packs are made of; the machine's widest unless given");
}

void Studio::offer_forms() {
  line_.choice<SphereForm>(
      "--spheres", spheres, {{"plain", SphereForm::plain}, {"robust", SphereForm::robust}, {"hybrid", SphereForm::hybrid}},
      "formulas for meeting a sphere: robust draws every scene of the course; hybrid, some 6 times slower, is for float beyond "
      "100 radii, an eye close above a surface, or tiny and huge units; plain shows how the textbook's fails");
}

void Studio::prefer_size(int columns, int rows) {
  if (!line_.typed("--width")) width = columns;
  if (!line_.typed("--height")) height = rows;
}

void Studio::prefer_samples(int count) {
  if (!line_.typed("--samples")) samples = count;
}

void Studio::check() const {
  if (!machine_has(instructions)) {
    throw UsageError(
        "--instructions: this machine cannot run them; without the option the program takes the widest that it can");
  }
  if (static_cast<long>(width) * height > most_pixels) {
    throw UsageError("--width " + std::to_string(width) + " times --height " + std::to_string(height) +
                     " must be at most 67108864 (2^26) pixels");
  }
  if (out == default_out_) {
    std::error_code error;
    std::filesystem::create_directories("out", error);  // what goes wrong is said by the check of the file
  }
  check_output(out);
}

std::string Studio::file_name(std::string_view suffix) const {
  const auto slash = out.find_last_of('/');
  const auto dot = out.find_last_of('.');
  const bool has_ending = dot != std::string::npos && (slash == std::string::npos || dot > slash + 1);
  const std::size_t at = has_ending ? dot : out.size();
  return out.substr(0, at) + std::string(suffix) + out.substr(at);
}

Image Studio::timed(double rays, const std::function<Image(const RenderSettings&)>& work) {
  Progress progress(!quiet, remark);
  if (before_drawing_) load_ = before_drawing_->milliseconds();
  before_drawing_.reset();
  const Stopwatch drawing;
  Image image =
      work({.samples = samples, .threads = threads, .instructions = instructions, .progress = [&progress](int done, int total) {
              progress.report(done, total);
            }});
  render_ += drawing.milliseconds();
  rays_ += rays;
  return image;
}

void Studio::save(const Image& image, std::string_view suffix) {
  const std::string file = file_name(suffix);
  const SavingTime saving = save_png(image, file);
  if (!quiet) {
    std::array<char, 200> figures{};
    std::snprintf(figures.data(), figures.size(),
                  ": %d x %d pixels, %.1f ms (load %.1f, render %.1f, encode %.1f, write %.1f), %.1f million rays/s\n",
                  image.width, image.height, load_ + render_ + saving.encode + saving.write, load_, render_, saving.encode,
                  saving.write, rays_ / render_ / 1000);
    print(file + figures.data());
  }
  load_ = 0;
  render_ = 0;
  rays_ = 0;
}

}  // namespace texmap
