// Who is in the fleet of a guide, what its agents shall do, and what they say.
#include <beespace/guide.hpp>

#include "c/door/agents.hpp"
#include "c/door/door.hpp"
#include "c/door/movers.hpp"
#include "c/door/number_column.hpp"
#include "c/door/structs.hpp"
#include "c/guide/guide.hpp"
#include "c/guide/messages.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Intruder;
using beespace::JoinAnswer;
using beespace::JoinRequest;
using beespace::MoversView;
using beespace::Result;
using beespace::Status;

namespace {

constexpr MoverNames kIntruderArrays = {"positions", "velocities"};

Result<JoinRequest> request_of(const beespace_join_request* request) {
  const Result<beespace_join_request> given = read_struct(request, "request");
  if (!given) return given.error();
  JoinRequest all;
  all.agent = agent_id_of(given->agent);
  all.position = point_of(given->position);
  all.radius_m = given->radius_m;
  if (given->figures != nullptr) {
    const auto figures = figures_of(given->figures);
    if (!figures) return figures.error();
    all.figures = *figures;
  }
  if (given->max_speed_mps != 0.0 || given->max_acceleration_mps2 != 0.0) {
    all.limits = {given->max_speed_mps, given->max_acceleration_mps2};
  }
  all.promised = given->promised;
  return all;
}

template <class Number, class ToC>
const std::int64_t* kept(const std::vector<Number>& numbers, ToC&& to_c,
                         std::vector<std::int64_t>& in) {
  in.clear();
  for (const Number number : numbers) in.push_back(to_c(number));
  return in.empty() ? nullptr : in.data();
}

Status write_answer(const JoinAnswer& answer, beespace_guide& guide, beespace_join_answer* into) {
  beespace_join_answer shown{};
  shown.joined = answer.joined ? 1 : 0;
  const auto as_it_is = [](std::size_t index) { return static_cast<std::int64_t>(index); };
  shown.touches = kept(answer.touches, agent_number_of, guide.touches);
  shown.obstacles = kept(answer.obstacles, as_it_is, guide.near_obstacles);
  shown.fences = kept(answer.fences, as_it_is, guide.near_fences);
  shown.touch_count = static_cast<std::int64_t>(guide.touches.size());
  shown.obstacle_count = static_cast<std::int64_t>(guide.near_obstacles.size());
  shown.fence_count = static_cast<std::int64_t>(guide.near_fences.size());
  return write_struct(into, shown, "answer");
}

beespace_code ask_to_join(beespace_guide* guide, const beespace_join_request* request,
                          bool for_good, beespace_join_answer* answer, beespace_error* error) {
  return with_guide(guide, error, [&](beespace_guide& used) -> Status {
    const Result<JoinRequest> given = request_of(request);
    if (!given) return given.error();
    // First, so that none joins without an answer.
    Status can_answer = write_struct(answer, beespace_join_answer{}, "answer");
    if (!can_answer) return can_answer;
    const Result<JoinAnswer> found =
        for_good ? used.guide.join(*given) : used.guide.may_join(*given);
    return found ? write_answer(*found, used, answer) : Status(found.error());
  });
}

// Three numbers of the caller's, wherever these lie.
Result<std::array<double, 3>> three_of(const double* numbers, const char* name) {
  if (const char* const problem = NumberColumn(numbers).problem(3)) return invalid(problem, name);
  return std::array{numbers[0], numbers[1], numbers[2]};
}

// NULL: all are 0.
Status read_errors(const double* numbers, const char* name, double Intruder::*into,
                   std::vector<Intruder>& intruders) {
  if (numbers == nullptr || intruders.empty()) return std::monostate{};
  const NumberColumn column(numbers);
  if (const char* const problem = column.problem(intruders.size())) return invalid(problem, name);
  for (std::size_t i = 0; i < intruders.size(); ++i) intruders[i].*into = column[i];
  return std::monostate{};
}

}  // namespace

