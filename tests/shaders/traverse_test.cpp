// SPDX-License-Identifier: MIT
// Shapes in the hierarchy over the scene are met exactly as in flat lists, whatever a ray starts on or is
// sent to.
#include <algorithm>
#include <chrono>
#include <iostream>

#include "renderer/gpu_scene.hpp"
#include "renderer/loop_budget.hpp"
#include "renderer/variants.hpp"
#include "shaders/kernel_traverse.comp.h"
#include "tests/renderer/scenes.hpp"
#include "tests/shaders/kernel.hpp"

namespace steradian::kernel {
namespace {

using namespace scenes;

const Kernel traverse{kernel_traverse_spirv, "traverse"};
constexpr std::uint32_t nearestHit = 0, isBlocked = 1, isBlockedToPlace = 2;

/// One ray and what it knows.
struct Question {
  dvec3 o, d;
  double tMax = 1e30;
  float self = -1.0f, target = -1.0f;
  bool inside = false;
};

Rows rowsOf(const std::vector<Question>& questions) {
  Rows rows;
  for (const Question& q : questions) {
    rows.emplace_back(glm::vec3(q.o), float(q.tMax));
    rows.emplace_back(glm::vec3(glm::normalize(q.d)), q.inside ? 1.0f : 0.0f);
    rows.emplace_back(q.self, q.target, 0.0f, 0.0f);
  }
  return rows;
}

Shape shapeOf(int kind, double size) {
  switch (kind) {
    case 0:
      return Sphere{size};
    case 1:
      return Box{dvec3(size, 0.6 * size, 1.4 * size)};
    case 2:
      return Rect{glm::dvec2(1.5 * size, size)};
    case 3:
      return Disk{size};
    default:
      return Cylinder{0.5 * size, 1.5 * size};
  }
}

/// Shapes of all kinds in a cube of 20 m: turned, some stretched, some sheared by their parent, some of them
/// lamps; a floor, and under it a planet.
Scene clutter(int count, std::uint64_t seed, const dvec3& place = dvec3(0)) {
  Random random(seed);
  const auto somewhere = [&] {
    return dvec3(random.uniform(-10, 10), random.uniform(-10, 10), random.uniform(-10, 10));
  };
  Scene scene = plainScene(3);
  const Id matt = add(scene, lambert(glm::vec3(0.7f)));
  add(scene, at(dvec3(0, -11, 0)), Plane{}, matt);
  add(scene, at(dvec3(0, -2015, 0)), Sphere{2000.0}, matt);
  const Id parent = add(scene, at(dvec3(1, 0, 0), {0, 0, 1}, 0.4, {1, 2, 0.7}), Box{dvec3(0.5)}, matt);
  for (int i = 0; i < count; ++i) {
    const int kind = i % 6;
    const dvec3 scale = kind == 5 || i % 4 == 0 ? dvec3(1, random.decades(-1, 0), 1.3) : dvec3(1);
    const double size = random.decades(-1.5, 0.3);
    add(scene, at(somewhere(), random.direction(), random.uniform(0, 6), scale), shapeOf(kind % 5, size),
        i % 50 == 7 ? add(scene, emitter(2.0f)) : matt);
    if (i % 10 == 3) scene.objects.back().parent = parent;
    if (i % 40 == 11) addLight(scene, at(somewhere(), random.direction(), 1.0), RectLight{{0.5, 0.4}}, 2.0f);
    if (i % 40 == 21) addLight(scene, at(somewhere()), SphereLight{0.3}, 2.0f);
    if (i % 40 == 31) addLight(scene, at(somewhere(), random.direction(), 2.0), DiskLight{0.4}, 2.0f);
  }
  CameraView none;
  translate(scene, none, place);
  return scene;
}

class Traverse : public KernelTest {
 protected:
  static CameraView viewFrom(const dvec3& place) { return lookAt(place, place + dvec3(0, 0, -1), 1.0); }

