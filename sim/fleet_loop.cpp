#include "sim/fleet_loop.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace beespace::sim {

namespace {

constexpr std::uint64_t kCommandSeed = 0x1001;
constexpr std::uint64_t kReportSeed = 0x2002;
constexpr std::uint64_t kReplySeed = 0x3003;

// Latencies in instants instead of ticks.
ChannelErrors in_instants(ChannelErrors errors, int instants) {
  errors.least_latency *= instants;
  errors.most_latency *= instants;
  return errors;
}

TrueSeparationOptions check_options(const FleetOptions& options) {
  return {.threshold_m = options.threshold_m,
          .separation = options.separation,
          .instant_s = options.link.period_s / options.instants,
          .instants = static_cast<std::size_t>(options.instants),
          .fences = options.fences,
          .clearance_m = options.clearance_m,
          .planar = options.planar,
          .intruders = options.intruders};
}

}  // namespace

Result<std::unique_ptr<FleetLoop>> FleetLoop::make(scenes::Mission mission,
                                                   const FleetOptions& options) {
  auto tube = stated_tube(options);
  if (!tube) return std::move(tube).error();
  auto obstacles = ObstacleMap::of(mission.obstacles);
  if (!obstacles) return std::move(obstacles).error();
  std::unique_ptr<FleetLoop> loop(new FleetLoop(std::move(mission), options, *tube, *obstacles));
  if (Status begun = loop->begin(); !begun) return std::move(begun).error();
  return loop;
}

FleetLoop::FleetLoop(scenes::Mission mission, const FleetOptions& options, const Tube& tube,
                     const ObstacleMap& obstacles)
    : mission_(std::move(mission)),
      options_(options),
      tube_(tube),
      obstacles_(obstacles),
      random_(options.seed * 7919 + 17),
      agents_(mission_.starts.size()),
      commands_(in_instants(options.commands, options.instants), options.seed + kCommandSeed),
      reports_(in_instants(options.reports, options.instants), options.seed + kReportSeed),
      replies_(in_instants(options.reports, options.instants), options.seed + kReplySeed),
      nearest_(4.0 * options.threshold_m),
      checker_(check_options(options)),
      clearance_(mission_.obstacles.empty() ? nullptr : &obstacles_, options.clearance_m,
                 options.link.period_s / options.instants) {
}

GuideOptions FleetLoop::guide_options() const {
  GuideOptions guided;
  guided.threshold_m = options_.threshold_m;
  guided.separation = options_.separation;
  guided.link = options_.link;
  guided.limits = options_.limits;
  guided.figures = stated_figures(options_);
  if (options_.faults.no_tubes) guided.threshold_m -= 2.0 * tube_.radius_m;
  if (options_.faults.figures_withheld) {
    guided.limits = tube_.planned;
    guided.figures = {};
    guided.figures.loop = options_.place;
  }
  guided.obstacles = mission_.obstacles.empty() ? nullptr : &obstacles_;
  guided.fences = options_.fences;
  guided.clearance_m = options_.clearance_m;
  guided.planar = options_.planar;
  guided.threads = options_.threads;
  return guided;
}

Status FleetLoop::begin() {
  auto guide = Guide::make(guide_options());
  if (!guide) return std::move(guide).error();
  guide_.emplace(std::move(guide).value());
  choose_agents();
  choose_intruders();
  const bool all = !(options_.joins_per_s > 0.0);
  for (std::size_t agent = 0; all && agent < agents_.size(); ++agent) {
    if (Status joined = join(agent); !joined) return joined;
  }
  return std::monostate{};
}

// Who is weak and who falls silent; the first of each by its number, as starts are at random.
void FleetLoop::choose_agents() {
  scenes::RandomStream random(options_.seed * 31 + 5);
  for (FleetAgent& agent : agents_) {
    const double weak = random.uniform();
    const double silent = random.uniform();
    const double when_s = random.uniform(options_.silent_from_s, options_.silent_to_s);
    const double radius_m = random.uniform(options_.least_radius_m, options_.most_radius_m);
    agent.weak = weak < options_.weak_share;
    if (silent < options_.silent_share) agent.falls_silent_s = when_s;
    agent.radius_m = radius_m;
  }
}

// Straight through the middle of the fleet, roughly, from far outside.
void FleetLoop::choose_intruders() {
  if (agents_.empty()) return;
  Vector3 middle;
  for (const Point& start : mission_.starts) middle += vector_of(start);
  middle = middle * (1.0 / static_cast<double>(mission_.starts.size()));
  double radius_m = 0.0;
  for (const Point& start : mission_.starts) {
    radius_m = std::max(radius_m, length_of(vector_of(start) - middle));
  }
  for (std::size_t i = 0; i < options_.intruders; ++i) {
    const Vector3 way = uniform_direction(random_, options_.planar);
    const Vector3 off = uniform_in_ball(random_, options_.planar) * (0.5 * radius_m);
    intruders_.push_back(
        {middle + off - way * (2.0 * radius_m + 50.0), way * options_.intruder_speed_mps});
  }
}

