// The fastest flights to goals.
#include <beespace/advise.hpp>

#include "c/advice/options.hpp"
#include "c/door/door.hpp"
#include "c/door/points.hpp"
#include "c/door/structs.hpp"

#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Error;
using beespace::FlightLimits;
using beespace::Point;
using beespace::PointsView;
using beespace::Result;
using beespace::Status;
using beespace::Velocity;

namespace {

bool can_be_place(const Point& place) {
  return std::abs(place.x) <= beespace::kLargestInMotion &&
         std::abs(place.y) <= beespace::kLargestInMotion &&
         std::abs(place.z) <= beespace::kLargestInMotion;
}

// C++ knows of one agent; C also says which, and which of its arrays that is about.
Error about_agent(Error error, const Point& position, const Point& goal, std::size_t agent,
                  bool own_limits) {
  if (!can_be_place(position) || !can_be_place(goal)) {
    error.location.array = can_be_place(position) ? "goals" : "positions";
    error.location.record = agent;
  } else if (own_limits) {
    error.location.array = "limits";
    error.location.record = agent;
  }
  return error;
}

Status write_velocities(const PointsView& positions, const PointsView& goals,
                        const std::vector<FlightLimits>& limits, double step_s, double* xyz) {
  const bool own_limits = limits.size() > 1;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Result<Velocity> velocity =
        beespace::velocity_to_goal(positions[i], goals[i], limits[own_limits ? i : 0], step_s);
    if (!velocity) {
      return about_agent(velocity.error(), positions[i], goals[i], i, own_limits);
    }
    xyz[3 * i] = velocity->x;
    xyz[3 * i + 1] = velocity->y;
    xyz[3 * i + 2] = velocity->z;
  }
  return std::monostate{};
}

}  // namespace

extern "C" {

beespace_code beespace_velocity_to_goal(const beespace_points* positions,
                                        const beespace_points* goals, const beespace_limits* limits,
                                        double step_s, double* xyz, beespace_error* error) {
  return enter(error, [&]() -> Status {
    const Result<PointsView> from = view_of(positions, "positions");
    if (!from) return from.error();
    const Result<PointsView> to = view_of(goals, "goals");
    if (!to) return to.error();
    if (from->size() != to->size()) {
      return invalid("there is not one goal for each position; a stride of 0 repeats one", "goals");
    }
    std::vector<FlightLimits> all_limits;
    Status read = read_limits(limits, from->size(), all_limits);
    if (!read) return read;
    const double step = given_or(step_s, beespace::AdviseOptions().step_s);
    // What is said once for all is checked first, and also where there is no agent.
    const FlightLimits of_all = all_limits.size() > 1 ? FlightLimits() : all_limits.front();
    const Result<Velocity> any = beespace::velocity_to_goal({}, {}, of_all, step);
    if (!any) return any.error();
    if (from->empty()) return std::monostate{};
    if (xyz == nullptr) return invalid("the pointer to the velocities is NULL", "xyz");
    if (!is_aligned(xyz)) {
      return invalid("the memory for velocities is not aligned as doubles are", "xyz");
    }
    return write_velocities(*from, *to, all_limits, step, xyz);
  });
}

}  // extern "C"
