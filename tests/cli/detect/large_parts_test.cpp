// What answers beyond memory wait in: rows that are sorted, texts that are looked up.
#include "cli/detect/out_of_core/sorted_rows.hpp"
#include "cli/detect/out_of_core/text_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <tuple>
#include <vector>

namespace beespace::cli {
namespace {

std::string folder() {
  return std::filesystem::temp_directory_path().string();
}

using Values = std::tuple<std::uint64_t, std::uint64_t, double>;

std::vector<Values> sorted(const std::vector<Values>& rows, std::size_t memory_bytes) {
  SortedRows sorter(folder(), memory_bytes);
  for (const auto& [first, second, distance_m] : rows) sorter.add({first, second, distance_m});
  EXPECT_EQ(sorter.size(), rows.size());
  std::vector<Values> found;
  sorter.for_each(
      [&](const LargeRow& row) { found.emplace_back(row.first, row.second, row.distance_m); });
  EXPECT_TRUE(sorter.status());
  return found;
}

TEST(LargeParts, RowsAreSortedHoweverManyRunsTheyCameIn) {
  std::mt19937_64 random(3);
  for (const std::size_t count : {0U, 1U, 255U, 256U, 257U, 512U, 20'000U}) {
    std::vector<Values> rows;
    for (std::size_t row = 0; row < count; ++row) {
      rows.emplace_back(random() % 50, (std::uint64_t{1} << 40U) + row * 7919 % 100'003,
                        0.5 * static_cast<double>(row));
    }
    auto expected = rows;
    std::sort(expected.begin(), expected.end());
    // 256 rows in memory, a few more, and all.
    for (const std::size_t bytes : {1U, 9'000U, 10'000'000U}) {
      EXPECT_EQ(sorted(rows, bytes), expected) << count << " rows in " << bytes;
    }
  }
}

TEST(LargeParts, RowsThatCannotBeWrittenAreAnError) {
  SortedRows sorter(folder() + "/missing/folder", 1);
  for (std::uint64_t row = 0; row < 1000; ++row) sorter.add({row, row, 0.0});
  std::size_t seen = 0;
  sorter.for_each([&](const LargeRow& /*row*/) { ++seen; });
  EXPECT_EQ(seen, 0U);
  ASSERT_FALSE(sorter.status());
  EXPECT_EQ(sorter.status().error().code, ErrorCode::kWriteFailed);
}

TEST(LargeParts, TextsAreThoseThatWereAdded) {
  for (const std::size_t count : {1U, 127U, 128U, 129U, 5'000U}) {
    std::vector<std::string> texts;
    for (std::size_t at = 0; at < count; ++at) {
      texts.push_back(at % 7 == 0 ? "" : std::string(at % 90, static_cast<char>('a' + at % 26)));
    }
    for (const std::size_t memory : {1U, 1'000'000U}) {
      TextStore store(folder());
      for (const std::string& text : texts) store.add(text);
      store.finish(memory);
      for (std::size_t at = 0; at < count; ++at) {
        const std::size_t there = at * 1'009 % count;
        ASSERT_EQ(store.text(there), texts[there]) << there << " of " << count;
      }
      EXPECT_TRUE(store.status());
    }
  }
}

TEST(LargeParts, TextsThatCannotBeWrittenAreAnError) {
  TextStore store(folder() + "/missing/folder");
  for (int at = 0; at < 1000; ++at) store.add("text");
  store.finish(1);
  EXPECT_EQ(store.text(3), "");
  ASSERT_FALSE(store.status());
  EXPECT_EQ(store.status().error().code, ErrorCode::kWriteFailed);
}

}  // namespace
}  // namespace beespace::cli
