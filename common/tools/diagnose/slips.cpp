// Which slips drew a picture.
#include "slips.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>

#include "engine/compare/difference.hpp"
#include "engine/files/text.hpp"
#include "wrong_program.hpp"

namespace texmap::slips {
namespace {

constexpr const char* without_highlight =
    "without a highlight: its factor is 0, the direction to the eye or the reflected light has the "
    "wrong sign, or the 2 is missing";

bool alike(const Rgb8& a, const Rgb8& b, int tolerance = of_rounding) {
  return channel_difference(a, b) <= tolerance;
}

enum class Fit { nothing, factors, exponent, blend };  // of the light, to the picture

/// The search for a picture's slips.
class Search {
 public:
  /// @param right  the stage as it should be, if `stage` is another
  Search(const Image& drawn, const StageView& stage, const StageView& right)
      : drawn_(drawn), stage_(stage), program_(stage) {
    for (int place = 0; place < places; ++place)
      rows_[static_cast<std::size_t>(place)] = static_cast<int>(rows_of(place).size());
    const bool shines = std::ranges::any_of(
        stage.pixels, [](const Seen& seen) { return seen.lit && seen.lit->material.specular > 0; });
    if (!shines) rows_[light] -= static_cast<int>(std::size(mistakes::of_highlight));
    if (stage.picture.pixels.empty()) std::fill(rows_.begin() + texel, rows_.begin() + squares, 1);
    if (std::ranges::none_of(stage.pixels, [](const Seen& seen) { return seen.lit.has_value(); }))
      std::fill(rows_.begin(), rows_.begin() + bytes, 1);
    for (const Seen& seen : right.pixels) {
      right_.push_back(bytes_of_color(seen.color));
      if (seen.lit && shining_.specular == 0) shining_ = seen.lit->material;
    }
    // What tells slips apart best is what is not right.
    std::vector<std::size_t> wrong, all;
    std::size_t shining = 0;
    for (std::size_t i = 0; i < stage.pixels.size(); ++i) {
      if (stage.pixels[i].shines && shining++ % 8 == 0) probes_of_highlight_.push_back(i);
      all.push_back(i);
      ++seen_of_[number_of_object(stage.pixels[i])];
      if (!fits(right_[i], at(Way{}, stage.pixels[i]))) wrong.push_back(i);
    }
    different_ = static_cast<long>(wrong.size());
    for (const std::vector<std::size_t>* from : {&wrong, &all}) {
      for (std::size_t k = 0; k < 100 && !from->empty(); ++k)
        probes_.push_back((*from)[(k * 7919) % from->size()]);
    }
    // So that a wrong way is given up soon, both kinds take turns.
    for (std::size_t k = 0; k + 100 < probes_.size() && k < 100; k += 2)
      std::swap(probes_[k], probes_[k + 100]);
  }

  /// All ways with so many slips that explain the picture.
  [[nodiscard]] std::vector<Way> ways(int slips) const {
    std::vector<Way> found;
    const long limit = colors_ + (slips < 3 ? 20'000'000 : 3'000'000);  // about a second
    Fit fit = Fit::nothing;
    const std::function<void(Way&, int, int)> choose = [&](Way& way, int place, int left) {
      if (left == 0 || place == places || colors_ > limit) {
        if (left == 0) try_way(way, found, fit);
        return;
      }
      for (int row = 0; row < rows_[static_cast<std::size_t>(place)]; ++row) {
        const bool is_turn = place == turned && row >= not_turned && row < from_origin;
        if (is_turn && stage_.turn.sine == 0) continue;  // nothing is turned
        way.row[static_cast<std::size_t>(place)] = place == degrees ? 90 * row : row;
        choose(way, place + 1, left - (row == 0 ? 0 : 1));
      }
      way.row[static_cast<std::size_t>(place)] = 0;
    };
    Way way;
    choose(way, 0, slips);
    const auto explains_all = [&](const Way& one) {
      return explained(one) * 1000 >= different_ * 999;
    };
    if (slips == 0 || std::ranges::any_of(found, explains_all)) return found;
    for (const Fit each : {Fit::factors, Fit::exponent, Fit::blend}) {
      fit = each;
      if (each == Fit::factors || shining_.specular > 0) choose(way, 0, slips - 1);
    }
    return found;
  }

