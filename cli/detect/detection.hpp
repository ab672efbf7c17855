// One run of `beespace detect`: what was asked, what was read, what was found.
#pragma once

#include "cli/console/exit_code.hpp"
#include "cli/detect/reports/report.hpp"
#include "cli/input/separation.hpp"
#include "cli/output/output_form.hpp"
#include "cli/output/table.hpp"
#include "io/points/load_options.hpp"
#include "io/points/loaded_points.hpp"
#include "io/points/repeated_ids.hpp"
#include "io/units/stated_length.hpp"

#include <beespace/nearest.hpp>
#include <beespace/point.hpp>
#include <beespace/search_options.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace beespace::cli {

// What is asked for: each value as its option says it, then what follows from them.
struct DetectRequest {
  std::vector<std::string> inputs;  // one, or with memory_bytes several
  std::optional<std::string> others;
  std::string output = "-";
  io::LoadOptions load;  // of both inputs
  const Report* report = &reports().front();
  std::optional<io::StatedLength> threshold;    // as typed; absent: the default
  std::optional<io::StatedLength> vertical;     // as typed
  const UsualSeparation* separation = nullptr;  // that stands for both
  std::optional<std::uint64_t> max_results;     // absent: no limit
  std::optional<std::uint64_t> memory_bytes;    // absent: all that it takes
  std::string temporary;                        // the folder of temporary files, with memory_bytes
  bool unique_ids = false;
  bool at_risk_only = false;
  bool csv = false;
  bool json = false;
  bool geojson = false;
  bool fail_on_risk = false;
  bool quiet = false;

  PairOptions search{.threads = 0};
  OutputForm form;

  // The only one.
  [[nodiscard]] const std::string& input() const { return inputs.front(); }
};

// The exit code, or what went wrong.
Result<ExitCode> run_detect(const DetectRequest& request);

// What is said of an input, however many of its points are in memory. Refers to all.
struct InputFacts {
  const std::string& path;
  const io::LoadedPoints& loaded;
  std::uint64_t points;
  const io::RepeatedIds* repeated;  // null: said elsewhere
};

struct Inputs {
  io::LoadedPoints ours;
  std::optional<io::LoadedPoints> others;
  io::RepeatedIds our_repeated = {};
  io::RepeatedIds their_repeated = {};

  // Of the heights of both; where they differ they are compared in metres.
  [[nodiscard]] io::Unit height_unit() const {
    const bool alike = !others || others->height_unit == ours.height_unit;
    return alike ? ours.height_unit : io::Unit::kMetre;
  }

  // Bad records, of which it is not known where they are.
  [[nodiscard]] std::uint64_t skipped() const {
    return ours.skipped_count + (others ? others->skipped_count : 0);
  }

  // Whose ids stand second in pairs, and in columns of ids.
  [[nodiscard]] const io::LoadedPoints& theirs() const { return others ? *others : ours; }
};

struct Timings {
  double read_s = 0.0;
  double search_s = 0.0;
  double write_s = 0.0;
};

struct Detection {
  std::vector<PointId> at_risk;        // only where it is told, or the exit code depends on it
  std::optional<ClosestPair> closest;  // only where it is told
  Table table;
  Timings timings;

  [[nodiscard]] double share(const io::LoadedPoints& loaded) const {
    if (loaded.points.empty()) return 0.0;
    return static_cast<double>(at_risk.size()) / static_cast<double>(loaded.points.size());
  }
};

}  // namespace beespace::cli
