// One run of a chapter's program: the user's choices, drawing, saving.
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "engine/app/lesson.hpp"
#include "engine/measure/stopwatch.hpp"
#include "engine/render/settings.hpp"
#include "scene/camera.hpp"
#include "scene/sphere_forms.hpp"
#include "texture/image.hpp"

namespace texmap {

/// The user's choices; a chapter may offer fewer.
struct Settings {
  std::string out;                                    ///< the picture's file
  int width = 800;                                    ///< pixels
  int height = 600;                                   ///< pixels
  int samples = 1;                                    ///< rays per pixel
  int threads = 0;                                    ///< 0: all cores
  NumberKind number = NumberKind::double_pack;        ///< draws what double draws (tests/packs)
  Instructions instructions = widest_instructions();  ///< of packs
  SphereForm spheres = SphereForm::robust;            ///< for all spheres of the lesson
  std::string budget = "exact";                       ///< how far off the picture may be
  bool quiet = false;                                 ///< no progress, no line on success
  Shown show = Shown::color;                          ///< of the surfaces that the camera sees
  double zoom = 1;                                    ///< 1: the lesson's view
  std::string at;  ///< COLUMN,ROW of the pixel that stays in its place; empty: the middle
};

/// What decides which options are offered.
struct Offers {
  bool spheres = false;     ///< --spheres
  bool surfaces = false;    ///< --show
  bool one_number = false;  ///< the program was built for learning, with double alone
};

class Session {
 public:
  /// Adds the options of all chapters to `line`, which must live as long as the session.
  ///
  /// @param chapter  its folder's name, such as 02_checkerboard_uv: the picture's default name
  Session(std::string_view chapter, CommandLine& line, const About& about,
          const Offers& offers = {});

  Settings settings;

  [[nodiscard]] bool was_given(std::string_view option) const;
  void default_size(int width, int height);
  /// After a lesson's `prepare`, which may change the size: refuses pictures that are too large and
  /// files that cannot be written.
  void check() const;
  /// Then lets the lesson's groups of options make their plans: once, not for each frame of a turn.
  void plan() const;
  /// Refuses groups of options that `prepare` did not use, such as a texture that is never loaded.
  /// Errors: std::logic_error.
  void check_uses() const;

  /// The lesson's picture.
  template <class Lesson>
  [[nodiscard]] Image draw(const Lesson& lesson) {
    return draw(lesson, settings.width, settings.height);
  }
  /// The lesson's picture in another size. Defined in run_chapter.hpp.
  /// Errors: std::logic_error for a lesson that gathers light, unless --show was given.
  template <class Lesson>
  [[nodiscard]] Image draw(const Lesson& lesson, int width, int height);
  /// Draws and saves the lesson's picture, or all those of its turntable. Defined in
  /// run_chapter.hpp.
  template <class Lesson>
  void draw_all(Lesson& lesson);
  /// The view of a lesson's camera for a picture of this size, or the user's close-up of it.
  /// Errors: UsageError if there is no such pixel.
  [[nodiscard]] View<> view(const Camera& camera, int width, int height);

  /// Writes a picture and prints a line about it: file, size, milliseconds, rays a second.
  ///
  /// @param suffix  before the file's ending, for chapters with several pictures
  /// Errors: FileError, and UsageError if --zoom or --show was given and the picture was not drawn
  /// through view(); the old file is then unchanged.
  void save(const Image& image, std::string_view suffix = "");
  /// The name of the file that save() writes.
  [[nodiscard]] std::filesystem::path file_name(std::string_view suffix) const;

  /// What `work` draws with the user's settings; save() reports its time and rays.
  [[nodiscard]] Image timed(double rays, const std::function<Image(const RenderSettings&)>& work);
  /// Adds to the rays that save() reports.
  void count_rays(double rays);
  /// What to append to the progress line; called from any thread.
  std::function<std::string()> remark;

 private:
  /// What happened since the last picture was saved; times in milliseconds.
  struct Times {
    std::optional<Stopwatch> before_drawing;  ///< until the first ray
    double load = 0, render = 0;              ///< before the first ray, and from it on
    double rays = 0;
    long uncertain = 0, judged = 0;  ///< pixels that rounding could change; all with bounds
  };
  void offer_numbers(Numbers numbers, std::string_view no_intervals);

  std::string default_out_;
  bool one_number_;
  bool seen_by_camera_ = false;  // what is saved next
  CommandLine& line_;
  Times times_;
};

}  // namespace texmap
