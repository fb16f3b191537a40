// SPDX-License-Identifier: MIT
// Every damaged project costs one clear line that names file, place and what was expected.
#include <fcntl.h>
#include <sys/stat.h>

#include "plugins/host/utf8.hpp"
#include "tests/plugins/fixture.hpp"

namespace steradian::plugins {
namespace {

const std::string kSample = R"({
  "steradian": 1,
  "materials": [{"id": 1, "name": "red", "albedo": [0.8, 0.1, 0.1]}],
  "objects": [
    {"id": 2, "name": "Camera", "translation": [0, 1, 5], "camera": {}},
    {"id": 3, "name": "Lamp", "pointLight": {"intensity": 60}},
    {"id": 4, "name": "Ball", "sphere": {"radius": 1}, "material": 1}
  ],
  "animation": {"channels": [{"target": 3, "property": "lightIntensity", "keys": [{"time": 0, "value": [1]}]}]}
})";

class DamagedProject : public FolderTest {
 protected:
  /// What opening this text says; always an Error(badInput) that begins with the file's name.
  std::string says(const std::string& text) {
    const fs::path file = folder / "room.srad";
    writeText(file, text);
    const auto [message, code] = faultOf([&] { stockPlugins().importScene(file); });
    EXPECT_EQ(code, ExitCode::badInput) << message << "\n" << text.substr(0, 200);
    EXPECT_EQ(message.rfind(file.string() + ": ", 0), 0u) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_TRUE(isUtf8(message)) << message;
    return message;
  }
  std::string object(const std::string& fields) {
    return R"({"steradian": 1, "objects": [{"id": 1}, {"id": 2}, {"id": 3}, {"id": 4, )" + fields + "}]}";
  }
};

TEST_F(DamagedProject, TheUndamagedSampleOpens) {
  writeText(folder / "room.srad", kSample);
  EXPECT_EQ(stockPlugins().importScene(folder / "room.srad").scene.objects.size(), 3u);
}

TEST_F(DamagedProject, CutAtEvery64thSaysWhere) {
  for (std::size_t i = 0; i < 64; ++i)
    EXPECT_CONTAINS(says(kSample.substr(0, kSample.size() * i / 64)), "line ");
}

TEST_F(DamagedProject, ZeroBytes) {
  EXPECT_CONTAINS(says(""), "line 1, column 1");
}

TEST_F(DamagedProject, SyntaxErrorsHaveLineAndColumn) {
  EXPECT_CONTAINS(says("{\n  \"steradian\": 1,\n  \"name\" 5\n}"), "line 3, column 10: ");
}

TEST_F(DamagedProject, WrongMagicNumber) {
  EXPECT_CONTAINS(says("\x7f"
                       "ELF"),
                  "line 1, column 1");
  EXPECT_CONTAINS(says("{}"), "is this a Steradian project?");
  EXPECT_CONTAINS(says("[]"), "expected an object {...}, got []");
}

TEST_F(DamagedProject, WrongTypesNameTheJsonPath) {
  EXPECT_CONTAINS(says(object(R"("sphere": {"radius": "big"})")),
                  "room.srad: /objects/3/sphere/radius: expected a number > 0, got \"big\"");
  EXPECT_CONTAINS(says(object(R"("name": 5)")), "/objects/3/name: expected a text in quotes, got 5");
  EXPECT_CONTAINS(says(object(R"("visible": 1)")), "/objects/3/visible: expected true or false, got 1");
  EXPECT_CONTAINS(says(object(R"("translation": [1, 2])")),
                  "/objects/3/translation: expected an array of 3 numbers");
  EXPECT_CONTAINS(says(object(R"("translation": [1, null, 2])")),
                  "/objects/3/translation/1: expected a number, got null");
  EXPECT_CONTAINS(says(object(R"("sphere": 1)")), "/objects/3/sphere: expected an object");
  EXPECT_CONTAINS(says(object(R"("parent": -1)")), "/objects/3/parent: expected a whole number");
  EXPECT_CONTAINS(says(object(R"("parent": 1.5)")), "/objects/3/parent: expected a whole number");
  EXPECT_CONTAINS(says(R"({"steradian": 1, "objects": {}})"), "/objects: expected an array");
  EXPECT_CONTAINS(says(R"({"steradian": 1, "objects": [7]})"), "/objects/0: expected an object");
  EXPECT_CONTAINS(says(R"({"steradian": 1, "render": {"filter": "sinc"}})"),
                  "/render/filter: expected one of \"box\", \"blackmanHarris\", got \"sinc\"");
  EXPECT_CONTAINS(says(R"({"steradian": "1"})"), "/steradian: expected the format version");
}

