// SPDX-License-Identifier: MIT
// Analytic shapes, single lights, materials and cameras against the oracle.
#include "tests/oracle/agreement_fixture.hpp"

namespace steradian {
namespace {

// The other side of the scales: scenes that differ a little must not pass.
TEST_F(OracleComparison, SmallFaultsAreSeen) {
  const AgreementCase plastic = named(punctualCases(), "PlasticUnderAPointLight");
  EXPECT_FALSE(caught(plastic, [](Scene&) {}));
  EXPECT_TRUE(caught(plastic, ofMaterials([](Material& m) { m.albedo *= 1.02f; })));
  EXPECT_TRUE(caught(plastic, [](Scene& s) { s.render.maxBounces = 1; }));
  const AgreementCase metal = named(punctualCases(), "MetalUnderAPointLight");
  EXPECT_TRUE(caught(metal, ofMaterials([](Material& m) { m.roughness *= 1.1f; })));
  const AgreementCase rough = named(materialCases(), "CompensatedMetal");
  EXPECT_TRUE(caught(rough, [](Scene& s) { s.render.energyCompensation = false; }));
  const AgreementCase glass = named(glassCases(), "GlassSphere");
  EXPECT_TRUE(caught(glass, ofMaterials([](Material& m) { m.ior *= 1.05f; })));
}

INSTANTIATE_TEST_SUITE_P(Punctual, OracleAgreement, testing::ValuesIn(punctualCases()), featureOf);
INSTANTIATE_TEST_SUITE_P(Shapes, OracleAgreement, testing::ValuesIn(shapeCases()), featureOf);
INSTANTIATE_TEST_SUITE_P(Lights, OracleAgreement, testing::ValuesIn(lightCases()), featureOf);
INSTANTIATE_TEST_SUITE_P(Materials, OracleAgreement, testing::ValuesIn(materialCases()), featureOf);
INSTANTIATE_TEST_SUITE_P(Glass, OracleAgreement, testing::ValuesIn(glassCases()), featureOf);
INSTANTIATE_TEST_SUITE_P(Cameras, OracleAgreement, testing::ValuesIn(cameraCases()), featureOf);

}  // namespace
}  // namespace steradian