Status FleetLoop::join(std::size_t index) {
  FleetAgent& agent = agents_[index];
  const auto id = static_cast<AgentId>(index);
  auto answer =
      guide_->join({.agent = id, .position = mission_.starts[index], .radius_m = agent.radius_m});
  if (!answer) return std::move(answer).error();
  if (!answer->joined) {
    ++tally_.joins_refused;
    agent.refused = std::move(answer).value();
    waiting_.push_back(index);
    return std::monostate{};
  }
  auto tube = guide_->tube(id);
  if (!tube) return std::move(tube).error();
  agent.tube_m = tube->radius_m;
  auto follower = Follower::make(id, tube->planned, options_.link.period_s);
  if (!follower) return std::move(follower).error();
  AgentLoop loop;
  loop.place = options_.place;
  loop.instants_per_tick = options_.instants;
  loop.instant_ns = std::llround(options_.link.period_s * 1e9 / options_.instants);
  loop.period = options_.loop_period;
  loop.delay = options_.loop_delay;
  loop.gain_per_s = tube_.gain_per_s;
  loop.max_acceleration_mps2 = options_.limits.max_acceleration_mps2;
  loop.floors_ticks = options_.faults.floors_ticks;
  AgentErrors errors = options_.errors;
  errors.strength = agent.weak ? options_.weak_strength : 1.0;
  errors.disturbance.planar = options_.planar;
  agent.truth.emplace(*follower, mission_.starts[index], loop, errors,
                      options_.seed * 1'000'003 + index);
  agent.truth->begin_at(instants(tick_));
  agent.refused.reset();
  joined_.push_back(index);
  return guide_->set_goal(id, mission_.goals[index]);
}

// So many a second ask, and those that were refused ask again once a second.
Status FleetLoop::join_more() {
  if (!(options_.joins_per_s > 0.0)) return std::monostate{};
  const auto ticks_per_s = static_cast<Tick>(std::llround(1.0 / options_.link.period_s));
  if (tick_ % ticks_per_s == 0) {
    for (const std::size_t agent : std::exchange(waiting_, {})) {
      if (Status joined = join(agent); !joined) return joined;
    }
  }
  const double due = options_.joins_per_s * seconds(tick_) + 1.0;
  for (; asked_ < agents_.size() && static_cast<double>(asked_) < due; ++asked_) {
    if (Status joined = join(asked_); !joined) return joined;
  }
  return std::monostate{};
}

AgentReport FleetLoop::report_of(std::size_t index) {
  FleetAgent& agent = agents_[index];
  AgentReport report = agent.truth->report();
  report.agent = index;
  const Vector3 nominal = vector_of(agent.truth->setpoint().nominal.position);
  if (options_.faults.reports_ignored) report.position = point_of(nominal);
  const double off_m = length_of(vector_of(report.position) - nominal);
  if (!agent.passed_s && off_m > agent.tube_m + options_.errors.report_error_m) {
    agent.passed_s = time_s();
  }
  return report;
}

void FleetLoop::hear_and_report(std::int64_t instant) {
  for (const std::size_t index : joined_) {
    FleetAgent& agent = agents_[index];
    const bool ticked = agent.truth->look_at_clock();
    if (ticked && !agent.silent) reports_.send(instant, index, report_of(index));
  }
  commands_.deliver(instant, [&](const Command& command) {
    FleetAgent& agent = agents_[command.agent];
    if (agent.silent) return;
    const Acknowledgement reply = agent.truth->receive(command);
    if (reply.reply == CommandReply::kTaken) ++tally_.replies_taken;
    if (reply.reply == CommandReply::kTooLate) ++tally_.replies_too_late;
    replies_.send(instant, command.agent, reply);
  });
}

Status FleetLoop::guide() {
  const std::int64_t now = instants(tick_);
  reports_.deliver(now, [&](const AgentReport& report) {
    if (!guide_->take(report)) ++tally_.refused_messages;
  });
  replies_.deliver(now, [&](const Acknowledgement& reply) {
    if (!guide_->take(reply)) ++tally_.refused_messages;
  });
  tell_intruders();
  const auto begin = std::chrono::steady_clock::now();
  Status guided = guide_->step(tick_, guidance_);
  tally_.guiding_s +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!guided) return guided;
  tally_.guided += guidance_.agents.size();
  tally_.commands += guidance_.commands.size();
  for (const Command& command : guidance_.commands) {
    commands_.send(now, static_cast<std::size_t>(command.agent), command);
  }
  look_at_guidance();
  return std::monostate{};
}

void FleetLoop::tell_intruders() {
  if (intruders_.empty()) return;
  std::vector<Intruder> told;
  for (const IntruderFlight& flight : intruders_) {
    const Vector3 error = uniform_in_ball(random_, options_.planar) * options_.intruder_error_m;
    told.push_back({.mover = {point_of(flight.position + error), velocity_of(flight.velocity)},
                    .position_error_m = options_.intruder_error_m});
  }
  if (!guide_->set_intruders(told)) ++tally_.refused_messages;
}

