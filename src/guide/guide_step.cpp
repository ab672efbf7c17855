// One tick of a Guide: claims of all, advice, commands.
#include "avoidance/advised_flight.hpp"
#include "fleet/check_figures.hpp"
#include "guide/guide_state.hpp"
#include "motion/flush.hpp"
#include "motion/validate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace beespace {

namespace {

constexpr double kMeetWithin_s = 2.0;

}  // namespace

Guide::State::State(const GuideOptions& options)
    : options_(options), fences_(options.fences.begin(), options.fences.end()) {
  options_.fences = {};
  advise_options_.threshold_m = options.threshold_m;
  advise_options_.separation = options.separation;
  advise_options_.step_s = options.link.period_s;
  advise_options_.obstacles = options.obstacles;
  advise_options_.clearance_m = options.clearance_m;
  advise_options_.intruder_horizon_s = options.intruder_horizon_s;
  advise_options_.planar = options.planar;
  advise_options_.threads = options.threads;
}

Status Guide::State::check() {
  const auto wrong = [](const std::string& what) {
    return Error{ErrorCode::kInvalidArgument, what, {}};
  };
  if (options_.epoch == 0) {
    return wrong("the epoch is 0; give one greater than that of every planner before");
  }
  if (!std::isfinite(options_.limits.max_acceleration_mps2)) {
    return wrong("a Guide needs a greatest acceleration: give a finite one in limits");
  }
  if (auto tube = tube_for({}); !tube) return std::move(tube).error();
  // The rest is checked by the Adviser.
  AdviseOptions options = advise_options_;
  options.fences = fences_;
  options.unknown_horizon_s = unknown_horizon_s();
  return adviser_.advise({}, {}, std::span(&options_.limits, 1), options, advised_);
}

// An agent whose clock is a tick ahead takes no command that departs a tick after it is sent; and
// one whose clock is behind by more than a tick, none that begins a tick before it is sent.
Status Guide::State::check_clock(const FleetFigures& figures) const {
  const auto wrong = [&](const std::string& what) {
    return Error{ErrorCode::kInvalidArgument,
                 "clock_error_s is " + fleet::number(figures.clock_error_s) + what,
                 {}};
  };
  if (!(figures.clock_error_s > 0.0)) return std::monostate{};
  if (options_.link.command_delay < 2) {
    return wrong(
        ", and command_delay is 1 tick: commands would come too late for agents whose clocks are "
        "ahead; give a delay of 2 or more");
  }
  if (figures.clock_error_s <= options_.link.period_s) return std::monostate{};
  return wrong(", and period_s " + fleet::number(options_.link.period_s) +
               ": commands would come too late or too early for agents whose clocks are off by "
               "more than a tick; give a longer period, or better clocks");
}

// From the ground each tick needs a command, with a correction. A command counts as one that the
// agent may be on until a report of a later one has come: so many are held at the same time.
Status Guide::State::check_ground(const FleetFigures& figures) const {
  if (figures.loop != LoopPlace::kGround) return std::monostate{};
  constexpr double kRounding = 1e-9;
  const double age_ticks = std::ceil(figures.report_age_s / options_.link.period_s - kRounding);
  const double clocks = figures.clock_error_s > 0.0 ? 2.0 : 0.0;
  constexpr auto kMost = static_cast<double>(guide::Branches::kMostLive);
  if (age_ticks + clocks + options_.link.command_delay <= kMost) return std::monostate{};
  return Error{ErrorCode::kInvalidArgument,
               "the loop is closed on the ground, report_age_s is " +
                   fleet::number(figures.report_age_s) + ", and command_delay " +
                   std::to_string(options_.link.command_delay) + " ticks: together they may be " +
                   std::to_string(guide::Branches::kMostLive) +
                   " ticks, and 2 less where clocks are off; give a longer period, or faster "
                   "messages",
               {}};
}

Tick Guide::State::claims_from(const Member& member, Tick now) {
  return member.figures.clock_error_s > 0.0 ? now - 1 : now;
}

// Out of its contract, or on the ground loop without a report: its tube no longer holds it.
bool Guide::State::is_unknown(const Member& member) {
  if (member.monitor.contract() == Contract::kOut) return true;
  return member.is_on_ground_loop() && member.monitor.reason() == ContractReason::kSilent;
}

// It gets nothing new.
bool Guide::State::holds(const Member& member) {
  return member.branches.awaits_root() || member.branches.full() ||
         member.monitor.reason() == ContractReason::kSilent;
}

