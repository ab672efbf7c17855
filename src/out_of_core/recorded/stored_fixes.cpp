#include "out_of_core/recorded/stored_fixes.hpp"

#include "motion/flush.hpp"
#include "motion/validate.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::out_of_core {

namespace {

Error at(Error error, const char* array, std::size_t row) {
  error.location.array = array;
  error.location.record = row;
  return error;
}

// Those of positions in the words of all checks of motion.
std::optional<Error> check_fix(double time_s, const Point& position, double height_m,
                               std::size_t row) {
  if (auto error = motion::check_position(motion::flushed(position), row)) {
    return at(*std::move(error), "positions", row);
  }
  if (auto error = motion::check_height(motion::flushed(height_m), 0.0, row)) {
    return at(*std::move(error), "heights", row);
  }
  if (auto error = motion::check_time(motion::flushed(time_s), row)) {
    return at(*std::move(error), "times", row);
  }
  return std::nullopt;
}

}  // namespace

std::vector<double> TimeSample::sorted() const {
  std::vector<double> times = times_;
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

Status StoredFixes::add(std::span<const AgentId> agents, std::span<const double> times_s,
                        const PointsView& positions, Crew& crew) {
  const bool apart = positions.has_heights();
  const auto height_of = [&](std::size_t row) { return apart ? positions.heights_m()[row] : 0.0; };
  for (std::size_t row = 0; row < agents.size(); ++row) {
    if (auto error = check_fix(times_s[row], positions[row], height_of(row), row)) {
      return *std::move(error);
    }
  }
  if (!agents.empty()) have_heights_ = apart;
  for (std::size_t row = 0; row < agents.size(); ++row) {
    const Fix fix = motion::flushed(Fix{times_s[row], positions[row]});
    rows_.add({agents[row], fix, motion::flushed(height_of(row)), rows_.size()});
    times_.add(fix.time_s);
    if (!rows_.full()) continue;
    if (auto status = rows_.flush(crew); !status) return status;
  }
  return std::monostate{};
}

void StoredFixes::note(const StoredFix& first, const StoredFix& second, RepeatedFixes& repeated) {
  if (repeated.allowed && first.fix == second.fix && first.height_m == second.height_m) {
    ++repeated.count;
    return;
  }
  if (repeated.clash && repeated.clash->second_row < second.row) return;
  repeated.clash = {first.agent, first.fix.time_s, first.row, second.row};
}

}  // namespace beespace::out_of_core
