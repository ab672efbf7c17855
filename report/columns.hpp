// The columns of a page: lists of numbers or texts, compressed, each in an element of its own.
// See docs/page-format.md.
#pragma once

#include "io/json/json_writer.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::report {

// How numbers are told from those before them.
enum class Differences : std::uint8_t { kNone, kFirst, kSecond };

// What a number stands for: offset + scale * number.
struct Meaning {
  double scale = 1.0;
  double offset = 0.0;
};

class Columns {
 public:
  // Each keeps a column, and writes what the page's JSON has in its place, a member of this name.
  void add(io::JsonWriter& json, std::string_view name, std::span<const std::uint8_t> numbers);
  void add(io::JsonWriter& json, std::string_view name, std::span<const std::uint16_t> numbers,
           Differences differences = Differences::kNone, const Meaning& meaning = {});
  void add(io::JsonWriter& json, std::string_view name, std::span<const std::uint32_t> numbers,
           Differences differences = Differences::kNone, const Meaning& meaning = {});
  void add(io::JsonWriter& json, std::string_view name, std::span<const double> numbers);
  void add(io::JsonWriter& json, std::string_view name, std::span<const std::string> texts);

  // What the elements hold, in base64.
  [[nodiscard]] const std::vector<std::string>& elements() const { return elements_; }

 private:
  // What is said of a column, beside its bytes.
  struct Kept {
    const char* type;
    std::size_t count;
    Differences differences = Differences::kNone;
    Meaning meaning = {};
  };
  void keep(io::JsonWriter& json, std::string_view name, const Kept& column,
            std::string_view bytes);

  std::vector<std::string> elements_;
};

}  // namespace beespace::report
