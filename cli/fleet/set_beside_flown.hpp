// What was set beside what was flown: the same bees, in one frame and by one clock.
#pragma once

#include "analysis/recorded/tracking_figures.hpp"
#include "io/recording/recording.hpp"
#include "report/placement.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace beespace::cli {

// When by the clock of what was flown that begins which was set, as it was typed.
struct SetBegins {
  double seconds = 0.0;
  bool since_1970 = false;  // a date and time; otherwise seconds of that clock
};

struct SetOptions {
  std::optional<report::Placement> origin = {};  // of what was set in metres
  std::optional<SetBegins> begins = {};
};

struct SetBesideFlown {
  std::vector<analysis::SetAndFlown> bees = {};  // that were set and flown
  std::vector<std::string> flown_ids = {};       // of these
  std::vector<std::string> set_ids = {};
  std::size_t only_one = 0;  // of which one of both is there
  std::vector<std::string> notes = {};
};

// Errors: kUnsupportedFormat for what cannot be compared, as ids, frames or clocks differ;
// kInvalidArgument where the options have to say more, or less, with the line to type.
Result<SetBesideFlown> set_beside_flown(const io::Recording& flown, const io::Recording& set,
                                        const SetOptions& options, double max_gap_s);

}  // namespace beespace::cli
