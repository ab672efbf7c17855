#include "io/mavlink/boot_clock.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace beespace::io {
namespace {

constexpr std::int64_t kSecond = 1'000'000;
// One part of so many; ten times what clocks of quartz do.
constexpr std::int64_t kDrift = 10'000;
// A vehicle is started, and first heard of, no sooner than this before it was heard of last: what
// messages take varies.
constexpr std::int64_t kStartSlackMicros = kSecond;
// No message is believed to have been on its way for longer,
constexpr std::int64_t kLongestMicros = 60 * kSecond;
// and of those that took longer than this there are few, none of which came first; all that waited
// together come together.
constexpr std::int64_t kLongMicros = 5 * kSecond;
constexpr std::size_t kFewIn = 4;
constexpr std::size_t kFewSpans = 1;
// Of so many in a row, over so long, one comes about as fast as the fastest.
constexpr std::size_t kSpanMessages = 8;
constexpr std::int64_t kSpanMicros = 10 * kSecond;
constexpr std::int64_t kSlowMicros = kSecond / 4;

std::int64_t apart(const SentMessage& message) {
  return message.came_us - message.sent_us;
}

// Whether a vehicle that has sent until `sent_us`, by a clock that is `apart_us` behind that of the
// log, can have been started behind that.
bool is_new_start(const SentMessage& message, std::int64_t apart_us, std::int64_t sent_us) {
  return message.sent_us < sent_us && apart(message) + kStartSlackMicros >= apart_us + sent_us;
}

// Where the starts begin, and the end.
std::vector<std::size_t> starts_of(const std::vector<SentMessage>& messages) {
  std::vector<std::size_t> starts;
  std::int64_t apart_us = 0;
  std::int64_t sent_us = 0;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    const SentMessage& message = messages[i];
    if (i == 0 || is_new_start(message, apart_us, sent_us)) {
      starts.push_back(i);
      apart_us = apart(message);
      sent_us = message.sent_us;
    }
    apart_us = std::min(apart_us, apart(message));
    sent_us = std::max(sent_us, message.sent_us);
  }
  starts.push_back(messages.size());
  return starts;
}

// From the difference of the clocks at each message of [begin, end) to the greatest that they can
// have then: what is possible at one message bounds it at all others.
void bound_by_all(const std::vector<SentMessage>& messages, std::size_t begin, std::size_t end,
                  std::vector<std::int64_t>& apart_us) {
  std::vector<std::size_t> order(end - begin);
  std::iota(order.begin(), order.end(), begin);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return messages[a].sent_us < messages[b].sent_us;
  });
  const auto bound = [&](std::size_t by, std::size_t at) {
    const std::int64_t between_us = messages[at].sent_us - messages[by].sent_us;
    const std::int64_t most_us =
        apart_us[by] + (between_us < 0 ? -between_us : between_us) / kDrift;
    apart_us[at] = std::min(apart_us[at], most_us);
  };
  for (std::size_t i = 1; i < order.size(); ++i) bound(order[i - 1], order[i]);
  for (std::size_t i = order.size() - 1; i > 0; --i) bound(order[i], order[i - 1]);
}

bool all_sent_at_once(const std::vector<SentMessage>& messages, std::size_t begin,
                      std::size_t end) {
  for (std::size_t i = begin + 1; i < end; ++i) {
    if (messages[i].sent_us != messages[begin].sent_us) return false;
  }
  return end - begin > 1;
}

