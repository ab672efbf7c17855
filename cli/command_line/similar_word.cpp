#include "cli/command_line/similar_word.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace beespace::cli {
namespace {

// Levenshtein's distance, row by row.
std::size_t edits_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row[b.size()];
}

}  // namespace

std::optional<std::string> most_similar(std::string_view word,
                                        const std::vector<std::string>& known) {
  constexpr std::size_t kLongestWord = 40;
  if (word.size() > kLongestWord) return std::nullopt;
  constexpr std::size_t kShortestBeginning = 3;
  if (word.size() >= kShortestBeginning) {
    for (const std::string& candidate : known) {
      if (candidate.starts_with(word)) return candidate;
    }
  }
  std::optional<std::string> best;
  std::size_t fewest = word.size() / 3 + 1;
  for (const std::string& candidate : known) {
    const std::size_t edits = edits_between(word, candidate);
    if (edits >= fewest) continue;
    fewest = edits;
    best = candidate;
  }
  return best;
}

}  // namespace beespace::cli
