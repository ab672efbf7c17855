// Whether bytes are what they were: against faults of disks and memory, not of enemies.
#pragma once

#include "base/hash.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace beespace::out_of_core {

// Goes on over bytes that come in several parts; each part but the last one is a multiple of 8.
class Checksum {
 public:
  void add(std::span<const std::byte> bytes) {
    // Four lanes, so that no multiplication waits for the one before it.
    constexpr std::size_t kLanes = 4;
    std::array<std::uint64_t, kLanes> words{};
    std::size_t at = 0;
    for (; at + sizeof words <= bytes.size(); at += sizeof words) {
      std::memcpy(words.data(), bytes.data() + at, sizeof words);
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        lanes_[lane] = (lanes_[lane] ^ words[lane]) * 0x9E3779B97F4A7C15U;
        lanes_[lane] ^= lanes_[lane] >> 29U;
      }
    }
    words = {};
    if (at < bytes.size()) std::memcpy(words.data(), bytes.data() + at, bytes.size() - at);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      lanes_[lane] = core::mix(lanes_[lane] + words[lane] + bytes.size());
    }
  }

  [[nodiscard]] std::uint64_t value() const {
    std::uint64_t all = 0;
    for (const std::uint64_t lane : lanes_) all = core::mix(all + lane);
    return all;
  }

 private:
  std::array<std::uint64_t, 4> lanes_ = {1, 2, 3, 4};
};

}  // namespace beespace::out_of_core
