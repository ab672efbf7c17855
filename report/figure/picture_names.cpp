#include "report/figure/picture_names.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace beespace::report {
namespace {

constexpr std::size_t kShort = 16;       // fits, with another one beside it
constexpr std::size_t kMostNames = 500;  // of more the picture names few
constexpr std::size_t kWorthIt = 4;      // characters that are left out
constexpr std::string_view kEllipsis = "\u2026";
constexpr std::string_view kBetweenWords = " /_-.:";

// How many characters all begin with, up to the end of a word.
template <class Alike>
std::size_t shared(const std::vector<std::string>& texts, const Alike& alike) {
  std::size_t count = texts.front().size();
  for (const std::string& text : texts) {
    count = std::min(count, text.size());
    count = std::min(count, alike(texts.front(), text));
  }
  return count;
}

std::size_t begin_alike(std::string_view one, std::string_view other) {
  const auto pair = std::mismatch(one.begin(), one.end(), other.begin(), other.end());
  return static_cast<std::size_t>(pair.first - one.begin());
}

std::size_t end_alike(std::string_view one, std::string_view other) {
  const auto pair = std::mismatch(one.rbegin(), one.rend(), other.rbegin(), other.rend());
  return static_cast<std::size_t>(pair.first - one.rbegin());
}

}  // namespace

std::string picture_name(const Names& names, PointId bee) {
  std::string name = names.of(bee);
  const std::vector<std::string>& texts = names.texts;
  if (name.size() <= kShort || texts.size() < 2 || texts.size() > kMostNames) return name;
  std::string_view rest = name;
  const std::size_t ends = shared(texts, &end_alike);
  // Back to where a word ends: "/mavros/pose" of "/drone1/mavros/pose".
  const std::size_t tail =
      rest.substr(rest.size() - std::min(ends, rest.size())).find_first_of(kBetweenWords);
  const bool drops_end = tail != std::string_view::npos && ends - tail >= kWorthIt;
  if (drops_end) rest.remove_suffix(ends - tail);
  const std::size_t begins = std::min(shared(texts, &begin_alike), rest.size());
  const std::size_t head = rest.substr(0, begins).find_last_of(kBetweenWords);
  const bool drops_beginning = head != std::string_view::npos && head + 1 >= kWorthIt;
  if (drops_beginning) rest.remove_prefix(head + 1);
  if (rest.empty()) return name;
  std::string shorter;
  if (drops_beginning) shorter += kEllipsis;
  shorter += rest;
  if (drops_end) shorter += kEllipsis;
  return shorter;
}

}  // namespace beespace::report
