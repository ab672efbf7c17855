#include "io/fleet/fleet_writer.hpp"

#include <algorithm>
#include <array>

namespace beespace::io {
namespace {

void write_branch_number(JsonWriter& json, std::string_view key, BranchNumber number) {
  if (number == 0) {
    json.key(key).null();
  } else {
    json.member(key, branch_text(number));
  }
}

bool is_zero(const Velocity& v) {
  return v.x == 0.0 && v.y == 0.0 && v.z == 0.0;
}

void write_state(JsonWriter& json, const BranchState& state) {
  const Point& p = state.nominal.position;
  const Velocity& v = state.nominal.velocity;
  json.begin_array(JsonLayout::kTight);
  for (const double value : {p.x, p.y, p.z, v.x, v.y, v.z}) json.value(value);
  const Velocity& c = state.correction;
  if (!is_zero(c)) json.value(c.x).value(c.y).value(c.z);
  json.end();
}

// Within an object. Counts beyond the arrays are of no command.
void write_branch(JsonWriter& json, const Command& branch) {
  write_branch_number(json, "number", branch.number);
  write_tick(json, "starts", branch.starts);
  json.begin_array("path", JsonLayout::kTight);
  const std::size_t states = std::min<std::size_t>(branch.state_count, Command::kMostStates);
  for (std::size_t i = 0; i < states; ++i) write_state(json, branch.states[i]);
  json.end();
  json.begin_array("ancestors", JsonLayout::kTight);
  const std::size_t count = std::min<std::size_t>(branch.ancestor_count, Command::kMostAncestors);
  for (std::size_t i = 0; i < count; ++i) {
    json.begin_array().value(branch_text(branch.ancestors[i].number));
    json.value(branch.ancestors[i].departs).end();
  }
  json.end();
}

void write_request(JsonWriter& json, const JoinRequest& request) {
  if (request.radius_m != 0.0) json.member("radius_m", request.radius_m);
  if (request.figures) {
    const FleetFigures& f = *request.figures;
    json.begin_object("figures");
    json.member("loop", f.loop == LoopPlace::kGround ? "ground" : "onboard");
    json.member("report_error_m", f.report_error_m).member("report_age_s", f.report_age_s);
    json.member("sensing_error_m", f.sensing_error_m).member("loop_period_s", f.loop_period_s);
    json.member("loop_delay_s", f.loop_delay_s).member("deviation_mps", f.deviation_mps);
    json.member("clock_error_s", f.clock_error_s).member("correction_mps2", f.correction_mps2);
    json.member("correction_mps", f.correction_mps).end();
  }
  if (request.limits) {
    json.begin_object("limits").member("max_speed_mps", request.limits->max_speed_mps);
    json.member("max_acceleration_mps2", request.limits->max_acceleration_mps2).end();
  }
}

// Writes the members of each kind behind event and id.
class Members {
 public:
  Members(JsonWriter& json, std::string_view id) : json_(json), id_(id) {}

  void operator()(const JoinMessage& message) {
    begin(message.only_asks ? "may_join" : "join");
    write_vector(json_, "position", message.request.position);
    if (message.tick) write_tick(json_, "tick", *message.tick);
    if (message.request.promised != 0) json_.member("promised", message.request.promised);
    write_request(json_, message.request);
  }
  void operator()(const LeaveMessage& /*message*/) { begin("leave"); }
  void operator()(const LoseMessage& /*message*/) { begin("lose"); }
  void operator()(const ToldMessage& /*message*/) { begin("status"); }
  void operator()(const AdoptMessage& message) {
    begin("adopt");
    write_request(json_, message.request);
    json_.member("period_s", message.period_s).member("braking_mps2", message.braking_mps2);
    json_.key("stored");
    write_stored(json_, message.stored);
  }
  void operator()(const ExpectMessage& message) {
    begin("expect");
    json_.member("ids", message.ids);
  }
  void operator()(const GoalMessage& message) {
    begin("goal");
    write_vector(json_, "position", message.position);
  }
  void operator()(const PreferredMessage& message) {
    begin("preferred");
    write_vector(json_, "velocity", message.velocity);
  }
  void operator()(const AgentReport& report) {
    begin("report");
    write_branch_number(json_, "held", report.held);
    write_tick(json_, "tick", report.tick);
    if (report.after_s != 0.0) json_.member("after_s", report.after_s);
    write_vector(json_, "position", report.position);
    if (report.velocity) write_vector(json_, "velocity", *report.velocity);
  }
  void operator()(const Acknowledgement& ack) {
    begin("ack");
    write_branch_number(json_, "number", ack.number);
    json_.member("reply", name_of(ack.reply));
    write_branch_number(json_, "held", ack.held);
    write_tick(json_, "tick", ack.tick);
  }
  void operator()(const IntrudersMessage& message) {
    begin("intruders");
    json_.begin_array("intruders");
    for (const Intruder& intruder : message.intruders) {
      json_.begin_object();
      write_vector(json_, "position", intruder.mover.position);
      write_vector(json_, "velocity", intruder.mover.velocity);
      json_.member("radius_m", intruder.radius_m);
      json_.member("position_error_m", intruder.position_error_m);
      json_.member("speed_error_mps", intruder.speed_error_mps).end();
    }
    json_.end();
  }
  void operator()(const TickMessage& message) {
    begin("tick");
    write_tick(json_, "tick", message.tick);
  }
  void operator()(const CommandMessage& message) {
    begin("command");
    write_branch(json_, message.command);
    json_.member("period_s", message.period_s).member("braking_mps2", message.braking_mps2);
  }
  void operator()(const HelloMessage& message) {
    begin("hello");
    json_.member("epoch", message.epoch);
  }
  void operator()(const JoinedMessage& message) {
    begin("joined");
    json_.member("joined", message.joined).member("tube_m", message.tube_m);
    json_.member("touches", message.touches).member("obstacles", message.obstacles);
    json_.member("fences", message.fences);
  }
  void operator()(const MeasuredMessage& message) {
    begin("measured");
    if (message.tick) write_tick(json_, "tick", *message.tick);
    if (message.after_s != 0.0) json_.member("after_s", message.after_s);
    write_vector(json_, "position", message.position);
    if (message.velocity) write_vector(json_, "velocity", *message.velocity);
  }

 private:
  void begin(std::string_view event) {
    json_.member("event", event);
    if (!id_.empty()) json_.member("id", id_);
  }

  JsonWriter& json_;
  std::string_view id_;
};

}  // namespace

void write_vector(JsonWriter& json, std::string_view key, const Point& point) {
  json.begin_array(key, JsonLayout::kTight);
  json.value(point.x).value(point.y).value(point.z).end();
}

void write_vector(JsonWriter& json, std::string_view key, const Velocity& velocity) {
  write_vector(json, key, Point{velocity.x, velocity.y, velocity.z});
}

void write_tick(JsonWriter& json, std::string_view key, Tick tick) {
  json.member(key, tick);
}

void write_stored(JsonWriter& json, const StoredBranch& stored) {
  json.begin_object().member("promised", stored.promised);
  write_tick(json, "tick", stored.tick);
  json.key("branch");
  if (stored.branch.number == 0) {
    json.null();
  } else {
    json.begin_object();
    write_branch(json, stored.branch);
    json.end();
  }
  json.end();
}

void append_message(std::string& out, std::string_view id, const FleetContent& content) {
  {
    JsonWriter json(out);
    json.begin_object();
    std::visit(Members(json, id), content);
    json.end();
  }
  out += '\n';
}

}  // namespace beespace::io
