#include "tests/differential/passage.hpp"

#include <algorithm>
#include <utility>

namespace beespace::differential {

namespace {

Whole product(const Axes& a, const Axes& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

// (r + w t) times the denominator of t.
Axes place_at(const Axes& r, const Axes& w, const Fraction& time) {
  Axes place;
  for (std::size_t axis = 0; axis < place.size(); ++axis) {
    place[axis] = r[axis] * time.denominator + w[axis] * time.numerator;
  }
  return place;
}

}  // namespace

Passage::Passage(const Axes& r, const Axes& w, const Limits& limits)
    : r_(r), w_(w), level_r_(r), level_w_(w), limits_(limits) {
  if (limits.vertical) level_r_[limits.up] = level_w_[limits.up] = 0;
}

bool Passage::below(const Whole& value, const Whole& limit) const {
  return limits_.inclusive ? value <= limit : value < limit;
}

bool Passage::level_at(const Fraction& time) const {
  const Axes at = place_at(level_r_, level_w_, time);
  return below(product(at, at), squared(limits_.threshold * time.denominator));
}

bool Passage::level_strictly_at(const Fraction& time) const {
  const Axes at = place_at(level_r_, level_w_, time);
  return product(at, at) < squared(limits_.threshold * time.denominator);
}

bool Passage::upright_at(const Fraction& time) const {
  if (!limits_.vertical) return true;
  const Whole at = r_[limits_.up] * time.denominator + w_[limits_.up] * time.numerator;
  return below(abs(at), *limits_.vertical * time.denominator);
}

bool Passage::in_conflict_at(const Fraction& time) const {
  return level_at(time) && upright_at(time);
}

Fraction Passage::lowest(const Axes& r, const Axes& w, const Span& span) const {
  const Whole speed = product(w, w);
  if (speed == 0) return span.begin;
  const Fraction turn{-product(r, w), speed};
  if (turn < span.begin) return span.begin;
  return span.end < turn ? span.end : turn;
}

Fraction Passage::closest_within(const Fraction& begin, const Fraction& end) const {
  return lowest(r_, w_, {begin, end});
}

Fraction Passage::squared_distance_at(const Fraction& time) const {
  const Axes at = place_at(r_, w_, time);
  return {product(at, at), squared(time.denominator)};
}

// The closure of the part of begin ... end in which they are close in height; nothing where no
// instant is.
std::optional<Passage::Span> Passage::time_in_height(const Fraction& begin,
                                                     const Fraction& end) const {
  Span span{begin, end};
  if (!limits_.vertical) return span;
  const Whole& height = r_[limits_.up];
  const Whole& climb = w_[limits_.up];
  if (climb == 0) {
    if (!below(abs(height), *limits_.vertical)) return std::nullopt;
    return span;
  }
  const Whole speed = abs(climb);
  const Whole from =
      climb > 0 ? Whole(-*limits_.vertical - height) : Whole(height - *limits_.vertical);
  const Fraction enters{from, speed};
  const Fraction leaves{from + 2 * *limits_.vertical, speed};
  const bool in_time =
      limits_.inclusive ? enters <= end && begin <= leaves : enters < end && begin < leaves;
  if (!in_time) return std::nullopt;
  if (span.begin < enters) span.begin = enters;
  if (leaves < span.end) span.end = leaves;
  return span;
}

bool Passage::in_conflict_within(const Fraction& begin, const Fraction& end) const {
  const auto span = time_in_height(begin, end);
  // Close on the level at an end at which they are not quite close in height: then also inside.
  return span && level_at(lowest(level_r_, level_w_, *span));
}

bool Passage::in_conflict_between(const Fraction& begin, const Fraction& end) const {
  const auto span = time_in_height(begin, end);
  if (!span) return false;
  const Fraction time = lowest(level_r_, level_w_, *span);
  if (begin < time && time < end) return level_at(time);
  if (!(span->begin < span->end)) return false;
  // Closest at an end, which does not count; but what is inside beside it does.
  const bool still = product(level_w_, level_w_) == 0;
  return still ? level_at(time) : level_strictly_at(time);
}

}  // namespace beespace::differential
