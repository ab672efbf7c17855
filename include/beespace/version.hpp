// The version of these headers (semantic versioning), and of the library that is linked.
#pragma once

#include <beespace/export.hpp>

#include <string_view>

#define BEESPACE_VERSION_MAJOR 0
#define BEESPACE_VERSION_MINOR 1
#define BEESPACE_VERSION_PATCH 0
#define BEESPACE_VERSION "0.1.0"

namespace beespace {

// The version of the library in use, "MAJOR.MINOR.PATCH".
BEESPACE_API std::string_view version();

}  // namespace beespace
