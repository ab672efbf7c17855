// What was set beside what was flown: the same bees, in one frame and by one clock.
#pragma once

#include "analysis/recorded/gaps.hpp"
#include "analysis/recorded/tracking_figures.hpp"
#include "io/recording/recording.hpp"
#include "report/placement.hpp"

#include <beespace/conflict.hpp>
#include <beespace/result.hpp>

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

struct MaxGaps {
  analysis::MaxGap flown;
  analysis::MaxGap set;
};

// What was set and not flown, and for how long it was.
struct OnlySet {
  std::string id = {};
  double seconds = 0.0;
};

struct SetBesideFlown {
  std::vector<analysis::SetAndFlown> bees = {};  // that were set and flown
  std::vector<std::string> flown_ids = {};       // of these
  std::vector<std::string> set_ids = {};
  // Of these: when it was set, and it is not known where it was.
  std::vector<std::vector<TimeSpan>> unknown = {};
  std::vector<std::string> only_flown = {};
  std::vector<OnlySet> only_set = {};
  std::vector<std::string> notes = {};
};

// Errors: kUnsupportedFormat for what cannot be compared, as ids, frames or clocks differ;
// kInvalidArgument where the options have to say more, or less, with the line to type.
Result<SetBesideFlown> set_beside_flown(const io::Recording& flown, const io::Recording& set,
                                        const SetOptions& options, const MaxGaps& max_gaps);

}  // namespace beespace::cli
