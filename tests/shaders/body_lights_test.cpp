// SPDX-License-Identifier: MIT
// Glowing disks, boxes, cylinders and ellipsoids as lights, from scenes as the renderer packs them: samples
// lie on them as densely as is stated, the density is that of the direction, and integrates to 1.
#include "renderer/gpu_scene.hpp"
#include "tests/renderer/scenes.hpp"
#include "tests/shaders/histogram.hpp"
#include "tests/shaders/light_samples.hpp"

namespace steradian::kernel {
namespace {

using namespace scenes;

constexpr float bodyNit = 3.0f;

/// The part of a unit shape that a point sees, as a map from the unit square onto its surface.
using Chart = std::function<dvec3(double, double)>;

struct Lamp {
  const char* name;
  Shape shape;
  dvec3 unit;  // half sizes of the shape
  Transform place;
  dvec3 p;  // that it shines on
  Chart (*chart)(const dvec3&);
  double (*offSurface)(const dvec3&);
};

double share(double x, double low, double high) {
  return low + (high - low) * x;
}

Chart diskChart(const dvec3&) {
  return [](double x, double y) {
    const double r = std::sqrt(x), angle = 2 * M_PI * y;
    return dvec3(r * std::cos(angle), 0, r * std::sin(angle));
  };
}

/// Three faces, rows 0-32, 33-66 and 67-100 of the histogram.
Chart boxChart(const dvec3& p) {
  const dvec3 s = glm::sign(p);
  return [s](double x, double y) {
    const double b = 2 * y - 1;
    if (x < 33.0 / 101) return dvec3(s.x, 2 * x * 101 / 33 - 1, b);
    if (x < 67.0 / 101) return dvec3(b, s.y, 2 * (x * 101 - 33) / 34 - 1);
    return dvec3(2 * (x * 101 - 67) / 34 - 1, b, s.z);
  };
}

/// The upper cap in rows 0-49, the half of the tube towards p in the others.
Chart cylinderChart(const dvec3& p) {
  const double middle = std::atan2(p.z, p.x), half = std::acos(1 / std::hypot(p.x, p.z)), up = p.y;
  return [=](double x, double y) {
    if (x < 50.0 / 101 && std::fabs(up) > 1) {
      const dvec3 cap = diskChart({})(x * 101 / 50, y);
      return dvec3(cap.x, up > 0 ? 1 : -1, cap.z);
    }
    const double angle = middle + share(y, -half, half), low = std::fabs(up) > 1 ? 50.0 / 101 : 0;
    return dvec3(std::cos(angle), 2 * (x - low) / (1 - low) - 1, std::sin(angle));
  };
}

/// The cap of the unit ball towards p.
Chart ballChart(const dvec3& p) {
  const dvec3 axis = glm::normalize(p), a = across(axis, {0.3, 0.5, -0.7}), b = glm::cross(axis, a);
  const double least = 1 / glm::length(p);
  return [=](double x, double y) {
    const double cosine = share(x, least, 1), sine = std::sqrt(1 - cosine * cosine), angle = 2 * M_PI * y;
    return axis * cosine + (a * std::cos(angle) + b * std::sin(angle)) * sine;
  };
}

double offDisk(const dvec3& q) {
  return std::max(std::fabs(q.y), std::hypot(q.x, q.z) - 1);
}
double offBox(const dvec3& q) {
  const dvec3 a = glm::abs(q);
  return std::fabs(std::max({a.x, a.y, a.z}) - 1);
}
double offCylinder(const dvec3& q) {
  return std::fabs(std::max(std::hypot(q.x, q.z), std::fabs(q.y)) - 1);
}
double offBall(const dvec3& q) {
  return std::fabs(glm::length(q) - 1);
}

const dvec3 turned(1, 2, 0.5);

std::vector<Lamp> lamps() {
  const auto lamp = [](const char* name, Shape shape, dvec3 unit, dvec3 centre, dvec3 scale, dvec3 p,
                       auto chart, auto off) {
    return Lamp{name, shape, unit, at(centre, turned, 0.7, scale), p, chart, off};
  };
  const Disk disk{0.5};
  const Box box{{1.0, 0.6, 0.4}};
  const Cylinder tube{0.1, 2.0};
  const Sphere ball{0.5};
  const dvec3 c(0.3, 0.2, -1), one(1), d(0.5, 1, 0.5), b(0.5, 0.3, 0.2), t(0.1, 1, 0.1), s(0.5);
  return {
      {lamp("disk", disk, d, c, one, {0, 0, 0}, diskChart, offDisk)},
      {lamp("disk, close", disk, d, c, one, c + dvec3(0.02, 0.03, 0.06), diskChart, offDisk)},
      {lamp("disk, grazed", disk, d, c, one, c + dvec3(0.9, 0.1, 0.1), diskChart, offDisk)},
      {lamp("disk, far", disk, d, c, one, {20, 30, 9}, diskChart, offDisk)},
      {lamp("ellipse", disk, d, c, {0.4, 1, -1.7}, {0.1, 0, 0.2}, diskChart, offDisk)},
      {lamp("box", box, b, c, one, {0.2, 0.9, 0.4}, boxChart, offBox)},
      {lamp("box, stretched", box, b, c, {2, -0.3, 1}, {1.95, 0.73, -1.44}, boxChart, offBox)},
      {lamp("tube beside", tube, t, c, one, c + dvec3(0.3, 0.1, 0.2), cylinderChart, offCylinder)},
      {lamp("tube from above", tube, t, c, {3, 0.5, 2}, c + dvec3(1, 2, 0.3), cylinderChart, offCylinder)},
      {lamp("ellipsoid", ball, s, c, {0.4, -1, 2}, {0.9, 0.5, 0.3}, ballChart, offBall)},
      {lamp("ellipsoid, far", ball, s, c, {0.06, 0.03, 0.06}, {0.9, -0.5, 0.3}, ballChart, offBall)}};
}

class BodyLights : public KernelTest {
 protected:
  /// A lamp as the renderer packs it, and as the test knows it.
  struct Lit {
    GpuScene packed;
    glm::dmat4 worldFromUnit;
    dvec3 inUnit;  // the point
    vec3 p;        // relative to the camera
  };
  static Lit light(const Lamp& lamp) {
    Scene scene = plainScene(1);
    add(scene, lamp.place, lamp.shape, add(scene, emitter(bodyNit)));
    Lit lit{packScene(scene, lookAt({0, 0, 0}, {0, 0, -1}, 1.0), {8, 8}), {}, {}, {}};
    EXPECT_EQ(lit.packed.params.lightCount, 1u) << lamp.name;
    lit.worldFromUnit = matrixOf(lamp.place) * glm::scale(glm::dmat4(1), lamp.unit);
    lit.p = vec3(lamp.p - lit.packed.origin);
    lit.inUnit = dvec3(glm::inverse(lit.worldFromUnit) * glm::dvec4(dvec3(lit.p) + lit.packed.origin, 1));
    return lit;
  }
  static Task taskFor(const Lit& lit, std::uint32_t operation, std::size_t rowsIn, std::size_t rowsOut) {
    Task task{.operation = operation,
              .rowsIn = rowsIn,
              .rowsOut = rowsOut,
              .push = pushBytes(lit.packed.params),
              .scene = lit.packed.rows};
    for (std::uint32_t i = 0; i < gpu::SOLID_LIGHT_KINDS; ++i)
      task.constants.emplace_back(gpu::CONSTANT_SOLID_LIGHTS + i, (lit.packed.solidLights >> i) & 1u);
    return task;
  }
  static std::vector<Sample> draw(const Lit& lit, std::size_t count) {
    Task task = taskFor(lit, 1, 0, 3);
    task.invocations = count;
    const Rows a = run(lights, task, {glm::vec4(lit.p, 0)});
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < a.size(); i += 3)
      samples.push_back({xyz(a[i]), a[i].w, a[i + 1].x, a[i + 1].w, a[i + 2].x, a[i + 2].y, a[i + 2].z});
    return samples;
  }
  /// Stated densities of directions.
  static std::vector<double> densities(const Lit& lit, const std::vector<dvec3>& directions) {
    Rows questions;
    for (const dvec3& wi : directions) {
      questions.emplace_back(lit.p, 0);
      questions.emplace_back(vec3(wi), 0);
    }
    std::vector<double> answers;
    for (const glm::vec4& a : run(lights, taskFor(lit, 4, 2, 1), questions)) answers.push_back(a.x);
    return answers;
  }
  static dvec3 unitPoint(const Lit& lit, const Sample& s) {
    const dvec3 world = dvec3(lit.p) + lit.packed.origin + s.wi * s.distance;
    return dvec3(glm::inverse(lit.worldFromUnit) * glm::dvec4(world, 1));
  }
};

constexpr int rows = 101, columns = 202;

/// Points of Gauss's rule with two points a side, of all cells.
struct Quadrature {
  std::vector<dvec3> directions;
  std::vector<double> solidAngles;  // that each stands for
};

Quadrature quadrature(const Chart& chart, const glm::dmat4& world, const dvec3& p) {
  Quadrature q;
  const double step = 1e-5, gauss = 0.5 / std::sqrt(3.0);
  const auto onto = [&](double x, double y) { return dvec3(world * glm::dvec4(chart(x, y), 1)); };
  for (int i = 0; i < rows * columns * 4; ++i) {
    const double x = (i / 4 / columns + 0.5 + (i % 4 / 2 ? gauss : -gauss)) / rows,
                 y = (i / 4 % columns + 0.5 + (i % 2 ? gauss : -gauss)) / columns;
    const dvec3 dx = (onto(x + step, y) - onto(x - step, y)) / (2 * step),
                dy = (onto(x, y + step) - onto(x, y - step)) / (2 * step), f = onto(x, y) - p;
    const double d = glm::length(f);
    q.directions.push_back(f / d);
    q.solidAngles.push_back(std::fabs(glm::dot(glm::cross(dx, dy), f)) / (d * d * d) /
                            (4.0 * rows * columns));
  }
  return q;
}

/// Where on the chart a point of the surface lies, by the nearest of the chart's cells: the inverse in closed
/// form.
dvec3 onChart(const Lamp& lamp, const dvec3& seenFrom, const dvec3& q);

TEST_F(BodyLights, row24_they_are_filled_as_densely_as_is_stated) {
  const double significance = 1 - std::pow(0.99, 1.0 / double(lamps().size()));
  for (const Lamp& lamp : lamps()) {
    const Lit lit = light(lamp);
    const dvec3 p = dvec3(lit.p) + lit.packed.origin;
    const Quadrature q = quadrature(lamp.chart(lit.inUnit), lit.worldFromUnit, p);
    const std::vector<double> pdf = densities(lit, q.directions);
    std::vector<double> shares(rows * columns, 0.0);
    double whole = 0;
    for (std::size_t i = 0; i < pdf.size(); ++i) shares[i / 4] += pdf[i] * q.solidAngles[i];
    for (const double s : shares) whole += s;
    EXPECT_NEAR(whole, 1.0, 1e-3) << lamp.name << ": the density's integral over the shape";
    measured("error of the density's integral", std::fabs(whole - 1), 1e-3);
    const auto cell = [&](const Sample& s) { return onChart(lamp, lit.inUnit, unitPoint(lit, s)); };
    const auto expected = [&](int r, int c) { return shares[std::size_t(r * columns + c)] / whole; };
    expectEven(histogramP(draw(lit, manySamples), cell, expected), significance, lamp.name);
  }
}

double turnOf(double x, double y) {
  const double angle = std::atan2(y, x) / (2 * M_PI);
  return angle < 0 ? angle + 1 : angle;
}

dvec3 onBoxChart(const dvec3& p, const dvec3& q) {
  const dvec3 off = glm::abs(q * glm::sign(p) - 1.0);
  if (off.x <= off.y && off.x <= off.z) return {33 * (q.y + 1) / 2 / 101, (q.z + 1) / 2, 0};
  if (off.y <= off.z) return {(33 + 34 * (q.z + 1) / 2) / 101, (q.x + 1) / 2, 0};
  return {(67 + 34 * (q.x + 1) / 2) / 101, (q.y + 1) / 2, 0};
}

dvec3 onCylinderChart(const dvec3& p, const dvec3& q) {
  const double r2 = q.x * q.x + q.z * q.z, low = std::fabs(p.y) > 1 ? 50.0 / 101 : 0;
  if (low > 0 && std::fabs(q.y * (p.y > 0 ? 1 : -1) - 1) < std::fabs(std::sqrt(r2) - 1))
    return {r2 * 50 / 101, turnOf(q.x, q.z), 0};
  const double half = std::acos(1 / std::hypot(p.x, p.z));
  const double angle = std::remainder(std::atan2(q.z, q.x) - std::atan2(p.z, p.x), 2 * M_PI);
  return {low + (1 - low) * (q.y + 1) / 2, (angle / half + 1) / 2, 0};
}

dvec3 onBallChart(const dvec3& p, const dvec3& q) {
  const dvec3 axis = glm::normalize(p), a = across(axis, {0.3, 0.5, -0.7}), b = glm::cross(axis, a);
  const double least = 1 / glm::length(p);
  return {(glm::dot(q, axis) - least) / (1 - least), turnOf(glm::dot(q, a), glm::dot(q, b)), 0};
}

dvec3 onChart(const Lamp& lamp, const dvec3& seenFrom, const dvec3& q) {
  if (lamp.chart == boxChart) return onBoxChart(seenFrom, q);
  if (lamp.chart == cylinderChart) return onCylinderChart(seenFrom, q);
  if (lamp.chart == ballChart) return onBallChart(seenFrom, q);
  return {q.x * q.x + q.z * q.z, turnOf(q.x, q.z), 0};
}

TEST_F(BodyLights, row25_a_sample_lies_on_the_shape_and_carries_the_density_of_its_direction) {
  for (const Lamp& lamp : lamps()) {
    const Lit lit = light(lamp);
    double worstPdf = 0, worstPlace = 0, least = 1e30, most = 0;
    std::size_t rim = 0;
    for (const Sample& s : draw(lit, 1 << 16)) {
      worstPlace = std::max(worstPlace, lamp.offSurface(unitPoint(lit, s)));
      // Where two sides meet, rounding may ask for the other side's density.
      const double off = std::fabs(s.askedPdf / s.pdf - 1);
      if (off > 1e-4)
        ++rim;
      else
        worstPdf = std::max(worstPdf, off);
      EXPECT_NEAR(s.illuminance * s.pdf, bodyNit, 1e-5);
      least = std::min(least, s.pdf), most = std::max(most, s.pdf);
    }
    EXPECT_LT(rim, 7u) << lamp.name << ": beside 1e-4 of the edges";
    EXPECT_LE(worstPlace, 1e-3) << lamp.name;
    measured("share of samples whose densities differ", double(rim) / (1 << 16), 1e-4);
    measured("distance from the surface / size", worstPlace, 1e-3);
    std::printf("%s: densest / least dense %.2f\n", lamp.name, most / least);
  }
}

TEST_F(BodyLights, a_solid_lights_its_inside_evenly) {
  for (const Lamp& lamp : lamps()) {
    if (lamp.chart == diskChart) continue;
    Lamp inside = lamp;
    inside.p = inside.place.translation + dvec3(2e-3, -1e-3, 3e-3);
    const Estimate e = estimate(draw(light(inside), 1 << 16),
                                [](const Sample& s) { return s.illuminance * std::max(s.wi.y, 0.0); });
    EXPECT_NEAR(e.mean, M_PI * double(bodyNit), 4 * e.sigma) << lamp.name;
  }
}

}  // namespace
}  // namespace steradian::kernel
