// Addresses of aircraft (ICAO 24-bit, as six hexadecimal digits), which some write in capitals and
// others not: one aircraft, called as it came first.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

namespace beespace::io {

// Whether a column, by its name, holds such addresses and nothing else: "icao24", "hex".
bool names_address(std::string_view column);

class AddressNames {
 public:
  // What to call who has that id; the id where it is no address. As long as this and `id` live.
  std::string_view name_of(std::string_view id);

  // How many aircraft came in several spellings, and the second spelling of the first of them.
  [[nodiscard]] std::uint64_t spelt_twice() const { return spelt_twice_; }
  [[nodiscard]] const std::string& example() const { return example_; }

 private:
  struct Name {
    std::string text;
    bool twice = false;
  };
  std::unordered_map<std::string, Name> names_;  // by the address in small letters
  std::string key_;
  std::uint64_t spelt_twice_ = 0;
  std::string example_;
};

}  // namespace beespace::io
