/// @file
/// @brief The version of these headers (semantic versioning), and of the library that is linked.
#pragma once

#include <beespace/export.hpp>

#include <string_view>

/// @brief The major version of these headers.
#define BEESPACE_VERSION_MAJOR 0
/// @brief The minor version of these headers.
#define BEESPACE_VERSION_MINOR 1
/// @brief The patch version of these headers.
#define BEESPACE_VERSION_PATCH 0
/// @brief The version of these headers, "MAJOR.MINOR.PATCH".
#define BEESPACE_VERSION "0.1.0"

namespace beespace {

/// @brief Says the version of the library in use.
/// @return "MAJOR.MINOR.PATCH"; valid until the program ends.
BEESPACE_API std::string_view version();

}  // namespace beespace
