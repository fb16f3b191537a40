// SPDX-License-Identifier: MIT
// The renderer against the independent oracle: Welch's t-test for every pixel of every case of a list.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "tests/oracle/agreement_scenes.hpp"
#include "tests/oracle/statistics.hpp"
#include "tests/renderer/renderer_fixture.hpp"

namespace steradian {

inline void PrintTo(const AgreementCase& which, std::ostream* out) {
  *out << which.feature;
}

inline AgreementCase named(const std::vector<AgreementCase>& cases, const std::string& feature) {
  return *std::find_if(cases.begin(), cases.end(), [&](const auto& c) { return c.feature == feature; });
}

class OracleComparison : public RendererTest {
 protected:
  /// Scenes that look alike in places must not share their noise: of the name (Fowler, Noll & Vo's hash).
  static unsigned seedOf(const AgreementCase& test) {
    unsigned hash = 2166136261u;
    for (const char c : test.feature) hash = (hash ^ unsigned(c)) * 16777619u;
    return hash;
  }
  /// Pictures of independent seeds: each is one sample, whatever pattern its own points have.
  oracle::Estimate ourEstimate(AgreementCase test) {
    constexpr int seeds = 16;
    std::vector<Image> images;
    for (int i = 0; i < seeds; ++i) {
      test.scene.render.seed = seedOf(test) + unsigned(i);
      images.push_back(render(test.scene, test.view, {test.size, test.size}, std::uint64_t(test.samples)));
    }
    return oracle::fromImages(images);
  }
  static oracle::Estimate truthOf(const AgreementCase& test) {
    return oracle::trace(test.scene, test.view, test.size, test.size, test.oracleSamples, seedOf(test));
  }
  /// Whether a scene that differs a little from `right` fails to agree with it.
  template <class Fault>
  bool caught(const AgreementCase& right, const Fault& fault) {
    return caught(right, truthOf(right), fault);
  }
  template <class Fault>
  bool caught(const AgreementCase& right, const oracle::Estimate& truth, const Fault& fault) {
    AgreementCase wrong = right;
    fault(wrong.scene);
    const oracle::Estimate ours = ourEstimate(wrong);
    return !oracle::compare(ours, truth).holds() || !oracle::compare(ours, truth, 5).holds() ||
           !oracle::compare(ours, truth, right.size).holds();
  }
  /// A fault of all materials.
  template <class Change>
  static auto ofMaterials(Change change) {
    return [change](Scene& scene) {
      for (Material& material : scene.materials) change(material);
    };
  }
  /// A fault of all meshes.
  template <class Change>
  static auto ofMeshes(Change change) {
    return [change](Scene& scene) {
      for (Object& object : scene.objects) {
        auto* geometry = std::get_if<Geometry>(&object.content);
        auto* shape = geometry ? std::get_if<MeshShape>(&geometry->shape) : nullptr;
        if (!shape) continue;
        Mesh mesh = *shape->mesh;
        change(mesh);
        shape->mesh = sharedMesh(std::move(mesh));
      }
    };
  }
  /// A fault of all lights.
  template <class Change>
  static auto ofLights(Change change) {
    return [change](Scene& scene) {
      for (Object& object : scene.objects)
        if (auto* light = std::get_if<Light>(&object.content)) change(*light);
    };
  }
};

/// Looks at the p-values of all scenes of a list together, where what is too little to be seen in one adds
/// up.
class OracleAgreement : public OracleComparison, public testing::WithParamInterface<AgreementCase> {
 protected:
  static void SetUpTestSuite() {
    OracleComparison::SetUpTestSuite();
    histogram_ = {};
  }
  static void TearDownTestSuite() {
    double total = 0.0, chiSquare = 0.0;
    for (const int count : histogram_) total += count;
    for (const int count : histogram_)
      chiSquare += std::pow(count - 0.1 * total, 2.0) / std::max(0.1 * total, 1.0);
    std::printf("%.0f p-values of all scenes: chi-square %.1f\n", total, chiSquare);
    EXPECT_LE(chiSquare, 33.72) << "p-values of all scenes are uneven (9 degrees of freedom, p = 1e-4)";
    OracleComparison::TearDownTestSuite();
  }
  static void addToHistogram(const oracle::Agreement& agreement) {
    for (std::size_t i = 0; i < histogram_.size(); ++i) histogram_[i] += agreement.histogram[i];
  }

 private:
  static inline std::array<int, 10> histogram_{};
};

TEST_P(OracleAgreement, EveryPixelIsTheOracles) {
  const AgreementCase& test = GetParam();
  const oracle::Estimate ours = ourEstimate(test), truth = truthOf(test);
  const oracle::Agreement pixels = oracle::compare(ours, truth);
  std::printf("%s: %s", test.feature.c_str(), report(pixels).c_str());
  EXPECT_TRUE(pixels.holds()) << report(pixels);
  addToHistogram(pixels);
  measuredAtLeast("p of the evenness of the pixels' p-values", pixels.uniformity, 1e-4);
  for (const int tile : {5, test.size}) {
    const oracle::Agreement tiles = oracle::compare(ours, truth, tile);
    EXPECT_TRUE(tiles.holds()) << "tiles of " << tile << " pixels: " << report(tiles);
  }
  EXPECT_GE(pixels.random, pixels.tests / 6) << "too little noise to test, or a black picture";
}

inline const auto featureOf = [](const auto& info) { return info.param.feature; };

}  // namespace steradian
