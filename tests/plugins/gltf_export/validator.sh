#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Khronos' glTF validator on files: validator.sh CACHE_FOLDER FILE...; exit status 77 when it cannot be had here.
set -uo pipefail
version=2.0.0-dev.3.10
here=$(dirname "$(readlink -f "$0")")
cache=$1
shift
command -v node >/dev/null && command -v npm >/dev/null || { echo "node and npm are not installed"; exit 77; }
if [ ! -d "$cache/node_modules/gltf-validator" ]; then
  mkdir -p "$cache"
  npm install --silent --no-audit --no-fund --prefix "$cache" "gltf-validator@$version" >&2 ||
    { echo "npm could not fetch gltf-validator $version"; exit 77; }
fi
exec node "$here/validate.mjs" "$cache" "$@"
