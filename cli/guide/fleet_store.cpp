#include "cli/guide/fleet_store.hpp"

#include "io/bytes/durable_file.hpp"
#include "io/fleet/fleet_reader.hpp"
#include "io/fleet/fleet_writer.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace beespace::cli {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 30;

Error not_ours(const std::string& path, std::uint64_t line) {
  return {ErrorCode::kMalformedRecord,
          "this file is damaged, or not what a planner stored; name its own file, or begin with a "
          "new file and a greater --epoch than all before, and let all agents join anew",
          {.source = path, .line = line}};
}

}  // namespace

Result<FleetStore> FleetStore::open(const std::string& path, std::uint32_t least) {
  FleetStore store(path);
  if (!path.empty()) {
    auto lock = io::FileLock::take(path, "planner");
    if (!lock) return std::move(lock).error();
    store.lock_ = *std::move(lock);
  }
  if (Status done = store.read(); !done) return std::move(done).error();
  if (store.epoch_ == std::numeric_limits<std::uint32_t>::max()) {
    return Error{ErrorCode::kMalformedRecord,
                 "there is no epoch after that of this file; begin with a new file, and let all "
                 "agents join anew",
                 {.source = path}};
  }
  store.epoch_ = std::max(store.epoch_ + 1, least);
  if (Status done = store.write(); !done) return std::move(done).error();
  return store;
}

// A "hello" with the epoch, then a "join" of each member.
Status FleetStore::read() {
  if (path_.empty()) return std::monostate{};
  const auto text = io::read_small_file(path_, kMostBytes);
  if (!text) return text.error();
  if (!*text) return std::monostate{};
  io::FleetReader reader({}, path_);
  std::string_view rest = **text;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    const auto message = reader.take(rest.substr(0, end));
    if (!message) return not_ours(path_, reader.lines());
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    if (!*message) continue;
    const auto* const hello = std::get_if<io::HelloMessage>(&(**message).content);
    const auto* const join = std::get_if<io::JoinMessage>(&(**message).content);
    const bool first = epoch_ == 0;
    if (first ? hello == nullptr || hello->epoch == 0 : join == nullptr) {
      return not_ours(path_, reader.lines());
    }
    if (first) {
      epoch_ = hello->epoch;
    } else {
      members_.insert_or_assign(std::string((**message).id), join->request);
    }
  }
  return epoch_ == 0 ? Status(not_ours(path_, 1)) : Status(std::monostate{});
}

void FleetStore::put(const std::string& name, const JoinRequest& request) {
  JoinRequest& known = members_[name];
  known = request;
  known.agent = 0;
  changed_ = true;
}

void FleetStore::remove(const std::string& name) {
  changed_ = members_.erase(name) > 0 || changed_;
}

// The lock keeps others away; where it was removed by hand, or the file was put back from a copy,
// this does.
Status FleetStore::check_latest() const {
  const auto text = io::read_small_file(path_, kMostBytes);
  if (!text) return text.error();
  if (!*text) return std::monostate{};
  io::FleetReader reader({}, path_);
  const auto message = reader.take(std::string_view(**text).substr(0, (**text).find('\n')));
  if (!message || !*message) return std::monostate{};
  const auto* const hello = std::get_if<io::HelloMessage>(&(**message).content);
  if (hello == nullptr || hello->epoch <= epoch_) return std::monostate{};
  return Error{ErrorCode::kWriteFailed,
               "a planner of epoch " + std::to_string(hello->epoch) +
                   " has stored here since this one, of epoch " + std::to_string(epoch_) +
                   ", was started; stop one of them",
               {.source = path_}};
}

Status FleetStore::write() {
  if (path_.empty() || !changed_) return std::monostate{};
  if (Status latest = check_latest(); !latest) return latest;
  std::string text;
  io::append_message(text, {}, io::HelloMessage{epoch_});
  for (const auto& [name, request] : members_) {
    io::append_message(text, name, io::JoinMessage{request});
  }
  Status written = io::write_durably(path_, text);
  changed_ = !written;
  return written;
}

}  // namespace beespace::cli
