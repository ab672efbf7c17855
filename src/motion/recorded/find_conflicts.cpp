#include <beespace/brute_force.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/nearest.hpp>

#include "base/crew_size.hpp"
#include "base/stopping.hpp"
#include "exact/validate.hpp"
#include "motion/flushed_copies.hpp"
#include "motion/pair_walk.hpp"
#include "motion/recorded/recording_search.hpp"
#include "motion/track_segments.hpp"
#include "motion/validate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace beespace {

namespace {

bool have_heights(std::span<const Track> tracks) {
  return std::any_of(tracks.begin(), tracks.end(),
                     [](const Track& track) { return !track.heights_m.empty(); });
}

std::optional<Error> check(std::span<const Track> tracks, const ConflictOptions& options) {
  if (auto error = motion::check_options(options)) return error;
  if (auto error = motion::check_heights(have_heights(tracks), options.vertical_m)) return error;
  if (auto error = core::check_size(tracks.size())) return error;
  return motion::check_tracks(tracks);
}

// The diagonal of the box that contains all tracks.
double diagonal_of(std::span<const Track> tracks) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{kNone, kNone, kNone};
  std::array<double, 3> high{-kNone, -kNone, -kNone};
  for (const Track& track : tracks) {
    for (const auto& [time, p] : track.fixes) {
      const std::array<double, 3> at{p.x, p.y, p.z};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], at[axis]);
        high[axis] = std::max(high[axis], at[axis]);
      }
    }
  }
  if (low[0] > high[0]) return 0.0;
  return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

// The distance of the closest two at some instants: an upper limit of the closest encounter.
// Nothing if no two exist then.
std::optional<double> closest_at_some_instants(std::span<const Track> tracks, double max_gap_s) {
  if (tracks.empty()) return std::nullopt;
  constexpr std::size_t kInstants = 5;
  std::optional<double> closest_m;
  std::vector<Point> places;
  for (std::size_t k = 0; k < kInstants; ++k) {
    // The midpoint of a track.
    const Track& some = tracks[k * tracks.size() / kInstants];
    if (some.fixes.empty()) continue;
    const double time_s = some.fixes[some.fixes.size() / 2].time_s;
    places.clear();
    for (const Track& track : tracks) {
      if (const auto place = position_at(track, time_s, max_gap_s)) places.push_back(*place);
    }
    const auto pair = find_closest_pair(places);
    if (!pair || !*pair) continue;
    const double distance_m = (*pair)->distance_m;
    closest_m = std::min(closest_m.value_or(distance_m), distance_m);
  }
  return closest_m;
}

// The options are valid, but the threshold may lie beyond the motion domain.
Result<RecordedConflicts> search_tracks(std::span<const Track> tracks,
                                        const ConflictOptions& options) {
  motion::TrackSegments cut = motion::cut_at_gaps(tracks, options.max_gap_s);
  ThreadCrew crew(cpu::crew_size(options.threads, cut.segments.size()));
  core::StoppableCrew stoppable(crew, options.stop);
  core::Memory memory;
  memory.start_call();
  auto conflicts = core::unless_stopped([&] {
    return motion::search_recording(cut.segments,
                                    motion::separation_of(options, have_heights(tracks)),
                                    options.max_results, {stoppable, memory});
  });
  if (!conflicts) return std::move(conflicts).error();
  return RecordedConflicts{*std::move(conflicts), std::move(cut.gaps)};
}

}  // namespace

Result<RecordedConflicts> find_conflicts(std::span<const Track> tracks,
                                         const ConflictOptions& options) {
  using Answer = Result<RecordedConflicts>;
  return motion::with_small_values_flushed(tracks, [&](std::span<const Track> them) -> Answer {
    if (auto error = check(them, options)) return *std::move(error);
    return search_tracks(them, options);
  });
}

namespace {

Result<std::optional<Conflict>> closest_encounter(std::span<const Track> tracks, double max_gap_s,
                                                  const RunOptions& run) {
  ConflictOptions options;
  options.max_gap_s = max_gap_s;
  options.threads = run.threads;
  options.stop = run.stop;
  options.inclusive = true;
  options.threshold_m = 1.0;  // any, for the check
  if (auto error = check(tracks, options)) return *std::move(error);
  // From a distance that some pair comes within to one that exceeds the swarm's width, which may
  // exceed any threshold that is valid as input.
  const double widest = std::max(1.01 * diagonal_of(tracks), 0x1p-90);
  const auto some_m = closest_at_some_instants(tracks, max_gap_s);
  const double first = some_m ? *some_m * (1.0 + 0x1p-40) : widest * 0x1p-12;
  for (double threshold = std::max(first, kSmallestInMotion);; threshold *= 2.0) {
    options.threshold_m = std::min(threshold, widest);
    const Result<RecordedConflicts> found = search_tracks(tracks, options);
    if (!found) return found.error();
    std::optional<Conflict> closest;
    for (const Conflict& conflict : found->conflicts) {
      if (!closest || conflict.closest_m < closest->closest_m) closest = conflict;
    }
    if (closest) closest->begins_s = closest->ends_s = closest->closest_s;
    // Tolerances also find pairs beyond the threshold; then another pair may be closer.
    const bool sure = closest && closest->closest_m <= options.threshold_m;
    if (sure || threshold >= widest) return closest;
  }
}

}  // namespace

Result<std::optional<Conflict>> find_closest_encounter(std::span<const Track> tracks,
                                                       double max_gap_s, const RunOptions& run) {
  return motion::with_small_values_flushed(
      tracks, [&](std::span<const Track> them) { return closest_encounter(them, max_gap_s, run); });
}

namespace brute_force {

namespace {

Result<RecordedConflicts> find_one_by_one(std::span<const Track> tracks,
                                          const ConflictOptions& options) {
  if (auto error = check(tracks, options)) return *std::move(error);
  motion::TrackSegments cut = motion::cut_at_gaps(tracks, options.max_gap_s);
  const motion::Separation separation = motion::separation_of(options, have_heights(tracks));
  constexpr double kEver = std::numeric_limits<double>::infinity();
  RecordedConflicts answer;
  for (std::size_t i = 0; i < cut.segments.size(); ++i) {
    for (std::size_t j = i + 1; j < cut.segments.size(); ++j) {
      if (cut.segments[i].track == cut.segments[j].track) continue;
      const auto wide =
          motion::WalkSeparation::within(separation, cut.segments[i], cut.segments[j]);
      motion::PairWalk::State state;
      motion::PairWalk(cut.segments[i], cut.segments[j], wide)
          .walk({-kEver, kEver}, state, [&](const motion::PairWalk::Stretch& stretch) {
            answer.conflicts.push_back(stretch.conflict);
          });
      if (answer.conflicts.size() > options.max_results) {
        return core::too_many_results(options.max_results);
      }
    }
  }
  motion::order_conflicts(answer.conflicts);
  answer.gaps = std::move(cut.gaps);
  return answer;
}

}  // namespace

Result<RecordedConflicts> find_conflicts(std::span<const Track> tracks,
                                         const ConflictOptions& options) {
  return motion::with_small_values_flushed(
      tracks, [&](std::span<const Track> them) { return find_one_by_one(them, options); });
}

}  // namespace brute_force

}  // namespace beespace