  /// How far a way is from the picture, at few pixels.
  [[nodiscard]] int distance(const Way& way) const {
    int sum = 0;
    for (const auto* probes : {&probes_, &probes_of_highlight_}) {
      for (const std::size_t i : *probes)
        sum += channel_difference(color(way, stage_.pixels[i]), at(way, stage_.pixels[i]));
    }
    return sum;
  }
  /// The twentieths of texture in a blend with which a way is nearest to the picture.
  [[nodiscard]] double with_blend(Way way) const {
    const auto distance_at = [&](int twentieths) {
      way.blend = twentieths / 20.0;
      return distance(way);
    };
    std::array<int, 21> blends{};
    std::iota(blends.begin(), blends.end(), 0);
    return *std::ranges::min_element(blends, {}, distance_at) / 20.0;
  }

  /// The whole exponent of the highlight with which a way is nearest to the picture.
  [[nodiscard]] PhongMaterial with_exponent(Way way) const {
    PhongMaterial material = shining_;
    const auto distance_at = [&](double exponent) {
      material.shininess = exponent;
      way.material = material;
      return distance(way);
    };
    std::vector<double> exponents{128, 150, 200, 256, 300, 500, 1000};
    for (int i = 1; i <= 100; ++i) exponents.push_back(i);
    material.shininess = *std::ranges::min_element(exponents, {}, distance_at);
    return material;
  }

  /// The ambient, diffuse and specular, in hundredths, with which a way is nearest to the picture:
  /// least squares over what is neither black nor white.
  [[nodiscard]] PhongMaterial fitted(Way way) const {
    std::array<std::array<double, 4>, 3> sums{};  // the normal equations
    for (std::size_t k = 0; k < probes_.size() + stage_.pixels.size() / 97; ++k) {
      const Seen& seen = stage_.pixels[k < probes_.size() ? probes_[k] : (k - probes_.size()) * 97];
      if (!seen.lit) continue;
      std::array<Rgb, 3> part;
      for (const std::size_t j : {0U, 1U, 2U}) {
        way.material = {{j == 0 ? 1.0 : 0, j == 1 ? 1.0 : 0}, j == 2 ? 1.0 : 0, shining_.shininess};
        part[j] = light_of(way, seen);
      }
      if (std::isnan(part[0].r + part[1].r)) continue;
      const Rgb8 is = at(way, seen);
      const auto add = [&](double Rgb::*channel, int byte) {
        if (byte < 2 || byte > 253) return;
        for (std::size_t j = 0; j < 3; ++j) {
          for (std::size_t l = 0; l < 3; ++l) sums[j][l] += part[j].*channel * (part[l].*channel);
          sums[j][3] += part[j].*channel * (byte + 0.5) / 255;
        }
      };
      add(&Rgb::r, is.r), add(&Rgb::g, is.g), add(&Rgb::b, is.b);
    }
    std::array<double, 3> best{};
    for (std::size_t round = 0; round < 600; ++round) {  // Gauss and Seidel
      const std::size_t j = round % 3, k = (j + 1) % 3, l = (j + 2) % 3;
      best[j] = (sums[j][3] - sums[j][k] * best[k] - sums[j][l] * best[l]) / (sums[j][j] + 1e-6);
    }
    const auto rounded = [](double x) { return std::round(100 * x) / 100; };
    return {{rounded(best[0]), rounded(best[1])}, rounded(best[2]), shining_.shininess};
  }

  /// Bytes of 255 hide a part of the light: the factors may then be off by some hundredths.
  static PhongMaterial in_tenths(PhongMaterial material) {
    for (double* factor :
         {&material.lambertian.ambient, &material.lambertian.diffuse, &material.specular})
      *factor = std::round(10 * *factor) / 10;
    return material;
  }

