#include "cli/follow/following.hpp"

#include "io/bytes/durable_file.hpp"
#include "io/bytes/number_text.hpp"
#include "io/fleet/fleet_reader.hpp"
#include "io/fleet/fleet_writer.hpp"

#include <utility>
#include <variant>

namespace beespace::cli {
namespace {

// Of a process with one agent, and of all that is read.
constexpr AgentId kSelf = 0;
// An agent that is not in the fleet asks again after so many ticks.
constexpr Tick kAskEvery = 10;

}  // namespace

Result<Following> Following::begin(const FollowRequest& request) {
  auto follower = Follower::make(kSelf, request.planned, request.period_s);
  if (!follower) return std::move(follower).error();
  Following following(request, *follower);
  if (!request.store.empty()) {
    auto lock = io::FileLock::take(request.store, "'beespace follow'");
    if (!lock) return std::move(lock).error();
    following.lock_ = *std::move(lock);
  }
  if (Status loaded = following.load(); !loaded) return std::move(loaded).error();
  return following;
}

// What is stored is an "adopt" message: what a planner that is started anew is told.
Status Following::load() {
  if (request_.store.empty()) return std::monostate{};
  const auto text = io::read_small_file(request_.store, io::FleetReader::kLongest);
  if (!text) return text.error();
  if (!*text) return std::monostate{};
  io::FleetReader reader({}, request_.store);
  const auto message = reader.take(**text);
  const auto* const adopt =
      message && *message ? std::get_if<io::AdoptMessage>(&(**message).content) : nullptr;
  if (adopt == nullptr || (**message).id != request_.agent) {
    return Error{ErrorCode::kMalformedRecord,
                 "this file is damaged, or not what agent '" + request_.agent +
                     "' stored; land it, remove the file, and let it join anew",
                 {.source = request_.store}};
  }
  if (adopt->period_s != request_.period_s ||
      adopt->braking_mps2 != request_.planned.max_acceleration_mps2) {
    return Error{ErrorCode::kInvalidArgument,
                 "what this agent stored was planned with ticks of " + io::exact(adopt->period_s) +
                     " s and braking of " + io::exact(adopt->braking_mps2) +
                     " m/s^2; give the same again (--period, --planned-acceleration), or land it "
                     "and remove the file",
                 {.source = request_.store}};
  }
  if (follower_.restore(adopt->stored)) return std::monostate{};
  return Error{ErrorCode::kMalformedRecord,
               "agent '" + request_.agent +
                   "' cannot be on the branch in this file with its --planned-speed of " +
                   io::exact(request_.planned.max_speed_mps) +
                   " m/s: give the same as before; or where the file is damaged, land it, remove "
                   "the file, and let it join anew",
               {.source = request_.store}};
}

io::AdoptMessage Following::to_be_adopted() const {
  io::AdoptMessage adopt;
  adopt.request.radius_m = request_.radius_m;
  adopt.stored = follower_.stored();
  adopt.period_s = request_.period_s;
  adopt.braking_mps2 = request_.planned.max_acceleration_mps2;
  return adopt;
}

Status Following::store() const {
  if (request_.store.empty()) return std::monostate{};
  std::string text;
  say(text, to_be_adopted());
  return io::write_durably(request_.store, text);
}

void Following::say(std::string& out, const io::FleetContent& content) const {
  io::append_message(out, request_.agent, content);
}

Status Following::advance(Tick tick, std::string& out) {
  follower_.advance(tick);
  if (follower_.held() == 0) {
    if (!asked_at_ || tick >= *asked_at_ + kAskEvery) {
      ask_to_join(out);
      asked_at_ = tick;
    }
  } else if (request_.simulated && static_cast<std::uint64_t>(tick) % request_.report_every == 0) {
    report(out);
  }
  if (request_.setpoints) tell_setpoint(out);
  return std::monostate{};
}

// Where it stands: as measured, or as it was told.
void Following::ask_to_join(std::string& out) {
  if (!asks_for_) asks_for_ = at_ ? at_ : request_.start;
  if (!asks_for_) return;
  io::JoinMessage join;
  join.tick = follower_.tick();
  join.request.position = *asks_for_;
  join.request.radius_m = request_.radius_m;
  join.request.promised = follower_.stored().promised;
  say(out, join);
}

void Following::report(std::string& out) const {
  const Setpoint now = follower_.setpoint(0.0);
  AgentReport report;
  report.held = follower_.held();
  report.tick = follower_.tick();
  report.position = now.nominal.position;
  say(out, report);
}

void Following::tell_setpoint(std::string& out) const {
  const Setpoint now = follower_.setpoint(0.0);
  {
    io::JsonWriter json(out);
    json.begin_object().member("event", "setpoint").member("id", request_.agent);
    io::write_tick(json, "tick", follower_.tick());
    const bool flies = follower_.held() != 0;
    json.member("held", io::known_if(flies, io::branch_text(follower_.held())));
    if (flies) {
      io::write_vector(json, "position", now.nominal.position);
      io::write_vector(json, "velocity", now.nominal.velocity);
      io::write_vector(json, "correction", now.correction);
      json.member("holding", now.holding);
    }
    json.end();
  }
  out += '\n';
}

Status Following::take(const io::FleetMessage& message, std::string& out) {
  if (const auto* command = std::get_if<io::CommandMessage>(&message.content)) {
    return take_command(*command, out);
  }
  if (const auto* hello = std::get_if<io::HelloMessage>(&message.content)) {
    return take_hello(*hello, out);
  }
  if (const auto* measured = std::get_if<io::MeasuredMessage>(&message.content)) {
    take_measured(*measured, out);
  } else if (std::holds_alternative<io::LoseMessage>(message.content)) {
    follower_.lose();
    return store();
  }
  return std::monostate{};
}

// Both sides must compute the same fallback.
bool Following::fits(const io::CommandMessage& message) {
  const double braking_mps2 = request_.planned.max_acceleration_mps2;
  if (message.period_s == request_.period_s && message.braking_mps2 == braking_mps2) return true;
  if (!warned_) {
    warning_ = "the planner plans with ticks of " + io::exact(message.period_s) +
               " s and brakes with " + io::exact(message.braking_mps2) +
               " m/s^2, and this agent has " + io::exact(request_.period_s) + " s and " +
               io::exact(braking_mps2) +
               " m/s^2: it takes no command; give both the same (--period, "
               "--planned-acceleration)";
    warned_ = true;
  }
  return false;
}

Status Following::take_command(const io::CommandMessage& message, std::string& out) {
  Acknowledgement ack;
  if (fits(message)) {
    ack = follower_.receive(message.command);
  } else {
    ack = {kSelf, message.command.number, CommandReply::kInvalid, follower_.held(),
           follower_.tick()};
  }
  if (ack.reply == CommandReply::kTaken) {
    if (Status stored = store(); !stored) return stored;
    asks_for_.reset();
    ++taken_;
  } else {
    ++refused_;
  }
  say(out, ack);
  return std::monostate{};
}

Status Following::take_hello(const io::HelloMessage& message, std::string& out) {
  const std::uint32_t before = follower_.stored().promised;
  if (!follower_.promise(message.epoch)) return std::monostate{};
  if (before != message.epoch) {
    if (Status stored = store(); !stored) return stored;
  }
  if (follower_.held() == 0) {
    ask_to_join(out);
    return std::monostate{};
  }
  say(out, to_be_adopted());
  return std::monostate{};
}

void Following::take_measured(const io::MeasuredMessage& measured, std::string& out) {
  at_ = measured.position;
  if (request_.simulated || follower_.held() == 0) return;
  AgentReport report;
  report.held = follower_.held();
  report.tick = measured.tick.value_or(follower_.tick());
  report.after_s = measured.after_s;
  report.position = measured.position;
  report.velocity = measured.velocity;
  say(out, report);
}

std::string Following::take_warning() {
  return std::exchange(warning_, {});
}

}  // namespace beespace::cli
