// SPDX-License-Identifier: MIT
// Shapes under affine maps: boxes, rectangles, disks, cylinders, ellipsoids of any size.
#include <cmath>
#include <cstdint>
#include <functional>

#include "tests/shaders/oracle.hpp"
#include "tests/shaders/scene_rows.hpp"

namespace steradian::kernel {
namespace {

class Solids : public KernelTest {};

/// Rows of a shape as the host stores them: the inverse map by row, the centre beside it.
std::array<glm::vec4, 3> rowsOf(const glm::dmat3& worldFromUnit, const glm::dvec3& centre) {
  const glm::dmat3 byRow = glm::transpose(glm::inverse(worldFromUnit));
  std::array<glm::vec4, 3> rows;
  for (int i = 0; i < 3; ++i) rows[std::size_t(i)] = glm::vec4(glm::vec3(byRow[i]), float(centre[i]));
  return rows;
}

void pushSolid(Rows& rows, glm::dvec3 o, glm::dvec3 d, const std::array<glm::vec4, 3>& shape) {
  rows.insert(rows.end(),
              {glm::vec4(glm::vec3(o), 0), glm::vec4(glm::vec3(d), 0), shape[0], shape[1], shape[2]});
}

const std::array<glm::vec4, 3> unit = rowsOf(glm::dmat3(1.0), glm::dvec3(0.0));

TEST_F(Solids, row12_rays_in_the_plane_of_a_face_hit_the_box) {
  Rows rays;
  for (const double face : {-1.0, 1.0})
    for (const float zero : {0.0f, -0.0f})
      for (int axis = 0; axis < 3; ++axis)
        for (const double along : {-1.0, 1.0}) {
          glm::dvec3 o(0.25), d(0.0);
          o[axis] = face, o[(axis + 1) % 3] = -5.0 * along;
          d[axis] = double(zero), d[(axis + 1) % 3] = along, d[(axis + 2) % 3] = double(zero);
          pushSolid(rays, o, d, unit);
        }
  const Rows answers = run(shapes, {.operation = 3, .rowsIn = 5}, rays);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    EXPECT_FLOAT_EQ(answers[i].x, 4.0f) << "from " << rays[5 * i].x << " " << rays[5 * i].y << " "
                                        << rays[5 * i].z << " face axis " << i / 2 % 3;
    measured("error of t = 4", std::fabs(double(answers[i].x) - 4), 4 * ulp(4.0));
  }
}

TEST_F(Solids, row12_parallel_rays_beside_the_box_miss_it) {
  Rows rays;
  for (const double beside : {-1.001, 1.001})
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 o(0.25), d(0.0);
      o[axis] = beside, o[(axis + 1) % 3] = -5.0, d[(axis + 1) % 3] = 1.0;
      pushSolid(rays, o, d, unit);
    }
  for (const glm::vec4 answer : run(shapes, {.operation = 3, .rowsIn = 5}, rays)) {
    EXPECT_TRUE(missed(answer.x));
    measured("false hits", !missed(answer.x), 0);
  }
}

TEST_F(Solids, row12_a_box_of_a_tenth_of_a_micrometre_stops_every_ray) {
  Random random(12);
  Rows rays;
  for (int i = 0; i < 1 << 16; ++i) {
    const glm::dvec3 centre(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2));
    const glm::dvec3 target = centre + glm::dvec3(0, random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9));
    const glm::dvec3 o = target + random.direction() * random.uniform(1, 5);
    pushSolid(rays, o, glm::normalize(target - o),
              rowsOf(glm::dmat3({0.5e-7, 0, 0}, {0, 1, 0}, {0, 0, 1}), centre));
  }
  int misses = 0;
  for (const glm::vec4 answer : run(shapes, {.operation = 3, .rowsIn = 5}, rays)) misses += missed(answer.x);
  EXPECT_EQ(misses, 0);
  measured("misses of 65,536 rays", misses, 0);
}

using Oracle = std::function<std::optional<oracle::Real>(oracle::Vec, oracle::Vec)>;
/// Cosine of incidence at a point of the unit shape, and how far the point is from its surface.
using Residual = std::function<oracle::Real(oracle::Vec)>;

std::optional<oracle::Real> flat(oracle::Vec o, oracle::Vec d, bool round) {
  const oracle::Real t = -o.y / d.y;
  const oracle::Vec p = o + d * t;
  const bool inside = round ? p.x * p.x + p.z * p.z <= 1 : std::max(std::fabs(p.x), std::fabs(p.z)) <= 1;
  return inside && t > 0 ? std::optional(t) : std::nullopt;
}

