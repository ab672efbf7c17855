// Which agents of a recording came too close to each other: what `beespace replay` says.
#include "analysis/geometry/geometry.hpp"
#include "analysis/recorded/all_conflicts.hpp"
#include "analysis/recorded/coarse_places.hpp"
#include "analysis/recorded/coverage.hpp"
#include "analysis/recorded/findings.hpp"
#include "analysis/recorded/gaps.hpp"
#include "analysis/recorded/kept_by_height.hpp"
#include "analysis/recorded/low_conflicts.hpp"
#include "analysis/recorded/tracks.hpp"
#include "c/door/door.hpp"
#include "c/door/structs.hpp"
#include "c/door/watched_call.hpp"
#include "c_io/coverage.hpp"
#include "c_io/door.hpp"
#include "c_io/read_options.hpp"
#include "c_io/recording.hpp"
#include "io/recording/recording.hpp"

#include <beespace_io.h>
#include <beespace/conflict.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/result.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

using namespace beespace::c_io;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Conflict;
using beespace::ConflictOptions;
using beespace::Error;
using beespace::ErrorCode;
using beespace::Gap;
using beespace::Result;
using beespace::RunOptions;
using beespace::Status;
using beespace::c::invalid;
namespace analysis = beespace::analysis;
namespace io = beespace::io;

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_io_conflicts {
  beespace_io_conflict_facts facts{};
  beespace_io_coverage coverage{};
  std::vector<std::int64_t> first;
  std::vector<std::int64_t> second;
  std::vector<double> begins_s;
  std::vector<double> ends_s;
  std::vector<double> closest_s;
  std::vector<double> closest_m;
  std::vector<std::uint8_t> certain;
  std::vector<std::int64_t> gap_agent;
  std::vector<double> gap_begins_s;
  std::vector<double> gap_ends_s;
};

