// Which velocity shall each bee take next, so that nobody comes too close to anybody?
//
// Given where all bees are, how fast they fly and how each would like to fly, advise() gives each
// the velocity for the next step that is closest to its wish among those that are *certified*: as
// long as everybody does as advised, no two come closer than the threshold, in this step and for
// ever after, because everybody can always still brake to a stop clear of everybody else. The proof
// and its conditions are in docs/prevention.md.
//
// The motion that is meant: in a step of `step_s` a bee changes its velocity evenly from the old
// one to the new one, within its greatest acceleration; one without such a limit flies with the new
// one from the start. Units: metres, seconds, in one Cartesian frame.
#pragma once

#include <beespace/export.hpp>
#include <beespace/mover.hpp>
#include <beespace/pairs.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace beespace {

// What a bee can do.
struct FlightLimits {
  double max_speed_mps = 10.0;
  // Infinite: velocities change at once.
  double max_acceleration_mps2 = std::numeric_limits<double>::infinity();

  friend constexpr bool operator==(const FlightLimits&, const FlightLimits&) = default;
};

struct AdviseOptions {
  // Metres: nobody shall come closer than this to anybody.
  double threshold_m = 5.0;

  // Seconds: until the next advice. All bees begin it at the same time.
  double step_s = 0.1;

  // Metres: how far from where it is said to be a bee may be, now and wherever it is told to go. It
  // widens the threshold by twice this.
  double uncertainty_m = 0.0;

  // How many threads may work, the calling one included; 0 means one per processor. The answer is
  // the same for every number.
  unsigned threads = 1;
};

enum class AdviceKind : std::uint8_t {
  kAsWished,   // the preferred velocity, or as near to it as the bee's limits allow
  kDeflected,  // another one, for the sake of others
  kBraking,    // the bee brakes as hard as it can: there is nothing better
};

struct Advice {
  Velocity velocity;  // for the end of the step; without a limit of acceleration, for all of it
  AdviceKind kind = AdviceKind::kAsWished;
  // Whether this bee keeps the threshold from all others that do as advised. It does not where it
  // is closer to somebody already, or could not brake in time: see Advised::too_close.
  bool certified = true;

  friend constexpr bool operator==(const Advice&, const Advice&) = default;
};

struct Advised {
  std::vector<Advice> advice;  // of each bee
  // Who is not certified, and because of whom: pairs whose ways to a stop come closer than the
  // threshold. They do not come closer than those ways are; ascending.
  std::vector<Pair> too_close;
};

// Gives advice again and again: keeps its working memory and its threads between calls.
//
// Ownership: an Adviser owns its memory. Not thread-safe: use one a thread.
class BEESPACE_API Adviser {
 public:
  Adviser();
  Adviser(const Adviser&) = delete;
  Adviser& operator=(const Adviser&) = delete;
  Adviser(Adviser&&) noexcept;
  Adviser& operator=(Adviser&&) noexcept;
  ~Adviser();

  // `preferred` has a velocity for each of `movers`; `limits` one set of limits for each, or one
  // for all. The answer depends on nothing but these: not on the order of calls, nor on threads.
  //
  // Errors: kInvalidThreshold; kInvalidArgument for a step that is not above zero, a negative
  // uncertainty, limits that are negative or not numbers, or spans of the wrong length; kNotFinite
  // and kOutsideDomain (the motion domain, see mover.hpp) for movers and preferred velocities, with
  // the mover in place.record; kTooManyPoints. Then `advised` is unspecified.
  Status advise(const MoversView& movers, std::span<const Velocity> preferred,
                std::span<const FlightLimits> limits, const AdviseOptions& options,
                Advised& advised);

 private:
  class State;
  std::unique_ptr<State> state_;
};

// The same once.
BEESPACE_API Result<Advised> advise(const MoversView& movers, std::span<const Velocity> preferred,
                                    std::span<const FlightLimits> limits,
                                    const AdviseOptions& options = {});

}  // namespace beespace
