#include "io/recording/continued_logs.hpp"

#include <beespace/track.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {
namespace {

struct ContinuedLog {
  std::string source;
  std::string before;  // of its ids: "r1:"
  double begins_s;
  double ends_s;
};

// "r1:" of "r1:7"; nothing where behind it there is no number of a system.
std::string_view before_system(std::string_view id) {
  const std::size_t colon = id.rfind(':');
  if (colon == std::string_view::npos || colon + 1 == id.size()) return {};
  const std::string_view number = id.substr(colon + 1);
  const bool all =
      std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
  return all ? id.substr(0, colon + 1) : std::string_view();
}

std::string source_of(std::string_view before, const std::vector<std::string>& sources) {
  const std::string name = std::string(before.substr(0, before.size() - 1)) + ".tlog";
  const auto found = std::find_if(sources.begin(), sources.end(), [&](const std::string& source) {
    return source == name || source.ends_with("/" + name);
  });
  return found == sources.end() ? std::string() : *found;
}

}  // namespace

std::optional<std::string> continued_logs_note(const std::vector<RecordedBee>& bees,
                                               const std::vector<std::string>& sources) {
  std::vector<ContinuedLog> logs;
  std::map<std::string, std::size_t> times_heard;  // by number
  for (const RecordedBee& bee : bees) {
    const std::string_view before = before_system(bee.id);
    if (before.empty() || bee.fixes.empty()) return std::nullopt;
    ++times_heard[bee.id.substr(before.size())];
    const TimeSpan span{bee.fixes.front().time_s, bee.fixes.back().time_s};
    const auto known = std::find_if(logs.begin(), logs.end(), [before](const ContinuedLog& log) {
      return log.before == before;
    });
    if (known == logs.end()) {
      const std::string source = source_of(before, sources);
      if (source.empty()) return std::nullopt;
      logs.push_back({source, std::string(before), span.begins_s, span.ends_s});
    } else {
      known->begins_s = std::min(known->begins_s, span.begins_s);
      known->ends_s = std::max(known->ends_s, span.ends_s);
    }
  }
  const bool heard_again = std::any_of(times_heard.begin(), times_heard.end(),
                                       [](const auto& heard) { return heard.second > 1; });
  if (logs.size() < 2 || !heard_again) return std::nullopt;
  std::sort(logs.begin(), logs.end(),
            [](const ContinuedLog& a, const ContinuedLog& b) { return a.begins_s < b.begins_s; });
  std::string names;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    if (i > 0 && logs[i].begins_s <= logs[i - 1].ends_s) return std::nullopt;
    const bool quoted = logs[i].source.find(' ') != std::string::npos;
    names.append(quoted ? " '" : " ").append(logs[i].source).append(quoted ? "'" : "");
  }
  return "the same systems are in logs of which one begins when the other is over: if they are the "
         "same drones, as where the ground station was started again, join the logs, so that each "
         "is one: cat" +
         names + " > joined.tlog";
}

}  // namespace beespace::io
