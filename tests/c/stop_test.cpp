// A long call ends soon where its stop is requested or its poll says so, with no answer; and what
// is short is never polled.
#include "tests/c/c_scenes.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scene_maker.hpp"

#include <beespace.h>
#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <functional>
#include <thread>
#include <utility>
#include <vector>

#include <pthread.h>

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

// Time that one thread has worked, whatever else the machine does.
class WorkOfThisThread {
 public:
  WorkOfThisThread() { pthread_getcpuclockid(pthread_self(), &clock_); }
  // Any thread may ask.
  [[nodiscard]] double seconds() const {
    timespec now{};
    clock_gettime(clock_, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

 private:
  clockid_t clock_{};
};

// Calls ask(run) with a stop that is requested when this thread has worked so long; says how long
// it works after that, or less than 0 where the answer was complete before.
template <class Ask>
double work_after_stop(double requested_after, const Ask& ask) {
  const WorkOfThisThread work;
  const Owned<beespace_stop> stop(beespace_stop_create());
  beespace_run run{};
  run.struct_size = sizeof run;
  run.stop = stop.get();
  std::atomic<bool> over = false;
  std::atomic<double> requested = 0.0;
  const double begin = work.seconds();
  std::thread other([&] {
    while (!over && work.seconds() - begin < requested_after)
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    beespace_stop_request(stop.get());
    requested = work.seconds();
  });
  const beespace_code code = ask(&run);
  const double end = work.seconds();
  over = true;
  other.join();
  return code == BEESPACE_STOPPED ? end - requested : -1.0;
}

// All points in one cell, each near each other one: one row of the grid has all the work, and more
// is written than searched.
TEST(CStopOfACrowd, EndsAtAnyMomentWithLittleMoreWork) {
  const std::vector<Point> crowd(kSanitized ? 2500 : 5000, Point{0.5, 0.5, 0.5});
  const beespace_points given = c_points(crowd);
  const beespace_search search = c_search(1.0, BEESPACE_DISTANCES);
  const beespace_search around = c_search(1.0);
  beespace_search upright = search;
  upright.flags |= BEESPACE_VERTICAL;
  upright.vertical_m = 1.0;
  // As far off as the threshold: nothing is near, and each two are decided exactly.
  const std::vector<Point> beside(1500, Point{1.5, 0.5, 0.5});
  const beespace_points given_beside = c_points(beside);
  const Owned<beespace_engine> engine(beespace_engine_create());
  const Owned<beespace_result> result(beespace_result_create());
  beespace_index* made = nullptr;
  ASSERT_EQ(beespace_index_create(&given, nullptr, &made, nullptr), BEESPACE_OK);
  const Owned<beespace_index> index(made);
  using Ask = std::function<beespace_code(const beespace_run*)>;
  const auto pairs_of = [&](const beespace_points* others, const beespace_search& asked) -> Ask {
    return [&, others](const beespace_run* run) {
      return beespace_pairs(engine.get(), &given, others, &asked, run, result.get(), nullptr);
    };
  };
  const std::vector<std::pair<const char*, Ask>> questions = {
      {"pairs", pairs_of(nullptr, search)},
      {"pairs of two sets", pairs_of(&given, search)},
      {"pairs in cylinders", pairs_of(nullptr, upright)},
      {"pairs exactly the threshold apart", pairs_of(&given_beside, search)},
      {"neighbours",
       [&](const beespace_run* run) {
         return beespace_neighbors(engine.get(), &given, nullptr, &search, run, result.get(),
                                   nullptr);
       }},
      {"around",
       [&](const beespace_run* run) {
         return beespace_index_around(index.get(), &given, &around, run, result.get(), nullptr);
       }},
  };
  for (const auto& [name, ask] : questions) {
    ASSERT_EQ(ask(nullptr), BEESPACE_OK);  // memory is there from now on
    const WorkOfThisThread work;
    const double begin = work.seconds();
    ASSERT_EQ(ask(nullptr), BEESPACE_OK);
    const double all = work.seconds() - begin;
    int stopped = 0;
    for (const double moment : {0.25, 0.5, 0.75}) {
      const double more = work_after_stop(all * moment, ask);
      if (more < 0.0) continue;
      ++stopped;
      EXPECT_LT(more, std::max(all / 6.0, 0.02)) << name << ", of " << all << " s";
    }
    EXPECT_GT(stopped, 0) << name;
  }
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
