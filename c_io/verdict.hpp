// What is behind beespace_io_verdict.
#pragma once

#include "analysis/recorded/verify_paths.hpp"

#include <beespace_io.h>

#include <cstdint>
#include <string>
#include <vector>

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_io_verdict {
  beespace_io_verdict_facts facts;
  beespace_io_coverage coverage;
  std::vector<std::int32_t> kinds;
  std::vector<std::int64_t> first;
  std::vector<std::int64_t> second;
  std::vector<double> begins_s;
  std::vector<double> ends_s;
  std::vector<double> values;
  std::vector<double> at_s;
  std::string not_looked_at;  // joined by commas
};

namespace beespace::c_io {

// The columns of what was found, and how many there are of each kind.
void write_findings(const analysis::PathVerdict& found, beespace_io_verdict& into);

// The greatest values, and who came closest.
void write_extremes(const analysis::PathVerdict& found, beespace_io_verdict_facts& into);

}  // namespace beespace::c_io
