// SPDX-License-Identifier: MIT
// compare --verify-pixel from the outside.
#include <gtest/gtest.h>

#include "process.hpp"

using namespace process;

TEST(Verify, projects_agree_in_float_and_double) {
  const Sandbox sandbox;
  for (const char* name : {"thesis-room", "material-grid", "cornell", "glass", "veach"}) {
    const Outcome outcome = sandbox.run(
        {"compare", "--verify-pixel", "4,4,11,9", project(name), "--size", "16x12", "--sample", "3"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("agreed: 48 paths"), std::string::npos) << outcome.out;
  }
}

TEST(Verify, one_pixel_is_told_vertex_by_vertex) {
  const Sandbox sandbox;
  const Outcome outcome =
      sandbox.run({"compare", "--verify-pixel", "8,6", project("thesis-room"), "--size", "16x12"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
  for (const char* expected :
       {"pixel 8,6 sample 0", "pixel 8,6 sample 3", "intersection", "free-running in double"})
    EXPECT_NE(outcome.out.find(expected), std::string::npos) << outcome.out;
}

TEST(Verify, pixels_outside_the_film_and_a_missing_reference_are_usage_errors) {
  const Sandbox sandbox;
  for (const char* pixels : {"16,0", "-1,0", "3", "4,4,3,3", "1,2,3", "1,2x"})
    EXPECT_EQ(
        sandbox.run({"compare", std::string("--verify-pixel=") + pixels, project("hello"), "--size", "16x12"})
            .exitCode,
        2)
        << pixels;
  EXPECT_EQ(sandbox.run({"compare", "a.exr"}).exitCode, 2);
}
