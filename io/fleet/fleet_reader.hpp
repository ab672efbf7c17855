// Reads messages of a fleet, a line each; see fleet_message.hpp and docs/fleet-messages.md.
//
// A line that is wrong is an error with its number, and the next line is read. Memory is bounded by
// the longest line that is taken. One thread at a time.
#pragma once

#include "io/fleet/event_line.hpp"
#include "io/fleet/fleet_fields.hpp"
#include "io/fleet/fleet_message.hpp"
#include "io/json/json_value.hpp"

#include <beespace/advise.hpp>
#include <beespace/fleet.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

class FleetReader {
 public:
  static constexpr std::size_t kLongest = EventLines::kLongest;  // longer lines are refused
  static constexpr std::size_t kLongestId = kLongestFleetId;

  struct Defaults {
    FleetFigures figures = {};  // what is absent in the figures and limits of one agent
    FlightLimits limits = {};
  };

  // `source` is what errors blame. With `only`, messages about other agents are read no further
  // than their ids.
  explicit FleetReader(Defaults defaults, std::string source = "<stdin>", std::string only = {});

  // The next line, without its end. Nothing where it is blank, or about another agent. What it
  // returns holds until the next call. Errors have source and line.
  Result<std::optional<FleetMessage>> take(std::string_view line);

  // Of a line that is an error: whom it is about, as far as that could be read; or empty.
  [[nodiscard]] std::string_view bad_id() const { return bad_id_; }
  // Of the same: whether it is a list of intruders, or may be one where it is no whole object.
  [[nodiscard]] bool bad_intruders() const { return bad_intruders_; }
  [[nodiscard]] std::uint64_t lines() const { return lines_; }

 private:
  Result<std::optional<FleetMessage>> read(std::string_view line);
  Result<FleetMessage> read_content(JsonElement object, std::string_view event);
  std::optional<Error> read_id(FleetFields& fields, bool needed, std::string_view& id);

  void read_request(FleetFields& fields, JoinRequest& request) const;
  FleetContent read_join(FleetFields& fields, bool only_asks) const;
  FleetContent read_adopt(FleetFields& fields) const;

  Defaults defaults_;
  std::string source_;
  std::string only_;
  EventLines events_;
  std::string id_;
  std::string event_;
  std::string bad_id_;
  bool bad_intruders_ = false;
  std::uint64_t lines_ = 0;
};

}  // namespace beespace::io
