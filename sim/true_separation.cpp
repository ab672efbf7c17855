#include "sim/true_separation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace beespace::sim {

namespace {

using Real = long double;
// The coefficients of a polynomial of degree four on an interval, in the Bernstein basis.
using Quartic = std::array<Real, 5>;

// a + b s + c s^2, with s from 0 to 1.
struct Parabola {
  Real a = 0;
  Real b = 0;
  Real c = 0;
};

Parabola difference(double x, double v, double a, double y, double w, double b, Real lasts_s) {
  return {Real{x} - Real{y}, (Real{v} - Real{w}) * lasts_s,
          (Real{a} - Real{b}) * lasts_s * lasts_s / 2};
}

// Adds the square, times a factor, to powers of s.
void add_square(std::array<Real, 5>& powers, const Parabola& p, Real factor) {
  powers[0] += factor * p.a * p.a;
  powers[1] += factor * 2 * p.a * p.b;
  powers[2] += factor * (p.b * p.b + 2 * p.a * p.c);
  powers[3] += factor * 2 * p.b * p.c;
  powers[4] += factor * p.c * p.c;
}

Quartic bernstein_of(const std::array<Real, 5>& powers) {
  const auto& p = powers;
  return {p[0], p[0] + p[1] / 4, p[0] + p[1] / 2 + p[2] / 6,
          p[0] + p[1] * 3 / 4 + p[2] / 2 + p[3] / 4, p[0] + p[1] + p[2] + p[3] + p[4]};
}

// De Casteljau: the same polynomial on both halves.
std::pair<Quartic, Quartic> halves(Quartic q) {
  Quartic left{};
  Quartic right{};
  for (std::size_t round = 0; round < 5; ++round) {
    left[round] = q[0];
    right[4 - round] = q[4 - round];
    for (std::size_t i = 0; i + 1 + round < 5; ++i) q[i] = (q[i] + q[i + 1]) / 2;
  }
  return {left, right};
}

// Two polynomials of which the greater one counts; and their value at the border of the shape,
// which has no division in it, so that what is exactly there is so here.
struct Gauge {
  Quartic one{};
  Quartic other{};
  Real border = 1;

  [[nodiscard]] Real low() const {
    return std::max(*std::min_element(one.begin(), one.end()),
                    *std::min_element(other.begin(), other.end()));
  }
  [[nodiscard]] Real at_begin() const { return std::max(one[0], other[0]); }
  [[nodiscard]] Real at_end() const { return std::max(one[4], other[4]); }
};

// The least value; `best` is one that is reached or enough. Each cut makes the distance between
// coefficients and values four times smaller.
Real least_of(const Gauge& gauge, Real best, int cuts_left) {
  best = std::min({best, gauge.at_begin(), gauge.at_end()});
  const Real low = gauge.low();
  // What is left is rounding: of a polynomial that is constant it would be cut for ever.
  constexpr Real kExact = 1 - 0x1p-56L;
  if (low >= best * kExact) return best;
  if (cuts_left == 0) return std::max(low, Real{0});
  const auto [one_left, one_right] = halves(gauge.one);
  const auto [other_left, other_right] = halves(gauge.other);
  best = least_of({one_left, other_left, gauge.border}, best, cuts_left - 1);
  return least_of({one_right, other_right, gauge.border}, best, cuts_left - 1);
}

Gauge gauge_of(const Stretch& a, const Stretch& b, Real lasts_s, const FreeSpace& space) {
  const auto axis = [&](double Vector3::*c) {
    return difference(a.position.*c, a.velocity.*c, a.acceleration.*c, b.position.*c, b.velocity.*c,
                      b.acceleration.*c, lasts_s);
  };
  // Horizontal parts are multiplied by what heights would be divided by.
  const bool cylinder = space.separation.shape == SeparationShape::kCylinder;
  const Real free = space.free_m * space.free_m;
  Real wide = 1;
  if (space.separation.shape == SeparationShape::kEllipsoid) {
    wide = Real{space.separation.vertical_factor} * Real{space.separation.vertical_factor};
  } else if (cylinder) {
    wide = Real{space.separation.vertical_m} * Real{space.separation.vertical_m};
  }
  std::array<Real, 5> one{};
  std::array<Real, 5> other{};
  add_square(one, axis(&Vector3::x), wide);
  add_square(one, axis(&Vector3::y), wide);
  add_square(cylinder ? other : one, axis(&Vector3::z), cylinder ? free : 1);
  return {bernstein_of(one), bernstein_of(other), wide * free};
}

}  // namespace

