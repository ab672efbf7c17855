// What came of a simulation, for people and for programs.
#pragma once

#include "cli/simulate_request.hpp"
#include "sim/closed_loop.hpp"

#include <beespace/verify.hpp>

#include <cstdint>
#include <string>

namespace beespace::cli {

// How the flight went, beside what the loop and the verdict know.
struct FlightFigures {
  std::uint64_t steps = 0;
  std::uint64_t steps_with_losses = 0;
  std::uint64_t uncertified = 0;  // pairs, counted anew in each step
  bool landed = false;            // all have arrived and stand
  double total_s = 0.0;           // how long it took, checks included
};

std::string simulate_summary(const SimulateRequest& request, const sim::ClosedLoop& loop,
                             const Verdict& verdict, const FlightFigures& figures);

// The same as one JSON document.
std::string simulate_json(const SimulateRequest& request, const sim::ClosedLoop& loop,
                          const Verdict& verdict, const FlightFigures& figures);

}  // namespace beespace::cli
