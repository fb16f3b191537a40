// SPDX-License-Identifier: MIT
// Signal handlers that only take a note.
#include "editor/cli/interruption.hpp"

namespace steradian::cli {

namespace {
constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
volatile std::sig_atomic_t caught = 0;  // a handler can reach nothing else
void take(int signal) {
  caught = signal;
}
}  // namespace

Interruption::Interruption() {
  caught = 0;
  struct sigaction action {};
  action.sa_handler = take;
  action.sa_flags = int(SA_RESETHAND | SA_RESTART);
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], nullptr, &previous_[i]);
    // nohup and background jobs ask for signals to stay ignored.
    if (previous_[i].sa_handler != SIG_IGN) sigaction(kSignals[i], &action, nullptr);
  }
}

Interruption::~Interruption() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &previous_[i], nullptr);
}

int Interruption::signal() const {
  return caught;
}

}  // namespace steradian::cli