void FleetLoop::fall_silent() {
  for (std::size_t index = 0; index < agents_.size(); ++index) {
    FleetAgent& agent = agents_[index];
    if (!agent.falls_silent_s || time_s() < *agent.falls_silent_s || agent.silent) continue;
    if (!options_.silent_are_told) {
      agent.silent = true;
    } else if (agent.truth) {
      const Status told = guide_->set_preferred(index, {});
      if (!told) ++tally_.refused_messages;
    }
  }
}

Status FleetLoop::step() {
  if (Status joined = join_more(); !joined) return joined;
  fall_silent();
  hear_and_report(instants(tick_));
  if (Status guided = guide(); !guided) return guided;
  fly();
  if (Status judged = judge(time_s()); !judged) return judged;
  ++tick_;
  return std::monostate{};
}

void FleetLoop::fly() {
  const auto each = static_cast<std::size_t>(options_.instants);
  const double instant_s = options_.link.period_s / options_.instants;
  std::vector<Vector3> places;
  for (const IntruderFlight& flight : intruders_) places.push_back(flight.position);
  for (const std::size_t index : joined_) places.push_back(agents_[index].truth->position());
  const bool adversarial = options_.errors.disturbance.kind == ErrorKind::kAdversarial;
  towards_.assign(places.size(), {});
  if (adversarial) towards_ = nearest_.find(places);
  stretches_.resize(places.size() * each);
  for (std::size_t k = 0; k < each; ++k) {
    if (k > 0) hear_and_report(instants(tick_) + static_cast<std::int64_t>(k));
    std::size_t body = 0;
    for (IntruderFlight& flight : intruders_) {
      stretches_[each * body++ + k] = {flight.position, flight.velocity, {}};
      flight.position += flight.velocity * instant_s;
    }
    for (const std::size_t index : joined_) {
      TrueAgent& truth = *agents_[index].truth;
      truth.fly(towards_[body]);
      stretches_[each * body++ + k] = truth.stretch();
    }
  }
}

// Who has left its tube without a reason has lost nothing by its own fault.
bool FleetLoop::is_at_fault(const FleetAgent& agent) const {
  return agent.weak && (agent.left_tube_s || agent.named_s);
}

Status FleetLoop::judge(double begins_s) {
  for (const std::size_t index : joined_) {
    FleetAgent& agent = agents_[index];
    const double deviation_m = agent.truth->deviation_m();
    if (!agent.weak) {
      tally_.largest_deviation_m = std::max(tally_.largest_deviation_m, deviation_m);
    }
    if (!agent.left_tube_s && deviation_m > agent.tube_m) agent.left_tube_s = begins_s;
  }
  judge_pairs(begins_s);
  return judge_clearance();
}

void FleetLoop::judge_pairs(double begins_s) {
  radii_m_.assign(intruders_.size(), 0.0);
  for (const std::size_t index : joined_) radii_m_.push_back(agents_[index].radius_m);
  for (const TrueLoss& loss : checker_.look(begins_s, stretches_, radii_m_)) {
    if (loss.first < intruders_.size()) {
      ++tally_.losses_to_intruders;
      continue;
    }
    const FleetAgent& first = agents_[joined_[loss.first - intruders_.size()]];
    const FleetAgent& second = agents_[joined_[loss.second - intruders_.size()]];
    ++(is_at_fault(first) || is_at_fault(second) ? tally_.losses_out : tally_.losses);
  }
}

Status FleetLoop::judge_clearance() {
  const auto each = static_cast<std::size_t>(options_.instants);
  const auto flown = std::span<const Stretch>(stretches_).subspan(intruders_.size() * each);
  const auto lost = clearance_.look(instants(tick_), flown, each);
  if (!lost) return lost.error();
  for (const std::size_t agent : *lost) {
    const bool out = is_at_fault(agents_[joined_[agent]]);
    ++(out ? tally_.clearance_losses_out : tally_.clearance_losses);
  }
  return std::monostate{};
}

void FleetLoop::look_at_guidance() {
  for (const AgentGuidance& told : guidance_.agents) look_at_agent(told);
}

void FleetLoop::look_at_agent(const AgentGuidance& told) {
  FleetAgent& agent = agents_[told.agent];
  if (!told.certified) ++tally_.uncertified;
  const Point& goal = mission_.goals[told.agent];
  if (!agent.arrived_s &&
      length_of(vector_of(told.nominal.position) - vector_of(goal)) <= options_.arrived_m) {
    agent.arrived_s = time_s();
    ++arrived_;
  }
  const bool sound = !agent.weak && !agent.silent;
  if (told.contract == Contract::kDoubted && sound && !std::exchange(agent.doubted, true)) {
    ++tally_.doubted;
  }
  if (told.contract != Contract::kOut || agent.named_s) return;
  agent.named_s = time_s();
  agent.reason = told.reason;
  ++tally_.named;
  if (sound) ++tally_.false_namings;
}

}  // namespace beespace::sim
