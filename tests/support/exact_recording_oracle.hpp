// Two tracks, from the definition and in fractions of any size: an oracle that shares no code with
// the library.
//
// Time is cut at every fix of either track. In the open interval between two cuts the two move in
// straight lines, and the set of instants at which they are too close is convex. The conflict as a
// whole is the union of these sets and of the cuts that belong to it; its connected parts are the
// stretches.
#pragma once

#include "tests/support/exact_motion_oracle.hpp"

#include <beespace/find_conflicts.hpp>

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

namespace beespace::test {

struct ExactStretch {
  Wide begins;
  Wide ends;
  Wide closest_m;
};

class ExactRecording {
 public:
  ExactRecording(const Track& first, const Track& second, const ConflictOptions& options)
      : first_(first),
        second_(second),
        options_(options),
        squared_threshold_(Fraction(options.threshold_m) * Fraction(options.threshold_m)),
        up_(first.heights_m.empty() && second.heights_m.empty() ? 2 : 3) {}

  // The squared distance in a straight line, where both are there.
  [[nodiscard]] std::optional<Fraction> squared_distance(const Fraction& time) const {
    const auto apart = apart_at(time);
    if (!apart) return std::nullopt;
    return product(*apart, *apart);
  }

  [[nodiscard]] bool too_close_at(const Fraction& time) const {
    const auto apart = apart_at(time);
    return apart && too_close(*apart);
  }

  [[nodiscard]] std::vector<ExactStretch> stretches() const {
    std::vector<ExactStretch> found;
    std::optional<ExactStretch> open;
    const auto close = [&] {
      if (open) found.push_back(*open);
      open.reset();
    };
    const std::vector<Fraction> cuts = all_cuts();
    for (std::size_t k = 0; k < cuts.size(); ++k) {
      if (!too_close_at(cuts[k])) {
        close();
      } else {
        const Wide at = wide(cuts[k]);
        join(open, {at, at, sqrt(wide(*squared_distance(cuts[k])))});
      }
      if (k + 1 == cuts.size()) break;
      const std::optional<Part> part = between(cuts[k], cuts[k + 1]);
      if (!part) {
        close();
        continue;
      }
      if (!part->from_the_start) close();
      join(open, part->stretch);
      if (!part->to_the_end) close();
    }
    close();
    return found;
  }

 private:
  // The part of an open interval between two cuts that belongs to the conflict.
  struct Part {
    ExactStretch stretch;
    bool from_the_start;  // whatever small beginning of the interval does
    bool to_the_end;
  };

  static FractionVector place(const Track& track, std::size_t i) {
    const Point& p = track.fixes[i].position;
    const double height = track.heights_m.empty() ? 0.0 : track.heights_m[i];
    return {Fraction(p.x), Fraction(p.y), Fraction(p.z), Fraction(height)};
  }

