#include "analysis/recorded/matching_numbers.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace beespace::analysis {
namespace {

bool is_digit(char character) {
  return character >= '0' && character <= '9';
}

// The numbers in a name, in their order, without leading zeros.
std::vector<std::string> numbers_in(const std::string& name) {
  std::vector<std::string> numbers;
  for (std::size_t at = 0; at < name.size();) {
    const auto from =
        std::find_if(name.begin() + static_cast<std::ptrdiff_t>(at), name.end(), is_digit);
    if (from == name.end()) break;
    const auto to = std::find_if_not(from, name.end(), is_digit);
    const auto counts = std::find_if(from, to, [](char digit) { return digit != '0'; });
    numbers.push_back(counts == to ? "0" : std::string(counts, to));
    at = static_cast<std::size_t>(to - name.begin());
  }
  return numbers;
}

// Of each name the number that tells it from all others; empty where none does, or several do.
std::vector<std::string> telling_numbers(std::span<const std::string> names) {
  std::vector<std::vector<std::string>> numbers;
  numbers.reserve(names.size());
  for (const std::string& name : names) numbers.push_back(numbers_in(name));
  std::vector<std::string> telling;
  if (numbers.empty()) return telling;
  const std::size_t count = numbers.front().size();
  if (std::any_of(numbers.begin(), numbers.end(),
                  [count](const auto& one) { return one.size() != count; })) {
    return telling;
  }
  for (std::size_t k = 0; k < count; ++k) {
    std::set<std::string> distinct;
    for (const auto& one : numbers) distinct.insert(one[k]);
    if (distinct.size() < names.size()) continue;
    if (!telling.empty()) return {};
    telling.reserve(names.size());
    for (const auto& one : numbers) telling.push_back(one[k]);
  }
  return telling;
}

}  // namespace

std::vector<std::optional<std::size_t>> match_by_numbers(std::span<const std::string> names,
                                                         std::span<const std::string> others) {
  const std::vector<std::string> of_names = telling_numbers(names);
  const std::vector<std::string> of_others = telling_numbers(others);
  std::vector<std::optional<std::size_t>> matches;
  if (of_names.empty() || of_others.empty()) return matches;
  std::map<std::string, std::size_t> by_number;
  for (std::size_t i = 0; i < of_others.size(); ++i) by_number.emplace(of_others[i], i);
  matches.resize(names.size());
  for (std::size_t i = 0; i < of_names.size(); ++i) {
    const auto found = by_number.find(of_names[i]);
    if (found != by_number.end()) matches[i] = found->second;
  }
  return matches;
}

}  // namespace beespace::analysis
