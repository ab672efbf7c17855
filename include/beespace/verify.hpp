/// @file
/// @brief Did all agents keep the threshold, and fly within their limits? An independent check of
/// what has been flown, by whatever planner.
///
/// This is independent of how velocities are found (advise.hpp): it reads positions, velocities and
/// times only, and checks all of the time in between, not samples of it. Between two fixes an agent
/// moves on the cubic curve (the cubic Hermite spline) that has its positions and velocities at
/// both; where it accelerates evenly, that is how it moves. Without velocities it moves in a
/// straight line.
///
/// Units: metres and seconds, in one Cartesian frame.
#pragma once

#include <beespace/export.hpp>
#include <beespace/lifetimebound.hpp>
#include <beespace/mover.hpp>
#include <beespace/not_given.hpp>
#include <beespace/obstacle.hpp>
#include <beespace/pairs.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace beespace {

/// @brief What a verification needs to know.
///
/// Ownership: `obstacles` refers to the caller's map, which must outlive the options.
struct VerifyOptions {
  /// @brief The threshold in metres: two agents that come closer than this have lost separation.
  ///
  /// What rounding cannot exclude counts as lost, so two that are exactly the threshold apart may
  /// count. Must be given: there is no default.
  double threshold_m = kNotGiven;

  /// @brief The static obstacles; null for none.
  const ObstacleMap* obstacles = nullptr;
  /// @brief The clearance in metres: an agent that comes closer to an obstacle than this has lost
  /// it, and again what rounding cannot exclude counts. Above zero; must be given where there are
  /// obstacles.
  double clearance_m = kNotGiven;

  /// @brief The greatest speed of each agent in metres per second; infinite: not checked.
  ///
  /// Speeds and accelerations are those of the curves. They may be above these limits by a
  /// billionth, and by the effect of rounding of the given positions and times: little, unless
  /// coordinates are large or times count from 1970.
  double max_speed_mps = std::numeric_limits<double>::infinity();
  /// @brief The greatest acceleration of each agent in metres per second squared; infinite: not
  /// checked.
  double max_acceleration_mps2 = std::numeric_limits<double>::infinity();

  /// @brief Whether velocities jump from one step to the next: agents then fly in straight lines
  /// between their fixes, the given velocities are ignored, and accelerations are not checked.
  bool straight = false;

  /// @brief How many threads may work, the calling one included; 0 means one per processor.
  unsigned threads = 1;

  /// @brief When a stop is requested while pairs are searched, which takes longest, Verifier::add
  /// ends soon, with ErrorCode::kStopped, and has taken nothing: the same call can be made again.
  std::stop_token stop = {};
};

/// @brief A loss of separation: two agents that came closer than the threshold in one step.
struct Loss {
  Pair pair;               ///< The two agents.
  double begins_s = 0.0;   ///< When the step begins, in seconds.
  double ends_s = 0.0;     ///< When the step ends, in seconds.
  double closest_m = 0.0;  ///< How close at least, in metres, to a millionth of the threshold.

  friend constexpr bool operator==(const Loss&, const Loss&) = default;
};

/// @brief A loss of clearance: an agent that came closer to an obstacle than the clearance in one
/// step.
struct ClearanceLoss {
  PointId agent = 0;         ///< The index of the agent.
  std::size_t obstacle = 0;  ///< The index of the first obstacle to which it came too close.
  double begins_s = 0.0;     ///< When the step begins, in seconds.
  double ends_s = 0.0;       ///< When the step ends, in seconds.
  double closest_m =
      0.0;  ///< The least distance seen to any obstacle, in metres; below zero inside.

  friend constexpr bool operator==(const ClearanceLoss&, const ClearanceLoss&) = default;
};

/// @brief The limits that can be exceeded.
enum class BreachKind : std::uint8_t {
  kSpeed,         ///< VerifyOptions::max_speed_mps.
  kAcceleration,  ///< VerifyOptions::max_acceleration_mps2.
};

/// @brief A breach of limits: an agent that exceeded one in one step.
struct Breach {
  PointId agent = 0;                     ///< The index of the agent.
  BreachKind kind = BreachKind::kSpeed;  ///< Which limit.
  double begins_s = 0.0;                 ///< When the step begins, in seconds.
  double value = 0.0;                    ///< The greatest value, in m/s or m/s^2.

