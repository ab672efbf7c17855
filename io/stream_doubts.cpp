// Where bees of a stream are not known, and what cannot be left out any more as it was handed out.
#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"
#include "io/recording/restarted_clock.hpp"
#include "io/stream_recording.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace beespace::io {

void RecordingStream::look_whether_lost(std::size_t bee, const Fix& fix) {
  if (bee >= last_fix_.size()) last_fix_.resize(bee + 1);
  Last& last = last_fix_[bee];
  if (last.time_s && fix.time_s < *last.time_s) {
    last.goes_back = true;
    return;
  }
  if (last.time_s) {
    const TimeSpan between{*last.time_s, fix.time_s};
    if (assembly_->is_lost_between(id(bee), between)) assembly_->lose(id(bee), between);
  }
  last.time_s = fix.time_s;
}

// Between which fixes the records without a place are of bees that go back in time is not known any
// more: wherever they have some.
void RecordingStream::lose_unordered() {
  for (std::size_t bee = 0; bee < last_fix_.size(); ++bee) {
    if (!last_fix_[bee].goes_back) continue;
    if (const auto span = assembly_->unplaced_span(id(bee))) assembly_->lose(id(bee), *span);
  }
}

void RecordingStream::look_whether_frozen(std::size_t bee, const Fix& fix,
                                          const Velocity* velocity) {
  if (bee >= frozen_.size()) {
    frozen_.resize(bee + 1);
    led_away_.resize(bee + 1);
  }
  const auto now = frozen_[bee].take(fix, velocity, frame(), fixes_);
  if (now == FrozenWatch::Now::kLedAway && !led_away_[bee]) led_away_[bee] = fixes_;
}

// Runs that were handed out would be mixed in the order of time.
std::optional<Error> RecordingStream::restart_problem() const {
  std::vector<BeeClock> clocks;
  clocks.reserve(clocks_.size());
  for (const RestartWatch& watch : clocks_) clocks.push_back(watch.clock());
  const auto restarted = restarted_clock(clocks);
  if (!restarted) return std::nullopt;
  return assembly_->restart_error(*restarted);
}

// Those that were handed out cannot be left out any more.
std::optional<Error> RecordingStream::zero_run_problem() const {
  for (std::size_t bee = 0; bee < zero_runs_.size(); ++bee) {
    const auto fix = zero_runs_[bee].found();
    if (!fix) continue;
    return Error{ErrorCode::kInvalidArgument,
                 "a place of bee " + excerpt(id(bee)) + " is " + std::string(kZeroRun.which) +
                     " and cannot be left out with --memory: take such records out, or leave "
                     "--memory out",
                 assembly_->location_of(origin_of(*fix))};
  }
  return std::nullopt;
}

std::optional<Error> RecordingStream::frozen_problem() const {
  constexpr const char* kTakeOut =
      ", and cannot be left out with --memory; take them out, or leave --memory out";
  std::vector<double> ends_s;
  for (std::size_t bee = 0; bee < frozen_.size(); ++bee) {
    const std::string name = "bee " + excerpt(id(bee));
    if (const auto fix = led_away_[bee]) {
      return Error{ErrorCode::kInvalidArgument,
                   name +
                       " repeats a place exactly, up to here at least, though it has moved on by "
                       "its own velocity: records are said again after it was lost" +
                       kTakeOut,
                   assembly_->location_of(origin_of(*fix))};
    }
    const FrozenWatch& track = frozen_[bee];
    if (track.end() != FrozenEnd::kNo) ends_s.push_back(track.since_s());
    const auto fix = track.found();
    if (!fix) continue;
    return Error{ErrorCode::kInvalidArgument,
                 name +
                     " jumps to here after it has repeated a place exactly, farther and faster "
                     "than it moves elsewhere: records of before were said again after it was "
                     "lost" +
                     kTakeOut,
                 assembly_->location_of(origin_of(*fix))};
  }
  FrozenEnds perhaps;
  const bool usual = ends_are_usual(ends_s, frozen_.size());
  for (std::size_t bee = 0; bee < frozen_.size(); ++bee) {
    const FrozenWatch& track = frozen_[bee];
    if (track.end() == FrozenEnd::kNo) continue;
    if (track.end() == FrozenEnd::kMeasured && !usual) {
      return Error{ErrorCode::kInvalidArgument,
                   "bee " + excerpt(id(bee)) + " repeats a place exactly from " +
                       exact(track.since_s()) +
                       " s to its end, though the places before waver as measured ones do: records "
                       "are said again after it was lost" +
                       kTakeOut,
                   {}};
    }
    perhaps.take(id(bee), track.since_s());
  }
  assembly_->note_frozen(perhaps);
  return std::nullopt;
}

}  // namespace beespace::io
