// When two movers are closest, of many twos.
#include <beespace/closest_approach.hpp>

#include "c/door/movers.hpp"
#include "c/door/options.hpp"
#include "c/door/question.hpp"

#include <cstddef>
#include <limits>
#include <utility>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Approach;
using beespace::ApproachOptions;
using beespace::Error;
using beespace::MoversView;
using beespace::Result;
using beespace::RunOptions;
using beespace::Status;

namespace {

constexpr MoverNames kOtherMovers = {"other_positions", "other_velocities"};
// Often enough to end soon, seldom enough to cost nothing.
constexpr std::size_t kApproachesBetweenStops = 1024;

struct TwoMovers {
  MoversView first;
  MoversView second;
};

Result<TwoMovers> both_of(const beespace_points* positions, const beespace_points* velocities,
                          const beespace_points* other_positions,
                          const beespace_points* other_velocities) {
  const Result<MoversView> first = movers_of(positions, velocities, kMovers);
  if (!first) return first.error();
  const Result<MoversView> second = movers_of(other_positions, other_velocities, kOtherMovers);
  if (!second) return second.error();
  if (first->size() != second->size()) {
    return invalid("there is not one other mover for each mover; a stride of 0 repeats one",
                   kOtherMovers.positions);
  }
  return TwoMovers{*first, *second};
}

struct AskedApproach {
  ApproachOptions options;
  bool conflicts = false;  // whether a threshold was given
};

Result<AskedApproach> asked_of(const beespace_search* search, double horizon_s) {
  AskedApproach asked;
  asked.options.horizon_s = horizon_s;
  if (search == nullptr) {
    asked.options.threshold_m = 1.0;  // any: what comes of it is not shown
    return asked;
  }
  const Result<Search> given = search_of(search, kWithin);
  if (!given) return given.error();
  asked.options.threshold_m = given->options.threshold_m;
  asked.options.vertical_m = given->options.vertical_m;
  asked.options.inclusive = given->options.inclusive;
  asked.conflicts = true;
  return asked;
}

Status write_approaches(const TwoMovers& movers, const AskedApproach& asked, const RunOptions& run,
                        beespace_result& into) {
  constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
  const std::size_t size = movers.first.size();
  into.closest_s.resize(size);
  into.distances_m.resize(size);
  into.begins_s.resize(asked.conflicts ? size : 0);
  into.ends_s.resize(asked.conflicts ? size : 0);
  if (size == 0) {  // options are checked all the same
    const Result<Approach> any = beespace::closest_approach({}, {}, asked.options);
    return any ? Status(std::monostate{}) : Status(any.error());
  }
  for (std::size_t i = 0; i < size; ++i) {
    if (i % kApproachesBetweenStops == 0 && run.stop.stop_requested()) {
      return Error{beespace::ErrorCode::kStopped, "a stop was requested", {}};
    }
    const Result<Approach> found =
        beespace::closest_approach(movers.first[i], movers.second[i], asked.options);
    if (!found) {
      Error error = found.error();
      if (!error.location.record) return error;
      const bool first = std::exchange(error.location.record, i) == 0;
      return first ? with_array(std::move(error), movers.first, kMovers)
                   : with_array(std::move(error), movers.second, kOtherMovers);
    }
    into.closest_s[i] = found->closest_s;
    into.distances_m[i] = found->closest_m;
    if (!asked.conflicts) continue;
    into.begins_s[i] = found->conflict ? found->conflict->begins_s : kNever;
    into.ends_s[i] = found->conflict ? found->conflict->ends_s : kNever;
  }
  return std::monostate{};
}

}  // namespace

extern "C" {

beespace_code beespace_closest_approach(const beespace_points* positions,
                                        const beespace_points* velocities,
                                        const beespace_points* other_positions,
                                        const beespace_points* other_velocities,
                                        const beespace_search* search, double horizon_s,
                                        const beespace_run* run, beespace_result* result,
                                        beespace_error* error) {
  return answer_into(result, error, [&]() -> Status {
    const Result<TwoMovers> movers =
        both_of(positions, velocities, other_positions, other_velocities);
    if (!movers) return movers.error();
    return call_watched(run, [&](const RunOptions& options) -> Status {
      const Result<AskedApproach> asked = asked_of(search, horizon_s);
      if (!asked) return asked.error();
      return write_approaches(*movers, *asked, options, *result);
    });
  });
}

}  // extern "C"
