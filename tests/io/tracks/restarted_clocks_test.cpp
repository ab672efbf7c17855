// A clock that begins again in a recording: two runs are not mixed in the order of time, whether
// all is read at once or some at a time.
#include "io/stream_recording.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {
namespace {

using RunTexts = std::vector<std::string>;

Result<Recording> streamed(const std::vector<std::string>& paths, const RecordingOptions& options) {
  auto stream = RecordingStream::open(paths, options, 128);
  if (!stream) return stream.error();
  std::vector<StreamedFix> fixes;
  do {
    if (const auto status = stream->next(fixes); !status) return status.error();
  } while (!fixes.empty());
  return stream->finish(0);
}

std::vector<std::string> written(const TemporaryFolder& folder, const RunTexts& texts) {
  std::vector<std::string> paths;
  for (const std::string& text : texts) {
    paths.push_back(folder.write("run" + std::to_string(paths.size()) + ".csv", text));
  }
  return paths;
}

void expect_asked(const RunTexts& texts, std::string_view part) {
  const TemporaryFolder folder;
  const auto paths = written(folder, texts);
  for (const auto& loaded : {load_recording(paths, {}), streamed(paths, {})}) {
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::kTimeOrder);
    EXPECT_NE(loaded.error().message.find(part), std::string::npos) << loaded.error().message;
  }
  for (const auto& loaded :
       {load_recording(paths, on_one_clock()), streamed(paths, on_one_clock())}) {
    if (loaded) continue;  // or times at which a bee is twice
    EXPECT_EQ(loaded.error().message.find("times begin again"), std::string::npos);
  }
}

void expect_not_asked(const RunTexts& texts) {
  const TemporaryFolder folder;
  const auto paths = written(folder, texts);
  for (const auto& loaded : {load_recording(paths, {}), streamed(paths, {})}) {
    EXPECT_TRUE(loaded) << loaded.error().message;
  }
}

std::string record_of(const std::string& id, double time_s, double east, double north) {
  return id + "," + std::to_string(time_s) + "," + std::to_string(east) + "," +
         std::to_string(north) + ",9\n";
}

// Two fly at each other, record by record.
std::string run_of(double from_s, double begun_s, double until_s, double step_s = 1.0) {
  std::string text;
  for (int i = 0; from_s + i * step_s <= until_s; ++i) {
    const double time_s = from_s + i * step_s;
    const double east = 0.1 * (time_s - begun_s);
    text += record_of("a", time_s, east, 0.0);
    text += record_of("b", time_s, 9.0 - east, 0.2);
  }
  return text;
}

// All records of one bee, on a round of its own.
std::string block_of(const std::string& id, double from_s, int fixes, double turned) {
  std::string text;
  for (int i = 0; i < fixes; ++i) {
    const double angle = 0.05 * i + turned;
    text += record_of(id, from_s + i, 20.0 * std::cos(angle), 20.0 * std::sin(angle));
  }
  return text;
}

const std::string kOfRuns = "id,time_s,x_m,y_m,z_m\n";

TEST(RestartedClocks, InOneFileAreAskedAbout) {
  const std::string first = run_of(0.0, 0.0, 60.0, 10.0);
  const RunTexts twice = {kOfRuns + first + run_of(3.0, 0.0, 63.0, 10.0)};
  expect_asked(twice, "times begin again here: 2 bees go back at once, from 60 s to 3 s");
  expect_asked(twice, "read each for itself, the first as 'head -n 15' of this file");
  // With the same times, too, where before leaving out the second run was advised.
  expect_asked({kOfRuns + first + run_of(0.0, 5.0, 60.0, 10.0)}, "times begin again here");
  // One of them flies as before.
  std::string other;
  for (int t = 0; t <= 60; t += 10) {
    other += record_of("a", t, 0.1 * t, 0.0) + record_of("b", t, 5.0 - 0.1 * t, 0.2);
  }
  expect_asked({kOfRuns + first + other}, "times begin again here");
}

TEST(RestartedClocks, AreFoundInLongRunsToo) {
  const std::string first = run_of(0.0, 0.0, 500.0);
  expect_asked({kOfRuns + first + run_of(0.5, 7.0, 480.5)},
               "2 bees go back at once, from 500 s to 0.5 s");
  expect_asked({kOfRuns + first + run_of(497.5, 450.0, 600.5)},
               "2 bees go back at once, from 500 s to 497.5 s");
  expect_asked({kOfRuns + first, kOfRuns + run_of(0.5, 40.0, 480.5)}, "read the files each");
  expect_not_asked({kOfRuns + first, kOfRuns + run_of(0.5, 0.0, 480.5)});
  expect_not_asked({kOfRuns + first + first});
}

