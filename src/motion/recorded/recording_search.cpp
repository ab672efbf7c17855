#include "motion/recorded/recording_search.hpp"

#include "base/stopping.hpp"
#include "exact/validate.hpp"
#include "grid/density.hpp"
#include "motion/pair_walk.hpp"
#include "motion/passing/passing_search.hpp"
#include "motion/passing/step_balls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace beespace::motion {

namespace {

// A pair of segments on which a walk has begun, or is to begin.
struct PairState {
  std::uint32_t first;
  std::uint32_t second;
  PairWalk::State state;
  bool candidate = true;  // of this step; else it is kept only so that no window is walked twice

  [[nodiscard]] auto pair() const { return std::tie(first, second); }
};

double speed_on(const Piece& piece) {
  if (piece.instant()) return 0.0;
  const Point& p = piece.from.position;
  const Point& q = piece.to.position;
  const double lasts = piece.to.time_s - piece.from.time_s;
  return std::sqrt((q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y) +
                   (q.z - p.z) * (q.z - p.z)) /
         lasts;
}

// What this part of the values is below.
double quantile(std::vector<double>& values, double part) {
  const auto found =
      values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size()));
  std::nth_element(values.begin(), found, values.end());
  return *found;
}

class RecordingSearch {
 public:
  RecordingSearch(const std::vector<TrackSegment>& segments, const Separation& separation,
                  std::uint64_t max_results, const core::Resources& with,
                  const RecordingTuning& tuning)
      : segments_(segments),
        separation_(separation),
        max_results_(max_results),
        with_(with),
        tuning_(tuning),
        clearance_m_(separation.reach_m()),
        by_begin_(segments.size()) {
    std::iota(by_begin_.begin(), by_begin_.end(), 0U);
    std::sort(by_begin_.begin(), by_begin_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(segments[a].begins_s(), a) < std::pair(segments[b].begins_s(), b);
    });
    for (const TrackSegment& segment : segments) {
      last_s_ = std::max(last_s_, segment.ends_s());
      for (const Fix& fix : segment.fixes) {
        const Point& p = fix.position;
        farthest_m_ = std::max({farthest_m_, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
      }
    }
  }

  Result<std::vector<Conflict>> search() {
    if (segments_.empty()) return std::move(found_);
    double begin = segments_[by_begin_.front()].begins_s();
    while (true) {
      enter(begin, begin);
      const TimeSpan time{begin, step_end(begin)};
      enter(begin, time.ends_s);
      take_step(time);
      if (found_.size() > max_results_) return core::too_many_results(max_results_);
      if (time.ends_s >= last_s_) break;
      begin = time.ends_s;
    }
    for (PairState& pair : walks_) {
      if (pair.state.open) found_.push_back(pair.state.open->conflict);
    }
    if (found_.size() > max_results_) return core::too_many_results(max_results_);
    order_conflicts(found_);
    return std::move(found_);
  }

 private:
  // The bees that are there at some time from `begin` to `end`, and the first piece of each.
  void enter(double begin, double end) {
    std::erase_if(active_,
                  [&](const ActiveSegment& a) { return segments_[a.segment].ends_s() < begin; });
    for (; next_ < by_begin_.size() && segments_[by_begin_[next_]].begins_s() <= end; ++next_) {
      active_.push_back({by_begin_[next_], 0});
    }
    for (ActiveSegment& a : active_) {
      const TrackSegment& segment = segments_[a.segment];
      while (a.piece + 1 < segment.pieces() && piece_of(segment, a.piece).to.time_s < begin)
        ++a.piece;
    }
  }

  double step_end(double begin) {
    // None is there: until one comes.
    const double next = next_ < by_begin_.size() ? segments_[by_begin_[next_]].begins_s() : last_s_;
    const double left = last_s_ - begin;
    if (active_.empty()) return next;
    const double step = tuning_.step_s ? *tuning_.step_s : cheapest_step(begin, left);
    const double end = begin + step;
    return end > begin && step < left ? std::min(end, last_s_) : last_s_;
  }

  // How bees move, but for few.
  struct BeeMotion {
    double speed;    // the most, in metres a second
    double turn;     // by how much the velocity changes behind a piece
    double lasts_s;  // a piece
  };

  // By how much the velocity of a bee changes behind its piece.
  double turn_behind(const ActiveSegment& active) const {
    const TrackSegment& segment = segments_[active.segment];
    if (active.piece + 1 >= segment.pieces()) return 0.0;
    const Piece piece = piece_of(segment, active.piece);
    const Piece next = piece_of(segment, active.piece + 1);
    if (piece.instant() || next.instant()) return 0.0;
    const Point& p = piece.from.position;
    const Point& q = piece.to.position;
    const Point& r = next.to.position;
    const double before_s = piece.lasts_s();
    const double after_s = next.lasts_s();
    const double x = (r.x - q.x) / after_s - (q.x - p.x) / before_s;
    const double y = (r.y - q.y) / after_s - (q.y - p.y) / before_s;
    const double z = (r.z - q.z) / after_s - (q.z - p.z) / before_s;
    return std::sqrt(x * x + y * y + z * z);
  }

  // The step with the least cost per time: short steps sort often, long ones compare many pairs.
  double cheapest_step(double begin, double left) {
    core::Buffer<Point> places(with_.memory, active_.size());
    std::vector<double> speeds;
    std::vector<double> turns;
    double lasts_s = 0.0;
    const std::size_t stride = active_.size() / 128 + 1;
    for (std::size_t i = 0; i < active_.size(); ++i) {
      const Piece piece = piece_of(segments_[active_[i].segment], active_[i].piece);
      places[i] = position_on(piece, std::max(begin, piece.from.time_s));
      if (i % stride != 0) continue;
      speeds.push_back(speed_on(piece));
      turns.push_back(turn_behind(active_[i]));
      lasts_s += piece.lasts_s();
    }
    // Balls that enclose many pieces decide little.
    constexpr double kPieces = 4.0;
    const double mean_s = lasts_s / static_cast<double>(speeds.size());
    if (mean_s > 0.0) left = std::min(left, kPieces * mean_s);
    const BeeMotion motion{quantile(speeds, 0.9), quantile(turns, 0.5), mean_s};
    const core::DensitySample sample(std::span<const Point>(places.data(), active_.size()),
                                     with_.memory);
    double best = left;
    double best_cost = 0.0;
    double step = left;
    while (step > 0.0) {
      const double cost = cost_of(step, motion, sample) / step;
      if (step == left || cost < best_cost) {
        best = step;
        best_cost = cost;
      }
      if (motion.speed * step < 0.25 * clearance_m_) break;
      step *= 0.7;
    }
    return best;
  }

  // What such a step costs, in nanoseconds.
  double cost_of(double step, const BeeMotion& motion, const core::DensitySample& sample) const {
    // Measured: the cost of a step, of enclosing and sorting a bee, and of comparing it with one
    // other.
    constexpr double kStep = 30'000.0;
    constexpr double kSorting = 150.0;
    constexpr double kComparing = 0.25;
    // And of walking along a piece with one whose ball it meets. A ball has about this part of the
    // changes of velocity in a step as its radius; this cube is as large as a ball of radius 1.
    constexpr double kWalking = 100.0;
    constexpr double kRadius = 0.25;
    constexpr double kCube = 1.6;
    const auto bees = static_cast<double>(active_.size());
    const double reach = clearance_m_ + motion.speed * step;
    const double met = std::min(bees, sample.expected_neighbors(2.6 * reach));
    double with_others = 0.5 * kComparing * met;
    // Of smaller balls, few are walked but those that are near in steps of any length.
    const double bend = 2.0 * kRadius * motion.turn * std::min(step, 2.0 * motion.lasts_s);
    if (bend > clearance_m_) {
      const double walked = std::min(bees, sample.expected_neighbors(kCube * bend));
      with_others += 0.5 * kWalking * walked * step / motion.lasts_s;
    }
    return kStep + bees * (kSorting + with_others);
  }

  void take_step(const TimeSpan& time) {
    if (active_.empty()) return;
    const StepBalls enclosed(segments_, active_, time, with_);
    // Positions along the way are wrong by a few roundings of these.
    const double blur_m = 0x1p-48 * farthest_m_;
    const Step step{0.5 * (time.ends_s - time.begins_s) * (1.0 + 0x1p-50),
                    clearance_m_ * (1.0 + 0x1p-50) + 4.0 * blur_m};
    walk(time, pairs_of(find_passing(enclosed.balls(), step, with_, tuning_.search)));
  }

  // Throws where a stop was requested: between long pieces of work that no crew does.
  void look_for_stop(const std::vector<PairState>& pairs) const {
    constexpr std::size_t kLong = 100'000;
    const auto nothing = [](unsigned) {};
    if (pairs.size() > kLong) with_.crew.run(nothing);
  }

  // The pairs to walk, ascending: the candidates, and those on which a walk is under way.
  std::vector<PairState> pairs_of(const core::Vector<core::FoundPairs>& candidates) {
    std::vector<PairState> pairs;
    for (const core::FoundPairs& part : candidates) {
      for (const auto& chunk : part.chunks()) {
        for (std::uint32_t k = 0; k < chunk.size; ++k) {
          ActiveSegment first = active_[chunk.first[k]];
          ActiveSegment second = active_[chunk.second[k]];
          if (segments_[first.segment].track == segments_[second.segment].track) continue;
          if (first.segment > second.segment) std::swap(first, second);
          pairs.push_back({first.segment, second.segment, {first.piece, second.piece}});
        }
      }
    }
    const auto ascending = [](const PairState& a, const PairState& b) {
      return a.pair() < b.pair();
    };
    look_for_stop(pairs);
    std::sort(pairs.begin(), pairs.end(), ascending);
    look_for_stop(pairs);
    std::vector<PairState> all;
    all.reserve(pairs.size() + walks_.size());
    auto walk = walks_.begin();
    for (PairState& kept : walks_) kept.candidate = false;
    for (const PairState& pair : pairs) {
      while (walk != walks_.end() && walk->pair() < pair.pair()) all.push_back(*walk++);
      const bool begun = walk != walks_.end() && walk->pair() == pair.pair();
      all.push_back(begun ? *walk++ : pair);
      all.back().candidate = true;
    }
    all.insert(all.end(), walk, walks_.end());
    return all;
  }

  void walk(const TimeSpan& time, std::vector<PairState> pairs) {
    std::vector<std::vector<Conflict>> ended(with_.crew.size());
    with_.crew.split(pairs.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
      constexpr std::size_t kPairsAtOnce = 256;
      for (std::size_t i = begin; i < end; ++i) {
        if ((i - begin) % kPairsAtOnce == 0 && core::is_stopping()) return;
        PairState& pair = pairs[i];
        if (!pair.candidate && !pair.state.open) continue;
        const TrackSegment& first = segments_[pair.first];
        const TrackSegment& second = segments_[pair.second];
        const WalkSeparation separation = WalkSeparation::within(separation_, first, second);
        PairWalk(first, second, separation)
            .walk(time, pair.state, [&](const PairWalk::Stretch& stretch) {
              ended[worker].push_back(stretch.conflict);
            });
      }
    });
    for (const std::vector<Conflict>& part : ended) {
      found_.insert(found_.end(), part.begin(), part.end());
    }
    // A pair that has been walked beyond the step must not be walked there again.
    std::erase_if(pairs, [&](const PairState& pair) {
      return !pair.state.open && pair.state.walked_until < time.ends_s;
    });
    walks_ = std::move(pairs);
  }

