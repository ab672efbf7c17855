// beespace itself: the plain functions, or an Engine that keeps its memory from call to call
// (variant "engine"), with two threads ("two_threads").
#include "bench/compare/contender.hpp"
#include "bench/compare/fail.hpp"

#include <beespace/beespace.hpp>

namespace beespace::compare {
namespace {

template <class Value>
Value value_of(Result<Value> result) {
  if (!result) fail(to_string(result.error()));
  return std::move(result).value();
}

const std::vector<Question> kAllQuestions = {Question::kAtRisk, Question::kPairs,
                                             Question::kNearest, Question::kCounts};

class Functions final : public Contender {
 public:
  [[nodiscard]] Description description() const override {
    return {"beespace", BEESPACE_VERSION, Arithmetic::kExact, "a plain function call",
            kAllQuestions};
  }

  Answer answer(Question question, std::span<const Point> points, double threshold_m) override {
    const SearchOptions options{.threshold_m = threshold_m};
    Answer answer;
    switch (question) {
      case Question::kAtRisk:
        answer.at_risk = value_of(find_at_risk(points, options));
        break;
      case Question::kPairs:
        answer.pairs = value_of(find_pairs(points, options));
        break;
      case Question::kNearest:
        answer.nearest = value_of(find_nearest(points));
        break;
      case Question::kCounts:
        answer.counts = value_of(count_neighbors(points, options));
        break;
    }
    return answer;
  }
};

class KeptEngine final : public Contender {
 public:
  explicit KeptEngine(unsigned threads) : threads_(threads) {}

  [[nodiscard]] Description description() const override {
    const bool alone = threads_ == 1;
    return {alone ? "beespace Engine" : "beespace, " + std::to_string(threads_) + " threads",
            BEESPACE_VERSION, Arithmetic::kExact,
            alone ? "memory kept from call to call" : "an Engine; wall time", kAllQuestions};
  }

  Answer answer(Question question, std::span<const Point> points, double threshold_m) override {
    const SearchOptions options{.threshold_m = threshold_m, .threads = threads_};
    Answer answer = std::move(kept_);
    switch (question) {
      case Question::kAtRisk:
        value_of(engine_.find_at_risk(points, options, answer.at_risk));
        break;
      case Question::kPairs:
        value_of(engine_.find_pairs(points, options, answer.pairs));
        break;
      case Question::kNearest:
        value_of(engine_.find_nearest(points, answer.nearest, threads_));
        break;
      case Question::kCounts:
        value_of(engine_.count_neighbors(points, options, answer.counts));
        break;
    }
    return answer;
  }

  void take_back(Answer answer) override { kept_ = std::move(answer); }

 private:
  unsigned threads_;
  Engine engine_;
  Answer kept_;
};

}  // namespace

std::unique_ptr<Contender> make_contender(std::string_view variant) {
  if (variant == "engine") return std::make_unique<KeptEngine>(1);
  if (variant == "two_threads") return std::make_unique<KeptEngine>(2);
  return std::make_unique<Functions>();
}

}  // namespace beespace::compare
