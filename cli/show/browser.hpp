// The browser of the user who sits here.
#pragma once

#include <functional>
#include <string>

namespace beespace::cli {

// Asks the desktop to open an address, and returns at once: some desktops stay with the browser
// until it is closed, and it has to be answered meanwhile. `tell` is called once, with whether the
// desktop does it: here where there is no desktop or nothing to ask, otherwise from another thread,
// as soon as the desktop has said so, or nothing for a while. Ctrl-C does not reach the browser.
void open_in_browser(const std::string& address, const std::function<void(bool opened)>& tell);

}  // namespace beespace::cli
