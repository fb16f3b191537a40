// SPDX-License-Identifier: MIT
// How much float loses where functions read a scene: camera rays, the sky, the light tree, glowing meshes,
// textures.
#include <cstdint>

#include "shaders/kernel_rounding_scene.comp.h"
#include "tests/shaders/rounding.hpp"
#include "tests/shaders/rounding_scene_inputs.hpp"
#include "tests/shaders/rounding_scene_kernel.hpp"

namespace steradian::kernel {
namespace {

using Gates = std::vector<Gate<SceneQuestion>>;

constexpr Extent film{64, 48};
constexpr std::uint32_t lightCount = 50;

class RoundingInScenes : public KernelTest {
 protected:
  static constexpr std::size_t questions = 100'000;

  static reference::TracedScene traced(const CameraView& view) {
    return reference::tracedScene(packScene(hardScene(), view, film), *device_);
  }
  static std::vector<glm::dvec4> onDevice(const reference::TracedScene& scene, std::uint32_t operation,
                                          const Rows& rows) {
    const Task task{.operation = operation,
                    .rowsIn = 2,
                    .push = pushBytes(scene.scene.params),
                    .scene = scene.scene.rows,
                    .tables = scene.tables,
                    .mesh = scene.meshes,
                    .texels = scene.texels};
    const Rows answers = run({kernel_rounding_scene_spirv, "rounding_scene"}, task, rows);
    return {answers.begin(), answers.end()};
  }
  template <class Real>
  static std::vector<glm::dvec4> inCpp(const reference::TracedScene& scene, std::uint32_t operation,
                                       const Rows& rows) {
    reference::RoundingSceneKernel<Real> kernel(scene);
    using Row = glm::vec<4, Real>;
    std::vector<glm::dvec4> answers;
    for (std::size_t i = 0; i < rows.size(); i += 2)
      answers.emplace_back(kernel.roundedOfScene(operation, Row(rows[i]), Row(rows[i + 1])));
    return answers;
  }