struct Kind {
  const char* name;
  std::uint32_t operation;
  Count count;
  Oracle nearest;
  Residual residual;
};

oracle::Real boxDistance(oracle::Vec p) {
  return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) - 1;
}
oracle::Real cylinderDistance(oracle::Vec p) {
  return std::max(std::fabs(p.y), std::sqrt(p.x * p.x + p.z * p.z)) - 1;
}

const Kind kinds[] = {
    {"box", 3, &gpu::TraceParams::boxCount, [](auto o, auto d) { return oracle::nearest(oracle::box(o, d)); },
     boxDistance},
    {"rect", 4, &gpu::TraceParams::rectCount, [](auto o, auto d) { return flat(o, d, false); },
     [](auto p) { return p.y; }},
    {"disk", 5, &gpu::TraceParams::diskCount, [](auto o, auto d) { return flat(o, d, true); },
     [](auto p) { return p.y; }},
    {"cylinder", 6, &gpu::TraceParams::cylinderCount,
     [](auto o, auto d) { return oracle::nearest(oracle::cylinder(o, d)); }, cylinderDistance},
    {"ellipsoid", 7, &gpu::TraceParams::ellipsoidCount,
     [](auto o, auto d) { return oracle::nearest(oracle::sphere(o, d, oracle::Vec(0), 1)); },
     [](auto p) { return glm::length(p) - 1; }}};

struct Affine {
  glm::dmat3 worldFromUnit;
  glm::dvec3 centre;
};

/// Any size from 1e-4 to 1e4, stretched up to four times, turned, somewhere near.
Affine randomAffine(Random& random) {
  const double size = random.decades(-4, 4);
  const glm::dvec3 z = random.direction(), x = glm::normalize(cross(z, random.direction())), y = cross(z, x);
  return {glm::dmat3(x * size * random.uniform(0.5, 2), y * size * random.uniform(0.5, 2),
                     z * size * random.uniform(0.5, 2)),
          random.direction() * size * random.uniform(0, 3)};
}

oracle::Vec toUnit(const glm::vec4* shape, oracle::Vec v) {
  oracle::Vec out;
  for (int i = 0; i < 3; ++i) out[i] = glm::dot(oracle::Vec(xyz(shape[i])), v);
  return out;
}

oracle::Vec centreOf(const glm::vec4* shape) {
  return {shape[0].w, shape[1].w, shape[2].w};
}

TEST_F(Solids, row13_shapes_of_any_size_agree_with_long_double) {
  constexpr int count = 200000;
  for (const Kind& kind : kinds) {
    Random random(13);
    Rows rays;
    for (int i = 0; i < count; ++i) {
      const Affine shape = randomAffine(random);
      const glm::dvec3 o = shape.centre + shape.worldFromUnit * (random.direction() * random.uniform(0, 8));
      const glm::dvec3 target =
          shape.centre + shape.worldFromUnit * (random.direction() * random.uniform(0, 1.5));
      pushSolid(rays, o, glm::normalize(target - o), rowsOf(shape.worldFromUnit, shape.centre));
    }
    const Rows answers = run(shapes, {.operation = kind.operation, .rowsIn = 5}, rays);
    int wrongClass = 0, steep = 0;
    double worst = 0, worstResidual = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const glm::vec4* q = &rays[5 * i];
      const oracle::Vec o = toUnit(q + 2, oracle::Vec(xyz(q[0])) - centreOf(q + 2));
      const oracle::Vec d = toUnit(q + 2, oracle::Vec(xyz(q[1])));
      const auto t = kind.nearest(o, d);
      wrongClass += t.has_value() == missed(answers[i].x);
      if (!t || missed(answers[i].x)) continue;
      // Near tangency t is ill-conditioned: there only the point's distance from the surface counts.
      const oracle::Real away = kind.residual(o + d * oracle::Real(answers[i].x));
      worstResidual = std::max(worstResidual, std::fabs(double(away)));
      const oracle::Real step = 1e-4 / glm::length(d);
      const oracle::Real cosine = std::fabs(kind.residual(o + d * (*t - step)) / 1e-4L);
      if (cosine < 0.1) continue;
      ++steep;
      worst = std::max(worst, std::fabs(double((answers[i].x - *t) / (*t + 1 / glm::length(d)))));
    }
    EXPECT_LE(wrongClass, count * 2e-5) << kind.name;
    EXPECT_LE(worst, 1e-5) << kind.name;
    EXPECT_LE(worstResidual, 1e-5) << kind.name;
    measured("share of rays that should miss or hit", double(wrongClass) / count, 2e-5);
    measured("relative error of t", worst, 1e-5);
    measured("distance of the hit from the surface, sizes", worstResidual, 1e-5);
    EXPECT_GT(steep, count / 4) << kind.name;
  }
}

