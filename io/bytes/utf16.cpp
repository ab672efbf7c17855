#include "io/bytes/utf16.hpp"

#include "io/bytes/characters.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace beespace::io {
namespace {

constexpr std::uint32_t kHighSurrogates = 0xD800;
constexpr std::uint32_t kLowSurrogates = 0xDC00;
constexpr std::uint32_t kSurrogatesEnd = 0xE000;

bool is_high(std::uint32_t unit) {
  return unit >= kHighSurrogates && unit < kLowSurrogates;
}

bool is_low(std::uint32_t unit) {
  return unit >= kLowSurrogates && unit < kSurrogatesEnd;
}

}  // namespace

std::optional<Bytes> from_utf16(std::string_view bytes) {
  constexpr std::size_t kUnit = 2;
  const bool little = bytes.starts_with("\xFF\xFE");
  if (!little && !bytes.starts_with("\xFE\xFF")) return std::nullopt;
  // UTF-32 begins like it.
  if (bytes.starts_with(std::string_view("\xFF\xFE\0\0", 2 * kUnit))) return std::nullopt;
  if (bytes.size() % kUnit != 0) return std::nullopt;
  const auto unit_at = [&](std::size_t at) {
    const std::uint32_t first = static_cast<unsigned char>(bytes[at]);
    const std::uint32_t second = static_cast<unsigned char>(bytes[at + 1]);
    return little ? second << 8u | first : first << 8u | second;
  };
  std::string text;
  text.reserve(bytes.size() / kUnit + bytes.size() / 8);
  for (std::size_t at = kUnit; at < bytes.size(); at += kUnit) {
    std::uint32_t character = unit_at(at);
    if (is_low(character)) return std::nullopt;
    if (is_high(character)) {
      at += kUnit;
      if (at >= bytes.size() || !is_low(unit_at(at))) return std::nullopt;
      character = 0x1'0000 + ((character - kHighSurrogates) << 10u) + unit_at(at) - kLowSurrogates;
    }
    append_utf8(text, character);
  }
  return copy_of(text);
}

}  // namespace beespace::io
