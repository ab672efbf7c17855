#include "io/tracks/offered_columns.hpp"

#include "io/bytes/characters.hpp"
#include "io/table/header_words.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

// Columns of numbers that are understood as nothing else, and name no other quantity.
std::vector<std::size_t> free_numbers(const Header& header) {
  const TableLayout& table = header.table();
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const bool is_number = i < table.contents.size() && table.contents[i] == ColumnContent::kNumber;
    const bool is_free =
        header.meaning(i).role == Role::kNone && !names_other_quantity(table.names[i]);
    if (is_number && is_free) numbers.push_back(i);
  }
  return numbers;
}

// The one whose name is that of `first` but for the end: "sy" beside "sx", "coords.x2" beside
// "coords.x1".
std::optional<std::size_t> with_end(const std::vector<std::string>& names,
                                    const std::vector<std::size_t>& among, std::size_t first,
                                    char end) {
  std::string wanted = lower_case(names[first]);
  wanted.back() = end;
  for (const std::size_t other : among) {
    if (lower_case(names[other]) == wanted) return other;
  }
  return std::nullopt;
}

// Two or three that go together by their names, or else the first two: a height that is none would
// keep apart who is not.
std::vector<std::size_t> coordinates_among(const std::vector<std::string>& names,
                                           const std::vector<std::size_t>& numbers) {
  constexpr std::array<std::string_view, 2> kEnds = {"xyz", "123"};
  for (const std::size_t first : numbers) {
    for (const std::string_view ends : kEnds) {
      if (names[first].empty() || lower_case(names[first]).back() != ends[0]) continue;
      const auto second = with_end(names, numbers, first, ends[1]);
      if (!second) continue;
      const auto third = with_end(names, numbers, first, ends[2]);
      if (third) return {first, *second, *third};
      return {first, *second};
    }
  }
  if (numbers.size() < 2) return {};
  return {numbers[0], numbers[1]};
}

}  // namespace

std::string offered_columns(const Header& header, bool degrees) {
  const auto places = coordinates_among(header.table().names, free_numbers(header));
  if (places.empty()) return {};
  std::string text;
  const auto offer = [&text](std::string_view role, std::size_t column) {
    text.append(text.empty() ? "" : ",").append(role).append("=");
    text += std::to_string(column + 1);
  };
  for (const auto& [role, name] : {std::pair(Role::kId, "id"), std::pair(Role::kTime, "time")}) {
    if (header.has(role)) offer(name, header.columns(role).front());
  }
  constexpr std::array kDegrees = {"lon", "lat", "height"};
  constexpr std::array kMetres = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < places.size(); ++axis) {
    offer((degrees ? kDegrees : kMetres)[axis], places[axis]);
  }
  return text;
}

}  // namespace beespace::io
