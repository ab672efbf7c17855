// What is behind beespace_out_of_core.
#pragma once

#include <beespace.h>
#include <beespace/out_of_core.hpp>

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_out_of_core {
  beespace::OutOfCore search;
  double height_unit_m;
};
