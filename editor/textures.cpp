// SPDX-License-Identifier: MIT
// The textures of materials: from encoded bytes or a file to pixels, shared between all who use them.
#include "editor/textures.hpp"

#include <algorithm>
#include <atomic>
#include <span>
#include <string_view>
#include <thread>
#include <unordered_map>
#include <unordered_set>

#include "editor/image_file.hpp"
#include "plugins/host/read_file.hpp"

namespace steradian {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kLargestFile = 1ull << 30;

template <class Work>
void eachSlot(auto& scene, Work&& work) {
  for (auto& m : scene.materials)
    for (auto* slot : {&m.albedoTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.emissionTexture})
      if (slot->texture) work(*slot);
}

using Replacement = std::unordered_map<const Texture*, std::shared_ptr<const Texture>>;

void replace(Scene& scene, const Replacement& replacement) {
  eachSlot(scene, [&](TextureSlot& slot) {
    if (const auto found = replacement.find(slot.texture.get()); found != replacement.end())
      slot.texture = found->second;
  });
}

std::string nameOf(const Texture& texture) {
  if (texture.file.empty()) return "texture '" + texture.name + "'";
  return "texture '" + texture.name + "' (" + texture.file + ")";
}

/// Runs work(i) for all i < count on all cores.
template <class Work>
void inParallel(std::size_t count, Work&& work) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::jthread> threads;
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  for (std::size_t i = 0; i < std::min(count, cores); ++i)
    threads.emplace_back([&] {
      for (std::size_t each; (each = next++) < count;) work(each);
    });
}

}  // namespace

std::vector<std::shared_ptr<const Texture>> texturesOf(const Scene& scene) {
  std::vector<std::shared_ptr<const Texture>> out;
  std::unordered_set<const Texture*> seen;
  eachSlot(scene, [&](const TextureSlot& slot) {
    if (seen.insert(slot.texture.get()).second) out.push_back(slot.texture);
  });
  return out;
}

void renameTextures(Scene& scene, const std::function<std::string(const std::string&)>& newName) {
  Replacement renamed;
  for (const auto& texture : texturesOf(scene)) {
    if (texture->file.empty() || newName(texture->file) == texture->file) continue;
    Texture other = *texture;
    other.file = newName(texture->file);
    renamed.emplace(texture.get(), std::make_shared<const Texture>(std::move(other)));
  }
  replace(scene, renamed);
}

/// One texture on its way from bytes to pixels.
struct Textures::Wanted {
  std::shared_ptr<const Texture> from, to;
  std::string file;  // its bytes, when they lie in a file
  Content content;
  TexturePixels pixels;
  std::string failure;

  std::span<const std::uint8_t> bytes() const {
    if (from->file.empty()) return from->encoded;
    return {reinterpret_cast<const std::uint8_t*>(file.data()), file.size()};
  }
  void fetch(const fs::path& folder) try {
    if (!from->file.empty()) file = plugins::readFile(folder / from->file, kLargestFile);
    const std::string_view view(reinterpret_cast<const char*>(bytes().data()), bytes().size());
    content = {view.size(), std::hash<std::string_view>{}(view)};
  } catch (const std::exception& error) {
    failure = error.what();
  }
  void decode() noexcept try { pixels = decodeTexture(bytes()); } catch (const std::exception& error) {
    failure = error.what();
  }
};

std::shared_ptr<const Texture> Textures::known(const Content& content, const Texture& like) const {
  std::shared_ptr<const Texture> found;
  const auto [first, last] = decoded_.equal_range(content);
  for (auto each = first; each != last; ++each)
    if (auto alive = each->second.lock();
        alive && (!found || (alive->name == like.name && alive->file == like.file)))
      found = std::move(alive);
  return found;
}

/// Decodes each content that is new once, then gives every texture its pixels.
void Textures::decode(std::vector<Wanted>& wanted) {
  std::vector<Wanted*> jobs;
  std::map<Content, Wanted*> first;
  for (Wanted& each : wanted)
    if (each.failure.empty() && !known(each.content, *each.from) && first.emplace(each.content, &each).second)
      jobs.push_back(&each);
  inParallel(jobs.size(), [&](std::size_t i) { jobs[i]->decode(); });
  for (Wanted& each : wanted) {
    const auto job = first.find(each.content);
    if (each.failure.empty() && job != first.end()) each.failure = job->second->failure;
    if (!each.failure.empty()) continue;
    const auto same = known(each.content, *each.from);
    if (same && same->name == each.from->name && same->file == each.from->file) {
      each.to = same;
      continue;
    }
    Texture texture = *each.from;
    texture.pixels = same ? same->pixels : std::move(each.pixels);
    each.to = std::make_shared<const Texture>(std::move(texture));
    decoded_.emplace(each.content, each.to);
  }
}

std::vector<std::string> Textures::load(Scene& scene, const fs::path& folder) {
  std::erase_if(decoded_, [](const auto& each) { return each.second.expired(); });
  std::vector<Wanted> wanted;
  for (auto& texture : texturesOf(scene))
    if (texture->pixels.width == 0) wanted.emplace_back().from = std::move(texture);
  for (Wanted& each : wanted) each.fetch(folder);
  decode(wanted);
  std::vector<std::string> failures;
  Replacement replacement;
  for (const Wanted& each : wanted) {
    if (each.to)
      replacement.emplace(each.from.get(), each.to);
    else
      failures.push_back(nameOf(*each.from) + " " + each.failure + "; what uses it is shown without it");
  }
  replace(scene, replacement);
  return failures;
}

}  // namespace steradian