Velocity Guide::State::preferred(const Member& member, const Point& from) const {
  if (!member.goal) return member.preferred;
  return velocity_to_goal(from, *member.goal, member.tube.planned, options_.link.period_s)
      .value_or(Velocity{});
}

void Guide::State::prepare(Tick now) {
  movers_.clear();
  preferred_.clear();
  limits_.clear();
  places_.clear();
  place_ends_.clear();
  unknown_.clear();
  claims_.clear();
  for (PointId index = 0; index < members_.size(); ++index) prepare(members_[index], index, now);
  std::size_t begin = 0;
  for (PointId index = 0; index < members_.size(); ++index) {
    const Member& member = members_[index];
    claims_.push_back({std::span(places_).subspan(begin, place_ends_[index] - begin),
                       member.tube.radius_m, member.radius_m, holds(member)});
    begin = place_ends_[index];
  }
  prepare_intruders(now);
}

// On the ground it counts from when the newest report was measured, not from when it came: what
// corrects an agent is as old as that.
double Guide::State::silent_s(const Member& member, Tick now) const {
  if (!member.is_on_ground_loop() || !member.last) return seconds(now - member.heard);
  return seconds(now - member.last->tick) - member.last->after_s;
}

void Guide::State::prepare(Member& member, PointId index, Tick now) {
  member.branches.advance(now);
  member.around.reset();
  if (!member.branches.awaits_root()) member.monitor.check_silence(silent_s(member, now));
  // From the ground none can be left without a correction.
  if (member.is_on_ground_loop() && member.branches.full()) {
    member.monitor.name(ContractReason::kSilent);
  }
  const Mover base = member.branches.base_state(now + options_.link.command_delay);
  movers_.push_back(base);
  preferred_.push_back(preferred(member, base.position));
  limits_.push_back(member.tube.planned);
  member.branches.append_places(claims_from(member, now), places_);
  place_ends_.push_back(places_.size());
  if (is_unknown(member)) unknown_.push_back(ball_of(member, now, index));
}

// Where an agent is of which the tube no longer tells it.
UnknownAgent Guide::State::ball_of(const Member& member, Tick now, PointId index) const {
  const FleetFigures& figures = member.figures;
  const double fastest_mps = member.tube.planned.max_speed_mps + figures.correction_mps;
  const bool is_out = member.monitor.contract() == Contract::kOut;
  if (is_out && member.last) {
    const double age_s = std::max(0.0, seconds(now - member.last->tick) - member.last->after_s) +
                         figures.clock_error_s;
    const double growth_mps = fastest_mps + figures.deviation_mps;
    return {member.last->position, figures.report_error_m + growth_mps * age_s, growth_mps, index};
  }
  std::vector<Point> places;
  member.branches.append_places(claims_from(member, now), places);
  const guide::Ball ball = guide::ball_around(places);
  const double silent_s = seconds(std::max<Tick>(0, now - member.heard));
  const double growth_mps = figures.deviation_mps + (is_out ? fastest_mps : 0.0);
  return {{ball.middle.x, ball.middle.y, ball.middle.z},
          ball.radius_m + member.tube.radius_m + growth_mps * silent_s,
          growth_mps,
          index};
}

// Flown straight on since they were told of.
void Guide::State::prepare_intruders(Tick now) {
  if (!intruders_at_) intruders_at_ = now;
  // To where they are when commands take effect.
  const double since_s = seconds(now - *intruders_at_ + options_.link.command_delay);
  intruder_movers_.clear();
  intruder_margins_m_.clear();
  intruders_of_step_.clear();
  intruder_lost_ = false;
  for (std::size_t index = 0; index < intruders_.size(); ++index) {
    const auto& [p, v] = intruders_[index].mover;
    const Mover mover =
        motion::flushed(Mover{{p.x + v.x * since_s, p.y + v.y * since_s, p.z + v.z * since_s}, v});
    // What is uncertain of its velocity adds up until they meet: for some seconds, as a rule.
    const double ahead_s = since_s + std::min(kMeetWithin_s, options_.intruder_horizon_s);
    const double margin_m =
        motion::flushed(intruders_[index].radius_m + intruders_[index].position_error_m +
                        intruders_[index].speed_error_mps * ahead_s);
    // Beyond what can be computed with: it may be anywhere. The others are not.
    if (motion::check_mover(mover, index) || !motion::in_motion_domain(margin_m)) {
      intruder_lost_ = true;
      continue;
    }
    intruder_movers_.push_back(mover);
    intruder_margins_m_.push_back(margin_m);
    intruders_of_step_.push_back(intruder_numbers_[index]);
  }
}

