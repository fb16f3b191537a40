// SPDX-License-Identifier: MIT
// Meshes against the oracle: flat and smooth, of glass, glowing.
#include "tests/oracle/agreement_fixture.hpp"

namespace steradian {
namespace {

TEST_F(OracleComparison, small_faults_of_meshes_are_seen) {
  const AgreementCase smooth = named(meshCases(), "SmoothMesh");
  const oracle::Estimate truth = truthOf(smooth);
  EXPECT_FALSE(caught(smooth, truth, [](Scene&) {}));
  EXPECT_TRUE(caught(smooth, truth, ofMeshes([](Mesh& mesh) { mesh.normals.clear(); })));
  const AgreementCase glowing = named(meshCases(), "GlowingMesh");
  EXPECT_TRUE(caught(glowing, ofMaterials([](Material& m) { m.emissionLuminance *= 1.05f; })));
}

INSTANTIATE_TEST_SUITE_P(Meshes, OracleAgreement, testing::ValuesIn(meshCases()), featureOf);

}  // namespace
}  // namespace steradian