  friend constexpr bool operator==(const Breach&, const Breach&) = default;
};

/// @brief What was found in all steps so far.
struct Verdict {
  std::uint64_t steps = 0;             ///< How many steps were checked.
  std::uint64_t losses = 0;            ///< Losses of separation: pairs, counted anew in each step.
  std::uint64_t clearance_losses = 0;  ///< Losses of clearance: agents, counted anew in each step.
  std::uint64_t breaches = 0;          ///< Breaches of limits.
  /// @brief The most entries that each of the lists below holds.
  static constexpr std::size_t kMostShown = 1000;
  std::vector<Loss> first_losses;                     ///< The first losses of separation.
  std::vector<ClearanceLoss> first_clearance_losses;  ///< The first losses of clearance.
  std::vector<Breach> first_breaches;                 ///< The first breaches of limits.
  /// @brief The least distance of any two agents in metres, where it is below twice the threshold;
  /// to a millionth of the threshold, and never more than it was.
  std::optional<double> closest_m = {};
  std::optional<Pair> closest_pair = {};  ///< The two agents of `closest_m`.
  double closest_step_s = 0.0;            ///< When the step of `closest_m` began, in seconds.
  double peak_speed_mps = 0.0;            ///< The greatest speed, in metres per second.
  double peak_acceleration_mps2 =
      0.0;  ///< The greatest acceleration, in metres per second squared.

  /// @brief Says whether nothing was lost or exceeded.
  /// @return Whether all three counts are zero.
  [[nodiscard]] bool holds() const { return losses == 0 && clearance_losses == 0 && breaches == 0; }
};

/// @brief Checks step after step, so that what was flown need not be kept.
///
/// Ownership: a Verifier owns its memory. Thread safety: none. A moved-from Verifier can only be
/// destroyed or assigned to.
class BEESPACE_API Verifier {
 public:
  /// @brief Makes a verifier that has checked nothing.
  /// @param options The threshold and the limits. If they make no sense, add() returns the error.
  explicit Verifier(const VerifyOptions& options);
  Verifier(const Verifier&) = delete;
  Verifier& operator=(const Verifier&) = delete;
  /// @brief Takes over what was found.
  Verifier(Verifier&&) noexcept;
  /// @brief Takes over what was found.
  /// @return This.
  Verifier& operator=(Verifier&&) noexcept;
  /// @brief Frees its memory.
  ~Verifier();

  /// @brief Takes where all agents are at a time, and how fast: the end of the step that the call
  /// before began.
  ///
  /// Numbers too small for the motion domain are used as they are.
  ///
  /// @param time_s The time in seconds; after that of the call before.
  /// @param movers The agents, in metres and metres per second; as many each time.
  /// @return Success; or an error:
  ///   - ErrorCode::kInvalidThreshold: a threshold that is not given, or is no number above zero of
  ///     the motion domain (see mover.hpp);
  ///   - ErrorCode::kInvalidArgument: another number of agents, limits below zero, a clearance that
  ///     is not above zero, a step that lasts longer or less than times in the motion domain, a
  ///     view whose arrays do not fit together;
  ///   - ErrorCode::kTimeOrder: a time that is not after the one before;
  ///   - ErrorCode::kNotFinite, ErrorCode::kOutsideDomain: a value outside the motion domain, with
  ///     the agent in ErrorLocation::record;
  ///   - ErrorCode::kStopped: a stop was requested (VerifyOptions::stop).
  Status add(double time_s, const MoversView& movers);
  /// @brief The same with threads and a stop of this call, in place of those of the options.
  /// @param time_s The time in seconds.
  /// @param movers The agents, in metres and metres per second.
  /// @param run How many threads may work, and what ends the call early.
  /// @return Success, or the same errors.
  Status add(double time_s, const MoversView& movers, const RunOptions& run);

  /// @brief Says that it was not seen what agents did from the last time on until the next one: no
  /// step is checked in between, and what was found so far stays. There may be other agents then.
  void skip();

  /// @brief Says what was found so far.
  /// @return The verdict, in the memory of this; changed by add().
  [[nodiscard]] const Verdict& verdict() const BEESPACE_LIFETIMEBOUND;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace beespace
