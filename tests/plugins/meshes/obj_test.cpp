// SPDX-License-Identifier: MIT
// OBJ and MTL: every statement that means something to a renderer, and what is said about the rest.
#include <clocale>
#include <cmath>

#include "tests/plugins/meshes/mesh_fixture.hpp"

namespace steradian::plugins {
namespace {

class ObjFile : public MeshFileTest {
 protected:
  ObjFile() : MeshFileTest("a.obj") {}
};

TEST_F(ObjFile, ATriangleComesWithTheIndicesOfTheFile) {
  const Scene scene = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Mesh& mesh = meshOf(scene, 0);
  EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.triangles, (std::vector<glm::uvec3>{{0, 1, 2}}));
  EXPECT_TRUE(mesh.normals.empty());
  EXPECT_TRUE(mesh.uv0.empty());
}

TEST_F(ObjFile, NegativeIndicesCountBackFromWhereTheyStand) {
  const Scene scene = read("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -4 -1 -2\n");
  EXPECT_EQ(corners(scene, 0),
            (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {5, 5, 5}, {0, 1, 0}}));
}

TEST_F(ObjFile, TextureCoordinatesAndNormalsSplitVertices) {
  const Scene scene = read(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0.25 1\nvt 1 1\nvn 0 0 2\nvn 0 0 -1\n"
      "f 1/1/1 2/2/1 3/3/1\nf 2/2/1 4/4/1 3/3/2\n");
  const Mesh& mesh = meshOf(scene, 0);
  EXPECT_EQ(mesh.positions.size(), 5u) << "only the third corner has two normals";
  ASSERT_EQ(mesh.uv0.size(), 5u);
  EXPECT_EQ(mesh.uv0[mesh.triangles[0][2]], glm::vec2(0.25f, 0)) << "v runs downwards here";
  EXPECT_EQ(mesh.uv0[mesh.triangles[0][0]], glm::vec2(0, 1));
  EXPECT_EQ(mesh.normals[mesh.triangles[0][2]], glm::vec3(0, 0, 1)) << "made unit length";
  EXPECT_EQ(mesh.normals[mesh.triangles[1][2]], glm::vec3(0, 0, -1));
}

TEST_F(ObjFile, CornersWithoutANormalGetTheFacesWhereOthersHaveOne) {
  const Scene scene = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 0\nvn 0 0 0\nf 1//1 2 3//2\n");
  const Mesh& mesh = meshOf(scene, 0);
  EXPECT_EQ(mesh.normals, (std::vector<glm::vec3>{{1, 0, 0}, {0, 0, 1}, {0, 0, 1}}));
}

/// The area of a mesh and whether all its triangles turn like +Z.
std::pair<double, bool> areaOf(const Mesh& mesh) {
  double area = 0;
  bool turns = true;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
    const double twice = glm::cross(b - a, c - a).z;
    area += twice / 2;
    turns = turns && twice >= 0;
  }
  return {area, turns};
}

TEST_F(ObjFile, PolygonsAreCutWithTheirAreaAndWinding) {
  const std::string convex = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 3 0\nv 0 2 0\nf 1 2 3 4 5\n";
  const std::string concave = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n";
  const std::string spiral =
      "v 0 0 0\nv 5 0 0\nv 5 5 0\nv 0 5 0\nv 0 2 0\nv 3 2 0\nv 3 3 0\nv 1 3 0\nv 1 4 0\nv 4 4 0\nv 4 1 0\nv "
      "0 1 0\nf 1 2 3 4 5 6 7 8 9 10 11 12\n";
  EXPECT_EQ(areaOf(meshOf(read(convex), 0)), (std::pair{5.0, true}));
  EXPECT_EQ(areaOf(meshOf(read(concave), 0)), (std::pair{10.0, true}));
  EXPECT_EQ(areaOf(meshOf(read(spiral), 0)).second, true);
  EXPECT_NEAR(areaOf(meshOf(read(spiral), 0)).first, 17, 1e-9);
}

TEST_F(ObjFile, EachMaterialOfAGroupIsOneObject) {
  writeText(folder / "a.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
  const Scene scene = read(
      "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\no ball\nf 1 2 3\nusemtl blue\nf 3 2 1\n"
      "usemtl red\nf 1 3 2\n");
  ASSERT_EQ(scene.objects.size(), 3u);
  EXPECT_EQ(scene.objects[0].name, "red");
  EXPECT_EQ(scene.objects[1].name, "ball");
  EXPECT_EQ(meshOf(scene, 1).triangles.size(), 2u) << "both runs of red";
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.materials[0].name, "red");
  EXPECT_EQ(std::get<Geometry>(scene.objects[2].content).material, scene.materials[1].id);
  EXPECT_EQ(scene.materials[1].albedo, glm::vec3(0, 0, 1));
}

