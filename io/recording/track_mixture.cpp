#include "io/recording/track_mixture.hpp"

#include "io/recording/flat_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace beespace::io {
namespace {

using Place = TrackMixture::Place;

double step_m(const Place& a, const Place& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

bool turns_impossibly(const Place& before, const Place& at, const Place& after, double most_mps2) {
  const double there_s = at.time_s - before.time_s;
  const double back_s = after.time_s - at.time_s;
  const double x = (after.x - at.x) / back_s - (at.x - before.x) / there_s;
  const double y = (after.y - at.y) / back_s - (at.y - before.y) / there_s;
  return 2.0 * std::hypot(x, y) > most_mps2 * (there_s + back_s);
}

// One of the tracks that may make up the whole.
struct Head {
  Place at;
  double x_mps = 0.0;
  double y_mps = 0.0;
  std::size_t entered = 0;  // how often another one came before

  [[nodiscard]] double off_m(const Place& place) const {
    const double after_s = place.time_s - at.time_s;
    return std::hypot(place.x - at.x - x_mps * after_s, place.y - at.y - y_mps * after_s);
  }
  void go_on(const Place& place) {
    const double after_s = place.time_s - at.time_s;
    x_mps = (place.x - at.x) / after_s;
    y_mps = (place.y - at.y) / after_s;
    at = place;
  }
};

class Heads {
 public:
  explicit Heads(double scale_m) : scale_m_(scale_m) {}

  void take(const Place& place) {
    std::size_t nearest = 0;
    double off_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count_; ++i) {
      const double of_this_m = heads_[i].off_m(place);
      if (of_this_m < off_m) {
        off_m = of_this_m;
        nearest = i;
      }
    }
    if (off_m >= scale_m_) {
      if (count_ > 0) ++strays_;
      nearest = oldest();
      heads_[nearest] = {place};
    } else {
      if (off_m > scale_m_ / 4.0) {
        ++strays_;
      } else if (nearest != last_) {
        ++jumps_;
        ++heads_[nearest].entered;
      }
      heads_[nearest].go_on(place);
    }
    last_ = nearest;
    merge();
  }

  [[nodiscard]] bool explain() const {
    constexpr std::size_t kFewestJumps = 16;
    constexpr std::size_t kFewestEntered = 8;
    const auto often =
        std::count_if(heads_.begin(), heads_.begin() + static_cast<std::ptrdiff_t>(count_),
                      [](const Head& head) { return head.entered >= kFewestEntered; });
    return often >= 2 && jumps_ >= kFewestJumps && 7 * strays_ <= jumps_;
  }

 private:
  // Where a new one goes.
  std::size_t oldest() {
    if (count_ < heads_.size()) return count_++;
    std::size_t oldest = 0;
    for (std::size_t i = 1; i < count_; ++i) {
      if (heads_[i].at.time_s < heads_[oldest].at.time_s) oldest = i;
    }
    return oldest;
  }

  // What has come closer to the last one than the scale is the same.
  void merge() {
    for (std::size_t i = 0; i < count_;) {
      if (i == last_ || step_m(heads_[i].at, heads_[last_].at) >= scale_m_) {
        ++i;
        continue;
      }
      --count_;
      heads_[i] = heads_[count_];
      if (last_ == count_) last_ = i;
    }
  }

  double scale_m_;
  std::array<Head, TrackMixture::kMostHeads> heads_ = {};
  std::size_t count_ = 0;
  std::size_t last_ = 0;
  std::size_t jumps_ = 0;
  std::size_t strays_ = 0;
};

// The least way between two different places that follow each other closely.
double least_step_m(const std::vector<Place>& places) {
  constexpr std::size_t kClosely = 8;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = i + 1; k < std::min(i + kClosely, places.size()); ++k) {
      const double way_m = step_m(places[i], places[k]);
      if (way_m > 0.0) least_m = std::min(least_m, way_m);
    }
  }
  return least_m;
}

}  // namespace

std::optional<std::uint64_t> TrackMixture::take(const Fix& fix, std::uint64_t number, Frame frame) {
  constexpr std::uint64_t kLookEvery = 16;
  if (!origin_) origin_ = fix;
  const Point at = flat_offset_m(fix.position, origin_->position, frame);
  Place place{fix.time_s, at.x, at.y, number, false};
  place.turns = taken_ >= 2 && turns_impossibly(before_, last_, place, impossible_mps2_);
  before_ = last_;
  last_ = place;
  ++taken_;
  if (place.turns) last_turn_ = taken_;
  if (window_.empty() && !place.turns) return std::nullopt;
  if (taken_ - last_turn_ > kWindow) {
    window_ = {};
    next_ = 0;
    return std::nullopt;
  }
  if (window_.size() < kWindow) {
    window_.push_back(place);
  } else {
    window_[next_] = place;
    next_ = (next_ + 1) % kWindow;
  }
  if (taken_ % kLookEvery != 0 || !is_of_several()) return std::nullopt;
  const std::size_t first = window_.size() < kWindow ? 0 : next_;
  return window_[first].number;
}

bool TrackMixture::is_of_several() const {
  std::vector<double> jumps_m;
  std::vector<Place> places = window_;
  std::rotate(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(next_), places.end());
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i].turns) jumps_m.push_back(step_m(places[i - 1], places[i]));
  }
  if (jumps_m.size() < kFewestTurns) return false;
  const auto middle = jumps_m.begin() + static_cast<std::ptrdiff_t>(jumps_m.size() / 2);
  std::nth_element(jumps_m.begin(), middle, jumps_m.end());
  constexpr double kTimesRounded = 16.0;
  constexpr double kRoundsToLess_m = 20.0;
  const double least_m = std::min(kTimesRounded * least_step_m(places), kRoundsToLess_m);
  constexpr std::array kScales = {0.8, 0.4, 0.2, 0.1};
  return std::any_of(kScales.begin(), kScales.end(), [&](double of_middle) {
    const double scale_m = of_middle * *middle;
    if (!(scale_m >= least_m)) return false;
    Heads heads(scale_m);
    for (const Place& place : places) heads.take(place);
    return heads.explain();
  });
}

}  // namespace beespace::io