TEST_F(Solids, row13_hit_points_lie_on_the_surface_and_normals_are_outward_units) {
  constexpr int count = 20000;
  for (const Kind& kind : kinds) {
    Random random(131);
    for (int scene = 0; scene < 4; ++scene) {
      const Affine shape = randomAffine(random);
      const auto stored = rowsOf(shape.worldFromUnit, shape.centre);
      Rows rays;
      for (int i = 0; i < count; ++i) {
        const glm::dvec3 o = shape.centre + shape.worldFromUnit * (random.direction() * random.uniform(2, 8));
        const glm::dvec3 target =
            shape.centre + shape.worldFromUnit * (random.direction() * random.uniform(0, 1));
        rays.insert(rays.end(),
                    {glm::vec4(glm::vec3(o), 0), glm::vec4(glm::vec3(glm::normalize(target - o)), 0)});
      }
      const Rows answers =
          run(sceneKernel, sceneTask(0, kind.count, {stored[0], stored[1], stored[2]}), rays);
      double away = 0, length = 0, outward = 1;
      for (std::size_t i = 0; i < count; ++i) {
        if (missed(answers[3 * i].x)) continue;
        const oracle::Vec p =
            toUnit(stored.data(), oracle::Vec(xyz(answers[3 * i + 1])) - centreOf(stored.data()));
        const oracle::Vec n(xyz(answers[3 * i + 2]));
        away = std::max(away, double(std::fabs(kind.residual(p))));
        length = std::max(length, double(std::fabs(glm::length(n) - 1)));
        outward = std::min(outward,
                           double(glm::dot(n, oracle::Vec(glm::dvec3(shape.worldFromUnit * glm::dvec3(p)))) /
                                  glm::length(shape.worldFromUnit[0])));
      }
      EXPECT_LE(away, 2e-6) << kind.name;
      EXPECT_LE(length, 3e-7) << kind.name;
      measured("distance of the hit from the surface, sizes", away, 2e-6);
      measured("error of the normal's length", length, 3e-7);
      EXPECT_GT(outward, kind.operation == 4 || kind.operation == 5 ? -1e-5 : 0.0) << kind.name;
    }
  }
}

TEST_F(Solids, row05_no_shape_hits_itself_and_no_solid_leaks) {
  constexpr int count = 100000;
  for (const Kind& kind : kinds) {
    Random random(53);
    const bool solid = kind.operation != 4 && kind.operation != 5;
    int selfHits = 0, leaks = 0, hits = 0;
    for (int scene = 0; scene < 4; ++scene) {
      const Affine shape = randomAffine(random);
      const auto stored = rowsOf(shape.worldFromUnit, shape.centre);
      Rows rays;
      for (int i = 0; i < count; ++i) {
        const double from = i % 2 ? random.uniform(2, 8) : random.uniform(0, 0.9);
        const glm::dvec3 o = shape.centre + shape.worldFromUnit * (random.direction() * from);
        const glm::dvec3 target =
            shape.centre + shape.worldFromUnit * (random.direction() * random.uniform(0, 1));
        rays.insert(rays.end(),
                    {glm::vec4(glm::vec3(o), 0), glm::vec4(glm::vec3(glm::normalize(target - o)), 0)});
      }
      for (const glm::vec4 answer :
           run(sceneKernel, sceneTask(1, kind.count, {stored[0], stored[1], stored[2]}), rays)) {
        if (missed(answer.x)) continue;
        ++hits;
        selfHits += (answer.z == 0.0f || !solid) && !missed(answer.y);
        leaks += solid && answer.z == 1.0f && missed(answer.y);
      }
    }
    EXPECT_EQ(selfHits, 0) << kind.name;
    EXPECT_EQ(leaks, 0) << kind.name;
    measured("self hits and leaks of 400,000 rays", selfHits + leaks, 0);
    EXPECT_GT(hits, count) << kind.name;
  }
}

}  // namespace
}  // namespace steradian::kernel
