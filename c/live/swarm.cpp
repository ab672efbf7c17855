// Live swarms: reports in, events out.
#include <beespace/swarm.hpp>

#include "c/door/agents.hpp"
#include "c/door/door.hpp"
#include "c/door/structs.hpp"
#include "c/door/watched_call.hpp"
#include "c/live/events.hpp"
#include "c/live/known_movers.hpp"
#include "c/live/reports.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Error;
using beespace::ErrorCode;
using beespace::PositionReport;
using beespace::Result;
using beespace::Status;
using beespace::Swarm;
using beespace::SwarmCounts;
using beespace::SwarmEvent;
using beespace::SwarmOptions;

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_swarm {
  explicit beespace_swarm(const SwarmOptions& options)
      : swarm(options), heights_apart(options.heights_apart) {}
  Swarm swarm;
  bool heights_apart;
  std::vector<SwarmEvent> events;
};

namespace {

constexpr std::uint32_t kKnownSwarmFlags = BEESPACE_SWARM_VERTICAL | BEESPACE_SWARM_HEIGHTS_APART |
                                           BEESPACE_SWARM_HORIZON | BEESPACE_SWARM_MAX_SPEED;

// Sets an option where it is not the zero of a default.
template <class To, class From>
void set_unless_zero(To& option, From given) {
  if (given != From{0}) option = static_cast<To>(given);
}

std::optional<Error> set_flagged(SwarmOptions& options, const beespace_swarm_options& given) {
  const auto has = [&](std::uint32_t flag) { return (given.flags & flag) != 0; };
  if (has(BEESPACE_SWARM_VERTICAL)) options.vertical_m = given.vertical_m;
  if (has(BEESPACE_SWARM_HORIZON)) options.horizon_s = given.horizon_s;
  if (has(BEESPACE_SWARM_MAX_SPEED)) options.max_speed_mps = given.max_speed_mps;
  options.heights_apart = has(BEESPACE_SWARM_HEIGHTS_APART);
  if ((given.flags & ~kKnownSwarmFlags) != 0) {
    return invalid("flags ask for what a swarm cannot do", "options");
  }
  const bool forgotten = (!has(BEESPACE_SWARM_VERTICAL) && given.vertical_m != 0.0) ||
                         (!has(BEESPACE_SWARM_HORIZON) && given.horizon_s != 0.0) ||
                         (!has(BEESPACE_SWARM_MAX_SPEED) && given.max_speed_mps != 0.0);
  if (!forgotten) return std::nullopt;
  return invalid(
      "vertical_m, horizon_s or max_speed_mps is given without its flag, as "
      "BEESPACE_SWARM_VERTICAL is one",
      "options");
}

Result<SwarmOptions> swarm_options_of(const beespace_swarm_options* given_options) {
  const Result<beespace_swarm_options> given = read_struct(given_options, "options");
  if (!given) return given.error();
  SwarmOptions options;
  if (auto error = set_flagged(options, *given)) return *std::move(error);
  options.threshold_m = given->threshold_m;
  options.threads = threads_of(given->threads);
  set_unless_zero(options.leave_factor, given->leave_factor);
  set_unless_zero(options.max_age_s, given->max_age_s);
  set_unless_zero(options.height_unit_m, given->height_unit_m);
  set_unless_zero(options.max_agents, given->max_agents);
  set_unless_zero(options.max_pairs, given->max_pairs);
  // A swarm says with its first call what is wrong with its options: the caller hears it now.
  SwarmOptions alone = options;
  alone.threads = 1;
  const Result<std::vector<SwarmEvent>> tried = Swarm(alone).advance(0.0);
  if (!tried) {
    Error error = tried.error();
    error.location.array = "options";
    return error;
  }
  return options;
}

Error no_swarm() {
  return invalid("the pointer to the swarm is NULL", "swarm");
}

// The first error of a report, or how many were refused.
struct Refused {
  std::optional<Error> first;
  std::int64_t count = 0;
};

Refused take_all(Swarm& swarm, const Reports& reports) {
  Refused refused;
  for (std::size_t row = 0; row < reports.size(); ++row) {
    const PositionReport report = reports[row];
    Status status = swarm.update(report);
    if (status) continue;
    ++refused.count;
    if (!refused.first) refused.first = at_report(std::move(status).error(), report, row);
  }
  return refused;
}

// Calls change(swarm, agent) for each id.
template <class Change>
beespace_code change_agents(beespace_swarm* swarm, const std::int64_t* ids, std::int64_t count,
                            beespace_error* error, Change&& change) {
  return enter(error, [&]() -> Status {
    if (swarm == nullptr) return no_swarm();
    if (count < 0) return invalid("count is below zero", "ids");
    if (ids == nullptr && count > 0) return invalid("this is NULL, but there are ids", "ids");
    if (!is_aligned(ids)) return invalid("ids are not aligned as their type is", "ids");
    for (std::int64_t i = 0; i < count; ++i) change(swarm->swarm, agent_id_of(ids[i]));
    return std::monostate{};
  });
}

// Calls make(swarm, its events), which returns a Status; the caller's events are complete or none.
template <class Make>
beespace_code make_events(beespace_swarm* swarm, beespace_events* events, beespace_error* error,
                          Make&& make) {
  if (events != nullptr) events->resize(0);
  return enter(error, [&]() -> Status {
    if (swarm == nullptr) return no_swarm();
    if (events == nullptr) return invalid("the pointer to the events is NULL", "events");
    Status status = make(swarm->swarm, swarm->events);
    if (status) write_events(swarm->events, *events);
    return status;
  });
}

Status keep(Result<std::vector<SwarmEvent>> made, std::vector<SwarmEvent>& events) {
  if (!made) return std::move(made).error();
  events = *std::move(made);
  return std::monostate{};
}

beespace_counts counts_of(const SwarmCounts& now) {
  beespace_counts counts{};
  counts.taken = now.taken;
  counts.repeated = now.repeated;
  counts.late = now.late;
  counts.contrary = now.contrary;
  counts.refused = now.refused;
  counts.agents = now.agents;
  counts.stale = now.stale;
  counts.heard_once = now.heard_once;
  counts.predicted = now.predicted;
  counts.unknown_s = now.unknown_s;
  counts.missed_s = now.missed_s;
  return counts;
}

std::optional<Error> check_moment(double time_s) {
  if (std::abs(time_s) <= beespace::kLargestInMotion) return std::nullopt;
  Error error{std::isfinite(time_s) ? ErrorCode::kOutsideDomain : ErrorCode::kNotFinite,
              "give a finite number of seconds, below 1.3e+30",
              {}};
  error.location.array = "time";
  return error;
}

}  // namespace