  static Rows ask(std::uint32_t operation, const GpuScene& scene, const std::vector<Question>& questions) {
    return ask(operation, scene, rowsOf(questions), false);
  }

  /// `baked`: as a special pipeline holds spheres and planes.
  static Rows ask(std::uint32_t operation, const GpuScene& scene, const Rows& questions, bool baked) {
    Task task{.operation = operation,
              .rowsIn = 3,
              .rowsOut = 2,
              .push = pushBytes(scene.params),
              .scene = scene.rows};
    for (std::uint32_t i = 0; i < gpu::FEATURE_COUNT; ++i)
      task.constants.emplace_back(i, (scene.features >> i) & 1u);
    task.constants.emplace_back(gpu::CONSTANT_SHAPE_HIERARCHY, scene.shapeHierarchy());
    const VariantKey key = variantFor(scene, 1);
    if (baked) {
      task.constants.emplace_back(gpu::CONSTANT_FIXED_SPHERES, key.fixedSpheres);
      task.constants.emplace_back(gpu::CONSTANT_FIXED_PLANES, key.fixedPlanes);
      task.constants.emplace_back(gpu::CONSTANT_PLANE_AXES, key.planeAxes);
    }
    return run(traverse, task, questions);
  }

  /// Rays from anywhere in the scene and from far outside of it.
  static std::vector<Question> anyRays(Random& random, int count) {
    std::vector<Question> questions;
    for (int i = 0; i < count; ++i) {
      const double from = i % 8 == 0 ? 300.0 : 11.0;
      const dvec3 o = from * random.direction() * random.uniform(0.1, 1.0);
      const dvec3 target = 10.0 * random.direction() * random.uniform(0, 1);
      questions.push_back({o, target - o});
    }
    return questions;
  }

  /// What leaves the surfaces that were met, each ray by the rules of its own shape.
  static std::vector<Question> leaving(Random& random, const GpuScene& scene, const Rows& hits) {
    std::vector<Question> questions;
    for (std::size_t i = 0; i + 1 < hits.size(); i += 2) {
      if (hits[i + 1].w < 0.0f) continue;
      Question q{xyz(hits[i]), random.direction()};
      q.self = hits[i + 1].w;
      q.inside = glm::dot(xyz(hits[i + 1]), q.d) < 0.0 && isSolid(scene, std::uint32_t(q.self));
      questions.push_back(q);
    }
    return questions;
  }

  static bool isSolid(const GpuScene& scene, std::uint32_t primitive) {
    const gpu::TraceParams& p = scene.params;
    const std::uint32_t rect = p.sphereCount + p.planeCount + p.largeSphereCount + p.boxCount;
    const bool plane = primitive >= p.sphereCount && primitive < p.sphereCount + p.planeCount;
    return !plane && (primitive < rect || primitive >= rect + p.rectCount + p.diskCount);
  }

  /// The same rays on their way to lamps.
  static std::vector<Question> towardsLamps(Random& random, const GpuScene& scene,
                                            std::vector<Question> questions) {
    for (Question& q : questions) {
      const std::size_t light = std::size_t(random.uniform(0, scene.params.lightCount));
      const glm::vec4* rows = &scene.rows[scene.params.lightRow + light * gpu::LIGHT_ROWS];
      const dvec3 way = xyz(rows[0]) + 0.2 * random.direction() - q.o;
      q.d = way;
      q.tMax = glm::length(way);
      q.target = float(std::bit_cast<std::uint32_t>(rows[3].w));
    }
    return questions;
  }

  /// Rays of which pipelines may disagree: on a CPU none; a GPU's compiler may fuse what it likes.
  static std::size_t allowed(std::size_t rays) {
    return device_->description().type == "CPU" ? 0 : rays / 5000;
  }
  static std::size_t differing(const Rows& a, const Rows& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); i += 2) count += a[i].w != b[i].w || a[i + 1].w != b[i + 1].w;
    return count;
  }
};

