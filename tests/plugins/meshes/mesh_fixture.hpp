// SPDX-License-Identifier: MIT
// Reads a mesh file from a text, and what was said about it.
#pragma once
#include "tests/plugins/fixture.hpp"

namespace steradian::plugins {

class MeshFileTest : public FolderTest {
 protected:
  explicit MeshFileTest(std::string name) : name_(std::move(name)) {}

  Scene read(const std::string& bytes) {
    writeText(folder / name_, bytes);
    ImportResult result = stockPlugins().importScene(folder / name_);
    report_ = std::move(result.report);
    return std::move(result.scene);
  }
  /// The one line of the refusal; always an Error(badInput) that begins with the file's name.
  std::string says(const std::string& bytes) {
    const fs::path file = folder / name_;
    writeText(file, bytes);
    const auto [message, code] = faultOf([&] { stockPlugins().importScene(file); });
    EXPECT_EQ(code, ExitCode::badInput) << message << "\n" << bytes.substr(0, 200);
    EXPECT_EQ(message.rfind(file.string() + ": ", 0), 0u) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
  }
  std::string report() const {
    std::string text;
    for (const auto& line : report_.notKept) text += line.what + ": " + line.why + "\n";
    return text;
  }
  static const Mesh& meshOf(const Scene& scene, std::size_t object) {
    return *std::get<MeshShape>(std::get<Geometry>(scene.objects.at(object).content).shape).mesh;
  }
  /// The position of every corner of every triangle.
  static std::vector<glm::vec3> corners(const Scene& scene, std::size_t object) {
    std::vector<glm::vec3> out;
    for (const glm::uvec3& t : meshOf(scene, object).triangles)
      for (int i = 0; i < 3; ++i) out.push_back(meshOf(scene, object).positions.at(t[i]));
    return out;
  }

 private:
  std::string name_;
  ImportReport report_;
};

}  // namespace steradian::plugins
