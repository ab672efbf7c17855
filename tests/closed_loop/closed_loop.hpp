// A flock of bees that `beespace watch --advise` keeps apart: what they report goes into the
// process, what it tells them is flown, and what was flown is judged.
#pragma once

#include "tests/closed_loop/flight_plan.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace beespace::closed_loop {

// The flight, and whether the promises about it were kept.
struct Outcome {
  std::uint64_t looks = 0;
  std::uint64_t looks_missing = 0;               // that were due, and did not come
  std::uint64_t certified = 0;                   // bees, look by look
  std::uint64_t uncertified = 0;                 // the same, from the second look on
  std::map<std::string, std::uint64_t> because;  // they were not
  std::uint64_t certified_pairs =
      0;                          // pairs whose distance was promised and looked at, step by step
  std::uint64_t stale_pairs = 0;  // the same, one of which was stale
  std::uint64_t losses = 0;       // pairs closer than the threshold in a step, promised or not
  double closest_m = 1e300;       // of all
  double closest_certified_m = 1e300;  // of pairs with a promised distance
  // Promises that were broken, each in a sentence; and what else must not be.
  std::vector<std::string> broken;
  int watch_status = 0;
  std::string watch_errors;
  // Of the whole flight: 0 where `beespace verify` finds neither loss nor breach, 1 where it does.
  int verify_status = 0;
};

// `command` is the built program. What was flown goes into a file.
Outcome fly(const std::string& command, const FlightPlan& plan, const std::string& flown_path);

}  // namespace beespace::closed_loop
