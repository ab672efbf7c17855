// An independent check of true flights, in plain long doubles: whether what must stay free around
// agents stayed free, within instants too.
//
// It shares no code with src/avoidance or src/verify. In an instant both of a pair accelerate
// evenly, so the square of their distance (of an ellipsoid: with heights divided by its factor) is
// a polynomial of degree four. It is written in the Bernstein basis, whose coefficients enclose it,
// and cut in halves until they tell whether it falls below the threshold, and how far. Of a
// cylinder the two polynomials, of the horizontal distance and of the height, are looked at
// together.
#pragma once

#include "sim/true_agent.hpp"

#include <beespace/advise.hpp>
#include <beespace/separation.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace beespace::sim {

// What must stay free between two: a shape with the horizontal semi-axis `free_m`.
struct FreeSpace {
  Separation separation;
  long double free_m = 0.0L;
};

// How close two come in an instant: the least factor by which the shape must be multiplied to be
// touched; below 1 the pair has lost its separation. `enough`: where it is at least that, any
// number from there on to the true one may come back.
long double closest_in(const Stretch& a, const Stretch& b, long double lasts_s,
                       const FreeSpace& space,
                       long double enough = std::numeric_limits<long double>::infinity());

struct TrueLoss {
  std::size_t first = 0;
  std::size_t second = 0;
  double begins_s = 0.0;   // of the tick
  double closest_m = 0.0;  // as TrueVerdict::closest_m
};

struct TrueVerdict {
  std::uint64_t losses = 0;        // a pair and a tick
  std::uint64_t fence_losses = 0;  // an agent, a fence and a tick
  std::uint64_t heights_left = 0;  // in planar mode: an agent and a tick
  // The least distance: along the horizontal semi-axis of what must stay free, which counts as
  // shrunk until it is touched.
  std::optional<double> closest_m = {};
  std::size_t first = 0;
  std::size_t second = 0;
  double closest_s = 0.0;  // the begin of that tick
};

struct TrueSeparationOptions {
  double threshold_m = 5.0;
  Separation separation = {};
  double instant_s = 0.02;
  std::size_t instants = 5;  // in a tick
  std::vector<Fence> fences = {};
  double clearance_m = 1.0;  // from fences
  bool planar = false;
  std::size_t intruders = 0;  // the first of all: neither fences nor planes are theirs
};

class TrueSeparation {
 public:
  explicit TrueSeparation(TrueSeparationOptions options) : options_(std::move(options)) {}

  // Looks at a tick: `stretches` has `instants` of each agent, one agent after the other; radii are
  // those of the agents. Returns what is lost in it.
  const std::vector<TrueLoss>& look(double begins_s, std::span<const Stretch> stretches,
                                    std::span<const double> radii_m);
  [[nodiscard]] const TrueVerdict& verdict() const { return verdict_; }

 private:
  struct Box {
    Vector3 low;
    Vector3 high;
  };
  struct Cell {
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::int64_t z = 0;
    std::uint32_t agent = 0;
    friend bool operator<(const Cell& a, const Cell& b) {
      return std::tie(a.x, a.y, a.z, a.agent) < std::tie(b.x, b.y, b.z, b.agent);
    }
  };

  [[nodiscard]] std::span<const Stretch> of(std::span<const Stretch> all, std::size_t agent) const {
    return all.subspan(agent * options_.instants, options_.instants);
  }
  void find_boxes(std::span<const Stretch> stretches);
  void find_cells(std::span<const double> radii_m);
  void look_at_row(const Cell& cell, const Cell& of_row, std::span<const Stretch> stretches,
                   std::span<const double> radii_m);
  void look_at_pair(std::size_t a, std::size_t b, std::span<const Stretch> stretches,
                    std::span<const double> radii_m);
  void look_at_fences(std::span<const Stretch> stretches);

  TrueSeparationOptions options_;
  double begins_s_ = 0.0;
  std::vector<Box> boxes_;
  std::vector<Cell> cells_;
  double wide_m_ = 0.0;
  double high_m_ = 0.0;
  std::vector<double> heights_m_;  // at the start, in planar mode
  std::vector<TrueLoss> lost_;
  TrueVerdict verdict_;
};

}  // namespace beespace::sim
