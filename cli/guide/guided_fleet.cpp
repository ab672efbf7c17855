#include "cli/guide/guided_fleet.hpp"

#include "io/bytes/number_text.hpp"
#include "io/fleet/fleet_writer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace beespace::cli {
namespace {

// How often agents that must be found are called.
constexpr double kHelloEvery_s = 1.0;

Error refusal(std::string message) {
  return {ErrorCode::kInvalidArgument, std::move(message), {}};
}

// Whether an agent that asks again asks for the same.
bool same(const JoinRequest& a, const JoinRequest& b) {
  return a.position == b.position && a.radius_m == b.radius_m && a.figures == b.figures &&
         a.limits == b.limits;
}

}  // namespace

GuidedFleet::GuidedFleet(const GuideRequest& request, Guide guide, FleetStore store)
    : guide_(std::move(guide)),
      store_(std::move(store)),
      lines_(request.status),
      period_s_(request.options.link.period_s),
      link_(request.options.link),
      figures_(request.options.figures),
      limits_(request.options.limits) {
  for (const auto& [name, member] : store_.members()) expect(name);
}

void GuidedFleet::expect(const std::string& id) {
  if (names_.find(id)) return;
  const AgentId agent = names_.add(id);
  guide_.expect(std::span(&agent, 1));
  const auto stored = store_.members().find(id);
  missing_.emplace(agent, stored == store_.members().end() ? JoinRequest{} : stored->second);
  store_.put(id, missing_.at(agent));
}

Result<AgentId> GuidedFleet::known(std::string_view id) const {
  if (const auto agent = names_.find(id)) return *agent;
  return refusal("agent '" + std::string(id) + "' is not in the fleet; let it join first");
}

// The Guide knows agents by their numbers, and messages by their names.
Error GuidedFleet::in_its_words(Error error, std::string_view id, AgentId agent) {
  error.location.array.clear();
  error.location.record.reset();
  const std::string number = "agent " + std::to_string(agent);
  const std::size_t at = error.message.find(number);
  if (at != std::string::npos) {
    error.message.replace(at, number.size(), "agent '" + std::string(id) + "'");
  }
  return error;
}

Status GuidedFleet::take(const io::FleetMessage& message, std::string& out) {
  const AgentId agent = names_.find(message.id).value_or(names_.next());
  Status taken = std::visit(
      [&](const auto& content) { return take_content(message.id, content, out); }, message.content);
  return taken ? std::move(taken)
               : Status(in_its_words(std::move(taken).error(), message.id, agent));
}

template <class Other>
Status GuidedFleet::take_content(std::string_view /*id*/, const Other& /*message*/,
                                 std::string& /*out*/) {
  return refusal(
      "this message is for agents; 'beespace guide' takes join, may_join, leave, adopt, expect, "
      "goal, preferred, report, ack, intruders and tick");
}

void GuidedFleet::answer(std::string_view id, const JoinAnswer& given, double tube_m,
                         std::string& out) const {
  io::JoinedMessage message;
  message.joined = given.joined;
  message.tube_m = tube_m;
  for (const AgentId agent : given.touches) message.touches.push_back(names_.name(agent));
  message.obstacles = given.obstacles;
  message.fences = given.fences;
  io::append_message(out, id, message);
}

Status GuidedFleet::add(AgentId agent, const JoinRequest& request) {
  const auto tube = guide_.tube(agent);
  if (!tube) return tube.error();
  Member member;
  member.request = request;
  member.planned = tube->planned;
  member.tube_m = tube->radius_m;
  members_.insert_or_assign(agent, member);
  missing_.erase(agent);
  store_.put(names_.name(agent), request);
  return std::monostate{};
}

