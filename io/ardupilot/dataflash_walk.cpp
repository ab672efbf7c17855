#include "io/ardupilot/dataflash_walk.hpp"

#include <algorithm>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::string_view kFront = "\xA3\x95";
constexpr std::size_t kDefinition = 0x80;  // the type of definitions
constexpr std::size_t kDefinitionBytes = 89;

std::size_t byte_at(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]);
}

}  // namespace

bool is_dataflash_log(std::string_view bytes) {
  return bytes.starts_with("\xA3\x95\x80\x80\x59");
}

DataflashWalk::DataflashWalk(std::string_view bytes) : bytes_(bytes) {
  DataflashLayout definition;
  definition.size = kDefinitionBytes;
  layouts_[kDefinition] = std::move(definition);
}

bool DataflashWalk::is_front(std::size_t at) const {
  return at + kDataflashFront <= bytes_.size() && bytes_.substr(at, kFront.size()) == kFront;
}

// Of what begins there, whether all of it is there or not; null where nothing begins.
const DataflashLayout* DataflashWalk::layout_at(std::size_t at) const {
  if (!is_front(at)) return nullptr;
  const auto& layout = layouts_[byte_at(bytes_, at + kFront.size())];
  return layout ? &*layout : nullptr;
}

// All of a message, and nothing but another one behind it.
bool DataflashWalk::is_sure(std::size_t at) const {
  const DataflashLayout* const layout = layout_at(at);
  if (layout == nullptr || layout->size > bytes_.size() - at) return false;
  const std::size_t end = at + layout->size;
  return bytes_.substr(end, kFront.size()) == kFront.substr(0, bytes_.size() - end);
}

// Pages of a chip, or of a card, that were reserved and never written.
bool DataflashWalk::is_unwritten(std::size_t at) const {
  const char first = bytes_[at];
  return (first == '\0' || first == '\xFF') &&
         bytes_.find_first_not_of(first, at) == std::string_view::npos;
}

// Whether anything follows.
bool DataflashWalk::pass_damage() {
  const std::size_t from = at_;
  if (is_unwritten(from)) {
    at_ = bytes_.size();
    return false;
  }
  at_ = from + 1;
  while (at_ < bytes_.size() && !is_sure(at_)) {
    at_ = std::min(bytes_.find(kFront.front(), at_ + 1), bytes_.size());
  }
  const bool begins = layout_at(from) != nullptr || bytes_.size() - from < kDataflashFront;
  if (at_ == bytes_.size() && begins) {
    losses_.cut_at = from;
    return false;
  }
  if (losses_.damaged_places++ == 0) losses_.first_damage = from;
  losses_.damaged_bytes += at_ - from;
  return true;
}

bool DataflashWalk::next() {
  while (at_ < bytes_.size()) {
    const DataflashLayout* const layout = layout_at(at_);
    if (layout == nullptr || layout->size > bytes_.size() - at_) {
      if (!pass_damage()) return false;
      continue;
    }
    const std::size_t type = byte_at(bytes_, at_ + kFront.size());
    message_ = bytes_.substr(at_ + kDataflashFront, layout->size - kDataflashFront);
    layout_ = layout;
    at_ += layout->size;
    if (type != kDefinition) return true;
    const std::size_t defined = byte_at(message_, 0);
    if (defined != kDefinition) layouts_[defined] = dataflash_layout(message_);
  }
  return false;
}

}  // namespace beespace::io
