// The command's answers for the example swarm, compared line by line with brute force.
#include <gtest/gtest.h>

#include <beespace/beespace.hpp>

#include <charconv>
#include <fstream>
#include <string>

#include "tests/cli/run/below_header.hpp"
#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

std::vector<std::string> example_lines() {
  std::ifstream file(BEESPACE_EXAMPLE_DATA);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

Point parse(const std::string& line) {
  const std::size_t first = line.find(',');
  const std::size_t second = line.find(',', first + 1);
  return *to_ecef(GeographicPosition{std::stod(line.substr(0, first)),
                                     std::stod(line.substr(first + 1, second - first - 1)),
                                     std::stod(line.substr(second + 1))});
}

class BruteForce : public testing::TestWithParam<double> {
 protected:
  void SetUp() override {
    const std::vector<std::string> lines = example_lines();
    ASSERT_EQ(lines.size(), 1'001u);
    for (std::size_t i = 1; i < lines.size(); ++i) points_.push_back(parse(lines[i]));
    // The last third are the others, where there are others.
    constexpr std::size_t kOurs = 667;
    std::string ours = lines[0] + '\n';
    std::string others = ours;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      (i < kOurs ? ours : others) += lines[i + 1] + '\n';
    }
    ours_path_ = folder_.file("ours.csv", ours);
    others_path_ = folder_.file("others.csv", others);
    ours_.assign(points_.begin(), points_.begin() + kOurs);
    others_.assign(points_.begin() + kOurs, points_.end());
    options_.threshold_m = GetParam();
  }

  std::string said(const std::string& report) const {
    return said({BEESPACE_EXAMPLE_DATA}, report);
  }
  std::string said_between(const std::string& report) const {
    return said({ours_path_, "--others", others_path_}, report);
  }

  std::vector<Point> points_;
  std::vector<Point> ours_;
  std::vector<Point> others_;
  SearchOptions options_;

 private:
  [[nodiscard]] std::string said(const Arguments& inputs, const std::string& report) const {
    Arguments arguments = {"detect"};
    arguments.insert(arguments.end(), inputs.begin(), inputs.end());
    for (const std::string& more : {std::string("--quiet"), std::string("--threshold"),
                                    std::to_string(GetParam()), std::string("--report"), report}) {
      arguments.push_back(more);
    }
    const Finished finished = run(arguments);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    return finished.out;
  }

  TemporaryFolder folder_;
  std::string ours_path_;
  std::string others_path_;
};

std::string number(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof(text), value).ptr};
}

std::string id_lines(const std::vector<PointId>& ids) {
  std::string text;
  for (const PointId id : ids) text += std::to_string(id) + '\n';
  return text;
}

std::string pair_line(PointId first, PointId second, double distance_m) {
  return std::to_string(first) + '\t' + std::to_string(second) + '\t' + number(distance_m) + '\n';
}

std::string pair_lines(const std::vector<Pair>& pairs, const std::vector<Point>& points,
                       const std::vector<Point>& others) {
  std::string text;
  for (const Pair& pair : pairs) {
    text += pair_line(pair.first, pair.second, distance(points[pair.first], others[pair.second]));
  }
  return text;
}

// Row number, length, members.
std::string row_lines(const IdRows& rows) {
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += std::to_string(i) + '\t' + std::to_string(rows[i].size());
    for (const PointId id : rows[i]) text += '\t' + std::to_string(id);
    text += '\n';
  }
  return text;
}

std::string count_lines(const std::vector<std::uint32_t>& counts) {
  std::string text;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    text += std::to_string(i) + '\t' + std::to_string(counts[i]) + '\n';
  }
  return text;
}

std::string nearest_lines(const std::vector<Nearest>& nearest) {
  std::string text;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    text += pair_line(static_cast<PointId>(i), nearest[i].id, nearest[i].distance_m);
  }
  return text;
}

std::string closest_line(const std::optional<ClosestPair>& pair) {
  return pair ? pair_line(pair->first, pair->second, pair->distance_m) : std::string();
}

TEST_P(BruteForce, AgreesForOneSwarm) {
  EXPECT_EQ(said("at-risk"), id_lines(*brute_force::find_at_risk(points_, options_)));
  EXPECT_EQ(below_header(said("pairs")),
            pair_lines(*brute_force::find_pairs(points_, options_), points_, points_));
  EXPECT_EQ(below_header(said("neighbors")),
            row_lines(*brute_force::find_neighbors(points_, options_)));
  EXPECT_EQ(below_header(said("counts")),
            count_lines(*brute_force::count_neighbors(points_, options_)));
  EXPECT_EQ(below_header(said("nearest")), nearest_lines(*brute_force::find_nearest(points_)));
  EXPECT_EQ(below_header(said("groups")),
            row_lines(*brute_force::find_conflict_groups(points_, options_)));
  EXPECT_EQ(below_header(said("closest-pair")),
            closest_line(*brute_force::find_closest_pair(points_)));
}

TEST_P(BruteForce, AgreesForTwoSwarms) {
  EXPECT_EQ(said_between("at-risk"),
            id_lines(*brute_force::find_at_risk_between(ours_, others_, options_)));
  EXPECT_EQ(below_header(said_between("pairs")),
            pair_lines(*brute_force::find_pairs_between(ours_, others_, options_), ours_, others_));
  EXPECT_EQ(below_header(said_between("neighbors")),
            row_lines(*brute_force::find_neighbors_between(ours_, others_, options_)));
  EXPECT_EQ(below_header(said_between("counts")),
            count_lines(*brute_force::count_neighbors_between(ours_, others_, options_)));
  EXPECT_EQ(below_header(said_between("nearest")),
            nearest_lines(*brute_force::find_nearest_between(ours_, others_)));
  EXPECT_EQ(below_header(said_between("closest-pair")),
            closest_line(*brute_force::find_closest_pair_between(ours_, others_)));
}

INSTANTIATE_TEST_SUITE_P(Thresholds, BruteForce, testing::Values(10.0, 100.0, 400.0));

}  // namespace
}  // namespace beespace::cli_test
