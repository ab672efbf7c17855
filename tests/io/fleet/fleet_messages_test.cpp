// Messages of a fleet: what is written is read as the same, and what is wrong is said.
#include "io/fleet/fleet_reader.hpp"
#include "io/fleet/fleet_writer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace beespace::io {
namespace {

std::string written(std::string_view id, const FleetContent& content) {
  std::string line;
  append_message(line, id, content);
  EXPECT_TRUE(line.ends_with('\n'));
  line.pop_back();
  return line;
}

// What a reader makes of a line that it takes.
template <class Content>
Content read_back(const std::string& line, std::string_view id) {
  FleetReader reader({});
  const auto message = reader.take(line);
  if (!message || !*message) {
    ADD_FAILURE() << line << (message ? "" : message.error().message);
    return {};
  }
  EXPECT_EQ((**message).id, id);
  const auto* const content = std::get_if<Content>(&(**message).content);
  if (content == nullptr) {
    ADD_FAILURE() << line;
    return {};
  }
  return *content;
}

Error error_of(const std::string& line) {
  FleetReader reader({});
  const auto message = reader.take(line);
  if (message) {
    ADD_FAILURE() << line;
    return {};
  }
  EXPECT_EQ(message.error().location.line, 1u);
  EXPECT_EQ(message.error().location.source, "<stdin>");
  return message.error();
}

void expect_error(const std::string& line, ErrorCode code, const std::string& part) {
  const Error error = error_of(line);
  EXPECT_EQ(error.code, code) << line;
  EXPECT_NE(error.message.find(part), std::string::npos) << error.message;
}

Command some_command() {
  Command command;
  command.number = branch_number(3, 17);
  command.starts = -4;
  command.state_count = 3;
  const double third = 1.0 / 3.0;
  command.states[0] = {{{0.1, -0.2, 1e-300}, {third, 5e-324, -third}}, {}};
  command.states[1] = {{{123456.789, 2.0 / 7.0, -1e11}, {1.0, 2.0, 3.0}}, {0.1, 0.0, -0.3}};
  command.states[2] = {{{std::nextafter(1.0, 2.0), 0.0, 0.0}, {}}, {}};
  command.ancestor_count = 2;
  command.ancestors[0] = {branch_number(3, 16), 120};
  command.ancestors[1] = {branch_number(2, 4294967295u), -3};
  return command;
}

void expect_same(const Command& a, const Command& b) {
  EXPECT_EQ(a.number, b.number);
  EXPECT_EQ(a.starts, b.starts);
  EXPECT_TRUE(std::equal(a.path().begin(), a.path().end(), b.path().begin(), b.path().end()));
  const auto before = a.departs_from();
  const auto after = b.departs_from();
  EXPECT_TRUE(std::equal(before.begin(), before.end(), after.begin(), after.end()));
}

TEST(FleetMessages, ACommandIsReadAsTheSameDoubles) {
  const CommandMessage sent{some_command(), 0.1, 3.5};
  const auto read = read_back<CommandMessage>(written("7", sent), "7");
  expect_same(read.command, sent.command);
  EXPECT_EQ(read.period_s, 0.1);
  EXPECT_EQ(read.braking_mps2, 3.5);
}

TEST(FleetMessages, ACommandOfTheMostStatesIsNotTooLong) {
  Command command = some_command();
  command.state_count = Command::kMostStates;
  for (BranchState& state : command.states) {
    state = {{{-1.0 / 3e-5, -2.0 / 3e-5, -1.0 / 7e-5}, {-1.0 / 3e5, -2.0 / 3e5, -1.0 / 7e5}},
             {-1.0 / 3e5, -2.0 / 3e5, -1.0 / 7e5}};
  }
  command.ancestor_count = Command::kMostAncestors;
  for (Ancestor& ancestor : command.ancestors) ancestor = {~BranchNumber{0}, 1234567890123};
  const auto read = read_back<CommandMessage>(written("a", CommandMessage{command, 0.1, 1}), "a");
  expect_same(read.command, command);
}

TEST(FleetMessages, ReportsAndAcknowledgements) {
  AgentReport report;
  report.held = branch_number(1, 2);
  report.tick = 77;
  report.after_s = 0.05;
  report.position = {1.0 / 3.0, 2, 3};
  EXPECT_EQ(read_back<AgentReport>(written("a b", report), "a b"), report);
  report.velocity = Velocity{0, -0.5, 0.25};
  report.held = 0;
  EXPECT_EQ(read_back<AgentReport>(written("a b", report), "a b"), report);
  for (const CommandReply reply :
       {CommandReply::kTaken, CommandReply::kOlder, CommandReply::kTooLate, CommandReply::kTooEarly,
        CommandReply::kNoAncestor, CommandReply::kNoBranch, CommandReply::kInvalid}) {
    const Acknowledgement ack{0, branch_number(1, 9), reply, branch_number(1, 8), -5};
    EXPECT_EQ(read_back<Acknowledgement>(written("7", ack), "7"), ack);
  }
}

TEST(FleetMessages, JoinsWithFiguresOfTheirOwn) {
  JoinMessage join;
  join.request.position = {1, 2, 3};
  join.request.radius_m = 0.75;
  join.request.promised = 4;
  join.request.figures = FleetFigures{.loop = LoopPlace::kGround, .report_error_m = 0.25};
  join.request.limits = FlightLimits{8.0, 4.0};
  const auto read = read_back<JoinMessage>(written("7", join), "7");
  EXPECT_EQ(read.request.position, join.request.position);
  EXPECT_EQ(read.request.radius_m, 0.75);
  EXPECT_EQ(read.request.promised, 4u);
  EXPECT_EQ(read.request.figures, join.request.figures);
  EXPECT_EQ(read.request.limits, join.request.limits);
  EXPECT_FALSE(read.only_asks);
  join.only_asks = true;
  EXPECT_TRUE(read_back<JoinMessage>(written("7", join), "7").only_asks);
}

TEST(FleetMessages, FiguresThatAreAbsentAreThoseOfTheFleet) {
  FleetReader reader({FleetFigures{.deviation_mps = 0.5}, FlightLimits{12.0, 6.0}});
  const auto message = reader.take(
      R"({"event":"join","id":1,"position":[0,0,0],"figures":{"report_error_m":2},"limits":{}})");
  ASSERT_TRUE(message && *message);
  const auto& request = std::get<JoinMessage>((**message).content).request;
  EXPECT_EQ(request.figures, (FleetFigures{.report_error_m = 2.0, .deviation_mps = 0.5}));
  EXPECT_EQ(request.limits, (FlightLimits{12.0, 6.0}));
}

TEST(FleetMessages, WhatIsStoredComesBack) {
  AdoptMessage adopt;
  adopt.request.radius_m = 1.5;
  adopt.period_s = 0.1;
  adopt.braking_mps2 = 3.5;
  adopt.stored = {some_command(), 3, 130};
  const auto read = read_back<AdoptMessage>(written("x", adopt), "x");
  expect_same(read.stored.branch, adopt.stored.branch);
  EXPECT_EQ(read.stored.promised, 3u);
  EXPECT_EQ(read.stored.tick, 130);
  EXPECT_EQ(read.request.radius_m, 1.5);
  EXPECT_EQ(read.period_s, 0.1);
  EXPECT_EQ(read.braking_mps2, 3.5);
  adopt.stored.branch = {};
  EXPECT_EQ(read_back<AdoptMessage>(written("x", adopt), "x").stored.branch.number, 0u);
}

TEST(FleetMessages, TheOthers) {
  EXPECT_EQ(read_back<TickMessage>(written("", TickMessage{-9}), "").tick, -9);
  EXPECT_EQ(read_back<HelloMessage>(written("", HelloMessage{4294967295u}), "").epoch, 4294967295u);
  EXPECT_EQ(read_back<HelloMessage>(written("7", HelloMessage{1}), "7").epoch, 1u);
  EXPECT_EQ(read_back<GoalMessage>(written("7", GoalMessage{{1, 2, 3}}), "7").position,
            (Point{1, 2, 3}));
  EXPECT_EQ(read_back<PreferredMessage>(written("7", PreferredMessage{{1, 2, 3}}), "7").velocity,
            (Velocity{1, 2, 3}));
  const std::vector<std::string> ids = {"1", "two", "\"3\""};
  EXPECT_EQ(read_back<ExpectMessage>(written("", ExpectMessage{ids}), "").ids, ids);
  const std::vector<Intruder> intruders = {{{{1, 2, 3}, {4, 5, 6}}, 1, 2, 3}, {}};
  EXPECT_EQ(read_back<IntrudersMessage>(written("", IntrudersMessage{intruders}), "").intruders,
            intruders);
  const auto joined =
      read_back<JoinedMessage>(written("7", JoinedMessage{true, 0.25, {"a"}, {1, 2}, {0}}), "7");
  EXPECT_TRUE(joined.joined);
  EXPECT_EQ(joined.touches, std::vector<std::string>{"a"});
  EXPECT_EQ(joined.obstacles, (std::vector<std::size_t>{1, 2}));
  read_back<LeaveMessage>(written("7", LeaveMessage{}), "7");
  read_back<LoseMessage>(written("7", LoseMessage{}), "7");
  const auto measured = read_back<MeasuredMessage>(
      written("7", MeasuredMessage{5, 0.5, {1, 2, 3}, Velocity{0, 0, 1}}), "7");
  EXPECT_EQ(measured.tick, 5);
  EXPECT_EQ(measured.position, (Point{1, 2, 3}));
}

TEST(FleetMessages, WholeNumbersAreIds) {
  read_back<LeaveMessage>(R"({"event": "leave", "id": 7})", "7");
  read_back<LeaveMessage>(R"({"event": "leave", "id": 18446744073709551615})",
                          "18446744073709551615");
}

TEST(FleetMessages, OnlyWhatIsAboutOneAgent) {
  FleetReader reader({}, "<stdin>", "a");
  const auto other = reader.take(R"({"event": "goal", "id": "b", "position": "not looked at"})");
  ASSERT_TRUE(other);
  EXPECT_FALSE(other->has_value());
  const auto own = reader.take(R"({"event": "leave", "id": "a"})");
  ASSERT_TRUE(own);
  EXPECT_TRUE(own->has_value());
  const auto all = reader.take(R"({"event": "hello", "epoch": 2})");
  ASSERT_TRUE(all);
  EXPECT_TRUE(all->has_value());
}

TEST(FleetMessages, BlankLinesSayNothing) {
  FleetReader reader({});
  const auto blank = reader.take(" \r");
  ASSERT_TRUE(blank);
  EXPECT_FALSE(blank->has_value());
}

TEST(FleetMessages, NumbersOfBranches) {
  EXPECT_EQ(branch_text(branch_number(3, 17)), "3.17");
  EXPECT_EQ(parse_branch("3.17"), branch_number(3, 17));
  for (const char* text : {"", ".", "3", "3.", ".3", "03.1", "3.01", "-1.2", "1.4294967296", "0.0",
                           "1.2.3", " 1.2", "1e1.2"}) {
    EXPECT_FALSE(parse_branch(text)) << text;
  }
}

TEST(FleetMessages, WhatIsWrongIsSaid) {
  expect_error("{", ErrorCode::kTruncated, "ends too early");
  expect_error("[1]", ErrorCode::kUnsupportedFormat, "not an object");
  expect_error("{}", ErrorCode::kMissingColumn, "'event'");
  expect_error(R"({"event": "fly"})", ErrorCode::kUnsupportedFormat, "known are report, ack");
  expect_error(R"({"event": "leave"})", ErrorCode::kMissingColumn, "'id'");
  expect_error(R"({"event": "leave", "id": ""})", ErrorCode::kMalformedRecord, "no id");
  expect_error(R"({"event": "leave", "id": 1.5})", ErrorCode::kMalformedRecord, "no id");
  expect_error(R"({"event": "goal", "id": 1})", ErrorCode::kMissingColumn, "'position'");
  expect_error(R"({"event": "goal", "id": 1, "position": [1, 2]})", ErrorCode::kColumnCount,
               "3 numbers");
  expect_error(R"({"event": "goal", "id": 1, "position": [1, 2, "3"]})", ErrorCode::kNotANumber,
               "a string");
  expect_error(R"({"event": "goal", "id": 1, "position": [1, 2, 1e13]})", ErrorCode::kOutsideDomain,
               "1e12");
  expect_error(R"({"event": "goal", "id": 1, "position": [1, 2, 1e999]})", ErrorCode::kCorrupt, "");
  expect_error(R"({"event": "tick", "tick": 1.5})", ErrorCode::kNotANumber, "whole number");
  expect_error(R"({"event": "tick", "tick": 9007199254740993})", ErrorCode::kNotANumber, "2^53");
  expect_error(R"({"event": "tick", "tick": 1, "tick": 2})", ErrorCode::kMalformedRecord, "twice");
  expect_error(R"({"event": "join", "id": 1, "position": [0, 0, 0], "radius": 2})",
               ErrorCode::kUnsupportedFormat, "radius_m");
  expect_error(R"({"event": "join", "id": 1, "position": [0, 0, 0], "radius_m": -2})",
               ErrorCode::kInvalidArgument, "below zero");
  expect_error(
      R"({"event": "join", "id": 1, "position": [0,0,0], "figures": {"loop": "elsewhere"}})",
      ErrorCode::kMalformedRecord, "onboard and ground");
  expect_error(R"({"event": "ack", "id": 1, "number": "1.2", "reply": "yes", "tick": 1})",
               ErrorCode::kMalformedRecord, "no reply");
  expect_error(R"({"event": "ack", "id": 1, "number": 12, "reply": "taken", "tick": 1})",
               ErrorCode::kMalformedRecord, "number of a branch");
  expect_error(R"({"event": "hello", "epoch": -1})", ErrorCode::kNotANumber, "whole number");
}

std::string command_line(const std::string& path, const std::string& ancestors) {
  return R"({"event":"command","id":1,"number":"1.2","starts":0,"period_s":0.1,"braking_mps2":1,)"
         R"("path":)" +
         path + R"(,"ancestors":)" + ancestors + "}";
}

TEST(FleetMessages, CommandsThatCannotBeAreSaid) {
  const std::string row = "[0,0,0,0,0,0]";
  read_back<CommandMessage>(command_line("[" + row + "]", "[]"), "1");
  std::string many = row;
  for (std::size_t i = 0; i < Command::kMostStates; ++i) many += "," + row;
  expect_error(command_line("[" + many + "]", "[]"), ErrorCode::kColumnCount, "36 at most");
  expect_error(command_line("[]", "[]"), ErrorCode::kColumnCount, "empty");
  expect_error(command_line("[[0,0,0,0,0,0,0]]", "[]"), ErrorCode::kColumnCount, "6 numbers");
  expect_error(command_line("[" + row + "]", R"([["1.1"]])"), ErrorCode::kMalformedRecord,
               "no ancestor");
  expect_error(command_line("[" + row + "]", R"([[1.1,2]])"), ErrorCode::kMalformedRecord,
               "no ancestor");
  expect_error(command_line("3", "[]"), ErrorCode::kMalformedRecord, "an array");
}

TEST(FleetMessages, ALineThatIsTooLongIsRefusedAndTheNextIsTaken) {
  FleetReader reader({});
  const std::string line = R"({"event": "leave", "id": ")" + std::string(10'000'000, 'a') + "\"}";
  const auto refused = reader.take(line);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kMalformedRecord);
  const auto next = reader.take(R"({"event": "leave", "id": "a"})");
  ASSERT_TRUE(next);
  EXPECT_EQ(reader.lines(), 2u);
}

TEST(FleetMessages, ManyMembersTakeNoLongTime) {
  std::string line = R"({"event": "leave")";
  for (int i = 0; i < 20'000; ++i) line += ",\"" + std::to_string(i) + "\":0";
  expect_error(line + "}", ErrorCode::kMalformedRecord, "more members");
}

TEST(FleetMessages, ABadLineNamesItsAgent) {
  FleetReader reader({});
  EXPECT_FALSE(reader.take(R"({"event": "goal", "id": "bee 9", "position": 3})"));
  EXPECT_EQ(reader.bad_id(), "bee 9");
  EXPECT_FALSE(reader.take("{"));
  EXPECT_EQ(reader.bad_id(), "");
}

}  // namespace
}  // namespace beespace::io
