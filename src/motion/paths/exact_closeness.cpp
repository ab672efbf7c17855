#include "motion/paths/exact_closeness.hpp"

#include "exact/exact_number.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace beespace::motion {
namespace {

using Numbers = std::vector<ExactNumber>;

// Control points times `weight`, which is above zero: so they need no division.
struct Weighted {
  std::vector<std::array<ExactNumber, 3>> points;
  ExactNumber weight = 1.0;
};

Weighted weighted(const BezierCurve& curve) {
  Weighted all;
  for (unsigned k = 0; k <= curve.degree; ++k) {
    const Point& p = curve.points[k];
    all.points.push_back({ExactNumber(p.x), ExactNumber(p.y), ExactNumber(p.z)});
  }
  return all;
}

// The part of the curve in that time. Control point k of it is the curve's blossom at the end of
// the window k times, and at its beginning otherwise.
Weighted exact_part_of(const BezierCurve& curve, const TimeSpan& window) {
  Weighted whole = weighted(curve);
  if (window.begins_s == curve.begins_s && window.ends_s == curve.ends_s) return whole;
  Weighted part;
  for (unsigned k = 0; k <= curve.degree; ++k) {
    auto points = whole.points;
    for (unsigned step = 0; step < curve.degree; ++step) {
      const ExactNumber at = step < k ? window.ends_s : window.begins_s;
      const ExactNumber before = ExactNumber(curve.ends_s) - at;
      const ExactNumber behind = at - ExactNumber(curve.begins_s);
      for (std::size_t i = 0; i + 1 + step < whole.points.size(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          points[i][axis] = points[i][axis] * before + points[i + 1][axis] * behind;
        }
      }
    }
    part.points.push_back(points[0]);
  }
  const ExactNumber lasts = ExactNumber(curve.ends_s) - ExactNumber(curve.begins_s);
  for (unsigned step = 0; step < curve.degree; ++step) part.weight = part.weight * lasts;
  return part;
}

// The same curve with one control point more.
void elevate(Weighted& curve) {
  const std::size_t degree = curve.points.size() - 1;
  std::vector<std::array<ExactNumber, 3>> points(degree + 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (i > 0) {
        points[i][axis] = curve.points[i - 1][axis] * ExactNumber(static_cast<double>(i));
      }
      if (i <= degree) {
        points[i][axis] = points[i][axis] +
                          curve.points[i][axis] * ExactNumber(static_cast<double>(degree + 1 - i));
      }
    }
  }
  curve.points = std::move(points);
  curve.weight = curve.weight * ExactNumber(static_cast<double>(degree + 1));
}

// Of both to the same number of control points; returns their differences, under one weight.
Weighted between_of(Weighted first, Weighted second) {
  while (first.points.size() < second.points.size()) elevate(first);
  while (second.points.size() < first.points.size()) elevate(second);
  Weighted between;
  between.weight = first.weight * second.weight;
  for (std::size_t k = 0; k < first.points.size(); ++k) {
    auto& point = between.points.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point[axis] = first.points[k][axis] * second.weight - second.points[k][axis] * first.weight;
    }
  }
  return between;
}

double binomial(std::size_t n, std::size_t k) {
  double value = 1.0;
  for (std::size_t i = 1; i <= k; ++i) {
    value = value * static_cast<double>(n + 1 - i) / static_cast<double>(i);
  }
  return value;
}

// Bernstein's coefficients of the squared distance less the squared threshold, times a number above
// zero.
Numbers excess_of(const Weighted& between, double threshold_m) {
  const std::size_t degree = between.points.size() - 1;
  // The least common multiples of the binomials of 2, 4 and 6.
  constexpr std::array<double, 4> kCommon = {1.0, 2.0, 12.0, 60.0};
  const double common = kCommon[degree];
  const ExactNumber reach = ExactNumber(threshold_m) * between.weight;
  const ExactNumber squared = reach * reach * ExactNumber(common);
  Numbers excess;
  for (std::size_t j = 0; j <= 2 * degree; ++j) {
    ExactNumber sum;
    for (std::size_t i = j > degree ? j - degree : 0; i <= std::min(j, degree); ++i) {
      ExactNumber product;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        product = product + between.points[i][axis] * between.points[j - i][axis];
      }
      sum = sum + product * ExactNumber(binomial(degree, i) * binomial(degree, j - i));
    }
    excess.push_back(sum * ExactNumber(common / binomial(2 * degree, j)) - squared);
  }
  return excess;
}

bool is_negative(const ExactNumber& number) {
  return number.sign() < 0;
}

// Of a second degree, whose discriminant decides.
bool dips_below_zero(const Numbers& parabola) {
  if (is_negative(parabola[0]) || is_negative(parabola[2])) return true;
  if (!is_negative(parabola[1])) return false;
  return is_negative(parabola[0] * parabola[2] - parabola[1] * parabola[1]);
}

std::pair<Numbers, Numbers> halves(Numbers polynomial) {
  const ExactNumber half = 0.5;
  const std::size_t count = polynomial.size();
  Numbers left;
  Numbers right(count);
  for (std::size_t step = 0; step < count; ++step) {
    left.push_back(polynomial[0]);
    right[count - 1 - step] = polynomial[count - 1 - step];
    for (std::size_t i = 0; i + 1 + step < count; ++i) {
      polynomial[i] = (polynomial[i] + polynomial[i + 1]) * half;
    }
  }
  return {std::move(left), std::move(right)};
}

}  // namespace

bool closer_exactly(const BezierCurve& first, const BezierCurve& second, const TimeSpan& window,
                    double threshold_m) {
  const Numbers whole = excess_of(
      between_of(exact_part_of(first, window), exact_part_of(second, window)), threshold_m);
  if (whole.size() == 3) return dips_below_zero(whole);
  constexpr std::size_t kDeepest = 64;
  std::vector<std::pair<Numbers, std::size_t>> open{{whole, 0}};
  while (!open.empty()) {
    const auto [polynomial, depth] = std::move(open.back());
    open.pop_back();
    if (is_negative(polynomial.front()) || is_negative(polynomial.back())) return true;
    if (std::none_of(polynomial.begin(), polynomial.end(), is_negative)) continue;
    if (depth == kDeepest) return true;
    auto [left, right] = halves(polynomial);
    open.emplace_back(std::move(right), depth + 1);
    open.emplace_back(std::move(left), depth + 1);
  }
  return false;
}

}  // namespace beespace::motion
