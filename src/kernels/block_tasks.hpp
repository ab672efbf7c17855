// What becomes of the near pairs of a sweep by itself: the tasks of block_sweep_kernel.hpp.
//
// Included by the sweep_<instruction set>.cpp files only, through sweep_kernel.hpp; the rules of
// sweep_lanes.hpp hold. Comparing does not branch on whether a pair is near.
#pragma once

#include "kernels/block_sweep_kernel.hpp"
#include "kernels/sweep_lanes.hpp"

#include <cstdint>

namespace beespace::cpu {
namespace {

template <class Lanes>
class MarkBoth {
 public:
  static constexpr bool kForItself = false;
  static constexpr bool kMeasures = false;
  using Seen = typename Lanes::Seen;

  explicit MarkBoth(const Marks& marks) : marks_(marks) {}

  static constexpr const std::uint32_t* words() { return nullptr; }
  void start(std::uint32_t i) {
    near_ = 0;
    ahead_ = 0;
    first_ahead_ = i;
  }
  void start(const Beside&, std::uint32_t, std::uint32_t) { near_ = 0; }
  bool beside(const Seen& seen, std::uint32_t, std::uint32_t j) {
    if (j - first_ahead_ > kMostAhead) [[unlikely]] {
      mark_ahead();
      first_ahead_ = j;
    }
    ahead_ |= std::uint64_t{seen.near} << (j - first_ahead_);
    near_ |= seen.near;
    return true;
  }
  bool across(const Seen& seen, const Beside& theirs, std::uint32_t j) {
    std::uint8_t& mark = marks_.others[theirs.place[j] - marks_.first_other];
    mark = static_cast<std::uint8_t>(mark | (seen.near != 0 ? 1U : 0U));
    near_ |= seen.near;
    return true;
  }
  void finish(std::uint32_t i, std::uint32_t) {
    Lanes::mark(marks_.asked + (i - marks_.first_asked), near_);
    mark_ahead();
  }
  void finish(const Beside& mine, std::uint32_t i, std::uint32_t) {
    for (; near_ != 0; near_ &= near_ - 1) {
      const auto lane = static_cast<unsigned>(__builtin_ctz(near_));
      marks_.asked[mine.place[i + lane] - marks_.first_asked] = 1;
    }
  }

 private:
  static constexpr std::uint32_t kMostAhead = 64 - Lanes::kLanes;

  void mark_ahead() {
    std::uint8_t* marks = marks_.others + (first_ahead_ - marks_.first_other);
    for (; ahead_ != 0; ahead_ >>= Lanes::kLanes, marks += Lanes::kLanes) {
      Lanes::mark(marks, static_cast<unsigned>(ahead_ & ((1U << Lanes::kLanes) - 1)));
    }
  }

  Marks marks_;
  unsigned near_ = 0;
  // Points from the first of the block on that have met a near one, a bit each. To mark them at
  // every step would be to wait for the marks of the last step, which are a place beside.
  std::uint64_t ahead_ = 0;
  std::uint32_t first_ahead_ = 0;
};

template <class Lanes>
class CountBoth {
 public:
  // Adding to counts lane by lane would have to wait for what was just added a lane beside.
  static constexpr bool kForItself = true;
  static constexpr bool kMeasures = false;
  using Seen = typename Lanes::Seen;

  explicit CountBoth(const Counts& counts) : counts_(counts) {}

  static constexpr const std::uint32_t* words() { return nullptr; }
  void start(std::uint32_t) { tally_.clear(); }
  void start(const Beside&, std::uint32_t, std::uint32_t) { tally_.clear(); }
  bool around(const Seen& seen, std::uint32_t) {
    tally_.add(seen);
    return true;
  }
  bool across(const Seen& seen, const Beside& theirs, std::uint32_t j) {
    tally_.add(seen);
    counts_.others[theirs.place[j] - counts_.first_other] +=
        static_cast<std::uint32_t>(__builtin_popcount(seen.near));
    return true;
  }
  void finish(std::uint32_t i, std::uint32_t count) {
    std::uint32_t sums[Lanes::kLanes];
    tally_.write(sums);
    std::uint32_t* const counts = counts_.asked + (i - counts_.first_asked);
    for (std::uint32_t lane = 0; lane < count; ++lane) counts[lane] += sums[lane];
  }
  void finish(const Beside& mine, std::uint32_t i, std::uint32_t count) {
    std::uint32_t sums[Lanes::kLanes];
    tally_.write(sums);
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      counts_.asked[mine.place[i + lane] - counts_.first_asked] += sums[lane];
    }
  }

 private:
  Counts counts_;
  typename Lanes::Tally tally_;
};

// Where the next pairs are written.
class PairList {
 public:
  explicit PairList(PairSink& sink) : sink_(&sink) { read(); }

  [[nodiscard]] PointId* first() const { return first_; }
  [[nodiscard]] PointId* second() const { return second_; }
  // The lanes whose bits are set have been written; returns whether to go on.
  bool add(unsigned lanes) {
    const auto pairs = static_cast<unsigned>(__builtin_popcount(lanes));
    first_ += pairs;
    second_ += pairs;
    if (first_ <= last_) [[likely]] {
      return true;
    }
    save();
    const bool go_on = sink_->make_room(sink_->context);
    read();
    return go_on;
  }
  void save() const { sink_->size = static_cast<std::uint32_t>(first_ - sink_->first); }

