// The vectors that are published for others: closest_approach must pass them itself.
#include "tests/support/exact_motion_oracle.hpp"

#include <beespace/closest_approach.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace beespace {
namespace {

// A row: fields by the names of their columns.
using Vector = std::map<std::string, std::string>;

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == ',') {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

std::vector<Vector> vectors() {
  std::ifstream file(BEESPACE_VECTORS "/closest_approach.csv");
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> names = fields_of(line);
  std::vector<Vector> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> fields = fields_of(line);
    EXPECT_EQ(fields.size(), names.size()) << line;
    if (fields.size() != names.size()) continue;
    Vector row;
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = fields[i];
    rows.push_back(row);
  }
  return rows;
}

double number(const Vector& row, const std::string& column) {
  const std::string& text = row.at(column);
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  EXPECT_TRUE(!text.empty() && *end == '\0') << column << " of " << row.at("name");
  return value;
}

Mover mover(const Vector& row, const std::string& which) {
  const auto of = [&](const std::string& begin, const std::string& unit) {
    return number(row, begin + which + unit);
  };
  return {{of("x", "_m"), of("y", "_m"), of("z", "_m")},
          {of("vx", "_mps"), of("vy", "_mps"), of("vz", "_mps")}};
}

PredictOptions options_of(const Vector& row) {
  PredictOptions options;
  options.threshold_m = number(row, "threshold_m");
  if (!row.at("vertical_m").empty()) options.vertical_m = number(row, "vertical_m");
  options.horizon_s = number(row, "horizon_s");
  options.inclusive = row.at("inclusive") == "1";
  return options;
}

TEST(ClosestApproachVectors, AreTheResultsOfClosestApproach) {
  std::size_t conflicts = 0;
  const std::vector<Vector> rows = vectors();
  ASSERT_GE(rows.size(), 280U);
  for (const Vector& row : rows) {
    SCOPED_TRACE(row.at("name"));
    const auto found =
        closest_approach(mover(row, "1"), mover(row, "2"), options_of(row).approach());
    ASSERT_TRUE(found.has_value());
    const auto expect_near = [&](double value, const char* column, const char* tolerance) {
      EXPECT_LE(std::abs(value - number(row, column)), number(row, tolerance))
          << column << " is " << value << ", not " << row.at(column);
    };
    expect_near(found->closest_s, "closest_s", "tolerance_s");
    expect_near(found->closest_m, "closest_m", "tolerance_m");
    ASSERT_EQ(found->conflict.has_value(), row.at("conflict") == "1");
    if (!found->conflict) continue;
    ++conflicts;
    expect_near(found->conflict->begins_s, "begins_s", "tolerance_s");
    expect_near(found->conflict->ends_s, "ends_s", "tolerance_s");
  }
  EXPECT_GT(conflicts, 100U);
  EXPECT_GT(rows.size() - conflicts, 100U);
}

// The oracles in Python and here share no code and agree.
TEST(ClosestApproachVectors, AreTheResultsOfTheOracle) {
  for (const Vector& row : vectors()) {
    SCOPED_TRACE(row.at("name"));
    const test::ExactEncounter truly(mover(row, "1"), mover(row, "2"), options_of(row));
    EXPECT_EQ(truly.in_conflict(), row.at("conflict") == "1");
    const test::Fraction closest = truly.closest_time();
    EXPECT_DOUBLE_EQ(number(row, "closest_s"), closest.convert_to<double>());
    const test::Wide distance = sqrt(test::wide(truly.squared_distance(closest)));
    EXPECT_DOUBLE_EQ(number(row, "closest_m"), distance.convert_to<double>());
    if (row.at("conflict") == "0") continue;
    const auto [begins, ends] = truly.conflict_span();
    EXPECT_DOUBLE_EQ(number(row, "begins_s"), begins.convert_to<double>());
    EXPECT_DOUBLE_EQ(number(row, "ends_s"), ends.convert_to<double>());
  }
}

TEST(ClosestApproachVectors, HaveNamesOfTheirOwnAndManyAtTheEdge) {
  std::set<std::string> names;
  std::map<std::string, std::string> strict;
  std::size_t different = 0;
  for (const Vector& row : vectors()) {
    EXPECT_TRUE(names.insert(row.at("name")).second) << row.at("name");
    const std::string& name = row.at("name");
    const std::size_t end = name.rfind('-');
    if (name.substr(end) == "-strict") strict[name.substr(0, end)] = row.at("conflict");
    if (name.substr(end) == "-inclusive" && strict.at(name.substr(0, end)) != row.at("conflict")) {
      ++different;
    }
  }
  EXPECT_GT(different, 15U);
}

}  // namespace
}  // namespace beespace
