#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Fuzzes the glTF importer: `run.sh [SECONDS]`, 60 by default. What breaks it lies in build/fuzz/findings.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.." || exit 1
seconds=${1:-60}
case $seconds in *[!0-9]*) echo "fuzz: expected a number of seconds, got '$seconds'" >&2; exit 2 ;; esac
command -v clang++-14 >/dev/null || { echo "fuzz: clang++-14 is missing; apt-get install clang-14" >&2; exit 4; }

cmake --preset fuzz >&2
cmake --build --preset fuzz >&2
corpus=$PWD/build/fuzz/corpus findings=$PWD/build/fuzz/findings
mkdir -p "$corpus" "$findings"
seeds=("$PWD/tests/fuzz/seeds")
for models in /usr/share/assimp/models/glTF2 /usr/share/assimp/models/glTF; do  # Debian's assimp-testmodels
  [ ! -d "$models" ] || seeds+=("$models")
done
exec build/fuzz/bin/gltf_fuzzer -max_total_time="$seconds" -max_len=65536 -timeout=10 -rss_limit_mb=2048 \
  -dict=tests/fuzz/gltf.dict -artifact_prefix="$findings/" -print_final_stats=1 "$corpus" "${seeds[@]}"
