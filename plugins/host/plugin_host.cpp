// SPDX-License-Identifier: MIT
// The host: what was found where, who wins, and one import or export from the question to the file.
#include "plugins/host/plugin_host.hpp"

#include <algorithm>
#include <mutex>
#include <set>

#include "plugins/host/atomic_file.hpp"
#include "plugins/host/call.hpp"
#include "plugins/host/description.hpp"
#include "plugins/host/elf_check.hpp"
#include "plugins/host/library.hpp"
#include "plugins/host/probe.hpp"
#include "plugins/host/probe_cache.hpp"
#include "plugins/host/read_file.hpp"
#include "plugins/host/scene_builder.hpp"
#include "plugins/host/scene_records.hpp"
#include "plugins/host/tonemapper_file.hpp"
#include "renderer/scene/validate.hpp"

namespace steradian::plugins {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kLargestInput = 4ull << 30, kLargestGlsl = 1 << 20;

/// Files beside an exported one are named by their content as a rule: what is there already is left alone.
void writeBeside(const fs::path& path, const std::string& bytes) {
  std::error_code failed;
  fs::create_directories(path.parent_path(), failed);
  if (failed)
    throw Error(ExitCode::io, path.parent_path().string() + ": cannot be made: " + failed.message());
  if (fs::file_size(path, failed) == bytes.size() && !failed && readFile(path, bytes.size()) == bytes) return;
  writeFileAtomically(path, bytes);
}

std::string lowerExtension(const fs::path& path) {
  std::string out = path.extension().string();
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return out;
}

/// The layers of a picture as records. Throws Error(badInput) for one that is not of the picture's size.
class LayerRecords {
 public:
  LayerRecords(const ImageToSave& image, const fs::path& path) : names_(image.layers.size()) {
    for (std::size_t i = 0; i < image.layers.size(); ++i) {
      const ImageLayer& layer = image.layers[i];
      const Image& pixels = layer.pixels;
      if (pixels.width != image.width || pixels.height != image.height || pixels.channels < 1 ||
          std::size_t(pixels.channels) != layer.channelNames.size())
        throw Error(ExitCode::badInput,
                    path.string() + ": not written, the layer " + layer.name + " does not fit the picture");
      names_[i].assign(layer.channelNames.begin(), layer.channelNames.end());
      records.push_back({layer.name, names_[i].data(), pixels.pixels.data(), std::uint32_t(pixels.channels)});
    }
  }
  std::vector<sdk::LayerRecord> records;

 private:
  std::vector<std::vector<sdk::Text>> names_;
};

bool hasExtension(const Contribution& c, const std::string& extension) {
  return std::find(c.extensions.begin(), c.extensions.end(), extension) != c.extensions.end();
}

/// Candidates folder by folder, each sorted by name; the same file is taken once.
std::vector<fs::path> candidates(const std::vector<fs::path>& searchPath) {
  std::vector<fs::path> out;
  std::set<fs::path> seen;
  for (const fs::path& folder : searchPath) {
    std::vector<fs::path> inFolder;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".so" || extension == ".glsl") inFolder.push_back(entry.path());
    }
    std::sort(inFolder.begin(), inFolder.end());
    for (const fs::path& file : inFolder) {
      const fs::path real = fs::weakly_canonical(file, none);
      if (seen.insert(real).second) out.push_back(real);
    }
  }
  return out;
}

void takeTonemapper(PluginFile& file) try {
  file.contributions = {parseTonemapper(readFile(file.path, kLargestGlsl))};
} catch (const std::exception& error) {
  file.reason = error.what();
}

/// Answers from the cache where it can; the others are probed in children side by side.
void takeLibraries(std::vector<PluginFile>& files) {
  ProbeCache cache;
  std::vector<std::pair<PluginFile*, Probe>> probes;
  for (PluginFile& file : files) {
    if (file.path.extension() != ".so") continue;
    file.reason = reasonNotLoadable(file.path);
    if (!file.reason.empty()) continue;
    if (auto known = cache.find(file.path))
      file.contributions = std::move(*known);
    else
      probes.emplace_back(&file, Probe(file.path));
  }
  for (auto& [file, probe] : probes) {
    ProbeResult result = probe.collect();
    file->reason = std::move(result.reason);
    file->contributions = std::move(result.contributions);
    if (file->reason.empty()) cache.remember(file->path, file->contributions);
  }
  cache.save();
}

