// An exhibit of any type: its name, and how the program draws it, alone and on the sheet.
#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "engine/draw/settings.hpp"
#include "engine/files/sheet_image.hpp"
#include "math/color.hpp"
#include "number/kinds/judge.hpp"
#include "scene/camera.hpp"
#include "texture/uv.hpp"

namespace texmap {
class Chosen;
class Session;
struct Offer;
}  // namespace texmap

namespace texmap::chapter_14 {

/// Drawn where a formula gives a place outside the texture, or no number at all.
inline constexpr Rgb no_texel{1, 0, 1};
/// Drawn where a ray misses the object on show.
inline constexpr Rgb background{0.1, 0.1, 0.15};
inline constexpr Rgb sky{0.6, 0.75, 1};

/// Which formulas draw: the source documents' or the course's.
enum class Formulas {
  published,  ///< the source documents'; spheres by b^2 - ac; of shadows with their fixed t > 0.001
  robust,     ///< the course's, of the form that the scene needs
};

/// What one ray sees, and where on the texture it looks.
template <class Real>
struct SurfacePoint {
  Color<Real> color{};
  Uv<Real> uv{};  ///< of a hit on a textured object
  bool hit = false;
  bool mapped = false;   ///< true if `uv` means anything
  Real round = Real(1);  ///< length of the circle at this v over the equator's: weighs errors of u
};

/// What every exhibit's scene begins with.
struct Placed {
  const char* name;
  const char* caption;
  Camera camera;
};

/// One picture of an exhibit, and what each of its pixels sees.
struct Panel {
  Image image;
  std::vector<SurfacePoint<Judge>> points;  ///< without their colors

  Panel(int width, int height) : image(width, height), points(image.pixels.size()) {}
};

/// The pictures of an exhibit: four to compare, and the reference.
enum Variant {
  published_float,
  robust_float,
  published_double,
  robust_double,
  reference,  ///< robust, in Judge
  variants
};

struct Exhibit {
  std::string name;
  std::string caption;
  /// Draws one row of a panel.
  std::function<void(Panel& panel, Variant variant, int row)> draw_row;
  /// The whole picture, with the number that the user chose.
  std::function<Image(Formulas formulas, NumberKind number, int width, int height,
                      const RenderSettings& settings)>
      draw;
};

/// All exhibits, in the order of the sheet.
///
/// @param earth   on the globes
/// @param labels  on the needle
[[nodiscard]] std::vector<Exhibit> all_exhibits(const SharedImage& earth,
                                                const SharedImage& labels);

/// The options that choose one exhibit and how it is drawn; the sheet shows all of them.
struct ExhibitOptions {
  std::string name;  ///< empty: the sheet
  Formulas formulas = Formulas::robust;
  NumberKind number = NumberKind::double_;
  int samples = 1;

  void declare(Offer& offer);
  /// Hands number, samples and size on to the settings.
  /// Errors: UsageError for options that mean nothing on the sheet.
  void apply_to(Chosen& chosen) const;
};

/// How far one picture is from the reference.
struct Mistakes {
  int wrong = 0;            ///< pixels of another color, by more than one level of 255
  int missed = 0;           ///< pixels where only one of the two sees a surface
  Judge texels = Judge(0);  ///< the largest distance between the places on a texture of 8192 x 4096
};

/// The sheet and its figures.
struct Sheet {
  SheetImage picture;
  std::string table;
  std::vector<std::array<Mistakes, reference>> mistakes;  ///< of each exhibit, in their order
};

/// Draws every exhibit in all variants, on a sheet as large as the session's picture.
[[nodiscard]] Sheet draw_sheet(const std::vector<Exhibit>& exhibits, Session& session);

/// The picture of the exhibit of that name.
/// Errors: UsageError that lists all names if there is none.
[[nodiscard]] Image draw_exhibit(const std::vector<Exhibit>& exhibits, const std::string& name,
                                 Formulas formulas, Session& session);

/// Draws and saves what the user asked for: one exhibit, or the sheet with its table.
void show_exhibits(const std::vector<Exhibit>& exhibits, const ExhibitOptions& options,
                   Session& session);

}  // namespace texmap::chapter_14