// The adviser looks from where commands depart. Whether an intruder comes too close on the way
// there; then it is added to the conflicts.
bool Guide::State::meets_before_departing(PointId index, Tick now) {
  const Member& member = members_[index];
  const double apart_m =
      farthest_apart_m(member.radius_m, 0.5 * options_.threshold_m) + member.tube.radius_m;
  const Tick departs = now + options_.link.command_delay;
  const core::Vector3 place_then = core::vector_of(member.branches.base_state(departs).position);
  const double fastest_now = length(core::vector_of(member.branches.base_state(now).velocity));
  bool meets = false;
  for (std::size_t k = 0; k < intruder_movers_.size(); ++k) {
    const Mover& there = intruder_movers_[k];
    const double delay_s = seconds(departs - now);
    const double speeds = length(core::vector_of(there.velocity)) +
                          std::max(member.tube.planned.max_speed_mps, fastest_now);
    const double far_m = apart_m + intruder_margins_m_[k] + 2.0 * speeds * delay_s;
    if (length(core::vector_of(there.position) - place_then) > far_m) continue;
    std::optional<double> closest_m;
    for (Tick tick = now; tick < departs; ++tick) {
      const Mover from = member.branches.base_state(tick);
      const avoidance::AdvisedFlight agent(from, member.branches.base_state(tick + 1).velocity);
      const double before_s = seconds(departs - tick);
      const auto& [p, v] = there;
      const avoidance::AdvisedFlight intruder(
          Mover{{p.x - v.x * before_s, p.y - v.y * before_s, p.z - v.z * before_s}, v});
      const auto meeting = avoidance::AdvisedFlight::meeting(
          agent, intruder, apart_m + intruder_margins_m_[k], seconds(1), seconds(1));
      if (meeting) closest_m = std::min(meeting->closest_m, closest_m.value_or(meeting->closest_m));
    }
    if (!closest_m) continue;
    meets = true;
    met_early_.push_back({member.id, intruders_of_step_[k], *closest_m});
  }
  return meets;
}

// Those that joined before the first tick was known join with it.
void Guide::State::begin(Tick now) {
  for (Member& member : members_) {
    if (member.branches.awaits_root()) {
      member.heard = now;
      member.since = now + clock_ticks(member.figures);
    } else if (member.since > now + clock_ticks(member.figures)) {
      member.monitor.name(ContractReason::kFuture);
    }
    member.branches.begin(now);
  }
}

// Ticks in which nothing was sent. On the ground they are corrections that are missing: as where a
// message is lost, nothing is known of such an agent any more.
void Guide::State::miss_ticks() {
  for (Member& member : members_) {
    if (member.is_on_ground_loop() && !member.branches.awaits_root()) {
      member.monitor.name(ContractReason::kSilent);
    }
  }
}

// Reports that lay ahead. What still does comes from a wrong clock.
void Guide::State::hear_early(Tick now) {
  for (Member& member : members_) {
    if (!member.early) continue;
    const AgentReport report = *std::exchange(member.early, {});
    if (is_ahead(member, report, now)) {
      member.monitor.name(ContractReason::kFuture);
    } else {
      // What is wrong with it names the agent.
      static_cast<void>(hear(member, report, now));
    }
  }
}

Status Guide::State::step(Tick now, Guidance& guidance, const std::stop_token& stop) {
  guidance.clear();
  if (Status fine = check_tick(now); !fine) return fine;
  if (now_ && now <= *now_) {
    return Error{ErrorCode::kTimeOrder,
                 "tick " + std::to_string(now) + " does not come after tick " +
                     std::to_string(*now_) + ", the last one",
                 {}};
  }
  if (!now_) begin(now);
  hear_early(now);
  if (now_ && now > *now_ + 1) miss_ticks();
  now_ = now;
  prepare(now);
  AdviseOptions options = advise_options_;
  options.fences = fences_;
  options.claims = claims_;
  options.planes = &planes_;
  options.unknown = unknown_;
  options.unknown_horizon_s = unknown_horizon_s();
  options.intruders = intruder_movers_;
  options.intruder_margins_m = intruder_margins_m_;
  options.stop = stop;
  if (Status done = adviser_.advise(movers_, preferred_, limits_, options, advised_); !done) {
    return done;
  }
  guidance.tick = now;
  met_early_.clear();
  for (const auto& [id, index] : by_id_) tell(index, now, guidance);
  tell_findings(guidance);
  return std::monostate{};
}

