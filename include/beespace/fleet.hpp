/// @file
/// @brief What is known about a fleet, and how far from its nominal path an agent can be.
///
/// An agent is kept near its nominal path by a loop: something measures how far it deviates, and
/// something corrects it. From the bounds of its errors follows the radius of the *tube* around the
/// nominal path that it never leaves, and what its corrections need. The derivation is in
/// docs/tube.md. Units: metres and seconds.
///
/// Complexity: constant. Thread safety: no state is kept.
#pragma once

#include <beespace/advise.hpp>
#include <beespace/export.hpp>
#include <beespace/result.hpp>

#include <cstdint>

namespace beespace {

/// @brief Where the loop that keeps an agent on its path is closed.
enum class LoopPlace : std::uint8_t {
  /// @brief The agent holds its path itself, with or without radio: it measures where it is and
  /// corrects.
  kOnboard,
  /// @brief The agent flies the velocities that it is told; the planner measures, by reports, and
  /// corrects, by commands. What is promised ends where reports or commands do.
  kGround,
};

/// @brief The figures of a fleet, or of one agent: all of them bounds, none a mean. One that is not
/// given is 0: perfect.
struct FleetFigures {
  LoopPlace loop = LoopPlace::kOnboard;  ///< Where the loop is closed.

  /// @brief How far at most a reported position is from the true one at its stamp, in metres.
  double report_error_m = 0.0;
  /// @brief How old at most the newest report of an agent is when the planner uses it, in seconds:
  /// from one report to the next, and how long it is under way.
  double report_age_s = 0.0;

  /// @brief On board: how far at most what the agent takes for its position is from the true one,
  /// in metres.
  double sensing_error_m = 0.0;
  /// @brief On board: the period of the agent's own loop in seconds; zero: it is continuous.
  double loop_period_s = 0.0;
  /// @brief On board: how old at most a measurement is when what follows from it begins to act, in
  /// seconds.
  double loop_delay_s = 0.0;

  /// @brief How fast at most all things together carry an agent off its path, in metres per second:
  /// wind, drift, errors of velocity, and, where its clock is corrected, by how much a second that
  /// goes, times its greatest speed.
  double deviation_mps = 0.0;
  /// @brief How far at most the clock of an agent is off, in seconds. It may wander within that,
  /// but not jump.
  double clock_error_s = 0.0;

  /// @brief How much of the greatest acceleration is kept for corrections, in m/s^2.
  double correction_mps2 = 0.0;
  /// @brief How much of the greatest speed is kept for corrections, in m/s.
  double correction_mps = 0.0;

  friend constexpr bool operator==(const FleetFigures&, const FleetFigures&) = default;
};

/// @brief How the planner talks with a fleet.
struct LinkFigures {
  double period_s = 0.1;  ///< A tick, in seconds; above zero.
  /// @brief After how many ticks a command takes effect; the same for all, 1 to 32. An agent takes
  /// it only if it arrives before that tick begins, by the clock of the agent.
  int command_delay = 1;
  /// @brief How many commands or reports of an agent, one after the other, are lost at most. On the
  /// ground it must be zero.
  int longest_loss = 0;

  friend constexpr bool operator==(const LinkFigures&, const LinkFigures&) = default;
};

/// @brief The tube of an agent, and the loop that keeps it there.
struct Tube {
  double radius_m = 0.0;  ///< The agent is never farther from its nominal place, in metres.
  double clock_m = 0.0;   ///< What of this is for its clock, in metres.
  double error_m = 0.0;   ///< The error that its loop works with, delays included, in metres.
  /// @brief How fast the loop corrects: deviations shrink as exp(-gain t). Both poles of the loop
  /// lie there; of one with a period T, at exp(-gain T). Zero: nothing is to be corrected.
  double gain_per_s = 0.0;
  double correction_mps2 = 0.0;  ///< The greatest acceleration that the loop asks for, in m/s^2.
  double correction_mps = 0.0;   ///< The greatest velocity that it asks for, in m/s.
  /// @brief What is left for the plan: the limits less what is kept for corrections.
  FlightLimits planned;

  friend constexpr bool operator==(const Tube&, const Tube&) = default;
};

/// @brief Computes the smallest tube that the figures allow: that of the fastest loop of which the
/// corrections fit what is kept for them.
///
/// It never falls when an error, a delay or the deviation grows. An agent that joins is within its
/// tube from the start, if it stands within `report_error_m` of where it is said to stand.
///
/// @param figures What is known of the agent.
/// @param link How the planner talks with it.
/// @param limits What the agent can do.
/// @return The tube; or ErrorCode::kInvalidArgument: a figure that is negative or not finite, or
///   figures that contradict each other, with the inequality and the numbers: corrections that are
///   too weak or too slow for the deviation, reserves that leave nothing for the plan, a loop on
///   the ground whose messages get lost.
BEESPACE_API Result<Tube> tube_of(const FleetFigures& figures, const LinkFigures& link,
                                  const FlightLimits& limits);

}  // namespace beespace
