// SPDX-License-Identifier: MIT
// A tiny importer of ".sample" files, with faults chosen at build time.
#include <unistd.h>

#include <cstdlib>
#include <limits>
#include <steradian/plugin.hpp>

namespace {

[[maybe_unused]] int loop() {
  for (volatile bool endless = true; endless;) {
  }
  return 0;
}
#ifdef START
const int started = (START, 1);
#endif
#ifdef UNDEFINED_SYMBOL
extern "C" int steradian_test_symbol_that_nobody_defines();
#endif

class Sample final : public steradian::sdk::Importer {
 public:
  Sample()
      : Importer({.id = "org.example.sample",
                  .name = "Sample",
                  .version = VERSION_TEXT,
                  .extensions = ".sample"}) {}
  void import(steradian::sdk::Host& host, std::string_view bytes, steradian::sdk::SceneSink& sink) override {
    if (bytes == "bad") throw steradian::sdk::BadInput("line 1: expected a sphere");
    if (bytes == "cancelled" && host.cancelled()) throw steradian::sdk::Cancelled{};
#ifdef THROWS
    if (bytes == "int") throw 42;
    throw std::runtime_error("its table is full");
#endif
#ifdef UNDEFINED_SYMBOL
    steradian_test_symbol_that_nobody_defines();
#endif
    host.notKept("fog", "there is no such thing yet");
    steradian::sdk::ObjectRecord ball{.id = 1, .kind = steradian::sdk::ObjectKind::sphere, .name = "Ball"};
#ifdef GARBAGE
    ball.translation[1] = std::numeric_limits<double>::quiet_NaN();
    ball.name = "\xff\xfe";
    ball.material = 77;
    ball.kind = steradian::sdk::ObjectKind{4711};
#endif
    sink.addObject(ball);
  }
};

}  // namespace

STERADIAN_PLUGIN(registry) {
  registry.add<Sample>();
}
