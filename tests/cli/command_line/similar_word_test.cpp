#include "cli/command_line/similar_word.hpp"

#include <gtest/gtest.h>

namespace beespace::cli {
namespace {

const std::vector<std::string> kWords = {"--threshold", "--threads", "--output", "detect"};

TEST(SimilarWord, AMistypedWordIsRecognised) {
  EXPECT_EQ(most_similar("--thershold", kWords), "--threshold");
  EXPECT_EQ(most_similar("--thread", kWords), "--threads");
  EXPECT_EQ(most_similar("detekt", kWords), "detect");
}

TEST(SimilarWord, ABeginningIsEnough) {
  EXPECT_EQ(most_similar("--thresh", kWords), "--threshold");
  EXPECT_EQ(most_similar("--o", kWords), "--output");
  EXPECT_FALSE(most_similar("--", kWords).has_value());
}

TEST(SimilarWord, SomethingElseIsNotGuessedAt) {
  EXPECT_FALSE(most_similar("--banana", kWords).has_value());
  EXPECT_FALSE(most_similar("", kWords).has_value());
  EXPECT_FALSE(most_similar(std::string(100'000, 'x'), kWords).has_value());
}

}  // namespace
}  // namespace beespace::cli
