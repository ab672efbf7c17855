#include "io/recording/missing_numbers.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace beespace::io {
namespace {

// Of fewer it is no numbering; with more gaps than one in so many it is one of another kind.
constexpr std::size_t kFewestNumbered = 3;
constexpr std::uint32_t kMissingOf = 3;

struct NumberedName {
  std::string_view before;
  std::uint32_t number = 0;
};

std::optional<NumberedName> numbered(std::string_view id) {
  std::size_t at = id.size();
  while (at > 0 && id[at - 1] >= '0' && id[at - 1] <= '9') --at;
  NumberedName name{id.substr(0, at)};
  const char* const end = id.data() + id.size();
  if (std::from_chars(id.data() + at, end, name.number).ec != std::errc()) return std::nullopt;
  return name;
}

}  // namespace

std::optional<std::string> missing_numbers_note(const std::vector<RecordedBee>& bees) {
  if (bees.size() < kFewestNumbered) return std::nullopt;
  std::vector<std::uint32_t> numbers;
  numbers.reserve(bees.size());
  std::string_view before;
  for (const RecordedBee& bee : bees) {
    const auto name = numbered(bee.id);
    if (!name || (!numbers.empty() && name->before != before)) return std::nullopt;
    before = name->before;
    numbers.push_back(name->number);
  }
  std::sort(numbers.begin(), numbers.end());
  const auto there = static_cast<std::uint32_t>(numbers.size());
  const std::uint32_t among = numbers.back() - numbers.front() + 1;
  if (among <= there || (among - there) > there / kMissingOf) return std::nullopt;
  if (std::adjacent_find(numbers.begin(), numbers.end()) != numbers.end()) return std::nullopt;
  std::string missing;
  std::size_t told = 0;
  constexpr std::size_t kMostTold = 5;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    for (std::uint32_t number = numbers[i - 1] + 1; number < numbers[i]; ++number) {
      if (told++ == kMostTold) missing += ", …";
      if (told > kMostTold) continue;
      if (!missing.empty()) missing += ", ";
      missing += std::to_string(number);
    }
  }
  return "drones are numbered from " + std::to_string(numbers.front()) + " to " +
         std::to_string(numbers.back()) + " without " + missing +
         ": if one was left out, nothing is known of that drone";
}

}  // namespace beespace::io