Status GuidedFleet::take_content(std::string_view id, const io::JoinMessage& message,
                                 std::string& out) {
  const auto before = names_.find(id);
  if (before && members_.contains(*before)) return join_again(id, message, out);
  JoinRequest request = message.request;
  // It may be on a branch of the planner before, and have asked before that.
  if (before && request.promised < store_.epoch()) {
    return refusal("agent '" + std::string(id) +
                   "' is in the fleet, and has not answered the planner "
                   "of this epoch yet; let it answer 'hello', or leave");
  }
  request.agent = before.value_or(names_.next());
  const auto given = message.only_asks ? guide_.may_join(request) : guide_.join(request);
  if (!given) return given.error();
  double tube_m = 0.0;
  if (given->joined) {
    if (!before) names_.add(id);
    if (Status added = add(request.agent, request); !added) return added;
    tube_m = members_.at(request.agent).tube_m;
  }
  answer(id, *given, tube_m, out);
  return std::monostate{};
}

// Its answer may have been lost. Who has been on a branch and asks anew has lost it.
Status GuidedFleet::join_again(std::string_view id, const io::JoinMessage& message,
                               std::string& out) {
  const AgentId agent = *names_.find(id);
  const Member& member = members_.at(agent);
  if (!member.taken && same(member.request, message.request)) {
    answer(id, {.joined = true}, member.tube_m, out);
    return std::monostate{};
  }
  // It asked before it took a branch.
  if (member.taken && message.tick && *message.tick <= *member.taken) return std::monostate{};
  if (member.taken && message.tick && !message.only_asks) {
    AgentReport lost;
    lost.agent = agent;
    lost.position = message.request.position;
    if (Status done = guide_.take(lost); !done) return done;
    return refusal("agent '" + std::string(id) +
                   "' asks to join, and is in the fleet: it has lost its branch, or two have one "
                   "id; make sure where it is, let it leave, and it joins anew");
  }
  return refusal("agent '" + std::string(id) +
                 "' has joined already, with another place or size; "
                 "let it leave first, or give it an id of its own");
}

Status GuidedFleet::take_content(std::string_view id, const io::LeaveMessage& /*message*/,
                                 std::string& /*out*/) {
  const auto agent = known(id);
  if (!agent) return agent.error();
  if (Status left = guide_.leave(*agent); !left) return left;
  members_.erase(*agent);
  missing_.erase(*agent);
  store_.remove(std::string(id));
  lines_.forget(*agent);
  names_.remove(*agent);
  return std::monostate{};
}

// It flies its branch to the end, and stops, with the numbers that it was planned with.
Status GuidedFleet::check_plan(std::string_view id, const JoinRequest& request,
                               const io::AdoptMessage& message) const {
  const auto tube =
      tube_of(request.figures.value_or(figures_), link_, request.limits.value_or(limits_));
  if (!tube) return tube.error();
  const double braking_mps2 = tube->planned.max_acceleration_mps2;
  if (message.period_s == period_s_ && message.braking_mps2 == braking_mps2) {
    return std::monostate{};
  }
  return refusal("agent '" + std::string(id) + "' is on a branch of ticks of " +
                 io::exact(message.period_s) + " s and brakes with " +
                 io::exact(message.braking_mps2) + " m/s^2, and this planner has " +
                 io::exact(period_s_) + " s and " + io::exact(braking_mps2) +
                 " m/s^2; start it with the figures with which the fleet was guided before");
}

Status GuidedFleet::take_content(std::string_view id, const io::AdoptMessage& message,
                                 std::string& out) {
  const auto before = names_.find(id);
  if (before && members_.contains(*before)) return std::monostate{};  // it said so twice
  if (message.stored.branch.number == 0) {
    return refusal("agent '" + std::string(id) + "' is on no branch; let it join");
  }
  // What it was let in with counts.
  JoinRequest request = message.request;
  if (const auto stored = store_.members().find(id); stored != store_.members().end()) {
    request = stored->second;
  }
  request.agent = before.value_or(names_.next());
  StoredBranch stored = message.stored;
  stored.branch.agent = request.agent;
  if (Status fine = check_plan(id, request, message); !fine) return fine;
  if (Status done = guide_.adopt(request, stored); !done) return done;
  if (!before) names_.add(id);
  if (Status added = add(request.agent, request); !added) return added;
  members_.at(request.agent).taken = stored.tick;
  answer(id, {.joined = true}, members_.at(request.agent).tube_m, out);
  return std::monostate{};
}

