// SPDX-License-Identifier: MIT
// The renderer against the independent oracle, feature by feature: Welch's t-test for every pixel.
#include <algorithm>
#include <type_traits>

#include "tests/oracle/agreement_scenes.hpp"
#include "tests/oracle/statistics.hpp"
#include "tests/renderer/renderer_fixture.hpp"

namespace steradian {

void PrintTo(const AgreementCase& which, std::ostream* out) {
  *out << which.feature;
}

namespace {

AgreementCase named(const std::vector<AgreementCase>& cases, const std::string& feature) {
  return *std::find_if(cases.begin(), cases.end(), [&](const auto& c) { return c.feature == feature; });
}

class OracleComparison : public RendererTest {
 protected:
  /// Pictures of independent seeds: each is one sample, whatever pattern its own points have.
  oracle::Estimate ourEstimate(AgreementCase test) {
    constexpr int seeds = 16;
    std::vector<Image> images;
    for (int i = 0; i < seeds; ++i) {
      test.scene.render.seed = 100u + unsigned(i);
      images.push_back(render(test.scene, test.view, {test.size, test.size}, std::uint64_t(test.samples)));
    }
    return oracle::fromImages(images);
  }
  static oracle::Estimate truthOf(const AgreementCase& test) {
    return oracle::trace(test.scene, test.view, test.size, test.size, test.oracleSamples);
  }
};

class OracleAgreement : public OracleComparison, public testing::WithParamInterface<AgreementCase> {};

TEST_P(OracleAgreement, EveryPixelIsTheOracles) {
  const AgreementCase& test = GetParam();
  const oracle::Estimate ours = ourEstimate(test), truth = truthOf(test);
  const oracle::Agreement pixels = oracle::compare(ours, truth);
  std::printf("%s: %s", test.feature.c_str(), report(pixels).c_str());
  EXPECT_TRUE(pixels.holds()) << report(pixels);
  for (const int tile : {5, test.size}) {
    const oracle::Agreement tiles = oracle::compare(ours, truth, tile);
    EXPECT_TRUE(tiles.holds()) << "tiles of " << tile << " pixels: " << report(tiles);
  }
  EXPECT_GE(pixels.random, pixels.tests / 6) << "too little noise to test, or a black picture";
}

// The other side of the scales: scenes that differ a little must not pass.
TEST_F(OracleComparison, SmallFaultsAreSeen) {
  const auto caught = [this](const AgreementCase& right, const auto& fault) {
    AgreementCase wrong = right;
    for (Material& material : wrong.scene.materials) fault(material);
    fault(wrong.scene.render);
    const oracle::Estimate ours = ourEstimate(wrong), truth = truthOf(right);
    return !oracle::compare(ours, truth).holds() || !oracle::compare(ours, truth, 5).holds() ||
           !oracle::compare(ours, truth, right.size).holds();
  };
  const auto ofMaterial = [](auto change) {
    return [change](auto& part) {
      if constexpr (std::is_same_v<std::decay_t<decltype(part)>, Material>) change(part);
    };
  };
  const auto ofSettings = [](auto change) {
    return [change](auto& part) {
      if constexpr (std::is_same_v<std::decay_t<decltype(part)>, RenderSettings>) change(part);
    };
  };
  const AgreementCase plastic = named(punctualCases(), "PlasticUnderAPointLight");
  EXPECT_FALSE(caught(plastic, [](auto&) {}));
  EXPECT_TRUE(caught(plastic, ofMaterial([](Material& m) { m.albedo *= 1.02f; })));
  EXPECT_TRUE(caught(plastic, ofSettings([](RenderSettings& r) { r.maxBounces = 1; })));
  const AgreementCase metal = named(punctualCases(), "MetalUnderAPointLight");
  EXPECT_TRUE(caught(metal, ofMaterial([](Material& m) { m.roughness *= 1.1f; })));
  const AgreementCase rough = named(materialCases(), "CompensatedMetal");
  EXPECT_TRUE(caught(rough, ofSettings([](RenderSettings& r) { r.energyCompensation = false; })));
  const AgreementCase glass = named(glassCases(), "GlassSphere");
  EXPECT_TRUE(caught(glass, ofMaterial([](Material& m) { m.ior *= 1.05f; })));
}

const auto featureOf = [](const auto& info) { return info.param.feature; };

INSTANTIATE_TEST_SUITE_P(Punctual, OracleAgreement, testing::ValuesIn(punctualCases()), featureOf);
INSTANTIATE_TEST_SUITE_P(Shapes, OracleAgreement, testing::ValuesIn(shapeCases()), featureOf);
INSTANTIATE_TEST_SUITE_P(Lights, OracleAgreement, testing::ValuesIn(lightCases()), featureOf);
INSTANTIATE_TEST_SUITE_P(Materials, OracleAgreement, testing::ValuesIn(materialCases()), featureOf);
INSTANTIATE_TEST_SUITE_P(Glass, OracleAgreement, testing::ValuesIn(glassCases()), featureOf);
INSTANTIATE_TEST_SUITE_P(Cameras, OracleAgreement, testing::ValuesIn(cameraCases()), featureOf);

}  // namespace
}  // namespace steradian
