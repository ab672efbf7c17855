// beespace's own reference: every pair, compared exactly. For small swarms, to check all others.
#include "bench/compare/contender.hpp"

#include <beespace/brute_force.hpp>
#include <beespace/version.hpp>

namespace beespace::compare {
namespace {

class BruteForce final : public Contender {
 public:
  [[nodiscard]] Description description() const override {
    return {"brute force",
            BEESPACE_VERSION,
            Arithmetic::kExact,
            "every pair, compared exactly",
            {Question::kAtRisk, Question::kPairs, Question::kNearest, Question::kCounts}};
  }

  Answer answer(Question question, std::span<const Point> points, double threshold_m) override {
    const SearchOptions options{.threshold_m = threshold_m};
    Answer answer;
    switch (question) {
      case Question::kAtRisk:
        answer.at_risk = *brute_force::find_at_risk(points, options);
        break;
      case Question::kPairs:
        answer.pairs = *brute_force::find_pairs(points, options);
        break;
      case Question::kNearest:
        answer.nearest = *brute_force::find_nearest(points);
        break;
      case Question::kCounts:
        answer.counts = *brute_force::count_neighbors(points, options);
        break;
    }
    return answer;
  }
};

}  // namespace

std::unique_ptr<Contender> make_contender(std::string_view) {
  return std::make_unique<BruteForce>();
}

}  // namespace beespace::compare
