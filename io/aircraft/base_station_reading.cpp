#include "io/aircraft/base_station_reading.hpp"

#include "io/aircraft/aircraft_gathering.hpp"
#include "io/aircraft/base_station.hpp"
#include "io/problems/text_check.hpp"
#include "io/table/record_walk.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace beespace::io {

namespace {

constexpr LeftOutReason kNoPositionEver = {"of aircraft that never tell a position (one each)"};
// As a recording that was stopped ends.
constexpr LeftOutReason kCutShort = {"cut short at the end of the input"};
// As the last lines of a log, or a log that was begun anew, begin.
constexpr LeftOutReason kCutOff = {"cut off at the beginning of the input"};

// The line at the beginning of `text`, which is without it then.
std::string_view take_line(std::string_view& text) {
  const std::size_t ends = text.find('\n');
  std::string_view line = text.substr(0, ends);
  text.remove_prefix(ends == std::string_view::npos ? text.size() : ends + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

// The rest of a message, and nothing but messages behind it.
bool is_cut_off(std::string_view text) {
  constexpr int kEnough = 3;
  constexpr std::ptrdiff_t kSeparators = 21;
  const std::string_view first = take_line(text);
  const auto separators = std::count(first.begin(), first.end(), ',');
  if (separators == 0 || separators > kSeparators) return false;
  for (int line = 0; line < kEnough; ++line) {
    if (!is_base_station_line(take_line(text))) return false;
  }
  return true;
}

}  // namespace

bool is_base_station(std::string_view bytes) {
  constexpr std::size_t kLongestMessage = 1024;
  const std::string_view text = without_byte_order_mark(bytes);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return false;
  const std::string_view rest = text.substr(begin, kLongestMessage);
  return is_base_station_line(rest.substr(0, rest.find_first_of("\r\n"))) || is_cut_off(rest);
}

std::optional<Error> read_base_station(std::string_view bytes, RecordingAssembly& assembly) {
  const RecordingOptions& options = assembly.options();
  if (auto error = base_station_problem(options)) return error;
  AircraftGathering gathering({HeightSource::kPressure, options.grounded}, assembly);
  if (auto error = gathering.begin("BaseStation messages", Unit::kFoot, 0.0)) return error;
  BaseStation station(options.time_zone);
  assembly.note(station.note());
  std::unordered_map<std::string, bool> heard;  // whether it tells positions
  const std::string_view text = without_byte_order_mark(bytes);
  RecordWalk walk(text, 0, '\n');
  bool is_first = true;
  while (walk.next()) {
    if (std::exchange(is_first, false) && !is_base_station_line(walk.record())) {
      assembly.leave_out(kCutOff, {});
      continue;
    }
    const AircraftReport* report = nullptr;
    auto error = station.take(walk.record(), report);
    if (!error && report != nullptr) error = gathering.add(*report, walk.line() + 1);
    if (!error && !station.address().empty()) {
      bool& tells_positions = heard.try_emplace(station.address(), false).first->second;
      tells_positions = tells_positions || report != nullptr;
    }
    if (!error) continue;
    // Without the end of its line it is the last one.
    if (!text.ends_with('\n') &&
        walk.record().data() + walk.record().size() == text.data() + text.size()) {
      assembly.leave_out(kCutShort, station.address());
      continue;
    }
    error->location.line = walk.line() + 1;
    error->location.record = walk.row();
    if (auto fatal = assembly.bad(*std::move(error), station.address())) return fatal;
  }
  std::vector<std::string> silent;
  for (const auto& [address, tells_positions] : heard) {
    if (!tells_positions) silent.push_back(address);
  }
  std::sort(silent.begin(), silent.end());
  for (const std::string& address : silent) assembly.heard_of(kNoPositionEver, address);
  return std::nullopt;
}

}  // namespace beespace::io
