// Compares lists of conflicts, with readable failures.
#pragma once

#include <beespace/conflict.hpp>
#include <beespace/pairs.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace beespace::test {

using Conflicts = std::vector<Conflict>;

inline std::string shown(const Conflict& c) {
  std::ostringstream text;
  text.precision(17);
  text << c.first << " and " << c.second << " from " << c.begins_s << " s to " << c.ends_s
       << " s, closest at " << c.closest_s << " s, " << c.closest_m << " m"
       << (c.certain ? "" : ", possibly");
  return text.str();
}

// Bit for bit; reports the first difference only.
inline void expect_same(const Conflicts& found, const Conflicts& expected) {
  for (std::size_t k = 0; k < found.size() && k < expected.size(); ++k) {
    ASSERT_TRUE(found[k] == expected[k])
        << "conflict " << k << " is " << shown(found[k]) << "; not " << shown(expected[k]);
  }
  ASSERT_EQ(found.size(), expected.size());
}

inline void expect_same(const std::vector<Pair>& found, const std::vector<Pair>& expected) {
  for (std::size_t k = 0; k < found.size() && k < expected.size(); ++k) {
    ASSERT_TRUE(found[k] == expected[k])
        << "pair " << k << " is " << found[k].first << " and " << found[k].second << "; not "
        << expected[k].first << " and " << expected[k].second;
  }
  ASSERT_EQ(found.size(), expected.size());
}

inline std::vector<Pair> pairs_of(const Conflicts& conflicts) {
  std::vector<Pair> pairs;
  for (const Conflict& conflict : conflicts) pairs.push_back({conflict.first, conflict.second});
  return pairs;
}

}  // namespace beespace::test
