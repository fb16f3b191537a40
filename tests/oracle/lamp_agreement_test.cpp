// SPDX-License-Identifier: MIT
// Crowds of lamps and colour temperatures against the oracle.
#include "tests/oracle/agreement_fixture.hpp"

namespace steradian {
namespace {

TEST_F(OracleComparison, small_faults_of_lamps_are_seen) {
  const AgreementCase many = named(lampCases(), "FortyPointLights");
  EXPECT_GT(std::count_if(many.scene.objects.begin(), many.scene.objects.end(),
                          [](const Object& o) { return std::holds_alternative<Light>(o.content); }),
            many.scene.render.lightSamples)
      << "else all are sampled";
  EXPECT_TRUE(caught(many, [](Scene& scene) {
    Object& first = scene.objects[2];
    std::get<Light>(first.content).intensity *= 1.5f;
  }));
  const AgreementCase warm = named(lampCases(), "PointLightOf6500Kelvin");
  EXPECT_TRUE(caught(warm, ofLights([](Light& light) { light.temperature = 6200.0f; })));
}

INSTANTIATE_TEST_SUITE_P(Lamps, OracleAgreement, testing::ValuesIn(lampCases()), featureOf);

}  // namespace
}  // namespace steradian
