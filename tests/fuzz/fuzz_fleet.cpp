// Fuzzes messages of a fleet: lines of anything. Beyond the sanitizers: errors have a line, and
// what is read is written and read again as the same line. The same lines as the log of a fleet.
#include "io/fleet/fleet_log.hpp"
#include "io/fleet/fleet_reader.hpp"
#include "io/fleet/fleet_writer.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <variant>

namespace beespace::io {
namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

std::string written(const FleetMessage& message) {
  std::string line;
  append_message(line, message.id, message.content);
  line.pop_back();
  return line;
}

void check_again(const FleetMessage& message) {
  const std::string once = written(message);
  if (std::holds_alternative<ToldMessage>(message.content)) return;
  FleetReader reader({});
  const auto again = reader.take(once);
  require(again && again->has_value());
  require((**again).content.index() == message.content.index());
  const std::string twice = written(**again);
  // Of zero the sign may go.
  FleetReader third({});
  const auto last = third.take(twice);
  require(last && last->has_value() && written(**last) == twice);
}

void check_log(std::string_view lines, bool skip_bad) {
  const auto log = read_fleet_log(lines, "<stdin>", skip_bad);
  if (!log) return require(!log.error().message.empty());
  require(log->period_s > 0.0 && !log->agents.empty());
  for (const LoggedAgent& agent : log->agents) {
    for (const LoggedBranch& branch : agent.branches) require(!branch.states.empty());
    for (const LoggedStatus& status : agent.statuses) {
      require(status.sent <= agent.branches.size());
    }
  }
}

}  // namespace
}  // namespace beespace::io

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace beespace::io;
  if (size == 0) return 0;
  FleetReader reader({}, "<stdin>", data[0] == 'o' ? "a" : "");
  std::string_view rest(reinterpret_cast<const char*>(data) + 1, size - 1);
  check_log(rest, data[0] == 's');
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    const auto taken = reader.take(rest.substr(0, end));
    if (!taken) {
      require(taken.error().location.line.has_value() && !taken.error().message.empty());
    } else if (taken->has_value()) {
      check_again(**taken);
    }
    if (end == std::string_view::npos) break;
    rest.remove_prefix(end + 1);
  }
  return 0;
}
