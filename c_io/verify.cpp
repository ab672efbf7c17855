// Whether the agents of a recording kept their distance and their limits, along the curves of a
// show or between their fixes: what `beespace verify` says.
#include "analysis/recorded/coarse_places.hpp"
#include "analysis/recorded/common_times.hpp"
#include "analysis/recorded/coverage.hpp"
#include "analysis/recorded/earth_flights.hpp"
#include "analysis/recorded/gaps.hpp"
#include "analysis/recorded/kept_by_height.hpp"
#include "analysis/recorded/verify_paths.hpp"
#include "c/door/door.hpp"
#include "c/door/structs.hpp"
#include "c/door/watched_call.hpp"
#include "c/obstacles/obstacles.hpp"
#include "c_io/coverage.hpp"
#include "c_io/door.hpp"
#include "c_io/read_options.hpp"
#include "c_io/recording.hpp"
#include "c_io/verdict.hpp"
#include "io/bytes/number_text.hpp"

#include <beespace_io.h>
#include <beespace/obstacle.hpp>
#include <beespace/result.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace beespace::c_io;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Error;
using beespace::ErrorCode;
using beespace::kPathLimits;
using beespace::ObstacleMap;
using beespace::PathLimit;
using beespace::Result;
using beespace::RunOptions;
using beespace::Status;
using beespace::c::invalid;
namespace analysis = beespace::analysis;
namespace io = beespace::io;

