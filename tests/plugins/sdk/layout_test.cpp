// SPDX-License-Identifier: MIT
// The binary layout of interface 1.0 is frozen: fields may be added at the end of a record, never moved.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>

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
  EXPECT_EQ(offsetof(ImageRecord, layerCount), 56u);
  EXPECT_EQ(sizeof(LayerRecord), 40u);
}

TEST(Layout, OfInterface11BeginsWhereInterface10Ended) {
  EXPECT_EQ(offsetof(ObjectRecord, imageFile), 208u);
  EXPECT_EQ(offsetof(ObjectRecord, ground), 272u);
  EXPECT_EQ(offsetof(MaterialRecord, transmission), 88u);
  EXPECT_EQ(offsetof(MaterialRecord, edgeTint), 116u);
  EXPECT_EQ(offsetof(RenderSettingsRecord, energyCompensation), 36u);
  EXPECT_EQ(offsetof(DisplaySettingsRecord, physical), 48u);
}

TEST(Layout, OfInterface12BeginsWhereInterface11Ended) {
  EXPECT_EQ(offsetof(ObjectRecord, mesh), 284u);  // was padding that 1.1 left 0
  EXPECT_EQ(sizeof(ObjectRecord), 288u);
  EXPECT_EQ(offsetof(MaterialRecord, albedoTexture), 128u);
  EXPECT_EQ(offsetof(MaterialRecord, thinWalled), 320u);
  EXPECT_EQ(sizeof(MaterialRecord), 328u);
  EXPECT_EQ(sizeof(TextureSlotRecord), 44u);
  EXPECT_EQ(sizeof(MeshRecord), 96u);
  EXPECT_EQ(sizeof(TextureRecord), 56u);
}

/// `Record` as a plugin of interface 1.0 makes it: `size` bytes long, garbage beyond.
template <class Record>
Record ofSize(Record record, std::uint32_t size) {
  std::memset(reinterpret_cast<char*>(&record) + size, 0x5a, sizeof record - size);
  record.size = size;
  return record;
}

TEST(Layout, RecordsOfInterface10GetDefaultsForEveryNewField) {
  ObjectRecord object{.id = 7, .kind = ObjectKind::camera};
  object.outerConeAngle = 0.5f;
  const ObjectRecord o = adopt(ofSize(object, 208));
  EXPECT_EQ(o.outerConeAngle, 0.5f);
  EXPECT_EQ(o.imageFile.size, 0u);
  EXPECT_EQ(o.orthographicHeight, 2.0);
  EXPECT_EQ(o.fNumber, 0.0);
  EXPECT_EQ(o.focusDistance, 5.0);
  EXPECT_EQ(o.projection, 0u);
  EXPECT_EQ(o.temperature, 0.0f);
  EXPECT_EQ(o.angularDiameter, 0.0f);
  EXPECT_EQ(o.ground[2], 1.0f);
  MaterialRecord material{.id = 8, .emissionLuminance = 3};
  const MaterialRecord m = adopt(ofSize(material, 88));
  EXPECT_EQ(m.emissionLuminance, 3.0f);
  EXPECT_EQ(m.transmission, 0.0f);
  EXPECT_EQ(m.attenuationColor[0], 1.0f);
  EXPECT_EQ(m.attenuationDistance, 0.0f);
  EXPECT_EQ(m.clearcoat, 0.0f);
  EXPECT_EQ(m.clearcoatRoughness, 0.0f);
  EXPECT_EQ(m.edgeTint[2], 1.0f);
  const RenderSettingsRecord r = adopt(ofSize(RenderSettingsRecord{.seed = 9}, 36));
  EXPECT_EQ(r.seed, 9u);
  EXPECT_EQ(r.energyCompensation, 1u);
  EXPECT_EQ(r.clamp, 0.0f);
  const DisplaySettingsRecord d = adopt(ofSize(DisplaySettingsRecord{.exposure = 2}, 48));
  EXPECT_EQ(d.exposure, 2.0f);
  EXPECT_EQ(d.physical, 0u);
  EXPECT_EQ(d.ev100, 0.0f);
}

TEST(Layout, WhatAnOldPluginLeavesInItsPaddingIsNotTakenForAValue) {
  MaterialRecord material{.id = 8};
  std::memset(reinterpret_cast<char*>(&material) + 84, 0xff, 4);
  material.size = 88;
  EXPECT_EQ(adopt(material).transmission, 0.0f);
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
