// The bees of a live swarm: the reports of each, as far back as they matter.
#pragma once

#include "motion/track_segments.hpp"

#include <beespace/swarm.hpp>

#include <cstdint>
#include <limits>
#include <memory_resource>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace beespace::motion {

// Two agents, the lower first.
struct AgentPair {
  AgentId first;
  AgentId second;

  friend constexpr bool operator==(const AgentPair&, const AgentPair&) = default;
  friend constexpr bool operator<(const AgentPair& a, const AgentPair& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  }
};

// The reason why a segment is complete.
enum class SegmentEnd : std::uint8_t { kSilent, kRemoved, kFinished };

// Reports of one bee without a gap. When it is heard again after a gap, another segment begins.
struct LiveSegment {
  static constexpr double kNever = -std::numeric_limits<double>::infinity();

  AgentId bee = 0;
  bool complete = true;  // no report will be added
  bool done = false;     // it is complete, and the next search is the last one that needs it
  SegmentEnd end = SegmentEnd::kSilent;
  std::vector<Fix> fixes = {};            // empty: the place is free
  std::vector<double> heights_m = {};     // empty, or one for each fix
  std::optional<Velocity> velocity = {};  // of the last, where it was given
  double climb_mps = 0.0;
  double searched_until_s = kNever;                                   // its last report then
  double complete_since_s = std::numeric_limits<double>::infinity();  // by the clock of searches

  [[nodiscard]] double last_s() const { return fixes.back().time_s; }
  [[nodiscard]] bool moves() const { return velocity.has_value() || fixes.size() > 1; }
  // The present state, extrapolated from the last report; nothing after one report without a
  // velocity.
  struct Now {
    Mover mover;
    double height_m;
    double climb_mps;
  };
  [[nodiscard]] std::optional<Now> at(double now_s) const;
};

// The state of a bee, until it is removed.
struct KnownBee {
  static constexpr std::uint32_t kStale = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t segment = kStale;  // the place of the segment under way
  Fix last = {};                   // its last report, if it has no segment
  double height_m = 0.0;
  double unknown_s = 0.0;   // silences that are over
  bool waiting = false;     // without a segment and not stale: times have begun anew
  bool lost = false;        // stale from its last report on, at any age
  bool unreported = false;  // and not yet reported as such
  bool once = true;         // heard only once

  [[nodiscard]] bool has_segment() const { return segment != kStale; }
  [[nodiscard]] bool stale() const { return segment == kStale && !waiting; }
};

// A bee has been heard again after a silence.
struct Return {
  AgentId bee;
  double since_s;
  double heard_s;
  bool reported_stale;  // reported as stale meanwhile
  Fix last;             // before it
  double height_m;
  bool lost;
};

class LiveBees {
 public:
  explicit LiveBees(bool heights_apart) : heights_apart_(heights_apart) {}

  // Returns what became of the report, whose values are flushed; kFull if it is of a new bee beyond
  // `max_agents`.
  enum class Taken : std::uint8_t { kYes, kRepeated, kLate, kContrary, kFull };
  Taken take(const PositionReport& report, double max_age_s,
             std::size_t max_agents = std::numeric_limits<std::size_t>::max());

  // Removes a bee; nothing happens if it is unknown.
  void remove(AgentId bee);
  // Breaks the segment of a bee: it is stale until its next report.
  void lose(AgentId bee);
  // Completes the segments of all bees that have not been heard for more than max_age_s; calls
  // stale(bee, last heard). Compares the difference of the two times, as take() does between two
  // reports.
  template <class Stale>
  void complete_stale(double now_s, double max_age_s, Stale&& stale);
  // Completes all segments: the input has ended, or times begin anew, and all bees are waited for.
  void complete_all(bool anew);
  // After that and a search, shifts all times by so much. The last known positions are kept.
  void begin_anew(double later_s);

  // Segments by their place, which stays as long as the segment does.
  [[nodiscard]] const std::vector<LiveSegment>& segments() const { return segments_; }
  [[nodiscard]] const std::unordered_map<AgentId, KnownBee>& known() const { return known_; }
  [[nodiscard]] std::size_t under_way() const { return known_.size() - stale_; }
  [[nodiscard]] std::size_t heard_once() const { return once_; }
  // Stale, and not heard since.
  [[nodiscard]] std::size_t stale() const { return stale_; }
  // Grows with each bee that comes, goes, falls silent or is heard again; above zero.
  [[nodiscard]] std::uint64_t changes() const { return changes_; }
  // How long bees were unknown that have been heard again, removed ones included.
  [[nodiscard]] double unknown_s() const { return unknown_s_; }
  // How far segments began before what is still known, in all.
  [[nodiscard]] double missed_s() const { return missed_s_; }
  // Returns since the last call; overwritten.
  void take_returns(std::vector<Return>& returns) {
    returns.clear();
    returns.swap(returns_);
  }

  // Before a search: marks the complete segments that are done. A segment is kept until all others
  // have been heard as late as it was, but for no longer than they take to become stale.
  void settle(double now_s, double max_age_s);

  // After a search: forgets segments that are done, and fixes before those that the next search
  // needs. Sets dropped[place] to the number of fixes dropped from a segment.
  void forget(std::pmr::vector<std::uint32_t>& dropped);

 private:
  [[nodiscard]] std::optional<Taken> before_last(const KnownBee& bee,
                                                 const PositionReport& report) const;
  void add(LiveSegment& segment, const PositionReport& report) const;
  void begin_segment(KnownBee& bee, const PositionReport& report);
  void complete(KnownBee& bee, SegmentEnd end);
  void give_back();
  [[nodiscard]] double known_from_s() const;

  bool heights_apart_;
  std::vector<LiveSegment> segments_;
  std::vector<std::uint32_t> free_;  // places
  std::unordered_map<AgentId, KnownBee> known_;
  std::size_t stale_ = 0;
  std::size_t waiting_ = 0;
  std::size_t once_ = 0;
  std::vector<AgentId> lost_;  // and not reported
  std::uint64_t changes_ = 1;
  double unknown_s_ = 0.0;
  double missed_s_ = 0.0;
  double forgotten_until_s_ = LiveSegment::kNever;
  std::vector<Return> returns_;
};

template <class Stale>
void LiveBees::complete_stale(double now_s, double max_age_s, Stale&& stale) {
  for (const AgentId id : std::exchange(lost_, {})) {
    const auto at = known_.find(id);
    if (at == known_.end() || !std::exchange(at->second.unreported, false)) continue;
    stale(id, at->second.last.time_s);
  }
  if (waiting_ > 0) {
    for (auto& [id, bee] : known_) {
      if (!bee.waiting || now_s - bee.last.time_s <= max_age_s) continue;
      bee.waiting = false;
      --waiting_;
      ++stale_;
      ++changes_;
      stale(id, bee.last.time_s);
    }
  }
  for (const LiveSegment& segment : segments_) {
    if (segment.fixes.empty() || segment.complete) continue;
    if (now_s - segment.last_s() <= max_age_s) continue;
    stale(segment.bee, segment.last_s());
    complete(known_.find(segment.bee)->second, SegmentEnd::kSilent);
  }
}

}  // namespace beespace::motion
