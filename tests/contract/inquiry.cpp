#include "tests/contract/inquiry.hpp"

#include "tests/support/exact_oracle.hpp"
#include "tests/support/random_scenes.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/search_scenes.hpp"

#include <beespace/brute_force.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <tuple>
#include <utility>

namespace beespace::test {

namespace {

// Brute force is expensive: larger scenes are tested at fewer radii.
constexpr std::size_t kSmallScene = 420;

// Two points of a scene, and how far apart they are, roughly.
struct Chord {
  double length = 0.0;
  std::size_t first = 0;
  std::size_t second = 0;
};

// The shortest distance, the next shorter and the next longer than the threshold, and one that an
// eighth of the pairs are within: the real distances that decide differently from scene to scene.
std::vector<Chord> telling_chords(const SearchScene& scene) {
  constexpr double kNotTheSame = 1.0 + 0x1p-40;
  Chord shortest{std::numeric_limits<double>::infinity()};
  Chord shorter{0.0};
  Chord longer{std::numeric_limits<double>::infinity()};
  std::vector<Chord> some;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    for (std::size_t j = i + 1; j < scene.points.size(); ++j) {
      const Chord chord{distance(scene.points[i], scene.points[j]), i, j};
      if (chord.length == 0.0) continue;
      if (chord.length < shortest.length) shortest = chord;
      if (chord.length * kNotTheSame < scene.threshold_m && chord.length > shorter.length) {
        shorter = chord;
      }
      if (chord.length > scene.threshold_m * kNotTheSame && chord.length < longer.length) {
        longer = chord;
      }
      if ((i * 7 + j) % 5 == 0) some.push_back(chord);
    }
  }
  std::vector<Chord> chords = {shorter, longer, shortest};
  if (!some.empty()) {
    const auto eighth = some.begin() + static_cast<std::ptrdiff_t>(some.size() / 8);
    std::nth_element(some.begin(), eighth, some.end(), [](const Chord& a, const Chord& b) {
      return std::tie(a.length, a.first, a.second) < std::tie(b.length, b.first, b.second);
    });
    chords.push_back(*eighth);
  }
  std::erase_if(chords, [](const Chord& chord) { return chord.first == chord.second; });
  return chords;
}

void add_with_neighbors(std::vector<double>& thresholds, double distance) {
  for (const double one : {std::nextafter(distance, 0.0), distance,
                           std::nextafter(distance, std::numeric_limits<double>::infinity())}) {
    if (one >= kSmallestCoordinate_m && one <= kLargestCoordinate_m) thresholds.push_back(one);
  }
}

std::vector<double> thresholds_of(const SearchScene& scene) {
  std::vector<double> thresholds;
  add_with_neighbors(thresholds, scene.threshold_m);
  std::vector<Chord> chords = telling_chords(scene);
  if (scene.points.size() > kSmallScene && chords.size() > 1) chords.resize(1);
  for (const Chord& chord : chords) {
    add_with_neighbors(thresholds,
                       rounded_distance(scene.points[chord.first], scene.points[chord.second]));
  }
  std::sort(thresholds.begin(), thresholds.end());
  thresholds.erase(std::unique(thresholds.begin(), thresholds.end()), thresholds.end());
  return thresholds;
}

void add_random_subjects(std::vector<Subject>& all) {
  constexpr std::uint32_t kScenes = 150;
  for (std::uint32_t number = 0; number < kScenes; ++number) {
    SearchScene scene = random_scene(number);
    TwoSets sets = split(scene.points, kSplits[number % 2]);
    all.push_back({scene.name + ", " + name_of(kSplits[number % 2]),
                   std::move(sets.points),
                   std::move(sets.others),
                   true,
                   {scene.threshold_m}});
    all.push_back({scene.name, std::move(scene.points), {}, false, {scene.threshold_m}});
  }
}

std::vector<Subject> make_subjects() {
  std::vector<Subject> all;
  for (SearchScene& scene : search_scenes()) {
    const std::vector<double> thresholds = thresholds_of(scene);
    const std::vector<double> one = {scene.threshold_m};
    for (const Split how : kSplits) {
      const bool every = how == Split::kEvenAndOdd && scene.points.size() <= kSmallScene;
      TwoSets sets = split(scene.points, how);
      all.push_back({scene.name + ", " + name_of(how), std::move(sets.points),
                     std::move(sets.others), true, every ? thresholds : one});
    }
    all.push_back({scene.name, std::move(scene.points), {}, false, thresholds});
  }
  add_random_subjects(all);
  return all;
}

void add_questions_of_radius(const Subject& subject, const PairOptions& options,
                             std::vector<Inquiry>& all) {
  if (subject.two_sets) {
    for (const Question question :
         {Question::kAtRiskBetween, Question::kPairsBetween, Question::kNeighborsBetween,
          Question::kCountsBetween, Question::kNearestWithinBetween}) {
      all.push_back({&subject, question, options});
    }
    return;
  }
  for (const Question question : {Question::kAtRisk, Question::kPairs, Question::kNeighbors,
                                  Question::kCounts, Question::kGroups, Question::kNearestWithin}) {
    all.push_back({&subject, question, options});
  }
  if (options.inclusive) all.push_back({&subject, Question::kVisitedPairs, options});
}

// As many results as there are is not too many; one fewer allowed is.
void add_questions_of_limits(const Subject& subject, PairOptions options,
                             std::vector<Inquiry>& all) {
  const std::size_t pairs =
      subject.two_sets
          ? brute_force::find_pairs_between(subject.points, subject.others, options).value().size()
          : brute_force::find_pairs(subject.points, options).value().size();
  const auto add = [&](Question question, std::size_t results) {
    for (const std::size_t fewer : {0U, 1U}) {
      if (results < fewer) continue;
      options.max_results = results - fewer;
      all.push_back({&subject, question, options});
    }
  };
  if (subject.two_sets) {
    add(Question::kPairsBetween, pairs);
    add(Question::kNeighborsBetween, pairs);
  } else {
    add(Question::kPairs, pairs);
    add(Question::kNeighbors, 2 * pairs);
  }
}

std::vector<Inquiry> make_inquiries() {
  std::vector<Inquiry> all;
  for (const Subject& subject : subjects()) {
    const bool two = subject.two_sets;
    all.push_back({&subject, two ? Question::kNearestBetween : Question::kNearest, {}});
    all.push_back({&subject, two ? Question::kClosestPairBetween : Question::kClosestPair, {}});
    for (const double threshold : subject.thresholds) {
      for (const bool inclusive : {false, true}) {
        add_questions_of_radius(subject, {threshold, inclusive}, all);
      }
    }
    const double middle = subject.thresholds[subject.thresholds.size() / 2];
    add_questions_of_limits(subject, {middle, true}, all);
  }
  if (!kSanitized) return all;
  // Brute force takes most of their time there.
  std::vector<Inquiry> some;
  for (std::size_t i = 0; i < all.size(); i += 7) some.push_back(all[i]);
  return some;
}

}  // namespace

