#include "c/guide/messages.hpp"

#include "c/door/agents.hpp"
#include "c/door/door.hpp"
#include "c/door/points.hpp"
#include "c/door/structs.hpp"

#include <algorithm>
#include <cstddef>

namespace beespace::c {

static_assert(BEESPACE_MOST_STATES == Command::kMostStates);
static_assert(BEESPACE_MOST_ANCESTORS == Command::kMostAncestors);
static_assert(sizeof(beespace_stored_branch) <= kLargestStruct);

namespace {

// C++ may number its replies anew; C may not.
std::int32_t c_reply_of(CommandReply reply) {
  switch (reply) {
    case CommandReply::kTaken:
      return BEESPACE_REPLY_TAKEN;
    case CommandReply::kOlder:
      return BEESPACE_REPLY_OLDER;
    case CommandReply::kTooLate:
      return BEESPACE_REPLY_TOO_LATE;
    case CommandReply::kTooEarly:
      return BEESPACE_REPLY_TOO_EARLY;
    case CommandReply::kNoAncestor:
      return BEESPACE_REPLY_NO_ANCESTOR;
    case CommandReply::kNoBranch:
      return BEESPACE_REPLY_NO_BRANCH;
    case CommandReply::kInvalid:
      return BEESPACE_REPLY_INVALID;
  }
  return BEESPACE_REPLY_INVALID;
}

constexpr CommandReply kReplies[] = {CommandReply::kTaken,      CommandReply::kOlder,
                                     CommandReply::kTooLate,    CommandReply::kTooEarly,
                                     CommandReply::kNoAncestor, CommandReply::kNoBranch,
                                     CommandReply::kInvalid};

// A count that cannot be is one of C++ that cannot be either.
std::uint32_t count_of(std::int32_t count) {
  return static_cast<std::uint32_t>(count);
}

}  // namespace

Result<FleetFigures> figures_of(const beespace_fleet_figures* figures) {
  if (figures == nullptr) return FleetFigures();
  const Result<beespace_fleet_figures> given = read_struct(figures, "figures");
  if (!given) return given.error();
  if (given->loop != BEESPACE_LOOP_ONBOARD && given->loop != BEESPACE_LOOP_GROUND) {
    return invalid("loop is neither BEESPACE_LOOP_ONBOARD nor BEESPACE_LOOP_GROUND", "figures");
  }
  FleetFigures all;
  all.loop = given->loop == BEESPACE_LOOP_GROUND ? LoopPlace::kGround : LoopPlace::kOnboard;
  all.report_error_m = given->report_error_m;
  all.report_age_s = given->report_age_s;
  all.sensing_error_m = given->sensing_error_m;
  all.loop_period_s = given->loop_period_s;
  all.loop_delay_s = given->loop_delay_s;
  all.deviation_mps = given->deviation_mps;
  all.clock_error_s = given->clock_error_s;
  all.correction_mps2 = given->correction_mps2;
  all.correction_mps = given->correction_mps;
  return all;
}

Result<LinkFigures> link_of(const beespace_link_figures* link) {
  LinkFigures all;
  if (link == nullptr) return all;
  const Result<beespace_link_figures> given = read_struct(link, "link");
  if (!given) return given.error();
  if (given->period_s != 0.0) all.period_s = given->period_s;
  if (given->command_delay != 0) all.command_delay = given->command_delay;
  all.longest_loss = given->longest_loss;
  return all;
}

Result<Command> command_of(const beespace_command* command, const char* name) {
  const Result<beespace_command> given = read_struct(command, name);
  if (!given) return given.error();
  Command all;
  all.agent = agent_id_of(given->agent);
  all.number = given->number;
  all.starts = given->starts;
  all.state_count = count_of(given->state_count);
  all.ancestor_count = count_of(given->ancestor_count);
  for (std::size_t i = 0; i < Command::kMostStates; ++i) {
    const beespace_branch_state& state = given->states[i];
    all.states[i] = {{point_of(state.position), velocity_of(state.velocity)},
                     velocity_of(state.correction)};
  }
  for (std::size_t i = 0; i < Command::kMostAncestors; ++i) {
    all.ancestors[i] = {given->ancestors[i].number, given->ancestors[i].departs};
  }
  return all;
}

// What does not count is zero.
beespace_command c_command_of(const Command& command) {
  beespace_command all{};
  all.struct_size = sizeof all;
  if (command.number == 0) return all;  // no branch
  all.agent = agent_number_of(command.agent);
  all.number = command.number;
  all.starts = command.starts;
  all.state_count = static_cast<std::int32_t>(command.state_count);
  all.ancestor_count = static_cast<std::int32_t>(command.ancestor_count);
  for (std::size_t i = 0; i < std::min<std::size_t>(command.state_count, Command::kMostStates);
       ++i) {
    const BranchState& state = command.states[i];
    write_three(state.nominal.position, all.states[i].position);
    write_three(state.nominal.velocity, all.states[i].velocity);
    write_three(state.correction, all.states[i].correction);
  }
  for (std::size_t i = 0;
       i < std::min<std::size_t>(command.ancestor_count, Command::kMostAncestors); ++i) {
    all.ancestors[i] = {command.ancestors[i].number, command.ancestors[i].departs};
  }
  return all;
}

Result<Acknowledgement> acknowledgement_of(const beespace_acknowledgement* acknowledgement) {
  const Result<beespace_acknowledgement> given = read_struct(acknowledgement, "acknowledgement");
  if (!given) return given.error();
  if (given->reply < BEESPACE_REPLY_TAKEN || given->reply > BEESPACE_REPLY_INVALID) {
    return invalid("reply is none of BEESPACE_REPLY_TAKEN, ...", "acknowledgement");
  }
  return Acknowledgement{agent_id_of(given->agent), given->number,
                         kReplies[given->reply - BEESPACE_REPLY_TAKEN], given->held, given->tick};
}

beespace_acknowledgement c_acknowledgement_of(const Acknowledgement& acknowledgement) {
  beespace_acknowledgement all{};
  all.struct_size = sizeof all;
  all.reply = c_reply_of(acknowledgement.reply);
  all.agent = agent_number_of(acknowledgement.agent);
  all.number = acknowledgement.number;
  all.held = acknowledgement.held;
  all.tick = acknowledgement.tick;
  return all;
}

Result<AgentReport> report_of(const beespace_agent_report* report) {
  const Result<beespace_agent_report> given = read_struct(report, "report");
  if (!given) return given.error();
  if ((given->flags & ~static_cast<std::uint32_t>(BEESPACE_WITH_VELOCITY)) != 0) {
    return invalid("flags are none that a report has", "report");
  }
  const bool has_velocity = (given->flags & BEESPACE_WITH_VELOCITY) != 0;
  const auto is_given = [](double number) { return number != 0.0; };
  if (!has_velocity && std::any_of(given->velocity, given->velocity + 3, is_given)) {
    return invalid("there is a velocity without its flag, BEESPACE_WITH_VELOCITY", "report");
  }
  AgentReport all;
  all.agent = agent_id_of(given->agent);
  all.held = given->held;
  all.tick = given->tick;
  all.after_s = given->after_s;
  all.position = point_of(given->position);
  if (has_velocity) all.velocity = velocity_of(given->velocity);
  return all;
}

Result<StoredBranch> stored_of(const beespace_stored_branch* stored) {
  const Result<beespace_stored_branch> given = read_struct(stored, "stored");
  if (!given) return given.error();
  const Result<Command> branch = command_of(&given->branch, "stored");
  if (!branch) return branch.error();
  return StoredBranch{*branch, given->promised, given->tick};
}

beespace_stored_branch c_stored_of(const StoredBranch& stored) {
  beespace_stored_branch all{};
  all.struct_size = sizeof all;
  all.promised = stored.promised;
  all.tick = stored.tick;
  all.branch = c_command_of(stored.branch);
  return all;
}

}  // namespace beespace::c
