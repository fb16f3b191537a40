// SPDX-License-Identifier: MIT
// What is made of something shared and immutable: once, and kept as long as someone holds the original.
#pragma once
#include <map>
#include <memory>
#include <mutex>

namespace steradian {

/// Made things by the identity of their source. Any thread.
template <class Source, class Made>
class IdentityCache {
 public:
  /// The one there is, else make(). Nobody waits for another's making: two threads that ask for the same new
  /// thing at once both make it, and the first one's stays.
  template <class Make>
  std::shared_ptr<const Made> of(const std::shared_ptr<const Source>& source, const Make& make) {
    if (auto known = find(source.get())) return known;
    auto fresh = std::make_shared<const Made>(make());
    const std::lock_guard lock(mutex_);
    Entry& entry = entries_[source.get()];
    if (!entry.made || entry.source.expired()) entry = {source, std::move(fresh)};
    return entry.made;
  }

  /// Null when it was not made yet.
  std::shared_ptr<const Made> find(const Source* source) const {
    const std::lock_guard lock(mutex_);
    const auto found = entries_.find(source);
    // Another source may have come to lie where one that died was.
    return found == entries_.end() || found->second.source.expired() ? nullptr : found->second.made;
  }

  /// What was made of sources that nobody holds any more.
  void forgetUnused() {
    const std::lock_guard lock(mutex_);
    std::erase_if(entries_, [](const auto& entry) { return entry.second.source.expired(); });
  }

 private:
  struct Entry {
    std::weak_ptr<const Source> source;
    std::shared_ptr<const Made> made;
  };
  mutable std::mutex mutex_;
  std::map<const Source*, Entry> entries_;
};

}  // namespace steradian
