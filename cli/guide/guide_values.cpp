#include "cli/guide/guide_values.hpp"

#include "cli/command_line/option_values.hpp"
#include "cli/input/number_list.hpp"
#include "io/bytes/durable_file.hpp"
#include "io/problems/excerpt.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace beespace::cli {
namespace {

std::optional<Fence> parse_fence(std::string_view text) {
  const auto numbers = parse_numbers(text, 4);
  if (!numbers) return std::nullopt;
  const std::vector<double>& n = *numbers;
  const double length = std::hypot(n[0], n[1], n[2]);
  if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
  return Fence{{n[0] / length, n[1] / length, n[2] / length}, n[3] / length};
}

// The first part that is no plane, and which part it is, from 1; 0: all are.
struct WrongPlane {
  std::string text;
  std::uint64_t part = 0;
};

// Planes between `separator`s. Comments begin with '#'.
std::vector<Fence> parse_fences(std::string_view text, char separator, WrongPlane& wrong) {
  std::vector<Fence> fences;
  for (std::uint64_t count = 1; !text.empty(); ++count) {
    const std::size_t end = text.find(separator);
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    const bool empty = part.find_first_not_of(" \t\r") == std::string_view::npos;
    if (empty || part.starts_with('#')) continue;
    const auto fence = parse_fence(part.substr(0, part.find_last_not_of(" \t\r") + 1));
    if (fence) {
      fences.push_back(*fence);
    } else if (wrong.part == 0) {
      wrong = {std::string(part), count};
    }
  }
  return fences;
}

}  // namespace

Result<std::vector<Fence>> read_fences(const Typed& typed) {
  WrongPlane wrong;
  std::vector<Fence> fences = parse_fences(typed.text, ';', wrong);
  if (wrong.part == 0 && !fences.empty()) return fences;
  constexpr std::size_t kMost = std::size_t{1} << 20;
  const auto file = io::read_small_file(typed.text, kMost);
  if (!file) return file.error();
  if (!*file) {
    return usage_error(typed.command,
                       std::string(typed.option) + " '" + typed.text +
                           "' is neither planes, as 0,0,1,10;0,0,-1,-120, nor a file");
  }
  wrong = {};
  fences = parse_fences(**file, '\n', wrong);
  if (wrong.part == 0 && !fences.empty()) return fences;
  Error error{ErrorCode::kMalformedRecord,
              (wrong.part == 0 ? "there is no plane in this file"
                               : io::excerpt(wrong.text) + " is no plane") +
                  "; give a direction inwards and an offset a line, as 0,0,1,10",
              {.source = typed.text}};
  if (wrong.part > 0) error.location.line = wrong.part;
  return error;
}

}  // namespace beespace::cli
