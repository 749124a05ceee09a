// What the groups of options offer, and what a choice does. Skies and meshes, which bring much code
// of their own, have files of their own. A program that offers none of these groups links none.
#include <cmath>
#include <cstdlib>
#include <utility>

#include "engine/draw/convert_projection.hpp"
#include "engine/fast/kernel_plan.hpp"
#include "engine/files/find_texture.hpp"
#include "engine/files/load_image.hpp"
#include "engine/run/bump_options.hpp"
#include "engine/run/chosen.hpp"
#include "engine/run/command_line.hpp"
#include "engine/run/filter_options.hpp"
#include "engine/run/globe_options.hpp"
#include "engine/run/layout_options.hpp"
#include "engine/run/phong_options.hpp"
#include "engine/run/projection_options.hpp"
#include "engine/run/sampling_options.hpp"
#include "engine/run/texture_file.hpp"
#include "engine/run/turntable.hpp"
#include "engine/run/uv_options.hpp"

namespace texmap {

namespace {

// The picture of a file; says what was done to it.
Image load_noted(const std::string& name, const CommandLine* line, DeepImage* deep = nullptr,
                 int later_bytes = 0) {
  std::string note;
  Image image = load_image(find_texture(name), &note, deep, later_bytes);
  if (line != nullptr && !note.empty()) line->note(name + " " + note + "\n");
  return image;
}

}  // namespace

void TextureFile::declare(Offer& offer) {
  declared = &offer.line;
  offer.line.text(option, "FILE", name, help);
}

SharedImage TextureFile::load(int later_bytes) {
  if (kept.pixels.empty()) kept = load_noted(name, declared, nullptr, later_bytes);
  return kept;
}

void LayoutOptions::declare(Offer& offer) {
  CommandLine& line = offer.line;
  // A new convention also has a row in chapter 04's conventions_compared.cpp.
  line.choice<Convention>("--convention", convention,
                          {{"daily", Convention::daily},
                           {"rtiow", Convention::rtiow},
                           {"lecture", Convention::lecture}},
                          "where on the globe the picture begins, and which way it runs");
  line.choice(
      "--rounding", rounding, "floor|lecture",
      "which texel has the coordinate u: number floor(u n), or the lecture's (n-1) u, cut off");
}

ImageTexture LayoutOptions::load(TextureFile& file) const {
  return {file.load(), v_axis_of(convention), rounding};
}

void UvOptions::declare(Offer& offer) {
  CommandLine& line = offer.line;
  constexpr double most = 1000;
  line.pair("--uv-scale", "UxV", scale, -most, most,
            "multiplies u and v: with 2x1 the picture is there twice, half as wide; -1x1 mirrors");
  line.decimal("--uv-turn", turn_degrees, -1e300, 1e300,
               "then turns the point (u, v) about (0, 0), from u towards v, by this angle");
  line.pair("--uv-offset", "U,V", offset, -most, most,
            "then adds to u and v: 0.25,0 moves the picture by a quarter towards smaller u");
  using published::LookUp;
  using published::TexelFormula;
  line.choice<std::optional<LookUp>>(
      "--wrap", look_up,
      {{"repeat", LookUp{Wrap::repeat}},
       {"mirror", LookUp{Wrap::mirror}},
       {"clamp", LookUp{Wrap::clamp}},
       {"weekend", LookUp{.formula = TexelFormula::one_weekend_2020}},
       {"article", LookUp{.formula = TexelFormula::triangle_article}}},
      "what the picture shows beyond its edges: itself again, its mirror image, or its edge's "
      "texels; or by a source document's formula, which also decides between texels: One Weekend "
      "2020's, which keeps to the edge, or the triangle article's, which mirrors below 0 and "
      "repeats above 1");
}

std::optional<UvTransform> UvOptions::transform() const {
  const UvTransform chosen{.scale = {scale[0], scale[1]},
                           .turn = on_circle_of_degrees(turn_degrees),
                           .offset = {offset[0], offset[1]}};
  const bool moves =
      scale != std::array{1.0, 1.0} || offset != std::array{0.0, 0.0} || chosen.turn.cosine != 1;
  return moves ? std::optional(chosen) : std::nullopt;
}

published::LookUpTexture UvOptions::read(const ImageTexture& image) const {
  const published::LookUp chosen =
      look_up.value_or(published::LookUp{transform() ? Wrap::repeat : Wrap::clamp});
  return {{chosen.wrap, image}, chosen.formula};
}

void Turntable::declare(Offer& offer) {
  CommandLine& line = offer.line;
  line.decimal("--degrees", degrees, -1e300, 1e300,
               "rotates the globe about its axis by this angle");
  line.whole("--turntable", frames, 0, 9999,
             "draw N pictures of a full turn instead of one, named _000, _001, ...");
  offer.turntable = this;
}

RotationY Turntable::rotation() const {
  return rotation_y(frame == 0 ? degrees : std::fmod(degrees, 360) + 360.0 * frame / frames);
}

void ProjectionOptions::declare(Offer& offer) {
  CommandLine& line = offer.line;
  std::vector<std::pair<std::string_view, Projection>> words;
  std::vector<std::pair<std::string_view, std::optional<Projection>>> or_none;  // no default
  for (const ProjectionFacts& facts : projections) {
    words.emplace_back(facts.word, facts.projection);
    or_none.emplace_back(facts.word, facts.projection);
  }
  line.choice("--projection", projection, or_none,
              "draw the globe with its picture converted to this layout");
  line.choice("--from", from, words, "the layout of the --texture file");
  line.choice("--to", to, or_none,
              "convert the --texture file to this layout and save it, with as many texels on the "
              "sphere unless you give --width or --height");
}

ImageTexture ProjectionOptions::load(TextureFile& file) const {
  const bool converts = from != on_globe();
  const SharedImage image = file.load(converts ? sizeof(Rgb8) : 0);
  if (!converts) return {image};
  return {convert_projection(image, from, on_globe(), converted_size(image, from, on_globe()))};
}

void BumpOptions::declare(Offer& offer) {
  CommandLine& line = offer.line;
  declared = &line;
  line.choice(
      "--show", picture, "globe|sheet|poles|daily",
      "globe: the globe. sheet: eight ways to read one normal map. poles: heights at a pole. "
      "daily: the daily exercise's bricks");
  line.choice<BumpForm>(
      "--bump", form,
      {{"exact", BumpForm::exact}, {"blinn", BumpForm::blinn}, {"off", BumpForm::flat}},
      "exact: the normal of the raised surface. blinn: Blinn's of 1978, which leaves out the term "
      "h dn. off: the globe's own normal");
  line.choice<SlopeFrom>(
      "--slopes", slopes,
      {{"duals", SlopeFrom::duals},
       {"forward", SlopeFrom::forward},
       {"central", SlopeFrom::central}},
      "slopes of the height: duals are exact derivatives, forward and central are differences");
  line.decimal("--step", step, 1e-300, 1, "the step of the differences, in radii of the globe");
  line.decimal("--relief", relief, -10, 10,
               "the height of white, in radii of the globe; below 0 mountains become valleys");
  line.choice("--relief-from", height, "image|uv|space",
              "where the heights come from: an image, waves in (u, v), or waves in space");
  line.text(
      "--relief-image", "FILE", image,
      "the image of the heights, a PNG or JPEG twice as wide as high; its red channel is used");
  line.text("--normals", "FILE", normals,
            "a normal map in place of heights, a PNG or JPEG twice as wide as high; its bytes are "
            "read as they are. The globe is white unless you give --texture");
  line.choice<Green>("--green", green, {{"up", Green::up}, {"down", Green::down}},
                     "where green is bright in the normal map: where the surface faces the image's "
                     "upper edge (usual for OpenGL), or its lower edge (DirectX)");
}

void BumpOptions::check(const Chosen& chosen) const {
  usage_error_if(chosen.was_given("--step") && slopes == SlopeFrom::duals && normals.empty(),
                 "--step is for differences: give --slopes forward or central, too");
  usage_error_if(chosen.was_given("--relief-image") && height != HeightKind::image,
                 "--relief-from has its heights from waves: leave out --relief-image");
  for (const std::string option : {"--texture", "--turntable"}) {
    usage_error_if(picture != BumpPicture::globe && chosen.was_given(option),
                   option + " is for the globe: leave out --show");
  }
  if (normals.empty()) {
    usage_error_if(chosen.was_given("--green"),
                   "--green says how to read a normal map: give --normals FILE, too");
    for (const std::string option : {"--relief", "--relief-from", "--relief-image"}) {
      usage_error_if(picture != BumpPicture::globe && chosen.was_given(option),
                     option + " is for the globe: leave out --show");
    }
    return;
  }
  for (const std::string option :
       {"--bump", "--slopes", "--step", "--relief", "--relief-from", "--relief-image"})
    usage_error_if(chosen.was_given(option), "--normals has no heights: leave out " + option);
  usage_error_if(picture != BumpPicture::globe, "--normals is for the globe: leave out --show");
}

bool BumpOptions::paints(const Chosen& chosen) const {
  return chosen.was_given("--texture") || (normals.empty() && height == HeightKind::image);
}

BilinearTexture BumpOptions::load_normals(VAxis v_axis) const {
  DeepImage deep;
  const SharedImage map = load_noted(normals, declared, &deep);
  const SharedLight numbers =
      map.pixels.empty() ? SharedLight(std::move(deep)) : SharedLight(map, TexelLight::encoded);
  std::size_t gray = 0, inward = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto [r, g, b] = numbers[i] * 255.0F;
    // nearly, after JPEG; no normal has r = b often
    if (std::abs(r - g) < 8.5F && std::abs(g - b) < 8.5F) ++gray;
    if (b < 127.5F) ++inward;
  }
  const std::string its = "--normals " + normals + ": ";
  usage_error_if(gray == numbers.size(),
                 its + "all its texels are gray; it looks like heights: use --relief-image");
  usage_error_if(2 * inward > numbers.size(),
                 its +
                     "most of its normals point inward (blue below 128), so it is no normal map. "
                     "If it has heights, give it to --relief-image");
  return {map, v_axis, TexelLight::encoded, map.pixels.empty() ? numbers : SharedLight()};
}

