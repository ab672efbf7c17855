#include "c/door/movers.hpp"

#include "c/door/door.hpp"
#include "c/door/points.hpp"

#include <beespace/points_view.hpp>

#include <cmath>
#include <utility>

namespace beespace::c {

Result<MoversView> movers_of(const beespace_points* positions, const beespace_points* velocities,
                             const MoverNames& names) {
  const Result<PointsView> places = view_of(positions, names.positions);
  if (!places) return places.error();
  const Result<PointsView> speeds = view_of(velocities, names.velocities);
  if (!speeds) return speeds.error();
  if (places->size() != speeds->size()) {
    return invalid("there is not one velocity for each position", names.velocities);
  }
  return MoversView(*places, *speeds);
}

Error with_array(Error error, const MoversView& movers, const MoverNames& names) {
  if (error.location.array != "movers") return error;
  error.location.array = names.positions;
  if (!error.location.record) return error;
  const auto is_possible = [](double value) { return std::abs(value) <= kLargestInMotion; };
  const Point at = movers.positions()[*error.location.record];
  const bool possible = is_possible(at.x) && is_possible(at.y) && is_possible(at.z);
  if (possible) error.location.array = names.velocities;
  return error;
}

}  // namespace beespace::c