TEST_F(ObjFile, MaterialTermsAreTurnedIntoMetallicAndRoughness) {
  writeText(folder / "a.mtl",
            "newmtl plastic\nKd 0.5 0.25 0.125\nKs 0.25 0.25 0.25\nNs 6\nKe 2 1 0\nd 0.5\nNi 1.33\n"
            "newmtl gold\nKd 0 0 0\nKs 1 0.8 0.3\nNs 1e9\n"
            "newmtl pbr\nKd 1 1 1\nPr 0.25\nPm 0.75\nPc 1\nPcr 0.5\nTr 0.25\n");
  const Scene scene = read(
      "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl plastic\nf 1 2 3\nusemtl gold\nf 1 2 3\nusemtl pbr\nf "
      "1 2 3\n");
  const Material &plastic = scene.materials[0], &gold = scene.materials[1], &pbr = scene.materials[2];
  EXPECT_EQ(plastic.albedo, glm::vec3(0.5f, 0.25f, 0.125f));
  EXPECT_FLOAT_EQ(plastic.roughness, std::sqrt(0.5f));  // alpha^2 = 2 / 8
  EXPECT_EQ(plastic.specular, 0.5f);
  EXPECT_EQ(plastic.emissionLuminance, 2);
  EXPECT_EQ(plastic.emissionColor, glm::vec3(1, 0.5f, 0));
  EXPECT_EQ(plastic.opacity, 0.5f);
  EXPECT_EQ(plastic.alphaMode, AlphaMode::blend);
  EXPECT_EQ(plastic.ior, 1.33f);
  EXPECT_EQ(gold.metallic, 1);
  EXPECT_EQ(gold.albedo, glm::vec3(1, 0.8f, 0.3f));
  EXPECT_LT(gold.roughness, 0.01f);
  EXPECT_EQ(pbr.roughness, 0.25f);
  EXPECT_EQ(pbr.metallic, 0.75f);
  EXPECT_EQ(pbr.clearcoat, 1);
  EXPECT_EQ(pbr.clearcoatRoughness, 0.5f);
  EXPECT_EQ(pbr.opacity, 0.75f);
  EXPECT_CONTAINS(report(), "material 'plastic': approximated");
  EXPECT_EQ(report().find("'pbr'"), std::string::npos);
}

