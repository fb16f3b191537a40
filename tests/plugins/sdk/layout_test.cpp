// SPDX-License-Identifier: MIT
// The binary layout of interface 1.0 is frozen: fields may be added at the end of a record, never moved.
#include <gtest/gtest.h>

#include <cstddef>

#include "steradian/plugin.hpp"

namespace steradian::sdk {
namespace {

TEST(Layout, OfInterface10DoesNotMove) {
  EXPECT_EQ(sizeof(Text), 16u);
  EXPECT_EQ(sizeof(PluginEntry), 24u);
  EXPECT_EQ(offsetof(PluginEntry, load), 16u);
  EXPECT_EQ(sizeof(VersionNote), 36u);
  EXPECT_EQ(sizeof(ParameterInfo), 96u);
  EXPECT_EQ(offsetof(FormatInfo, parameters), 88u);
  EXPECT_EQ(offsetof(ObjectRecord, name), 24u);
  EXPECT_EQ(offsetof(ObjectRecord, translation), 56u);
  EXPECT_EQ(offsetof(ObjectRecord, fovY), 176u);
  EXPECT_EQ(offsetof(ObjectRecord, outerConeAngle), 204u);
  EXPECT_EQ(offsetof(MaterialRecord, emissionLuminance), 80u);
  EXPECT_EQ(offsetof(RenderSettingsRecord, seed), 32u);
  EXPECT_EQ(offsetof(DisplaySettingsRecord, parameterCount), 40u);
  EXPECT_EQ(offsetof(ChannelRecord, keyCount), 24u);
  EXPECT_EQ(sizeof(Key), 40u);
  EXPECT_EQ(offsetof(SceneRecord, extras), 40u);
  EXPECT_EQ(offsetof(ImageRecord, metadataCount), 40u);
}

TEST(Layout, ARecordFromAnOlderPluginGetsDefaultsForWhatItLacks) {
  ObjectRecord old;
  old.radius = 7;
  old.fovY = 123;
  old.size = offsetof(ObjectRecord, fovY);
  const ObjectRecord ours = adopt(old);
  EXPECT_EQ(ours.radius, 7);
  EXPECT_EQ(ours.fovY, ObjectRecord{}.fovY);
  EXPECT_EQ(ours.size, sizeof(ObjectRecord));
}

TEST(Layout, ARecordFromANewerPluginIsCutToWhatIsKnown) {
  struct Newer {
    ObjectRecord known;
    double future = 5;
  } newer;
  newer.known.size = sizeof(Newer);
  newer.known.id = 9;
  EXPECT_EQ(adopt(newer.known).id, 9u);
  EXPECT_EQ(adopt(newer.known).size, sizeof(ObjectRecord));
}

}  // namespace
}  // namespace steradian::sdk
