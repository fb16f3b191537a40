// SPDX-License-Identifier: MIT
// What meshes carry against the oracle: textures, colours, tangents, opacity.
#include "tests/oracle/agreement_fixture.hpp"

namespace steradian {
namespace {

TEST_F(OracleComparison, small_faults_of_textures_are_seen) {
  const AgreementCase painted = named(textureCases(), "AlbedoTexture");
  const oracle::Estimate truth = truthOf(painted);
  EXPECT_FALSE(caught(painted, truth, [](Scene&) {}));
  const auto ofSlot = [](auto change) {
    return ofMaterials([change](Material& m) { change(m.albedoTexture); });
  };
  EXPECT_TRUE(caught(painted, truth, ofSlot([](TextureSlot& slot) { slot.nearest = true; })));
  EXPECT_TRUE(caught(painted, truth, ofSlot([](TextureSlot& slot) { slot.transformX.z = 0.02f; })));
  const AgreementCase bent = named(textureCases(), "NormalTexture");
  const auto flipBitangents = [](Mesh& mesh) {
    for (glm::vec4& tangent : mesh.tangents) tangent.w = -tangent.w;
  };
  EXPECT_TRUE(caught(bent, ofMeshes(flipBitangents)));
}

INSTANTIATE_TEST_SUITE_P(Textures, OracleAgreement, testing::ValuesIn(textureCases()), featureOf);

}  // namespace
}  // namespace steradian
