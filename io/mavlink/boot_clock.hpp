// When a vehicle was where a message says: by its own clock, not by when the message came.
//
// Messages carry the sender's time since it was started (time_boot_ms), and a log or a link when
// they came. None comes before it was sent: so the least delay tells how far the two clocks are
// apart, and a message that took longer is not taken for a place at the moment when it came. What
// is left is that least delay itself, which is not known.
//
// Two clocks of quartz go apart by some 10^-5; kDrift bounds that. A clock that falls back is that
// of a vehicle that was started anew, where it can have been: the start must lie behind the last
// message that was sent before. Otherwise the message is late.
//
// Not every number is a clock. It is not believed where it does not go on as the clock of the log
// does (a simulator at another speed, a field that is never set), or where many messages would have
// been on their way for long, as where two vehicles share an id. Then times are those of arrival.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::io {

struct SentMessage {
  std::int64_t sent_us = 0;  // by the sender's clock
  std::int64_t came_us = 0;  // by that of the log
};

struct SentTimes {
  bool believed = false;
  std::vector<std::int64_t> at_us = {};  // by the clock of the log, one a message
  std::int64_t latest_us = 0;            // what the slowest message took more than the fastest
};

// Of all messages of one vehicle, in the order in which they came.
SentTimes sent_times(const std::vector<SentMessage>& messages);

// The same while they come: of each what is known by then.
class BootClock {
 public:
  // When the message was sent, by the clock of the log.
  std::int64_t take(const SentMessage& message);

  [[nodiscard]] bool believed() const { return believed_; }

 private:
  // The messages of some seconds, by how they came.
  struct Span {
    std::int64_t began_us = 0;
    std::int64_t least_us = 0;  // of the differences of the two clocks
    std::size_t count = 0;
    std::size_t late = 0;
  };

  void begin(const SentMessage& message);
  void end_span();

  bool believed_ = true;
  std::optional<SentMessage> last_;
  std::int64_t apart_us_ = 0;  // the least difference of the two clocks, as it drifts
  std::int64_t sent_us_ = 0;   // the latest of this start
  Span span_;
};

}  // namespace beespace::io
