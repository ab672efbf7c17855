// The browser of whoever sits here.
#pragma once

#include <string>

namespace beespace::cli {

// Asks the desktop to open an address; false where there is no desktop, or nothing to ask.
bool open_in_browser(const std::string& address);

}  // namespace beespace::cli