namespace {

constexpr const char* kConflictOptions = "options";
// Of programs that were built before there was `ignore_below_m`.
constexpr std::size_t kFirstConflictOptions =
    offsetof(beespace_io_conflict_options, ignore_below_m);
constexpr std::size_t kFirstConflictFacts = offsetof(beespace_io_conflict_facts, ignored);
constexpr std::uint32_t kConflictFlags = static_cast<std::uint32_t>(BEESPACE_INCLUSIVE) |
                                         static_cast<std::uint32_t>(BEESPACE_IO_ALONG_LINES);

Status check_options(const beespace_io_conflict_options& given) {
  if ((given.flags & ~kConflictFlags) != 0 || given.limited > 1) {
    return invalid("flags or limited ask for what a search for conflicts cannot do",
                   kConflictOptions);
  }
  if (given.limited == 0 && given.max_results != 0) {
    return invalid("max_results is given, and limited does not say that it counts",
                   kConflictOptions);
  }
  if (std::isnan(given.threshold_m) || given.threshold_m < 0.0) {
    return Error{ErrorCode::kInvalidThreshold, "the threshold is a length above zero", {}};
  }
  if (std::isnan(given.max_gap_s) || given.max_gap_s < 0.0) {
    return invalid("max_gap_s is below zero; 0 lets the recording say what a gap is",
                   kConflictOptions);
  }
  return check_ignore_below(given.ignore_below_m, kConflictOptions);
}

void write_conflicts(const std::vector<Conflict>& conflicts, beespace_io_conflicts& into) {
  for (const Conflict& conflict : conflicts) {
    into.first.push_back(conflict.first);
    into.second.push_back(conflict.second);
    into.begins_s.push_back(conflict.begins_s);
    into.ends_s.push_back(conflict.ends_s);
    into.closest_s.push_back(conflict.closest_s);
    into.closest_m.push_back(conflict.closest_m);
    into.certain.push_back(conflict.certain ? 1 : 0);
    if (!conflict.certain) ++into.facts.possible;
  }
}

void write_gaps(const std::vector<Gap>& gaps, beespace_io_conflicts& into) {
  for (const Gap& gap : gaps) {
    into.gap_agent.push_back(gap.track);
    into.gap_begins_s.push_back(gap.begins_s);
    into.gap_ends_s.push_back(gap.ends_s);
  }
}

void write_closest(const std::optional<Conflict>& closest, beespace_io_conflict_facts& facts) {
  facts.closest_first = closest ? closest->first : std::int64_t{-1};
  facts.closest_second = closest ? closest->second : std::int64_t{-1};
  facts.closest_m = closest ? closest->closest_m : kNotKnown;
  facts.closest_s = closest ? closest->closest_s : kNotKnown;
}

void write_velocities(const analysis::VelocityCurves& curves, beespace_io_conflict_facts& facts) {
  facts.velocities = curves.given ? 1 : 0;
  facts.too_far = curves.followed ? 0 : 1;
  facts.most_off_m = curves.most_off_m;
}

Result<std::unique_ptr<beespace_io_conflicts>> find(const beespace_io_recording& of,
                                                    const beespace_io_conflict_options& given,
                                                    const RunOptions& run) {
  const io::Recording& recording = of.loaded;
  const auto vertical = vertical_of(given.vertical, kConflictOptions);
  if (!vertical) return vertical.error();
  const auto threshold_m = threshold_of(recording, given.threshold_m);
  if (!threshold_m) return threshold_m.error();
  const analysis::Geometry geometry = analysis::geometry_for(recording, *vertical);
  const auto tracks = analysis::tracks_of(recording, geometry, of.tolerance_m);
  if (!tracks) return tracks.error();
  const analysis::MaxGap max_gap = analysis::max_gap_of(
      recording, given.max_gap_s > 0.0 ? std::optional<double>(given.max_gap_s) : std::nullopt);
  ConflictOptions options{
      .threshold_m = *threshold_m,
      .vertical_m = analysis::vertical_in(geometry, *vertical, recording.height_unit),
      .inclusive = (given.flags & BEESPACE_INCLUSIVE) != 0,
      .max_gap_s = max_gap.seconds,
      .threads = run.threads,
      .height_unit_m = analysis::height_unit_m(geometry, recording.height_unit),
      .stop = run.stop};
  if (given.limited == 1) options.max_results = given.max_results;
  const bool straight = (given.flags & BEESPACE_IO_ALONG_LINES) != 0;
  auto found = analysis::all_conflicts(recording, *tracks, geometry, options, straight);
  if (!found) return found.error();
  analysis::LowConflicts low;
  if (given.ignore_below_m > 0.0) {
    low = analysis::leave_out_low(recording, given.ignore_below_m, found->recorded.conflicts);
    analysis::leave_out_too(low, found->with_standing);
  }
  const auto in_space =
      analysis::heights_apart(geometry)
          ? analysis::tracks_of(recording, analysis::Geometry::kSpace, of.tolerance_m)
          : tracks;
  if (!in_space) return in_space.error();

  analysis::Coverage coverage = analysis::coverage_of(recording, found->recorded.gaps, max_gap);
  analysis::judge_places(
      recording, analysis::coarse_question(options, found->recorded.conflicts, found->closest),
      coverage);
  const bool compared = analysis::has_encounters(*found, recording, *in_space, options);
  analysis::Findings findings{recording,      *tracks,  *in_space, found->recorded,
                              found->closest, coverage, compared};
  findings.curves = &found->curves;
  auto kept = analysis::kept_by_height(recording, options, of.tolerance_m,
                                       found->recorded.conflicts, low.left_out);
  if (!kept) return kept.error();
  findings.kept_by_height = *std::move(kept);
  auto conflicts = std::make_unique<beespace_io_conflicts>();
  beespace_io_conflict_facts& facts = conflicts->facts;
  facts.risky = findings.is_risky() ? 1 : 0;
  facts.compared = compared ? 1 : 0;
  facts.threshold_m = *threshold_m;
  facts.with_standing = static_cast<std::int64_t>(found->with_standing.size());
  facts.ignored = static_cast<std::int64_t>(low.left_out.size());
  facts.takeoff_unknown = static_cast<std::int64_t>(low.bees_not_known);
  write_velocities(found->curves, facts);
  write_closest(found->closest, facts);
  write_conflicts(found->recorded.conflicts, *conflicts);
  write_gaps(found->recorded.gaps, *conflicts);
  conflicts->coverage = as_struct(coverage);
  return conflicts;
}

template <class Number>
const Number* column(const beespace_io_conflicts* conflicts,
                     std::vector<Number> beespace_io_conflicts::*numbers) {
  if (conflicts == nullptr || (conflicts->*numbers).empty()) return nullptr;
  return (conflicts->*numbers).data();
}

}  // namespace