SharedLight BumpOptions::load() const {
  DeepImage deep;
  Image bytes = load_noted(image, declared, &deep);
  if (!deep.pixels.empty()) return SharedGrid(std::move(deep));
  return {std::move(bytes), TexelLight::encoded};
}

namespace {

FilteredTexture texture_of(SharedImage image, const FilterOptions& options, Wrap wrap) {
  return {.pyramid = pyramid_of({std::move(image), TexelLight::linear}),
          .filter = options.filter,
          .wrap = wrap,
          .taps = options.taps,
          .border = {0.05, 0.05, 0.05}};
}

}  // namespace

void FilterOptions::declare(Offer& offer) {
  CommandLine& line = offer.line;
  declared = &line;
  // A new filter also has a place on chapter 09's sheet.cpp and in its comparison.cpp.
  line.choice<Filter>("--filter", filter,
                      {{"nearest", Filter::nearest},
                       {"bilinear", Filter::bilinear},
                       {"trilinear", Filter::trilinear},
                       {"anisotropic", Filter::anisotropic},
                       {"ewa", Filter::ewa},
                       {"stochastic", Filter::stochastic}},
                      "how textures are filtered");
  line.choice("--scene", scene, "both|plane|globe",
              "what to draw: a plane up to the horizon, a globe far away, or both");
  line.choice<Wrap>("--wrap", wrap,
                    {{"repeat", Wrap::repeat},
                     {"mirror", Wrap::mirror},
                     {"clamp", Wrap::clamp},
                     {"border", Wrap::border}},
                    "what the floor shows outside the first copy of its picture");
  line.whole("--taps", taps, 1, 64,
             "how many times at most a filter reads along a pixel's footprint");
  line.text("--floor", "FILE", floor_file,
            "the picture on the floor: a PNG or JPEG file, or the word checkers");
  line.text("--plot", "FILE.svg", plot,
            "also plot the filters' errors against the number of texels they read");
  offer.budget =
      "the allowed error of textured pixels: exact or levels=4; prints which filter it chooses";
  offer.no_intervals =
      "where rounding leaves open which level a filter reads, the bound would be too wide to be "
      "of use";
}

