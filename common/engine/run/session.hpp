// Draws and saves what the user chose.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "engine/run/chosen.hpp"
#include "scene/camera.hpp"
#include "texture/image.hpp"

namespace texmap {

class Session {
 public:
  /// @param choices  must live as long as the session
  explicit Session(Chosen& choices) : chosen(choices), settings(choices.settings) {}

  Chosen& chosen;
  const Settings& settings;  ///< the user's

  /// The lesson's picture.
  template <class Lesson>
  [[nodiscard]] Image draw(const Lesson& lesson) {
    return draw(lesson, settings.width, settings.height);
  }
  /// The lesson's picture in another size. Defined in draw_lesson.hpp.
  template <class Lesson>
  [[nodiscard]] Image draw(const Lesson& lesson, int width, int height);
  /// Draws and saves the lesson's picture, or those of its turntable. Defined in draw_lesson.hpp.
  template <class Lesson>
  void save_frames(Lesson& lesson);
  /// The view of a lesson's camera for a picture of this size, or the user's close-up of it.
  /// Errors: UsageError if there is no such pixel.
  [[nodiscard]] View<> view(const Camera& camera, int width, int height);

  /// Writes a picture and prints a line about it: file, size, milliseconds, rays a second.
  ///
  /// @param suffix  before the file's ending, for chapters with several pictures
  /// Errors: FileError, and UsageError if --zoom or --show was given and the picture was not drawn
  /// through view(); the old file is then unchanged.
  void save(const Image& image, std::string_view suffix = "");
  /// The name of the file that save() writes: a device has no suffix.
  [[nodiscard]] std::filesystem::path file_name(std::string_view suffix) const;

  /// What `work` draws with the user's settings; save() reports its time and rays.
  [[nodiscard]] Image timed(double rays, const std::function<Image(const RenderSettings&)>& work);
  /// Adds to the rays that save() reports.
  void count_rays(double rays) { times_.rays += rays; }
  /// What to append to the progress line; called from any thread.
  std::function<std::string()> remark;
  std::string sentence;    ///< about the picture, which save() prints
  Image* taken = nullptr;  ///< where save() puts a picture; null: into its file
  /// `diagnose` compares only every n-th column of every n-th row, from the second on.
  int every = 1;
  [[nodiscard]] bool needs(int column, int row) const {
    return (column - 1) % every == 0 && (row - 1) % every == 0;
  }

 private:
  /// What happened since the last picture was saved; times in milliseconds.
  struct Times {
    double load = 0, render = 0;  ///< before the first ray, and from it on
    double rays = 0;
    long uncertain = 0, judged = 0;  ///< pixels that rounding could change; all with bounds
  };

  bool has_drawn_ = false;
  bool seen_by_camera_ = false;  // what is saved next
  Times times_{};
};

/// The base of a lesson whose pictures no camera sees: it offers no --number, --samples, --zoom.
struct SheetLesson : LessonHooks {};

}  // namespace texmap
