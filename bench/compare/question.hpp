// The four questions of the comparison.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace beespace::compare {

enum class Question : std::uint8_t { kAtRisk, kPairs, kNearest, kCounts };

struct QuestionName {
  Question question;
  std::string_view name;
};

inline constexpr std::array<QuestionName, 4> kQuestionNames = {{
    {Question::kAtRisk, "at_risk"},
    {Question::kPairs, "pairs"},
    {Question::kNearest, "nearest"},
    {Question::kCounts, "counts"},
}};

constexpr std::optional<Question> question_named(std::string_view name) {
  for (const QuestionName& entry : kQuestionNames) {
    if (entry.name == name) return entry.question;
  }
  return std::nullopt;
}

constexpr std::string_view name_of(Question question) {
  return kQuestionNames[static_cast<std::size_t>(question)].name;
}

}  // namespace beespace::compare