extern "C" {

beespace_code beespace_io_find_conflicts(const beespace_io_recording* recording,
                                         const beespace_io_conflict_options* options,
                                         beespace_io_conflicts** conflicts,
                                         beespace_io_error* error) {
  if (conflicts != nullptr) *conflicts = nullptr;
  return enter(error, [&]() -> Status {
    if (recording == nullptr) return invalid("the recording is NULL", "recording");
    if (conflicts == nullptr) return invalid("the pointer to the conflicts is NULL", "conflicts");
    beespace_io_conflict_options given{};
    if (options != nullptr) {
      const auto read = beespace::c::read_struct(options, kConflictOptions, kFirstConflictOptions);
      if (!read) return read.error();
      given = *read;
    }
    if (Status good = check_options(given); !good) return good;
    return beespace::c::call_watched(given.run, [&](const RunOptions& run) -> Status {
      auto found = find(*recording, given, run);
      if (!found) return std::move(found).error();
      *conflicts = (*found).release();
      return std::monostate{};
    });
  });
}

void beespace_io_conflicts_free(beespace_io_conflicts* conflicts) {
  delete conflicts;
}

beespace_code beespace_io_conflicts_facts_of(const beespace_io_conflicts* conflicts,
                                             beespace_io_conflict_facts* facts,
                                             beespace_io_error* error) {
  return enter(error, [&]() -> Status {
    if (conflicts == nullptr) return invalid("the conflicts are NULL", "conflicts");
    return beespace::c::write_struct(facts, conflicts->facts, "facts", kFirstConflictFacts);
  });
}

beespace_code beespace_io_conflicts_coverage(const beespace_io_conflicts* conflicts,
                                             beespace_io_coverage* coverage,
                                             beespace_io_error* error) {
  return enter(error, [&]() -> Status {
    if (conflicts == nullptr) return invalid("the conflicts are NULL", "conflicts");
    return beespace::c::write_struct(coverage, conflicts->coverage, "coverage");
  });
}

int64_t beespace_io_conflicts_size(const beespace_io_conflicts* conflicts) {
  return conflicts == nullptr ? 0 : static_cast<int64_t>(conflicts->first.size());
}

const int64_t* beespace_io_conflicts_first(const beespace_io_conflicts* conflicts) {
  return column(conflicts, &beespace_io_conflicts::first);
}

const int64_t* beespace_io_conflicts_second(const beespace_io_conflicts* conflicts) {
  return column(conflicts, &beespace_io_conflicts::second);
}

const double* beespace_io_conflicts_begins_s(const beespace_io_conflicts* conflicts) {
  return column(conflicts, &beespace_io_conflicts::begins_s);
}

const double* beespace_io_conflicts_ends_s(const beespace_io_conflicts* conflicts) {
  return column(conflicts, &beespace_io_conflicts::ends_s);
}

const double* beespace_io_conflicts_closest_s(const beespace_io_conflicts* conflicts) {
  return column(conflicts, &beespace_io_conflicts::closest_s);
}

const double* beespace_io_conflicts_closest_m(const beespace_io_conflicts* conflicts) {
  return column(conflicts, &beespace_io_conflicts::closest_m);
}

const uint8_t* beespace_io_conflicts_certain(const beespace_io_conflicts* conflicts) {
  return column(conflicts, &beespace_io_conflicts::certain);
}

int64_t beespace_io_conflicts_gaps(const beespace_io_conflicts* conflicts) {
  return conflicts == nullptr ? 0 : static_cast<int64_t>(conflicts->gap_agent.size());
}

const int64_t* beespace_io_conflicts_gap_agent(const beespace_io_conflicts* conflicts) {
  return column(conflicts, &beespace_io_conflicts::gap_agent);
}

const double* beespace_io_conflicts_gap_begins_s(const beespace_io_conflicts* conflicts) {
  return column(conflicts, &beespace_io_conflicts::gap_begins_s);
}

const double* beespace_io_conflicts_gap_ends_s(const beespace_io_conflicts* conflicts) {
  return column(conflicts, &beespace_io_conflicts::gap_ends_s);
}

}  // extern "C"