Real closest_in(const Stretch& a, const Stretch& b, Real lasts_s, const FreeSpace& space,
                Real enough) {
  // Thirty cuts: the rest is below what doubles can tell.
  constexpr int kCuts = 30;
  const Gauge gauge = gauge_of(a, b, lasts_s, space);
  const Real far = enough * enough * gauge.border;
  return std::sqrt(least_of(gauge, far, kCuts) / gauge.border);
}

const std::vector<TrueLoss>& TrueSeparation::look(double begins_s,
                                                  std::span<const Stretch> stretches,
                                                  std::span<const double> radii_m) {
  begins_s_ = begins_s;
  lost_.clear();
  find_boxes(stretches);
  find_cells(radii_m);
  for (const Cell& cell : cells_) {
    // Each pair of cells once: this one and those after it.
    for (std::int64_t z = -1; z <= 1; ++z) {
      for (std::int64_t y = -1; y <= 1; ++y) {
        look_at_row(cell, {cell.x - 1, cell.y + y, cell.z + z, 0}, stretches, radii_m);
        look_at_row(cell, {cell.x, cell.y + y, cell.z + z, 0}, stretches, radii_m);
        look_at_row(cell, {cell.x + 1, cell.y + y, cell.z + z, 0}, stretches, radii_m);
      }
    }
  }
  look_at_fences(stretches);
  std::sort(lost_.begin(), lost_.end(), [](const TrueLoss& a, const TrueLoss& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  });
  verdict_.losses += lost_.size();
  return lost_;
}

// All places of the tick: those of an instant are between its control points.
void TrueSeparation::find_boxes(std::span<const Stretch> stretches) {
  const double lasts_s = options_.instant_s;
  boxes_.clear();
  for (std::size_t agent = 0; agent * options_.instants < stretches.size(); ++agent) {
    Box box{of(stretches, agent).front().position, of(stretches, agent).front().position};
    const auto cover = [&box](const Vector3& p) {
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
    };
    for (const Stretch& s : of(stretches, agent)) {
      cover(s.position);
      cover(s.position + s.velocity * (0.5 * lasts_s));
      cover(s.position + s.velocity * lasts_s + s.acceleration * (0.5 * lasts_s * lasts_s));
    }
    boxes_.push_back(box);
  }
}

// Cells are as wide as the widest box and what must stay free: so two that are in each other's free
// space lie in cells that touch.
void TrueSeparation::find_cells(std::span<const double> radii_m) {
  double radius_m = 0.0;
  for (const double r : radii_m) radius_m = std::max(radius_m, r);
  const double free_m = std::max(options_.threshold_m, 2.0 * radius_m);
  double wide_m = 0.0;
  double high_m = 0.0;
  for (const Box& box : boxes_) {
    wide_m = std::max({wide_m, box.high.x - box.low.x, box.high.y - box.low.y});
    high_m = std::max(high_m, box.high.z - box.low.z);
  }
  const Separation& separation = options_.separation;
  double free_above_m = free_m;
  if (separation.shape == SeparationShape::kEllipsoid) free_above_m *= separation.vertical_factor;
  if (separation.shape == SeparationShape::kCylinder) free_above_m = separation.vertical_m;
  // A little more, so that rounding takes nothing.
  constexpr double kMore = 1.001;
  wide_m_ = kMore * (wide_m + free_m);
  high_m_ = kMore * (high_m + free_above_m);
  cells_.clear();
  for (std::uint32_t agent = 0; agent < boxes_.size(); ++agent) {
    const Vector3& p = boxes_[agent].low;
    const auto cell = [](double x, double size) {
      return static_cast<std::int64_t>(std::floor(x / size));
    };
    cells_.push_back({cell(p.x, wide_m_), cell(p.y, wide_m_), cell(p.z, high_m_), agent});
  }
  std::sort(cells_.begin(), cells_.end());
}

