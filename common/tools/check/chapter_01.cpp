// The exercises of chapter 01. The lesson is the chapter's own. Its color_along and sample_light
// are these here, which call the student's function.
#include <span>

#include "exercises.hpp"
#include "scene/light.hpp"

namespace texmap::chapter_01 {

using FirstHit = std::function<double(Vec3d, Vec3d)>;
using Lamps = std::vector<Vec3d>;
static std::function<double(Vec3d, Vec3d, Vec3d, double, double)> distance_to_bowl;
static std::function<double(Vec3d, Vec3d, Vec3d, double)> light_on_paper;
static std::function<double(Vec3d, Vec3d, const Lamps&, const FirstHit&)> visible;

static const double never = infinity<double>();  // a ray meets nothing

/// The distance to the first of `objects`, each with a `shape`, along a ray.
[[nodiscard]] static FirstHit first_hit_on(const auto& objects) {
  return [&objects](const Vec3d& origin, const Vec3d& direction) {
    return find_nearest(objects, Ray<double>{origin, direction}).distance;
  };
}

/// The distance to a sphere of which the points with y <= rim are left.
static double right_distance(Vec3d origin, Vec3d direction, Vec3d center, double radius,
                             double rim) {
  const double first = distance_to(Sphere<>{center, radius}, Ray<double>{origin, direction});
  const double sum = 2 * dot(center - origin, direction) / dot(direction, direction);
  for (const double t : {first, sum - first})
    if (t > 0 && t < never && origin.y + t * direction.y <= rim) return t;
  return never;
}

inline constexpr struct {
  Rgb operator()(const auto& objects, const Ray<double>& ray, const auto& background,
                 const auto& shade) const {
    if (!distance_to_bowl) return texmap::color_along(objects, ray, background, shade);
    const auto distance = [&](const auto& object) {
      const Vec3d center = object.shape.center;
      const double radius = object.shape.radius;
      const double rim = radius < 100 ? center.y + radius / 3 : never;  // the ground has none
      const double t = distance_to_bowl(ray.origin, ray.direction, center, radius, rim);
      const double right = right_distance(ray.origin, ray.direction, center, radius, rim);
      if (check::alike(right, t)) return right;  // rounded to float, the point is below the surface
      return t < never ? t : never;              // also for NaN
    };
    const auto& first = *std::ranges::min_element(objects, {}, distance);
    const double t = distance(first);
    if (!(t < never)) return background(ray);
    Hit<double> hit = hit_at(first.shape, ray, t);
    if (dot(hit.normal, ray.direction) > 0) {  // the inner side
      hit.normal = -hit.normal;
      hit.outside = hit.point - (hit.outside - hit.point);
    }
    return shade(first, hit);
  }
} color_along;

inline constexpr struct {
  LightSample<double> operator()(const PointLight& light, const auto& objects,
                                 const Hit<double>& hit) const {
    // Paper casts no shadow here, and each lamp of a row has its own.
    const auto shadows = std::span(objects).first(visible || light_on_paper ? 0 : objects.size());
    LightSample<double> sample = texmap::sample_light(light, shadows, hit);
    if (light_on_paper) sample.cosine = light_on_paper(hit.point, hit.normal, light.position, 0.6);
    if (visible && sample.cosine > 0) {
      Lamps row;
      for (const double x : {-1.2, -0.6, 0., 0.6, 1.2}) {
        // A lamp within 3 degrees of the horizon is left out: hidden or seen, both may be right.
        const Vec3d lamp = light.position + Vec3d{x, 0, -x};
        if (abs(dot(hit.normal, normalize(lamp - hit.point))) > 0.05) row.push_back(lamp);
      }
      if (!row.empty()) sample.cosine *= visible(hit.point, hit.normal, row, first_hit_on(objects));
    }
    return sample;
  }
} sample_light;

}  // namespace texmap::chapter_01

#include "01_plain_spheres/lesson.hpp"