namespace {

// Of a program that was built before there was `skipped_limits`.
constexpr std::size_t kFirstOptions = offsetof(beespace_io_verify_options, skipped_limits);
constexpr std::uint32_t kAllLimits = (1U << kPathLimits) - 1;

bool is_given(std::uint32_t limits, std::size_t limit) {
  return (limits >> limit & 1U) != 0;
}

bool has_curves(const io::Recording& recording) {
  return std::any_of(recording.bees.begin(), recording.bees.end(),
                     [](const io::RecordedBee& bee) { return bee.path.has_value(); });
}

Status check_options(const beespace_io_verify_options& given) {
  if ((given.flags & ~static_cast<std::uint32_t>(BEESPACE_IO_STRAIGHT)) != 0 ||
      (given.limits & ~kAllLimits) != 0) {
    return invalid("flags or limits ask for what a verification cannot do", "options");
  }
  for (std::size_t k = 0; k < kPathLimits; ++k) {
    if (!is_given(given.limits, k) && given.most[k] != 0.0) {
      return Error{ErrorCode::kInvalidArgument,
                   std::string("a limit of ") + beespace_io_finding_name(static_cast<int>(k)) +
                       " is given without its bit in limits",
                   {.array = "options"}};
    }
  }
  if (std::isnan(given.threshold_m) || given.threshold_m < 0.0) {
    return Error{ErrorCode::kInvalidThreshold, "the threshold is a length above zero", {}};
  }
  if (std::isnan(given.max_gap_s) || given.max_gap_s < 0.0) {
    return invalid("max_gap_s is below zero; 0 lets the recording say what a gap is", "options");
  }
  if (given.obstacles == nullptr && (given.obstacle_count != 0 || given.clearance_m != 0.0)) {
    return invalid("there is a number of obstacles or a clearance, but there are no obstacles",
                   "options");
  }
  if (given.obstacles != nullptr && !(given.clearance_m > 0.0)) {
    return invalid("with obstacles goes a clearance above zero", "options");
  }
  return check_ignore_below(given.ignore_below_m, "options");
}

// What limits heights, or how fast they change.
constexpr std::uint32_t kHeightLimits = 1U << static_cast<unsigned>(BEESPACE_IO_CLIMB) |
                                        1U << static_cast<unsigned>(BEESPACE_IO_DESCENT) |
                                        1U << static_cast<unsigned>(BEESPACE_IO_HEIGHT);

bool has_flight(const io::RecordedBee& bee) {
  return bee.path || bee.fixes.size() > 1;
}

Status check_recording(const io::Recording& recording, const beespace_io_verify_options& given) {
  const bool on_earth = recording.frame != io::Frame::kMetres;
  if (on_earth && given.obstacles != nullptr) {
    return Error{ErrorCode::kUnknownFrame,
                 "obstacles are in metres, and this recording is in degrees; leave the obstacles "
                 "out",
                 {}};
  }
  if (recording.flat && (given.limits & kHeightLimits) != 0) {
    return Error{ErrorCode::kMissingColumn,
                 "this recording has no heights, and so nothing is known of climbs, descents and "
                 "heights; leave their limits out",
                 {}};
  }
  const auto& bees = recording.bees;
  if (on_earth && std::any_of(bees.begin(), bees.end(), has_flight)) return std::monostate{};
  const bool straight = (given.flags & BEESPACE_IO_STRAIGHT) != 0;
  if (straight && has_curves(recording)) {
    return invalid("drones of a show fly along their curves; leave straight out", "options");
  }
  for (const io::RecordedBee& bee : recording.bees) {
    if (has_flight(bee)) continue;
    return Error{ErrorCode::kUnsupportedFormat,
                 "'" + bee.id + "' has " + (bee.fixes.empty() ? "no fix" : "a single fix") +
                     ", and so no flight; leave it out",
                 {}};
  }
  return std::monostate{};
}

// How agents fly between fixes. Of straight lines no acceleration is known, but a show that is one
// is flown so.
Result<std::int32_t> motion_of(const io::Recording& recording,
                               const beespace_io_verify_options& given) {
  if (has_curves(recording)) return BEESPACE_IO_ALONG_SHOW;
  // Accelerations are then those of the turns at fixes.
  if (recording.frame != io::Frame::kMetres) {
    const bool straight = (given.flags & BEESPACE_IO_STRAIGHT) != 0;
    return !straight && analysis::logs_velocities(recording) ? BEESPACE_IO_WITH_VELOCITIES
                                                             : BEESPACE_IO_IN_STRAIGHT_LINES;
  }
  const bool asked = is_given(given.limits, BEESPACE_IO_ACCELERATION);
  if ((given.flags & BEESPACE_IO_STRAIGHT) != 0) {
    if (!asked) return BEESPACE_IO_IN_STRAIGHT_LINES;
    return invalid("of straight lines no acceleration is known: leave one of the two out",
                   "options");
  }
  const auto missing = analysis::missing_velocity(recording);
  if (!missing) return BEESPACE_IO_WITH_VELOCITIES;
  if (!asked || recording.show) return BEESPACE_IO_IN_STRAIGHT_LINES;
  const io::RecordedBee& bee = recording.bees[missing->bee];
  return Error{ErrorCode::kMissingColumn,
               "a limit of acceleration needs velocities, and '" + bee.id + "' has none at " +
                   io::exact(bee.fixes[missing->fix].time_s) +
                   " s; give velocities, or leave the limit out",
               {}};
}

// The limits that are asked for, and of the others those that the show declares.
void settle_limits(const io::Recording& recording, const beespace_io_verify_options& given,
                   beespace_io_verdict_facts& facts) {
  facts.limits = given.limits;
  for (std::size_t k = 0; k < kPathLimits; ++k) {
    facts.most[k] =
        is_given(given.limits, k) ? given.most[k] : std::numeric_limits<double>::infinity();
    if (is_given(given.limits, k) || !recording.show) continue;
    const auto declared = analysis::declared_limit(*recording.show, static_cast<PathLimit>(k));
    if (!declared) continue;
    facts.most[k] = *declared;
    facts.limits |= 1U << k;
    facts.declared |= 1U << k;
  }
}

// They must be those of this show, so that a mistyped one is none.
Result<std::vector<std::string>> skipped_limits_of(const io::Recording& recording,
                                                   const beespace_io_verify_options& given) {
  std::vector<std::string> names;
  if (given.skipped_limits == nullptr) return names;
  std::string_view text = given.skipped_limits;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(','), text.size());
    names.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  const std::vector<std::string> known = analysis::skippable_limits(recording);
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    return Error{ErrorCode::kInvalidArgument,
                 "skipped_limits names '" + name +
                     "', which is none of the limits that are not looked at and that the "
                     "recording declares",
                 {.array = "options"}};
  }
  return names;
}

