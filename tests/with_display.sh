#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs a command on an X display of its own: tests/with_display.sh COMMAND [ARGUMENT...]
set -u
number=$(mktemp) || exit 1
Xvfb -displayfd 5 -screen 0 1280x800x24 -nolisten tcp 5>"$number" 2>/dev/null &
server=$!
trap 'kill "$server" 2>/dev/null; rm -f "$number"' EXIT
for _ in $(seq 100); do
  [ -s "$number" ] && break
  sleep 0.1
done
[ -s "$number" ] || { echo "Xvfb did not start: apt-get install xvfb"; exit 1; }
DISPLAY=:$(cat "$number") "$@"
