// The check of what was flown, step after step.
#include <beespace/verify.hpp>

#include "c/door/door.hpp"
#include "c/door/movers.hpp"
#include "c/door/points.hpp"
#include "c/door/structs.hpp"
#include "c/door/watched_call.hpp"
#include "c/motion/recording.hpp"
#include "c/obstacles/obstacles.hpp"
#include "c/verify/violations.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Error;
using beespace::ErrorCode;
using beespace::Fix;
using beespace::Mover;
using beespace::MoversView;
using beespace::ObstacleMap;
using beespace::PointsView;
using beespace::Result;
using beespace::RunOptions;
using beespace::Status;
using beespace::Verdict;
using beespace::Verifier;
using beespace::VerifyOptions;

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_verifier {
  // The options refer to this map, which shares the caller's obstacles.
  beespace_verifier(VerifyOptions options, const ObstacleMap& obstacles)
      : map(obstacles), straight(options.straight), verifier(with(std::move(options))) {}
  beespace_verifier(const beespace_verifier&) = delete;
  beespace_verifier& operator=(const beespace_verifier&) = delete;
  ~beespace_verifier() = default;

  VerifyOptions with(VerifyOptions options) const {
    if (options.obstacles != nullptr) options.obstacles = &map;
    return options;
  }

  const ObstacleMap map;
  bool straight;
  Verifier verifier;
  std::uint64_t moments = 0;
  std::uint64_t unseen = 0;
  bool skipped = false;  // since the last moment
  std::vector<double> breach_ends_s;
};