// Whether the clock goes on as that of the log, by how much later than the fastest each came.
bool goes_along(const std::vector<SentMessage>& messages, std::size_t begin, std::size_t end,
                const std::vector<std::int64_t>& late_us) {
  if (all_sent_at_once(messages, begin, end)) return false;
  std::size_t long_ones = 0;
  std::size_t long_in_span = 0;
  std::size_t long_spans = 0;
  std::size_t spans = 0;
  std::size_t slow_spans = 0;
  std::size_t first = begin;
  std::int64_t least_us = std::numeric_limits<std::int64_t>::max();
  for (std::size_t i = begin; i < end; ++i) {
    const std::int64_t sent_us = messages[i].came_us - late_us[i];
    if (late_us[i] > kLongestMicros || sent_us < messages[begin].came_us - kLongMicros)
      return false;
    if (late_us[i] > kLongMicros) {
      ++long_ones;
      ++long_in_span;
    }
    least_us = std::min(least_us, late_us[i]);
    const std::size_t count = i + 1 - first;
    const bool is_whole = messages[i].came_us - messages[first].came_us >= kSpanMicros;
    if (count < kSpanMessages || (!is_whole && i + 1 < end)) continue;
    ++spans;
    if (least_us > kSlowMicros) ++slow_spans;
    if (kFewIn * long_in_span > count) ++long_spans;
    first = i + 1;
    long_in_span = 0;
    least_us = std::numeric_limits<std::int64_t>::max();
  }
  return kFewIn * long_ones <= end - begin && long_spans <= kFewSpans &&
         kFewIn * slow_spans <= spans;
}

}  // namespace

SentTimes sent_times(const std::vector<SentMessage>& messages) {
  SentTimes times;
  if (messages.empty()) return times;
  const std::vector<std::size_t> starts = starts_of(messages);
  std::vector<std::int64_t> apart_us;
  apart_us.reserve(messages.size());
  for (const SentMessage& message : messages) apart_us.push_back(apart(message));
  for (std::size_t k = 0; k + 1 < starts.size(); ++k) {
    bound_by_all(messages, starts[k], starts[k + 1], apart_us);
  }
  std::vector<std::int64_t> late_us;
  late_us.reserve(messages.size());
  for (std::size_t i = 0; i < messages.size(); ++i) {
    times.at_us.push_back(messages[i].sent_us + apart_us[i]);
    late_us.push_back(messages[i].came_us - times.at_us[i]);
    times.latest_us = std::max(times.latest_us, late_us[i]);
  }
  times.believed = true;
  for (std::size_t k = 0; k + 1 < starts.size(); ++k) {
    if (!goes_along(messages, starts[k], starts[k + 1], late_us)) times.believed = false;
  }
  return times;
}

void BootClock::begin(const SentMessage& message) {
  apart_us_ = apart(message);
  sent_us_ = message.sent_us;
  span_ = {message.came_us, apart_us_, 0, 0};
}

// What a span of all messages says of the clock.
void BootClock::end_span() {
  if (span_.count < kSpanMessages) return;
  if (span_.least_us - apart_us_ > kSlowMicros || kFewIn * span_.late > span_.count) {
    believed_ = false;
  }
  apart_us_ = std::max(apart_us_, span_.least_us);
}

std::int64_t BootClock::take(const SentMessage& message) {
  if (!believed_) return message.came_us;
  // A number that stands still is no clock; the same message may come by several links.
  const bool stands =
      last_ && last_->sent_us == message.sent_us && message.came_us - last_->came_us > 2 * kSecond;
  if (!last_ || is_new_start(message, apart_us_, sent_us_)) begin(message);
  last_ = last_ && last_->sent_us == message.sent_us ? last_ : message;
  if (message.sent_us > sent_us_) {
    apart_us_ += (message.sent_us - sent_us_) / kDrift;
    sent_us_ = message.sent_us;
  }
  apart_us_ = std::min(apart_us_, apart(message));
  const std::int64_t late_us = apart(message) - apart_us_;
  if (message.came_us - span_.began_us >= kSpanMicros) {
    end_span();
    span_ = {message.came_us, apart(message), 0, 0};
  }
  span_.least_us = std::min(span_.least_us, apart(message));
  ++span_.count;
  if (late_us > kLongMicros) ++span_.late;
  if (stands || late_us > kLongestMicros) believed_ = false;
  return believed_ ? message.came_us - late_us : message.came_us;
}

}  // namespace beespace::io