Image checkers_image(int size, int squares) {
  return image_of(size, size, [=](int column, int row) {
    const bool light = (row * squares / size + column * squares / size) % 2 == 0;
    return light ? Rgb8{255, 255, 255} : Rgb8{0, 0, 0};
  });
}

FilteredTexture FilterOptions::load_floor() const {
  const bool made = floor_file == "checkers";
  return texture_of(made ? checkers_image(1024, 32)
                         : load_noted(floor_file, declared, nullptr, Pyramid::later_bytes),
                    *this, wrap);
}

FilteredTexture FilterOptions::load_globe(TextureFile& file) const {
  return texture_of(file.load(Pyramid::later_bytes), *this, Wrap::spherical);
}

void PhongOptions::declare(Offer& offer) {
  CommandLine& line = offer.line;
  line.decimal("--blend", blend, 0, 1,
               "mix X parts of texture with 1 - X parts of light; without this option the stage "
               "multiplies them");
  line.decimal("--shininess", shininess, 0, 1e30,
               "Phong's exponent, by default 500 in the lecture's scene");
  line.choice("--scene", scene, "stage|lecture",
              "which scene to draw; the lecture's picture is 800x400");
  line.choice("--highlight", formula, "phong|lecture",
              "Phong's highlight, or the lecture's, which has a wrong sign");
  offer.budget =
      "the allowed error of Phong's highlight: exact or levels=1; prints which fast formula it "
      "chooses";
}

