// Two that move in straight lines, in whole numbers: are they in conflict at some instant?
//
// No polynomial, no discriminant: the decisive instant is computed as a fraction, substituted, and
// the resulting distance is compared. It is the instant of the least horizontal distance within the
// time in which heights are close: squared distances are convex in time, so if that instant is not
// close enough, none is.
#pragma once

#include "tests/differential/whole_numbers.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace beespace::differential {

// numerator / denominator; the denominator is above zero.
struct Fraction {
  Whole numerator = 0;
  Whole denominator = 1;

  friend bool operator<(const Fraction& a, const Fraction& b) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
  }
  friend bool operator<=(const Fraction& a, const Fraction& b) { return !(b < a); }
  friend bool operator==(const Fraction& a, const Fraction& b) {
    return a.numerator * b.denominator == b.numerator * a.denominator;
  }
};

// x, y, z and the height where that is kept apart.
using Axes = std::array<Whole, 4>;

struct Limits {
  Whole threshold = 1;
  std::optional<Whole> vertical = {};
  bool inclusive = false;
  std::size_t up = 2;  // the axis that the vertical threshold is for
};

// One as seen from another: at r + w t.
class Passage {
 public:
  Passage(const Axes& r, const Axes& w, const Limits& limits);

  // At an instant.
  [[nodiscard]] bool in_conflict_at(const Fraction& time) const;
  // At some instant from `begin` to `end`, these included.
  [[nodiscard]] bool in_conflict_within(const Fraction& begin, const Fraction& end) const;
  // At some instant between them, these excluded.
  [[nodiscard]] bool in_conflict_between(const Fraction& begin, const Fraction& end) const;

  // When the two are closest in a straight line from `begin` to `end`, and the square of how close.
  [[nodiscard]] Fraction closest_within(const Fraction& begin, const Fraction& end) const;
  [[nodiscard]] Fraction squared_distance_at(const Fraction& time) const;

 private:
  struct Span {
    Fraction begin;
    Fraction end;
  };

  [[nodiscard]] bool below(const Whole& value, const Whole& limit) const;
  [[nodiscard]] Fraction lowest(const Axes& r, const Axes& w, const Span& span) const;
  [[nodiscard]] bool level_at(const Fraction& time) const;
  [[nodiscard]] bool level_strictly_at(const Fraction& time) const;
  [[nodiscard]] bool upright_at(const Fraction& time) const;
  [[nodiscard]] std::optional<Span> time_in_height(const Fraction& begin,
                                                   const Fraction& end) const;

  Axes r_;
  Axes w_;
  Axes level_r_;
  Axes level_w_;
  Limits limits_;
};

}  // namespace beespace::differential
