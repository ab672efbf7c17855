#include "io/bytes/characters.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <string_view>

namespace beespace::io {
namespace {

// What a pattern means, said as simply as possible.
bool fits(std::string_view pattern, std::string_view word) {
  if (pattern.empty()) return word.empty();
  if (pattern.front() == '*') {
    return fits(pattern.substr(1), word) || (!word.empty() && fits(pattern, word.substr(1)));
  }
  const bool alike = !word.empty() && (pattern.front() == '?' || pattern.front() == word.front());
  return alike && fits(pattern.substr(1), word.substr(1));
}

std::string random_text(std::mt19937_64& random, std::string_view letters) {
  std::string text(random() % 7, 'a');
  for (char& letter : text) letter = letters[random() % letters.size()];
  return text;
}

TEST(Words, AreOneOfSeveralPatterns) {
  EXPECT_TRUE(is_one_of("lon long* x?", "longitude"));
  EXPECT_TRUE(is_one_of("lon long* x?", "x1"));
  EXPECT_FALSE(is_one_of("lon long* x?", "lo"));
  EXPECT_FALSE(is_one_of("lon long* x?", "x12"));
}

TEST(Words, FitAPatternAsItsMeaningSays) {
  std::mt19937_64 random(20261123);
  int fitting = 0;
  for (int round = 0; round < 100'000; ++round) {
    std::string pattern = random_text(random, "ab?*");
    if (pattern.empty()) pattern = "*";
    const std::string word = random_text(random, "ab");
    const bool expected = fits(pattern, word);
    fitting += expected ? 1 : 0;
    ASSERT_EQ(is_one_of(pattern, word), expected) << pattern << ' ' << word;
  }
  EXPECT_GT(fitting, 10'000);
}

TEST(Words, MayBeVeryLong) {
  const std::string word(10'000'000, 'f');
  EXPECT_FALSE(is_one_of("*g f*g ?*?*g", word));
  EXPECT_TRUE(is_one_of("g* f*f", word));
}

}  // namespace
}  // namespace beespace::io
