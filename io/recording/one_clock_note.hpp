// What is said where times of several files that count from zeros of their own are compared, as if
// these were one.
#pragma once

#include <beespace/conflict.hpp>

#include <optional>
#include <span>
#include <string>

namespace beespace::io {

// Of the times of such files. `shift` is how to add to those of one file, or empty. Nothing where
// they begin together, as on one clock, or where none goes on beside another one.
std::optional<std::string> one_clock_note(std::span<const TimeSpan> files,
                                          const std::string& shift);

}  // namespace beespace::io
