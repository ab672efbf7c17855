#include "io/encounters/scenario_words.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::io {
namespace {

std::optional<double> finite_number(std::string_view text) {
  const auto value = parse_number(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

bool is_between(char c) {
  return c == ',' || is_blank(c);
}

std::string in_capitals(std::string_view word) {
  std::string text(word);
  for (char& c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return text;
}

std::vector<std::string> words_of(std::string_view command) {
  std::vector<std::string> words;
  std::size_t at = 0;
  while (true) {
    // One comma, with any blanks around it, separates.
    std::size_t commas = 0;
    for (; at < command.size() && is_between(command[at]); ++at) commas += command[at] == ',';
    if (at == command.size()) return words;
    for (; commas > 1; --commas) words.emplace_back();
    const std::size_t begin = at;
    while (at < command.size() && !is_between(command[at])) ++at;
    words.push_back(in_capitals(command.substr(begin, at - begin)));
  }
}

}  // namespace

std::optional<TimedCommands> timed_commands(std::string_view line) {
  const std::size_t end = line.find('>');
  if (end == std::string_view::npos) return std::nullopt;
  std::string_view clock = without_padding(line.substr(0, end));
  double seconds = 0.0;
  for (int part = 0; part < 3; ++part) {
    const std::size_t colon = part < 2 ? clock.find(':') : clock.size();
    if (colon == std::string_view::npos) return std::nullopt;
    const std::string_view digits = clock.substr(0, colon);
    const bool begins_well = !digits.empty() && digits.front() >= '0' && digits.front() <= '9';
    const auto value = begins_well ? finite_number(digits) : std::nullopt;
    constexpr double kMost = 1e6;
    if (!value || *value >= kMost) return std::nullopt;
    seconds = seconds * 60.0 + *value;
    clock.remove_prefix(std::min(colon + 1, clock.size()));
  }
  return TimedCommands{seconds, without_padding(line.substr(end + 1))};
}

std::vector<std::vector<std::string>> commands_in(std::string_view commands) {
  std::vector<std::vector<std::string>> found;
  while (!commands.empty()) {
    const std::size_t end = std::min(commands.find(';'), commands.size());
    auto words = words_of(commands.substr(0, end));
    if (!words.empty()) found.push_back(std::move(words));
    commands.remove_prefix(std::min(end + 1, commands.size()));
  }
  return found;
}

std::optional<double> degrees_in(std::string_view word) {
  if (word.empty()) return std::nullopt;
  double sign = 1.0;
  const bool before = is_one_of("N E S W", word.substr(0, 1));
  if (before || is_one_of("N E S W", word.substr(word.size() - 1))) {
    const char side = before ? word.front() : word.back();
    if (side == 'S' || side == 'W') sign = -1.0;
    before ? word.remove_prefix(1) : word.remove_suffix(1);
  }
  if (word.find_first_of("'\"") == std::string_view::npos) {
    const auto value = finite_number(word);
    return value ? std::optional(sign * *value) : std::nullopt;
  }
  if (word.starts_with('-')) {
    sign = -sign;
    word.remove_prefix(1);
  }
  // Degrees, minutes and seconds.
  double degrees = 0.0;
  double unit = 1.0;
  for (int part = 0; part < 3 && !word.empty(); ++part) {
    const std::size_t end = std::min(word.find_first_of("'\""), word.size());
    const auto value = finite_number(word.substr(0, end));
    if (!value || *value < 0.0) return std::nullopt;
    degrees += *value / unit;
    unit *= 60.0;
    word.remove_prefix(std::min(end + 1, word.size()));
  }
  return word.empty() ? std::optional(sign * degrees) : std::nullopt;
}

std::optional<double> heading_in(std::string_view word) {
  if (word.ends_with('T')) word.remove_suffix(1);
  return finite_number(word);
}

std::optional<double> feet_in(std::string_view word) {
  if (!word.starts_with("FL")) return finite_number(word);
  const auto level = finite_number(word.substr(2));
  return level ? std::optional(100.0 * *level) : std::nullopt;
}

std::optional<AirSpeed> air_speed_in(std::string_view word) {
  if (word.starts_with('M')) {
    const auto mach = finite_number(word.substr(1));
    if (!mach || *mach < 0.0) return std::nullopt;
    // "M78" is 0.78.
    return AirSpeed{*mach >= 20.0 ? *mach / 100.0 : *mach, true};
  }
  const auto value = finite_number(word);
  if (!value || *value < 0.0) return std::nullopt;
  return AirSpeed{*value, *value > 0.1 && *value < 1.0};
}

}  // namespace beespace::io
