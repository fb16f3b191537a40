// SPDX-License-Identifier: MIT
// How many samples a budget buys, and what is switched off.
#include "editor/report/measure.hpp"

#include <gtest/gtest.h>

#include <set>

#include "editor/report/variants.hpp"

using namespace steradian;
using namespace steradian::report;

TEST(AffordableSamples, keep_the_budget_with_the_reference_in_it) {
  MeasureOptions options;
  options.maxSamples = 1024;
  options.runs = 5;
  options.seconds = 70.0;
  // 1 variant: 5 runs and 64 for the reference, 69 samples of time for each sample of a run.
  EXPECT_EQ(affordableSamples(options, 1.0 / 1024.0, 1, 1), 1024u);
  EXPECT_EQ(affordableSamples(options, 1.0 / 1000.0, 1, 1), 512u);
  EXPECT_EQ(affordableSamples(options, 0.01, 1, 1), 64u);
  EXPECT_EQ(affordableSamples(options, 100.0, 1, 1), 8u);
  EXPECT_LT(affordableSamples(options, 1.0 / 1024.0, 8, 3), 1024u);
}

TEST(Variants, have_names_of_their_own_and_switch_something_off) {
  std::set<std::string> names{baseline().id, baseline().label};
  for (const Variant& variant : ablations()) {
    EXPECT_TRUE(names.insert(variant.id).second) << variant.id;
    EXPECT_TRUE(names.insert(variant.label).second) << variant.label;
    RenderSettings settings;
    Ablation ablation;
    if (variant.settings) variant.settings(settings);
    if (variant.ablation) variant.ablation(ablation);
    EXPECT_TRUE(settings != RenderSettings{} || ablation != Ablation{} || !variant.specialized) << variant.id;
  }
}
