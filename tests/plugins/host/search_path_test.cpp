// SPDX-License-Identifier: MIT
// Where plugins are looked for, and in which order.
#include "tests/plugins/fixture.hpp"

namespace steradian::plugins {
namespace {

/// An environment variable for one test.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    setenv(name, value.c_str(), 1);
  }
  ~Variable() { old_.empty() ? unsetenv(name_) : setenv(name_, old_.c_str(), 1); }

 private:
  const char* name_;
  std::string old_;
};

TEST(SearchPath, IsCommandLineThenEnvironmentThenUserThenInstalled) {
  const Variable list("STERADIAN_PLUGIN_PATH", "/one::/two");
  const Variable data("XDG_DATA_HOME", "/data");
  const auto path = defaultSearchPath({"/first"});
  const std::vector<fs::path> expected{"/first", "/one", "/two", "/data/steradian/plugins"};
  ASSERT_GE(path.size(), expected.size());
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), path.begin()));
  ASSERT_EQ(path.size(), 5u) << "the build tree's own plugins come last";
  EXPECT_TRUE(fs::equivalent(path.back(), STOCK_PLUGINS));
}

TEST(SearchPath, IgnoresARelativeDataFolder) {
  const Variable data("XDG_DATA_HOME", "relative");
  const Variable home("HOME", "/home/somebody");
  const auto path = defaultSearchPath();
  EXPECT_NE(std::find(path.begin(), path.end(), "/home/somebody/.local/share/steradian/plugins"), path.end());
}

TEST(SearchPath, AFolderNamedTwiceIsTakenOnce) {
  EXPECT_EQ(PluginHost({STOCK_PLUGINS, STOCK_PLUGINS, fs::path(STOCK_PLUGINS) / "."}).files().size(), 13u);
}

}  // namespace
}  // namespace steradian::plugins
