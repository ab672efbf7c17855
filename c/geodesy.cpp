// From degrees to metres.
#include <beespace/geodesy.hpp>

#include "c/door/door.hpp"
#include "c/door/points.hpp"
#include "c/door/structs.hpp"

#include <beespace/point.hpp>

#include <cstddef>
#include <span>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Point;
using beespace::PointsView;
using beespace::Result;
using beespace::Status;

// Coordinates are written in place, through a Point of three of them.
static_assert(sizeof(Point) == 3 * sizeof(double) && alignof(Point) == alignof(double));

extern "C" {

beespace_code beespace_to_ecef(const beespace_points* positions, double* xyz,
                               beespace_error* error) {
  return enter(error, [&]() -> Status {
    const Result<PointsView> view = view_of(positions, "positions");
    if (!view) return view.error();
    if (view->empty()) return std::monostate{};
    if (positions->z == nullptr) {
      return invalid("z is NULL: say the heights above the ellipsoid, if only 0 with a stride of 0",
                     "positions");
    }
    if (xyz == nullptr) return invalid("the pointer to the coordinates is NULL", "xyz");
    if (!is_aligned(xyz)) {
      return invalid("coordinates are not aligned as doubles are", "xyz");
    }
    Status status = beespace::to_ecef(*view, {reinterpret_cast<Point*>(xyz), view->size()});
    if (status) return status;
    beespace::Error wrong = std::move(status).error();
    wrong.location.array = "positions";
    return wrong;
  });
}

}  // extern "C"