namespace {

constexpr std::uint32_t kKnownVerifyFlags =
    BEESPACE_VERIFY_MAX_SPEED | BEESPACE_VERIFY_MAX_ACCELERATION | BEESPACE_VERIFY_STRAIGHT;
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

std::optional<Error> check_flags(const beespace_verify_options& given) {
  const auto has = [&](std::uint32_t flag) { return (given.flags & flag) != 0; };
  if ((given.flags & ~kKnownVerifyFlags) != 0) {
    return invalid("flags ask for what a verifier cannot do", "options");
  }
  if (has(BEESPACE_VERIFY_STRAIGHT) && has(BEESPACE_VERIFY_MAX_ACCELERATION)) {
    return invalid("of straight lines no acceleration is known: leave one of the two flags out",
                   "options");
  }
  if ((!has(BEESPACE_VERIFY_MAX_SPEED) && given.max_speed_mps != 0.0) ||
      (!has(BEESPACE_VERIFY_MAX_ACCELERATION) && given.max_acceleration_mps2 != 0.0)) {
    return invalid(
        "a limit is given without its flag, BEESPACE_VERIFY_MAX_SPEED or "
        "BEESPACE_VERIFY_MAX_ACCELERATION",
        "options");
  }
  if (given.obstacles == nullptr && given.clearance_m != 0.0) {
    return invalid("there is a clearance, but there are no obstacles", "options");
  }
  return std::nullopt;
}

Result<VerifyOptions> verify_options_of(const beespace_verify_options* given_options) {
  const Result<beespace_verify_options> given = read_struct(given_options, "options");
  if (!given) return given.error();
  if (auto error = check_flags(*given)) return *std::move(error);
  VerifyOptions options;
  options.threshold_m = given->threshold_m;
  if ((given->flags & BEESPACE_VERIFY_MAX_SPEED) != 0) options.max_speed_mps = given->max_speed_mps;
  if ((given->flags & BEESPACE_VERIFY_MAX_ACCELERATION) != 0) {
    options.max_acceleration_mps2 = given->max_acceleration_mps2;
  }
  options.straight = (given->flags & BEESPACE_VERIFY_STRAIGHT) != 0;
  if (given->obstacles != nullptr) {
    options.obstacles = &given->obstacles->map;
    options.clearance_m = given->clearance_m;
  }
  // A verifier says with its first call what is wrong with its options: the caller hears it now.
  const Status tried = Verifier(options).add(0.0, {});
  if (tried) return options;
  Error error = tried.error();
  error.location.array = "options";
  return error;
}

Error no_verifier() {
  return invalid("the pointer to the verifier is NULL", "verifier");
}

Result<MoversView> flown_of(const beespace_verifier& verifier, const beespace_points* positions,
                            const beespace_points* velocities) {
  if (velocities != nullptr && !verifier.straight) {
    return movers_of(positions, velocities, kMovers);
  }
  if (!verifier.straight) {
    return invalid("this is NULL, which takes BEESPACE_VERIFY_STRAIGHT", "velocities");
  }
  static constexpr double kStill = 0.0;
  const Result<PointsView> places = view_of(positions, "positions");
  if (!places) return places.error();
  return MoversView(*places, PointsView::strided(&kStill, &kStill, &kStill, places->size(), 0));
}

Status add_moment(beespace_verifier& to, double time_s, const MoversView& movers,
                  const RunOptions& run) {
  Status status = to.verifier.add(time_s, movers, run);
  if (!status) {
    Error error = std::move(status).error();
    const bool of_time = error.code == ErrorCode::kTimeOrder || error.code == ErrorCode::kNotFinite;
    error.location.array = error.location.record ? "movers" : of_time ? "time" : "positions";
    return with_array(std::move(error), movers, kMovers);
  }
  to.skipped = false;
  ++to.moments;
  to.breach_ends_s.resize(to.verifier.verdict().first_breaches.size(), time_s);
  return status;
}

void skip(beespace_verifier& verifier) {
  if (verifier.moments == 0) return;
  verifier.verifier.skip();
  if (!std::exchange(verifier.skipped, true)) ++verifier.unseen;
}

// The first agent whose fixes are not at the times of those of the first one.
std::optional<Error> check_common_times(const Agents& agents) {
  const auto same = [](const Fix& a, const Fix& b) { return a.time_s == b.time_s; };
  for (std::size_t i = 1; i < agents.tracks.size(); ++i) {
    const std::vector<Fix>& first = agents.tracks.front().fixes;
    const std::vector<Fix>& fixes = agents.tracks[i].fixes;
    if (std::equal(first.begin(), first.end(), fixes.begin(), fixes.end(), same)) continue;
    Error error{ErrorCode::kInvalidArgument,
                "the fixes of agent " + std::to_string(agents.ids[i]) +
                    " are not all at the times of those of agent " +
                    std::to_string(agents.ids.front()) +
                    "; check conflicts instead, which needs no common times",
                {}};
    error.location.array = "recording";
    error.location.record = i;
    return error;
  }
  return std::nullopt;
}

Status add_all(beespace_verifier& to, const Agents& agents, double max_gap_s,
               const RunOptions& run) {
  if (agents.tracks.empty()) return std::monostate{};
  std::vector<Mover> movers(agents.tracks.size());
  const std::vector<Fix>& moments = agents.tracks.front().fixes;
  for (std::size_t fix = 0; fix < moments.size(); ++fix) {
    if (run.stop.stop_requested()) {
      return Error{ErrorCode::kStopped, "a stop was requested", {}};
    }
    const double time_s = moments[fix].time_s;
    if (fix > 0 && !(time_s - moments[fix - 1].time_s <= max_gap_s)) skip(to);
    for (std::size_t i = 0; i < movers.size(); ++i) {
      movers[i].position = agents.tracks[i].fixes[fix].position;
    }
    Status status = add_moment(to, time_s, movers, run);
    if (!status) return status;
  }
  return std::monostate{};
}

beespace_verdict verdict_of(const beespace_verifier& from) {
  const Verdict& verdict = from.verifier.verdict();
  beespace_verdict into{};
  into.holds = verdict.steps > 0 && verdict.holds() && from.unseen == 0 ? 1 : 0;
  into.moments = from.moments;
  into.steps = verdict.steps;
  into.unseen = from.unseen;
  into.losses = verdict.losses;
  into.clearance_losses = verdict.clearance_losses;
  into.breaches = verdict.breaches;
  into.closest_first = verdict.closest_pair ? verdict.closest_pair->first : std::int64_t{-1};
  into.closest_second = verdict.closest_pair ? verdict.closest_pair->second : std::int64_t{-1};
  into.closest_m = verdict.closest_m.value_or(kNothing);
  into.closest_step_s = verdict.closest_m ? verdict.closest_step_s : kNothing;
  into.peak_speed_mps = verdict.peak_speed_mps;
  into.peak_acceleration_mps2 = from.straight ? kNothing : verdict.peak_acceleration_mps2;
  return into;
}

}  // namespace

