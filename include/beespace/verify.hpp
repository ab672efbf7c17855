// Did everybody keep the distance, and fly as they can? An independent check of what has been
// flown, whoever planned it.
//
// This knows nothing of how velocities are found (advise.hpp): it looks at positions, velocities
// and times only, and at all of the time in between, not at samples of it. Between two fixes a bee
// moves on the curve of third degree that has its positions and velocities at both; where it
// accelerates evenly, that is how it moves. Without velocities it moves in a straight line.
//
// Units: metres, seconds, in one Cartesian frame.
#pragma once

#include <beespace/export.hpp>
#include <beespace/mover.hpp>
#include <beespace/not_given.hpp>
#include <beespace/obstacle.hpp>
#include <beespace/pairs.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace beespace {

struct VerifyOptions {
  // Metres: who comes closer than this to another one has lost separation. What rounding cannot
  // exclude counts as lost, so two who are exactly the threshold apart may. Must be given.
  double threshold_m = kNotGiven;

  // What stands in the way; not owned, and null for nothing. Who comes closer to it than the
  // clearance, in metres, above zero, has lost it; again what rounding cannot exclude. It must be
  // given where there are obstacles.
  const ObstacleMap* obstacles = nullptr;
  double clearance_m = kNotGiven;

  // What everybody can do; infinite: not checked. Speeds and accelerations are those of the curves,
  // and may be above these by a billionth, and by what the rounding of the given positions and
  // times makes of them: little, unless coordinates are large or times count from 1970.
  double max_speed_mps = std::numeric_limits<double>::infinity();
  double max_acceleration_mps2 = std::numeric_limits<double>::infinity();

  // Whether velocities jump from one step to the next: then bees fly in straight lines between
  // their fixes, the velocities that are given are not looked at, and accelerations are not
  // checked.
  bool straight = false;

  // How many threads may work, the calling one included; 0 means one per processor.
  unsigned threads = 1;
};

// Two that came closer than the threshold in one step.
struct Loss {
  Pair pair;
  double begins_s = 0.0;  // of the step
  double ends_s = 0.0;
  double closest_m = 0.0;  // how close at least, to a millionth of the threshold

  friend constexpr bool operator==(const Loss&, const Loss&) = default;
};

// One that came closer to an obstacle than the clearance in one step.
struct ClearanceLoss {
  PointId bee = 0;
  std::size_t obstacle = 0;  // the first that it came too close to
  double begins_s = 0.0;     // of the step
  double ends_s = 0.0;
  double closest_m = 0.0;  // how close it was seen to be to any; below zero inside

  friend constexpr bool operator==(const ClearanceLoss&, const ClearanceLoss&) = default;
};

enum class BreachKind : std::uint8_t { kSpeed, kAcceleration };

// One that flew as it cannot, in one step.
struct Breach {
  PointId bee = 0;
  BreachKind kind = BreachKind::kSpeed;
  double begins_s = 0.0;  // of the step
  double value = 0.0;     // the most, in m/s or m/s^2

  friend constexpr bool operator==(const Breach&, const Breach&) = default;
};

// What was found in all steps so far.
struct Verdict {
  std::uint64_t steps = 0;
  std::uint64_t losses = 0;            // pairs, counted anew in each step
  std::uint64_t clearance_losses = 0;  // bees, counted anew in each step
  std::uint64_t breaches = 0;          // of limits
  // The first of each, at most kMostShown.
  static constexpr std::size_t kMostShown = 1000;
  std::vector<Loss> first_losses;
  std::vector<ClearanceLoss> first_clearance_losses;
  std::vector<Breach> first_breaches;
  // The closest that any two came, where they came closer than twice the threshold; to a millionth
  // of the threshold, and never more than it was.
  std::optional<double> closest_m = {};
  std::optional<Pair> closest_pair = {};
  double closest_step_s = 0.0;  // when the step of that began
  double fastest_mps = 0.0;
  double hardest_mps2 = 0.0;

  [[nodiscard]] bool holds() const { return losses == 0 && clearance_losses == 0 && breaches == 0; }
};

// Checks step after step, so that what was flown need not be kept.
//
// Ownership: a Verifier owns its memory. Not thread-safe.
class BEESPACE_API Verifier {
 public:
  explicit Verifier(const VerifyOptions& options);
  Verifier(const Verifier&) = delete;
  Verifier& operator=(const Verifier&) = delete;
  Verifier(Verifier&&) noexcept;
  Verifier& operator=(Verifier&&) noexcept;
  ~Verifier();

  // Where everybody is at a time, and how fast: the end of the step that the call before began. As
  // many movers each time.
  //
  // Errors: kInvalidThreshold, kInvalidArgument (another number of movers, limits below zero, a
  // clearance that is not above zero, a step that lasts longer or less than times in the motion
  // domain, a view whose arrays do not fit together);
  // kTimeOrder for a time that is not after the one before; kNotFinite and kOutsideDomain, with the
  // mover in place.record. Numbers too small for the motion domain are looked at as they are.
  Status add(double time_s, const MoversView& movers);

  [[nodiscard]] const Verdict& verdict() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace beespace
