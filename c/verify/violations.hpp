// What is behind beespace_violations.
#pragma once

#include "c/door/result.hpp"

#include <beespace.h>
#include <beespace/verify.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_violations {
  beespace::c::Column<std::int32_t> kinds;
  beespace::c::Column<std::int64_t> first;
  beespace::c::Column<std::int64_t> second;
  beespace::c::Column<double> begins_s;
  beespace::c::Column<double> ends_s;
  beespace::c::Column<double> values;

  void resize(std::size_t size);
};

namespace beespace::c {

// `breach_ends_s` has an entry for each breach of the verdict.
void write_violations(const Verdict& verdict, std::span<const double> breach_ends_s,
                      beespace_violations& into);

}  // namespace beespace::c