/// Of one kind and id the highest version stays, of equals the first found; the others say why they are gone.
void settleDuplicates(std::vector<PluginFile>& files) {
  struct Winner {
    std::size_t file;
    std::string version;
  };
  std::map<std::pair<Kind, std::string>, Winner> winners;
  for (std::size_t i = 0; i < files.size(); ++i)
    for (const Contribution& c : files[i].contributions) {
      const auto [at, first] = winners.try_emplace({c.kind, c.id}, Winner{i, c.version});
      if (!first && versionLess(at->second.version, c.version)) at->second = {i, c.version};
    }
  for (std::size_t i = 0; i < files.size(); ++i)
    std::erase_if(files[i].contributions, [&](const Contribution& c) {
      const Winner& winner = winners.at({c.kind, c.id});
      if (winner.file == i) return false;
      files[i].reason += (files[i].reason.empty() ? "" : "; ") + c.id + " " + c.version + " gives way to " +
                         winner.version + " in " + files[winner.file].path.string();
      return true;
    });
}

std::string joined(const std::vector<Problem>& problems) {
  std::string text = problems[0].where + ": " + problems[0].what;
  if (problems.size() > 1) text += " (and " + std::to_string(problems.size() - 1) + " more)";
  return text;
}

/// A folder stands for its one .srad.
fs::path projectFile(const fs::path& path) {
  std::error_code none;
  if (!fs::is_directory(path, none)) return path;
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(path, none))
    if (lowerExtension(entry.path()) == ".srad") found.push_back(entry.path());
  if (found.size() == 1) return found[0];
  throw Error(ExitCode::badInput, path.string() + ": is a folder with " + std::to_string(found.size()) +
                                      " .srad files; expected exactly one, or the name of a file");
}

}  // namespace

struct PluginHost::Impl {
  std::vector<PluginFile> files;
  std::mutex mutex;  // guards `open`
  std::map<fs::path, Library> open;

  const fs::path& fileOf(const Contribution& contribution) const {
    for (const PluginFile& file : files)
      for (const Contribution& each : file.contributions)
        if (&each == &contribution) return file.path;
    std::abort();  // contributions come from this host only
  }

  /// Opens the file on first use: a library behind it may take a quarter of a second to load.
  Library& libraryOf(const Contribution& contribution) {
    const fs::path& path = fileOf(contribution);
    const std::lock_guard lock(mutex);
    if (const auto found = open.find(path); found != open.end()) return found->second;
    try {
      return open.emplace(path, openLibrary(path)).first->second;
    } catch (const std::runtime_error& error) {
      throw Error(ExitCode::plugin, path.string() + ": " + error.what());
    }
  }

  template <class Interface>
  Interface& implementation(const Contribution& c, std::vector<Interface*> Library::*list) {
    for (Interface* each : libraryOf(c).*list)
      if (each->info().id.view() == c.id) return *each;
    throw Error(ExitCode::plugin, fileOf(c).string() + ": no longer has " + c.id + "; start Steradian again");
  }
  sdk::ImporterInterface& importer(const Contribution& c) { return implementation(c, &Library::importers); }
  sdk::ExporterInterface& exporter(const Contribution& c) { return implementation(c, &Library::exporters); }

  std::vector<const Contribution*> ofKind(Kind kind) const {
    std::vector<const Contribution*> out;
    for (const PluginFile& file : files)
      for (const Contribution& c : file.contributions)
        if (c.kind == kind) out.push_back(&c);
    return out;
  }

  /// By extension; when that does not decide, by what the importers say to the first bytes.
  const Contribution& importerFor(const fs::path& path) {
    std::vector<const Contribution*> all = ofKind(Kind::importer), matching;
    for (const Contribution* c : all)
      if (hasExtension(*c, lowerExtension(path))) matching.push_back(c);
    if (matching.size() == 1) return *matching[0];
    const std::string bytes = readFile(path, kLargestInput);
    const sdk::Text head = std::string_view(bytes).substr(0, 4096);
    const Contribution* best = nullptr;
    std::uint32_t bestScore = 0;
    for (const Contribution* c : matching.empty() ? all : matching)
      if (const std::uint32_t score = importer(*c).probe(head); score > bestScore)
        best = c, bestScore = score;
    if (!best && !matching.empty()) best = matching[0];
    if (!best) throw Error(ExitCode::badInput, path.string() + ": no importer knows this kind of file");
    return *best;
  }

  void run(const Contribution& c, SceneRecords* scene, const sdk::ImageRecord* image, const fs::path& path,
           const Progress& progress, const Parameters& parameters) {
    Call call(c, path, progress, parameters);
    MemoryWriter writer(path.stem().string());
    call.judge(exporter(c).run(call, scene, image, writer));
    if (writer.outOfMemory) throw Error(ExitCode::failed, path.string() + ": not enough memory to write it");
    for (const auto& [name, bytes] : writer.beside)
      writeBeside(insideFolder(path.parent_path(), name), bytes);
    writeFileAtomically(path, writer.bytes);
  }
};

