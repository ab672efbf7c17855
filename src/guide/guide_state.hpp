// The fleet of a Guide: who is in it, what is known of each, and the tick.
//
// Members are in a dense row, in any order, so that each call of the Adviser sees them all;
// `by_id_` has them in the order of their ids, in which all is told.
#pragma once

#include "guide/ball.hpp"
#include "guide/guided_agent.hpp"

#include <beespace/advise.hpp>
#include <beespace/guide.hpp>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace beespace {

class __attribute__((visibility("hidden"))) Guide::State {
 public:
  explicit State(const GuideOptions& options);

  // Membership.
  Result<JoinAnswer> join(const JoinRequest& request, bool for_good);
  Status adopt(const JoinRequest& request, const StoredBranch& stored);
  void expect(std::span<const AgentId> agents);
  Status leave(AgentId agent);

  // Messages.
  Status set_goal(AgentId agent, const Point& goal);
  Status set_preferred(AgentId agent, const Velocity& velocity);
  Status take(const AgentReport& report);
  Status take(const Acknowledgement& acknowledgement);
  Status set_intruders(std::span<const Intruder> intruders);

  Status step(Tick now, Guidance& guidance, const std::stop_token& stop);

  [[nodiscard]] std::size_t size() const { return members_.size(); }
  [[nodiscard]] Result<Tube> tube(AgentId agent) const;
  [[nodiscard]] Result<std::vector<Point>> claim(AgentId agent) const;

  // That these options make sense.
  [[nodiscard]] Status check();

 private:
  using Member = guide::GuidedAgent;

  // Its place in by_id_, or where it would be.
  [[nodiscard]] std::size_t place_of(AgentId agent) const;
  [[nodiscard]] bool is_at(std::size_t place, AgentId agent) const {
    return place < by_id_.size() && by_id_[place].id == agent;
  }
  [[nodiscard]] Member* find(AgentId agent);
  [[nodiscard]] const Member* find(AgentId agent) const;
  [[nodiscard]] static Error unknown_agent(AgentId agent);
  // That ticks can be added to it and compared without overflow.
  [[nodiscard]] static Status check_tick(Tick tick);

  // What an agent that wants to join would be.
  Result<Tube> tube_for(const JoinRequest& request) const;
  Status check_new(const JoinRequest& request) const;
  [[nodiscard]] guide::BranchOptions branch_options(const JoinRequest& request,
                                                    const Tube& tube) const;
  // That each tick can have its command.
  [[nodiscard]] Status check_ground(const FleetFigures& figures) const;
  // That an agent that is adopted says so of no tick that lies ahead.
  [[nodiscard]] Status check_stored(const JoinRequest& request, Tick tick) const;
  // That its commands do not come too late, by its clock.
  [[nodiscard]] Status check_clock(const FleetFigures& figures) const;
  // That no root which was sent to it before it left can be taken any more.
  [[nodiscard]] Status check_left(const JoinRequest& request) const;
  // Of a fleet in a plane: that it is in it.
  [[nodiscard]] Status check_height(const JoinRequest& request) const;
  void add(const JoinRequest& request, const Tube& tube, guide::Branches&& branches, Tick heard);
  [[nodiscard]] double farthest_apart_m(double radius_m, double other_radius_m) const;
  [[nodiscard]] std::vector<PointId> near(const Point& place, double tube_m, double radius_m);
  Status find_touching(const JoinRequest& request, const Tube& tube, JoinAnswer& answer);

  // What a report says, where the next step is of tick `next`, or is this one.
  Status hear(Member& member, const AgentReport& report, Tick next);
  // Whether it says that of a tick that lies ahead, as far as its clock may be ahead.
  [[nodiscard]] bool is_ahead(const Member& member, const AgentReport& report, Tick next) const;
  // How many ticks the clock of an agent may be wrong, rounded up.
  [[nodiscard]] Tick clock_ticks(const FleetFigures& figures) const;

  // One tick.
  void begin(Tick now);
  void hear_early(Tick now);
  void miss_ticks();
  void prepare(Tick now);
  void prepare(Member& member, PointId index, Tick now);
  [[nodiscard]] UnknownAgent ball_of(const Member& member, Tick now, PointId index) const;
  [[nodiscard]] double silent_s(const Member& member, Tick now) const;
  void prepare_intruders(Tick now);
  [[nodiscard]] static bool holds(const Member& member);
  [[nodiscard]] static bool is_unknown(const Member& member);
  [[nodiscard]] Velocity preferred(const Member& member, const Point& from) const;
  void tell(PointId index, Tick now, Guidance& guidance);
  [[nodiscard]] bool meets_before_departing(PointId index, Tick now);
  static bool command(Member& member, const Advice& advice, Guidance& guidance);
  void tell_findings(Guidance& guidance) const;
  // How far ahead to keep clear of agents that are out of their tubes, which are looked at anew in
  // each tick.
  [[nodiscard]] double unknown_horizon_s() const {
    return seconds(2 * Tick{options_.link.command_delay} + 4);
  }
  // From which tick on an agent may still be where its branches are: its clock may be behind.
  [[nodiscard]] static Tick claims_from(const Member& member, Tick now);
  [[nodiscard]] double seconds(Tick ticks) const {
    return static_cast<double>(ticks) * options_.link.period_s;
  }

  GuideOptions options_;
  std::vector<Fence> fences_;
  AdviseOptions advise_options_;
  std::optional<Tick> now_;  // of the last step

  std::vector<Member> members_;
  struct Place {
    AgentId id = 0;
    PointId index = 0;
  };
  std::vector<Place> by_id_;  // in ascending order
  // The branches that were sent to those that have left: none is used twice.
  struct Sent {
    std::uint32_t epoch = 0;
    std::uint32_t count = 0;
    Tick left = 0;
  };
  std::map<AgentId, Sent> sent_before_;
  std::set<AgentId> expected_;                 // not heard of yet
  std::vector<Intruder> intruders_;            // those that can be used
  std::vector<std::size_t> intruder_numbers_;  // as they were given
  bool intruder_anywhere_ = false;             // one that cannot be used
  bool intruder_lost_ = false;                 // one may be anywhere by now
  std::optional<Tick> intruders_at_;           // none: since the next step

  // Of a step.
  Adviser adviser_;
  PlaneMemory planes_;
  Advised advised_;
  std::vector<Mover> movers_;
  std::vector<Velocity> preferred_;
  std::vector<FlightLimits> limits_;
  std::vector<Point> places_;
  std::vector<std::size_t> place_ends_;
  std::vector<Claim> claims_;
  std::vector<UnknownAgent> unknown_;  // those that are out of their tubes
  std::vector<Mover> intruder_movers_;
  std::vector<double> intruder_margins_m_;
  std::vector<std::size_t> intruders_of_step_;  // as they were given
  std::vector<AgentAndObject> met_early_;       // intruders, before commands of the step depart
};

}  // namespace beespace
