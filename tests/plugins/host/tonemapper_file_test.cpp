// SPDX-License-Identifier: MIT
// The annotations of a tonemapper's GLSL text.
#include "plugins/host/tonemapper_file.hpp"

#include "tests/plugins/fixture.hpp"

namespace steradian::plugins {
namespace {

const std::string kBody = "\nvec3 tonemap(vec3 c) { return c; }\n";

std::string faultIn(const std::string& text) try {
  parseTonemapper(text);
  return {};
} catch (const std::runtime_error& error) {
  return error.what();
}

TEST(TonemapperFile, ReadsIdNameAndEveryPartOfAParameter) {
  const Contribution c = parseTonemapper(
      "// @id org.example.tonemap.film\r\n// @name Film look\n// @version 2.1\n"
      "// @param float whitePoint 4 0.5 64 \"cd/m2\" \"Becomes white\"\n// @param int steps 3 1 9\n"
      "  // @param bool soft 1" +
      kBody);
  EXPECT_EQ(c.kind, Kind::tonemapper);
  EXPECT_EQ(c.id, "org.example.tonemap.film");
  EXPECT_EQ(c.name, "Film look");
  EXPECT_EQ(c.version, "2.1");
  ASSERT_EQ(c.parameters.size(), 3u);
  EXPECT_EQ(c.parameters[0].id, "whitePoint");
  EXPECT_EQ(c.parameters[0].name, "white point");
  EXPECT_EQ(c.parameters[0].unit, "cd/m2");
  EXPECT_EQ(c.parameters[0].help, "Becomes white");
  EXPECT_EQ(c.parameters[0].defaultValue, 4.0);
  EXPECT_EQ(c.parameters[0].minimum, 0.5);
  EXPECT_EQ(c.parameters[0].maximum, 64.0);
  EXPECT_EQ(c.parameters[1].type, Parameter::Type::integer);
  EXPECT_EQ(c.parameters[2].type, Parameter::Type::boolean);
  EXPECT_EQ(c.parameters[2].defaultValue, 1.0);
}

TEST(TonemapperFile, ReadsNegativeRangesAsInTheContractsExample) {
  const Contribution c = parseTonemapper("// @id a.b\n// @param float exposure 0 -8 8 \"stops\"" + kBody);
  EXPECT_EQ(c.parameters.at(0).minimum, -8.0);
  EXPECT_EQ(c.parameters.at(0).unit, "stops");
  EXPECT_EQ(c.name, "b");
}

TEST(TonemapperFile, NamesTheLineOfABadAnnotation) {
  EXPECT_CONTAINS(faultIn("// @id a.b\n// @param float x one 0 1" + kBody),
                  "line 2: expected a number, got \"one\"");
  EXPECT_CONTAINS(faultIn("// @id a.b\n// @param colour x" + kBody), "line 2: expected float, int or bool");
  EXPECT_CONTAINS(faultIn("// @id a.b\n// @param float x 0 0" + kBody), "lacks its maximum");
  EXPECT_CONTAINS(faultIn("// @id a.b\n// @param float x 2 0 1" + kBody), "minimum <= default <= maximum");
  EXPECT_CONTAINS(faultIn("// @id a.b\n// @param float x 0 0 inf" + kBody), "all finite");
  EXPECT_CONTAINS(faultIn("// @id a.b\n// @param float x;y 0 0 1" + kBody), "bad id 'x;y'");
  EXPECT_CONTAINS(faultIn("// @id a.b\n// @parm float x 0 0 1" + kBody), "unknown annotation @parm");
}

TEST(TonemapperFile, RefusesATextThatIsNoTonemapper) {
  EXPECT_CONTAINS(faultIn(kBody), "got id \"\"");
  EXPECT_CONTAINS(faultIn("// @id film" + kBody), "got id \"film\"");
  EXPECT_CONTAINS(faultIn("// @id a.b\nvoid main() {}"), "expected a function vec3 tonemap");
  const std::string twice = "// @param float x 0 0 1\n";
  EXPECT_CONTAINS(faultIn("// @id a.b\n" + twice + twice + kBody), "twice");
  std::string many;
  for (int i = 0; i < 9; ++i) many += "// @param float p" + std::to_string(i) + " 0 0 1\n";
  EXPECT_CONTAINS(faultIn("// @id a.b\n" + many + kBody), "at most 8");
}

}  // namespace
}  // namespace steradian::plugins