TEST(RestartedClocks, InSeveralFilesAreAskedAbout) {
  const std::string first = kOfRuns + run_of(0.0, 0.0, 60.0, 10.0);
  const std::string second = kOfRuns + run_of(3.0, 3.0, 63.0, 10.0);
  for (const auto& texts : {RunTexts{first, second}, RunTexts{second, first}}) {
    expect_asked(texts,
                 "as of two runs: then they cannot be compared; read the files "
                 "each for itself, or, if all have one clock, say so with "
                 "--one-clock");
  }
  // Two logs of one run say the same.
  expect_not_asked({first, kOfRuns + run_of(3.0, 0.0, 63.0, 10.0)});
}

// A file has the records of one bee after the other.
TEST(RestartedClocks, AmongTheRecordsOfEachBeeAreAskedAbout) {
  const std::string a = block_of("a", 0.0, 60, 0.0) + block_of("a", 3.5, 60, 1.0);
  const std::string b = block_of("b", 0.0, 60, 2.0) + block_of("b", 3.5, 60, 2.2);
  expect_asked(
      {kOfRuns + a + b},
      "times begin again here: those of bee 'a' go back, from 59 s to 3.5 s, and go "
      "through the same times once more (so do those of all 2 bees of this file), as where");
  // One of them, the first or the last; and one by itself.
  expect_asked({kOfRuns + a + block_of("b", 0.0, 60, 2.0)}, "those of bee 'a' go back");
  expect_asked(
      {kOfRuns + block_of("c", 0.0, 60, 2.0) + b},
      "those of bee 'b' go back, from 59 s to 3.5 s, and go through the same times once "
      "more, as where a simulation or a recording was started again, or two have one id: two "
      "runs cannot be compared with each other; write each run into a file of its own");
  expect_asked({kOfRuns + a}, "read each for itself, the first as 'head -n 61' of this file");
  // One of several files.
  expect_asked({kOfRuns + block_of("c", 2.0, 60, 2.0), kOfRuns + a}, "'head -n 61'");
  // Both runs of one of them are the same, but those of the other one are not.
  expect_asked({kOfRuns + block_of("a", 0.0, 60, 0.0) + block_of("a", 0.0, 60, 0.0) + b},
               "times begin again here");
}

TEST(RestartedClocks, AreNotWhatIsOnlyInNoOrder) {
  const std::string early = run_of(0.0, 0.0, 50.0);
  const std::string late = run_of(51.0, 0.0, 90.0);
  expect_not_asked({kOfRuns + late + early});
  expect_not_asked({kOfRuns + late, kOfRuns + early});
  expect_not_asked({kOfRuns + early + early});  // written twice
  expect_not_asked({kOfRuns + early + run_of(50.0, 0.0, 51.0) + late});
  // Some packets that came late; one bee by itself.
  expect_not_asked({kOfRuns + early + run_of(48.5, 0.0, 49.0) + late});
  expect_not_asked({kOfRuns + early + "a,3.5,0.35,0,9\na,4.5,0.45,0,9\na,5.5,0.55,0,9\n"});
  std::string backwards;
  for (int t = 90; t >= 0; --t) backwards += run_of(t, 0.0, t);
  expect_not_asked({kOfRuns + backwards});
}

TEST(RestartedClocks, AreNotThoseOfBlocks) {
  const auto a = [](double from_s, int fixes) {
    return block_of("a", from_s, fixes, 0.05 * from_s);
  };
  const std::string b = block_of("b", 0.0, 60, 1.0);
  const std::string c = block_of("c", 0.0, 60, 2.0);
  expect_not_asked({kOfRuns + a(0.0, 60) + b + c});
  expect_not_asked({kOfRuns + b + c + a(30.0, 30) + a(0.0, 30)});  // the later half first
  expect_not_asked({kOfRuns + b + a(0.0, 20) + a(40.0, 20) + a(20.0, 20)});
  expect_not_asked({kOfRuns + a(0.0, 60) + a(0.0, 60) + b + b + c + c});
  expect_not_asked({kOfRuns + a(3.0, 60), kOfRuns + b + c});
  // Every other record came later, of the same way.
  std::string even;
  std::string odd;
  for (int i = 0; i < 60; ++i) {
    (i % 2 == 0 ? even : odd) += record_of("a", i, 0.5 * i, 1.0);
  }
  expect_not_asked({kOfRuns + even + odd + b});
}

}  // namespace
}  // namespace beespace::io
