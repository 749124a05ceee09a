// The computed diagram of chapter 11: a frame and a raised normal.
#include <cmath>

#include "diagrams.hpp"
#include "texture/bump.hpp"

namespace texmap::diagrams {
namespace {

/// A round hill: the height at (x, z), and its slopes by both.
struct Hill {
  double height, size;

  template <class Real>
  [[nodiscard]] Real operator()(const Real& x, const Real& z) const {
    const Real near = Real(1) + (x * x + z * z) * Real(1 / (size * size));
    return Real(height) / (near * near);
  }
};

/// The frame t, b, n on a flat surface, and a hill's raised normal; on the right a cut.
Drawing raised_normal_diagram() {
  Drawing d("raised_normal", 680, 262, "The normal of a raised surface",
            "Left: a grid that rises to a hill, and at a point of its slope the frame of the flat "
            "surface below: t and b along it, n straight up, and the raised surface's normal, "
            "which leans downhill. Right: a cut. A step t raises the point by the slope; the "
            "vector t plus slope times n lies in the raised surface, and the raised normal is at "
            "a right angle to it.");
  const Hill hill{0.75, 0.8};
  const double x = -0.55, z = 0.25;
  const Dual<double> h = hill(Dual<double>{x, 1, 0}, Dual<double>{z, 0, 1});
  // t x b = n, with t along x and b along -z.
  const Vec3d t{1, 0, 0}, b{0, 0, -1}, n{0, 1, 0};
  const Frame<double> frame{t, b};
  const Slope<double> slope{h.value, h.dx, -h.dy};
  const Vec3d raised = raised_normal(n, frame, slope, 0.0, BumpForm::exact);

  const SpaceView view({0.5, 0.55, 1}, {180, 146}, 112);
  const auto on_hill = [&](double a, double c) { return Vec3d{a, hill(a, c), c}; };
  for (int i = -3; i <= 3; ++i) {
    std::vector<Spot> along_x, along_z;
    for (int k = -20; k <= 20; ++k) {
      along_x.push_back(view(on_hill(k * 0.06, i * 0.4)));
      along_z.push_back(view(on_hill(i * 0.4, k * 0.06)));
    }
    d.curve(along_x, "soft");
    d.curve(along_z, "soft");
  }
  const Vec3d at = on_hill(x, z);
  const auto draw_arrow = [&](const Vec3d& along, double size, const char* style,
                              const std::string& word, Spot label) {
    d.arrow(view(at), view(at + along * size), style);
    d.text(view(at + along * size) + label, word, Anchor::middle, style);
  };
  draw_arrow(t, 0.7, "blue", "t", {12, -3});
  draw_arrow(b, 1.3, "blue", "b", {11, 2});
  draw_arrow(n, 0.95, "blue", "n", {12, 2});
  draw_arrow(raised, 0.95, "red thick", "n'", {-12, 0});
  d.dot(view(at));
  d.text({180, 250}, "t and b along the flat surface, n up", Anchor::middle, "small");

  // The cut: one step t of the flat surface.
  const double unit = 120, rise = 0.5;
  const Spot foot{490, 156};
  const Spot step{unit, 0}, up{0, -rise * unit};
  d.line({400, foot.y}, {660, foot.y}, "ink");
  d.line(foot + (step + up) * -0.7, foot + (step + up) * 1.25, "ink thick");
  d.arrow(foot, foot + step, "blue");
  d.line(foot + step, foot + step + up, "blue dashed");
  d.arrow(foot, foot + step + up, "green");
  d.arrow(foot, foot + Spot{0, -unit}, "blue");
  const double size = std::sqrt(1 + rise * rise);
  const Spot lean = Spot{-rise, -1} * (unit / size);
  d.arrow(foot, foot + lean, "red thick");
  const Spot along = (step + up) * (1 / size / unit), across = lean * (1 / unit);
  d.curve({foot + along * 14, foot + along * 14 + across * 14, foot + across * 14}, "ink");
  d.text(foot + step * 0.5 + Spot{0, 20}, "t", Anchor::middle, "blue");
  d.text(foot + step + up * 0.5 + Spot{8, 5}, "h_t", Anchor::start, "blue");
  d.text(foot + Spot{12, -unit + 6}, "n", Anchor::start, "blue");
  d.text(foot + lean + Spot{-12, 2}, "n'", Anchor::end, "red");
  d.text(foot + (step + up) * 0.72 + Spot{-10, -12}, "t + h_t n", Anchor::end, "green");
  d.text({405, foot.y - 8}, "flat", Anchor::start, "small");
  d.text({530, 250}, "a cut: the height rises to the right", Anchor::middle, "small");
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_11() { return {raised_normal_diagram()}; }

}  // namespace texmap::diagrams
