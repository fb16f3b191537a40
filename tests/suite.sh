#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs the whole suite (release build, then the unit tests under ASan + UBSan) and ends with one count of all.
set -uo pipefail
cd "$(dirname "$(readlink -f "$0")")/.." || exit 1
passed=0 failed=0 skipped=0

# One line "verdict name" per ctest test; a GoogleTest binary that wrote its own results gives one per test in it.
verdicts() {
  local results=$1 name status
  sed -n 's/.*<testcase name="\([^"]*\)".* status="\([a-z]*\)".*/\1 \2/p' "$results/junit.xml" |
    while read -r name status; do
      case $status in run) status=passed ;; fail) status=failed ;; *) status=skipped ;; esac
      if [ -f "$results/gtest/$name.xml" ]; then
        gtest_verdicts "$results/gtest/$name.xml"
        # A crash, leak or time-out after the last test is no test's fault, yet a failure.
        [ "$status" = passed ] || grep -q '<failure ' "$results/gtest/$name.xml" || echo "$status $name"
      else
        echo "$status $name"
      fi
    done
}

gtest_verdicts() {
  awk '
    function attribute(key,  text) {
      if (!match($0, " " key "=\"[^\"]*\"")) return ""
      text = substr($0, RSTART, RLENGTH)
      gsub("^ " key "=\"|\"$", "", text)
      return text
    }
    function flush() { if (test != "") print verdict, test }
    /<testcase / {
      flush()
      test = attribute("classname") "." attribute("name")
      verdict = attribute("status") == "notrun" || attribute("result") == "skipped" ? "skipped" : "passed"
    }
    /<failure / { verdict = "failed" }
    END { flush() }' "$1"
}

count() {
  local preset=$1 verdict name
  while read -r verdict name; do
    case $verdict in
      passed) passed=$((passed + 1)) ;;
      failed) failed=$((failed + 1)) ;;
      skipped) skipped=$((skipped + 1)) ;;
    esac
    [ "$verdict" = passed ] || printf '%s (%s): %s\n' "$verdict" "$preset" "$name"
  done
}

fail_stage() {
  failed=$((failed + 1))
  printf 'failed: %s\n' "$1"
}

run_preset() {
  local preset=$1 results=$PWD/build/$1/results
  rm -rf "$results" && mkdir -p "$results/gtest"
  GTEST_OUTPUT="xml:$results/gtest/" ctest --preset "$preset" --output-junit "$results/junit.xml"
  if ! grep -q '<testcase ' "$results/junit.xml" 2>/dev/null; then
    fail_stage "ctest --preset $preset ran no tests"
    return
  fi
  count "$preset" < <(verdicts "$results")
}

run_preset release
if cmake --preset asan && cmake --build --preset asan --target unit_tests; then
  run_preset asan
else
  fail_stage "the build of the unit tests under sanitizers"
fi

printf '%d passed, %d failed, %d skipped\n' "$passed" "$failed" "$skipped"
[ "$failed" -eq 0 ]