extern "C" {

beespace_code beespace_verifier_create(const beespace_verify_options* options,
                                       beespace_verifier** verifier, beespace_error* error) {
  if (verifier != nullptr) *verifier = nullptr;
  return enter(error, [&]() -> Status {
    if (verifier == nullptr) return no_verifier();
    const Result<VerifyOptions> given = verify_options_of(options);
    if (!given) return given.error();
    const ObstacleMap map = given->obstacles == nullptr ? ObstacleMap() : *given->obstacles;
    *verifier = std::make_unique<beespace_verifier>(*given, map).release();
    return std::monostate{};
  });
}

void beespace_verifier_free(beespace_verifier* verifier) {
  delete verifier;
}

beespace_code beespace_verifier_add(beespace_verifier* verifier, double time_s,
                                    const beespace_points* positions,
                                    const beespace_points* velocities, const beespace_run* run,
                                    beespace_error* error) {
  return enter(error, [&]() -> Status {
    if (verifier == nullptr) return no_verifier();
    const Result<MoversView> movers = flown_of(*verifier, positions, velocities);
    if (!movers) return movers.error();
    return call_watched(run, [&](const RunOptions& options) -> Status {
      return add_moment(*verifier, time_s, *movers, options);
    });
  });
}

void beespace_verifier_skip(beespace_verifier* verifier) {
  if (verifier != nullptr) skip(*verifier);
}

beespace_code beespace_verifier_add_recording(beespace_verifier* verifier,
                                              const beespace_recording* recording, double max_gap_s,
                                              const beespace_run* run, beespace_error* error) {
  return enter(error, [&]() -> Status {
    if (verifier == nullptr) return no_verifier();
    if (recording == nullptr) return invalid("the pointer to the recording is NULL", "recording");
    if (!(max_gap_s > 0.0)) return invalid("the longest gap is a time above zero", "max_gap");
    if (!verifier->straight) {
      return invalid("a recording has no velocities, which takes BEESPACE_VERIFY_STRAIGHT",
                     "recording");
    }
    if (recording->agents.heights_apart) {
      return invalid("the recording has heights apart from its positions: make one without them",
                     "recording");
    }
    if (auto wrong = check_common_times(recording->agents)) return *std::move(wrong);
    return call_watched(run, [&](const RunOptions& options) -> Status {
      return add_all(*verifier, recording->agents, max_gap_s, options);
    });
  });
}

beespace_code beespace_verifier_verdict(const beespace_verifier* verifier,
                                        beespace_verdict* verdict, beespace_error* error) {
  return enter(error, [&]() -> Status {
    if (verifier == nullptr) return no_verifier();
    return write_struct(verdict, verdict_of(*verifier), "verdict");
  });
}

beespace_code beespace_verifier_violations(const beespace_verifier* verifier,
                                           beespace_violations* violations, beespace_error* error) {
  if (violations != nullptr) violations->resize(0);
  return enter(error, [&]() -> Status {
    if (verifier == nullptr) return no_verifier();
    if (violations == nullptr)
      return invalid("the pointer to the violations is NULL", "violations");
    write_violations(verifier->verifier.verdict(), verifier->breach_ends_s, *violations);
    return std::monostate{};
  });
}

}  // extern "C"
