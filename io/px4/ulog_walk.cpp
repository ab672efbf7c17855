#include "io/px4/ulog_walk.hpp"

#include <algorithm>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::string_view kMagic = "ULog\x01\x12\x35";
constexpr std::size_t kHeader = 16;
constexpr std::size_t kFront = 3;  // of a message: its size and type
constexpr std::string_view kKinds = "BFIMPQARDLCSO";
constexpr std::string_view kSync = "\x2F\x73\x13\x20\x25\x0C\xBB\x12";

std::size_t unsigned16(std::string_view bytes, std::size_t at) {
  return std::size_t{static_cast<unsigned char>(bytes[at])} |
         std::size_t{static_cast<unsigned char>(bytes[at + 1])} << 8u;
}

std::uint64_t unsigned64(std::string_view bytes, std::size_t at) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    value |= std::uint64_t{static_cast<unsigned char>(bytes[at + i])} << 8 * i;
  }
  return value;
}

Error cut_in_definitions(std::size_t at) {
  return {ErrorCode::kTruncated,
          "this PX4 log ends within its definitions, at byte " + std::to_string(at) +
              "; it is incomplete, copy it from the drone again",
          {}};
}

}  // namespace

bool is_ulog(std::string_view bytes) {
  return bytes.starts_with(kMagic);
}

Result<UlogWalk> UlogWalk::begin(std::string_view bytes) {
  if (bytes.size() < kHeader) return cut_in_definitions(bytes.size());
  constexpr unsigned kNewest = 1;
  const unsigned version = static_cast<unsigned char>(bytes[kMagic.size()]);
  if (version > kNewest) {
    return Error{ErrorCode::kUnsupportedFormat,
                 "this PX4 log is in version " + std::to_string(version) +
                     " of ULog, of which 0 and 1 are read; convert it to CSV with "
                     "ulog2csv (pip install pyulog)",
                 {}};
  }
  UlogWalk walk(bytes);
  walk.at_ = kHeader;
  walk.section_end_ = bytes.size();
  const auto first = walk.message_at(kHeader);
  if (!first && bytes.size() - kHeader < kFront) return cut_in_definitions(bytes.size());
  if (first && first->type == 'B') {
    if (auto error = walk.read_flags(first->body)) return *std::move(error);
    walk.at_ = first->end;
  }
  return walk;
}

// Eight bytes of features that may be ignored, eight of those that may not, and where data was
// appended later, as after a crash.
std::optional<Error> UlogWalk::read_flags(std::string_view body) {
  constexpr std::size_t kMayNot = 8;
  constexpr std::size_t kOffsets = 16;
  constexpr std::size_t kSize = 40;
  if (body.size() < kSize) return cut_in_definitions(kHeader);
  for (std::size_t i = kMayNot; i < kOffsets; ++i) {
    const unsigned known = i == kMayNot ? 1 : 0;
    if ((static_cast<unsigned char>(body[i]) & ~known) == 0) continue;
    return Error{ErrorCode::kUnsupportedFormat,
                 "this PX4 log says at byte " + std::to_string(kHeader + kFront + i) +
                     " that it cannot be read without a feature of ULog that beespace does not "
                     "know; convert it to CSV with ulog2csv (pip install pyulog)",
                 {}};
  }
  if ((static_cast<unsigned char>(body[kMayNot]) & 1u) == 0) return std::nullopt;
  std::size_t sections = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint64_t offset = unsigned64(body, kOffsets + 8 * i);
    const std::size_t before = sections == 0 ? kHeader : ends_[sections - 1];
    if (offset > before && offset < bytes_.size()) {
      ends_[sections++] = static_cast<std::size_t>(offset);
    }
  }
  ends_[sections] = bytes_.size();
  section_end_ = ends_[0];
  next_end_ = 1;
  return std::nullopt;
}

