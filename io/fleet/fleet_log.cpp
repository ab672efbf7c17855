#include "io/fleet/fleet_log.hpp"

#include "io/bytes/byte_source.hpp"
#include "io/bytes/gzip.hpp"
#include "io/bytes/number_text.hpp"
#include "io/fleet/event_line.hpp"
#include "io/fleet/fleet_fields.hpp"
#include "io/fleet/fleet_message.hpp"
#include "io/fleet/read_branch.hpp"
#include "io/fleet/status_message.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::string_view kHowToWrite =
    "write the log by 'beespace guide --status all', or by 'beespace simulate --fleet-log'";

Error wrong(ErrorCode code, std::string message) {
  return {code, std::move(message), {}};
}

// A period or an acceleration of anything that flies.
bool can_be(double figure) {
  return figure >= 1e-6 && figure <= 1e6;
}

class Reading {
 public:
  explicit Reading(std::string source) { log_.source = std::move(source); }

  Status read(std::string_view content, bool skip_bad) {
    while (!content.empty()) {
      const std::size_t end = std::min(content.find('\n'), content.size());
      ++line_;
      if (Status taken = take(content.substr(0, end)); !taken) {
        if (!skip_bad) return placed(std::move(taken).error());
        ++log_.skipped;
      }
      content.remove_prefix(std::min(end + 1, content.size()));
    }
    return std::monostate{};
  }

  Result<FleetLog> finish() {
    for (const LoggedAgent& agent : log_.agents) {
      has_status_ = has_status_ || !agent.statuses.empty();
      has_branch_ = has_branch_ || !agent.branches.empty();
    }
    if (!has_status_) {
      return nowhere(ErrorCode::kNoPoints,
                     "nothing in this file says where an agent shall be: there is no 'status'; ");
    }
    if (!has_branch_) {
      return nowhere(ErrorCode::kMissingColumn,
                     "there is no 'command' in this log, and so no way to know how long a tick "
                     "is; ");
    }
    if (!tells_each_tick()) {
      return nowhere(ErrorCode::kMissingColumn,
                     "this log tells of agents only when something changes, and so not where each "
                     "shall be when; ");
    }
    return std::move(log_);
  }

 private:
  [[nodiscard]] Error placed(Error error) const {
    error.location.source = log_.source;
    error.location.line = line_;
    return error;
  }
  [[nodiscard]] Error nowhere(ErrorCode code, std::string message) const {
    return {code, message.append(kHowToWrite), {.source = log_.source}};
  }

  Status take(std::string_view line) {
    const auto read = events_.read(line);
    if (!read) return read.error();
    if (!*read) return std::monostate{};
    if ((**read).event.empty()) {
      return wrong(ErrorCode::kMissingColumn,
                   "this object has no 'event' that says what it is; " + std::string(kHowToWrite));
    }
    if ((**read).event == "status") return take_status((**read).object);
    if ((**read).event == "command") return take_command((**read).object);
    if ((**read).event == "ticked") ++ticked_;
    return std::monostate{};
  }

  // Whom a line is about; empty where the line says that wrongly.
  static std::string read_id(FleetFields& fields) {
    fields.find("event");
    std::string id;
    const auto element = fields.need("id");
    if (element && !read_fleet_id(*element, id)) {
      id.clear();
      fields.fail(ErrorCode::kMalformedRecord,
                  fields.name("id") + " is no id; give a text of 1 to 64 bytes, or a whole number");
    }
    return id;
  }

  LoggedAgent& agent_of(const std::string& id) {
    const auto [found, is_new] = numbers_.try_emplace(id, log_.agents.size());
    if (is_new) log_.agents.push_back({id, line_, {}, {}});
    return log_.agents[found->second];
  }

  Status take_status(JsonElement object) {
    FleetFields fields(object, "a status");
    const StatusMessage status = read_status(fields);
    const std::string id = read_id(fields);
    if (auto error = fields.error()) return *std::move(error);
    LoggedAgent& agent = agent_of(id);
    if (!agent.statuses.empty() && status.tick <= agent.statuses.back().tick) {
      return wrong(ErrorCode::kTimeOrder, "tick " + std::to_string(status.tick) + " of agent '" +
                                              agent.id + "' is not after its tick " +
                                              std::to_string(agent.statuses.back().tick) +
                                              "; give the log of one flight, in its order");
    }
    agent.statuses.push_back({status.tick, status.told, agent.branches.size()});
    return std::monostate{};
  }

  Status take_command(JsonElement object) {
    FleetFields fields(object, "a command");
    Command command;
    read_branch(fields, command);
    const double period_s = fields.from_zero("period_s");
    const double braking_mps2 = fields.from_zero("braking_mps2");
    const std::string id = read_id(fields);
    if (auto error = fields.error()) return *std::move(error);
    if (!can_be(period_s) || !can_be(braking_mps2)) {
      return wrong(ErrorCode::kMalformedRecord,
                   "'period_s' and 'braking_mps2' of a command are from 1e-6 to 1e6; correct them");
    }
    if (log_.period_s != 0.0 && period_s != log_.period_s) {
      return wrong(ErrorCode::kMalformedRecord, "ticks of " + exact(period_s) +
                                                    " s follow ticks of " + exact(log_.period_s) +
                                                    " s; give the log of one flight");
    }
    log_.period_s = period_s;
    LoggedAgent& agent = agent_of(id);
    // A root is sent again until it is taken.
    if (!agent.branches.empty() && command.number <= agent.branches.back().number) {
      return std::monostate{};
    }
    LoggedBranch branch{command.number, 0, command.starts, {}, braking_mps2};
    if (command.ancestor_count > 0) branch.parent = command.ancestors.front().number;
    for (const BranchState& state : command.path()) branch.states.push_back(state.nominal);
    agent.branches.push_back(std::move(branch));
    return std::monostate{};
  }

  // Whether any agent is told of in two ticks, one after the other; or there is one tick only.
  [[nodiscard]] bool tells_each_tick() const {
    bool several = ticked_ > 1;
    for (const LoggedAgent& agent : log_.agents) {
      for (std::size_t i = 1; i < agent.statuses.size(); ++i) {
        several = true;
        if (agent.statuses[i].tick == agent.statuses[i - 1].tick + 1) return true;
      }
    }
    return !several;
  }

  FleetLog log_;
  EventLines events_;
  std::unordered_map<std::string, std::size_t> numbers_;
  std::uint64_t line_ = 0;
  std::uint64_t ticked_ = 0;
  bool has_status_ = false;
  bool has_branch_ = false;
};

}  // namespace

Result<FleetLog> read_fleet_log(std::string_view content, std::string source, bool skip_bad) {
  Reading reading(std::move(source));
  if (Status read = reading.read(content, skip_bad); !read) return std::move(read).error();
  return reading.finish();
}

Result<FleetLog> load_fleet_log(const std::string& path, bool skip_bad, Progress* progress) {
  const std::string source = source_name(path);
  auto bytes = open_bytes(path, progress);
  if (!bytes) return std::move(bytes).error();
  const auto content = unpacked(*std::move(bytes), source);
  if (!content) return content.error();
  return read_fleet_log(content->view, source, skip_bad);
}

}  // namespace beespace::io
