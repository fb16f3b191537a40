// SPDX-License-Identifier: MIT
// Random scenes up to the edges of what validation lets through: no NaN, no lost sample, no hang.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <random>

#include "renderer/scene/validate.hpp"
#include "tests/renderer/feature_scenes.hpp"
#include "tests/renderer/renderer_fixture.hpp"

namespace steradian {
namespace {

using namespace scenes;

/// Draws the same scenes everywhere: standard distributions differ between libraries, the engine does not.
class SceneDice {
 public:
  SceneDice(std::uint64_t seed, double decades) : engine_(seed), decades_(decades) {}

  Scene scene() {
    Scene scene;
    const int materials = 1 + below(4);
    for (int i = 0; i < materials; ++i) add(scene, material());
    const int objects = 1 + below(12);
    for (int i = 0; i < objects; ++i) add(scene, place(), shape(), scene.materials[below(materials)].id);
    for (int i = below(4); i > 0; --i) addAnyLight(scene);
    scene.render.maxBounces = below(12);
    scene.render.lightSamples = 1 + below(3);
    scene.render.filter = below(2) ? PixelFilter::box : PixelFilter::blackmanHarris;
    scene.render.russianRoulette = below(2) == 0;
    scene.render.energyCompensation = below(2) == 0;
    scene.render.clamp = below(4) == 0 ? float(length()) : 0.0f;
    scene.render.seed = std::uint32_t(engine_());
    return scene;
  }

  /// Among the objects, in one of them, or anywhere.
  CameraView camera(const Scene& scene) {
    const dvec3 target = scene.objects[below(int(scene.objects.size()))].transform.translation;
    const dvec3 eye = below(3) == 0 ? target : target + direction() * length();
    const double fov = below(8) == 0 ? 3.14 : 0.01 + 2.0 * unit();
    CameraView view{matrixOf({eye, eye == target ? facing(direction()) : facing(target - eye), dvec3(1.0)}),
                    fov};
    view.lens.fNumber = below(3) == 0 ? length() : 0.0;
    view.lens.focusDistance = length();
    view.lens.orthographicHeight = length();
    if (below(4) == 0) view.lens.projection = Projection::orthographic;
    return view;
  }

 private:
  double unit() { return double(engine_() >> 11) * 0x1p-53; }
  int below(int n) { return int(engine_() % std::uint64_t(n)); }
  double length() { return std::pow(10.0, (2.0 * unit() - 1.0) * decades_); }
  dvec3 direction() { return glm::normalize(dvec3(unit() - 0.5, unit() - 0.5, unit() - 0.4999)); }
  float edgy(float low, float high) {
    const int kind = below(4);
    return kind == 0 ? low : kind == 1 ? high : low + (high - low) * float(unit());
  }

  Transform place() {
    const dvec3 where = below(3) == 0 ? dvec3(0.0) : direction() * length();
    dvec3 scale(1.0);
    if (below(3) == 0) scale = dvec3(std::pow(10.0, unit() - 0.5), -std::pow(10.0, unit() - 0.5), 1.0);
    return at(where, direction(), below(2) ? 6.3 * unit() : 0.0, scale);
  }
  Shape shape() {
    switch (below(6)) {
      case 0:
        return Sphere{length()};
      case 1:
        return Plane{};
      case 2:
        return Box{{length(), length(), length()}};
      case 3:
        return Rect{{length(), length()}};
      case 4:
        return Disk{length()};
      default:
        return Cylinder{length(), length()};
    }
  }
  Material material() {
    Material m;
    m.albedo = {edgy(0, 1), edgy(0, 1), edgy(0, 1)};
    m.metallic = edgy(0, 1);
    const float roughness[] = {0.0f, 0.0316f, 0.0317f, 0.05f, 1.0f, float(unit())};
    m.roughness = roughness[below(6)];
    m.specular = edgy(0, 1);
    m.ior = below(3) == 0 ? 1.0f : edgy(1.0f, 1000.0f);
    m.transmission = below(3) == 0 ? edgy(0, 1) : 0.0f;
    m.attenuationColor = {edgy(1e-3f, 1), edgy(1e-3f, 1), edgy(1e-3f, 1)};
    m.attenuationDistance = below(2) ? float(length()) : 0.0f;
    m.clearcoat = below(3) == 0 ? edgy(0, 1) : 0.0f;
    m.clearcoatRoughness = roughness[below(6)];
    m.edgeTint = {edgy(0, 1), edgy(0, 1), edgy(0, 1)};
    m.emissionLuminance = below(3) == 0 ? float(length()) : 0.0f;
    return m;
  }
  void addAnyLight(Scene& scene) {
    const Transform where{direction() * length(), facing(direction()), dvec3(1.0)};
    const float power = float(length());
    switch (below(7)) {
      case 0:
        addLight(scene, where, PointLight{}, power);
        break;
      case 1:
        addLight(scene, where, SpotLight{0.0f, edgy(1e-3f, 1.57f)}, power);
        break;
      case 2:
        addLight(scene, where, DirectionalLight{below(2) ? edgy(1e-6f, 1.57f) : 0.0f}, power);
        break;
      case 3:
        addLight(scene, where, SphereLight{length()}, power);
        break;
      case 4:
        addLight(scene, where, RectLight{{length(), length()}}, power);
        break;
      case 5:
        addLight(scene, where, DiskLight{length()}, power);
        break;
      default:
        addSky(scene, where, power);
        break;
    }
  }