  const std::vector<TrackSegment>& segments_;
  Separation separation_;
  std::uint64_t max_results_;
  const core::Resources& with_;
  const RecordingTuning& tuning_;
  double clearance_m_;
  double farthest_m_ = 0.0;
  double last_s_ = -std::numeric_limits<double>::infinity();
  std::vector<std::uint32_t> by_begin_;  // segments
  std::size_t next_ = 0;                 // of these, to enter
  std::vector<ActiveSegment> active_;
  std::vector<PairState> walks_;  // under way, ascending
  std::vector<Conflict> found_;
};

}  // namespace

void order_conflicts(std::vector<Conflict>& conflicts) {
  std::sort(conflicts.begin(), conflicts.end(), [](const Conflict& a, const Conflict& b) {
    // Two that begin at one instant by rounding have an order, too.
    return std::tie(a.first, a.second, a.begins_s, a.ends_s) <
           std::tie(b.first, b.second, b.begins_s, b.ends_s);
  });
}

Result<std::vector<Conflict>> search_recording(const std::vector<TrackSegment>& segments,
                                               const Separation& separation,
                                               std::uint64_t max_results,
                                               const core::Resources& with,
                                               const RecordingTuning& tuning) {
  return RecordingSearch(segments, separation, max_results, with, tuning).search();
}

}  // namespace beespace::motion