extern "C" {

beespace_code beespace_guide_join(beespace_guide* guide, const beespace_join_request* request,
                                  beespace_join_answer* answer, beespace_error* error) {
  return ask_to_join(guide, request, true, answer, error);
}

beespace_code beespace_guide_may_join(beespace_guide* guide, const beespace_join_request* request,
                                      beespace_join_answer* answer, beespace_error* error) {
  return ask_to_join(guide, request, false, answer, error);
}

beespace_code beespace_guide_adopt(beespace_guide* guide, const beespace_join_request* request,
                                   const beespace_stored_branch* stored, beespace_error* error) {
  return with_guide(guide, error, [&](beespace_guide& used) -> Status {
    const Result<JoinRequest> given = request_of(request);
    if (!given) return given.error();
    const auto branch = stored_of(stored);
    return branch ? used.guide.adopt(*given, *branch) : Status(branch.error());
  });
}

beespace_code beespace_guide_expect(beespace_guide* guide, const int64_t* agents, int64_t count,
                                    beespace_error* error) {
  return with_guide(guide, error, [&](beespace_guide& used) -> Status {
    if (count < 0) return invalid("count is below zero", "agents");
    const auto size = static_cast<std::size_t>(count);
    const NumberColumn column(agents);
    if (const char* const problem = size == 0 ? nullptr : column.problem(size)) {
      return invalid(problem, "agents");
    }
    std::vector<beespace::AgentId> ids;
    for (std::size_t i = 0; i < size; ++i) ids.push_back(agent_id_of(column[i]));
    used.guide.expect(ids);
    return std::monostate{};
  });
}

beespace_code beespace_guide_leave(beespace_guide* guide, int64_t agent, beespace_error* error) {
  return with_guide(guide, error,
                    [&](beespace_guide& used) { return used.guide.leave(agent_id_of(agent)); });
}

beespace_code beespace_guide_set_goal(beespace_guide* guide, int64_t agent, const double goal[3],
                                      beespace_error* error) {
  return with_guide(guide, error, [&](beespace_guide& used) -> Status {
    const auto place = three_of(goal, "goal");
    if (!place) return place.error();
    return used.guide.set_goal(agent_id_of(agent), {(*place)[0], (*place)[1], (*place)[2]});
  });
}

beespace_code beespace_guide_set_preferred(beespace_guide* guide, int64_t agent,
                                           const double velocity[3], beespace_error* error) {
  return with_guide(guide, error, [&](beespace_guide& used) -> Status {
    const auto speed = three_of(velocity, "velocity");
    if (!speed) return speed.error();
    return used.guide.set_preferred(agent_id_of(agent), {(*speed)[0], (*speed)[1], (*speed)[2]});
  });
}

beespace_code beespace_guide_take_report(beespace_guide* guide, const beespace_agent_report* report,
                                         beespace_error* error) {
  return with_guide(guide, error, [&](beespace_guide& used) -> Status {
    const auto given = report_of(report);
    return given ? used.guide.take(*given) : Status(given.error());
  });
}

beespace_code beespace_guide_take_acknowledgement(beespace_guide* guide,
                                                  const beespace_acknowledgement* acknowledgement,
                                                  beespace_error* error) {
  return with_guide(guide, error, [&](beespace_guide& used) -> Status {
    const auto given = acknowledgement_of(acknowledgement);
    return given ? used.guide.take(*given) : Status(given.error());
  });
}

beespace_code beespace_guide_set_intruders(beespace_guide* guide, const beespace_points* positions,
                                           const beespace_points* velocities, const double* radii_m,
                                           const double* position_errors_m,
                                           const double* speed_errors_mps, beespace_error* error) {
  return with_guide(guide, error, [&](beespace_guide& used) -> Status {
    const Result<MoversView> movers = movers_of(positions, velocities, kIntruderArrays);
    if (!movers) return movers.error();
    std::vector<Intruder> intruders(movers->size());
    for (std::size_t i = 0; i < intruders.size(); ++i) intruders[i].mover = (*movers)[i];
    Status read = read_errors(radii_m, "radii", &Intruder::radius_m, intruders);
    if (!read) return read;
    read =
        read_errors(position_errors_m, "position_errors", &Intruder::position_error_m, intruders);
    if (!read) return read;
    read = read_errors(speed_errors_mps, "speed_errors", &Intruder::speed_error_mps, intruders);
    return read ? used.guide.set_intruders(intruders) : read;
  });
}

}  // extern "C"
