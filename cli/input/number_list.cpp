#include "cli/input/number_list.hpp"

#include "cli/command_line/option_values.hpp"
#include "io/bytes/number_text.hpp"

#include <cmath>
#include <string>

namespace beespace::cli {

std::optional<std::vector<double>> parse_numbers(std::string_view text, std::size_t count) {
  std::vector<double> numbers;
  for (;;) {
    const std::size_t end = text.find(',');
    std::string_view word = text.substr(0, end);
    while (word.starts_with(' ')) word.remove_prefix(1);
    while (word.ends_with(' ')) word.remove_suffix(1);
    const auto number = io::parse_number(word);
    if (!number || !std::isfinite(*number)) return std::nullopt;
    numbers.push_back(*number);
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  if (numbers.size() != count) return std::nullopt;
  return numbers;
}

Result<Point> read_point(const Typed& typed) {
  if (const auto numbers = parse_numbers(typed.text, 3)) {
    return Point{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  }
  return usage_error(typed.command, std::string(typed.option) + " '" + typed.text +
                                        "' is no position; give three numbers of metres, as "
                                        "0,12.5,30");
}

}  // namespace beespace::cli