namespace texmap::check {
namespace {

using namespace chapter_01;

/// The two t of a ray and a sphere, NaN if there are none.
struct Roots {
  double entry, exit;
};
std::array<double, 2> parts(const Roots& t) { return {t.entry, t.exit}; }
Roots roots(double a, double b, double c) {
  const double root = sqrt(b * b - a * c);
  return {(b - root) / a, (b + root) / a};
}

Slips<double> wrong_distances(Vec3d o, Vec3d d, Vec3d center, double r, double rim) {
  const Vec3d f = o - center;
  const double ff = dot(f, f);
  const double a = dot(d, d), b = -dot(f, d), c = ff - r * r, inside = b * b - a * c;
  const double root = sqrt(inside);
  const auto by = [&](double other) { return Roots{(b - other) / a, (b + other) / a}; };
  // 2s and 4 that do not fit: school's formula and the page's, mixed.
  const auto mixed = [&](double of_b, double of_ac, double of_a) {
    const Roots t = roots(1, of_b * b, of_ac * a * c);
    return Roots{t.entry / (of_a * a), t.exit / (of_a * a)};
  };
  const auto at_center = [&](Vec3d from) {
    return roots(a, -dot(from, d), dot(from, from) - r * r);
  };
  const Slips<Roots> wrong_roots = {
      {"the ray runs backward: f is origin - center, and b is -dot(f, direction)", roots(a, -b, c)},
      {"directions have any length: divide by a = dot(direction, direction)", roots(1, b, a * c)},
      {"t counts in lengths of the direction, which need not be 1", roots(1, b / sqrt(a), c)},
      {"this is chapter 00's formula, for length 1: a = dot(d, d) is missing", roots(1, b, c)},
      {"with b = -dot(f, d), t is (b - sqrt(b * b - a * c)) / a",
       {{"you have no a in the discriminant", by(sqrt(b * b - c))},
        {"C++ reads x / 2 * a as (x / 2) * a", {(b - root) * a, (b + root) * a}},
        {"only the root has / a",
         {{b - root / a, b + root / a}, {2 * b - root / a, 2 * b + root / a}}},
        {"std::sqrt of the discriminant is missing", by(inside < 0 ? root : inside)},
        {"2s and 4 do not fit", {mixed(2, 1, 1), mixed(2, 1, 2), mixed(2, 4, 1), mixed(1, 1, 2)}}}},
      {"a is the direction's length squared: dot(direction, direction)", roots(sqrt(a), b, c)},
      {"c is dot(f, f) - radius * radius, and yours is another one",
       {roots(a, b, ff - r), roots(a, b, ff), roots(a, b, ff - 2 * r),
        roots(a, b, length(f) - r * r), roots(a, b, (length(f) - r) * (length(f) - r))}},
      {"the center is not subtracted everywhere: f is origin - center",
       {at_center(o), roots(a, -dot(o, d), c), at_center(o + center)}},
      {"a discriminant below 0 means that there is no point: return infinity",
       {by(sqrt(abs(inside))), by(sqrt(max(inside, 0.0)))}},
  };
  // What to make of the roots.
  const auto kept = [=](double t, double below = 0) { return o.y + t * d.y - below <= rim; };
  const auto first_of = [](const Roots& t, bool first, bool second) {
    return t.entry > 0 && first ? t.entry : t.exit > 0 && second ? t.exit : never;
  };
  const auto first_kept = [&](const Roots& t) { return first_of(t, kept(t.entry), kept(t.exit)); };
  const auto first_ahead = [&](const Roots& t) { return first_of(t, true, true); };
  const auto entry_kept = [&](const Roots& t) { return first_of(t, kept(t.entry), false); };
  const auto entry_alone = [](const Roots& t) { return std::isnan(t.entry) ? never : t.entry; };
  const Roots t = roots(a, b, c);
  const auto [entry, exit] = t;
  const bool missed = std::isnan(root);
  const double right = first_kept(t), whole = first_ahead(t), exit_kept = kept(exit) ? exit : never;
  const double any = kept(entry) ? entry : exit_kept;
  Slips<double> wrong = {
      {"always infinity: look at the signs in b * b - a * c, and at what you compare", never},
      {"a point counts only if its y is not above the rim",
       {{"the upper part is cut away", whole},
        {"the larger t, too", first_of(t, kept(entry), true)},
        {"this was cut away", first_of(t, !kept(entry), !kept(exit))},
        {"rim is a y in the scene", first_of(t, kept(entry, center.y), kept(exit, center.y))},
        {"its y is origin.y + t * direction.y",
         {o.y <= rim ? whole : never, first_of(t, entry <= rim, exit <= rim),
          first_of(t, entry * d.y <= rim, exit * d.y <= rim)}}}},
      {"from inside and through the open top: try the larger t if the smaller one does not count",
       {entry_kept(t), kept(whole) ? whole : never, first_of(t, true, false),
        any > 0 ? any : never}},
      {"the larger t comes second: the ray leaves the sphere there",
       {exit > 0 ? exit_kept : never, exit > 0 && kept(exit) ? exit : entry_kept(t)}},
      {"t counts in lengths of the direction, which need not be 1", right * sqrt(a)},
      {"the larger t comes second: the ray leaves the sphere there, and the upper part is cut away",
       {exit > 0 ? exit : never, missed ? never : exit}},
      {"a t below 0 is behind the origin: only t > 0 counts",
       {any, abs(entry_alone(t)), max(entry_alone(t), 0.0)}},
      {"a t below 0 is behind the origin, and the upper part is cut away", entry_alone(t)},
      {"the square root of a negative number is NaN: if the discriminant is below 0, return first",
       {missed ? entry : right, missed ? entry : whole}},
  };
  // Those who return another number for a miss do so in one place or in both, or in another way.
  for (const double miss : {0, -1}) {
    wrong += {"the task wants infinity for a miss, and you return another number",
              {missed ? miss : right, right < never ? right : miss, whole < never ? whole : miss}};
  }
  // Those who make another mistake often forget the rim, or take the first root alone, too.
  const std::function<double(const Roots&)> picks[] = {first_kept, first_ahead, entry_kept,
                                                       entry_alone};
  for (const auto& pick : picks) wrong += changed(wrong_roots, pick);
  return wrong;
}

constexpr Vec3d zero{0, 0, 0}, eye{0, 0, 5}, ahead{0, 0, -1}, up{0, 1, 0}, down{0, -1, 0},
    left{-1, 0, 0};

constexpr double high = 100;  // a rim above all of the sphere
constexpr Place<Vec3d, Vec3d, Vec3d, double, double> distance_to_bowl_places[] = {
    {"from (0, 0, 5) straight at the unit sphere, t is 4", {eye, ahead, zero, 1, high}},
    {"radius 1/2, center (3, 1, -2): t is 5.5", {{3, 1, 4}, ahead, {3, 1, -2}, 0.5, high}},
    {"lengths of the direction count: with (0, 0, -2), t is 2", {eye, {0, 0, -2}, zero, 1, high}},
    {"a ray that passes the sphere never meets it", {eye, {0, 1, -1}, zero, 1, high}},
    {"the ground, with radius 1000, is met at t = 10.007: a float has too few digits for it",
     {{0.3, 2, 8}, {0, -0.3, -1}, {0, -1001, 0}, 1000, high}},
    {"a sphere behind the origin is never met", {eye, {0, 0, 1}, zero, 1, high}},
    {"from inside, the ray meets the sphere at its exit", {{0, 0, 0.5}, {0, 0, 1}, zero, 1, high}},
    {"rim 0.5, from (0, 5, 0) straight down: through the open top to the bottom, t is 6",
     {{0, 5, 0}, {0, -1, 0}, zero, 1, 0.5}},
    {"rim 0.5, from (0, 0.3, 5) in the direction (0, 0, -1): below the rim, on the outside",
     {{0, 0.3, 5}, ahead, zero, 1, 0.5}},
    {"rim 0.5, from (0, 0.8, 5) to -z: above it, never", {{0, 0.8, 5}, ahead, zero, 1, 0.5}},
    {"rim 0.5, from the center straight up: out of the open top, never", {zero, up, zero, 1, 0.5}},
    {"rim 0.5, from (0, -3, 0) straight up: the bottom, t is 2", {{0, -3, 0}, up, zero, 1, 0.5}},
    {"radius 1/2 around (3, 1, -2), rim 1.2: from (3, 3, -2) straight down, t is 2.5",
     {{3, 3, -2}, {0, -1, 0}, {3, 1, -2}, 0.5, 1.2}},
    {"rim 0.5, from (0, 3, 3) in the direction (0, -1, -1): through the open top to the inside",
     {{0, 3, 3}, {0, -1, -1}, zero, 1, 0.5}},
};

double right_light(Vec3d p, Vec3d n, Vec3d lamp, double share) {
  const double cosine = dot(n, normalize(lamp - p));
  return cosine > 0 ? cosine : -cosine * share;
}

Slips<double> wrong_lights(Vec3d p, Vec3d n, Vec3d lamp, double share) {
  const Vec3d to = normalize(lamp - p), outward = normalize(p);
  const double c = dot(n, to), away = length(lamp - p), long_c = c * away, cut = max(c, 0.0);
  const auto sides = [](double front, double back) {
    return [=](double cosine) { return cosine * (cosine > 0 ? front : -back); };
  };
  const auto light = [=](double front, double back) { return sides(front, back)(c); };
  const Slips<double> cosines = {
      {"the direction to the lamp does not have length 1: normalize it", long_c},
      {"the sides are exchanged: the one that faces the lamp gets all of its light", {-c, -long_c}},
      {"the direction to the lamp is normalize(lamp - point)",
       {{"lamp is a position", {dot(n, normalize(lamp)), dot(n, lamp)}},
        {"you add point, or subtract normal",
         {dot(n, normalize(lamp + p)), dot(n, normalize(lamp - n)),
          dot(n, normalize(lamp - p - n))}},
        {"subtract first", {dot(n, normalize(lamp) - p), long_c / length(lamp)}}}},
      {"point is a position, no direction: the surface faces along normal",
       {dot(p, to), dot(outward, to), dot(p, lamp), dot(outward, normalize(lamp))}},
      {"the light is the cosine alone: neither its square nor the distance of the lamp counts",
       {c / away, c / (away * away), c * abs(c)}},
      {"the cross product is a sine: the cosine is the dot product", length(cross(n, to))},
  };
  return {
      changed(cosines, sides(1, share)),
      {"the side away from the lamp is dark: it gets a share of the light from behind", cut},
      changed(cosines, [](double cosine) { return max(cosine, 0.0); }),
      {"a lamp behind the paper gives share * -cosine",
       {{"yours is negative light", {c, light(1, -share), long_c, c > 0 ? c : -share}},
        {"the share is missing", light(1, 1)},
        {"straight behind is most, without 1 +", {c > 0 ? c : share * (1 + c), share * (1 + c)}},
        {"slanted light is weaker", {c > 0 ? c : share, max(c, share)}},
        {"1 - share does not go through the paper", light(1, 1 - share)},
        {"the share is a factor", {light(1, 1 / share), c > 0 ? c : -c - share}}}},
      {"the side that faces the lamp gets all of its light, no share, and nothing is added",
       {light(share, share), light(1 - share, share), light(share, 0), cut + share,
        cut + share * abs(c), cut + share * (1 - c)}},
      {"0.2 and 0.8 come later, with the color: return the light alone",
       {0.2 + 0.8 * cut, 0.2 + light(0.8, 0.8 * share), c > 0 ? c : 0.2}},
      {"this is the angle; the dot product already is its cosine",
       {acos(c), acos(cut), sides(1, share)(acos(c)), acos(c) / radian}},
      {"this says which side is lit: multiply by the cosine", {c > 0 ? 1. : 0., c > 0 ? 1 : share}},
      {"std::min keeps the smaller one: take std::max", {min(c, 0.0), min(c, -share * c)}},
  };
}

constexpr Place<Vec3d, Vec3d, Vec3d, double> light_on_paper_places[] = {
    {"a lamp straight above, at distance 1: the cosine is 1", {zero, up, {0, 1, 0}, 0.4}},
    {"a lamp straight above, at distance 3: the cosine is 1, too", {zero, up, {0, 3, 0}, 0.4}},
    {"60 degrees from the normal: the cosine is 1/2", {zero, up, {std::numbers::sqrt3, 1, 0}, 0.4}},
    {"point (5, 0, 2), lamp at 60 degrees from the normal there: the cosine is 1/2",
     {{5, 0, 2}, up, {5 + std::numbers::sqrt3, 1, 2}, 0.4}},
    {"normal +x, point (0, 0, 0), lamp (0.3, 0, 0.4): 0.6", {zero, {1, 0, 0}, {0.3, 0, 0.4}, 0.25}},
    {"normal +y, point (0, 2, 0), lamp (3, 6, 0): it is 0.8", {{0, 2, 0}, up, {3, 6, 0}, 0.25}},
    {"a lamp straight behind, and the share 0.4: the light is 0.4", {zero, up, {0, -3, 0}, 0.4}},
    {"a lamp behind, at 60 degrees from the opposite of the normal: half of the share",
     {{5, 0, 2}, up, {5 + std::numbers::sqrt3, -1, 2}, 0.4}},
    {"normal +y, point (0, 2, 0), lamp (3, -2, 0): 0.25 * 0.8", {{0, 2, 0}, up, {3, -2, 0}, 0.25}},
};

/// Whether something is nearer than the lamp along a ray that starts so far above the point.
bool is_hidden(Vec3d p, Vec3d n, Vec3d lamp, const FirstHit& first_hit, double lift = 0.001) {
  const Vec3d start = p + n * lift;
  return first_hit(start, normalize(lamp - start)) < length(lamp - start);
}

double right_share(Vec3d p, Vec3d n, const Lamps& lamps, const FirstHit& first_hit) {
  double seen = 0;
  for (const Vec3d& lamp : lamps) seen += is_hidden(p, n, lamp, first_hit) ? 0 : 1;
  return seen / double(lamps.size());
}

/// Whether one lamp is hidden.
Slips<bool> wrong_shadows(Vec3d p, Vec3d n, Vec3d lamp, const FirstHit& first_hit) {
  const auto lifted = [&](double lift) { return is_hidden(p, n, lamp, first_hit, lift); };
  Slips<bool> wrong = {
      {"let the ray start at point + normal * 0.001",
       {{"rounding lets it meet the sphere that it starts on", lifted(0)},
        {"yours starts below the surface", lifted(-0.001)},
        {"point is a position, to lift along the normal",
         first_hit(p * 1.001, normalize(lamp - p * 1.001)) < length(lamp - p * 1.001)},
        {"yours starts too far above and misses what is nearer", lifted(1)},
        {"from the lamp it meets the sphere of the point, too",
         first_hit(lamp, normalize(p - lamp)) < length(lamp - p)}}},
      {"compare what first_hit returns with the distance of the lamp",
       {{"every lamp is seen", false}, {"no lamp is seen", true}}},
      {"this says whether the lamp is behind: ask first_hit what is between", dot(n, lamp - p) < 0},
  };
  // Those who make another mistake often forget the 0.001, too.
  for (const double lift : {0.001, 0.0}) {
    const Vec3d start = p + n * lift;
    const Vec3d path = lamp - start;
    const Vec3d to = normalize(path);
    const double away = length(path);
    const auto hit = [&](Vec3d along, double limit) { return first_hit(start, along) < limit; };
    const auto hits = [&](Vec3d along, double one = 1) {
      return std::vector<bool>{hit(along, away), hit(along, one), hit(along, never),
                               hit(along, length(lamp))};
    };
    const double one = lift > 0 ? 1 : never;  // else another row has these values
    wrong += {
        {"a sphere behind the lamp hides nothing: compare with its distance", hit(to, never)},
        {"direction and distance do not fit: normalize the direction", hit(path, away)},
        {"compare with length(lamp - start)",
         {{"the lamp is not at distance 1", hit(to, 1)},
          {"length(lamp) is that from 0", {hit(to, length(lamp)), hit(path, length(lamp))}}}},
        {"the direction to the lamp is lamp - start",
         {{"the ray runs away from the lamp", hits(-to, one)},
          {"the ray runs away from the lamp", hits(-path)},
          {"lamp is a position", hits(lamp)},
          {"lamp is a position", hits(normalize(lamp))},
          {"yours is their sum", hits(normalize(lamp + start), one)},
          {"you look along the normal", hits(n)}}},
        {"first_hit takes the start first, then the direction", first_hit(to, start) < away},
        {"this is the share of the hidden lamps: a lamp is hidden if something is nearer than it",
         {!hit(to, away), !hit(to, never), !hit(path, away), !hit(to, 1)}},
    };
  }
  return wrong;
}

Slips<double> wrong_shares(Vec3d p, Vec3d n, const Lamps& lamps, const FirstHit& first_hit) {
  const auto count = double(lamps.size());
  const auto of_one = [&](const Vec3d& lamp) { return is_hidden(p, n, lamp, first_hit) ? 0. : 1.; };
  const double right = right_share(p, n, lamps, first_hit), seen = right * count;
  const double first = of_one(lamps.front()), last = of_one(lamps.back());
  double lit = 0;
  for (const Vec3d& l : lamps) lit += of_one(l) * max(dot(n, normalize(l - p - n * 0.001)), 0.0);
  Slips<double> hidden = changed(wrong_shadows(p, n, lamps[0], first_hit), [](bool) { return 0.; });
  for (const Vec3d& lamp : lamps)
    hidden = combined(std::plus<>(), hidden, wrong_shadows(p, n, lamp, first_hit));
  return {
      {"count the lamps seen, and divide in double by lamps.size() (1 / 2 is 0)",
       {{"this is how many lamps it sees", seen},
        {"yours is 1 only where all are seen", floor(right)},
        {"yours is 1 where one is seen", ceil(right)},
        {"you divide by one less or more", {seen / (count - 1), seen / (count + 1)}},
        {"only the first or the last lamp counts", {first, first / count, last, last / count}},
        {"the first or the last lamp is missing", {(seen - first) / count, (seen - last) / count}},
        {"the middle does not stand for the row", of_one((lamps.front() + lamps.back()) * 0.5)}}},
      {"the cosine comes later: a lamp that the point sees counts as 1", lit / count},
      changed(hidden, [=](double lamps_hidden) { return 1 - lamps_hidden / count; }),
  };
}

/// Draws the chapter's scene with the lamp, or the middle of a row of them, there.
std::function<Image()> picture_with_lamp(const Vec3d& lamp) {
  return [=] {
    auto lesson = prepared<Lesson>();
    lesson.stage.light.position = lamp;
    return picture_of(lesson);
  };
}

}  // namespace

ExercisesOfChapter all_exercises_of_chapter() {
  static const std::vector<Painted<Solid>> balls = {{{{0, 0, 0}, 1}, {}},
                                                    {{{0, 4, 0}, 0.5}, {}},
                                                    {{{0, 20, 0}, 1}, {}},
                                                    {{{6, 0, 0}, 1}, {}},
                                                    {{{0, -1.5, 0}, 0.25}, {}}};
  static const FirstHit all = first_hit_on(balls);
  static const Place<Vec3d, Vec3d, Lamps, FirstHit> visible_places[] = {
      {"one lamp, and a sphere between it and the point: 0", {up, up, {{0, 8, 0}}, all}},
      {"one lamp, and nothing between it and the point: 1", {up, up, {{5, 5, 0}}, all}},
      {"of two lamps the first is hidden: 1/2", {up, up, {{0, 8, 0}, {5, 5, 0}}, all}},
      {"of three lamps the last is hidden: 2/3", {up, up, {{5, 5, 0}, {0, 2, 5}, {0, 9, 0}}, all}},
      {"a sphere between two lamps hides neither: 1", {up, up, {{-4, 8, 0}, {4, 8, 0}}, all}},
      {"rounding put the point 1e-12 below its own sphere: this sphere does not hide the lamp",
       {{0, 1 - 1e-12, 0}, up, {{5, 5, 0}}, all}},
      {"the same, with a sphere before the lamp: 0", {{0, 1 - 1e-12, 0}, up, {{0, 8, 0}}, all}},
      {"a point under a sphere sees a lamp below it", {down, down, {{5, -5, 0}}, all}},
      {"a sphere behind the lamp does not hide the lamp", {up, up, {{0, 3, 0}}, all}},
      {"a sphere 5 times as far away hides nothing", {{0, 4.5, 0}, up, {{0, 7.3, 0}}, all}},
      {"a sphere on the other side hides nothing", {{0, 7, 0}, up, {{0, 10, 0}}, all}},
      {"point (5, 0, 0), normal -x, lamp (1, 6, 0): 1", {{5, 0, 0}, left, {{1, 6, 0}}, all}},
      {"point (5, 0, 0), normal -x, lamp (-2, 4, 0): 1", {{5, 0, 0}, left, {{-2, 4, 0}}, all}},
      {"point (6, 1, 0), normal +y, lamp (9, 5, 0): 1", {{6, 1, 0}, up, {{9, 5, 0}}, all}},
      {"a sphere 4 away does not hide a lamp 0.8 away", {{5, 0, 0}, left, {{4.2, 0, 0}}, all}},
      {"a sphere 4 away hides a lamp 8 away", {{5, 0, 0}, left, {{-3, 0, 0}}, all}},
      {"a sphere that is 1/4 away hides the lamp", {down, down, {{0, -6, 0}}, all}},
      {"a lamp behind the surface is hidden: 0", {{7, 0, 0}, {1, 0, 0}, {{2, 3, 0}}, all}},
  };
  return {
      "01",
      {exercise(distance_to_bowl, picture<Lesson>(),
                {right_distance, wrong_distances, distance_to_bowl_places}),
       exercise(light_on_paper, picture_with_lamp({0.3, 0.6, 0.2}),
                {right_light, wrong_lights, light_on_paper_places}),
       exercise(visible, picture_with_lamp({3, 3, 5}),
                {right_share, wrong_shares, visible_places})},
      {{"The right sphere has the color (0.2, 0.2, 0.8), and one of its points is in shadow. Which "
        "number, 0 to 255, does the pixel there have for blue? Decimals are cut off.",
        [] { return double(byte_of(blue.b * Lesson{}.surface.ambient)); },
        {"", 0},
        "Which part of the formula for the color is left in a shadow? A byte is 255 times that.",
        {{41, "the decimals are cut off, not rounded"},
         {204, "this is the color in full light: in a shadow 0.2 of it is left"},
         {51, "this is the ambient light alone: multiply it by the sphere's blue, 0.8"}}},
       {"At which angle of the light, in degrees from the normal, is a surface half as bright as "
        "where the light falls straight on it?",
        [] {
          // Half of (ambient + diffuse) is ambient + diffuse * cosine.
          const auto [ambient, diffuse] = Lesson{}.surface;
          return acos((diffuse - ambient) / 2 / diffuse) / radian;
        },
        {"degrees", 0.005},
        "How bright is the surface at 0 degrees? Half of that is the ambient light and a part of "
        "the lamp's.",
        {{60, "there the lamp's part is a half, but the ambient light stays"},
         {51.32, "the ambient light stays where the light is slanted: 0.2 + 0.8 cos is the half"},
         {75.52,
          "the ambient light counts where the light falls straight, too: that is 1, not 0.8"}}}},
  };
}

}  // namespace texmap::check
