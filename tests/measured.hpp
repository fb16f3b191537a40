// SPDX-License-Identifier: MIT
// Figures of the running test, written beside its verdict (--gtest_output=xml) for tests/figures.py.
#pragma once
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace steradian {

/// The test's property of this name; null = not yet recorded.
inline const char* recorded(const std::string& key) {
  const testing::TestResult& result = *testing::UnitTest::GetInstance()->current_test_info()->result();
  for (int i = 0; i < result.test_property_count(); ++i)
    if (key == result.GetTestProperty(i).key()) return result.GetTestProperty(i).value();
  return nullptr;
}

/// Records `value` beside the bound that an EXPECT holds it to, in the unit that `what` names. Of several
/// records under the same words the one that uses up most of its gate stays.
inline void measured(const std::string& what, double value, double gate, bool atLeast = false) {
  const auto used = [atLeast](double v, double g) {
    if (atLeast) return g / v;
    return g > 0.0 ? v / g : v;  // a count that must be 0 stands for itself
  };
  const std::string key = "measured " + what;
  if (const char* old = recorded(key)) {
    char* rest = nullptr;
    const double before = std::strtod(old, &rest);
    if (used(before, std::strtod(rest + 4, nullptr)) >= used(value, gate)) return;
  }
  char text[64];
  std::snprintf(text, sizeof text, "%.6g %s %.6g", value, atLeast ? ">=" : "<=", gate);
  testing::Test::RecordProperty(key, text);
}

/// The same for a value that may not be smaller than its gate.
inline void measuredAtLeast(const std::string& what, double value, double gate) {
  measured(what, value, gate, true);
}

}  // namespace steradian
