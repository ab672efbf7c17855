// How far from its path an agent can be.
#include <beespace/fleet.hpp>

#include "c/door/door.hpp"
#include "c/door/structs.hpp"
#include "c/guide/messages.hpp"
#include "c/guide/tube.hpp"

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::FleetFigures;
using beespace::LinkFigures;
using beespace::Result;
using beespace::Status;
using beespace::Tube;

namespace beespace::c {

Status write_tube(const Tube& tube, beespace_tube* into) {
  beespace_tube all{};
  all.radius_m = tube.radius_m;
  all.clock_m = tube.clock_m;
  all.error_m = tube.error_m;
  all.gain_per_s = tube.gain_per_s;
  all.correction_mps2 = tube.correction_mps2;
  all.correction_mps = tube.correction_mps;
  all.planned_speed_mps = tube.planned.max_speed_mps;
  all.planned_acceleration_mps2 = tube.planned.max_acceleration_mps2;
  return write_struct(into, all, "tube");
}

}  // namespace beespace::c

extern "C" {

beespace_code beespace_tube_of(const beespace_fleet_figures* figures,
                               const beespace_link_figures* link, double max_speed_mps,
                               double max_acceleration_mps2, beespace_tube* tube,
                               beespace_error* error) {
  return enter(error, [&]() -> Status {
    const Result<FleetFigures> all = figures_of(figures);
    if (!all) return all.error();
    const Result<LinkFigures> talk = link_of(link);
    if (!talk) return talk.error();
    const Result<Tube> found =
        beespace::tube_of(*all, *talk, {max_speed_mps, max_acceleration_mps2});
    return found ? write_tube(*found, tube) : Status(found.error());
  });
}

}  // extern "C"
