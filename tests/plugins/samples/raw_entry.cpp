// SPDX-License-Identifier: MIT
// An entry and a note with chosen numbers. Unless QUIET it aborts as soon as any of its code runs.
#include <cstdlib>
#include <steradian/plugin.hpp>

#ifndef NOTE_MINOR
#define NOTE_MINOR 0
#endif
#ifndef NOTE_SIZE
#define NOTE_SIZE sizeof(steradian::sdk::PluginEntry)
#endif
#ifndef NO_NOTE
__attribute__((section(".note.steradian"), used, aligned(4))) static const steradian::sdk::VersionNote note{
    .major = NOTE_MAJOR, .minor = NOTE_MINOR, .entrySize = NOTE_SIZE};
#else
#define ENTRY_MAJOR 1
#endif

static steradian::sdk::Status load(steradian::sdk::RegistryInterface&) noexcept {
  std::abort();
}

extern "C" __attribute__((visibility("default")))
const steradian::sdk::PluginEntry steradian_plugin{.major = ENTRY_MAJOR, .load = load};

#ifndef QUIET
static const int started = (std::abort(), 1);
#endif
