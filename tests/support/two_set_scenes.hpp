// Ways to make two sets of points of one scene: ours against theirs.
#pragma once

#include <beespace/point.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace beespace::test {

enum class Split : std::uint8_t {
  kNone,  // one set, among itself
  kEvenAndOdd,
  kHalves,
  kAgainstEmpty,
  kEmptyAgainstAll,
  kOneAgainstAll,
  kAgainstItself,
};

inline constexpr std::array kSplits = {Split::kEvenAndOdd,    Split::kHalves,
                                       Split::kAgainstEmpty,  Split::kEmptyAgainstAll,
                                       Split::kOneAgainstAll, Split::kAgainstItself};

inline const char* name_of(Split split) {
  switch (split) {
    case Split::kNone:
      return "one set";
    case Split::kEvenAndOdd:
      return "even against odd";
    case Split::kHalves:
      return "first half against second";
    case Split::kAgainstEmpty:
      return "all against an empty set";
    case Split::kEmptyAgainstAll:
      return "an empty set against all";
    case Split::kOneAgainstAll:
      return "one against all";
    case Split::kAgainstItself:
      return "all against themselves";
  }
  return "unknown";
}

struct TwoSets {
  std::vector<Point> points;
  std::vector<Point> others;
};

inline TwoSets split(const std::vector<Point>& all, Split how) {
  TwoSets sets;
  const bool ours = how == Split::kAgainstEmpty || how == Split::kAgainstItself;
  const bool theirs = how == Split::kEmptyAgainstAll || how == Split::kOneAgainstAll ||
                      how == Split::kAgainstItself;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool even = i % 2 == 0;
    const bool first_half = i < all.size() / 2;
    if (ours || (how == Split::kEvenAndOdd && even) || (how == Split::kHalves && first_half) ||
        (how == Split::kOneAgainstAll && i == all.size() / 3)) {
      sets.points.push_back(all[i]);
    }
    if (theirs || (how == Split::kEvenAndOdd && !even) || (how == Split::kHalves && !first_half)) {
      sets.others.push_back(all[i]);
    }
  }
  return sets;
}

}  // namespace beespace::test
