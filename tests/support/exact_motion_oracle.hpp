// Two movers, from the definition and in fractions of any size: an oracle that shares no code and
// no formula with the library.
//
// "In conflict" is answered with a witness: an instant of [0, horizon] at which the two are too
// close, which can be checked by substitution. "Not in conflict" rests on the squared distance
// being convex in time: if its minimum is not too small, no value is.
#pragma once

#include <beespace/closest_approach.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace beespace::test {

using Fraction = boost::multiprecision::number<boost::multiprecision::cpp_rational::backend_type,
                                               boost::multiprecision::et_off>;

// For square roots, which are no fractions: 1024 bits, so that what cancels in the roots of a
// quadratic still leaves hundreds.
using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<1024, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

inline Wide wide(const Fraction& value) {
  return Wide(boost::multiprecision::numerator(value)) /
         Wide(boost::multiprecision::denominator(value));
}

// On x, y and z, and on a fourth axis for heights that are kept apart.
using FractionVector = std::array<Fraction, 4>;

inline Fraction product(const FractionVector& a, const FractionVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

struct HeightApart {
  double height_m = 0.0;
  double climb_mps = 0.0;
};

struct FractionSpan {
  Fraction begin;
  Fraction end;
};

class ExactEncounter {
 public:
  ExactEncounter(const Mover& first, const Mover& second, const PredictOptions& options)
      : ExactEncounter(first, {}, second, {}, options, 2) {}
  ExactEncounter(const Mover& first, const HeightApart& first_height, const Mover& second,
                 const HeightApart& second_height, const PredictOptions& options)
      : ExactEncounter(first, first_height, second, second_height, options, 3) {}

  // The definition: whether they are too close at this instant.
  [[nodiscard]] bool too_close_at(const Fraction& time) const {
    if (!below(squared_level_distance(time), squared_threshold_)) return false;
    return !height_ || below(height_difference(time), *height_);
  }

  // An instant of [0, horizon] at which they are too close, if there is one.
  [[nodiscard]] std::optional<Fraction> witness() const {
    const std::optional<FractionSpan> span = span_in_height();
    if (!span) return std::nullopt;
    const Fraction lowest = lowest_within(level_from_, level_speed_, *span);
    if (!below(squared_level_distance(lowest), squared_threshold_)) return std::nullopt;
    if (too_close_at(lowest)) return lowest;
    // The lowest is where the two pass the height itself. Inside of the span they are close in
    // height, and near enough to its end close on the level too: it is an open condition.
    Fraction step = (span->begin + span->end) / 2 - lowest;
    if (step == 0) return std::nullopt;
    while (!too_close_at(lowest + step)) step /= 2;
    return lowest + step;
  }

  [[nodiscard]] bool in_conflict() const { return witness().has_value(); }

  // The first instant of a span at which they are closest in a straight line.
  [[nodiscard]] Fraction closest_time(const FractionSpan& span) const {
    return lowest_within(from_, speed_, span);
  }
  [[nodiscard]] Fraction closest_time() const { return closest_time({Fraction(0), horizon_}); }
  [[nodiscard]] Fraction squared_distance(const Fraction& time) const {
    return squared_at(from_, speed_, time);
  }
  // Where the height counts by itself, the horizontal one; all of it otherwise.
  [[nodiscard]] Fraction squared_level_distance(const Fraction& time) const {
    return squared_at(level_from_, level_speed_, time);
  }
  [[nodiscard]] Fraction height_difference(const Fraction& time) const {
    return abs(from_[up_] + speed_[up_] * time);
  }
  [[nodiscard]] Fraction squared_speed() const { return product(speed_, speed_); }

  // From when to when they are in conflict, of two who are: the closure of it where the ends do
  // not belong to it themselves.
  [[nodiscard]] std::pair<Wide, Wide> conflict_span() const {
    const FractionSpan span = *span_in_height();
    Wide begins = wide(span.begin);
    Wide ends = wide(span.end);
    const Fraction a = product(level_speed_, level_speed_);
    if (a == 0) return {begins, ends};
    const Fraction half_sum = -product(level_from_, level_speed_) / a;
    const Fraction constant = (product(level_from_, level_from_) - squared_threshold_) / a;
    const Wide half_width = sqrt(wide(half_sum * half_sum - constant));
    begins = std::max(begins, Wide(wide(half_sum) - half_width));
    ends = std::min(ends, Wide(wide(half_sum) + half_width));
    return {begins, ends};
  }

 private:
  ExactEncounter(const Mover& first, const HeightApart& first_height, const Mover& second,
                 const HeightApart& second_height, const PredictOptions& options, std::size_t up)
      : up_(up),
        from_{difference(first.position.x, second.position.x),
              difference(first.position.y, second.position.y),
              difference(first.position.z, second.position.z),
              difference(first_height.height_m, second_height.height_m)},
        speed_{difference(first.velocity.x, second.velocity.x),
               difference(first.velocity.y, second.velocity.y),
               difference(first.velocity.z, second.velocity.z),
               difference(first_height.climb_mps, second_height.climb_mps)},
        level_from_(from_),
        level_speed_(speed_),
        squared_threshold_(Fraction(options.threshold_m) * Fraction(options.threshold_m)),
        horizon_(options.horizon_s),
        inclusive_(options.inclusive) {
    if (!options.vertical_m) return;
    height_ = Fraction(*options.vertical_m);
    level_from_[up_] = level_speed_[up_] = 0;
  }

  static Fraction difference(double from, double to) { return Fraction(to) - Fraction(from); }

  static Fraction squared_at(const FractionVector& from, const FractionVector& speed,
                             const Fraction& time) {
    Fraction sum = 0;
    for (std::size_t axis = 0; axis < from.size(); ++axis) {
      const Fraction at = from[axis] + speed[axis] * time;
      sum += at * at;
    }
    return sum;
  }

  [[nodiscard]] bool below(const Fraction& value, const Fraction& limit) const {
    return inclusive_ ? value <= limit : value < limit;
  }

  static Fraction lowest_within(const FractionVector& from, const FractionVector& speed,
                                const FractionSpan& span) {
    const Fraction a = product(speed, speed);
    if (a == 0) return span.begin;
    return std::clamp(Fraction(-product(from, speed) / a), span.begin, span.end);
  }

  // The part of [0, horizon] in which they are close in height, with its ends; none where that
  // would be nothing but ends that do not count.
  [[nodiscard]] std::optional<FractionSpan> span_in_height() const {
    const FractionSpan all{Fraction(0), horizon_};
    if (!height_) return all;
    if (speed_[up_] == 0) {
      if (!below(abs(from_[up_]), *height_)) return std::nullopt;
      return all;
    }
    const Fraction one = (-*height_ - from_[up_]) / speed_[up_];
    const Fraction other = (*height_ - from_[up_]) / speed_[up_];
    const FractionSpan span{std::max(all.begin, std::min(one, other)),
                            std::min(all.end, std::max(one, other))};
    if (span.begin > span.end) return std::nullopt;
    return span;
  }

  std::size_t up_;  // the axis of heights
  FractionVector from_;
  FractionVector speed_;
  FractionVector level_from_;  // without the height, where that counts by itself
  FractionVector level_speed_;
  Fraction squared_threshold_;
  std::optional<Fraction> height_;
  Fraction horizon_;
  bool inclusive_;
};

}  // namespace beespace::test
