// What waits on the disk comes back as it was, or is an error.
#include "out_of_core/cells.hpp"

#include "out_of_core/temporary_file.hpp"
#include "tests/out_of_core/damage.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace beespace::out_of_core {
namespace {

std::string folder() {
  return std::filesystem::temp_directory_path().string();
}

std::vector<Point> row_of_points(std::size_t count) {
  std::vector<Point> points(count);
  for (std::size_t index = 0; index < count; ++index) {
    points[index] = {static_cast<double>(index), -1.0, 0.5};
  }
  return points;
}

TEST(TemporaryFile, HasNoNameAndGivesBackWhatWasWritten) {
  const auto names = [] {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder())) {
      if (entry.path().filename().string().starts_with("beespace-")) ++count;
    }
    return count;
  };
  const std::size_t before = names();
  auto file = TemporaryFile::make(folder(), 100);
  ASSERT_TRUE(file);
  EXPECT_EQ(names(), before);
  std::vector<int> written(1000);
  std::iota(written.begin(), written.end(), 0);
  EXPECT_EQ(*file->append(std::as_bytes(std::span(written))), 0U);
  EXPECT_EQ(*file->append(std::as_bytes(std::span(written))), 4000U);
  std::vector<int> first(10);
  std::vector<int> rest(20);
  std::array<iovec, 3> parts = {{{first.data(), 40}, {nullptr, 0}, {rest.data(), 80}}};
  ASSERT_TRUE(file->read(4000 + 400, parts));
  EXPECT_EQ(first.front(), 100);
  EXPECT_EQ(rest.back(), 129);
  std::array<iovec, 1> beyond = {{{rest.data(), 80}}};
  EXPECT_EQ(file->read(7960, beyond).error().code, ErrorCode::kCorrupt);
}

TEST(TemporaryFile, SaysWhyThereIsNone) {
  const auto missing = TemporaryFile::make("/no/such/folder", 1);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kWriteFailed);
  EXPECT_NE(missing.error().message.find("/no/such/folder"), std::string::npos);
  const auto too_large = TemporaryFile::make(folder(), std::numeric_limits<std::uint64_t>::max());
  ASSERT_FALSE(too_large);
  EXPECT_EQ(too_large.error().code, ErrorCode::kWriteFailed);
  EXPECT_NE(too_large.error().message.find("more room"), std::string::npos);
}

TEST(TemporaryFile, AFullDiskIsAnError) {
  auto file = TemporaryFile::make(folder(), 1);
  ASSERT_TRUE(file);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit small = before;
  small.rlim_cur = 1000;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::vector<std::byte> bytes(5000);
  const auto written = file->append(bytes);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kWriteFailed);
}

class DistributedCells : public testing::Test {
 protected:
  // Cells of a row of points, of some 100 each.
  void distribute(std::size_t batch, unsigned threads) {
    auto sample = points_;
    Cut cut = Cut::of_sample(sample, 100, {1.0, 1.0, 1.0});
    StoredPoints stored;
    ASSERT_TRUE(stored.refer(PointsView(points_).with_heights(heights_)));
    auto file = TemporaryFile::make(folder(), 1);
    ASSERT_TRUE(file);
    cells_.emplace(*std::move(file), std::move(cut), stored.have_heights());
    ThreadCrew crew(threads);
    ASSERT_TRUE(cells_->distribute(stored, batch, crew, [](std::uint64_t) {}));
  }

  // Above 1000, and each another.
  void give_heights() {
    for (const Point& point : points_) heights_.push_back(1000.5 + point.x);
  }

  std::vector<Point> points_ = row_of_points(1000);
  std::vector<double> heights_;
  std::optional<Cells> cells_;
};

TEST_F(DistributedCells, HaveEachPointAtOneHomeInAscendingOrder) {
  for (const unsigned threads : {1U, 4U}) {
    distribute(37, threads);
    ASSERT_GE(cells_->size(), 10U);
    std::vector<int> homes(points_.size());
    for (std::size_t cell = 0; cell < cells_->size(); ++cell) {
      CellPoints points;
      ASSERT_TRUE(cells_->read(cells_->segments(cell), points));
      EXPECT_EQ(points.size(), cells_->count(cell));
      for (std::size_t index = 0; index < points.size(); ++index) {
        const std::uint64_t id = points.id(index);
        if (index > 0) {
          EXPECT_LT(points.id(index - 1), id);
        }
        EXPECT_EQ(points.view()[index], points_[id]);
        if (points.is_home(index)) ++homes[id];
      }
    }
    EXPECT_EQ(homes, std::vector<int>(points_.size(), 1));
  }
}