  [[nodiscard]] std::optional<FractionVector> place_at(const Track& track,
                                                       const Fraction& time) const {
    for (std::size_t i = 0; i < track.fixes.size(); ++i) {
      const Fraction from(track.fixes[i].time_s);
      if (time == from) return place(track, i);
      if (i + 1 == track.fixes.size() || time < from) continue;
      const Fraction to(track.fixes[i + 1].time_s);
      if (time >= to) continue;
      if (track.fixes[i + 1].time_s - track.fixes[i].time_s > options_.max_gap_s) break;
      FractionVector at = place(track, i);
      const FractionVector end = place(track, i + 1);
      const Fraction share = (time - from) / (to - from);
      for (std::size_t axis = 0; axis < 4; ++axis) at[axis] += (end[axis] - at[axis]) * share;
      return at;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<FractionVector> apart_at(const Fraction& time) const {
    const auto p = place_at(first_, time);
    const auto q = place_at(second_, time);
    if (!p || !q) return std::nullopt;
    FractionVector apart;
    for (std::size_t axis = 0; axis < 4; ++axis) apart[axis] = (*q)[axis] - (*p)[axis];
    return apart;
  }

  [[nodiscard]] FractionVector level(FractionVector apart) const {
    if (options_.vertical_m) apart[up_] = 0;
    return apart;
  }
  [[nodiscard]] bool below(const Fraction& value, const Fraction& limit) const {
    return options_.inclusive ? value <= limit : value < limit;
  }
  [[nodiscard]] bool too_close(const FractionVector& apart) const {
    const FractionVector flat = level(apart);
    return below(product(flat, flat), squared_threshold_) &&
           (!options_.vertical_m || below(abs(apart[up_]), Fraction(*options_.vertical_m)));
  }

  [[nodiscard]] std::vector<Fraction> all_cuts() const {
    std::set<Fraction> cuts;
    for (const Track* track : {&first_, &second_}) {
      for (const Fix& fix : track->fixes) cuts.insert(Fraction(fix.time_s));
    }
    return {cuts.begin(), cuts.end()};
  }

  static void join(std::optional<ExactStretch>& open, const ExactStretch& more) {
    if (!open) {
      open = more;
      return;
    }
    open->ends = more.ends;
    open->closest_m = std::min(open->closest_m, more.closest_m);
  }

  [[nodiscard]] std::optional<Part> between(const Fraction& begin, const Fraction& end) const {
    // A straight line is known by two of its points.
    const Fraction third = (end - begin) / 3;
    const auto one = apart_at(begin + third);
    const auto other = apart_at(end - third);
    if (!one || !other) return std::nullopt;
    FractionVector w;
    FractionVector r;  // at the beginning
    for (std::size_t axis = 0; axis < 4; ++axis) {
      w[axis] = ((*other)[axis] - (*one)[axis]) / third;
      r[axis] = (*one)[axis] - w[axis] * third;
    }
    return part_of(r, w, begin, end - begin);
  }

  // r + w t for t in (0, duration).
  [[nodiscard]] std::optional<Part> part_of(const FractionVector& r, const FractionVector& w,
                                            const Fraction& begin, const Fraction& duration) const {
    Fraction low = 0;
    Fraction high = duration;
    if (options_.vertical_m) {
      const Fraction limit(*options_.vertical_m);
      if (w[up_] == 0 && !below(abs(r[up_]), limit)) return std::nullopt;
      if (w[up_] != 0) {
        const Fraction one = (-limit - r[up_]) / w[up_];
        const Fraction other = (limit - r[up_]) / w[up_];
        low = std::max(low, std::min(one, other));
        high = std::min(high, std::max(one, other));
      }
    }
    if (low >= high) return std::nullopt;  // a common end is one of the cuts
    const FractionVector flat = level(r);
    const FractionVector speed = level(w);
    const Fraction a = product(speed, speed);
    const Fraction b = product(flat, speed);
    const Fraction c = product(flat, flat) - squared_threshold_;
    const auto excess = [&](const Fraction& t) { return a * t * t + 2 * b * t + c; };
    Fraction lowest = (low + high) / 2;
    if (a != 0) lowest = std::clamp(Fraction(-b / a), low, high);
    // An end that is a cut does not belong to the interval, but what is close to it does.
    const bool outside = lowest == 0 || lowest == duration;
    const bool any = outside ? excess(lowest) < 0 : below(excess(lowest), Fraction(0));
    if (!any) return std::nullopt;

    Wide begins = wide(low);
    Wide ends = wide(high);
    if (a != 0) {
      const Wide half = sqrt(std::max(Wide(0), wide((b / a) * (b / a) - c / a)));
      begins = std::max(begins, Wide(wide(-b / a) - half));
      ends = std::min(ends, Wide(wide(-b / a) + half));
    }
    const auto near_end = [&](const Fraction& at, const Fraction& slope_inwards) {
      const Fraction here = excess(at);
      if (here != 0) return here < 0;
      return slope_inwards < 0 || (options_.inclusive && a == 0);
    };
    const bool from_the_start = low == 0 && near_end(low, b);
    const bool to_the_end = high == duration && near_end(high, -(a * high + b));
    return Part{{wide(begin) + begins, wide(begin) + ends, closest(r, w, begins, ends)},
                from_the_start,
                to_the_end};
  }

  static Wide closest(const FractionVector& r, const FractionVector& w, const Wide& begins,
                      const Wide& ends) {
    const Fraction a = product(w, w);
    const Wide at =
        a == 0 ? begins : std::clamp(wide(-product(r, w) / a), begins, std::max(begins, ends));
    Wide sum = 0;
    for (std::size_t axis = 0; axis < 4; ++axis) {
      const Wide part = wide(r[axis]) + wide(w[axis]) * at;
      sum += part * part;
    }
    return sqrt(sum);
  }

  const Track& first_;
  const Track& second_;
  const ConflictOptions& options_;
  Fraction squared_threshold_;
  std::size_t up_;
};

}  // namespace beespace::test
