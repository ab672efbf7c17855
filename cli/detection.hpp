// One run of `beespace detect`: what was asked, what was read, what was found.
#pragma once

#include "io/load_points.hpp"

#include <beespace/nearest.hpp>
#include <beespace/point.hpp>
#include <beespace/search_options.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace beespace::cli {

enum class Answer : std::uint8_t { kIds, kCsv, kJson, kGeoJson };

struct DetectRequest {
  std::string input = "-";
  std::string output = "-";
  io::LoadOptions load;
  SearchOptions search;
  Answer answer = Answer::kIds;
  bool nearest = false;
  bool fail_on_risk = false;
  bool quiet = false;
};

struct Timings {
  double read_s = 0.0;
  double search_s = 0.0;
  double write_s = 0.0;
};

struct Detection {
  std::vector<PointId> at_risk;
  std::optional<ClosestPair> closest;  // only when somebody will see it
  std::vector<Nearest> nearest;        // of every point; empty unless asked for
  Timings timings;

  [[nodiscard]] double share(const io::LoadedPoints& loaded) const {
    if (loaded.points.empty()) return 0.0;
    return static_cast<double>(at_risk.size()) / static_cast<double>(loaded.points.size());
  }
};

}  // namespace beespace::cli
