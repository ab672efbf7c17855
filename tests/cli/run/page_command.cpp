#include "tests/cli/run/page_command.hpp"

#include "tests/cli/run/expectations.hpp"

namespace beespace::cli_test {

std::size_t Page::swarms() const {
  return simdjson::dom::array(json["swarms"]).size();
}

report_test::Json Page::swarm(std::size_t which) const {
  return simdjson::dom::array(json["swarms"]).at(which);
}

std::vector<double> Page::values(report_test::Json column) const {
  return report_test::values_of(column, parts.elements);
}

std::vector<std::uint64_t> Page::numbers(report_test::Json column) const {
  return report_test::numbers_of(column, parts.elements);
}

std::vector<std::string> Page::names() const {
  if (report_test::has(swarm(), "names")) {
    return report_test::column_of(swarm()["names"]["texts"], parts.elements).texts;
  }
  std::vector<std::string> numbers;
  for (std::uint64_t bee = 0; bee < std::uint64_t(swarm()["count"]); ++bee) {
    numbers.push_back(std::to_string(bee));
  }
  return numbers;
}

Page reported(const Arguments& arguments, std::string_view input) {
  const Finished finished = run(Arguments{"report"} + arguments, input);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  return Page(finished.out);
}

}  // namespace beespace::cli_test
