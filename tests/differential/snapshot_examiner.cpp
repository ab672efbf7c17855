// Every query on a snapshot, by every variant, against the oracle.
#include "tests/contract/variants.hpp"
#include "tests/differential/cylinder_variants.hpp"
#include "tests/differential/described.hpp"
#include "tests/differential/examiner.hpp"
#include "tests/differential/shrink.hpp"
#include "tests/differential/snapshot_oracle.hpp"
#include "tests/differential/snapshot_scenes.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace beespace::differential {

namespace {

using test::Inquiry;
using test::Variant;

// A point and, where heights are apart, its height; of the first set or of the second.
struct Placed {
  Point point;
  double height = 0.0;
  bool theirs = false;
};

bool is_apart(const SnapshotScene& scene) {
  return !scene.subject.heights.empty() || !scene.subject.other_heights.empty();
}

// A query, with the parts of the scene that it needs.
class Asked {
 public:
  Asked(const SnapshotScene& scene, Question question, const PairOptions& options)
      : Asked(placed_of(scene), scene.subject, is_apart(scene), question, options) {}

  Asked(const std::vector<Placed>& placed, const Subject& like, bool apart, Question question,
        const PairOptions& options) {
    subject_.name = like.name;
    subject_.two_sets = like.two_sets;
    for (const Placed& one : placed) {
      (one.theirs ? subject_.others : subject_.points).push_back(one.point);
      // Heights are nothing to a question without a vertical threshold.
      if (apart && options.vertical_m) {
        (one.theirs ? subject_.other_heights : subject_.heights).push_back(one.height);
      }
    }
    inquiry_ = {&subject_, question, options};
  }
  Asked(const Asked&) = delete;
  Asked& operator=(const Asked&) = delete;
  ~Asked() = default;

  [[nodiscard]] const Inquiry& inquiry() const { return inquiry_; }
  [[nodiscard]] Answer expected() const {
    return SnapshotOracle(subject_, inquiry_.options)
        .answer(inquiry_.question, inquiry_.options.max_results);
  }
  [[nodiscard]] Answer of(const Variant& variant) const { return variant.ask(inquiry_); }

  [[nodiscard]] std::string described() const {
    std::string text = test::described(inquiry_);
    if (inquiry_.options.vertical_m) text += ", vertical " + hex(*inquiry_.options.vertical_m);
    text.append("\n  points {\n").append(differential::described(subject_.points)).append("  }\n");
    if (subject_.two_sets) {
      text.append("  others {\n").append(differential::described(subject_.others)).append("  }\n");
    }
    if (!subject_.heights.empty())
      text.append("  unit of heights ").append(hex(inquiry_.options.height_unit_m)).append("\n");
    for (const double height : subject_.heights)
      text.append("  height ").append(hex(height)).append("\n");
    for (const double height : subject_.other_heights) {
      text.append("  height of other ").append(hex(height)).append("\n");
    }
    return text;
  }

  static std::vector<Placed> placed_of(const SnapshotScene& scene) {
    std::vector<Placed> all;
    for (std::size_t i = 0; i < scene.subject.points.size(); ++i) {
      all.push_back({scene.subject.points[i],
                     scene.subject.heights.empty() ? 0.0 : scene.subject.heights[i]});
    }
    for (std::size_t i = 0; i < scene.subject.others.size(); ++i) {
      const double height =
          scene.subject.other_heights.empty() ? 0.0 : scene.subject.other_heights[i];
      all.push_back({scene.subject.others[i], height, true});
    }
    return all;
  }

 private:
  Subject subject_;
  Inquiry inquiry_;
};

const std::vector<Question> kOfOneSet = {
    Question::kAtRisk, Question::kPairs,  Question::kVisitedPairs, Question::kNeighbors,
    Question::kCounts, Question::kGroups, Question::kNearestWithin};
const std::vector<Question> kOfTwoSets = {Question::kAtRiskBetween, Question::kPairsBetween,
                                          Question::kNeighborsBetween, Question::kCountsBetween,
                                          Question::kNearestWithinBetween};

// Those that PairOptions::max_results is for.
bool is_limited(Question question) {
  return question == Question::kPairs || question == Question::kPairsBetween ||
         question == Question::kNeighbors || question == Question::kNeighborsBetween;
}

class SnapshotExaminer {
 public:
  explicit SnapshotExaminer(bool upright) : upright_(upright) {}

