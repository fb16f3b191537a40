// SPDX-License-Identifier: MIT
// Time from process start to the first pixel, in fresh processes with empty or filled caches.
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>

#include "editor/assets.hpp"
#include "editor/cli/bench.hpp"
#include "editor/cli/bench_cache.hpp"
#include "editor/cli/bench_scene.hpp"

namespace steradian::bench {

namespace fs = std::filesystem;

namespace {

std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> out;
  for (std::string& string : strings) out.push_back(string.data());
  out.push_back(nullptr);
  return out;
}

/// Wall seconds of one start, the process's end not counted: it tells through the pipe when a pixel is there.
double timeOneStart(std::vector<std::string> command, const CacheFolder& caches) {
  int ends[2];
  if (pipe(ends) != 0) throw Error(ExitCode::io, std::string("no pipe: ") + std::strerror(errno));
  std::vector<std::string> environment = caches.environment();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addclose(&actions, ends[0]);
  const auto start = std::chrono::steady_clock::now();
  pid_t child = 0;
  const int failure = posix_spawn(&child, command[0].c_str(), &actions, nullptr, pointers(command).data(),
                                  pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  char byte = 0;
  const bool seen = failure == 0 && read(ends[0], &byte, 1) == 1;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  close(ends[0]);
  int status = 0;
  if (failure == 0) waitpid(child, &status, 0);
  if (!seen)
    throw Error(ExitCode::failed,
                "the start of " + command[0] + " for the first pixel failed; its messages stand above");
  return seconds;
}

std::vector<std::string> commandFor(const fs::path& project, const BenchOptions& options) {
  std::vector<std::string> command = options.firstPixelCommand;
  command.insert(command.end(), {"--first-pixel", project.string()});
  if (!options.device.empty()) command.insert(command.end(), {"--device", options.device});
  if (options.size)
    command.insert(command.end(), {"--size", std::to_string(options.size->width) + "x" +
                                                 std::to_string(options.size->height)});
  for (const fs::path& folder : options.pluginPath)
    command.insert(command.end(), {"--plugin-path", folder.string()});
  return command;
}

}  // namespace

FirstPixel measureFirstPixel(const fs::path& project, const BenchOptions& options) {
  const std::vector<std::string> command = commandFor(project, options);
  std::vector<double> cold, warm;
  for (int run = 0; run < options.runs; ++run) {
    const CacheFolder caches;
    cold.push_back(timeOneStart(command, caches));
    warm.push_back(timeOneStart(command, caches));
  }
  return {median(cold), median(warm)};
}

BenchScene loadBenchScene(const plugins::PluginHost& host, const fs::path& project,
                          const BenchOptions& options) {
  BenchScene out;
  out.scene = host.importScene(project).scene;
  loadAssets(out.scene, projectFolderOf(project));
  if (options.bounces) out.scene.render.maxBounces = *options.bounces;
  out.film = options.size.value_or(Extent{out.scene.render.width, out.scene.render.height});
  out.view = cameraView(out.scene);
  return out;
}

void renderFirstPixel(const fs::path& project, const BenchOptions& options) {
  const plugins::PluginHost host(plugins::defaultSearchPath(options.pluginPath));
  const BenchScene scene = loadBenchScene(host, project, options);
  Renderer renderer(openDevice({.device = options.device}));
  renderer.setScene(scene.scene, scene.view, scene.film);
  renderer.trace(15.0);
  if (write(STDOUT_FILENO, "\n", 1) != 1) throw Error(ExitCode::io, "stdout is closed");
}

}  // namespace steradian::bench
