// What is behind beespace_engine: an Engine, and its answers in the widths of C++.
#pragma once

#include <beespace.h>
#include <beespace/conflict.hpp>
#include <beespace/engine.hpp>
#include <beespace/id_rows.hpp>
#include <beespace/nearest.hpp>
#include <beespace/pairs.hpp>
#include <beespace/point.hpp>

#include <cstdint>
#include <vector>

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_engine {
  beespace::Engine engine;
  std::vector<beespace::PointId> ids;
  std::vector<beespace::Pair> pairs;
  std::vector<beespace::Conflict> conflicts;
  std::vector<std::uint32_t> counts;
  std::vector<beespace::Nearest> nearest;
  beespace::IdRows rows;
  beespace::NearestRows nearest_rows;
};
