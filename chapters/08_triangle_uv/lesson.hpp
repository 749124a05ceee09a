// The lesson of this chapter; `idea` says what it adds to the chapter before.
#pragma once
#include "engine/draw/lesson.hpp"
#include "engine/run/mesh_options.hpp"
#include "engine/run/texture_file.hpp"
#include "scene/stage.hpp"
#include "texture/image_texture.hpp"
#include "texture/mapped.hpp"
#include "texture/surface.hpp"

namespace texmap::chapter_08 {

using Textured = MaterialPaint<Transformed<MeshMapping>, published::LookUpTexture>;

struct Lesson : MeshLesson {
  static constexpr About about{
      .idea = "a crate of triangles, with texture coordinates in its corners",
      .size = {480, 360},
  };

  Stage stage{.camera = {.eye = {0, 2.4, 4.5}, .target = {0, -0.2, 0}, .fov_y_degrees = 45}};
  Lambertian surface{.ambient = 0.33, .diffuse = 0.67};
  MeshScene scene;
  Textured paint;
  TextureFile texture{"crate.png", "the picture on the mesh, a PNG or JPEG"};
  MeshOptions choice;

  Groups options() override { return {texture, choice}; }
  void build(Chosen& chosen) override {
    scene = choice.load(chosen, stage.camera);
    paint = {{choice.uv.moved(MeshMapping{scene.mapping}), choice.uv.read({texture.load()})},
             scene.materials};
  }
  Surface<double> first_surface(const Ray<double>& ray) const override {
    return surface_at(choice.weighted(scene.mesh, first_hit(scene.mesh, ray)), paint, scene.normal);
  }

  /// The color that one ray sees.
  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    const MeshHit<Real> hit = choice.weighted(scene.mesh, first_hit(scene.mesh, ray));
    const auto light = sample_light(stage.light, others(scene.mesh, hit), hit, scene.normal);
    return select(hit.met, paint(hit) * lambert(surface, light), stage.sky(ray));
  }
};

}  // namespace texmap::chapter_08
