// The methods of the paper as contenders, in metres: variant "hash", "kdtree" or "octree".
#include "bench/compare/contender.hpp"
#include "bench/compare/fail.hpp"
#include "bench/compare/text_key_hash.hpp"
#include "bench/compare/textbook_kdtree.hpp"
#include "bench/compare/textbook_octree.hpp"

#include <algorithm>

namespace beespace::compare {
namespace {

template <class Method>
class PaperMethod final : public Contender {
 public:
  explicit PaperMethod(Description description) : description_(std::move(description)) {}

  [[nodiscard]] Description description() const override { return description_; }

  Answer answer(Question /*question*/, std::span<const Point> points, double threshold_m) override {
    Method method(threshold_m);
    for (std::size_t i = 0; i < points.size(); ++i) {
      method.insert(points[i], static_cast<PointId>(i));
    }
    if constexpr (requires { method.finish(); }) method.finish();
    Answer answer;
    answer.at_risk = Method::ids(method.find());
    std::sort(answer.at_risk.begin(), answer.at_risk.end());
    return answer;
  }

 private:
  Description description_;
};

}  // namespace

std::unique_ptr<Contender> make_contender(std::string_view variant) {
  const std::vector<Question> at_risk = {Question::kAtRisk};
  if (variant == "hash") {
    return std::make_unique<PaperMethod<TextKeyHash>>(
        Description{"the paper's hash", "rebuilt", Arithmetic::kApproximate,
                    "text keys, a linked list a cell, a box test on each axis", at_risk});
  }
  if (variant == "kdtree") {
    return std::make_unique<PaperMethod<TextbookKdTree>>(
        Description{"textbook kd-tree", "rebuilt", Arithmetic::kFloat64,
                    "a node a point, medians, pointers", at_risk});
  }
  if (variant == "octree") {
    return std::make_unique<PaperMethod<TextbookOctree>>(
        Description{"textbook octree", "rebuilt", Arithmetic::kFloat64,
                    "up to 8 points a leaf, pointers", at_risk});
  }
  fail("variants: hash, kdtree, octree");
}

}  // namespace beespace::compare