TEST_F(DamagedProject, ValuesOutOfRange) {
  EXPECT_CONTAINS(says(object(R"("sphere": {"radius": 0})")),
                  "/objects/3/sphere/radius: expected a number > 0, got 0");
  EXPECT_CONTAINS(says(object(R"("sphere": {"radius": -1})")), "expected a number > 0, got -1");
  EXPECT_CONTAINS(says(object(R"("sphere": {"radius": 1e30})")), "shape.radius");
  EXPECT_CONTAINS(says(object(R"("scale": [1, 0, 1])")), "scale: is 0 along y");
  EXPECT_CONTAINS(says(object(R"("rotation": [0, 0, 0, 2])")), "expected a unit quaternion");
  EXPECT_CONTAINS(says(object(R"("pointLight": {"intensity": 1e39})")), "fits 32 bits");
  EXPECT_CONTAINS(says(R"({"steradian": 1, "render": {"maxBounces": 65}})"), "from 0 to 64, got 65");
  EXPECT_CONTAINS(says(R"({"steradian": 1, "materials": [{"id": 1, "albedo": [2, 0, 0]}]})"),
                  "/materials/0/albedo/0");
}

TEST_F(DamagedProject, NotANumberAndInfinity) {
  EXPECT_CONTAINS(says(object(R"("translation": [NaN, 0, 0])")), "line 1, column ");
  EXPECT_CONTAINS(says(object(R"("translation": [1e999, 0, 0])")), "number overflow parsing '1e999'");
}

