// SPDX-License-Identifier: MIT
// An importer of ".wait" files that reads for ever: only cancelling ends it.
#include <chrono>
#include <thread>

#include <steradian/plugin.hpp>

namespace {

class Waiting final : public steradian::sdk::Importer {
 public:
  Waiting()
      : Importer({.id = "org.example.wait", .name = "Waiting", .version = "1.0", .extensions = ".wait"}) {}
  void import(steradian::sdk::Host& host, std::string_view, steradian::sdk::SceneSink&) override {
    host.progress(0.5);
    while (!host.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    throw steradian::sdk::Cancelled{};
  }
};

}  // namespace

STERADIAN_PLUGIN(registry) {
  registry.add<Waiting>();
}
