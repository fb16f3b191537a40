// SPDX-License-Identifier: MIT
// What a scene holds and takes on the device, in rows that only inform.
#include <set>

#include "editor/ui/inspector.hpp"
#include "editor/ui/numbers.hpp"

namespace steradian::ui {

namespace {

struct Counts {
  std::set<const Mesh*> meshes;
  std::set<const Texture*> textures;
  std::uint64_t triangles = 0, shownTriangles = 0;
};

Counts countsOf(const Scene& scene) {
  Counts counts;
  for (const Object& object : scene.objects) {
    const auto* geometry = std::get_if<Geometry>(&object.content);
    const auto* shape = geometry ? std::get_if<MeshShape>(&geometry->shape) : nullptr;
    if (!shape) continue;
    counts.shownTriangles += shape->mesh->triangles.size();
    if (counts.meshes.insert(shape->mesh.get()).second) counts.triangles += shape->mesh->triangles.size();
  }
  for (const Material& m : scene.materials)
    for (const auto* slot :
         {&m.albedoTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.emissionTexture})
      if (slot->texture) counts.textures.insert(slot->texture.get());
  return counts;
}

void textureRow(Fields& fields, const char* name, const TextureSlot& slot, const SceneCache& cache) {
  if (!slot.texture) return;
  const Texture& texture = *slot.texture;
  const std::string file = texture.file.empty() ? texture.name + ", embedded" : texture.file;
  if (!isUsable(slot)) return fields.note(name, "missing or damaged", file.c_str());
  fields.note(name,
              std::to_string(texture.pixels.width) + " x " + std::to_string(texture.pixels.height) + ", " +
                  memoryText(cache.textures.bytesOf(texture)),
              (file + "\nSize, and what it takes on the device with its smaller levels.").c_str());
}

}  // namespace

void textureRows(Fields& fields, const Material& material, const SceneCache& cache) {
  textureRow(fields, "Albedo image", material.albedoTexture, cache);
  textureRow(fields, "Metal, rough", material.metallicRoughnessTexture, cache);
  textureRow(fields, "Normal map", material.normalTexture, cache);
  textureRow(fields, "Emission image", material.emissionTexture, cache);
}

void inspectStatistics(Ui& ui, const InspectorInput& input) {
  if (!section(ui, "Statistics")) return;
  Fields fields(ui, "statistics");
  const Counts counts = countsOf(input.scene);
  fields.note("Objects", countText(input.scene.objects.size()));
  fields.note(
      "Triangles", countText(counts.shownTriangles),
      ("Of all objects; " + countText(counts.triangles) + " are stored, because objects share meshes.")
          .c_str());
  const auto stored = [](std::size_t count, std::size_t bytes) {
    return count ? countText(count) + ", " + memoryText(bytes) : std::string("none");
  };
  fields.note("Meshes", stored(counts.meshes.size(), input.stats.meshBytes),
              "Each is stored once on the device, whatever shows it.");
  fields.note("Textures", stored(counts.textures.size(), input.stats.textureBytes),
              "Each is stored once on the device, with its smaller levels.");
  fields.note("Sky image", input.stats.skyBytes ? memoryText(input.stats.skyBytes) : "none",
              "With the tables that samples of it are drawn from.");
}

}  // namespace steradian::ui
