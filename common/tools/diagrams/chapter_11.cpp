// The diagrams of chapter 11: a frame and a raised normal, bump or dent, two facets.
#include <cmath>
#include <numbers>

#include "diagrams.hpp"
#include "scene/two_facets.hpp"
#include "texture/bump.hpp"
#include "texture/normal_map.hpp"

namespace texmap::diagrams {
namespace {

constexpr double radians = std::numbers::pi / 180;

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
  d.mark("foot", foot);
  d.mark("along", foot + step + up);
  d.mark("raised", foot + lean);
  d.mark("hill top", view(on_hill(0, 0)));
  d.mark("point", view(at));
  d.mark("normal", view(at + n * 0.95));
  d.mark("leaning", view(at + raised * 0.95));
  return d;
}

/// One file under one lamp, its green read as it was meant and inverted.
Drawing green_up_or_down() {
  Drawing d("green_up_or_down", 680, 300, "A bump read as a dent",
            "Two cuts along the direction of v under the same lamp. Left: the normals of a bump; "
            "the flank towards the lamp is lit. Right: the same colors with green inverted; the "
            "normals lean the other way, the flank towards the lamp is dark, and the surface that "
            "has such normals is a dent.");
  const double lean = 45 * radians;
  const Vec3d facing_v{0, std::sin(lean), std::cos(lean)};
  const Rgb8 bright = color_of_normal(facing_v);
  const Rgb8 dark = color_of_normal({0, -facing_v.y, facing_v.z});
  const auto words = [](const Rgb8& c) {
    return std::to_string(c.r) + ", " + std::to_string(c.g) + ", " + std::to_string(c.b);
  };
  const Vec3d lamp = normalize(Vec3d{0, 0.8, 0.6});  // in (red, green, blue)'s directions
  const auto panel = [&](double x, Green green) {
    const double sign = green == Green::up ? 1 : -1;
    const Spot left{x, 190}, right{x + 260, 190};
    // v grows to the left, n is up. A trapezoid of flanks of 45 degrees, up or down.
    const double size = 52;
    const Spot a{x + 60, 190}, b{x + 60 + size, 190 - sign * size};
    const Spot c{x + 200 - size, 190 - sign * size}, e{x + 200, 190};
    d.line(left, a, "ink");
    d.line(e, right, "ink");
    d.line(b, c, "ink");
    for (const double facing : {1.0, -1.0}) {
      const Spot from = facing > 0 ? a : c, to = facing > 0 ? b : e;
      const double part = sign * facing * facing_v.y;  // the normal's part along v
      const double light = part * lamp.y + facing_v.z * lamp.z;
      const bool lit = light > 0.1;
      d.line(from, to, lit ? "red thick" : "ink thick");
      const Spot middle = (from + to) * 0.5;
      d.arrow(middle, middle + Spot{-part, -facing_v.z} * 62, "blue");
      const Spot label = green == Green::up ? Spot{0, 50} : Spot{facing * -42, 16};
      d.text(middle + label, lit ? "lit" : "dark", Anchor::middle, lit ? "red small" : "small");
      const std::string name = green == Green::up ? "up" : "down";
      d.mark(name + (facing > 0 ? " near" : " far"), middle);
      d.mark(name + (facing > 0 ? " near tip" : " far tip"),
             middle + Spot{-part, -facing_v.z} * 62);
      d.text({facing > 0 ? x + 66 : x + 194, 278}, words(facing > 0 ? bright : dark),
             Anchor::middle, "small");
    }
    d.arrow({x + 34, 60}, Spot{x + 34, 60} + Spot{lamp.y, lamp.z} * 46, "red");
    d.text({x + 8, 50}, "lamp", Anchor::start, "red small");
  };
  panel(40, Green::up);
  panel(380, Green::down);
  d.text({170, 24}, "green read as meant: a bump", Anchor::middle, "strong");
  d.text({510, 24}, "green inverted: a dent", Anchor::middle, "strong");
  d.arrow({352, 216}, {324, 216}, "ink");
  d.text({338, 206}, "v", Anchor::middle, "small");
  d.text({338, 278}, "in the file", Anchor::middle, "small");
  return d;
}

/// A surface of two kinds of facets: one has the shading normal, one completes the surface.
Drawing two_facets_diagram() {
  const double lean = 35 * radians;
  Drawing d("two_facets", 680, 250, "Two facets",
            "A saw-tooth line on a flat surface. Its long facets have the shading normal, which "
            "leans to the left. Its short facets stand upright and face right. The mean of all "
            "facets' normals, weighted by their areas, is the true normal.");
  const double wide = 110;
  const Vec3d normal{0, 1, 0}, bent{-std::sin(lean), std::cos(lean), 0};
  const TwoFacets<double> facets = two_facets(normal, bent);
  const Spot start{90, 190};
  // A tooth rises to the right along the bent facet, and falls along the upright one.
  const Spot rise{wide, -wide * facets.upright_area};
  const auto to_spot = [](const Vec3d& v) { return Spot{v.x, -v.y}; };
  for (int i = 0; i < 4; ++i) {
    const Spot foot = start + Spot{i * wide, 0};
    d.line(foot, foot + rise, "blue thick");
    d.line(foot + rise, foot + Spot{wide, 0}, "red thick");
  }
  d.line(start + Spot{-40, 0}, start + Spot{4 * wide + 40, 0}, "soft");
  const Spot on_bent = start + Spot{wide, 0} + rise * 0.5;
  const Spot on_upright = start + Spot{4 * wide, 0} + Spot{0, rise.y * 0.5};
  const double size = 78;
  d.arrow(on_bent, on_bent + to_spot(facets.bent) * size, "blue");
  d.arrow(on_upright, on_upright + to_spot(facets.upright) * size, "red");
  const Spot between = start + Spot{2.35 * wide, 0} + Spot{0, -wide * 0.9};
  d.arrow(between + Spot{0, 10}, between + Spot{0, 10 - size}, "ink");
  d.text(between + Spot{10, 16 - size}, "n, the mean", Anchor::start);
  d.text(on_bent + to_spot(facets.bent) * size + Spot{-8, 0}, "shading normal n'", Anchor::end,
         "blue small");
  d.text(on_upright + to_spot(facets.upright) * size + Spot{0, -12}, "upright facet",
         Anchor::middle, "red small");
  d.text(start + Spot{wide / 2, 22}, "1", Anchor::middle, "small");
  d.text({340, 236}, "areas for a width of 1: long facet 1 / cos a, upright facet tan a",
         Anchor::middle, "small");
  d.mark("foot", start);
  d.mark("tip", start + rise);
  d.mark("next", start + Spot{wide, 0});
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_11() {
  return {raised_normal_diagram(), green_up_or_down(), two_facets_diagram()};
}

}  // namespace texmap::diagrams
