// Pages that C makes: of files, of points that were read, of points in memory.
#include "tests/c_io/test_file.hpp"

#include <beespace.h>
#include <beespace_io.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::test {
namespace {

constexpr std::string_view kSwarm =
    "id,x [m],y [m],z [m]\nanna,0,0,0\nbert,3,4,0\ncora,50,0,0\ndora,50,0,9\n";

struct MadePage {
  Page page;
  beespace_code code = BEESPACE_OK;
  beespace_io_error error = io_error();

  [[nodiscard]] std::string html() const {
    std::size_t size = 0;
    const char* const text = beespace_io_page_html(page.get(), &size);
    return {text, size};
  }
};

// Each ends with the page and the error.
template <class Make, class... Arguments>
MadePage make(Make&& function, Arguments... arguments) {
  MadePage made;
  beespace_io_page* page = nullptr;
  made.code = function(arguments..., &page, &made.error);
  made.page.reset(page);
  return made;
}

class CPage : public testing::Test {
 protected:
  CPage() {
    options_.struct_size = sizeof options_;
    options_.threshold_m = 6.0;
    if (of_memory({0, 0, 0, 1, 1, 1}).code == BEESPACE_INVALID_ARGUMENT) {
      has_pages_ = false;  // -DBEESPACE_WEB=OFF
    }
  }
  void SetUp() override {
    if (!has_pages_) GTEST_SKIP() << "this build has no pages";
  }
  MadePage of_file(const std::string& path, const beespace_io_options* reading = nullptr) {
    const char* const paths[] = {path.c_str()};
    return make(beespace_io_page_of_files, paths, std::int64_t{1}, reading, &options_);
  }
  MadePage of_memory(const std::vector<double>& xyz, const char* const* ids = nullptr) {
    const auto points =
        beespace_points_interleaved(xyz.data(), static_cast<std::int64_t>(xyz.size() / 3));
    return make(beespace_io_page_of_points, &points, ids, &options_);
  }
  static std::string content_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  TestFolder folder_;
  beespace_io_page_options options_{};
  bool has_pages_ = true;
};

TEST_F(CPage, OfAFileIsHtml) {
  const std::string path = folder_.file("swarm.csv", kSwarm);
  const auto made = of_file(path);
  ASSERT_EQ(made.code, BEESPACE_OK) << text_of(made.error);
  const std::string html = made.html();
  EXPECT_EQ(html.substr(0, 15), "<!doctype html>");
  EXPECT_NE(html.find("swarm.csv"), std::string::npos);
  EXPECT_EQ(html.find('\0'), std::string::npos);
  EXPECT_EQ(beespace_io_page_risky(made.page.get()), 1);
  EXPECT_GT(beespace_io_page_note_count(made.page.get()), 0);
  EXPECT_STRNE(beespace_io_page_note(made.page.get(), 0), "");
  EXPECT_EQ(beespace_io_page_note(made.page.get(), 100), nullptr);
}

TEST_F(CPage, OfPointsThatWereReadIsThatOfTheirFile) {
  const std::string path = folder_.file("swarm.csv", kSwarm);
  const auto read = read_points(path);
  ASSERT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
  for (const double threshold_m : {6.0, 4.0, 1000.0}) {
    options_.threshold_m = threshold_m;
    const auto made = make(beespace_io_page_of_read, read.points.get(), &options_);
    ASSERT_EQ(made.code, BEESPACE_OK) << text_of(made.error);
    EXPECT_EQ(made.html(), of_file(path).html());
    EXPECT_EQ(beespace_io_page_risky(made.page.get()), threshold_m > 5.0 ? 1 : 0);
  }
}

TEST_F(CPage, OfPointsWithBadRecordsIsThatOfTheirFile) {
  const std::string path = folder_.file("swarm.csv", "x [m],y [m]\n0,0\nx,1\n3,4\n4,4,4\n90,0\n");
  auto reading = io_options();
  reading.flags = BEESPACE_IO_SKIP_BAD;
  const auto read = read_points(path, &reading);
  ASSERT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
  const auto made = make(beespace_io_page_of_read, read.points.get(), &options_);
  ASSERT_EQ(made.code, BEESPACE_OK) << text_of(made.error);
  EXPECT_EQ(made.html(), of_file(path, &reading).html());
  options_.threshold_m = 1.0;  // none of the others is at risk
  EXPECT_EQ(beespace_io_page_risky(of_file(path, &reading).page.get()), 1);
}

TEST_F(CPage, OfDegreesThatWereReadIsThatOfTheirFile) {
  const std::string path = folder_.file(
      "swarm.csv", "id,lon_deg,lat_deg,height_m\na,8,47,100\nb,8.0001,47,100\nc,8,47,400\n");
  const auto read = read_points(path);
  ASSERT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
  const auto made = make(beespace_io_page_of_read, read.points.get(), &options_);
  ASSERT_EQ(made.code, BEESPACE_OK) << text_of(made.error);
  EXPECT_EQ(made.html(), of_file(path).html());
  options_.vertical = "50";
  const auto apart = make(beespace_io_page_of_read, read.points.get(), &options_);
  EXPECT_EQ(apart.code, BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(apart.error.place, "page_options");
  EXPECT_EQ(of_file(path).code, BEESPACE_OK);
}

TEST_F(CPage, OfPointsInMemoryHasTheirNamesAndTitle) {
  const char* const ids[] = {"first-one", "", "third \"<one>\""};
  options_.title = "My <swarm>";
  const std::vector<double> xyz = {0, 0, 0, 3, 4, 0, 100, 0, 0};
  const auto made = of_memory(xyz, ids);
  ASSERT_EQ(made.code, BEESPACE_OK) << text_of(made.error);
  // Names stand in the page packed; python/tests/test_report.py reads them.
  const std::string html = made.html();
  EXPECT_EQ(html.find("My <swarm>"), std::string::npos);  // it is no markup
  EXPECT_NE(html.find("My \\u003cswarm\\u003e"), std::string::npos);
  EXPECT_NE(html, of_memory(xyz).html());
  const char* const missing[] = {"a", nullptr, "c"};
  EXPECT_EQ(of_memory(xyz, missing).code, BEESPACE_INVALID_ARGUMENT);
}

TEST_F(CPage, OfARecordingShowsWhatIsUnknown) {
  const std::string path =
      folder_.file("flight.csv",
                   "id,time_s,x [m],y [m],z [m]\na,0,0,0,0\na,1,1,0,0\na,2,2,0,0\na,100,3,0,0\n"
                   "b,0,90,0,0\nb,1,91,0,0\nb,2,92,0,0\nb,100,93,0,0\n");
  const auto made = of_file(path);
  ASSERT_EQ(made.code, BEESPACE_OK) << text_of(made.error);
  EXPECT_EQ(beespace_io_page_risky(made.page.get()), 1);
  options_.max_gap_s = std::numeric_limits<double>::infinity();
  EXPECT_EQ(beespace_io_page_risky(of_file(path).page.get()), 0);
  options_.max_gap_s = -1;
  EXPECT_EQ(of_file(path).code, BEESPACE_INVALID_ARGUMENT);
}

TEST_F(CPage, IsWrittenButNotOverItsInput) {
  const std::string path = folder_.file("swarm.csv", kSwarm);
  const auto made = of_file(path);
  ASSERT_EQ(made.code, BEESPACE_OK) << text_of(made.error);
  auto error = io_error();
  const std::string output = folder_.path("page.html");
  ASSERT_EQ(beespace_io_page_write(made.page.get(), output.c_str(), &error), BEESPACE_OK);
  EXPECT_EQ(content_of(output), made.html());
  EXPECT_EQ(beespace_io_page_write(made.page.get(), path.c_str(), &error),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(content_of(path), kSwarm);
  EXPECT_EQ(beespace_io_page_write(made.page.get(), folder_.path("none/p.html").c_str(), &error),
            BEESPACE_WRITE_FAILED);
  EXPECT_EQ(beespace_io_page_write(nullptr, output.c_str(), &error), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_io_page_write(made.page.get(), nullptr, &error), BEESPACE_INVALID_ARGUMENT);
}

TEST_F(CPage, OfACrowdEndsWhenAStopIsRequested) {
  // All within the threshold of all: the worst pairs of so many take minutes.
  std::vector<double> crowd;
  for (int i = 0; i < 300'000; ++i) crowd.insert(crowd.end(), {1e-6 * i, 0.0, 0.0});
  beespace_run run = {};
  run.struct_size = sizeof run;
  int asked = 0;
  run.poll = [](void* data) { return ++*static_cast<int*>(data) == 3 ? 1 : 0; };
  run.poll_data = &asked;
  options_.run = &run;
  const MadePage polled = of_memory(crowd);
  EXPECT_EQ(polled.code, BEESPACE_STOPPED) << polled.error.message;
  EXPECT_EQ(polled.page, nullptr);
  EXPECT_GE(asked, 3);

  const std::unique_ptr<beespace_stop, decltype(&beespace_stop_free)> stop(beespace_stop_create(),
                                                                           &beespace_stop_free);
  beespace_stop_request(stop.get());
  run = {};
  run.struct_size = sizeof run;
  run.stop = stop.get();
  EXPECT_EQ(of_memory(crowd).code, BEESPACE_STOPPED);
  EXPECT_EQ(of_memory({0, 0, 0, 0, 0, 1}).code, BEESPACE_STOPPED);
  run.struct_size = 1;
  EXPECT_EQ(of_memory({0, 0, 0, 0, 0, 1}).code, BEESPACE_INVALID_ARGUMENT);
}

TEST_F(CPage, ArgumentsThatMakeNoSenseAreRefused) {
  const std::string path = folder_.file("swarm.csv", kSwarm);
  for (const double threshold_m : {0.0, -1.0, std::nan("")}) {
    options_.threshold_m = threshold_m;
    EXPECT_EQ(of_file(path).code, BEESPACE_INVALID_THRESHOLD);
    EXPECT_EQ(of_memory({0, 0, 0}).code, BEESPACE_INVALID_THRESHOLD);
  }
  options_.threshold_m = 6;
  for (const char* const vertical : {"high", "-3", "0", "nan", "inf", "3kt"}) {
    options_.vertical = vertical;
    EXPECT_EQ(of_file(path).code, BEESPACE_INVALID_ARGUMENT) << vertical;
  }
  options_.vertical = "100ft";
  EXPECT_EQ(of_file(path).code, BEESPACE_OK);
  options_.flags = 2;
  EXPECT_EQ(of_file(path).code, BEESPACE_INVALID_ARGUMENT);
  options_.flags = 0;
  EXPECT_EQ(of_file(folder_.path("none")).code, BEESPACE_CANNOT_OPEN);
  const auto bad = of_memory({0, 0, 0, 1, std::nan(""), 0});
  EXPECT_EQ(bad.code, BEESPACE_NOT_FINITE);
  EXPECT_STREQ(bad.error.place, "points");
  EXPECT_EQ(bad.error.record, 1);
  EXPECT_EQ(
      make(beespace_io_page_of_read, static_cast<const beespace_io_points*>(nullptr), &options_)
          .code,
      BEESPACE_INVALID_ARGUMENT);
  auto error = io_error();
  EXPECT_EQ(beespace_io_page_of_read(nullptr, &options_, nullptr, &error),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(beespace_io_page_html(nullptr, nullptr), "");
  EXPECT_EQ(beespace_io_page_risky(nullptr), 0);
  EXPECT_EQ(beespace_io_page_note_count(nullptr), 0);
}

}  // namespace
}  // namespace beespace::test
