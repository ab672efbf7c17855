#include "bench/compare/answer.hpp"

#include "bench/compare/fail.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>

namespace beespace::compare {
namespace {

struct Header {
  std::uint64_t size = 0;         // entries of the answer
  std::uint64_t fingerprint = 0;  // of pairs: independent of their order
  std::uint64_t kept = 0;         // entries that follow
};

std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30u)) * 0xBF58'476D'1CE4'E5B9u;
  bits = (bits ^ (bits >> 27u)) * 0x94D0'49BB'1331'11EBu;
  return bits ^ (bits >> 31u);
}

std::uint64_t fingerprint(const std::vector<Pair>& pairs) {
  std::uint64_t sum = 0;
  for (const Pair& pair : pairs) sum += mixed((std::uint64_t{pair.first} << 32u) | pair.second);
  return sum;
}

template <class Entry>
void write(const std::string& path, const std::vector<Entry>& entries, Header header) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(&header), sizeof header);
  file.write(reinterpret_cast<const char*>(entries.data()),
             static_cast<std::streamsize>(header.kept * sizeof(Entry)));
  if (!file.flush()) fail("cannot write " + path);
}

template <class Entry>
std::vector<Entry> read(const std::string& path, Header& header) {
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(&header), sizeof header);
  std::vector<Entry> entries(file ? header.kept : 0);
  file.read(reinterpret_cast<char*>(entries.data()),
            static_cast<std::streamsize>(entries.size() * sizeof(Entry)));
  if (!file) fail("cannot read the reference answer " + path);
  return entries;
}

template <class Entry>
Difference difference_of_sets(const std::vector<Entry>& found, const std::vector<Entry>& expected) {
  Difference result;
  auto f = found.begin();
  auto e = expected.begin();
  while (f != found.end() && e != expected.end()) {
    if (*f == *e) {
      ++f;
      ++e;
    } else if (*f < *e) {
      ++f;
      ++result.spurious;
    } else {
      ++e;
      ++result.missed;
    }
  }
  result.spurious += static_cast<std::uint64_t>(found.end() - f);
  result.missed += static_cast<std::uint64_t>(expected.end() - e);
  return result;
}

Difference difference_of_counts(const std::vector<std::uint32_t>& found,
                                const std::vector<std::uint32_t>& expected) {
  if (found.size() != expected.size()) return {found.size(), expected.size()};
  Difference result;
  for (std::size_t i = 0; i < found.size(); ++i)
    result.spurious += found[i] == expected[i] ? 0u : 1u;
  return result;
}

bool is_nearest(std::span<const Point> points, std::size_t self, const Nearest& found,
                const Nearest& expected) {
  if (found.id == Nearest::kNone || expected.id == Nearest::kNone) {
    return found.id == expected.id;
  }
  if (found.id >= points.size() || found.id == self) return false;
  const double distance_m = distance(points[self], points[found.id]);
  return std::fabs(distance_m - expected.distance_m) <= 1e-12 * expected.distance_m;
}

Difference difference_of_nearest(std::span<const Point> points, const std::vector<Nearest>& found,
                                 const std::vector<Nearest>& expected) {
  if (found.size() != expected.size()) return {found.size(), expected.size()};
  Difference result;
  for (std::size_t i = 0; i < found.size(); ++i) {
    result.spurious += is_nearest(points, i, found[i], expected[i]) ? 0u : 1u;
  }
  return result;
}

Difference difference_of_pairs(const std::string& path, std::vector<Pair>& pairs) {
  Header header;
  const auto expected = read<Pair>(path, header);
  if (header.kept == header.size && pairs.size() <= kMostPairsKept) {
    std::sort(pairs.begin(), pairs.end());
    return difference_of_sets(pairs, expected);
  }
  const std::uint64_t size = pairs.size();
  if (size != header.size) {
    return {size > header.size ? size - header.size : 0,
            size < header.size ? header.size - size : 0};
  }
  return fingerprint(pairs) == header.fingerprint ? Difference{} : Difference{1, 1};
}

}  // namespace

std::uint64_t size_of(const Answer& answer, Question question) {
  switch (question) {
    case Question::kAtRisk:
      return answer.at_risk.size();
    case Question::kPairs:
      return answer.pairs.size();
    case Question::kNearest:
      return static_cast<std::uint64_t>(
          std::count_if(answer.nearest.begin(), answer.nearest.end(),
                        [](const Nearest& one) { return one.id != Nearest::kNone; }));
    case Question::kCounts:
      break;
  }
  return std::accumulate(answer.counts.begin(), answer.counts.end(), std::uint64_t{0});
}

std::vector<PointId> ids_of_marks(const std::vector<char>& marks) {
  std::vector<PointId> ids;
  ids.reserve(static_cast<std::size_t>(std::count(marks.begin(), marks.end(), char{1})));
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (marks[i] != 0) ids.push_back(static_cast<PointId>(i));
  }
  return ids;
}

void keep_reference(const std::string& path, Question question, Answer& answer) {
  const auto keep = [&](const auto& entries) {
    write(path, entries, {entries.size(), 0, entries.size()});
  };
  switch (question) {
    case Question::kAtRisk:
      return keep(answer.at_risk);
    case Question::kNearest:
      return keep(answer.nearest);
    case Question::kCounts:
      return keep(answer.counts);
    case Question::kPairs:
      break;
  }
  std::vector<Pair>& pairs = answer.pairs;
  const bool whole = pairs.size() <= kMostPairsKept;
  if (whole) std::sort(pairs.begin(), pairs.end());
  write(path, pairs, {pairs.size(), fingerprint(pairs), whole ? pairs.size() : 0});
}

Difference difference_from_reference(const std::string& path, Question question,
                                     std::span<const Point> points, Answer& answer) {
  Header header;
  switch (question) {
    case Question::kAtRisk:
      return difference_of_sets(answer.at_risk, read<PointId>(path, header));
    case Question::kNearest:
      return difference_of_nearest(points, answer.nearest, read<Nearest>(path, header));
    case Question::kCounts:
      return difference_of_counts(answer.counts, read<std::uint32_t>(path, header));
    case Question::kPairs:
      break;
  }
  return difference_of_pairs(path, answer.pairs);
}

Difference difference(const std::vector<PointId>& found, const std::vector<PointId>& expected) {
  return difference_of_sets(found, expected);
}

}  // namespace beespace::compare