TEST_F(ObjFile, TexturesAreTakenInWithTheirOptions) {
  fs::create_directory(folder / "my maps");
  writeText(folder / "my maps/wood.png", "\x89PNG bytes");
  writeText(folder / "brick_normal.png", "normal");
  writeText(folder / "rough.png", "rough");
  writeText(folder / "a.mtl",
            "newmtl m\nKd 0 0 0\nmap_Kd -s 2 3 -o 0.5 0.25 -clamp on my maps\\wood.png\n"
            "map_Bump -bm 0.5 brick_normal.png\nmap_Pr rough.png\nbump height.png\nmap_Ke lost.png\n");
  const Scene scene = read("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
  const Material& m = scene.materials[0];
  ASSERT_TRUE(m.albedoTexture.texture);
  const std::string wood = "\x89PNG bytes";
  EXPECT_EQ(m.albedoTexture.texture->encoded, (std::vector<std::uint8_t>(wood.begin(), wood.end())));
  EXPECT_EQ(m.albedoTexture.texture->name, "wood.png");
  EXPECT_EQ(m.albedo, glm::vec3(1)) << "black times a texture was not meant";
  EXPECT_EQ(m.albedoTexture.wrapU, Wrap::clamp);
  EXPECT_EQ(m.albedoTexture.transformX, glm::vec3(2, 0, 0.5f));
  EXPECT_EQ(m.albedoTexture.transformY, glm::vec3(0, 3, -2.25f));
  EXPECT_TRUE(m.normalTexture.texture);
  EXPECT_EQ(m.normalScale, 0.5f);
  EXPECT_TRUE(m.metallicRoughnessTexture.texture);
  EXPECT_EQ(m.roughness, 1);
  EXPECT_FALSE(m.emissionTexture.texture);
  EXPECT_CONTAINS(report(), "lost.png: left out: ");
  EXPECT_CONTAINS(report(), "height.png: left out: is not rendered");
}

TEST_F(ObjFile, VertexColoursAreLinear) {
  const Scene scene = read("v 0 0 0 1 0 0.5\nv 1 0 0 1 1 1\nv 0 1 0\nf 1 2 3\n");
  const auto& colors = meshOf(scene, 0).colors;
  ASSERT_EQ(colors.size(), 3u);
  EXPECT_NEAR(colors[0].b, 0.2140, 1e-4);
  EXPECT_EQ(colors[2], glm::vec4(1));
}

TEST_F(ObjFile, NumbersAreReadInAnyFormAndLocale) {
  const char* const was = std::setlocale(LC_ALL, nullptr);
  const std::string before = was ? was : "C";
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  const Scene scene = read("v +1.5 -.5 1e-3\r\nv\t1E2   2.  0\r\nv 1e-400 0 \\\n 1\r\nf 1 2 3 # a face\r\n");
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(meshOf(scene, 0).positions,
            (std::vector<glm::vec3>{{1.5f, -0.5f, 1e-3f}, {100, 2, 0}, {0, 0, 1}}));
}

TEST_F(ObjFile, ForeignNamesArriveAsUtf8) {
  const Scene scene = read(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\no K\xfc"
      "che\nf 1 2 3\no 日本語 🙂\nf 1 2 3\n");
  EXPECT_EQ(scene.objects[0].name, "Küche");
  EXPECT_EQ(scene.objects[1].name, "日本語 🙂");
}

TEST_F(ObjFile, WhatIsNotRenderedIsReported) {
  read(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nl 2 3\np 1\nf 1 2\nf 1 2 3\ns 1\nusemtl lost\nmtllib lost.mtl\nf 1 "
      "2 3\n");
  for (const char* line :
       {"l: left out: 2", "p: left out: 1", "faces of fewer than 3 corners: left out: 1",
        "material 'lost': left out", "lost.mtl: left out: ", "smoothing groups: approximated"})
    EXPECT_CONTAINS(report(), line);
}

TEST_F(ObjFile, fault9_EveryBadIndexAndNumberNamesItsLine) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_CONTAINS(says(three + "f 1 2 4\n"), "a.obj: line 4: names v 4; the file has 3");
  EXPECT_CONTAINS(says(three + "\n# x\nf 1 2 3/1\n"), "line 6: names vt 1; the file has 0");
  EXPECT_CONTAINS(says(three + "f 1 2 3//7\n"), "line 4: names vn 7; the file has 0");
  for (const char* bad : {"0", "-4", "x", "1.5", "99999999999", "99999999999999999999", "1/x", "2/-1", "/1"})
    EXPECT_CONTAINS(says(three + "f 1 2 " + bad + "\n"), "line 4: expected an index") << bad;
  for (const char* bad :
       {"v 1 2", "v 1 2 x", "v 1 2 nan", "v 1 2 inf", "v 1 2 1e13", "v 1 2 0,5", "vn 1 2", "vt"})
    EXPECT_CONTAINS(says(three + bad + "\nf 1 2 3\n"), "line 4: expected a number") << bad;
}

TEST_F(ObjFile, fault1_WhatHoldsNoFacesSaysSo) {
  for (const char* text : {"", "v 0 0 0\n",
                           "\x7f"
                           "ELF",
                           "v 0 0 0\np 1\n"})
    EXPECT_CONTAINS(says(text), "has no faces");
  EXPECT_CONTAINS(says(std::string("v 0 0 0\0\n", 9)), "line 1: holds a zero byte");
  EXPECT_CONTAINS(says("\xfe\xff"), "UTF-16");
}

TEST_F(ObjFile, fault13_LibrariesAndTexturesOutsideOfTheFolderAreNotRead) {
  writeText(folder / "secret.mtl", "newmtl m\nKd 1 0 0\n");
  fs::create_directory(folder / "in");
  writeText(folder / "in/b.mtl", "newmtl m\nmap_Kd ../secret.mtl\nmap_Ke /etc/passwd\n");
  writeText(folder / "in/a.obj",
            "mtllib ../secret.mtl\nmtllib b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
  const ImportResult result = stockPlugins().importScene(folder / "in/a.obj");
  EXPECT_FALSE(result.scene.materials.at(0).albedoTexture.texture);
  int refused = 0;
  for (const auto& line : result.report.notKept)
    refused += line.why.find("does not lie inside") != std::string::npos;
  EXPECT_EQ(refused, 3);
}

TEST_F(ObjFile, AManyCorneredPolygonAndAManyNormalledVertexTakeNoAge) {
  std::string text = "v 0 0 0\nv 1 0 0\n";
  for (int i = 0; i < 20000; ++i)
    text += "v " + std::to_string(i % 7) + " " + std::to_string(i % 11) + " 0\n";
  for (int i = 0; i < 20000; ++i) text += "vn 0 " + std::to_string(i) + " 1\n";
  text += "f";
  for (int i = 1; i <= 20000; ++i) text += " " + std::to_string(i);
  for (int i = 1; i <= 20000; ++i) text += "\nf 1//" + std::to_string(i) + " 2//1 3//1";
  const Scene scene = read(text + "\n");
  EXPECT_EQ(meshOf(scene, 0).triangles.size(), 19998u + 20000u);
}

}  // namespace
}  // namespace steradian::plugins
