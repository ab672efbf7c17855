// What is behind beespace_io_points.
#pragma once

#include "c_io/facts.hpp"
#include "c_io/texts.hpp"
#include "io/points/loaded_points.hpp"

#include <beespace_io.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_io_points {
  // Without the records: the file may change once it is read.
  beespace::io::LoadedPoints loaded;
  std::string path;
  std::vector<std::int64_t> rows;
  std::optional<beespace::c_io::Texts> ids;
  std::vector<double> degrees;  // three a point; none of metres
  beespace_io_facts facts;
};