PhongScene PhongOptions::resolve(const Chosen& chosen) {
  const bool lecture = scene == PhongScene::lecture;
  if (lecture && !chosen.was_given("--shininess")) shininess = 500;
  usage_error_if(formula == HighlightFormula::lecture && !chosen.settings.budget.is_exact(),
                 "--budget is for Phong's highlight: leave out --highlight lecture");
  const KernelPlan plan = plan_highlight(chosen.settings.budget);
  if (chosen.was_given("--budget")) chosen.say(plan.text);
  power_terms = plan.power_terms;
  return scene;
}

void PhongOptions::apply_to(PhongMaterial& globe, const Chosen& chosen) const {
  globe.specular = 0.3;
  globe.shininess = shininess;
  if (scene == PhongScene::lecture || chosen.was_given("--blend")) globe.blends = true;
}

void SamplingOptions::declare(Offer& offer) {
  CommandLine& line = offer.line;
  offer.samples = samples;
  offer.most_samples = most_samples;
  offer.no_intervals = "it bounds the error of one ray, not the noise of random samples";
  line.choice<SamplerKind>("--sampler", sampler,
                           {{"random", SamplerKind::random},
                            {"stratified", SamplerKind::stratified},
                            {"multi-jitter", SamplerKind::multi_jitter},
                            {"sobol", SamplerKind::sobol}},
                           "the pattern of a pixel's samples; --samples is their number");
  line.whole("--seed", seed, 0, 1000000000,
             "the seed of the random numbers: another seed has different noise");
  line.whole("--bounces", bounces, 1, 1000, "the largest number of bounces of a path");
  line.decimal("--time-limit", time_limit, 0, 1e6,
               "stop after so many seconds, or at --samples if that is given and earlier; 0 for no "
               "limit");
  line.decimal("--target-error", target_error, 0, 255,
               "stop when the estimated error of the light, root mean square, is below this, where "
               "white is 255, or at --samples if that is given; 0 for no limit");
  line.choice(
      "--gamma", transfer, "srgb|sqrt|2.2",
      "how light becomes bytes: the sRGB curve, the books' square root, or the power 1/2.2");
  line.decimal("--defocus", lens.defocus_degrees, 0, 90,
               "blur by a lens: the angle of its cone of rays, in degrees");
  line.decimal("--focus", lens.focus_distance, 0.001, 1e6,
               "the distance at which a lens is sharp; chapter 07's globe begins at 10");
  line.decimal("--shift", lens.shift, -100, 100,
               "blur by motion: the scene moves up by so much during the exposure");
}

void GlobeOptions::declare(Offer& offer) {
  CommandLine& line = offer.line;
  offer.budget =
      "the allowed error: exact, texels=0.01 (a place on the texture) or levels=1 (a byte of the "
      "picture, but for samples at the edge of a texel, which may read the neighbor); prints which "
      "fast formulas it chooses";
  line.choice<TexelLight>(
      "--decode", decoding,
      {{"srgb", TexelLight::linear}, {"stb", TexelLight::stb}, {"raw", TexelLight::encoded}},
      "how the texture's bytes become light: the sRGB curve, the power 2.2 rounded to bytes (Next "
      "Week since 2024), or the bytes as they are (Next Week before 2024)");
  line.choice("--scene", book, "ground|book",
              "the globe on a ground, or the scene `earth` of Next Week: the globe alone, larger");
  line.choice("--sky", gradient, "constant|gradient",
              "the sky: uniform, or white below and blue above");
}

void GlobeOptions::apply_to(LightTexture& texture, GradientSky& sky) const {
  texture.light = decoding;
  sky = gradient ? GradientSky{.below = {1, 1, 1}, .above = {0.5, 0.7, 1}}
                 : GradientSky{.below = {0.7, 0.8, 1.0}, .above = {0.7, 0.8, 1.0}};
}

}  // namespace texmap
