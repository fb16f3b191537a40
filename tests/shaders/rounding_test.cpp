// SPDX-License-Identifier: MIT
// How much float loses: every function on the device and in C++ float against the same text in double.
#include <cstdint>

#include "shaders/kernel_rounding.comp.h"
#include "tests/shaders/rounding.hpp"
#include "tests/shaders/rounding_inputs.hpp"
#include "tests/shaders/rounding_kernel.hpp"

namespace steradian::kernel {
namespace {

template <class Real>
glm::dvec4 answerOf(reference::RoundingKernel<Real>& kernel, std::uint32_t operation, const Question& q) {
  using Row = glm::vec<4, Real>;
  return glm::dvec4(kernel.rounded(operation, Row(q[0]), Row(q[1]), Row(q[2]), Row(q[3]), Row(q[4])));
}

// Four times what was measured with llvmpipe and g++. Where `all` is far above `most`, inputs at the edge of
// the domain are ill-conditioned (a ray that grazes, a light seen edge-on).
const Gate<Question> gates[] = {
    {"hitSphere t", 0, sphereQuestion, 8.4e-6, 5.2e-4},
    {"hitLargeSphere t", 1, largeSphereQuestion, 6.8e-4, 1.7e-1},
    {"hitPlane t", 2, planeQuestion, 6.8e-5, 4.4e-3},
    {"hitBox t", 3, affineQuestion, 2.2e-5, 3.3e-3},
    {"hitCylinder t", 4, affineQuestion, 2.5e-5, 1.6e-3},
    {"hitEllipsoid t", 5, affineQuestion, 1.9e-5, 7.6e-4},
    {"ggxD", 10, scatteringQuestion, 1.9e-6, 2.6e-6},
    {"smithG2", 11, scatteringQuestion, 6.8e-7, 9.2e-7},
    {"fresnelDielectric", 12, scatteringQuestion, 4.4e-6, 6.4e-5},
    {"reflectingFacets f cos", 13, scatteringQuestion, 2.5e-6, 3.2e-6},
    {"reflectingFacets pdf", 14, scatteringQuestion, 2.2e-6, 3.0e-6},
    {"visibleNormal", 15, scatteringQuestion, 5.6e-6, 1.2e-3},
    {"cosineHemisphere", 16, scatteringQuestion, 3.9e-7, 4.8e-7},
    {"cosSinTurn", 17, scatteringQuestion, 3.7e-7, 4.4e-7},
    {"frameAround t", 18, directionQuestion, 3.8e-7, 4.8e-7},
    {"powerHeuristic", 19, heuristicQuestion, 6.4e-7, 8.8e-7},
    {"sampleSphere direction", 20, lightQuestion, 6.8e-7, 8.8e-7},
    {"sampleSphere pdf", 21, lightQuestion, 1.5e-6, 1.9e-6},
    {"sampleRect direction", 22, lightQuestion, 1.0e-6, 4.4e-6},
    {"sampleRect pdf", 23, lightQuestion, 9.2e-5, 8.4e-3},
    {"sampleDisk direction", 24, lightQuestion, 8.8e-7, 1.2e-5},
    {"sampleDisk pdf", 25, lightQuestion, 1.0e-4, 6.0e-3},
    {"sampleTriangle direction", 26, glowingTriangleQuestion, 5.2e-7, 6.4e-7},
    {"sampleTriangle pdf", 27, glowingTriangleQuestion, 1.0e-4, 1.7e-2},
    {"hitRect t", 6, affineQuestion, 1.2e-5, 8.4e-4},
    {"hitDisk t", 7, affineQuestion, 1.2e-5, 5.6e-4},
    {"hitTriangle t", 30, triangleQuestion, 2.4e-6, 5.6e-6},
    {"hitTriangle weights", 31, triangleQuestion, 1.2e-3, 3.0e-3},
    {"hitTriangle t, slivers", 30, sliverQuestion, 2.6e-5, 1.5e-4, 2e-3},
    {"hitTriangle t, grazing", 30, grazedTriangleQuestion, 2.3e-4, 6.0e-4, 2e-3},
    {"refracted", 32, refractionQuestion, 4.8e-6, 1.8e-4},
    {"refractingFacets f cos", 33, refractionQuestion, 7.6e-4, 7.2e-2},
    {"refractingFacets pdf", 34, refractionQuestion, 7.6e-4, 1.9e-2},
    {"anyNormal", 40, warpQuestion, 4.8e-7, 6.4e-7},
    {"coneDirection", 41, warpQuestion, 4.8e-7, 7.6e-7},
    {"sampleLinear", 42, warpQuestion, 7.2e-7, 8.8e-7},
    {"mapDirection", 43, warpQuestion, 4.8e-7, 6.0e-7},
    {"turnOf", 44, warpQuestion, 5.6e-7, 8.8e-7},
    {"sampleSolid box, wi", 50, solidQuestion, 1.8e-6, 1.7e-5},
    {"sampleSolid box, pdf", 51, solidQuestion, 1.5e-5, 3.0e-5},
    {"sampleSolid cylinder, wi", 52, solidQuestion, 1.7e-6, 9.2e-6},
    {"sampleSolid cylinder, pdf", 53, solidQuestion, 1.5e-4, 2.4e-4},
    {"sampleSolid ellipsoid, wi", 54, solidQuestion, 7.6e-7, 1.0e-6},
    {"sampleSolid ellipsoid, pdf", 55, solidQuestion, 3.3e-6, 4.8e-6},
    {"samplePair, independent", 45, warpQuestion, 0, 0},
};

class RoundingOfFunctions : public KernelTest {};

TEST_F(RoundingOfFunctions, device_and_host_float_stay_within_their_gates_of_double) {
  constexpr std::size_t questions = 100'000;
  const Kernel kernel{kernel_rounding_spirv, "rounding"};
  reference::RoundingKernel<float> single;
  reference::RoundingKernel<double> exactly;
  printRoundingHead();
  for (const Gate<Question>& gate : gates) {
    Random random(1000 + gate.operation);
    Rows rows;
    std::vector<glm::dvec4> host, exact, device;
    for (std::size_t i = 0; i < questions; ++i) {
      const Question q = gate.question(random);
      rows.insert(rows.end(), q.begin(), q.end());
      host.push_back(answerOf(single, gate.operation, q));
      exact.push_back(answerOf(exactly, gate.operation, q));
    }
    for (const glm::vec4& row : run(kernel, {.operation = gate.operation, .rowsIn = 5}, rows))
      device.push_back(glm::dvec4(row));
    const double choice = gate.choice ? gate.all : 0.0;
    expectWithin(gate, errorsOf(device, exact, choice), errorsOf(host, exact, choice), questions);
  }
}

/// Rows of a shape of any sizes in any place, and a point anywhere, in it or on it; (p, u) (centre, v)
/// follow.
std::array<glm::vec4, 5> extremeQuestion(Random& random, double decades) {
  const glm::dvec3 z = random.direction(), x = glm::normalize(glm::cross(z, random.direction())),
                   y = cross(z, x);
  const glm::dvec3 size(random.decades(-decades, decades), random.decades(-decades, decades),
                        random.decades(-decades, decades));
  const glm::dvec3 centre = random.direction() * random.decades(-decades, decades);
  const double kind = random.uniform();
  const glm::dvec3 unit = kind < 0.3   ? random.direction() * random.uniform(0, 2)
                          : kind < 0.5 ? glm::dvec3(1, random.uniform(-1, 1), 0)
                                       : glm::dvec3(0, 0, 0);
  glm::dvec3 p = centre + x * (size.x * unit.x) + y * (size.y * unit.y) + z * (size.z * unit.z);
  if (kind > 0.5) p = random.direction() * random.decades(-decades, decades);
  return {glm::vec4(glm::vec3(p), float(random.uniform(0, 0.9999999))),
          glm::vec4(0, 0, 0, random.uniform(0, 0.9999999)), glm::vec4(glm::vec3(x / size.x), float(centre.x)),
          glm::vec4(glm::vec3(y / size.y), float(centre.y)),
          glm::vec4(glm::vec3(z / size.z), float(centre.z))};
}

TEST(LightsOfAnySize, row40_solids_are_sampled_without_a_number_that_is_none) {
  reference::RoundingKernel<float> kernel;
  constexpr int questions = 200'000;
  int dark = 0;  // of the ordinary ones: these are to be seen
  for (const double decades : {1.0, 4.0, 12.0}) {
    Random random(40);
    for (int i = 0; i < questions; ++i) {
      const auto q = extremeQuestion(random, decades);
      for (std::uint32_t operation = 50; operation < 56; ++operation) {
        const glm::vec4 answer = kernel.rounded(operation, q[0], q[1], q[2], q[3], q[4]);
        const bool pdf = operation % 2 != 0;
        dark += pdf && decades == 1.0 && answer.x == 0.0f;
        ASSERT_TRUE(!std::isnan(answer.x) && !std::isnan(answer.y) && !std::isnan(answer.z) &&
                    answer.x >= (pdf ? 0.0f : -2.0f))
            << "operation " << operation << ", decades " << decades << ", question " << i << ": " << answer.x
            << " " << answer.y << " " << answer.z;
      }
    }
  }
  EXPECT_LT(dark, questions / 100);
  measured("share of ordinary solids that are not seen", double(dark) / (3.0 * questions), 1.0 / 300);
}

}  // namespace
}  // namespace steradian::kernel