  std::optional<std::string> examine(Random& random, Tally& tally) {
    tally.scene();
    const SnapshotScene scene = random_snapshot(random, upright_);
    const bool two = scene.subject.two_sets;
    for (const PairOptions& options : scene.options) {
      SnapshotOracle oracle(scene.subject, options);
      for (const Question question : two ? kOfTwoSets : kOfOneSet) {
        if (auto found = ask(scene, question, options, oracle, random, tally)) return found;
      }
    }
    const PairOptions none;
    SnapshotOracle oracle(scene.subject, none);
    for (const Question question : {two ? Question::kNearestBetween : Question::kNearest,
                                    two ? Question::kClosestPairBetween : Question::kClosestPair}) {
      if (auto found = ask(scene, question, none, oracle, random, tally)) return found;
    }
    return std::nullopt;
  }

 private:
  std::optional<std::string> ask(const SnapshotScene& scene, Question question, PairOptions options,
                                 SnapshotOracle& oracle, Random& random, Tally& tally) {
    if (is_limited(question) && random.once_in(4)) {
      // Exactly as many as there are, or one fewer.
      const std::size_t pairs = oracle.pairs();
      const bool twice = question == Question::kNeighbors;
      options.max_results = std::max<std::size_t>(1, twice ? 2 * pairs : pairs) - random.below(2);
    }
    const Asked asked(scene, question, options);
    const Answer expected = oracle.answer(question, options.max_results);
    for (const Variant* variant : some_variants(asked.inquiry(), random)) {
      tally.answer(name_of(scene, question, options));
      if (asked.of(*variant) != expected) return difference(scene, asked, *variant);
    }
    return std::nullopt;
  }

  static std::string name_of(const SnapshotScene& scene, Question question,
                             const PairOptions& options) {
    std::string name = test::name_of(question);
    if (scene.subject.two_sets) name += ", two sets";
    if (options.vertical_m) name += ", vertical";
    return name;
  }

  // Brute force and the plain functions always, of all the others a few: over many scenes every one
  // meets everything. Those with threads are for swarms that are large enough to be shared.
  std::vector<const Variant*> some_variants(const Inquiry& inquiry, Random& random) {
    const bool large = inquiry.subject->points.size() >= 2000;
    const std::vector<Variant>& all = large ? with_threads_ : variants_;
    std::vector<const Variant*> some = {&brute_force_, &plain_};
    if (large) some.erase(some.begin());
    for (std::size_t i = 0; i < (large ? 2U : 5U); ++i) {
      const Variant& variant = random.one_of(all);
      if (!asks(variant, inquiry.question)) continue;
      if (inquiry.options.vertical_m && is_forced(variant)) continue;
      some.push_back(&variant);
    }
    if (inquiry.options.vertical_m) some.push_back(&random.one_of(upright_variants_));
    return some;
  }

  // The forced variants of the contract get their grids from outside, which know only spheres.
  static bool is_forced(const Variant& variant) {
    return variant.name.rfind("Functions", 0) != 0 && variant.name.rfind("Engine", 0) != 0;
  }

  static std::optional<std::string> difference(const SnapshotScene& scene, const Asked& asked,
                                               const Variant& variant) {
    const bool apart = is_apart(scene);
    const Inquiry& inquiry = asked.inquiry();
    const auto small = shrunk(Asked::placed_of(scene), [&](const std::vector<Placed>& placed) {
      const Asked less(placed, scene.subject, apart, inquiry.question, inquiry.options);
      return less.of(variant) != less.expected();
    });
    const Asked least(small, scene.subject, apart, inquiry.question, inquiry.options);
    return variant.name + " answers wrongly: " + least.described() + "  expected" +
           differential::described(least.expected()) + "\n  got     " +
           differential::described(least.of(variant)) + "\n";
  }

  bool upright_;
  const Variant brute_force_ = test::brute_force_reference();
  const Variant plain_ = test::public_functions(1);
  const std::vector<Variant> variants_ = test::contract_variants();
  const std::vector<Variant> upright_variants_ = forced_cylinders();
  const std::vector<Variant> with_threads_ = test::variants_with_threads();
};

}  // namespace

Examiner snapshot_examiner(const std::string& name, bool upright) {
  const auto kept = std::make_shared<SnapshotExaminer>(upright);
  return {name, [kept](Random& random, Tally& tally) { return kept->examine(random, tally); }};
}

}  // namespace beespace::differential