extern "C" {

beespace_code beespace_swarm_create(const beespace_swarm_options* options, beespace_swarm** swarm,
                                    beespace_error* error) {
  if (swarm != nullptr) *swarm = nullptr;
  return enter(error, [&]() -> Status {
    if (swarm == nullptr) return no_swarm();
    const Result<SwarmOptions> given = swarm_options_of(options);
    if (!given) return given.error();
    *swarm = std::make_unique<beespace_swarm>(*given).release();
    return std::monostate{};
  });
}

void beespace_swarm_free(beespace_swarm* swarm) {
  delete swarm;
}

beespace_code beespace_swarm_update(beespace_swarm* swarm, const beespace_fixes* reports,
                                    const beespace_points* positions,
                                    const beespace_points* velocities, int64_t* refused,
                                    beespace_error* error) {
  if (refused != nullptr) *refused = -1;
  return enter(error, [&]() -> Status {
    if (swarm == nullptr) return no_swarm();
    const Result<Reports> given = reports_of(reports, positions, velocities, swarm->heights_apart);
    if (!given) return given.error();
    const Refused all = take_all(swarm->swarm, *given);
    if (refused != nullptr) *refused = all.count;
    if (all.first) return *all.first;
    return std::monostate{};
  });
}

beespace_code beespace_swarm_remove(beespace_swarm* swarm, const int64_t* ids, int64_t count,
                                    beespace_error* error) {
  return change_agents(swarm, ids, count, error,
                       [](Swarm& used, beespace::AgentId agent) { used.remove(agent); });
}

beespace_code beespace_swarm_lose(beespace_swarm* swarm, const int64_t* ids, int64_t count,
                                  beespace_error* error) {
  return change_agents(swarm, ids, count, error,
                       [](Swarm& used, beespace::AgentId agent) { used.lose(agent); });
}

beespace_code beespace_swarm_advance(beespace_swarm* swarm, double now_s, beespace_events* events,
                                     beespace_error* error) {
  return make_events(swarm, events, error, [&](Swarm& used, std::vector<SwarmEvent>& made) {
    return used.advance(now_s, made);
  });
}

beespace_code beespace_swarm_finish(beespace_swarm* swarm, double now_s, beespace_events* events,
                                    beespace_error* error) {
  return make_events(swarm, events, error, [&](Swarm& used, std::vector<SwarmEvent>& made) {
    return keep(used.finish(now_s), made);
  });
}

beespace_code beespace_swarm_begin_anew(beespace_swarm* swarm, double now_s, double then_s,
                                        beespace_events* events, beespace_error* error) {
  return make_events(swarm, events, error, [&](Swarm& used, std::vector<SwarmEvent>& made) {
    return keep(used.begin_anew(now_s, then_s), made);
  });
}

beespace_code beespace_swarm_counts(const beespace_swarm* swarm, beespace_counts* counts,
                                    beespace_error* error) {
  return enter(error, [&]() -> Status {
    if (swarm == nullptr) return no_swarm();
    return write_struct(counts, counts_of(swarm->swarm.counts()), "counts");
  });
}

beespace_code beespace_swarm_movers(const beespace_swarm* swarm, double time_s,
                                    beespace_movers* movers, beespace_error* error) {
  if (movers != nullptr) movers->resize(0);
  return enter(error, [&]() -> Status {
    if (swarm == nullptr) return no_swarm();
    if (movers == nullptr) return invalid("the pointer to the movers is NULL", "movers");
    if (auto wrong = check_moment(time_s)) return *std::move(wrong);
    write_movers(swarm->swarm.movers(time_s), swarm->swarm.silences(time_s), *movers);
    return std::monostate{};
  });
}

}  // extern "C"
