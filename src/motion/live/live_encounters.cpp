#include "motion/live/live_encounters.hpp"

#include "motion/passing/passing_search.hpp"
#include "search/tuning_overrides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

namespace beespace::motion {

namespace {

double farthest_coordinate(std::span<const TrackSegment> segments,
                           std::span<const ActiveSegment> active) {
  double farthest_m = 0.0;
  for (const ActiveSegment& a : active) {
    for (const Fix& fix : segments[a.segment].fixes) {
      const Point& p = fix.position;
      farthest_m = std::max({farthest_m, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
  }
  return farthest_m;
}

// The piece of a segment at that time, or its first one.
std::size_t piece_at(const TrackSegment& segment, double time_s) {
  std::size_t piece = 0;
  while (piece + 1 < segment.pieces() && piece_of(segment, piece).to.time_s < time_s) ++piece;
  return piece;
}

// The time span with new information. A pair is known until the first of the two was last heard. So
// the span begins where a bee that has been heard since was last searched, and ends with the last
// report but one of another bee. It is empty where there is none.
TimeSpan new_time(const std::vector<LiveSegment>& segments) {
  TimeSpan time{std::numeric_limits<double>::infinity(), LiveSegment::kNever};
  double last_s = LiveSegment::kNever;
  for (const LiveSegment& segment : segments) {
    if (segment.fixes.empty()) continue;
    time.ends_s = std::max(time.ends_s, std::min(last_s, segment.last_s()));
    last_s = std::max(last_s, segment.last_s());
    if (segment.searched_until_s >= segment.last_s()) continue;
    time.begins_s =
        std::min(time.begins_s, std::max(segment.searched_until_s, segment.fixes.front().time_s));
  }
  return time;
}

// The event of a pair at the end of what is known.
EventKind cut_off(const LiveSegment& a, const LiveSegment& b) {
  const auto either = [&](SegmentEnd end) {
    return (a.complete && a.end == end) || (b.complete && b.end == end);
  };
  if (either(SegmentEnd::kRemoved)) return EventKind::kLeft;
  return either(SegmentEnd::kSilent) ? EventKind::kLost : EventKind::kEnded;
}

}  // namespace

LeftOut LiveEncounters::search(LiveBees& bees, const core::Resources& with,
                               std::vector<SwarmEvent>& events) {
  Places places(bees.segments(), &with.memory);
  places.segments.reserve(bees.segments().size());
  for (std::uint32_t place = 0; place < bees.segments().size(); ++place) {
    const LiveSegment& live = bees.segments()[place];
    places.segments.push_back({place, 0.0, live.fixes, live.heights_m, live.complete});
  }
  LeftOut left_out;
  const core::Vector<Pair> fresh = fresh_pairs(places, with, left_out);
  const WalkedPairs& all = walk(places, fresh, with);
  all.open(pairs_);
  const auto ascending = [](const LivePair& a, const LivePair& b) {
    return a.places() < b.places();
  };
  if (!std::is_sorted(pairs_.begin(), pairs_.end(), ascending)) {
    std::sort(pairs_.begin(), pairs_.end(), ascending);
  }
  events.insert(events.end(), all.events.begin(), all.events.end());
  events.insert(events.end(), all.lost.begin(), all.lost.end());
  if (all.left_out.any) left_out.add(all.left_out.count, all.left_out.from_m);
  note_entered(bees.segments());
  forget(bees, with);
  return left_out;
}

// Pairs of places, the lower first, ascending, that may be in conflict in the time span with new
// information.
core::Vector<Pair> LiveEncounters::fresh_pairs(Places& places, const core::Resources& with,
                                               LeftOut& left_out) {
  core::Vector<Pair> fresh(&with.memory);
  const TimeSpan time = new_time(places.live);
  if (!(time.begins_s <= time.ends_s)) return fresh;
  const core::Vector<TrackSegment>& segments = places.segments;
  core::Vector<ActiveSegment> active(&with.memory);
  active.reserve(segments.size());
  for (std::uint32_t place = 0; place < segments.size(); ++place) {
    const TrackSegment& segment = segments[place];
    if (segment.fixes.empty() || segment.ends_s() < time.begins_s ||
        segment.begins_s() > time.ends_s)
      continue;
    places.pieces[place] = piece_at(segment, time.begins_s);
    active.push_back({place, places.pieces[place]});
  }
  const StepBalls enclosed(segments, active, time, with);
  const double blur_m = 0x1p-46 * farthest_coordinate(segments, active);
  const Step step{0.5 * (time.ends_s - time.begins_s) * (1.0 + 0x1p-50),
                  separation_.outer.reach_m() * (1.0 + 0x1p-50) + blur_m};
  const auto found = candidates(enclosed.balls(), step, with, left_out);
  fresh.resize(core::size_of(found));
  core::order_pairs(found, core::Direction::kAscending, active.size(), with, fresh.data());
  for (Pair& pair : fresh) pair = {active[pair.first].segment, active[pair.second].segment};
  return fresh;
}

// Of too many, those that pass most closely: by a separation with few enough pairs.
core::Vector<core::FoundPairs> LiveEncounters::candidates(const MovingBalls& balls,
                                                          const Step& step,
                                                          const core::Resources& with,
                                                          LeftOut& left_out) {
  Step tried = step;
  tried.most = 4 * std::uint64_t{max_pairs_} + 16 * balls.middles.size();
  std::optional<core::Vector<core::FoundPairs>> found;
  const auto few = [&](double share) {
    tried.clearance_m = share * step.clearance_m;
    auto some = find_passing(balls, tried, with, search::TuningOverrides{});
    if (core::size_of(some) > tried.most) return false;
    found.emplace(std::move(some));
    return true;
  };
  if (share_.choose(few)) {
    if (share_.value() < 1.0) left_out.add(0, share_.value() * separation_.inner.threshold_m);
    return *std::move(found);
  }
  // All of them are at one place: any of them, but the same ones for any number of threads.
  left_out.add(0, 0.0);
  Crew alone;
  return find_passing(balls, tried, {alone, with.memory}, search::TuningOverrides{});
}

const WalkedPairs& LiveEncounters::walk(const Places& places, const core::Vector<Pair>& fresh,
                                        const core::Resources& with) {
  walked_.resize(with.crew.size(), WalkedPairs(max_pairs_));
  for (WalkedPairs& walked : walked_) walked.clear();
  with.crew.split(pairs_.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    for (std::size_t i = begin; i < end; ++i) walk(places, pairs_[i], walked_[worker]);
  });
  with.crew.split(fresh.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    if (begin == end) return;
    const auto before = [](const LivePair& kept, const Pair& pair) {
      return std::tie(kept.first, kept.second) < std::tie(pair.first, pair.second);
    };
    auto kept = std::lower_bound(pairs_.begin(), pairs_.end(), fresh[begin], before);
    for (std::size_t i = begin; i < end; ++i) {
      const Pair& pair = fresh[i];
      while (kept != pairs_.end() && before(*kept, pair)) ++kept;
      if (kept != pairs_.end() && kept->first == pair.first && kept->second == pair.second) {
        continue;
      }
      const LiveSegment& first = places.live[pair.first];
      const LiveSegment& second = places.live[pair.second];
      if (first.bee == second.bee) continue;
      LivePair begun{pair.first, pair.second, {}, {}};
      begun.state.first_piece = places.pieces[pair.first];
      begun.state.second_piece = places.pieces[pair.second];
      begun.state.walked_before = std::min(first.searched_until_s, second.searched_until_s);
      walk(places, begun, walked_[worker]);
    }
  });
  WalkedPairs& all = walked_.front();
  for (std::size_t worker = 1; worker < walked_.size(); ++worker) all.append(walked_[worker]);
  all.cut();
  return all;
}

void LiveEncounters::walk(const Places& places, LivePair pair, WalkedPairs& walked) const {
  const LiveSegment& first = places.live[pair.first];
  const LiveSegment& second = places.live[pair.second];
  const bool had_entered = pair.reported.entered;
  const std::size_t before = walked.events.size();
  EventEmitter emitter(first.bee, second.bee, margin_m_, cut_off(first, second), pair.reported,
                       walked.events);
  constexpr TimeSpan kEver{LiveSegment::kNever, -LiveSegment::kNever};
  PairWalk(places.segments[pair.first], places.segments[pair.second], separation_, true)
      .walk(
          kEver, pair.state, [&](const PairWalk::Stretch& stretch) { emitter.ended(stretch); },
          [&](const PairWalk::Stretch& stretch) { emitter.going_on(stretch); });
  if (pair.state.open && (first.done || second.done)) {
    pair.state.open->cut_off = true;
    emitter.ended(*std::exchange(pair.state.open, std::nullopt));
  }
  const std::size_t reported = walked.events.size() - before;
  if (!pair.state.open && reported == 0) return;
  double distance_m = std::numeric_limits<double>::infinity();
  if (pair.state.open) distance_m = pair.state.open->end_m;
  for (std::size_t k = before; k < walked.events.size(); ++k) {
    distance_m = std::min(distance_m, walked.events[k].distance_m);
  }
  const AgentPair bees{std::min(first.bee, second.bee), std::max(first.bee, second.bee)};
  walked.add(pair, bees, reported, distance_m, had_entered);
}

void LiveEncounters::note_entered(const std::vector<LiveSegment>& bees) {
  entered_.clear();
  for (const LivePair& pair : pairs_) {
    if (!pair.reported.entered) continue;
    const AgentId a = bees[pair.first].bee;
    const AgentId b = bees[pair.second].bee;
    entered_.push_back({std::min(a, b), std::max(a, b)});
  }
  if (!std::is_sorted(entered_.begin(), entered_.end()))
    std::sort(entered_.begin(), entered_.end());
}

void LiveEncounters::forget(LiveBees& bees, const core::Resources& with) {
  core::Vector<std::uint32_t> dropped(&with.memory);
  bees.forget(dropped);
  for (LivePair& pair : pairs_) {
    pair.state.walked_before = LiveSegment::kNever;
    pair.state.first_piece -= dropped[pair.first];
    pair.state.second_piece -= dropped[pair.second];
  }
}

}  // namespace beespace::motion