Status GuidedFleet::take_content(std::string_view /*id*/, const io::ExpectMessage& message,
                                 std::string& /*out*/) {
  for (const std::string& id : message.ids) expect(id);
  return std::monostate{};
}

Status GuidedFleet::take_content(std::string_view id, const io::GoalMessage& message,
                                 std::string& /*out*/) {
  return known(id).and_then(
      [&](AgentId agent) { return guide_.set_goal(agent, message.position); });
}

Status GuidedFleet::take_content(std::string_view id, const io::PreferredMessage& message,
                                 std::string& /*out*/) {
  return known(id).and_then(
      [&](AgentId agent) { return guide_.set_preferred(agent, message.velocity); });
}

Status GuidedFleet::take_content(std::string_view id, const AgentReport& report,
                                 std::string& /*out*/) {
  return known(id).and_then([&](AgentId agent) {
    AgentReport numbered = report;
    numbered.agent = agent;
    return guide_.take(numbered);
  });
}

Status GuidedFleet::take_content(std::string_view id, const Acknowledgement& ack,
                                 std::string& /*out*/) {
  const auto agent = known(id);
  if (!agent) return agent.error();
  Acknowledgement numbered = ack;
  numbered.agent = *agent;
  if (Status done = guide_.take(numbered); !done) return done;
  const bool taken = ack.reply == CommandReply::kTaken;
  ++(taken ? counts_.taken : counts_.refused);
  const auto member = members_.find(*agent);
  if (taken && member != members_.end()) {
    std::optional<Tick>& first = member->second.taken;
    first = std::min(first.value_or(ack.tick), ack.tick);
  }
  return std::monostate{};
}

Status GuidedFleet::take_content(std::string_view /*id*/, const io::IntrudersMessage& message,
                                 std::string& /*out*/) {
  intruders_ = message.intruders;
  intruders_at_.reset();
  return guide_.set_intruders(intruders_);
}

// Those of the last list fly on, and are given way to; what the new one would have said of them is
// not known.
void GuidedFleet::lose_intruders() {
  const double since_s =
      intruders_at_ ? static_cast<double>(stepped_ + 1 - *intruders_at_) * period_s_ : 0.0;
  std::vector<Intruder> all = intruders_;
  for (Intruder& one : all) {
    auto& [p, v] = one.mover;
    p = {p.x + v.x * since_s, p.y + v.y * since_s, p.z + v.z * since_s};
    one.position_error_m += one.speed_error_mps * since_s;
  }
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  all.emplace_back().mover.position = {kNowhere, kNowhere, kNowhere};
  // That it is refused is known.
  static_cast<void>(guide_.set_intruders(all));
}

void GuidedFleet::say_hello(Tick now, std::string& out) {
  const auto every = static_cast<Tick>(std::ceil(kHelloEvery_s / period_s_));
  if (missing_.empty() || (hello_at_ && now < *hello_at_ + every)) return;
  hello_at_ = now;
  for (const auto& [agent, request] : missing_) {
    io::append_message(out, names_.name(agent), io::HelloMessage{store_.epoch()});
  }
}

void GuidedFleet::say_commands(std::string& out) {
  for (const beespace::Command& command : guidance_.commands) {
    const Member& member = members_.at(command.agent);
    io::append_message(
        out, names_.name(command.agent),
        io::CommandMessage{command, period_s_, member.planned.max_acceleration_mps2});
  }
}

Status GuidedFleet::step(Tick now, std::string& out) {
  if (Status done = guide_.step(now, guidance_); !done) return done;
  // Who is in the fleet is on the disk before the first command goes to it.
  if (Status done = store_.write(); !done) return done;
  stepped_ = now;
  if (!intruders_at_) intruders_at_ = now;
  ++counts_.ticks;
  counts_.commands += guidance_.commands.size();
  say_hello(now, out);
  say_commands(out);
  lines_.append(out, guidance_, names_);
  return std::monostate{};
}

}  // namespace beespace::cli
