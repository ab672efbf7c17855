// One number for many doubles, by which machines are compared: FNV-1a over their bits.
#pragma once

#include <bit>
#include <cstdint>
#include <initializer_list>

namespace beespace::scenes {

class Fingerprint {
 public:
  void take(std::initializer_list<double> numbers) {
    for (const double number : numbers) {
      hash_ = (hash_ ^ std::bit_cast<std::uint64_t>(number)) * 1'099'511'628'211u;
    }
  }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 14'695'981'039'346'656'037u;
};

}  // namespace beespace::scenes