TEST_F(Traverse, the_hierarchy_over_shapes_gives_the_hits_of_flat_lists_wherever_the_scene_lies) {
  for (const double distance : {0.0, 1e6}) {
    SCOPED_TRACE(distance);
    const dvec3 place = distance * dvec3(1, -0.7, 0.4);
    const Scene scene = clutter(400, 3, place);
    const GpuScene list = packScene(scene, viewFrom(place), {8, 8}, ShapeSearch::list);
    const GpuScene tree = packScene(scene, viewFrom(place), {8, 8}, ShapeSearch::hierarchy);
    ASSERT_TRUE(tree.shapeHierarchy());
    ASSERT_FALSE(list.shapeHierarchy());
    Random random(11);
    const std::vector<Question> first = anyRays(random, 50000);
    const Rows hits = ask(nearestHit, list, first);
    EXPECT_LE(differing(hits, ask(nearestHit, tree, first)), allowed(first.size()));
    const std::vector<Question> second = leaving(random, list, hits);
    EXPECT_GT(second.size(), first.size() / 2);
    const Rows more = ask(nearestHit, list, second);
    EXPECT_LE(differing(more, ask(nearestHit, tree, second)), allowed(second.size()));
    EXPECT_GT(std::ranges::count_if(second, [](const Question& q) { return q.inside; }), 1000);
  }
}

TEST_F(Traverse, shadow_rays_through_the_hierarchy_find_what_those_through_flat_lists_find) {
  const Scene scene = clutter(400, 4);
  const GpuScene list = packScene(scene, viewFrom(dvec3(0)), {8, 8}, ShapeSearch::list);
  const GpuScene tree = packScene(scene, viewFrom(dvec3(0)), {8, 8}, ShapeSearch::hierarchy);
  Random random(12);
  const std::vector<Question> first = anyRays(random, 50000);
  const std::vector<Question> second =
      towardsLamps(random, list, leaving(random, list, ask(nearestHit, list, first)));
  const Rows expected = ask(isBlocked, list, second), found = ask(isBlocked, tree, second);
  // From kilometres away, rounding puts the end of a segment into a sphere beside it; its box knows better.
  constexpr double farAway = 5000.0;
  std::size_t blocked = 0, different = 0, lessFarAway = 0;
  for (std::size_t i = 0; i < expected.size(); i += 2) {
    blocked += expected[i].x != 0.0f;
    const bool far = second[i / 2].tMax > farAway && expected[i].x > found[i].x;
    (far ? lessFarAway : different) += expected[i].x != found[i].x;
    EXPECT_EQ(found[i].y, 0.0f) << "cut by the loop budget";
  }
  EXPECT_LE(different, allowed(second.size()));
  EXPECT_LT(lessFarAway, 10u);
  EXPECT_GT(blocked, second.size() / 10);
  EXPECT_LT(blocked, second.size() * 9 / 10);
}

// Six walls at 3 m, which face all axes both ways, and one aslant beyond a corner.
Scene closedRoom() {
  Scene scene = plainScene(1);
  const Id matt = add(scene, lambert(glm::vec3(0.5f)));
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-3.0, 3.0}) {
      dvec3 up(0.0), place(0.0);
      up[axis] = -side / 3.0;
      place[axis] = side;
      const dvec3 turn = axis == 1 ? dvec3(1, 0, 0) : glm::cross(dvec3(0, 1, 0), up);
      add(scene, at(place, turn, axis == 1 ? (side > 0 ? pi : 0.0) : pi / 2), Plane{}, matt);
    }
  add(scene, at({4, -4, 4}, {1, 0, -1}, 2.2), Plane{}, matt);
  return scene;
}

