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

}  // namespace

void LiveWalks::search(LiveBees& bees, const core::Resources& with,
                       std::vector<SwarmEvent>& events) {
  // Nothing about two bees is known that both have been heard of later than in the last search.
  TimeSpan time{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const LiveRun& run : bees.runs()) {
    if (run.fixes.empty()) continue;
    time.begins_s = std::min(time.begins_s, run.searched_until_s);
    time.ends_s = std::max(time.ends_s, run.last_s());
  }
  std::vector<Run> runs;
  std::vector<ActiveRun> active;
  runs.reserve(bees.runs().size());
  active.reserve(bees.runs().size());
  for (std::uint32_t place = 0; place < bees.runs().size(); ++place) {
    const LiveRun& live = bees.runs()[place];
    runs.push_back({place, 0.0, live.fixes, live.heights_m, live.complete});
    if (live.fixes.empty()) continue;
    std::size_t piece = 0;
    while (piece + 2 < live.fixes.size() && live.fixes[piece + 1].time_s < time.begins_s) ++piece;
    active.push_back({place, piece});
  }
  if (!active.empty()) {
    const StepBalls enclosed(runs, active, time, with);
    const double blur_m = 0x1p-46 * farthest_coordinate(runs, active);
    const Step step{0.5 * (time.ends_s - time.begins_s) * (1.0 + 0x1p-50),
                    separation_.outer.reach_m() * (1.0 + 0x1p-50) + blur_m};
    add_candidates(find_passing(enclosed.balls(), step, with, search::Choices{}), active,
                   bees.runs());
    walk(time, runs, bees.runs(), with, events);
  }
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
        fresh.push_back({first.run, second.run, {first.piece, second.piece}, {}});
      }
    }
  }
  const auto ascending = [](const LivePair& a, const LivePair& b) {
    return a.places() < b.places();
  };
  std::sort(fresh.begin(), fresh.end(), ascending);
  for (LivePair& kept : pairs_) {
    kept.candidate = std::binary_search(fresh.begin(), fresh.end(), kept, ascending);
  }
  // Of two alike, the one under way comes first in the union, and is the one that is kept.
  std::vector<LivePair> all;
  all.reserve(pairs_.size() + fresh.size());
  std::set_union(pairs_.begin(), pairs_.end(), fresh.begin(), fresh.end(), std::back_inserter(all),
                 ascending);
  pairs_ = std::move(all);
}

void LiveWalks::walk(const TimeSpan& time, const std::vector<Run>& runs,
                     const std::vector<LiveRun>& bees, const core::Resources& with,
                     std::vector<SwarmEvent>& events) {
  std::vector<std::vector<SwarmEvent>> told(with.crew.size());
  with.crew.split(pairs_.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    for (std::size_t i = begin; i < end; ++i) {
      LivePair& pair = pairs_[i];
      if (!pair.candidate && !pair.state.open) continue;
      PairTeller teller(bees[pair.first].bee, bees[pair.second].bee, margin_m_, pair.said,
                        told[worker]);
      PairWalk(runs[pair.first], runs[pair.second], separation_)
          .walk(
              time, pair.state, [&](const PairWalk::Stretch& stretch) { teller.ended(stretch); },
              [&](const PairWalk::Stretch& stretch) { teller.going_on(stretch); });
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
  std::erase_if(pairs_, [&](const LivePair& pair) {
    return bees.runs()[pair.first].complete || bees.runs()[pair.second].complete;
  });
  std::vector<std::uint32_t> dropped;
  const double known_from_s = bees.forget(dropped);
  // Whoever has been walked beyond that must not be walked there again.
  std::erase_if(pairs_, [&](const LivePair& pair) {
    return !pair.state.open && pair.state.walked_until < known_from_s;
  });
  for (LivePair& pair : pairs_) {
    pair.state.first_piece -= dropped[pair.first];
    pair.state.second_piece -= dropped[pair.second];
  }
}

}  // namespace beespace::motion
