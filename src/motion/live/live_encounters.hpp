// Past encounters of live bees: walks along the reports that have come since the last search.
#pragma once

#include "base/resources.hpp"
#include "motion/live/event_emitter.hpp"
#include "motion/live/live_bees.hpp"
#include "motion/live/live_overload.hpp"
#include "motion/pair_walk.hpp"
#include "motion/passing/passing_search.hpp"
#include "motion/passing/step_balls.hpp"

#include <beespace/pairs.hpp>
#include <beespace/swarm.hpp>

#include <cstdint>
#include <limits>
#include <memory_resource>
#include <tuple>
#include <vector>

namespace beespace::motion {

// Two segments by their places, the lower first, with the walked time and the reported events.
struct LivePair {
  std::uint32_t first;
  std::uint32_t second;
  PairWalk::State state;
  EventEmitter::Reported reported;

  [[nodiscard]] auto places() const { return std::tie(first, second); }
};

// Walked pairs that are in conflict, or have events, at most the closest `most` of them, and their
// events.
class WalkedPairs {
 public:
  explicit WalkedPairs(std::size_t most) : most_(most) {}

  // `reported` is how many of the last events are of this pair, whose bees are the lower and the
  // higher of `bees`; `had_entered` is its state before this search.
  void add(const LivePair& pair, const AgentPair& bees, std::size_t reported, double distance_m,
           bool had_entered);
  void append(const WalkedPairs& other);
  void clear();
  // Keeps only the closest pairs. Those that had entered before are lost then.
  void cut();

  std::vector<SwarmEvent> events;  // in the order of the pairs
  std::vector<SwarmEvent> lost;    // of those that were given up
  LeftOut left_out;

  // Pairs in conflict by the outer separation; overwritten.
  void open(std::vector<LivePair>& open) const;

 private:
  struct Walked {
    LivePair pair;
    AgentPair bees;
    std::uint32_t reported;
    bool had_entered;
    double distance_m;

    // Pairs that had entered are given up only for clearly closer ones.
    [[nodiscard]] double key() const { return had_entered ? 0.75 * distance_m : distance_m; }
  };
  void give_up(const Walked& walked);

  std::size_t most_;
  std::vector<Walked> pairs_;
};

class LiveEncounters {
 public:
  // Bees enter by the inner separation and leave by the outer one.
  LiveEncounters(const WalkSeparation& separation, double margin_m,
                 std::size_t max_pairs = std::numeric_limits<std::uint32_t>::max())
      : separation_(separation), margin_m_(margin_m), max_pairs_(max_pairs) {}

  // Searches the new time span, reports events, and lets the bees forget what is no longer needed.
  // Returns what there were too many of.
  LeftOut search(LiveBees& bees, const core::Resources& with, std::vector<SwarmEvent>& events);

  // The pairs that have entered and not left, ascending.
  [[nodiscard]] const std::vector<AgentPair>& entered() const { return entered_; }

 private:
  // Segments by their places, and the pieces at which to begin.
  struct Places {
    explicit Places(const std::vector<LiveSegment>& all, std::pmr::memory_resource* memory)
        : live(all), segments(memory), pieces(all.size(), 0, memory) {}

    const std::vector<LiveSegment>& live;
    core::Vector<TrackSegment> segments;
    core::Vector<std::size_t> pieces;
  };

  core::Vector<core::FoundPairs> candidates(const MovingBalls& balls, const Step& step,
                                            const core::Resources& with, LeftOut& left_out);
  core::Vector<Pair> fresh_pairs(Places& places, const core::Resources& with, LeftOut& left_out);
  const WalkedPairs& walk(const Places& places, const core::Vector<Pair>& fresh,
                          const core::Resources& with);
  void walk(const Places& places, LivePair pair, WalkedPairs& walked) const;
  void note_entered(const std::vector<LiveSegment>& bees);
  void forget(LiveBees& bees, const core::Resources& with);

  WalkSeparation separation_;
  double margin_m_;
  std::size_t max_pairs_;
  Share share_;                      // of the separation, within which pairs are followed
  std::vector<LivePair> pairs_;      // in conflict by the outer separation, ascending
  std::vector<AgentPair> entered_;   // ascending
  std::vector<WalkedPairs> walked_;  // of each worker, in one call
};

}  // namespace beespace::motion