TEST_F(DistributedCells, HaveEachPointsHeight) {
  give_heights();
  distribute(37, 4);
  for (std::size_t cell = 0; cell < cells_->size(); ++cell) {
    CellPoints points;
    ASSERT_TRUE(cells_->read(cells_->segments(cell), points));
    const PointsView view = points.view();
    ASSERT_EQ(view.heights_m().size(), points.size());
    for (std::size_t index = 0; index < points.size(); ++index) {
      EXPECT_EQ(view[index], points_[points.id(index)]);
      EXPECT_EQ(view.heights_m()[index], heights_[points.id(index)]);
    }
  }
}

// A segment has all x, all y, all z, then all heights.
TEST_F(DistributedCells, TellADamagedHeight) {
  give_heights();
  distribute(1000, 1);
  const Segment& first = cells_->segments(0)[0];
  test::damage_last_temporary_file(first.offset + 3 * 8 * first.count + 9);
  CellPoints points;
  const auto status = cells_->read(cells_->segments(0), points);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kCorrupt);
}

TEST_F(DistributedCells, TellDamage) {
  for (const std::uint64_t offset : {0U, 9U, 2403U, 5000U, 20'000U}) {
    distribute(1000, 1);
    CellPoints points;
    test::damage_last_temporary_file(offset);
    std::size_t damaged = 0;
    for (std::size_t cell = 0; cell < cells_->size(); ++cell) {
      const auto status = cells_->read(cells_->segments(cell), points);
      if (status) continue;
      EXPECT_EQ(status.error().code, ErrorCode::kCorrupt);
      ++damaged;
    }
    EXPECT_EQ(damaged, 1U) << offset;
  }
}

TEST(StoredPoints, TellDamage) {
  StoredPoints stored;
  ASSERT_TRUE(stored.copy(row_of_points(1000), folder(), 300));
  ASSERT_TRUE(stored.flush());
  test::damage_last_temporary_file(100);
  PointMemory memory;
  const auto stretches = stored.stretches(1000);
  ASSERT_EQ(stretches.size(), 4U);
  EXPECT_EQ(stored.view(stretches[0], memory).error().code, ErrorCode::kCorrupt);
  EXPECT_TRUE(stored.view(stretches[1], memory));
}

TEST(StoredPoints, KeepHeights) {
  const auto points = row_of_points(1000);
  std::vector<double> heights;
  for (const Point& point : points) heights.push_back(-point.x);
  StoredPoints stored;
  ASSERT_TRUE(stored.copy(PointsView(points).with_heights(heights), folder(), 300));
  ASSERT_TRUE(stored.flush());
  EXPECT_EQ(stored.bytes_on_disk(), 1000U * 32U);
  PointMemory memory;
  std::size_t seen = 0;
  for (const Stretch& stretch : stored.stretches(1000)) {
    const auto view = stored.view(stretch, memory);
    ASSERT_TRUE(view);
    ASSERT_EQ(view->heights_m().size(), stretch.count);
    for (std::size_t index = 0; index < stretch.count; ++index) {
      EXPECT_EQ((*view)[index], points[seen]);
      EXPECT_EQ(view->heights_m()[index], heights[seen++]);
    }
  }
  EXPECT_EQ(seen, points.size());
  // The heights of a part stand behind its points.
  test::damage_last_temporary_file(300 * 24 + 10);
  EXPECT_EQ(stored.view(stored.stretches(1000)[0], memory).error().code, ErrorCode::kCorrupt);
}

TEST(StoredPoints, TakeNothingOfACallThatFails) {
  StoredPoints stored;
  ASSERT_TRUE(stored.copy(row_of_points(150), folder(), 100));
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit small = before;
  small.rlim_cur = 5000;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_FALSE(stored.copy(row_of_points(500), folder(), 100));
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(stored.size(), 150U);
  ASSERT_TRUE(stored.flush());
  std::size_t count = 0;
  for (const Stretch& stretch : stored.stretches(1000)) count += stretch.count;
  EXPECT_EQ(count, 150U);
}

}  // namespace
}  // namespace beespace::out_of_core
