// SPDX-License-Identifier: MIT
// glTF 2.0 textures: image bytes as they are, samplers and KHR_texture_transform as slots.
#include <cmath>

#include "materials.hpp"

namespace gltf {

namespace {

bool isImage(std::string_view bytes) {
  return bytes.substr(0, 4) == "\x89PNG" || bytes.substr(0, 3) == "\xff\xd8\xff";
}

std::uint32_t wrapOf(int mode) {
  return mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? 1
         : mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? 2
                                                         : 0;
}

/// KHR_texture_transform: offset + rotation * scale, rotated counter-clockwise as seen on the image (v points
/// down), as the Khronos sample renderer does.
void readTransform(const tinygltf::Value& transform, sdk::TextureSlotRecord& out) {
  const auto pair = [&](const char* key, int i, double otherwise) {
    return transform.Has(key) && transform.Get(key).ArrayLen() == 2
               ? transform.Get(key).Get(i).GetNumberAsDouble()
               : otherwise;
  };
  const double angle = transform.Has("rotation") ? transform.Get("rotation").GetNumberAsDouble() : 0;
  const double c = std::cos(angle), s = std::sin(angle);
  const double x = pair("scale", 0, 1), y = pair("scale", 1, 1);
  const double matrix[6] = {c * x, s * y, pair("offset", 0, 0), -s * x, c * y, pair("offset", 1, 0)};
  for (int i = 0; i < 6; ++i) out.transform[i] = float(matrix[i]);
  if (transform.Has("texCoord")) out.uvSet = std::uint32_t(transform.Get("texCoord").GetNumberAsInt());
}

/// The matrix itself, where our exporter kept one that offset, rotation and scale cannot say.
void readOwnTransform(const tinygltf::Value& extras, sdk::TextureSlotRecord& out) {
  if (!extras.Has("steradian") || !extras.Get("steradian").Has("transform")) return;
  const tinygltf::Value& matrix = extras.Get("steradian").Get("transform");
  if (matrix.ArrayLen() != 6) return;
  for (int i = 0; i < 6; ++i)
    if (!matrix.Get(i).IsNumber() || !(std::abs(matrix.Get(i).GetNumberAsDouble()) <= 1e6)) return;
  for (int i = 0; i < 6; ++i) out.transform[i] = float(matrix.Get(i).GetNumberAsDouble());
}

}  // namespace

template <class Info>
sdk::TextureSlotRecord Materials::slot(const Info& info, const std::string& what) {
  sdk::TextureSlotRecord out;
  if (info.index < 0) return out;
  const bool sound = report_.attempt(what, [&] {
    const auto index = std::size_t(info.index);
    document_.demand(at("textures", index));
    const tinygltf::Texture& texture = document_.model.textures[index];
    if (texture.source < 0) throw sdk::BadInput(at("textures", index) + ".source: expected an image");
    out.uvSet = std::uint32_t(info.texCoord);
    const auto transform = info.extensions.find("KHR_texture_transform");
    if (transform != info.extensions.end()) readTransform(transform->second, out);
    readOwnTransform(info.extras, out);
    if (out.uvSet > 1)
      throw sdk::BadInput("uses TEXCOORD_" + std::to_string(out.uvSet) + "; expected set 0 or 1");
    readSampler(texture.sampler, out);
    out.texture = textureId(texture.source);
  });
  return sound ? out : sdk::TextureSlotRecord();
}

template sdk::TextureSlotRecord Materials::slot(const tinygltf::TextureInfo&, const std::string&);
template sdk::TextureSlotRecord Materials::slot(const tinygltf::NormalTextureInfo&, const std::string&);

std::uint32_t Materials::textureId(int image) {
  const ImageBytes& from = document_.images[std::size_t(image)];
  if (!from.error.empty()) throw sdk::BadInput(from.error);
  if (!isImage(from.bytes))
    throw sdk::BadInput(at("images", std::size_t(image)) + ": expected a PNG or JPEG, got other bytes");
  const auto [at, first] = textures_.emplace(image, std::uint32_t(textures_.size() + 1));
  if (first)
    sink_.addTexture(
        {.id = at->second, .name = from.name, .bytes = from.bytes.data(), .byteCount = from.bytes.size()});
  return at->second;
}

void Materials::readSampler(int index, sdk::TextureSlotRecord& out) {
  if (index < 0) return;
  document_.demand(at("samplers", std::size_t(index)));
  const tinygltf::Sampler& sampler = document_.model.samplers[std::size_t(index)];
  out.wrapU = wrapOf(sampler.wrapS);
  out.wrapV = wrapOf(sampler.wrapT);
  out.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
}

}  // namespace gltf