PluginHost::PluginHost(const std::vector<fs::path>& searchPath) : impl_(std::make_unique<Impl>()) {
  for (const fs::path& path : candidates(searchPath)) impl_->files.push_back({.path = path});
  for (PluginFile& file : impl_->files)
    if (file.path.extension() == ".glsl") takeTonemapper(file);
  takeLibraries(impl_->files);
  settleDuplicates(impl_->files);
  for (PluginFile& file : impl_->files) {
    file.loaded = !file.contributions.empty();
    if (!file.loaded && file.reason.empty()) file.reason = "registers nothing";
  }
}

PluginHost::~PluginHost() = default;

std::span<const PluginFile> PluginHost::files() const {
  return impl_->files;
}

std::vector<const Contribution*> PluginHost::contributions(Kind kind) const {
  return impl_->ofKind(kind);
}

const Contribution* PluginHost::tonemapper(std::string_view id) const {
  const auto all = impl_->ofKind(Kind::tonemapper);
  for (const Contribution* c : all)
    if (c->id == id) return c;
  for (const Contribution* c : all)
    if (c->id.substr(c->id.rfind('.') + 1) == id) return c;
  return nullptr;
}

const Contribution* PluginHost::exporterFor(const fs::path& path, bool image) const {
  for (const Contribution* c : impl_->ofKind(Kind::exporter))
    if ((image ? c->takesImage : c->takesScene) && hasExtension(*c, lowerExtension(path))) return c;
  return nullptr;
}

bool PluginHost::canImport(const fs::path& path) const {
  const auto all = impl_->ofKind(Kind::importer);
  return std::any_of(all.begin(), all.end(),
                     [&](const Contribution* c) { return hasExtension(*c, lowerExtension(path)); });
}

ImportResult PluginHost::importScene(const fs::path& asked, const Progress& progress,
                                     const Parameters& parameters) const {
  const fs::path path = projectFile(asked);
  const Contribution& contribution = impl_->importerFor(path);
  sdk::ImporterInterface& importer = impl_->importer(contribution);
  const std::uint64_t limit = sdk::adopt(importer.info()).maxBytes;
  const std::string bytes = readFile(path, limit ? std::min(limit, kLargestInput) : kLargestInput);
  const std::string name = path.string();
  Call call(contribution, path, progress, parameters);
  SceneBuilder sink;
  call.judge(importer.run(call, {.path = name, .bytes = bytes.data(), .byteCount = bytes.size()}, sink));
  if (sink.outOfMemory()) throw Error(ExitCode::failed, name + ": not enough memory to read it");
  std::vector<Problem> problems;
  ImportResult result{sink.finish(problems), std::move(call.report)};
  if (!problems.empty()) throw Error(ExitCode::badInput, name + ": " + joined(problems));
  if (call.cancelled()) throw Error(ExitCode::failed, name + ": cancelled");
  return result;
}

void PluginHost::exportScene(const Scene& scene, const fs::path& path, const Progress& progress,
                             const Parameters& parameters) const {
  const Contribution* c = exporterFor(path, false);
  if (!c) throw Error(ExitCode::usage, path.string() + ": no exporter writes scenes as this kind of file");
  const auto problems = problemsOf(scene);
  if (!problems.empty())
    throw Error(ExitCode::badInput,
                path.string() + ": not saved, it could not be opened again: " + joined(problems));
  SceneRecords records(scene);
  impl_->run(*c, &records, nullptr, path, progress, parameters);
}

void PluginHost::exportImage(const ImageToSave& image, const fs::path& path, const Progress& progress,
                             const Parameters& parameters) const {
  const Contribution* c = exporterFor(path, true);
  if (!c) throw Error(ExitCode::usage, path.string() + ": no exporter writes images as this kind of file");
  if (image.width <= 0 || image.height <= 0)
    throw Error(ExitCode::badInput, path.string() + ": not written, the image is empty");
  std::vector<sdk::MetadataRecord> metadata;
  for (const auto& [key, value] : image.metadata) metadata.push_back({key, value});
  sdk::ImageRecord record;
  record.width = std::uint32_t(image.width);
  record.height = std::uint32_t(image.height);
  record.radiance = image.radiance;
  record.displayed = image.displayed;
  record.metadata = metadata.data();
  record.metadataCount = metadata.size();
  const LayerRecords layers(image, path);
  record.layers = layers.records.data();
  record.layerCount = layers.records.size();
  impl_->run(*c, nullptr, &record, path, progress, parameters);
}

}  // namespace steradian::plugins
