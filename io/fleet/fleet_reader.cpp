#include "io/fleet/fleet_reader.hpp"

#include "io/fleet/read_branch.hpp"
#include "io/problems/excerpt.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace beespace::io {
namespace {

using ReadContent = FleetContent (*)(FleetFields&);

FleetContent read_leave(FleetFields& /*fields*/) {
  return LeaveMessage{};
}
FleetContent read_lose(FleetFields& /*fields*/) {
  return LoseMessage{};
}
FleetContent read_goal(FleetFields& fields) {
  return GoalMessage{fields.point("position")};
}
FleetContent read_tick(FleetFields& fields) {
  return TickMessage{fields.tick("tick")};
}
FleetContent read_hello(FleetFields& fields) {
  return HelloMessage{fields.whole("epoch")};
}

FleetContent read_preferred(FleetFields& fields) {
  const Point v = fields.point("velocity");
  return PreferredMessage{{v.x, v.y, v.z}};
}

FleetContent read_report(FleetFields& fields) {
  AgentReport report;
  report.held = fields.branch_or_none("held");
  report.tick = fields.tick("tick");
  report.after_s = fields.from_zero_or("after_s", 0.0);
  report.position = fields.point("position");
  report.velocity = fields.velocity_if("velocity");
  return report;
}

FleetContent read_ack(FleetFields& fields) {
  Acknowledgement ack;
  ack.number = fields.branch("number");
  ack.held = fields.branch_or_none("held");
  ack.tick = fields.tick("tick");
  const std::string_view word = fields.text("reply");
  const auto reply = parse_reply(word);
  if (!reply && !word.empty()) {
    fields.fail(ErrorCode::kMalformedRecord,
                excerpt(word) +
                    " is no reply; known are taken, older, too_late, too_early, "
                    "no_ancestor, no_branch, invalid");
  }
  ack.reply = reply.value_or(CommandReply::kInvalid);
  return ack;
}

FleetContent read_measured(FleetFields& fields) {
  MeasuredMessage measured;
  measured.tick = fields.tick_if("tick");
  measured.after_s = fields.from_zero_or("after_s", 0.0);
  measured.position = fields.point("position");
  measured.velocity = fields.velocity_if("velocity");
  return measured;
}

FleetContent read_expect(FleetFields& fields) {
  constexpr std::size_t kMost = 20'000;
  ExpectMessage expect;
  const auto ids = fields.array("ids", kMost);
  if (!ids) return expect;
  for (const JsonElement element : *ids) {
    std::string id;
    if (!read_fleet_id(element, id)) {
      fields.fail(ErrorCode::kMalformedRecord,
                  fields.name("ids") +
                      " holds what is no id; give texts of at most 64 bytes, or "
                      "whole numbers");
      break;
    }
    expect.ids.push_back(std::move(id));
  }
  return expect;
}

FleetContent read_intruders(FleetFields& fields) {
  constexpr std::size_t kMost = 2'000;
  IntrudersMessage message;
  const auto intruders = fields.array("intruders", kMost);
  if (!intruders) return message;
  for (const JsonElement element : *intruders) {
    FleetFields own(element, "an intruder");
    Intruder intruder;
    intruder.mover.position = own.point("position");
    intruder.mover.velocity = own.velocity_if("velocity").value_or(Velocity{});
    intruder.radius_m = own.from_zero_or("radius_m", 0.0);
    intruder.position_error_m = own.from_zero_or("position_error_m", 0.0);
    intruder.speed_error_mps = own.from_zero_or("speed_error_mps", 0.0);
    if (auto error = own.error()) {
      fields.fail(*std::move(error));
      break;
    }
    message.intruders.push_back(intruder);
  }
  return message;
}

std::vector<std::size_t> read_indices(FleetFields& fields, std::string_view key) {
  constexpr std::size_t kMost = 20'000;
  std::vector<std::size_t> found;
  const auto items = fields.array(key, kMost);
  if (!items) return found;
  for (const JsonElement item : *items) {
    std::uint64_t index = 0;
    if (!item.get(index)) {
      fields.fail(ErrorCode::kNotANumber, fields.name(key) + " holds what is no index; correct it");
      break;
    }
    found.push_back(index);
  }
  return found;
}

FleetContent read_joined(FleetFields& fields) {
  JoinedMessage message;
  message.joined = fields.flag("joined");
  message.tube_m = fields.from_zero("tube_m");
  constexpr std::size_t kMost = 20'000;
  if (const auto touches = fields.array("touches", kMost)) {
    for (const JsonElement element : *touches) {
      std::string id;
      if (!read_fleet_id(element, id)) {
        fields.fail(ErrorCode::kMalformedRecord,
                    fields.name("touches") + " holds what is no id; correct it");
        break;
      }
      message.touches.push_back(std::move(id));
    }
  }
  message.obstacles = read_indices(fields, "obstacles");
  message.fences = read_indices(fields, "fences");
  return message;
}

FleetContent read_command(FleetFields& fields) {
  CommandMessage message;
  read_branch(fields, message.command);
  message.period_s = fields.from_zero("period_s");
  message.braking_mps2 = fields.from_zero("braking_mps2");
  return message;
}

enum class Id : std::uint8_t { kNone, kMayHave, kNeeded };

struct Kind {
  std::string_view event;
  std::string_view what;
  Id id;
  ReadContent read;  // null: it needs the defaults
};

constexpr std::array<Kind, 16> kKinds = {
    {{"report", "a report", Id::kNeeded, read_report},
     {"ack", "an acknowledgement", Id::kNeeded, read_ack},
     {"command", "a command", Id::kNeeded, read_command},
     {"tick", "a tick", Id::kNone, read_tick},
     {"goal", "a goal", Id::kNeeded, read_goal},
     {"preferred", "a preferred velocity", Id::kNeeded, read_preferred},
     {"join", "a join", Id::kNeeded, nullptr},
     {"may_join", "a question whether to join", Id::kNeeded, nullptr},
     {"leave", "a leave", Id::kNeeded, read_leave},
     {"adopt", "an adopt", Id::kNeeded, nullptr},
     {"expect", "an expect", Id::kNone, read_expect},
     {"intruders", "a list of intruders", Id::kNone, read_intruders},
     {"hello", "a hello", Id::kMayHave, read_hello},
     {"joined", "an answer to a join", Id::kNeeded, read_joined},
     {"measured", "a measurement", Id::kNeeded, read_measured},
     {"lose", "a lose", Id::kNeeded, read_lose}}};

// What a planner or an agent writes for others to read.
constexpr std::array<std::string_view, 9> kTold = {
    "status",   "ticked",  "pair", "near_obstacle", "near_fence", "intruder_conflict",
    "setpoint", "refused", "guide"};

std::string known_events() {
  std::string list;
  for (const Kind& kind : kKinds) list.append(list.empty() ? "" : ", ").append(kind.event);
  return list;
}

}  // namespace

