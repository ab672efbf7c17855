// A long call ends soon where its stop is requested or its poll says so, with no answer; and what
// is short is never polled.
#include "tests/c/c_scenes.hpp"
#include "tests/support/scene_maker.hpp"

#include <beespace.h>
#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <thread>
#include <vector>

namespace beespace::test {
namespace {

// So many pairs that no machine shows them all within a second.
std::vector<Point> crowd() {
  return SceneMaker(3).box(100'000, {0, 0, 0}, {1, 1, 1});
}

int go_on(void* /*data*/, const std::int64_t* /*first*/, const std::int64_t* /*second*/,
          const double* /*distances*/, std::int64_t /*count*/) {
  return 1;
}

class CStop : public testing::Test {
 protected:
  beespace_code visit_pairs_of(const std::vector<Point>& points) {
    const beespace_points given = c_points(points);
    const beespace_search search = c_search(0.4);
    return beespace_visit_pairs(nullptr, &given, &search, &run_, go_on, nullptr, &error_);
  }
  beespace_code find_pairs_of(const std::vector<Point>& points) {
    const beespace_points given = c_points(points);
    const beespace_search search = c_search(1.0);
    return beespace_pairs(nullptr, &given, nullptr, &search, &run_, result_.get(), &error_);
  }

  beespace_run run_ = [] {
    beespace_run run{};
    run.struct_size = sizeof run;
    return run;
  }();
  beespace_error error_ = c_error();
  Owned<beespace_stop> stop_{beespace_stop_create()};
  Owned<beespace_result> result_{beespace_result_create()};
};

TEST_F(CStop, EndsCallsThatRunAndThoseThatBeginLater) {
  run_.stop = stop_.get();
  std::thread other([this] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    beespace_stop_request(stop_.get());
  });
  EXPECT_EQ(visit_pairs_of(crowd()), BEESPACE_STOPPED);
  other.join();
  EXPECT_EQ(error_.code, BEESPACE_STOPPED);
  EXPECT_EQ(find_pairs_of({{0, 0, 0}, {0, 0, 0.5}}), BEESPACE_STOPPED);
  EXPECT_EQ(columns(result_), Columns());
}

struct Polls {
  std::thread::id caller = std::this_thread::get_id();
  int count = 0;
  int stop_at = 2;
  bool elsewhere = false;
};

int poll(void* data) {
  auto& polls = *static_cast<Polls*>(data);
  polls.elsewhere = polls.elsewhere || polls.caller != std::this_thread::get_id();
  return ++polls.count >= polls.stop_at ? 1 : 0;
}

TEST_F(CStop, PollsAreCalledOnTheCallingThreadAndEndTheCall) {
  Polls polls;
  run_.poll = poll;
  run_.poll_data = &polls;
  EXPECT_EQ(visit_pairs_of(crowd()), BEESPACE_STOPPED);
  EXPECT_GE(polls.count, 2);
  EXPECT_FALSE(polls.elsewhere);
}

int poll_until_shown(void* data) {
  static_cast<std::atomic<bool>*>(data)->store(true);
  return 1;
}

int wait_for_poll(void* data, const std::int64_t* /*first*/, const std::int64_t* /*second*/,
                  const double* /*distances*/, std::int64_t /*count*/) {
  while (!static_cast<std::atomic<bool>*>(data)->load()) std::this_thread::yield();
  return 1;
}

TEST_F(CStop, APollThatComesTooLateIsHeardAllTheSame) {
  std::atomic<bool> polled = false;
  run_.poll = poll_until_shown;
  run_.poll_data = &polled;
  const std::vector<Point> points(2);
  const beespace_points given = c_points(points);
  const beespace_search search = c_search(1.0);
  // The only pair waits for the poll, so the search is complete when the stop comes.
  EXPECT_EQ(beespace_visit_pairs(nullptr, &given, &search, &run_, wait_for_poll, &polled, &error_),
            BEESPACE_STOPPED);
}

TEST_F(CStop, AStopEndsCallsThatArePolledToo) {
  Polls polls;
  polls.stop_at = 1'000'000;
  run_.poll = poll;
  run_.poll_data = &polls;
  run_.stop = stop_.get();
  beespace_stop_request(stop_.get());
  EXPECT_EQ(visit_pairs_of(crowd()), BEESPACE_STOPPED);
}

TEST_F(CStop, ShortCallsWithAPollHaveTheirAnswer) {
  Polls polls;
  run_.poll = poll;
  run_.poll_data = &polls;
  ASSERT_EQ(find_pairs_of({{0, 0, 0}, {0, 0, 0.5}}), BEESPACE_OK) << error_.message;
  EXPECT_EQ(columns(result_), columns_of(std::vector<Pair>{{0, 1}}));
  SceneMaker make(4);
  const std::vector<Point> points = make.box(2000, {0, 0, 0}, {20, 20, 20});
  const auto expected = find_pairs(points, PairOptions{.threshold_m = 1.0});
  polls.stop_at = 1'000'000;
  ASSERT_EQ(find_pairs_of(points), BEESPACE_OK);
  EXPECT_EQ(columns(result_), columns_of(*expected));
}

TEST(CThreads, EachWithHandlesOfItsOwnHaveTheirAnswers) {
  SceneMaker make(9);
  const std::vector<Point> points = make.box(3000, {0, 0, 0}, {60, 60, 60});
  const beespace_points given = c_points(points);
  const beespace_search search = c_search(2.0);
  const Columns expected = columns_of(*find_pairs(points, PairOptions{.threshold_m = 2.0}));
  std::atomic<int> same = 0;
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 8; ++thread) {
    threads.emplace_back([&] {
      const Owned<beespace_engine> engine(beespace_engine_create());
      const Owned<beespace_result> result(beespace_result_create());
      for (int round = 0; round < 5; ++round) {
        if (beespace_pairs(engine.get(), &given, nullptr, &search, nullptr, result.get(),
                           nullptr) == BEESPACE_OK &&
            columns(result) == expected) {
          ++same;
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(same, 40);
}

}  // namespace
}  // namespace beespace::test
