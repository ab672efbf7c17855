// From degrees to metres.
#include <beespace/geodesy.hpp>

#include "c/door/door.hpp"
#include "c/door/points.hpp"
#include "c/door/structs.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <span>
#include <utility>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Error;
using beespace::GeographicPosition;
using beespace::Point;
using beespace::PointsView;
using beespace::Result;
using beespace::Status;
using beespace::Velocity;

// Coordinates are written in place, through a Point of three of them.
static_assert(sizeof(Point) == 3 * sizeof(double) && alignof(Point) == alignof(double));

namespace {

// Calls convert(positions, as many points to be written), which returns a Status.
template <class Convert>
Status convert_all(const beespace_points* positions, double* xyz, Convert&& convert) {
  const Result<PointsView> view = view_of(positions, "positions");
  if (!view) return view.error();
  if (!view->empty()) {
    if (positions->z == nullptr) {
      return invalid("z is NULL: say the heights above the ellipsoid, if only 0 with a stride of 0",
                     "positions");
    }
    if (xyz == nullptr) return invalid("the pointer to the coordinates is NULL", "xyz");
    if (!is_aligned(xyz)) return invalid("coordinates are not aligned as doubles are", "xyz");
  }
  return convert(*view, std::span(reinterpret_cast<Point*>(xyz), view->size()));
}

Error at_row(Error error, const char* place, std::size_t row) {
  error.location.array = place;
  error.location.record = row;
  return error;
}

}  // namespace

extern "C" {

beespace_code beespace_to_ecef(const beespace_points* positions, double* xyz,
                               beespace_error* error) {
  return enter(error, [&]() -> Status {
    return convert_all(positions, xyz,
                       [](const PointsView& places, std::span<Point> into) -> Status {
                         if (into.empty()) return std::monostate{};
                         Status status = beespace::to_ecef(places, into);
                         if (status) return status;
                         Error wrong = std::move(status).error();
                         wrong.location.array = "positions";
                         return wrong;
                       });
  });
}

beespace_code beespace_to_ecef_velocity(const beespace_points* positions,
                                        const beespace_points* velocities, double* xyz,
                                        beespace_error* error) {
  return enter(error, [&]() -> Status {
    const Result<PointsView> speeds = view_of(velocities, "velocities");
    if (!speeds) return speeds.error();
    return convert_all(
        positions, xyz, [&](const PointsView& places, std::span<Point> into) -> Status {
          if (speeds->size() != places.size()) {
            return invalid("there is not one velocity for each position", "velocities");
          }
          for (std::size_t i = 0; i < into.size(); ++i) {
            const GeographicPosition place = {places[i].x, places[i].y, places[i].z};
            const Point v = (*speeds)[i];
            const Result<Velocity> turned = beespace::to_ecef_velocity(place, {v.x, v.y, v.z});
            if (turned) {
              into[i] = {turned->x, turned->y, turned->z};
              continue;
            }
            const bool possible = beespace::to_ecef(place).has_value();
            return at_row(turned.error(), possible ? "velocities" : "positions", i);
          }
          return std::monostate{};
        });
  });
}

}  // extern "C"