FleetReader::FleetReader(Defaults defaults, std::string source, std::string only)
    : defaults_(defaults), source_(std::move(source)), only_(std::move(only)) {
}

Result<std::optional<FleetMessage>> FleetReader::take(std::string_view line) {
  ++lines_;
  bad_id_.clear();
  id_.clear();
  event_.clear();
  bad_intruders_ = false;
  auto read = this->read(line);
  if (read) return read;
  bad_id_ = id_;
  bad_intruders_ =
      event_.empty() ? line.find("\"intruders\"") != std::string_view::npos : event_ == "intruders";
  Error error = std::move(read).error();
  error.location.source = source_;
  error.location.line = lines_;
  return error;
}

Result<std::optional<FleetMessage>> FleetReader::read(std::string_view line) {
  const auto read = events_.read(line);
  if (!read) return read.error();
  if (!*read) return std::optional<FleetMessage>();
  const auto& [root, word] = **read;
  if (word.empty()) {
    return Error{ErrorCode::kMissingColumn,
                 "this object has no 'event' that says what it is; known are " + known_events(),
                 {}};
  }
  event_ = word;
  if (std::find(kTold.begin(), kTold.end(), word) != kTold.end()) {
    return std::optional<FleetMessage>(FleetMessage{});
  }
  auto message = read_content(root, word);
  if (!message) return std::move(message).error();
  if (!only_.empty() && !message->id.empty() && message->id != only_) {
    return std::optional<FleetMessage>();
  }
  return std::optional<FleetMessage>(std::move(message).value());
}

