// SPDX-License-Identifier: MIT
// A wrong, broken or foreign plugin is listed with its reason; the others load; none brings us down.
#include "plugins/host/probe.hpp"
#include "tests/plugins/fixture.hpp"

namespace steradian::plugins {
namespace {

class BrokenPlugins : public FolderTest {
 protected:
  /// Why the host does not load this file; a good one beside it must load all the same.
  std::string reasonFor(const fs::path& file) {
    fs::copy_file(fs::path(SAMPLE_PLUGINS) / "good.so", folder / "plugins/zz_good.so",
                  fs::copy_options::overwrite_existing);
    const PluginHost plugins = host();
    EXPECT_EQ(plugins.contributions(Kind::importer).size(), 1u);
    for (const PluginFile& each : plugins.files())
      if (each.path.filename() == file.filename()) {
        EXPECT_FALSE(each.loaded);
        return each.reason;
      }
    return "not listed";
  }
  std::string importing(const std::string& bytes) {
    writeText(folder / "a.sample", bytes);
    const auto [message, code] = faultOf([&] { host().importScene(folder / "a.sample"); });
    lastCode = code;
    return message;
  }
  ExitCode lastCode = ExitCode::ok;
};

TEST_F(BrokenPlugins, ATextFile) {
  writeText(folder / "plugins/text.so", "x\n");
  EXPECT_CONTAINS(reasonFor("text.so"), "is not a shared library");
  writeText(folder / "plugins/empty.so", "");
  EXPECT_CONTAINS(reasonFor("empty.so"), "is not a shared library");
}

TEST_F(BrokenPlugins, ATruncatedLibraryAtEvery16th) {
  const fs::path file = add("throws");
  const std::string whole = readText(file);
  for (std::size_t i = 0; i < 16; ++i) {
    writeText(file, whole.substr(0, whole.size() * i / 16));
    EXPECT_FALSE(reasonFor(file).empty()) << i;
  }
}

TEST_F(BrokenPlugins, AnotherProcessor) {
  const fs::path file = add("good");
  std::string bytes = readText(file);
  bytes[18] = char(243);  // e_machine: RISC-V
  bytes[19] = 0;
  writeText(file, bytes);
  EXPECT_CONTAINS(reasonFor(file), "built for another processor");
}

TEST_F(BrokenPlugins, AnUndefinedSymbolIsNamed) {
  EXPECT_CONTAINS(reasonFor(add("undefined_symbol")), "steradian_test_symbol_that_nobody_defines");
}

TEST_F(BrokenPlugins, AForeignLibraryWithoutTheNote) {
  EXPECT_CONTAINS(reasonFor(add("no_note")), "has no version note");
}

// These abort as soon as any of their code runs: the reason shows that none did.
TEST_F(BrokenPlugins, ANewerOrOlderInterfaceIsRefusedBeforeItsCodeRuns) {
  EXPECT_CONTAINS(reasonFor(add("interface_2")), "built for interface 2.0, this host speaks 1.2");
  EXPECT_CONTAINS(reasonFor(add("interface_0")), "built for interface 0.0, this host speaks 1.2; rebuild");
  EXPECT_CONTAINS(reasonFor(add("minor_9")), "built for interface 1.9, this host speaks 1.2; update");
}

TEST_F(BrokenPlugins, AnEntryThatIsTooSmall) {
  EXPECT_CONTAINS(reasonFor(add("small_entry")), "has 8 bytes");
}

TEST_F(BrokenPlugins, AnEntryThatContradictsItsNote) {
  EXPECT_CONTAINS(reasonFor(add("lying_note")), "built for interface 7.2");
}

TEST_F(BrokenPlugins, AStaticInitialiserThatAbortsOrExits) {
  EXPECT_CONTAINS(reasonFor(add("crashes_at_start")), "crashed while it was probed: Aborted");
  EXPECT_CONTAINS(reasonFor(add("exits_at_start")), "ended the process while it was probed");
}

TEST_F(BrokenPlugins, fault26_a_static_initialiser_that_loops_or_sleeps_meets_its_own_limit) {
  const auto reason = [&](const char* name, ProbeLimits limits) {
    return Probe(fs::path(SAMPLE_PLUGINS) / (std::string(name) + ".so"), limits).collect().reason;
  };
  using namespace std::chrono_literals;
  EXPECT_CONTAINS(reason("loops_at_start", {1s, 60s}), "within 1 s of processor time");
  EXPECT_EQ(reason("sleeps_at_start", {1s, 2s}), "did not finish loading within 2 s");
  EXPECT_EQ(reason("good", {}), "");
}

TEST_F(BrokenPlugins, ABadTonemapperText) {
  writeText(folder / "plugins/film.glsl", "// @id a.b\n// @param float\n");
  EXPECT_CONTAINS(reasonFor("film.glsl"), "line 2");
}

TEST_F(BrokenPlugins, OfDuplicateIdsTheHighestVersionWinsAndTheOtherSaysSo) {
  add("good");
  add("newer");
  const PluginHost plugins = host();
  ASSERT_EQ(plugins.contributions(Kind::importer).size(), 1u);
  EXPECT_EQ(plugins.contributions(Kind::importer)[0]->version, "1.10");
  EXPECT_FALSE(plugins.files()[0].loaded);
  EXPECT_CONTAINS(plugins.files()[0].reason, "org.example.sample 1.9 gives way to 1.10 in ");
}

TEST_F(BrokenPlugins, OfEqualVersionsTheFirstFolderWins) {
  add("good");
  fs::create_directory(folder / "more");
  fs::copy_file(folder / "plugins/good.so", folder / "more/good.so");
  const PluginHost plugins({folder / "more", folder / "plugins"});
  EXPECT_TRUE(plugins.files()[0].loaded);
  EXPECT_EQ(plugins.files()[0].path.parent_path().filename(), "more");
  EXPECT_FALSE(plugins.files()[1].loaded);
}

TEST_F(BrokenPlugins, AGoodImporterImportsAndReports) {
  add("good");
  writeText(folder / "a.sample", "");
  const ImportResult result = host().importScene(folder / "a.sample");
  EXPECT_EQ(result.scene.objects.at(0).name, "Ball");
  EXPECT_EQ(result.scene.nextId, Id{2});
  EXPECT_EQ(result.report.notKept.at(0).what, "fog");
}

TEST_F(BrokenPlugins, AThrowingImporterCostsOneLineThatNamesIt) {
  add("throws");
  EXPECT_CONTAINS(importing("x"), "plugin org.example.sample 1.0 failed: its table is full");
  EXPECT_EQ(lastCode, ExitCode::plugin);
  EXPECT_CONTAINS(importing("int"), "threw an exception that is not a std::exception");
  EXPECT_EQ(importing("bad"), (folder / "a.sample").string() + ": line 1: expected a sphere");
  EXPECT_EQ(lastCode, ExitCode::badInput);
}

TEST_F(BrokenPlugins, GarbageFromAnImporterIsRefusedAsAWhole) {
  add("garbage");
  EXPECT_CONTAINS(importing("x"), "object #1.name: is not valid UTF-8");
  EXPECT_EQ(lastCode, ExitCode::badInput);
}

TEST_F(BrokenPlugins, AFolderThatDoesNotExistIsNoFault) {
  EXPECT_TRUE(PluginHost({folder / "nowhere", folder / "plugins"}).files().empty());
}

}  // namespace
}  // namespace steradian::plugins
