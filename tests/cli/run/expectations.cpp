#include "tests/cli/run/expectations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>

namespace beespace::cli_test {
namespace {

constexpr double kTolerance = 1e-5;

std::optional<double> number_in(const std::string& field) {
  char* end = nullptr;
  const double value = std::strtod(field.c_str(), &end);
  if (field.empty() || *end != '\0') return std::nullopt;
  return value;
}

bool alike(const std::string& field, const std::string& expected) {
  const auto a = number_in(field);
  const auto b = number_in(expected);
  return a && b ? std::abs(*a - *b) <= kTolerance : field == expected;
}

std::string shown(const TextRows& rows) {
  std::string text;
  for (const auto& row : rows) {
    for (const std::string& field : row) text += field + " | ";
    text += '\n';
  }
  return text;
}

}  // namespace

Arguments operator+(Arguments some, const Arguments& more) {
  some.insert(some.end(), more.begin(), more.end());
  return some;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> fields_of(const std::string& line, char delimiter) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == delimiter) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

TextRows rows_of(const std::string& text, char delimiter) {
  TextRows rows;
  for (const std::string& line : lines_of(text)) rows.push_back(fields_of(line, delimiter));
  if (delimiter != '\t') return rows;
  EXPECT_FALSE(rows.empty()) << "there is no header line";
  if (!rows.empty()) rows.erase(rows.begin());
  return rows;
}

void expect_rows(const TextRows& rows, const TextRows& expected) {
  const bool same = std::equal(rows.begin(), rows.end(), expected.begin(), expected.end(),
                               [](const auto& a, const auto& b) {
                                 return std::equal(a.begin(), a.end(), b.begin(), b.end(), alike);
                               });
  EXPECT_TRUE(same) << shown(rows) << "instead of\n" << shown(expected);
}

TextRows without_lasts(TextRows rows) {
  constexpr std::size_t kBegins = 2;
  constexpr std::size_t kEnds = 5;
  for (std::vector<std::string>& row : rows) {
    // In CSV dates stand behind all others.
    const auto is_date = [](const std::string& field) {
      return field == "begins" || field == "closest" || field == "ends" || field == "worst" ||
             field.ends_with('Z');
    };
    while (row.size() > kEnds + 1 && is_date(row.back())) row.pop_back();
    if (row.size() <= kEnds + 1) {
      ADD_FAILURE() << "no column says how long a conflict lasts";
      continue;
    }
    const auto begins_s = number_in(row[kBegins]);
    const auto ends_s = number_in(row[kEnds]);
    if (!begins_s || !ends_s) {
      const auto named = std::find(row.begin(), row.end(), "lasts_s");
      row.erase(named == row.end() ? row.end() - 1 : named, row.end());
      continue;
    }
    // With a vertical threshold the columns of the worst moment stand behind it, of aviation in
    // more units.
    std::size_t lasts = row.size() - 1;
    for (const std::size_t behind : {std::size_t{6}, std::size_t{4}}) {
      if (row.size() <= kEnds + 1 + behind) continue;
      const std::size_t place = row.size() - 1 - behind;
      const auto value = number_in(row[place]);
      if (value && std::abs(*value - (*ends_s - *begins_s)) <= kTolerance) {
        lasts = place;
        break;
      }
    }
    EXPECT_NEAR(number_in(row[lasts]).value_or(HUGE_VAL), *ends_s - *begins_s, kTolerance);
    row.resize(lasts);
  }
  return rows;
}

void expect_parts(const std::string& text, std::initializer_list<std::string_view> parts) {
  for (const std::string_view part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' in\n" << text;
  }
}

void expect_failure(const Arguments& arguments, std::string_view input, int exit_code,
                    const std::string& message, const Surroundings& surroundings) {
  const Finished finished = run(arguments, input, surroundings);
  EXPECT_EQ(finished.exit_code, exit_code) << finished.err;
  EXPECT_EQ(finished.out, "");
  expect_parts(finished.err, {"beespace: error: ", message});
}

void expect_usage_error(const Arguments& arguments, const std::string& message) {
  expect_failure(arguments, {}, 2, message);
}

}  // namespace beespace::cli_test
