// SPDX-License-Identifier: MIT
#include "renderer/scene_size.hpp"

#include <algorithm>

#include "renderer/gpu/device.hpp"
#include "renderer/scene/error.hpp"

namespace steradian {
namespace {

constexpr std::uint64_t rowBytes = sizeof(glm::vec4), wordBytes = sizeof(std::uint32_t);

std::uint64_t meshRows(const GpuScene& scene) {
  std::uint64_t rows = 0;
  for (const auto& mesh : scene.meshes) rows += mesh->nodes.size() + mesh->triangles.size();
  for (const auto& vertices : scene.vertices) rows += vertices->rows.size();
  return rows;
}

std::uint64_t textureWords(const GpuScene& scene) {
  std::uint64_t words = texelTables(scene.textures).size();
  for (const auto& texture : scene.textures) words += texture->words.size();
  return words;
}

std::uint64_t skyRows(const Image& image) {
  return std::uint64_t(image.width) * std::uint64_t(image.height) + std::uint64_t(image.height) + 1;
}

std::string mebibytes(std::uint64_t bytes) {
  return std::to_string((bytes + (1u << 20) - 1) >> 20) + " MiB";
}

std::string largestMesh(const Scene& scene) {
  const Object* largest = nullptr;
  std::size_t most = 0;
  for (const Object& object : scene.objects) {
    const auto* geometry = std::get_if<Geometry>(&object.content);
    const auto* shape = geometry ? std::get_if<MeshShape>(&geometry->shape) : nullptr;
    if (!shape || (largest && shape->mesh->triangles.size() <= most)) continue;
    largest = &object;
    most = shape->mesh->triangles.size();
  }
  if (!largest) return {};
  return "; the largest is '" + largest->name + "' with " + std::to_string(most) + " triangles";
}

std::string largestTexture(const Scene& scene) {
  const Texture* largest = nullptr;
  const auto texels = [](const Texture& t) { return std::int64_t(t.pixels.width) * t.pixels.height; };
  for (const Material& m : scene.materials)
    for (const auto* slot :
         {&m.albedoTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.emissionTexture})
      if (isUsable(*slot) && (!largest || texels(*slot->texture) > texels(*largest)))
        largest = slot->texture.get();
  if (!largest) return {};
  return "; the largest is '" + largest->name + "' with " + std::to_string(largest->pixels.width) + " x " +
         std::to_string(largest->pixels.height);
}

}  // namespace

std::string tooLarge(const Scene& scene, const GpuScene& packed, std::uint64_t mostElements) {
  const auto needs = [](const char* what, std::uint64_t needed, std::uint64_t allowed) {
    return "the " + std::string(what) + " needs " + mebibytes(needed) + ", the device allows " +
           std::to_string(allowed >> 20) + " MiB in one buffer";
  };
  if (const std::uint64_t rows = meshRows(packed); rows > mostElements)
    return needs("geometry of the scene's meshes", rows * rowBytes, mostElements * rowBytes) +
           largestMesh(scene) + ". Leave out or simplify meshes.";
  if (const std::uint64_t words = textureWords(packed); words > mostElements)
    return needs("image data of the scene's textures", words * wordBytes, mostElements * wordBytes) +
           largestTexture(scene) + ". Use smaller images.";
  if (!packed.environment || skyRows(*packed.environment) <= mostElements) return {};
  return needs("sky image", skyRows(*packed.environment) * rowBytes, mostElements * rowBytes) + "; it has " +
         std::to_string(packed.environment->width) + " x " + std::to_string(packed.environment->height) +
         ". Use a smaller image.";
}

void checkSize(const gpu::Device& device, const Scene& scene, const GpuScene& packed) {
  const std::string line = tooLarge(scene, packed, device.limits().maxTexelBufferElements);
  if (!line.empty()) throw Error(ExitCode::badInput, device.description().name + ": " + line);
}

}  // namespace steradian
