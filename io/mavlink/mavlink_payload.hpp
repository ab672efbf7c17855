// Little-endian numbers of a payload, behind whose end there are zeros: version 2 cuts them off.
#pragma once

#include "io/frames/track_domain.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace beespace::io {

class MavlinkPayload {
 public:
  explicit MavlinkPayload(std::string_view bytes) {
    std::copy_n(bytes.begin(), std::min(bytes.size(), kMost), bytes_.begin());
  }

  [[nodiscard]] std::uint8_t byte(std::size_t at) const {
    return static_cast<std::uint8_t>(bytes_[at]);
  }
  [[nodiscard]] std::uint32_t unsigned16(std::size_t at) const {
    return byte(at) | std::uint32_t{byte(at + 1)} << 8u;
  }
  [[nodiscard]] std::uint32_t unsigned32(std::size_t at) const {
    return unsigned16(at) | unsigned16(at + 2) << 16u;
  }
  [[nodiscard]] std::uint64_t unsigned64(std::size_t at) const {
    return unsigned32(at) | std::uint64_t{unsigned32(at + 4)} << 32u;
  }
  [[nodiscard]] double signed32(std::size_t at) const {
    return static_cast<std::int32_t>(unsigned32(at));
  }
  [[nodiscard]] double signed16(std::size_t at) const {
    return static_cast<std::int16_t>(unsigned16(at));
  }
  [[nodiscard]] double float32(std::size_t at) const {
    return without_dust(static_cast<double>(std::bit_cast<float>(unsigned32(at))));
  }
  [[nodiscard]] std::string_view text(std::size_t at, std::size_t length) const {
    return {bytes_.data() + at, length};
  }
  // Two digits a byte, without zeros at the end; empty where all are.
  [[nodiscard]] std::string name(std::size_t at, std::size_t length) const {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string digits;
    std::size_t used = 0;
    for (std::size_t i = 0; i < length; ++i) {
      digits += kDigits[byte(at + i) >> 4u];
      digits += kDigits[byte(at + i) & 0xFu];
      if (byte(at + i) != 0) used = digits.size();
    }
    return digits.substr(0, used);
  }

 private:
  // What is read of no message lies behind this.
  static constexpr std::size_t kMost = 72;

  std::array<char, kMost> bytes_ = {};
};

}  // namespace beespace::io
