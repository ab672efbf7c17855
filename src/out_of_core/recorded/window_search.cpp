#include "out_of_core/recorded/window_search.hpp"

#include "base/memory.hpp"
#include "base/stopping.hpp"
#include "exact/validate.hpp"
#include "motion/recorded/recording_search.hpp"
#include "out_of_core/recorded/clash_error.hpp"
#include "out_of_core/recorded/joined_conflicts.hpp"
#include "out_of_core/recorded/time_cut.hpp"
#include "out_of_core/recorded/time_windows.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace beespace::out_of_core {

namespace {

using motion::TrackSegment;
using Phase = OutOfCoreProgress::Phase;

// Tells the caller, but not all the time.
class Teller {
 public:
  Teller(const RecordingWorkplace& at, std::uint64_t fixes) : at_(at), fixes_(fixes) {}

  void tell(Phase phase, std::uint64_t done) {
    constexpr std::chrono::milliseconds kPause(100);
    if (!at_.progress) return;
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < kPause && done < fixes_) return;
    last_ = now;
    at_.progress({phase, std::min(done, fixes_), fixes_});
  }

  // Of fixes that are read twice: counted, and distributed. False where a stop was requested.
  FixWatcher watcher(std::uint64_t before) {
    return [this, before, read = std::uint64_t{0}]() mutable {
      constexpr std::uint64_t kBetween = std::uint64_t{1} << 14U;
      if (++read % kBetween != 0) return true;
      tell(Phase::kDistributing, before + std::min(read, fixes_) / 2);
      return !at_.stop.stop_requested();
    };
  }

 private:
  const RecordingWorkplace& at_;
  std::uint64_t fixes_;
  std::chrono::steady_clock::time_point last_;
};

std::string mebibytes(std::uint64_t bytes) {
  return std::to_string((bytes >> 20U) + 1) + " MiB";
}

// A window that is too large after all: that many agents are there at one time.
std::optional<Error> too_large(const TimeCut& cut, const RecordingPlan& plan) {
  const WindowSize largest = cut.largest(plan.cost);
  if (plan.cost.of(largest) <= plan.window) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "at one time " + std::to_string(largest.segments) +
                   " agents are there, which are searched together and take " +
                   mebibytes(memory_for(plan.cost.of(largest))) +
                   " of memory; allow as much, or search the agents of each area apart",
               {}};
}

// Whether two segments of different tracks are there at one instant: of those that begin before a
// segment, of another track, the last end is not before its beginning.
bool any_together(std::vector<TrackSegment> segments) {
  std::sort(segments.begin(), segments.end(), [](const TrackSegment& a, const TrackSegment& b) {
    return a.begins_s() < b.begins_s();
  });
  constexpr double kNever = -std::numeric_limits<double>::infinity();
  struct Last {
    PointId track = 0;
    double ends_s = kNever;
  };
  Last latest;
  Last of_others;  // the latest of another track than that
  for (const TrackSegment& segment : segments) {
    const Last& other = latest.track == segment.track ? of_others : latest;
    if (other.ends_s >= segment.begins_s()) return true;
    if (latest.track == segment.track) {
      latest.ends_s = std::max(latest.ends_s, segment.ends_s());
    } else {
      if (latest.ends_s > of_others.ends_s) of_others = latest;
      latest = {segment.track, segment.ends_s()};
    }
  }
  return false;
}

Result<std::vector<Conflict>> search(const WindowTracks& tracks, const ConflictOptions& options,
                                     bool have_heights, const RecordingWorkplace& at,
                                     bool& encounters) {
  const std::vector<TrackSegment> segments = tracks.segments();
  encounters = encounters || any_together(segments);
  core::StoppableCrew crew(at.crew, at.stop);
  core::Memory memory;
  memory.start_call();
  return core::unless_stopped([&] {
    return motion::search_recording(segments, motion::separation_of(options, have_heights),
                                    options.max_results, {crew, memory});
  });
}

Result<TimeWindows> distribute(const StoredFixes& fixes, const ConflictOptions& options,
                               RepeatedFixes& repeated, const RecordingWorkplace& at,
                               Teller& teller, const LargeGapVisitor& gaps,
                               RecordingOutOfCoreFacts& facts) {
  auto cut = find_cut(fixes, {options.max_gap_s, at.plan.cost, at.plan.cut_for}, repeated,
                      teller.watcher(0));
  if (!cut) return std::move(cut).error();
  facts.repeated = repeated.count;
  facts.clash = repeated.clash;
  if (repeated.clash) return clash_error(*repeated.clash);
  if (auto error = too_large(*cut, at.plan)) return *std::move(error);
  auto windows = TimeWindows::make(*std::move(cut), at.folder, at.plan.waiting);
  if (!windows) return std::move(windows).error();
  auto status = windows->distribute(fixes, options.max_gap_s, repeated, gaps,
                                    teller.watcher(fixes.size() / 2));
  if (!status) return std::move(status).error();
  return windows;
}

}  // namespace

Status search_windows(const StoredFixes& fixes, const ConflictOptions& options,
                      bool repeats_allowed, const RecordingWorkplace& at,
                      const LargeConflictVisitor& conflicts, const LargeGapVisitor& gaps,
                      RecordingOutOfCoreFacts& facts) {
  Teller teller(at, fixes.size());
  RepeatedFixes repeated{repeats_allowed, 0, {}};
  const auto windows = distribute(fixes, options, repeated, at, teller, gaps, facts);
  if (!windows) return windows.error();
  core::trim_freed_memory(at.plan.fixes.merge_bytes + at.plan.waiting);

  JoinedConflicts found(at.folder, at.plan.conflicts);
  {
    std::uint64_t most = 0;
    for (std::size_t window = 0; window < windows->count(); ++window) {
      most = std::max(most, windows->size(window).fixes);
    }
    WindowTracks tracks(most, fixes.have_heights(), options.max_gap_s);
    std::uint64_t searched = 0;
    for (std::size_t window = 0; window < windows->count(); ++window) {
      const std::uint64_t size = windows->size(window).fixes;
      if (size == 0) continue;
      auto read = windows->read(window, tracks);
      if (!read) return read;
      const auto some = search(tracks, options, fixes.have_heights(), at, facts.encounters);
      if (!some) return some.error();
      if (auto added = found.add(window, *some, tracks, at.crew); !added) return added;
      ++facts.windows;
      facts.largest_window = std::max(facts.largest_window, size);
      searched += size;
      teller.tell(Phase::kSearching, searched);
    }
    facts.copies = searched + repeated.count - fixes.size();
  }
  core::trim_freed_memory(at.plan.window);
  if (at.stop.stop_requested()) return core::stopped_error();
  return found.visit(options.max_results, conflicts, at.crew);
}

}  // namespace beespace::out_of_core