  static void expectWithinGates(const reference::TracedScene& scene, const Gates& gates) {
    printRoundingHead();
    for (const auto& gate : gates) {
      Random random(2000 + gate.operation);
      Rows rows;
      for (std::size_t i = 0; i < questions; ++i) {
        const SceneQuestion q = gate.question(random);
        rows.insert(rows.end(), q.begin(), q.end());
      }
      const std::vector<glm::dvec4> exact = inCpp<double>(scene, gate.operation, rows);
      const double choice = gate.choice ? gate.all : 0.0;
      expectWithin(gate, errorsOf(onDevice(scene, gate.operation, rows), exact, choice),
                   errorsOf(inCpp<float>(scene, gate.operation, rows), exact, choice), questions);
    }
  }
};

/// Anywhere on the film and a little beside it.
SceneQuestion cameraQuestion(Random& random) {
  return {glm::vec4(random.uniform(-2, 66), random.uniform(-2, 50), random.uniform(0, 0.9999999),
                    random.uniform(0, 0.9999999)),
          glm::vec4(0)};
}

/// Any direction and, as often, one near the pole or at the edge of the texels in the middle; any numbers.
SceneQuestion skyQuestion(Random& random) {
  const glm::dvec3 d = random.direction();
  const glm::dvec3 pole = glm::dmat3(glm::mat3_cast(scenes::at({0, 0, 0}, {1, 2, 3}, 0.9).rotation))[1];
  const glm::dvec3 near = glm::normalize(pole * (d.y < 0 ? -1.0 : 1.0) + d * random.decades(-4, 0));
  const double u = random.uniform() < 0.2 ? random.decades(-6, 0) : random.uniform(0.0, 0.9999999);
  return {glm::vec4(glm::vec3(random.uniform() < 0.5 ? near : d), 0),
          glm::vec4(float(u), float(random.uniform(0.0, 0.9999999)), 0, 0)};
}

/// Near and far from all lights, the light any of them.
SceneQuestion choiceQuestion(Random& random) {
  return {glm::vec4(glm::vec3(random.direction() * random.decades(-2, 5)),
                    std::floor(random.uniform(0, lightCount))),
          glm::vec4(float(random.uniform(0.0, 0.9999999)), 0, 0, 0)};
}

/// A lamp of about half a metre from 0.1 to 1,000 m away, at all angles; triangles in proportion to area.
SceneQuestion lampQuestion(Random& random, float light) {
  return {glm::vec4(glm::vec3(lampCentre() + random.direction() * random.decades(-1, 3)), light),
          glm::vec4(float(random.uniform(0.0, 0.9999999)), float(random.uniform(0.0, 0.9999999)), 0, 0)};
}

/// Within the texture, its first repetitions and, at times, a thousand of them away.
SceneQuestion texelQuestion(Random& random, std::uint32_t row, int levels) {
  const double reach = random.uniform() < 0.1 ? random.decades(0, 3) : 2.0;
  return {glm::vec4(float(random.uniform(-reach, reach)), float(random.uniform(-reach, reach)),
                    std::floor(random.uniform(0, levels)), float(row)),
          glm::vec4(float(random.decades(-4, 1)), float(random.decades(-1, 1)),
                    float(random.uniform(0.0, 0.9999999)), 0)};
}

// Gates are four times what was measured with llvmpipe and g++.

TEST_F(RoundingInScenes, camera_rays_of_every_lens_stay_within_their_gates_of_double) {
  CameraView lens = hardView(), parallel = hardView();
  lens.lens.focusDistance = 4.0;
  lens.lens.fNumber = 0.4;
  parallel.lens.projection = Projection::orthographic;
  expectWithinGates(traced(hardView()), {{"pinhole direction", 0, cameraQuestion, 5.2e-7, 6.8e-7},
                                         {"filterOffset", 2, cameraQuestion, 2.4e-7, 2.4e-7}});
  expectWithinGates(traced(lens), {{"lens direction", 0, cameraQuestion, 5.6e-7, 7.2e-7},
                                   {"lens origin", 1, cameraQuestion, 6.8e-7, 9.2e-7}});
  expectWithinGates(traced(parallel), {{"parallel direction", 0, cameraQuestion, 6.4e-8, 6.4e-8},
                                       {"parallel origin", 1, cameraQuestion, 4.8e-7, 6.4e-7}});
}

TEST_F(RoundingInScenes, the_sky_and_its_samples_stay_within_their_gates_of_double) {
  expectWithinGates(traced(hardView()),
                    {{"environment radiance", 10, skyQuestion, 2.4e-7, 2.4e-7, 1e-4, true},
                     {"environment pdf", 11, skyQuestion, 2.6e-7, 2.6e-7, 1e-4, true},
                     {"sampleEnvironment direction", 12, skyQuestion, 8.8e-7, 1.0e-6, 1e-4, true},
                     {"sampleEnvironment pdf", 13, skyQuestion, 2.6e-7, 2.6e-7, 1e-4, true}});
}

// A light that is hardly chosen has what a nearly certain sibling leaves of 1, with few digits. Choosing and
// asking round alike, so nothing is lost but variance.
TEST_F(RoundingInScenes, choices_among_many_lights_stay_within_their_gates_of_double) {
  const reference::TracedScene scene = traced(hardView());
  ASSERT_EQ(scene.scene.params.lightCount, lightCount);
  expectWithinGates(scene, {{"lightChoiceProbability", 20, choiceQuestion, 7.2e-3, 2.5e-2},
                            {"chooseLight", 21, choiceQuestion, 3.3e-5, 7.6e-4, 1e-4, true}});
}

TEST_F(RoundingInScenes, samples_of_glowing_meshes_stay_within_their_gates_of_double) {
  const reference::TracedScene scene = traced(hardView());
  const float light = meshLightOf(scene.scene);
  const auto question = [light](Random& random) { return lampQuestion(random, light); };
  expectWithinGates(scene, {{"sampleMeshLight direction", 22, question, 3.7e-6, 1.6e-5, 1e-4, true},
                            {"sampleMeshLight pdf", 23, question, 1.6e-4, 1.4e-2, 1e-4, true},
                            {"mesh light's emission", 24, question, 6.0e-4, 3.4e-3, 1e-4, true}});
}

// A thousand repetitions away a coordinate has 14 bits less for the place within a texel.
TEST_F(RoundingInScenes, texture_lookups_stay_within_their_gates_of_double) {
  const reference::TracedScene scene = traced(hardView());
  reference::RoundingSceneKernel<double> layout(scene);
  const glm::uvec4 refs = textureRefs(scene.scene, layout.primitiveLayout().instance);
  const auto of = [](std::uint32_t row, int levels) {
    return [row, levels](Random& random) { return texelQuestion(random, row, levels); };
  };
  expectWithinGates(scene, {{"bilinear, 8 bits sRGB", 30, of(refs.x, 3), 3.2e-6, 7.6e-6},
                            {"mirrored, 16 bits sRGB", 30, of(refs.w, 6), 4.8e-3, 4.4e-2},
                            {"nearest, half floats", 30, of(refs.y, 3), 0.0, 1e-7, 1e-4, true},
                            {"mipLevel", 31, of(refs.w, 6), 0.0, 1e-7, 1e-4, true}});
}

}  // namespace
}  // namespace steradian::kernel
