#include "cli/recorded/large_apart.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

namespace beespace::cli {
namespace {

using analysis::Apart;
using analysis::Whereabouts;

// Where is a bee at a time? Asked for the first or the second one of a conflict.
struct Question {
  AgentId bee;
  double time_s;
  std::size_t answer;

  friend bool operator<(const Question& a, const Question& b) {
    return std::tie(a.bee, a.time_s, a.answer) < std::tie(b.bee, b.time_s, b.answer);
  }
};

std::vector<Question> questions_about(const std::vector<Conflict>& conflicts,
                                      const std::vector<Track>& tracks) {
  std::vector<Question> questions;
  questions.reserve(2 * conflicts.size());
  for (std::size_t at = 0; at < conflicts.size(); ++at) {
    const Conflict& conflict = conflicts[at];
    const auto time_s = analysis::common_instant(tracks[conflict.first], tracks[conflict.second],
                                                 conflict.closest_s);
    if (!time_s) continue;
    questions.push_back({conflict.first, *time_s, 2 * at});
    questions.push_back({conflict.second, *time_s, 2 * at + 1});
  }
  std::sort(questions.begin(), questions.end());
  return questions;
}

// Answers questions in their order, as fixes come in theirs.
class Answering {
 public:
  Answering(const std::vector<Question>& questions, bool heights, std::size_t answers)
      : questions_(questions), heights_(heights), answers_(answers) {}

  void pass(const LargeFix& fix) {
    if (before_ && before_->agent != fix.agent) before_.reset();
    for (; next_ < questions_.size(); ++next_) {
      const Question& question = questions_[next_];
      const bool reached = question.bee < fix.agent ||
                           (question.bee == fix.agent && question.time_s <= fix.fix.time_s);
      if (!reached) break;
      if (question.bee == fix.agent) answers_[question.answer] = between(fix, question.time_s);
    }
    before_ = fix;
  }
  [[nodiscard]] const std::vector<std::optional<Whereabouts>>& answers() const { return answers_; }

 private:
  // As the whole track has it: of it, these two fixes decide.
  [[nodiscard]] std::optional<Whereabouts> between(const LargeFix& fix, double time_s) const {
    Track track;
    for (const auto& each : {before_, std::optional(fix)}) {
      if (!each) continue;
      track.fixes.push_back(each->fix);
      if (heights_) track.heights_m.push_back(each->height_m);
    }
    return analysis::whereabouts_at(track, time_s);
  }

  const std::vector<Question>& questions_;
  bool heights_;
  std::vector<std::optional<Whereabouts>> answers_;
  std::size_t next_ = 0;
  std::optional<LargeFix> before_;
};

}  // namespace

Result<analysis::ApartOf> large_apart_of(RecordingOutOfCore& fixes,
                                         const std::vector<Conflict>& conflicts,
                                         const std::vector<Track>& tracks,
                                         const LargeHeights& heights) {
  const std::vector<Question> questions = questions_about(conflicts, tracks);
  Answering answering(questions, heights.apart, 2 * conflicts.size());
  if (!questions.empty()) {
    const Status read = fixes.visit_fixes([&](std::span<const LargeFix> some) {
      for (const LargeFix& fix : some) answering.pass(fix);
    });
    if (!read) return read.error();
  }
  std::vector<std::optional<Apart>> known(conflicts.size());
  for (std::size_t at = 0; at < known.size(); ++at) {
    const auto& first = answering.answers()[2 * at];
    const auto& second = answering.answers()[2 * at + 1];
    if (first && second) known[at] = analysis::apart(*first, *second, heights.unit_m);
  }
  return analysis::ApartOf([&conflicts, known = std::move(known)](
                               const Conflict& conflict) -> std::optional<Apart> {
    const auto key = [](const Conflict& of) { return std::tie(of.first, of.second, of.begins_s); };
    const auto at =
        std::lower_bound(conflicts.begin(), conflicts.end(), conflict,
                         [&key](const Conflict& a, const Conflict& b) { return key(a) < key(b); });
    if (at == conflicts.end() || key(*at) != key(conflict)) return std::nullopt;
    return known[static_cast<std::size_t>(at - conflicts.begin())];
  });
}

}  // namespace beespace::cli
