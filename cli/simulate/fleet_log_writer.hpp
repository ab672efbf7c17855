// What the planner of a flight says, tick after tick, as `beespace guide --status all` writes it:
// "command" and "status".
#pragma once

#include "cli/input/flight_names.hpp"
#include "io/bytes/atomic_output.hpp"
#include "sim/fleet_loop.hpp"

#include <beespace/result.hpp>

#include <string>

namespace beespace::cli {

class FleetLogWriter {
 public:
  // Both must outlive it.
  FleetLogWriter(io::AtomicOutput& output, const FlightNames& names)
      : output_(output), names_(names) {}

  // Of the last tick of the loop.
  void add(const sim::FleetLoop& loop);
  // Commits the output. Errors: kWriteFailed.
  Status finish() { return output_.commit(); }

 private:
  [[nodiscard]] std::string id_of(AgentId agent) const;

  io::AtomicOutput& output_;
  const FlightNames& names_;
  std::string lines_;
};

}  // namespace beespace::cli
