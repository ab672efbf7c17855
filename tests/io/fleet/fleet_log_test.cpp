// The log of a fleet: what is written of it is read, and what is wrong with it is said with its
// line.
#include "io/fleet/fleet_log.hpp"
#include "io/fleet/fleet_writer.hpp"
#include "io/fleet/status_message.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

std::string status(const std::string& id, Tick tick, const AgentGuidance& told = {}) {
  std::string line;
  append_status(line, id, "none", tick, told);
  return line;
}

std::string command(const std::string& id, std::uint32_t count, Tick starts,
                    std::uint32_t parent = 0, double period_s = 0.1) {
  Command command;
  command.number = branch_number(1, count);
  command.starts = starts;
  command.state_count = 2;
  command.states[0] = {{{1, 2, 3}, {0, 0, 0}}, {}};
  command.states[1] = {{{1, 2, 3.5}, {0, 0, 1}}, {}};
  if (parent != 0) {
    command.ancestor_count = 2;
    command.ancestors[0] = {branch_number(1, parent), starts + 1};
    command.ancestors[1] = {branch_number(1, 99), starts};
  }
  std::string line;
  append_message(line, id, CommandMessage{command, period_s, 4.0});
  return line;
}

std::string flight() {
  return command("7", 1, -1) + status("7", 0) + command("7", 2, 0, 1) + status("7", 1);
}

FleetLog read(const std::string& text, bool skip_bad = false) {
  const auto log = read_fleet_log(text, "fleet.ndjson", skip_bad);
  EXPECT_TRUE(log.has_value()) << to_string(log.error());
  return log ? *log : FleetLog{};
}

// The error as it is told.
std::string error_of(const std::string& text) {
  const auto log = read_fleet_log(text, "fleet.ndjson", false);
  EXPECT_FALSE(log.has_value());
  return log ? "" : to_string(log.error());
}

void expect_error(const std::string& text, const std::string& part) {
  const std::string error = error_of(text);
  EXPECT_NE(error.find(part), std::string::npos) << error;
}

TEST(FleetLog, HasEachStatusAndEachCommandOnce) {
  AgentGuidance told;
  told.contract = Contract::kOut;
  told.reason = ContractReason::kNoBranch;
  told.certified = true;
  told.branches = 3;
  told.nominal = {{0.1, 1.0 / 3.0, -2e-9}, {4, 5, 6}};
  told.tube_m = 0.7;
  told.deviation_m = 0.25;
  const FleetLog log = read(flight() + command("7", 2, 1, 1) + status("7", 2, told));
  EXPECT_EQ(log.period_s, 0.1);
  ASSERT_EQ(log.agents.size(), 1U);
  const LoggedAgent& agent = log.agents.front();
  EXPECT_EQ(agent.id, "7");
  EXPECT_EQ(agent.line, 1U);
  ASSERT_EQ(agent.branches.size(), 2U);  // the third command is the second one, sent again
  EXPECT_EQ(agent.branches[0].parent, 0U);
  EXPECT_EQ(agent.branches[1].parent, branch_number(1, 1));
  EXPECT_EQ(agent.branches[1].starts, 0);
  EXPECT_EQ(agent.branches[1].braking_mps2, 4.0);
  ASSERT_EQ(agent.branches[1].states.size(), 2U);
  EXPECT_EQ(agent.branches[1].states[1], (Mover{{1, 2, 3.5}, {0, 0, 1}}));
  ASSERT_EQ(agent.statuses.size(), 3U);
  EXPECT_EQ(agent.statuses[0].sent, 1U);
  EXPECT_EQ(agent.statuses[1].sent, 2U);
  const LoggedStatus& last = agent.statuses[2];
  EXPECT_EQ(last.tick, 2);
  EXPECT_EQ(last.told.contract, Contract::kOut);
  EXPECT_EQ(last.told.reason, ContractReason::kNoBranch);
  EXPECT_TRUE(last.told.certified);
  EXPECT_EQ(last.told.branches, 3U);
  EXPECT_EQ(last.told.nominal, told.nominal);
  EXPECT_EQ(last.told.tube_m, 0.7);
  EXPECT_EQ(last.told.deviation_m, 0.25);
}