std::optional<UlogWalk::Message> UlogWalk::message_at(std::size_t at) const {
  if (at + kFront > section_end_) return std::nullopt;
  const std::size_t size = unsigned16(bytes_, at);
  const char type = bytes_[at + 2];
  const std::size_t end = at + kFront + size;
  if (size == 0 || kKinds.find(type) == std::string_view::npos || end > section_end_) {
    return std::nullopt;
  }
  return Message{type, bytes_.substr(at + kFront, size), end};
}

bool UlogWalk::may_begin(std::size_t at) const {
  if (at + kFront > section_end_) return true;
  return unsigned16(bytes_, at) > 0 && kKinds.find(bytes_[at + 2]) != std::string_view::npos;
}

// Whether what it says has the length that it must have.
bool UlogWalk::fits(const Message& message) const {
  constexpr std::size_t kTopic = 2;
  switch (message.type) {
    case 'D': {
      if (message.body.size() < kTopic) return false;
      const auto topic = topics_.find(static_cast<std::uint16_t>(unsigned16(message.body, 0)));
      if (topic == topics_.end()) return false;
      if (!topic->second.layout) return true;
      const std::size_t size = message.body.size() - kTopic;
      return size >= topic->second.layout->least_size && size <= topic->second.layout->size;
    }
    case 'A':
      return message.body.size() > 3;
    case 'O':
    case 'R':
      return message.body.size() == 2;
    case 'S':
      return message.body == kSync;
    default:
      return true;
  }
}

// Where the next message begins that says what it is: one of a topic that is known, or a mark that
// was written for this, with something behind it that may be a message. Otherwise the end.
std::size_t UlogWalk::next_sure(std::size_t at) const {
  for (; at < section_end_; ++at) {
    const auto message = message_at(at);
    if (!message || (message->type != 'D' && message->type != 'S')) continue;
    if (fits(*message) && may_begin(message->end)) return at;
  }
  return section_end_;
}

// Where a section ends within a message, the drone was switched off, or what follows was appended
// later.
bool UlogWalk::is_cut(std::size_t at) const {
  if (at + kFront > section_end_) return true;
  return may_begin(at) && at + kFront + unsigned16(bytes_, at) > section_end_;
}

void UlogWalk::pass_damage() {
  const std::size_t from = at_;
  at_ = next_sure(from + 1);
  if (at_ == section_end_ && is_cut(from)) {
    losses_.cut_at = from;
    return;
  }
  if (losses_.damaged_places++ == 0) losses_.first_damage = from;
  losses_.damaged_bytes += at_ - from;
}

bool UlogWalk::next_section() {
  if (next_end_ == 0 || next_end_ >= ends_.size() || ends_[next_end_] == 0) return false;
  at_ = section_end_;
  section_end_ = ends_[next_end_++];
  return true;
}

void UlogWalk::subscribe(std::string_view body) {
  UlogTopic topic;
  topic.instance = static_cast<std::uint8_t>(body[0]);
  topic.name = body.substr(3);
  topic.layout = definitions_.layout(topic.name);
  topics_.insert_or_assign(static_cast<std::uint16_t>(unsigned16(body, 1)), std::move(topic));
}

// Whether it is one of a topic.
bool UlogWalk::take(const Message& message) {
  switch (message.type) {
    case 'F':
      definitions_.add(message.body);
      return false;
    case 'A':
      subscribe(message.body);
      return false;
    case 'O':
      ++losses_.dropouts;
      losses_.dropped_ms += unsigned16(message.body, 0);
      return false;
    case 'D':
      topic_ = &topics_.find(static_cast<std::uint16_t>(unsigned16(message.body, 0)))->second;
      message_ = message.body.substr(2);
      return topic_->layout.has_value();
    default:
      return false;
  }
}

bool UlogWalk::next() {
  while (true) {
    if (at_ >= section_end_) {
      if (!next_section()) return false;
      continue;
    }
    const auto message = message_at(at_);
    if (message && fits(*message)) {
      offset_ = at_;
      at_ = message->end;
      if (take(*message)) return true;
      continue;
    }
    pass_damage();
  }
}

}  // namespace beespace::io