Result<ObstacleMap> obstacles_of(const beespace_io_verify_options& given) {
  if (given.obstacles == nullptr) return ObstacleMap();
  return beespace::c::map_of(given.obstacles, given.obstacle_count);
}

Result<std::unique_ptr<beespace_io_verdict>> verify(const io::Recording& recording,
                                                    const beespace_io_verify_options& given,
                                                    const RunOptions& run) {
  if (Status good = check_recording(recording, given); !good) return good.error();
  const auto motion = motion_of(recording, given);
  if (!motion) return motion.error();
  const auto threshold_m = threshold_of(recording, given.threshold_m);
  if (!threshold_m) return threshold_m.error();
  const auto obstacles = obstacles_of(given);
  if (!obstacles) return obstacles.error();
  const auto skipped = skipped_limits_of(recording, given);
  if (!skipped) return skipped.error();
  auto verdict = std::make_unique<beespace_io_verdict>();
  beespace_io_verdict_facts& facts = verdict->facts;
  settle_limits(recording, given, facts);
  const analysis::MaxGap max_gap = analysis::max_gap_of(
      recording, given.max_gap_s > 0.0 ? std::optional<double>(given.max_gap_s) : std::nullopt);

  analysis::PathQuestion question;
  question.with_velocities = *motion == BEESPACE_IO_WITH_VELOCITIES;
  question.threshold_m = *threshold_m;
  if (given.ignore_below_m > 0.0) question.ignore_below_m = given.ignore_below_m;
  question.max_gap_s = max_gap.seconds;
  if (given.obstacles != nullptr) question.obstacles = &*obstacles;
  question.clearance_m = given.clearance_m;
  std::copy_n(facts.most, kPathLimits, question.limits.most.begin());
  question.skipped_limits = *skipped;
  question.threads = run.threads;
  question.stop = run.stop;
  const auto found = analysis::verify_paths(recording, question);
  if (!found) return found.error();

  analysis::Coverage coverage = analysis::coverage_of(recording, found->gaps, max_gap);
  analysis::judge_places(recording, analysis::coarse_question(*found, question), coverage);
  const Status good = analysis::judge_heights(recording,
                                              {.threshold_m = question.threshold_m,
                                               .max_gap_s = question.max_gap_s,
                                               .threads = question.threads,
                                               .stop = question.stop},
                                              found->losses, found->low.left_out, coverage);
  if (!good) return good.error();
  const bool compared = analysis::compares(recording, *found, question);
  facts.holds = found->holds() && !coverage.may_hide_conflicts() && compared ? 1 : 0;
  facts.motion = *motion;
  facts.threshold_m = *threshold_m;
  facts.max_gap_s = max_gap.seconds;
  facts.gaps = static_cast<std::int64_t>(coverage.gaps);
  facts.missing = static_cast<std::int64_t>(coverage.missing.count);
  verdict->coverage = as_struct(coverage);
  for (const std::string& name : found->not_looked_at) {
    verdict->not_looked_at += (verdict->not_looked_at.empty() ? "" : ",") + name;
  }
  write_extremes(*found, facts);
  write_findings(*found, *verdict);
  return verdict;
}

}  // namespace

extern "C" {

beespace_code beespace_io_verify(const beespace_io_recording* recording,
                                 const beespace_io_verify_options* options,
                                 beespace_io_verdict** verdict, beespace_io_error* error) {
  if (verdict != nullptr) *verdict = nullptr;
  return enter(error, [&]() -> Status {
    if (recording == nullptr) return invalid("the recording is NULL", "recording");
    if (verdict == nullptr) return invalid("the pointer to the verdict is NULL", "verdict");
    beespace_io_verify_options given{};
    if (options != nullptr) {
      const auto read = beespace::c::read_struct(options, "options", kFirstOptions);
      if (!read) return read.error();
      given = *read;
    }
    if (Status good = check_options(given); !good) return good;
    return beespace::c::call_watched(given.run, [&](const RunOptions& run) -> Status {
      auto made = verify(recording->loaded, given, run);
      if (!made) return std::move(made).error();
      *verdict = (*made).release();
      return std::monostate{};
    });
  });
}

}  // extern "C"
