// SPDX-License-Identifier: MIT
// Collecting requests; out of line because g++ 12 warns wrongly about inlined moves of variants.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include "editor/ui/ui.hpp"

namespace steradian::ui {

void Ui::ask(Request request) {
  requests.push_back(std::move(request));
}

void Ui::ask(Command command) {
  ask(Request(Run{command}));
}

}  // namespace steradian::ui
