// The caller's fixes, which stand in any order of agents, as one track for each agent.
#pragma once

#include "c/door/number_column.hpp"

#include <beespace.h>
#include <beespace/find_conflicts.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

namespace beespace::c {

// The caller's columns, checked for so many rows; heights and climb rates may be left out.
struct FixColumns {
  NumberColumn<std::int64_t> agents;
  NumberColumn<double> times_s;
  std::optional<NumberColumn<double>> heights_m;
  std::optional<NumberColumn<double>> climbs_mps;
  double height_unit_m;
};
Result<FixColumns> columns_of(const beespace_fixes* fixes, std::size_t size);

// In ascending order of their ids: track i is of agent ids[i].
struct Agents {
  std::vector<std::int64_t> ids;
  std::vector<Track> tracks;
  bool heights_apart = false;
  double height_unit_m = 1.0;
};

// All values are of the motion domain, and times of each agent ascend: else it is an error that
// names the row.
Result<Agents> agents_of(const beespace_fixes* fixes, const beespace_points* positions,
                         const std::stop_token& stop);

// Where fixes are farther apart in time than is bridged, as find_conflicts says it.
std::vector<Gap> gaps_of(const Agents& agents, double max_gap_s);

}  // namespace beespace::c
