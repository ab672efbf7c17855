// What is behind beespace_recording.
#pragma once

#include "c/motion/fixes.hpp"

#include <beespace.h>

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_recording {
  beespace::c::Agents agents;
};
