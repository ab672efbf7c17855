// Reports as a program in C may hold them, and what a swarm of C answers as what C++ answers.
#pragma once

#include "tests/c/c_scenes.hpp"

#include <beespace.h>
#include <beespace/swarm.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace beespace::test {

struct CReport {
  std::int64_t id;
  double time_s;
  Point position;
  double velocity[3];  // NaN where it is not known
  double height;
  double climb;
};

// Views of them, to be given to beespace_swarm_update().
struct CReports {
  CReports(const std::vector<CReport>& reports, bool heights_apart) {
    constexpr auto kStride = static_cast<std::ptrdiff_t>(sizeof(CReport));
    fixes.struct_size = sizeof fixes;
    for (beespace_points* const points : {&positions, &velocities}) {
      *points = beespace_points_interleaved(nullptr, static_cast<std::int64_t>(reports.size()));
      points->x_stride = points->y_stride = points->z_stride = kStride;
    }
    if (reports.empty()) return;
    const CReport& first = reports.front();
    fixes.agents = &first.id;
    fixes.times_s = &first.time_s;
    fixes.agents_stride = fixes.times_stride = kStride;
    if (heights_apart) {
      fixes.heights_m = &first.height;
      fixes.climbs_mps = &first.climb;
      fixes.heights_stride = fixes.climbs_stride = kStride;
    }
    positions.x = &first.position.x;
    positions.y = &first.position.y;
    positions.z = &first.position.z;
    velocities.x = &first.velocity[0];
    velocities.y = &first.velocity[1];
    velocities.z = &first.velocity[2];
  }
  beespace_fixes fixes{};
  beespace_points positions{};
  beespace_points velocities{};
};

inline beespace_swarm_options c_swarm_options(double threshold_m) {
  beespace_swarm_options options{};
  options.struct_size = sizeof options;
  options.threshold_m = threshold_m;
  return options;
}

// What a report of C says to C++; `agent` is its id there.
inline PositionReport report_of(const CReport& report, AgentId agent) {
  PositionReport all{agent, report.time_s, report.position, {}, report.height, report.climb};
  if (!std::isnan(report.velocity[0])) {
    all.velocity = Velocity{report.velocity[0], report.velocity[1], report.velocity[2]};
  }
  return all;
}

}  // namespace beespace::test