 private:
  void read() {
    first_ = sink_->first + sink_->size;
    second_ = sink_->second + sink_->size;
    last_ = sink_->first + (sink_->capacity - PairSink::kMostAtOnce);
  }

  PairSink* sink_;
  PointId* first_ = nullptr;
  PointId* second_ = nullptr;
  PointId* last_ = nullptr;  // where there is room for the most at once
};

template <class Lanes>
class CollectOnce {
 public:
  static constexpr bool kForItself = false;
  static constexpr bool kMeasures = false;
  using Seen = typename Lanes::Seen;

  CollectOnce(const Sweep& sweep, PairSink& pairs) : id_(sweep.asked.id), pairs_(pairs) {}

  [[nodiscard]] const std::uint32_t* words() const { return id_; }
  void start(std::uint32_t) {}
  void start(const Beside& mine, std::uint32_t i, std::uint32_t) {
    asked_ = Lanes::words(mine.word + i);
  }
  bool beside(const Seen& seen, std::uint32_t i, std::uint32_t j) {
    Lanes::store(id_ + i, seen.near, pairs_.first());
    Lanes::store(id_ + j, seen.near, pairs_.second());
    return pairs_.add(seen.near);
  }
  bool across(const Seen& seen, const Beside& theirs, std::uint32_t j) {
    Lanes::store(asked_, seen.near, pairs_.first());
    Lanes::fill(pairs_.second(), theirs.word[j]);
    return pairs_.add(seen.near);
  }
  void finish(std::uint32_t, std::uint32_t) { pairs_.save(); }
  void finish(const Beside&, std::uint32_t, std::uint32_t) { pairs_.save(); }

 private:
  const PointId* id_;
  PairList pairs_;
  typename Lanes::Words asked_{};
};

// Of balls, each with a radius of its own.
template <class Lanes>
class CollectMeeting {
 public:
  static constexpr bool kForItself = false;
  static constexpr bool kMeasures = true;
  using Squared = typename Lanes::Floats;

  explicit CollectMeeting(const MeetingSink& meeting)
      : radius_(meeting.radius), pairs_(meeting.places) {}

  [[nodiscard]] const float* words() const { return radius_; }
  void start(std::uint32_t) {}
  void start(const Beside& mine, std::uint32_t i, std::uint32_t) {
    asked_ = Lanes::words(mine.place + i);
    asked_radius_ = Lanes::floats(mine.word + i);
  }
  bool beside(const Squared& squared, unsigned asking, std::uint32_t i, std::uint32_t j) {
    const unsigned meeting = Lanes::meeting(squared, radius_ + i, radius_ + j) & asking;
    Lanes::pack_numbers(i, meeting, pairs_.first());
    Lanes::pack_numbers(j, meeting, pairs_.second());
    return pairs_.add(meeting);
  }
  bool across(const Squared& squared, unsigned asking, const Beside& theirs, std::uint32_t j) {
    float radius = 0.0F;
    __builtin_memcpy(&radius, theirs.word + j, sizeof radius);
    const unsigned meeting = Lanes::meeting(squared, asked_radius_, radius) & asking;
    Lanes::store(asked_, meeting, pairs_.first());
    Lanes::fill(pairs_.second(), theirs.place[j]);
    return pairs_.add(meeting);
  }
  void finish(std::uint32_t, std::uint32_t) { pairs_.save(); }
  void finish(const Beside&, std::uint32_t, std::uint32_t) { pairs_.save(); }

 private:
  const float* radius_;
  PairList pairs_;
  typename Lanes::Words asked_{};
  typename Lanes::Floats asked_radius_{};
};

template <class Lanes>
class KeepNearestOfAll {
 public:
  static constexpr bool kForItself = true;
  static constexpr bool kMeasures = true;

  explicit KeepNearestOfAll(const NearestTable& table) : table_(table) {}

  static constexpr const std::uint32_t* words() { return nullptr; }
  void start(std::uint32_t) { nearest_.clear(); }
  void start(const Beside& mine, std::uint32_t i, std::uint32_t count) {
    Lists kept{};
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      const std::uint32_t place = mine.place[i + lane] - table_.first_asked;
      kept.best[lane] = table_.best[place];
      kept.second[lane] = table_.second[place];
      kept.who[lane] = table_.who[place];
    }
    nearest_.read(kept.best, kept.second, kept.who);
  }
  void measured(const typename Lanes::Floats& squared, std::uint32_t j) {
    nearest_.add_one(squared, j);
  }
  void finish(std::uint32_t i, std::uint32_t count) {
    const Lists found = lists();
    const std::uint32_t first = i - table_.first_asked;
    for (std::uint32_t lane = 0; lane < count; ++lane) set(first + lane, found, lane);
  }
  void finish(const Beside& mine, std::uint32_t i, std::uint32_t count) {
    const Lists found = lists();
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      set(mine.place[i + lane] - table_.first_asked, found, lane);
    }
  }

 private:
  struct Lists {
    float best[Lanes::kLanes];
    float second[Lanes::kLanes];
    std::uint32_t who[Lanes::kLanes];
  };

  [[nodiscard]] Lists lists() const {
    Lists found;
    nearest_.write_lanes(found.best, found.second, found.who);
    return found;
  }
  void set(std::uint32_t place, const Lists& found, std::uint32_t lane) {
    table_.best[place] = found.best[lane];
    table_.second[place] = found.second[lane];
    table_.who[place] = found.who[lane];
  }

  typename Lanes::Nearest nearest_;
  NearestTable table_;
};

}  // namespace
}  // namespace beespace::cpu
