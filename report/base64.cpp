#include "report/base64.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace beespace::report {

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t there = bytes.size() - i;  // of the three
    const auto byte = [&](std::size_t k) {
      return k < there ? std::uint32_t{static_cast<unsigned char>(bytes[i + k])} : 0u;
    };
    const std::uint32_t three = (byte(0) << 16u) | (byte(1) << 8u) | byte(2);
    const std::array<char, 4> four = {kDigits[three >> 18u], kDigits[(three >> 12u) & 63u],
                                      there > 1 ? kDigits[(three >> 6u) & 63u] : '=',
                                      there > 2 ? kDigits[three & 63u] : '='};
    text.append(four.data(), four.size());
  }
  return text;
}

}  // namespace beespace::report