const char* name_of(Question question) {
  switch (question) {
    case Question::kAtRisk:
    case Question::kAtRiskBetween:
      return "at risk";
    case Question::kPairs:
    case Question::kPairsBetween:
      return "pairs";
    case Question::kVisitedPairs:
      return "visited pairs";
    case Question::kNeighbors:
    case Question::kNeighborsBetween:
      return "neighbours";
    case Question::kCounts:
    case Question::kCountsBetween:
      return "counts";
    case Question::kGroups:
      return "groups";
    case Question::kNearest:
    case Question::kNearestBetween:
      return "nearest";
    case Question::kNearestWithin:
    case Question::kNearestWithinBetween:
      return "nearest within";
    case Question::kClosestPair:
    case Question::kClosestPairBetween:
      return "closest pair";
  }
  return "unknown";
}

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all = make_subjects();
  return all;
}

const std::vector<Inquiry>& inquiries() {
  static const std::vector<Inquiry> all = make_inquiries();
  return all;
}

std::string described(const Inquiry& inquiry) {
  const PairOptions& options = inquiry.options;
  char radius[64];
  std::snprintf(radius, sizeof radius, " at %a m, %s", options.threshold_m,
                options.inclusive ? "inclusive" : "strict");
  std::string text = inquiry.subject->name + ": " + name_of(inquiry.question) + radius;
  if (options.max_results != PairOptions{}.max_results) {
    text += ", at most " + std::to_string(options.max_results) + " results";
  }
  return text;
}

}  // namespace beespace::test
