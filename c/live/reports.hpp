// The caller's columns of reports, one report at a time.
#pragma once

#include "c/motion/fixes.hpp"

#include <beespace.h>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/swarm.hpp>

#include <cstddef>
#include <optional>

namespace beespace::c {

struct Reports {
  FixColumns columns;
  PointsView positions;
  std::optional<PointsView> velocities;
  bool planar = false;  // velocities have no third axis

  [[nodiscard]] std::size_t size() const { return positions.size(); }
  [[nodiscard]] PositionReport operator[](std::size_t row) const;
};

// `heights_apart` says whether the swarm wants heights.
Result<Reports> reports_of(const beespace_fixes* reports, const beespace_points* positions,
                           const beespace_points* velocities, bool heights_apart);

// C++ says which agent's report is refused; C says which row, and which of its arguments.
Error at_report(Error error, const PositionReport& report, std::size_t row);

}  // namespace beespace::c
