// Draws and saves what the user chose.
#include "engine/run/session.hpp"

#include <cstdio>
#include <stdexcept>

#include "engine/draw/progress.hpp"
#include "engine/files/save_png.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"
#include "engine/run/command_line.hpp"
#include "engine/run/turntable.hpp"

namespace texmap {
namespace {

/// The pixel that --at names in a picture of this size. Errors: UsageError.
PixelPlace<double> pixel_at(std::string_view typed, int width, int height) {
  const std::size_t comma = typed.find(',');
  usage_error_if(comma == std::string_view::npos,
                 "--at takes COLUMN,ROW such as 400,300, not '" + std::string(typed) + "'");
  return {double{1} * parse_whole("the column of --at", typed.substr(0, comma), 0, width - 1),
          double{1} * parse_whole("the row of --at", typed.substr(comma + 1), 0, height - 1)};
}

/// Prints a line about a picture that is written, and is so whether this fails or not.
void print_about(const std::string& line) {
  try {
    print(line);
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "the picture is written, but not the line about it: %s\n", error.what());
  }
}

}  // namespace

View<> Session::view(const Camera& camera, int width, int height) {
  seen_by_camera_ = true;
  View<> view = view_of(camera, width, height);
  const PixelPlace<double> fixed = settings.at.empty()
                                       ? PixelPlace<double>{view.center_column, view.center_row}
                                       : pixel_at(settings.at, width, height);
  // The ray through `fixed` + d is then that of the whole picture through `fixed` + d / zoom.
  view.pixel = view.pixel / settings.zoom;
  view.center_column = fixed.column + settings.zoom * (view.center_column - fixed.column);
  view.center_row = fixed.row + settings.zoom * (view.center_row - fixed.row);
  return view;
}

std::filesystem::path Session::file_name(std::string_view suffix) const {
  std::filesystem::path file = path_of(settings.out);
  if (is_stream(file)) return file;
  std::filesystem::path name = file.stem();
  name += path_of(suffix);
  name += file.extension();
  return file.replace_filename(name);
}

// Not with the turntable's options: a program without them would read files.
std::string frame_suffix(int frame) { return text("_%03d", frame); }

Image Session::timed(double rays, const std::function<Image(const RenderSettings&)>& work) {
  Progress progress(!settings.quiet, remark);
  if (!has_drawn_) times_.load = chosen.since_start.milliseconds();
  has_drawn_ = true;
  const Stopwatch drawing;
  Image image =
      work({.samples = settings.samples,
            .threads = settings.threads,
            .instructions = settings.instructions,
            .progress = [&progress](int done, int total) { progress.report(done, total); },
            .certainty =
                [this](long uncertain, long pixels) {
                  times_.uncertain += uncertain;
                  times_.judged += pixels;
                }});
  times_.render += drawing.milliseconds();
  times_.rays += rays;
  return image;
}

void Session::save(const Image& image, std::string_view suffix) {
  usage_error_if(
      (settings.show != Shown::color || settings.zoom != 1) && !seen_by_camera_,
      "--zoom and --show normal, uv and object work only for pictures that a camera sees; this "
      "picture has no camera");
  seen_by_camera_ = false;
  if (taken != nullptr) {
    *taken = image;
    return;
  }
  const std::filesystem::path file = file_name(suffix);
  const SavingTime saving = save_png(image, file);
  if (!settings.quiet && !sentence.empty()) print_about(sentence);
  sentence.clear();
  if (!settings.quiet && times_.judged > 0) {
    print_about(text("rounding could change %ld of %ld pixels, each drawn three wide\n",
                     times_.uncertain, times_.judged));
  }
  if (!settings.quiet) {
    const double all = times_.load + times_.render + saving.encode + saving.write;
    print_about(name_of(file) +
                text(": %d x %d pixels, %.1f ms (load %.1f, render %.1f, encode %.1f, write %.1f)",
                     image.width, image.height, all, times_.load, times_.render, saving.encode,
                     saving.write) +
                (times_.rays > 0
                     ? text(", %.1f million rays/s\n", times_.rays / times_.render / 1000)
                     : "\n"));
  }
  times_ = {};
}

}  // namespace texmap