TEST(FleetLog, EachContractAndReasonIsReadAsItIsWritten) {
  for (const Contract contract : {Contract::kKept, Contract::kDoubted, Contract::kOut}) {
    for (int reason = 0; reason <= static_cast<int>(ContractReason::kFuture); ++reason) {
      AgentGuidance told;
      told.contract = contract;
      told.reason = static_cast<ContractReason>(reason);
      const FleetLog log = read(command("7", 1, -1) + status("7", 0, told));
      EXPECT_EQ(log.agents[0].statuses[0].told.contract, contract);
      EXPECT_EQ(log.agents[0].statuses[0].told.reason, told.reason);
    }
  }
}

TEST(FleetLog, WhatElseAPlannerWritesIsPassedOver) {
  const std::string others =
      "{\"event\": \"ticked\", \"tick\": 0, \"agents\": 1}\n\n{\"event\": \"joined\", \"id\": "
      "\"7\"}\r\n{\"event\": \"something new\"}\n";
  const FleetLog log = read(others + flight() + others);
  EXPECT_EQ(log.agents.size(), 1U);
  EXPECT_EQ(log.agents[0].line, 5U);
}

TEST(FleetLog, ALineThatIsWrongIsNamed) {
  expect_error(flight() + "{\"event\": \"status\"", "fleet.ndjson:5");
  expect_error(flight() + "[]\n", "fleet.ndjson:5: this line is an array, not an object");
  expect_error(flight() + "{}\n", "fleet.ndjson:5: this object has no 'event'");
  expect_error(flight() + "{\"event\": \"status\", \"id\": \"7\"}\n", "fleet.ndjson:5");
  std::string odd = status("7", 2);
  odd.replace(odd.find("kept"), 4, "lost");
  expect_error(flight() + odd,
               "fleet.ndjson:5: 'contract' of a status is 'lost'; known are kept, doubted, out");
  odd = status("", 2);
  expect_error(flight() + odd, "fleet.ndjson:5: 'id' of a status is no id");
  expect_error(flight() + status("7", 1),
               "fleet.ndjson:5: tick 1 of agent '7' is not after its tick 1; give the log of one "
               "flight, in its order");
  expect_error(flight() + command("8", 1, 0, 0, 0.2),
               "fleet.ndjson:5: ticks of 0.2 s follow ticks of 0.1 s; give the log of one flight");
  expect_error(flight() + command("7", 3, 0, 0, 0.0), "fleet.ndjson:5: 'period_s' and");
}

TEST(FleetLog, LinesThatAreWrongAreLeftOutWhenAsked) {
  const FleetLog log = read("{\n" + flight() + status("7", 1) + status("8", 1).substr(0, 30), true);
  EXPECT_EQ(log.skipped, 3U);
  ASSERT_EQ(log.agents.size(), 1U);
  EXPECT_EQ(log.agents[0].statuses.size(), 2U);
}

TEST(FleetLog, WhatALogLacksIsSaidWithHowToWriteIt) {
  const std::string how = "write the log by 'beespace guide --status all'";
  for (const std::string& text :
       {std::string(), std::string("{\"event\": \"ticked\"}\n"), command("7", 1, -1)}) {
    expect_error(text, "there is no 'status'; " + how);
  }
  expect_error(status("7", 0) + status("7", 1), "there is no 'command' in this log");
  expect_error(command("7", 1, -1) + status("7", 0) + status("7", 4) + status("7", 9),
               "tells of agents only when something changes");
  const std::string ticked = "{\"event\": \"ticked\", \"tick\": 0}\n";
  expect_error(command("7", 1, -1) + status("7", 0) + ticked + ticked,
               "tells of agents only when something changes");
  EXPECT_EQ(read(command("7", 1, -1) + status("7", 0)).agents.size(), 1U);
}

}  // namespace
}  // namespace beespace::io