  /// What a fitted material has otherwise than the lesson.
  [[nodiscard]] Slip slip(const PhongMaterial& is) const {
    if (is.lambertian.diffuse < 0.005) {
      return {"no light of the lamp arrives: its factor is 0, or the lamp lies below the ground",
              "`lamp = (5, 5, 5)`, with y upward"};
    }
    if (shining_.specular > 0 && is.specular < 0.005) {
      return {without_highlight, "from the point to the eye"};
    }
    std::string words;
    const auto say = [&](const char* what, double now, double should) {
      if (std::abs(now - should) < 0.005) return;
      words += (words.empty() ? "" : ", ") + text("%s is %.4g and not %.4g", what, now, should);
    };
    say("the ambient light", is.lambertian.ambient, shining_.lambertian.ambient);
    say("the factor of the lamp's light", is.lambertian.diffuse, shining_.lambertian.diffuse);
    say("the factor of the highlight", is.specular, shining_.specular);
    if (shining_.specular > 0) say("the highlight's exponent", is.shininess, shining_.shininess);
    return {words, ""};
  }

  /// The same for a globe that is turned by any whole number of degrees.
  [[nodiscard]] std::vector<Way> turned_ways() const {
    std::vector<Way> found;
    Way way;
    for (way.row[upside] = 0; way.row[upside] < 2; ++way.row[upside]) {
      for (way.row[mirrored] = 0; way.row[mirrored] < 2; ++way.row[mirrored]) {
        for (way.row[degrees] = 1; way.row[degrees] < 360; ++way.row[degrees]) try_way(way, found);
      }
    }
    return found;
  }

  /// Pixels that are not the right picture's.
  [[nodiscard]] long different() const { return different_; }
  /// How many of these a way explains. It is -1 if more than 2 % of an object stay unexplained, or
  /// if more than 40 % of these pixels are unknown.
  [[nodiscard]] long explained(const Way& way) const {
    long sum = 0, unknown = 0;
    auto left = seen_of_;
    for (std::size_t k = 0; k < right_.size(); ++k) {
      const std::size_t i = k * 7919 % right_.size();  // all, the objects mixed
      const Seen& seen = stage_.pixels[i];
      const Fits fits_here = fits_at(way, seen);
      if (fits_here == Fits::no && (left[number_of_object(seen)] -= 50) < 0) return -1;
      if (fits(right_[i], at({}, seen))) continue;
      sum += fits_here == Fits::no ? 0 : 1;
      unknown += fits_here == Fits::unknown ? 1 : 0;
    }
    return unknown * 10 > different_ * 4 ? -1 : sum;
  }

 private:
  [[nodiscard]] Rgb light_of(const Way& way, const Seen& seen) const {
    ++colors_;
    return program_.light_of(way, seen);
  }
  [[nodiscard]] Rgb8 color(const Way& way, const Seen& seen) const {
    return of_bytes[way.row[bytes]].calculate(light_of(way, seen));
  }
  /// Whether a way explains a pixel. Nobody knows what it draws by bytes beyond the texture's end.
  enum class Fits { no, yes, unknown };
  [[nodiscard]] Fits fits_at(const Way& way, const Seen& seen) const {
    const Rgb c = light_of(way, seen);
    const Rgb8 is = at(way, seen);
    if (std::isnan(c.r + c.g + c.b)) return Fits::unknown;
    if (fits(of_bytes[way.row[bytes]].calculate(c), is)) return Fits::yes;
    // Channels below 0 wrap around in a byte where they are not limited.
    const bool wraps = way.row[bytes] == 0 && std::min({c.r, c.g, c.b}) < 0;
    const auto at_most_1 = [](double x) { return std::min(x, 1.0); };
    return wraps && fits(wrapped(each(c, at_most_1)), is) ? Fits::yes : Fits::no;
  }
  [[nodiscard]] bool fits(const Rgb8& a, const Rgb8& b) const {
    return alike(a, b, stage_.tolerance);
  }
  [[nodiscard]] Rgb8 at(const Way& way, const Seen& seen) const {
    const int form = way.row[flip];
    return drawn_.at(form % 2 == 1 ? drawn_.width - 1 - seen.column : seen.column,
                     form >= 2 ? drawn_.height - 1 - seen.row : seen.row);
  }
  /// Keeps a way that explains the probes and then the picture.
  void try_way(const Way& chosen, std::vector<Way>& found, Fit fit = Fit::nothing) const {
    if (fit != Fit::nothing && chosen.row[bytes] != 0) return;
    for (const bool on_squares : {true, false}) {
      Way way = chosen;
      way.on_squares = on_squares;
      const bool moves =
          std::any_of(way.row.begin(), way.row.begin() + texel, [](int r) { return r != 0; });
      if (!on_squares && (!moves || stage_.picture.pixels.empty())) return;
      if (fit == Fit::factors) {
        way.material = fitted(way);
        if (explains(way)) return found.push_back(way);
        way.material = in_tenths(*way.material);
      }
      if (fit == Fit::exponent) way.material = with_exponent(way);
      if (fit == Fit::blend) way.blend = with_blend(way);
      if (explains(way)) return found.push_back(way);
    }
  }
  [[nodiscard]] bool explains(const Way& way) const {
    double missed = 0, limit = 4;
    for (const std::size_t i : probes_) {
      missed += fits_at(way, stage_.pixels[i]) == Fits::no ? 1 : 0;
      limit += 0.12;
      if (missed > limit) return false;
    }
    return explained(way) * 10 >= different_ * 9;
  }

