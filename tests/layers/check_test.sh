#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests the layer check itself: every rule catches a planted breach, and what is allowed passes.
set -uo pipefail
here=$(dirname "$(readlink -f "$0")")
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failures=0

plant() {
  mkdir -p "$tree/$(dirname "$1")"
  printf '%s\n' "$2" >"$tree/$1"
}

# catches FILE TEXT: the check must fail and name FILE.
catches() {
  plant "$1" "$2"
  local output
  if output=$("$here/check.sh" "$tree") || ! grep -qF "$1:" <<<"$output"; then
    printf 'not caught: %s: %s\n' "$1" "$2"
    failures=$((failures + 1))
  fi
  rm "$tree/$1"
}

allows() {
  plant "$1" "$2"
  local output
  if ! output=$("$here/check.sh" "$tree"); then
    printf 'wrongly caught: %s\n' "$output"
    failures=$((failures + 1))
  fi
  rm "$tree/$1"
}

allows plugins/obj/obj.cpp '#include <steradian/plugin.hpp>'
allows plugins/host/sink.cpp '#include "renderer/scene/scene.hpp"'
allows renderer/renderer.cpp '#include "renderer/gpu/device.hpp"'
allows renderer/renderer.hpp 'void* vkInstance;  // a VkInstance'
allows renderer/gpu/device.cpp '#include <vulkan/vulkan_raii.hpp>'
allows renderer/scene/scene.cpp '#include <glm/glm.hpp>'
allows editor/ui/app.cpp '#include <imgui.h>'
allows editor/ui/imgui_vulkan.cpp '#include <vulkan/vulkan.h>'
allows editor/window.cpp '#include <GLFW/glfw3.h>'
allows editor/cli/edit.cpp '#include "editor/ui/app.hpp"'
allows shaders/path_trace.comp '#include "gpu_types.h"'
allows tests/renderer/bvh_test.cpp '#include "renderer/gpu/device.hpp"'

catches plugins/obj/obj.cpp '#include "renderer/scene/scene.hpp"'
catches plugins/obj/obj.cpp '#include "plugins/host/plugin_host.hpp"'
catches plugins/obj/obj.cpp '#include "plugins/ply/ply.hpp"'
catches plugins/obj/obj.cpp '#include "../ply/ply.hpp"'
catches plugins/sdk/steradian/plugin.hpp '#include <glm/glm.hpp>'
catches plugins/host/registry.cpp '#include "renderer/renderer.hpp"'
catches renderer/scene/scene.cpp '#include "renderer/renderer.hpp"'
catches renderer/scene/scene.cpp '#include <nlohmann/json.hpp>'
catches renderer/renderer.cpp '#include "editor/document.hpp"'
catches renderer/renderer.cpp '#include "plugins/host/plugin_host.hpp"'
catches renderer/renderer.hpp '#include <vulkan/vulkan.hpp>'
catches renderer/renderer.cpp 'vk::Device device;'
catches renderer/scene/scene.cpp 'VkDevice device;'
catches editor/ui/app.cpp '#include "renderer/gpu/device.hpp"'
catches editor/document.cpp '#include <imgui.h>'
catches editor/document.cpp '#include "editor/ui/app.hpp"'
catches editor/cli/render.cpp '#include <GLFW/glfw3.h>'
catches editor/cli/render.cpp '#include "editor/ui/app.hpp"'
catches editor/cli/render.cpp '#include "editor/window.hpp"'
catches shaders/path_trace.comp '#include "renderer/gpu_scene.hpp"'
catches renderer/long.cpp "$(yes '//' | head -401)"

[ "$failures" -eq 0 ]
