// A walk over the messages of a PX4 log (ULog): what topics say, and what was lost on the way.
//
// A log has no checksums. What is no message, or is not as long as its topic's definition says, is
// passed over until the next message that fits, and counted.
#pragma once

#include "io/flight_logs/log_losses.hpp"
#include "io/px4/ulog_format.hpp"

#include <beespace/result.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace beespace::io {

// By the first bytes.
bool is_ulog(std::string_view bytes);

// What one instance of a topic says.
struct UlogTopic {
  std::string name;
  std::uint8_t instance = 0;
  std::optional<UlogLayout> layout;  // nothing where its definition is missing or cannot be read
};

struct UlogLosses : LogLosses {
  std::uint64_t dropouts = 0;  // the drone could not write fast enough
  std::uint64_t dropped_ms = 0;
};

class UlogWalk {
 public:
  // `bytes` begin as is_ulog() says. Errors: kTruncated, kUnsupportedFormat for features that are
  // not known; with the byte in the message.
  static Result<UlogWalk> begin(std::string_view bytes);

  // To the next message of a topic; false when there is none.
  bool next();

  [[nodiscard]] const UlogTopic& topic() const { return *topic_; }
  // What it says, as topic().layout describes it, whose size it has.
  [[nodiscard]] std::string_view message() const { return message_; }
  // Where it begins.
  [[nodiscard]] std::size_t offset() const { return offset_; }
  // So far.
  [[nodiscard]] const UlogLosses& losses() const { return losses_; }
  [[nodiscard]] const std::unordered_map<std::uint16_t, UlogTopic>& topics() const {
    return topics_;
  }

 private:
  struct Message {
    char type = 0;
    std::string_view body = {};
    std::size_t end = 0;
  };

  explicit UlogWalk(std::string_view bytes) : bytes_(bytes) {}

  std::optional<Error> read_flags(std::string_view body);
  // Whether it is a message, as far as can be told without what it says.
  [[nodiscard]] std::optional<Message> message_at(std::size_t at) const;
  // Where a message may begin: at one, at the end of a section, or at one that is cut there.
  [[nodiscard]] bool may_begin(std::size_t at) const;
  [[nodiscard]] bool fits(const Message& message) const;
  [[nodiscard]] std::size_t next_sure(std::size_t at) const;
  [[nodiscard]] bool is_cut(std::size_t at) const;
  void pass_damage();
  bool next_section();
  bool take(const Message& message);
  void subscribe(std::string_view body);

  std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t section_end_ = 0;           // what was appended later begins there, or nothing
  std::array<std::size_t, 4> ends_ = {};  // of the sections that follow
  std::size_t next_end_ = 0;
  UlogDefinitions definitions_;
  std::unordered_map<std::uint16_t, UlogTopic> topics_;
  const UlogTopic* topic_ = nullptr;
  std::string_view message_ = {};
  std::size_t offset_ = 0;
  UlogLosses losses_;
};

}  // namespace beespace::io
