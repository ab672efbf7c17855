#include "io/problems/text_check.hpp"

#include "io/problems/json_kind.hpp"
#include "io/problems/signatures.hpp"

#include <cstddef>
#include <string>

namespace beespace::io {
namespace {

constexpr std::size_t kLookedAt = 4096;

Error unsupported(const std::string& found) {
  return {ErrorCode::kUnsupportedFormat, "this is " + found, {}};
}

// Every other byte of the first ones is NUL: letters in two bytes each.
std::optional<Error> utf16_problem(std::string_view bytes) {
  constexpr std::size_t kPairs = 8;
  for (const std::size_t nul : {std::size_t{1}, std::size_t{0}}) {
    std::size_t pairs = 0;
    while (pairs < kPairs && 2 * pairs + 1 < bytes.size() && bytes[2 * pairs + nul] == '\0' &&
           bytes[2 * pairs + 1 - nul] != '\0') {
      ++pairs;
    }
    if (pairs < 2 || (pairs < kPairs && 2 * pairs + 1 < bytes.size())) continue;
    const std::string name = nul == 1 ? "UTF-16LE" : "UTF-16BE";
    return unsupported("UTF-16 text without a mark that says so; save it as UTF-8 (iconv -f " +
                       name + " -t UTF-8 FILE)");
  }
  return std::nullopt;
}

// Eight bytes of a time, then a frame: the time in microseconds since 1970 lies within 2005 to
// 2041.
bool begins_as_telemetry(std::string_view bytes) {
  constexpr std::size_t kFrame = 8;
  if (bytes.size() <= kFrame) return false;
  const auto byte = [bytes](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  return byte(0) == 0 && byte(1) >= 4 && byte(1) <= 7 &&
         (byte(kFrame) == 0xFE || byte(kFrame) == 0xFD);
}

std::string hex(unsigned char byte) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  return {'0', 'x', kDigits[byte / 16u], kDigits[byte % 16u]};
}

}  // namespace

std::string_view without_byte_order_mark(std::string_view bytes) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return bytes.substr(0, kMark.size()) == kMark ? bytes.substr(kMark.size()) : bytes;
}

std::optional<Error> text_problem(std::string_view bytes, std::string_view or_raw) {
  const std::string_view text = without_byte_order_mark(bytes);
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  const std::string_view front = text.substr(start == std::string_view::npos ? 0 : start);
  if (std::string words = words_of_signature(front); !words.empty()) return unsupported(words);
  if (front.starts_with('{') || front.starts_with('[')) return unsupported(json_words(front));
  if (auto problem = utf16_problem(bytes)) return problem;
  if (begins_as_telemetry(bytes)) {
    return unsupported(
        "a MAVLink telemetry log (.tlog), which 'beespace replay' reads; where it finds no whole "
        "message in it, it is cut off or damaged, and to be copied again");
  }
  for (std::size_t i = 0; i < bytes.size() && i < kLookedAt; ++i) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    if (byte == 0) {
      return unsupported("no text: byte " + std::to_string(i) +
                         " is NUL; save it as text in UTF-8" + std::string(or_raw));
    }
    const bool control = byte < 0x20 && (byte < '\t' || byte > '\r');
    if (control || byte == 0x7F) {
      return unsupported("no text: byte " + std::to_string(i) + " is " + hex(byte) +
                         "; save it as text in UTF-8" + std::string(or_raw));
    }
  }
  return std::nullopt;
}

}  // namespace beespace::io