TEST_F(DamagedProject, DeepNesting) {
  for (std::size_t depth : {65u, 20'000u, 1'000'000u})
    EXPECT_CONTAINS(says(std::string(depth, '[')), "nested deeper than 64");
  const std::string fits = R"({"steradian": 1, "x": )" + std::string(63, '[') + std::string(63, ']') + "}";
  writeText(folder / "room.srad", fits);
  EXPECT_FALSE(stockPlugins().importScene(folder / "room.srad").scene.extras.empty());
}

TEST_F(DamagedProject, ANewerVersionIsRefusedPolitely) {
  EXPECT_CONTAINS(says(R"({"steradian": 3, "objects": "whatever"})"),
                  "was written by a newer Steradian (version 3; this one reads up to 2)");
}

TEST_F(DamagedProject, AByteOrderMarkIsAccepted) {
  writeText(folder / "room.srad", "\xef\xbb\xbf" + kSample);
  EXPECT_EQ(stockPlugins().importScene(folder / "room.srad").scene.objects.size(), 3u);
}

TEST_F(DamagedProject, InvalidUtf8) {
  EXPECT_CONTAINS(says(object("\"name\": \"\xff\"")), "invalid string: ill-formed UTF-8 byte");
  EXPECT_CONTAINS(says("{\"steradian\": 1, \"\xc3\": 1}"), "invalid string");
}

TEST_F(DamagedProject, OfDuplicateKeysTheLastCounts) {
  writeText(folder / "room.srad", R"({"steradian": 9, "steradian": 1, "name": "a", "name": "b"})");
  EXPECT_EQ(stockPlugins().importScene(folder / "room.srad").scene.name, "b");
}

TEST_F(DamagedProject, CyclesDuplicateIdsAndMissingTargets) {
  EXPECT_CONTAINS(says(object(R"("parent": 4)")), "cycle");
  EXPECT_CONTAINS(says(R"({"steradian": 1, "objects": [{"id": 1, "parent": 2}, {"id": 2, "parent": 1}]})"),
                  "cycle");
  EXPECT_CONTAINS(says(object(R"("parent": 77)")), "there is no such object");
  EXPECT_CONTAINS(says(object(R"("sphere": {}, "material": 77)")), "there is no such material");
  EXPECT_CONTAINS(says(R"({"steradian": 1, "objects": [{"id": 1}, {"id": 1}]})"), "in use already");
  EXPECT_CONTAINS(says(R"({"steradian": 1, "materials": [{"id": 1}], "objects": [{"id": 1}]})"),
                  "in use already");
  EXPECT_CONTAINS(says(R"({"steradian": 1, "activeCamera": 5})"), "activeCamera");
  EXPECT_CONTAINS(says(R"({"steradian": 1, "objects": [{"id": 4294967295}]})"), "id");
}

TEST_F(DamagedProject, TwoContentsOnOneObject) {
  EXPECT_CONTAINS(says(object(R"("sphere": {}, "camera": {})")), "got both \"sphere\" and \"camera\"");
}

TEST_F(DamagedProject, ADeepChainOfParentsIsReadWithoutRecursion) {
  std::string text = R"({"steradian": 1, "objects": [{"id": 1})";
  for (int i = 2; i <= 100'000; ++i)
    text += ", {\"id\": " + std::to_string(i) + ", \"parent\": " + std::to_string(i - 1) + "}";
  writeText(folder / "room.srad", text + "]}");
  EXPECT_EQ(stockPlugins().importScene(folder / "room.srad").scene.objects.size(), 100'000u);
}

TEST_F(DamagedProject, AHugeFileIsRefusedBeforeItIsRead) {
  writeText(folder / "room.srad", "{}");
  fs::resize_file(folder / "room.srad", 3ull << 30);
  EXPECT_CONTAINS(faultOf([&] { stockPlugins().importScene(folder / "room.srad"); }).first,
                  "up to 256.0 MiB");
}

TEST_F(DamagedProject, PipesDevicesAndMissingFilesAreRefusedAtOnce) {
  ASSERT_EQ(mkfifo((folder / "pipe.srad").c_str(), 0600), 0);
  EXPECT_CONTAINS(faultOf([&] { stockPlugins().importScene(folder / "pipe.srad"); }).first, "regular file");
  fs::create_symlink("/dev/zero", folder / "zero.srad");
  EXPECT_CONTAINS(faultOf([&] { stockPlugins().importScene(folder / "zero.srad"); }).first, "regular file");
  const auto [message, code] = faultOf([&] { stockPlugins().importScene(folder / "none.srad"); });
  EXPECT_EQ(code, ExitCode::badInput);
  EXPECT_CONTAINS(message, "No such file");
}

TEST_F(DamagedProject, TheWorkingFolderMayBeGone) {
  const fs::path before = fs::current_path();
  fs::create_directory(folder / "gone");
  fs::current_path(folder / "gone");
  fs::remove(folder / "gone");
  const auto [message, code] = faultOf([&] { stockPlugins().exportScene(Scene{}, "a.srad"); });
  EXPECT_EQ(code, ExitCode::io) << message;
  EXPECT_EQ(faultOf([&] { stockPlugins().importScene("a.srad"); }).second, ExitCode::badInput);
  stockPlugins().exportScene(Scene{.name = "kept"}, folder / "a.srad");
  EXPECT_EQ(stockPlugins().importScene(folder / "a.srad").scene.name, "kept");
  fs::current_path(before);
}

TEST_F(DamagedProject, AwkwardNamesWork) {
  for (const char* name : {"mit Leerzeichen.srad", "日本語.srad", "new\nline.srad", "-o.srad", "a.SRAD"}) {
    const fs::path file = folder / name;
    stockPlugins().exportScene(Scene{.name = name}, file);
    EXPECT_EQ(stockPlugins().importScene(file).scene.name, name);
  }
  const fs::path tooLong = folder / (std::string(300, 'x') + ".srad");
  EXPECT_EQ(faultOf([&] { stockPlugins().exportScene(Scene{}, tooLong); }).second, ExitCode::io);
  stockPlugins().exportScene(Scene{}, folder / (std::string(250, 'x') + ".srad"));
}

}  // namespace
}  // namespace steradian::plugins