void Guide::State::tell(PointId index, Tick now, Guidance& guidance) {
  Member& member = members_[index];
  const Advice& advice = advised_.advice[index];
  AgentGuidance& told = guidance.agents.emplace_back();
  told.agent = member.id;
  told.contract = member.monitor.contract();
  told.reason = member.monitor.reason();
  told.keeps_apart = advice.keeps_apart && advice.clear_of_unknown &&
                     told.contract != Contract::kOut && !member.branches.awaits_root() &&
                     expected_.empty();
  const bool meets_early = meets_before_departing(index, now);
  told.clear_of_intruders =
      advice.clear_of_intruders && !intruder_anywhere_ && !intruder_lost_ && !meets_early;
  told.certified = told.keeps_apart && told.clear_of_intruders && told.contract == Contract::kKept;
  told.kind = advice.kind;
  told.tube_m = member.tube.radius_m;
  told.deviation_m = member.monitor.deviation_m();
  told.commanded = command(member, advice, guidance);
  told.branches = static_cast<std::uint32_t>(member.branches.live_count());
  told.nominal = member.branches.base_state(now);
}

// Whether there is one.
bool Guide::State::command(Member& member, const Advice& advice, Guidance& guidance) {
  guide::Branches& branches = member.branches;
  if (branches.awaits_root()) {
    branches.write_root(guidance.commands.emplace_back());
    return true;
  }
  if (holds(member) || is_unknown(member) || advice.kind == AdviceKind::kNone) return false;
  Velocity correction;
  if (member.is_on_ground_loop()) {
    const Tick departs = branches.departs();
    const core::Vector3 next = member.corrections.next(departs, member.loop);
    member.corrections.set(departs + 1, next);
    correction = {next.x, next.y, next.z};
  } else if (!branches.would_change(advice.velocity)) {
    return false;
  }
  branches.issue(advice.velocity, correction, guidance.commands.emplace_back());
  return true;
}

void Guide::State::tell_findings(Guidance& guidance) const {
  const auto id = [this](std::size_t index) { return members_[index].id; };
  const auto add_pair = [&](AgentId a, AgentId b, double gap_m, double clear_s) {
    guidance.pairs.push_back({std::min(a, b), std::max(a, b), gap_m, clear_s});
  };
  for (const TooClose& close : advised_.too_close) {
    add_pair(id(close.pair.first), id(close.pair.second), close.gap_m, close.clear_s);
  }
  for (const NearUnknown& near : advised_.near_unknown) {
    add_pair(id(near.agent), id(*unknown_[near.unknown].agent), near.gap_m,
             std::numeric_limits<double>::infinity());
  }
  for (const NearObstacle& near : advised_.near_obstacle) {
    guidance.near_obstacle.push_back({id(near.agent), near.obstacle, near.gap_m});
  }
  for (const NearFence& near : advised_.near_fence) {
    guidance.near_fence.push_back({id(near.agent), near.fence, near.gap_m});
  }
  // One that is met before and after is told once, as close as it comes.
  guidance.intruder_conflicts.assign(met_early_.begin(), met_early_.end());
  for (const IntruderConflict& conflict : advised_.intruder_conflicts) {
    const auto same = [&](const AgentAndObject& met) {
      return met.agent == id(conflict.agent) && met.object == intruders_of_step_[conflict.intruder];
    };
    auto& told = guidance.intruder_conflicts;
    const auto early_end = told.begin() + static_cast<std::ptrdiff_t>(met_early_.size());
    if (const auto met = std::find_if(told.begin(), early_end, same); met != early_end) {
      met->gap_m = std::min(met->gap_m, conflict.closest_m);
      continue;
    }
    guidance.intruder_conflicts.push_back(
        {id(conflict.agent), intruders_of_step_[conflict.intruder], conflict.closest_m});
  }
  std::sort(guidance.pairs.begin(), guidance.pairs.end(),
            [](const UncertifiedPair& a, const UncertifiedPair& b) {
              return std::pair(a.first, a.second) < std::pair(b.first, b.second);
            });
  const auto in_order = [](std::vector<AgentAndObject>& found) {
    std::sort(found.begin(), found.end(), [](const AgentAndObject& a, const AgentAndObject& b) {
      return std::pair(a.agent, a.object) < std::pair(b.agent, b.object);
    });
  };
  in_order(guidance.near_obstacle);
  in_order(guidance.near_fence);
  in_order(guidance.intruder_conflicts);
}

}  // namespace beespace