std::optional<Error> FleetReader::read_id(FleetFields& fields, bool needed, std::string_view& id) {
  const auto element = needed ? fields.need("id") : fields.find("id");
  if (!element) return needed ? fields.error() : std::nullopt;
  if (!read_fleet_id(*element, id_)) {
    id_.clear();
    return Error{ErrorCode::kMalformedRecord,
                 fields.name("id") + " is no id; give a text of 1 to 64 bytes, or a whole number",
                 {}};
  }
  id = id_;
  return std::nullopt;
}

Result<FleetMessage> FleetReader::read_content(JsonElement object, std::string_view event) {
  const auto* const kind = std::find_if(kKinds.begin(), kKinds.end(),
                                        [&](const Kind& one) { return one.event == event; });
  if (kind == kKinds.end()) {
    return Error{ErrorCode::kUnsupportedFormat,
                 excerpt(event) + " is no event of a fleet; known are " + known_events(),
                 {}};
  }
  FleetFields fields(object, kind->what);
  fields.find("event");
  FleetMessage message;
  if (kind->id != Id::kNone) {
    const bool needed = kind->id == Id::kNeeded;
    if (auto error = read_id(fields, needed, message.id)) return *std::move(error);
  }
  if (!only_.empty() && !message.id.empty() && message.id != only_) return message;
  if (kind->read != nullptr) {
    message.content = kind->read(fields);
  } else if (event == "adopt") {
    message.content = read_adopt(fields);
  } else {
    message.content = read_join(fields, event == "may_join");
  }
  if (auto error = fields.error()) return *std::move(error);
  return message;
}

void FleetReader::read_request(FleetFields& fields, JoinRequest& request) const {
  request.radius_m = fields.from_zero_or("radius_m", 0.0);
  if (const auto figures = fields.find("figures")) {
    FleetFields own(*figures, "the figures of an agent");
    request.figures = read_figures(own, defaults_.figures);
    if (auto error = own.error()) fields.fail(*std::move(error));
  }
  if (const auto limits = fields.find("limits")) {
    FleetFields own(*limits, "the limits of an agent");
    const FlightLimits& other = defaults_.limits;
    request.limits = {own.from_zero_or("max_speed_mps", other.max_speed_mps),
                      own.from_zero_or("max_acceleration_mps2", other.max_acceleration_mps2)};
    if (auto error = own.error()) fields.fail(*std::move(error));
  }
}

FleetContent FleetReader::read_join(FleetFields& fields, bool only_asks) const {
  JoinMessage join;
  join.only_asks = only_asks;
  join.request.position = fields.point("position");
  join.tick = fields.tick_if("tick");
  if (fields.find("promised")) join.request.promised = fields.whole("promised");
  read_request(fields, join.request);
  return join;
}

FleetContent FleetReader::read_adopt(FleetFields& fields) const {
  AdoptMessage adopt;
  read_request(fields, adopt.request);
  adopt.period_s = fields.from_zero("period_s");
  adopt.braking_mps2 = fields.from_zero("braking_mps2");
  const auto stored = fields.need("stored");
  if (!stored) return adopt;
  FleetFields own(*stored, "a stored branch");
  read_stored(own, adopt.stored);
  if (auto error = own.error()) fields.fail(*std::move(error));
  return adopt;
}

}  // namespace beespace::io