void TrueSeparation::look_at_row(const Cell& cell, const Cell& of_row,
                                 std::span<const Stretch> stretches,
                                 std::span<const double> radii_m) {
  const auto from = std::lower_bound(cells_.begin(), cells_.end(), of_row);
  for (auto other = from; other != cells_.end(); ++other) {
    if (other->x != of_row.x || other->y != of_row.y || other->z != of_row.z) return;
    if (other->agent > cell.agent) look_at_pair(cell.agent, other->agent, stretches, radii_m);
  }
}

void TrueSeparation::look_at_pair(std::size_t a, std::size_t b, std::span<const Stretch> stretches,
                                  std::span<const double> radii_m) {
  const double radii = radii_m.empty() ? 0.0 : radii_m[a] + radii_m[b];
  const FreeSpace space{options_.separation, Real{std::max(options_.threshold_m, radii)}};
  // What is neither lost nor the closest so far need not be known.
  const Real so_far = verdict_.closest_m ? Real{*verdict_.closest_m} / space.free_m
                                         : std::numeric_limits<Real>::infinity();
  Real least = std::max(Real{1}, so_far);
  bool below = false;
  for (std::size_t k = 0; k < options_.instants; ++k) {
    const Real here = closest_in(of(stretches, a)[k], of(stretches, b)[k], Real{options_.instant_s},
                                 space, least);
    below = below || here < 1;
    least = std::min(least, here);
  }
  const auto least_m = static_cast<double>(least * space.free_m);
  if (below) lost_.push_back({a, b, begins_s_, least_m});
  if (least >= so_far) return;
  verdict_.closest_m = least_m;
  verdict_.first = a;
  verdict_.second = b;
  verdict_.closest_s = begins_s_;
}

// Along the normal of a fence a flight is a parabola: least at an end or where its slope is zero.
void TrueSeparation::look_at_fences(std::span<const Stretch> stretches) {
  const Real lasts_s = Real{options_.instant_s};
  const auto along = [](const Fence& fence, const Vector3& a) {
    return Real{fence.inward.x} * Real{a.x} + Real{fence.inward.y} * Real{a.y} +
           Real{fence.inward.z} * Real{a.z};
  };
  const auto beyond = [&](const Fence& fence, const Stretch& s) {
    const Real p = along(fence, s.position) - Real{fence.offset_m} - Real{options_.clearance_m};
    const Real v = along(fence, s.velocity);
    const Real a = along(fence, s.acceleration);
    const auto at = [&](Real t) { return p + v * t + a * t * t / 2; };
    const Real turn = a > 0 ? std::clamp(-v / a, Real{0}, lasts_s) : Real{0};
    return std::min({at(0), at(turn), at(lasts_s)}) < 0;
  };
  for (std::size_t agent = options_.intruders; agent < boxes_.size(); ++agent) {
    const auto flown = of(stretches, agent);
    for (const Fence& fence : options_.fences) {
      verdict_.fence_losses += std::any_of(flown.begin(), flown.end(),
                                           [&](const Stretch& s) { return beyond(fence, s); })
                                   ? 1U
                                   : 0U;
    }
    if (!options_.planar) continue;
    const std::size_t index = agent - options_.intruders;
    if (heights_m_.size() <= index) heights_m_.push_back(boxes_[agent].low.z);
    const bool left =
        boxes_[agent].low.z != heights_m_[index] || boxes_[agent].high.z != heights_m_[index];
    verdict_.heights_left += left ? 1U : 0U;
  }
}

}  // namespace beespace::sim
