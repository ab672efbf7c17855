// What is behind beespace_out_of_core.
#pragma once

#include <beespace.h>
#include <beespace/out_of_core.hpp>
#include <beespace/result.hpp>

namespace beespace::c {

// Errors: kInvalidArgument.
Result<OutOfCoreOptions> options_of(const beespace_out_of_core_options& given);

}  // namespace beespace::c

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_out_of_core {
  beespace::OutOfCore search;
  double height_unit_m;
};
