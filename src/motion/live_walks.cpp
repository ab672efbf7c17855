#include "motion/live_walks.hpp"

#include "motion/passing_search.hpp"
#include "search/choices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace beespace::motion {

namespace {

double farthest_coordinate(const std::vector<Run>& runs, const std::vector<ActiveRun>& active) {
  double farthest_m = 0.0;
  for (const ActiveRun& a : active) {
    for (const Fix& fix : runs[a.run].fixes) {
      const Point& p = fix.position;
      farthest_m = std::max({farthest_m, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
  }
  return farthest_m;
}

// The piece on which a run is then, or its first one.
std::size_t piece_at(const Run& run, double time_s) {
  std::size_t piece = 0;
  while (piece + 1 < run.pieces() && piece_of(run, piece).to.time_s < time_s) ++piece;
  return piece;
}

// The time of which something new is known. What is known of a pair ends where the first of the two
// was last heard of. So it begins where a bee that has been heard of since was last searched, and
// ends with the last report but one of another bee. It ends before it begins where there is none.
TimeSpan new_time(const std::vector<LiveRun>& runs) {
  TimeSpan time{std::numeric_limits<double>::infinity(), LiveRun::kNever};
  double last_s = LiveRun::kNever;
  for (const LiveRun& run : runs) {
    if (run.fixes.empty()) continue;
    time.ends_s = std::max(time.ends_s, std::min(last_s, run.last_s()));
    last_s = std::max(last_s, run.last_s());
    if (run.searched_until_s >= run.last_s()) continue;
    time.begins_s =
        std::min(time.begins_s, std::max(run.searched_until_s, run.fixes.front().time_s));
  }
  return time;
}

// What becomes of a pair where what is known of it ends.
EventKind cut_off(const LiveRun& a, const LiveRun& b) {
  const auto either = [&](RunEnd end) {
    return (a.complete && a.end == end) || (b.complete && b.end == end);
  };
  if (either(RunEnd::kRemoved)) return EventKind::kLeft;
  return either(RunEnd::kSilent) ? EventKind::kLost : EventKind::kEnded;
}

}  // namespace

void LiveWalks::search(LiveBees& bees, const core::Resources& with,
                       std::vector<SwarmEvent>& events) {
  std::vector<Run> runs;
  runs.reserve(bees.runs().size());
  for (std::uint32_t place = 0; place < bees.runs().size(); ++place) {
    const LiveRun& live = bees.runs()[place];
    runs.push_back({place, 0.0, live.fixes, live.heights_m, live.complete});
  }
  const TimeSpan time = new_time(bees.runs());
  if (time.begins_s <= time.ends_s) {
    std::vector<ActiveRun> active;
    active.reserve(runs.size());
    for (std::uint32_t place = 0; place < runs.size(); ++place) {
      const Run& run = runs[place];
      if (run.fixes.empty() || run.ends_s() < time.begins_s || run.begins_s() > time.ends_s) {
        continue;
      }
      active.push_back({place, piece_at(run, time.begins_s)});
    }
    const StepBalls enclosed(runs, active, time, with);
    const double blur_m = 0x1p-46 * farthest_coordinate(runs, active);
    const Step step{0.5 * (time.ends_s - time.begins_s) * (1.0 + 0x1p-50),
                    separation_.outer.reach_m() * (1.0 + 0x1p-50) + blur_m};
    add_candidates(find_passing(enclosed.balls(), step, with, search::Choices{}), active,
                   bees.runs());
  }
  walk(runs, bees.runs(), with, events);
  forget(bees);
}

bool LiveWalks::have_entered(PointId a, PointId b) const {
  return std::binary_search(entered_.begin(), entered_.end(),
                            Entered{std::min(a, b), std::max(a, b)});
}

void LiveWalks::add_candidates(const core::Vector<core::FoundPairs>& candidates,
                               const std::vector<ActiveRun>& active,
                               const std::vector<LiveRun>& bees) {
  std::vector<LivePair> fresh;
  for (const core::FoundPairs& part : candidates) {
    for (const auto& chunk : part.chunks()) {
      for (std::uint32_t k = 0; k < chunk.size; ++k) {
        ActiveRun first = active[chunk.first[k]];
        ActiveRun second = active[chunk.second[k]];
        if (bees[first.run].bee == bees[second.run].bee) continue;
        if (first.run > second.run) std::swap(first, second);
        LivePair pair{first.run, second.run, {first.piece, second.piece}, {}};
        pair.state.walked_before =
            std::min(bees[first.run].searched_until_s, bees[second.run].searched_until_s);
        fresh.push_back(pair);
      }
    }
  }
  const auto ascending = [](const LivePair& a, const LivePair& b) {
    return a.places() < b.places();
  };
  std::sort(fresh.begin(), fresh.end(), ascending);
  // Of two alike, the one under way comes first in the union, and is the one that is kept.
  std::vector<LivePair> all;
  all.reserve(pairs_.size() + fresh.size());
  std::set_union(pairs_.begin(), pairs_.end(), fresh.begin(), fresh.end(), std::back_inserter(all),
                 ascending);
  pairs_ = std::move(all);
}

void LiveWalks::walk(const std::vector<Run>& runs, const std::vector<LiveRun>& bees,
                     const core::Resources& with, std::vector<SwarmEvent>& events) {
  std::vector<std::vector<SwarmEvent>> told(with.crew.size());
  with.crew.split(pairs_.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    for (std::size_t i = begin; i < end; ++i) {
      LivePair& pair = pairs_[i];
      const LiveRun& first = bees[pair.first];
      const LiveRun& second = bees[pair.second];
      PairTeller teller(first.bee, second.bee, margin_m_, cut_off(first, second), pair.said,
                        told[worker]);
      PairWalk(runs[pair.first], runs[pair.second], separation_, true)
          .walk(
              {LiveRun::kNever, -LiveRun::kNever}, pair.state,
              [&](const PairWalk::Stretch& stretch) { teller.ended(stretch); },
              [&](const PairWalk::Stretch& stretch) { teller.going_on(stretch); });
      if (!pair.state.open || (!first.done && !second.done)) continue;
      pair.state.open->cut_off = true;
      teller.ended(*std::exchange(pair.state.open, std::nullopt));
    }
  });
  for (const auto& part : told) events.insert(events.end(), part.begin(), part.end());
  entered_.clear();
  for (const LivePair& pair : pairs_) {
    if (!pair.said.entered) continue;
    const PointId a = bees[pair.first].bee;
    const PointId b = bees[pair.second].bee;
    entered_.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(entered_.begin(), entered_.end());
}

void LiveWalks::forget(LiveBees& bees) {
  // What has been walked of the others is known by when their bees were searched.
  std::erase_if(pairs_, [](const LivePair& pair) { return !pair.state.open; });
  std::vector<std::uint32_t> dropped;
  bees.forget(dropped);
  for (LivePair& pair : pairs_) {
    pair.state.walked_before = LiveRun::kNever;
    pair.state.first_piece -= dropped[pair.first];
    pair.state.second_piece -= dropped[pair.second];
  }
}

}  // namespace beespace::motion
