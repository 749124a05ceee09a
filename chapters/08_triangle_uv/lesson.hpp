// The lesson of this chapter; `idea` says what it adds to the chapter before.
#pragma once
#include "engine/app/lesson.hpp"
#include "engine/app/mesh_options.hpp"
#include "engine/app/texture_file.hpp"
#include "published/mesh_weights.hpp"
#include "scene/stage.hpp"
#include "texture/image_texture.hpp"
#include "texture/mapped.hpp"
#include "texture/mesh_mapping.hpp"
#include "texture/wrapped.hpp"

namespace texmap::chapter_08 {

using Textured = Mapped<MeshMapping, Wrapped<ImageTexture>>;

struct Lesson : LessonHooks {
  static constexpr About about{
      .idea = "a crate of triangles, with texture coordinates in its corners",
      .size = {480, 360},
  };

  Stage stage{.light = {.position = {1, 5, 5}},
              .camera = {.eye = {0, 2.4, 4.5}, .target = {0, -0.2, 0}, .fov_y_degrees = 45}};
  Lambertian surface{.ambient = 0.33, .diffuse = 0.67};
  Mesh mesh;
  Textured paint;
  TextureFile texture{"crate.png", "the picture on the mesh, a PNG or JPEG"};
  MeshOptions choice;

  void options(CommandLine& line) override { offer(line, texture, choice); }
  void prepare(Session&) override {
    const TexturedMesh scene = choice.load();
    mesh = scene.mesh;
    paint = {scene.mapping, {choice.wrap, {texture.load()}}};
  }

  /// The color that one ray sees.
  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    MeshHit<Real> hit = first_hit(mesh, ray);
    if (!any(hit.met)) return stage.sky(ray);
    if (choice.weights == WeightsFormula::heron) hit = published::weighted_by_heron(mesh, hit);
    const LightSample<Real> light = sample_light(stage.light, others(mesh, hit), hit);
    return select(hit.met, paint(hit) * lambert(surface, light), stage.sky(ray));
  }
};

}  // namespace texmap::chapter_08
