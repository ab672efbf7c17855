// Shared by tests of the commands that make pages: whether this build can, and a parsed page.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/temporary_folder.hpp"
#include "tests/report/page_reader.hpp"

namespace beespace::cli_test {

// Not in a build with BEESPACE_WEB=OFF.
inline constexpr bool kHasPage = BEESPACE_HAS_PAGE != 0;

class PageCommand : public testing::Test {
 protected:
  void SetUp() override {
    if (!kHasPage) GTEST_SKIP() << "this build has no page";
  }

  TemporaryFolder folder_;
};

// A page, read. Throws where it is none.
class Page {
 public:
  explicit Page(std::string_view html) : parts(report_test::parts_of(html)), json(parts.json) {}

  [[nodiscard]] std::size_t swarms() const;
  [[nodiscard]] report_test::Json swarm(std::size_t which = 0) const;
  [[nodiscard]] report_test::Json risk() const { return swarm()["risk"]; }

  [[nodiscard]] std::vector<double> values(report_test::Json column) const;
  [[nodiscard]] std::vector<std::uint64_t> numbers(report_test::Json column) const;
  // The names of the bees: their numbers, where they have no names.
  [[nodiscard]] std::vector<std::string> names() const;

  report_test::PageParts parts;
  report_test::ParsedJson json;
};

// The page of `beespace report <arguments>`, which must do well.
Page reported(const Arguments& arguments, std::string_view input = {});

}  // namespace beespace::cli_test