  void addSky(Scene& scene, const Transform& where, float power) {
    EnvironmentLight sky{glm::vec3(edgy(0, 1)), glm::vec3(edgy(0, 1))};
    if (below(2)) sky.image = skyImage();
    addLight(scene, where, sky, power);
  }

  std::mt19937_64 engine_;
  double decades_;
};

class FuzzTest : public RendererTest {
 protected:
  /// A lamp of 1e12 cd at 1e-12 m is too bright for any film: that must be said, and nothing else may be.
  void expectClean() override {
    renderer().measureError();
    EXPECT_EQ(renderer().stats().nanSamples, 0u);
    const auto pixels = renderer().radiance().pixels;
    const float brightest = pixels.empty() ? 0.0f : std::ranges::max(pixels);
    EXPECT_TRUE(renderer().stats().faults == 0 || brightest > 1e11f) << brightest;
  }
  /// Scenes of sizes and distances 10^-decades to 10^decades: as many as STERADIAN_FUZZ_SCENES asks for over
  /// all three tests (10000 is what row 40 wants of a nightly run), or as many as ten seconds allow.
  void expectNoLostSample(double decades) {
    const char* wanted = std::getenv("STERADIAN_FUZZ_SCENES");
    const int most = wanted ? std::atoi(wanted) / 3 + 1 : 1500;
    const double limit = wanted ? 1e9 : 10.0;
    auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    int count = 0, lit = 0;
    for (; count < most && seconds() < limit; ++count) {
      SceneDice dice(std::uint64_t(count) + std::uint64_t(decades * 1000) * 1'000'000, decades);
      const Scene scene = dice.scene();
      for (const Problem& p : problemsOf(scene)) ADD_FAILURE() << p.where << " " << p.what;
      const Image image = render(scene, dice.camera(scene), {8, 8}, 4);
      if (count == 0) start = std::chrono::steady_clock::now();  // the pipeline has been compiled
      // The compensation of a sum of denormals may leave it a denormal below 0.
      for (const float value : image.pixels) ASSERT_TRUE(std::isfinite(value) && value > -1e-37f) << value;
      if (meanOf(image).value > 0.0) ++lit;
      ASSERT_FALSE(HasFailure()) << "scene " << count << " of 10^+-" << decades;
    }
    measuredAtLeast("scenes without NaN or a lost sample", count, 101);
    EXPECT_GT(count, 100);
    EXPECT_GT(lit, count / 4);
  }
};

TEST_F(FuzzTest, row40_ordinary_scenes_lose_no_sample) {
  expectNoLostSample(1.0);
}

TEST_F(FuzzTest, row40_wide_scenes_lose_no_sample) {
  expectNoLostSample(4.0);
}

TEST_F(FuzzTest, row40_scenes_at_the_limits_of_validation_lose_no_sample) {
  expectNoLostSample(12.0);
}

TEST_F(FuzzTest, row40_what_cannot_be_rendered_is_refused) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, 1e30, 1e-30, nan, inf}) {
    const Shape shapes[] = {Sphere{bad}, Box{{1, bad, 1}}, Rect{{bad, 1}},
                            Disk{bad},   Cylinder{bad, 1}, Cylinder{1, bad}};
    for (const Shape& shape : shapes) {
      Scene scene = plainScene(1);
      add(scene, at({0, 0, 0}), shape, Material{});
      EXPECT_EQ(problemsOf(scene).size(), 1u) << bad << ", shape " << shape.index();
      measuredAtLeast("problems found in an unsound scene", double(problemsOf(scene).size()), 1);
    }
    Scene scene = plainScene(1);
    add(scene, at({0, 0, 0}, {0, 1, 0}, 0.0, {1, bad, 1}), Sphere{1.0}, Material{});
    EXPECT_EQ(problemsOf(scene).empty(), bad == -1.0) << "scale " << bad;  // a mirrored shape is sound
  }
}

TEST_F(FuzzTest, row40_hidden_and_empty_scenes_render_black) {
  Scene scene = plainScene(3);
  const CameraView view = lookAt({0, 0, 5}, {0, 0, 0}, 1.0);
  for (const float value : render(scene, view, {8, 8}, 4).pixels) EXPECT_EQ(value, 0.0f);
  add(scene, at({0, 0, 0}), Sphere{1.0}, emitter(1.0f));
  scene.objects.back().visible = false;
  for (const float value : render(scene, view, {8, 8}, 4).pixels) {
    EXPECT_EQ(value, 0.0f);
    measured("light without a source", std::abs(double(value)), 0);
  }
  EXPECT_FALSE(renderer().pick(4, 4));
}

}  // namespace
}  // namespace steradian
