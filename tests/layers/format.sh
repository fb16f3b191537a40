#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The format check: clang-format 14 would change nothing.
set -uo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.." || exit 2
formatter=$(command -v clang-format-14 || command -v clang-format) || {
  echo "clang-format is missing: apt-get install clang-format-14"
  exit 1
}
find plugins renderer editor shaders tests -type f \( -name '*.cpp' -o -name '*.hpp' -o -name '*.h' \) -print0 |
  xargs -0 -r "$formatter" --dry-run -Werror
