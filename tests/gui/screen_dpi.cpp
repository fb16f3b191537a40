// SPDX-License-Identifier: MIT
// The resource that desktops tell programs a monitor's density by; apart, because Xlib defines macros.
#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <stdexcept>

#include "tests/gui/processes.hpp"

namespace steradian::test {

void Screen::setDpi(int dpi) {
  ::Display* server = XOpenDisplay(display_.c_str());
  if (!server) throw std::runtime_error("the display " + display_ + " cannot be opened");
  const std::string resources = "Xft.dpi:\t" + std::to_string(dpi) + "\n";
  XChangeProperty(server, DefaultRootWindow(server), XA_RESOURCE_MANAGER, XA_STRING, 8, PropModeReplace,
                  reinterpret_cast<const unsigned char*>(resources.data()), int(resources.size()));
  XCloseDisplay(server);
}

}  // namespace steradian::test
