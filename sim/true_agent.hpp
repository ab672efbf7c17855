// The truth of one agent: how it really flies, what it measures, and what it says.
//
// Its physics are integrated here on their own: nothing of this knows how the library plans, how
// wide it takes a tube to be or how it judges. In each instant (a sub-step of a tick) the true
// velocity changes evenly, so that a recording of all instants with velocities describes the flight
// exactly. The velocity is the agent's own, which its motors change, and that of the disturbance.
//
// On board it measures where it is, in each period of its loop, and corrects. On the ground it
// flies the velocities that it is told. Where it should be it knows from a beespace::Follower, by
// its own clock.
#pragma once

#include "sim/agent_clock.hpp"
#include "sim/disturbance.hpp"
#include "sim/vector3.hpp"

#include <beespace/advise.hpp>
#include <beespace/command.hpp>
#include <beespace/fleet.hpp>
#include <beespace/follower.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace beespace::sim {

// Within an instant: from `position` and `velocity` with a constant acceleration.
struct Stretch {
  Vector3 position;
  Vector3 velocity;
  Vector3 acceleration;
};

// What is wrong with an agent: bounds. All zero: nothing.
struct AgentErrors {
  DisturbanceBounds disturbance;
  ClockErrors clock;
  double sensing_error_m = 0.0;          // of what it measures on board
  double report_error_m = 0.0;           // of the place that it reports
  double report_velocity_error_mps = 0;  // of the velocity that it reports
  double strength = 1.0;                 // which share of its acceleration it really has
};

// The loop of an agent, in instants.
struct AgentLoop {
  LoopPlace place = LoopPlace::kOnboard;
  std::int64_t instant_ns = 20'000'000;
  std::int64_t instants_per_tick = 5;
  int period = 1;           // of the loop on board
  int delay = 0;            // of what is measured on board
  double gain_per_s = 0.0;  // Tube::gain_per_s
  double max_acceleration_mps2 = 5.0;
  // A fault for tests of the harness: its tick is the floor of a sum of seconds by a period.
  bool floors_ticks = false;
};

class TrueAgent {
 public:
  // It stands at its start.
  TrueAgent(const Follower& follower, const Point& start, const AgentLoop& loop,
            const AgentErrors& errors, std::uint64_t seed);

  // Begins at a later instant than the first: its clock counts from there.
  void begin_at(std::int64_t instant) { clock_.begin_at(instant); }
  // At the begin of an instant: sets its tick by its clock. Whether a tick has begun.
  bool look_at_clock();
  Acknowledgement receive(const Command& command) { return follower_.receive(command); }
  // Where it is, as it measures it now.
  AgentReport report();
  // Flies for an instant. `towards`: see Disturbance.
  void fly(const Vector3& towards);

  [[nodiscard]] const Stretch& stretch() const { return stretch_; }  // of the last instant
  [[nodiscard]] const Vector3& position() const { return position_; }
  [[nodiscard]] Vector3 velocity() const;
  // Where it should be now, by its own clock.
  [[nodiscard]] Setpoint setpoint() const;
  [[nodiscard]] double deviation_m() const;
  [[nodiscard]] const Follower& follower() const { return follower_; }

  void weaken(double strength) { errors_.strength = strength; }

 private:
  [[nodiscard]] Setpoint setpoint_at(std::int64_t clock_ns) const;
  [[nodiscard]] std::int64_t tick_ns() const { return loop_.instant_ns * loop_.instants_per_tick; }
  void measure();
  void correct(const Setpoint& now);
  void fly_by(const Setpoint& now, const Setpoint& next, const Vector3& towards);
  [[nodiscard]] double instant_s() const { return static_cast<double>(loop_.instant_ns) * 1e-9; }

  Follower follower_;
  Point start_;
  AgentLoop loop_;
  AgentErrors errors_;
  AgentClock clock_;
  Disturbance disturbance_;
  std::uint64_t instant_ = 0;
  double summed_s_ = 0.0;  // for the fault, that of one who joins at the start
  bool began_ = false;
  // Where the loop is closed on the ground nothing corrects it before its first command that says
  // so: it stands until then (docs/tube.md).
  bool flies_ = false;

  Vector3 position_;
  Vector3 own_velocity_;
  Stretch stretch_;
  // How far it has flown by itself; and what it measured less that, the newest last: so a late
  // measurement is off by what disturbances did since, and no more.
  Vector3 own_way_;
  std::vector<Vector3> measured_;
  Vector3 correction_mps2_;
};

}  // namespace beespace::sim