TEST_F(Traverse, lights_a_digit_before_a_wall_shine_into_the_room_and_those_a_digit_behind_do_not) {
  const GpuScene scene = packScene(closedRoom(), viewFrom(dvec3(0)), {8, 8});
  ASSERT_EQ(scene.params.planeCount, 7u);
  Random random(15);
  Rows questions;
  std::vector<bool> behind;
  for (int i = 0; i < 60000; ++i) {
    const auto inside = [&] {
      return glm::vec3(2.999 * dvec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
    };
    glm::vec3 place = inside();
    float& height = place[i % 3];
    const float wall = i % 2 ? 3.0f : -3.0f;
    behind.push_back(i % 4 < 2);
    height = wall;
    for (int digit = 0; digit <= i % 5; ++digit)
      height = std::nextafter(height, behind.back() ? 2.0f * wall : 0.0f);
    questions.emplace_back(inside(), 0.0f);
    questions.emplace_back(place, 0.0f);
    questions.emplace_back(-1.0f, -1.0f, 0.0f, 0.0f);
  }
  for (const bool baked : {false, true}) {
    const Rows answers = ask(isBlockedToPlace, scene, questions, baked);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < behind.size(); ++i) wrong += (answers[2 * i].x != 0.0f) != behind[i];
    EXPECT_EQ(wrong, 0u) << (baked ? "baked" : "counted");
  }
}

TEST_F(Traverse, shapes_that_coincide_are_met_in_the_order_of_the_list) {
  Scene scene = plainScene(1);
  const Id matt = add(scene, lambert(glm::vec3(0.5f)));
  for (int i = 0; i < 64; ++i)
    for (int twin = 0; twin < 3; ++twin) {
      const dvec3 place(3.0 * (i % 4), 3.0 * (i / 4 % 4), 3.0 * (i / 16));
      add(scene, at(place), twin == 2 ? Shape(Box{dvec3(1)}) : Shape(Sphere{1.0}), matt);
    }
  const GpuScene list = packScene(scene, viewFrom(dvec3(0)), {8, 8}, ShapeSearch::list);
  const GpuScene tree = packScene(scene, viewFrom(dvec3(0)), {8, 8}, ShapeSearch::hierarchy);
  Random random(13);
  const std::vector<Question> rays = anyRays(random, 20000);
  const Rows hits = ask(nearestHit, list, rays);
  EXPECT_LE(differing(hits, ask(nearestHit, tree, rays)), allowed(rays.size()));
}

TEST_F(Traverse, row16_ten_thousand_shapes_fit_the_loop_budget_and_are_sorted_in_milliseconds) {
  Random random(14);
  Scene scene = plainScene(8);
  const Id matt = add(scene, lambert(glm::vec3(0.5f)));
  for (int i = 0; i < 10000; ++i)
    add(scene, at(50.0 * random.direction() * random.uniform()), Sphere{0.2}, matt);
  const auto seconds = [&](ShapeSearch search) {
    double fastest = 1e9;
    for (int i = 0; i < 3; ++i) {
      const auto start = std::chrono::steady_clock::now();
      packScene(scene, viewFrom(dvec3(0)), {8, 8}, search);
      fastest =
          std::min(fastest, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return fastest;
  };
  const double list = seconds(ShapeSearch::list), tree = seconds(ShapeSearch::hierarchy);
  std::cout << "10,000 spheres: packed in " << 1e3 * list << " ms, with their hierarchy in " << 1e3 * tree
            << " ms\n";
  const GpuScene packed = packScene(scene, viewFrom(dvec3(0)), {8, 8});
  EXPECT_TRUE(packed.shapeHierarchy());
  EXPECT_GE(planLoops(packed.params, cpuDriverLoopBudget, packed.traversalSteps).samplesPerDispatch, 4u);
  const Rows hits = ask(nearestHit, packed, anyRays(random, 20000));
  for (std::size_t i = 0; i < hits.size(); i += 2)
    ASSERT_NE(hits[i + 1].w, -2.0f) << "cut by the loop budget";
  measuredAtLeast("samples that fit a dispatch",
                  planLoops(packed.params, cpuDriverLoopBudget, packed.traversalSteps).samplesPerDispatch, 4);
}

}  // namespace
}  // namespace steradian::kernel
