/// @file
/// @brief Marks what the shared library exports; all other symbols stay hidden.
#pragma once

/// @brief Marks a function or class that the shared library exports. Define BEESPACE_STATIC to use
/// the static library.
#if defined(BEESPACE_STATIC)
#define BEESPACE_API
#else
#define BEESPACE_API __attribute__((visibility("default")))
#endif
