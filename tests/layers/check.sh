#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The layer check: who includes whom, where Vulkan is named, and no file over 400 lines. `check.sh [ROOT]`
set -u
here=$(dirname "$(readlink -f "$0")")
cd "${1:-$here/../..}" || exit 2
sources=(plugins renderer editor shaders tests)

# Files of ours with one of the given endings.
files() {
  local ending names=()
  for ending in "$@"; do names+=(-o -name "*.$ending"); done
  for folder in "${sources[@]}"; do
    [ ! -d "$folder" ] || find "$folder" -type f \( "${names[@]:1}" \)
  done | sort
}

include_breaches() {
  files cpp hpp h glsl comp vert frag | xargs -r grep -nE '^[[:space:]]*#[[:space:]]*include' /dev/null |
    awk -f "$here/rules.awk" || echo "rules.awk: the check itself failed"
}

# Names of the Vulkan API in code (comments and string literals do not count).
vulkan_breaches() {
  files cpp hpp h | grep -E '^(plugins|renderer|editor)/' |
    grep -vE '^(renderer/gpu/|editor/ui/imgui_vulkan\.cpp$)' | while read -r path; do
    sed -E 's/"([^"\\]|\\.)*"//g; s://.*$::' "$path" | grep -nE '\b(vk::|Vk[A-Z][a-z]|VK_[A-Z])' |
      sed -E "s|^([0-9]+):.*|$path:\1: names Vulkan outside renderer/gpu|"
  done
}

long_files() {
  files cpp hpp h glsl comp vert frag sh awk py | xargs -r awk '
    FNR == 1 && NR > 1 { report() }
    { file = FILENAME; lines = FNR }
    function report() { if (lines > 400) printf "%s: %d lines; 400 is the limit, split it by concept\n", file, lines }
    END { report() }'
}

breaches=$(include_breaches; vulkan_breaches; long_files)
[ -z "$breaches" ] && exit 0
printf '%s\n' "$breaches"
exit 1