  static std::size_t number_of_object(const Seen& seen) {
    return seen.shines ? 7 : static_cast<std::size_t>(std::clamp(seen.object + 1, 0, 6));
  }

  const Image& drawn_;
  const StageView& stage_;
  WrongProgram program_;
  std::array<int, places> rows_{};  ///< of each place's table
  PhongMaterial shining_;           ///< the lesson's, with a highlight if there is one
  std::vector<Rgb8> right_;
  std::vector<std::size_t> probes_, probes_of_highlight_;
  std::array<long, 8> seen_of_{};  ///< pixels of each object, the sky's first, the highlight's last
  long different_ = 0;
  mutable long colors_ = 0;  ///< computed so far
};

/// By at least `least` slips, at most `most`, where `changed` was seen in place of the right one.
Explanation explain_changed(const Image& drawn, const StageView& right, const StageView& changed,
                            int least, int most) {
  Explanation result;
  const Search search(drawn, changed, right);
  result.different = search.different();
  // Too few tell no mistake from a damage.
  if (result.different * 3600 < static_cast<long>(right.pixels.size())) return result;
  std::vector<Way> ways;
  for (int slips = least; slips <= most && ways.empty(); ++slips) ways = search.ways(slips);
  if (ways.empty() && least == 1 && most == 2) ways = search.turned_ways();
  if (ways.empty()) return result;
  const auto explained = [&](const Way& way) { return search.explained(way); };
  // Of ways that explain as much, first those by the turn that the chapter adds.
  std::ranges::stable_sort(ways, std::greater<>(), [&](const Way& way) {
    return std::pair(explained(way), way.row[turned] != 0);
  });
  result.explained = explained(ways.front());
  const auto slips_of = [&](const Way& way) {
    std::vector<Slip> slips;
    for (int place = 0; place < places; ++place) {
      const int row = way.row[static_cast<std::size_t>(place)];
      if (place == upside && row != 0 && way.row[mirrored] != 0 && way.row[degrees] == 0) {
        slips.back() = {"turned by half: u and v run the other way", ""};
      } else if (row != 0) {
        slips.push_back(slip_of(place, row));
      }
      if (place == light && way.material) slips.push_back(search.slip(*way.material));
      if (place == light && way.blend) {
        slips.push_back({*way.blend == 0 ? "the globe's texture is missing: its light alone"
                         : *way.blend == 1
                             ? "the globe's light is missing: its texture alone"
                             : text("the globe's texture is blended with its light, %g parts of "
                                    "texture, though nobody asked for a blend",
                                    *way.blend),
                         ""});
      }
    }
    return slips;
  };
  result.slips = slips_of(ways.front());
  for (std::size_t i = 1; i < ways.size(); ++i) {
    if (explained(ways[i]) * 1000 < result.explained * 998) break;
    const std::string words = all_of(slips_of(ways[i]));
    const bool is_new = words != all_of(result.slips) &&
                        std::ranges::find(result.instead, words) == result.instead.end();
    if (is_new) result.instead.push_back(words);
  }
  return result;
}

}  // namespace

Explanation explain(const Image& drawn, const StageView& stage, int most) {
  return explain_changed(drawn, stage, stage, 1, most);
}

Explanation explain_by_view(const Image& drawn, const StageView& right, int more) {
  Explanation best;
  StageView few = right;
  std::erase_if(few.pixels, [](const Seen& seen) {
    return (seen.column - 1) % (10 * lattice) != 0 || (seen.row - 1) % (10 * lattice) != 0;
  });
  const auto try_one = [&](const Slip& slip, const auto& view) {
    // Drawing takes long here, so the search ends with the first that explains all.
    if (right.drawn_before && best.explained > 0 && best.explained * 1000 >= best.different * 999)
      return;
    if (explain_changed(drawn, few, view(10 * lattice), more, more).explained == 0) return;
    Explanation why = explain_changed(drawn, right, view(lattice), more, more);
    if (why.explained == 0) return;
    why.slips.insert(why.slips.begin(), slip);
    if (why.explained <= best.explained) return best.instead.push_back(slip.words);
    best = why;
  };
  right.visit_changed(right, try_one);
  return best;
}

std::vector<std::pair<const StageView*, Explanation>> explain_by_any(
    const Image& drawn, std::span<const StageView> stages) {
  std::vector<std::pair<const StageView*, Explanation>> found;
  std::size_t least = 99;
  const auto keep = [&](const StageView& stage, Explanation why) {
    if (why.slips.empty()) return;
    least = std::min(least, why.slips.size());
    found.emplace_back(&stage, std::move(why));
  };
  const auto by_slips = [&](std::span<const StageView> some, int most) {
    for (const StageView& stage : some) {
      // With more slips than another's, only an earlier chapter may be meant.
      const auto before = [&](const auto& row) { return row.first->chapter <= stage.chapter; };
      if (least >= static_cast<std::size_t>(most) || std::ranges::none_of(found, before))
        keep(stage, explain(drawn, stage, most));
    }
  };
  const auto by_views = [&](int more) {
    if (!found.empty()) return;
    for (const StageView& stage : stages) keep(stage, explain_by_view(drawn, stage, more));
  };
  // Where light is gathered, the same random numbers are tried first.
  for (const StageView& stage : stages) {
    if (stage.tolerance == of_rounding) continue;
    StageView exact = stage;
    exact.tolerance = of_rounding;
    keep(stage, explain(drawn, exact, 1));
    if (found.empty()) keep(stage, explain_by_view(drawn, exact, 0));
    if (!found.empty()) return found;
  }
  by_slips(stages, 1);
  by_views(0);
  by_slips(stages, 2);
  by_views(1);
  // Three slips take longer: of the nearest alone.
  if (found.empty()) by_slips(stages.first(std::min<std::size_t>(stages.size(), 1)), 3);
  std::erase_if(found, [&](const auto& row) { return row.second.slips.size() > least + 1; });
  std::ranges::stable_sort(found, {}, [](const auto& row) { return row.first->chapter; });
  return found;
}

bool has_other_colors(const Image& drawn, const StageView& stage) {
  // How often the texture has a color, in 16 steps a channel.
  constexpr int steps = 16;
  std::vector<std::size_t> times(std::size_t{steps} * steps * steps);
  const auto step_of = [](double channel, int more) {
    return static_cast<std::size_t>(std::clamp(static_cast<int>(channel * steps) + more, 0, 15));
  };
  const auto place_of = [&](const Rgb& c, int r, int g, int b) {
    return (step_of(c.r, r) * steps + step_of(c.g, g)) * steps + step_of(c.b, b);
  };
  if (stage.picture.pixels.empty()) return false;
  for (const Rgb8& texel : stage.picture.pixels) ++times[place_of(color_of(texel), 0, 0, 0)];
  const auto is_rare = [&](const Rgb& c) {
    std::size_t near = 0;
    for (int i = 0; i < 27; ++i) near += times[place_of(c, i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)];
    return near * 1000 < stage.picture.pixels.size();
  };
  long around = 0, around_wrong = 0, lit = 0, unlike = 0, impossible = 0;
  for (const Seen& seen : stage.pixels) {
    const Rgb8 is = drawn.at(seen.column, seen.row);
    if (!seen.mapped || seen.on_checkers) {
      ++around;
      around_wrong += alike(is, bytes_of_color(seen.color)) ? 0 : 1;
      continue;
    }
    const double diffuse = seen.lit->diffuse();
    if (diffuse < 0.4) continue;
    ++lit;
    const Rgb color = (color_of(is) + gray(-seen.lit->specular())) * (1 / diffuse);
    unlike += is_rare(color) ? 1 : 0;
    impossible += std::max({color.r, color.g, color.b}) > 1.02 ? 1 : 0;
  }
  return lit > 500 && around_wrong * 100 <= around && impossible * 50 <= lit && unlike * 10 >= lit;
}

bool is_in_highlight(const Image& drawn, const StageView& stage) {
  long wrong = 0, shining = 0;
  for (const Seen& seen : stage.pixels) {
    if (alike(drawn.at(seen.column, seen.row), bytes_of_color(seen.color))) continue;
    ++wrong;
    shining += seen.lit && seen.lit->specular() > 0.004 ? 1 : 0;
  }
  return shining > 4 && shining * 10 >= wrong * 9;
}

Slip wrong_shadows(const Image& drawn, const StageView& stage) {
  long dark = 0, bright = 0, other = 0, lit = 0, borders = 0;
  bool last_dark = false;
  for (const Seen& seen : stage.pixels) {
    const Rgb8 is = drawn.at(seen.column, seen.row);
    const bool right = alike(is, bytes_of_color(seen.color));
    const auto is_with = [&](double cosine) {
      return seen.lit && alike(is, bytes_of_color(mistakes::Lit(*seen.lit).with_cosine(cosine)));
    };
    lit += seen.lit && seen.lit->light.cosine > 0 ? 1 : 0;
    const bool is_dark = !right && is_with(0);
    borders += is_dark != last_dark ? 1 : 0;
    last_dark = is_dark;
    if (is_dark) {
      ++dark;
    } else if (!right) {
      ++(seen.lit && is_with(std::max(seen.lit->cosine(), 0.0)) ? bright : other);
    }
  }
  const auto some = [&](long count) { return count * 200 > lit && other * 50 < count; };
  if (some(dark) && bright * 50 < dark && borders * 5 > dark) {
    return {"full of dark dots: shadow acne, since the shadow ray meets the surface that it leaves",
            "start a little above the surface, or leave out the object that was hit"};
  }
  if (some(bright) && dark * 50 < bright) {
    return {"some shadows are missing: not every object is asked",
            "ask all objects, or all but the own"};
  }
  return {};
}

std::string all_of(const std::vector<Slip>& slips) {
  std::string words;
  for (const Slip& slip : slips) words += (words.empty() ? "" : "; and ") + slip.words;
  return words;
}

bool draws(const StageView& stage, const Image& right) {
  const auto off = std::ranges::count_if(stage.pixels, [&](const Seen& seen) {
    return !alike(bytes_of_color(seen.color), right.at(seen.column, seen.row), 1);
  });
  return off * 1000 <= std::ssize(stage.pixels);
}

const OnStage* find_chapter(std::string_view name) {
  for (const auto* chapters : {&stages(), &variants()}) {
    const auto found = std::ranges::find(*chapters, name, &OnStage::name);
    if (found != chapters->end()) return &*found;
  }
  return nullptr;
}

std::string Words::of(const Image& drawn, const WrongPicture& right) {
  if (const OnStage* chapter = find_chapter(right.name)) {
    const auto [place, is_new] = stages_.try_emplace(right.name);
    StageView& stage = place->second;
    if (is_new) stage = chapter->view(chapter->name, "");
    const bool is_as_large = stage.width == drawn.width && stage.height == drawn.height;
    if (is_as_large && draws(stage, right.picture)) {
      const auto whys = explain_by_any(drawn, {&stage, 1});
      if (whys.empty()) {
        std::string shadows = wrong_shadows(drawn, stage).words;
        if (!shadows.empty()) return shadows;
      } else {
        std::string words = all_of(whys.front().second.slips);
        for (const std::string& other : whys.front().second.instead) words += "; or " + other;
        return words;
      }
    }
  }
  return name_mistake(drawn, right.picture, mistakes_of_the_whole(right.picture));
}

}  // namespace texmap::slips
