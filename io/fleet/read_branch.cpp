#include "io/fleet/read_branch.hpp"

#include "io/fleet/fleet_message.hpp"
#include "io/problems/excerpt.hpp"

#include <array>
#include <string>
#include <utility>

namespace beespace::io {
namespace {

void read_path(FleetFields& fields, Command& branch) {
  const auto rows = fields.array("path", Command::kMostStates);
  if (!rows) return;
  for (const JsonElement row : *rows) {
    std::array<double, 9> values = {};
    JsonArray items;
    const bool corrected = row.get(items) && items.size() == values.size();
    if (!fields.numbers(row, "path", std::span(values).first(corrected ? 9 : 6))) return;
    branch.states[branch.state_count++] = {
        {{values[0], values[1], values[2]}, {values[3], values[4], values[5]}},
        {values[6], values[7], values[8]}};
  }
  if (branch.state_count == 0) {
    fields.fail(ErrorCode::kColumnCount, fields.name("path") + " is empty; give a state or more");
  }
}

// ["3.16", 120]
void read_ancestors(FleetFields& fields, Command& branch) {
  const auto ancestors = fields.array("ancestors", Command::kMostAncestors);
  if (!ancestors) return;
  for (const JsonElement one : *ancestors) {
    JsonArray pair;
    Ancestor ancestor;
    std::string_view text;
    bool fine = one.get(pair) && pair.size() == 2;
    if (fine) {
      auto item = pair.begin();
      fine = (*item).get(text) && (*++item).get(ancestor.departs);
    }
    const auto number = parse_branch(text);
    const bool within =
        ancestor.departs >= -FleetFields::kMostTick && ancestor.departs <= FleetFields::kMostTick;
    if (!fine || !number || !within) {
      fields.fail(ErrorCode::kMalformedRecord,
                  fields.name("ancestors") +
                      R"( holds what is no ancestor; give a branch and a tick: ["3.16", 120])");
      return;
    }
    ancestor.number = *number;
    branch.ancestors[branch.ancestor_count++] = ancestor;
  }
}

}  // namespace

void read_branch(FleetFields& fields, Command& branch) {
  branch.number = fields.branch("number");
  branch.starts = fields.tick("starts");
  read_path(fields, branch);
  read_ancestors(fields, branch);
}

void read_stored(FleetFields& fields, StoredBranch& stored) {
  stored.promised = fields.whole("promised");
  stored.tick = fields.tick("tick");
  const auto branch = fields.find("branch");
  if (!branch) return;
  FleetFields own(*branch, "a branch");
  read_branch(own, stored.branch);
  if (auto error = own.error()) fields.fail(*std::move(error));
}

FleetFigures read_figures(FleetFields& fields, const FleetFigures& defaults) {
  FleetFigures figures = defaults;
  if (fields.find("loop")) {
    const std::string_view word = fields.text("loop");
    if (word != "onboard" && word != "ground") {
      fields.fail(ErrorCode::kMalformedRecord,
                  fields.name("loop") + " is " + excerpt(word) + "; known are onboard and ground");
    }
    figures.loop = word == "ground" ? LoopPlace::kGround : LoopPlace::kOnboard;
  }
  const auto read = [&](std::string_view key, double& value) {
    value = fields.from_zero_or(key, value);
  };
  read("report_error_m", figures.report_error_m);
  read("report_age_s", figures.report_age_s);
  read("sensing_error_m", figures.sensing_error_m);
  read("loop_period_s", figures.loop_period_s);
  read("loop_delay_s", figures.loop_delay_s);
  read("deviation_mps", figures.deviation_mps);
  read("clock_error_s", figures.clock_error_s);
  read("correction_mps2", figures.correction_mps2);
  read("correction_mps", figures.correction_mps);
  return figures;
}

}  // namespace beespace::io
