// `beespace detect --memory`: several files, compressed ones, standard input; and what is wrong
// with them.
#include <gtest/gtest.h>

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include "io/bytes/gzip_stream.hpp"
#include "tests/cli/detect/out_of_core_runs.hpp"

namespace beespace::cli_test {
namespace {

std::string packed(std::string_view content) {
  std::string all;
  io::GzipStream gzip;
  const auto keep = [&](std::string_view bytes) { all += bytes; };
  gzip.write(content, keep);
  gzip.finish(keep);
  return all;
}

class OutOfCoreFiles : public OutOfCoreRuns {
 protected:
  // The lines [begin, end) of a table behind its header, with it.
  [[nodiscard]] std::string part(const std::string& table, std::size_t begin,
                                 std::size_t end) const {
    std::istringstream in(folder_.read(table));
    std::string text;
    std::string line;
    std::getline(in, line);
    text += line + '\n';
    for (std::size_t row = 0; row < end && std::getline(in, line); ++row) {
      if (row >= begin) text += line + '\n';
    }
    return text;
  }

  // A table with an id column.
  [[nodiscard]] std::string named(int points) const {
    EXPECT_EQ(swarm("plain.csv", points), folder_.path("plain.csv"));
    std::istringstream in(folder_.read("plain.csv"));
    std::string text;
    std::string line;
    std::getline(in, line);
    text += "id," + line + '\n';
    for (int row = 0; std::getline(in, line); ++row) {
      text += "b" + std::to_string(row * 31) + ',' + line + '\n';
    }
    return folder_.file("named.csv", text);
  }
};

TEST_F(OutOfCoreFiles, SeveralAreOneSwarm) {
  for (const bool own_ids : {false, true}) {
    const std::string whole = own_ids ? named(60'000) : swarm("plain.csv", 60'000);
    const std::string name = own_ids ? "named.csv" : "plain.csv";
    const std::string first = folder_.file("first.csv", part(name, 0, 100));
    const std::string second = folder_.file("second.csv.gz", packed(part(name, 100, 40'000)));
    const std::string third = part(name, 40'000, 60'000);
    for (const std::string report : {"at-risk", "pairs", "nearest", "counts"}) {
      const Arguments what = {"--threshold", "1", "--report", report};
      expect_answer({first, second, "-", what[0], what[1], what[2], what[3]},
                    Arguments{whole} + what, third);
    }
    expect_answer({first, second, "-", "--csv", "--threshold", "1"},
                  {whole, "--csv", "--threshold", "1"}, third);
  }
}

TEST_F(OutOfCoreFiles, ArraysAndTablesAreOneSwarm) {
  const std::string whole = swarm("plain.csv", 20'000);
  const std::string array = swarm("all.npy", 20'000);
  // The array has the points of the table: each has a twin at distance 0.
  const Finished found =
      small({array, whole, "--crs", "metres", "--threshold", "1e-9", "--report", "pairs"});
  const std::vector<std::string> lines = lines_of(found.out);
  ASSERT_EQ(lines.size(), 20'001U) << found.err;
  for (std::size_t row = 0; row < 20'000; ++row) {
    ASSERT_EQ(lines[row + 1], std::to_string(row) + '\t' + std::to_string(row + 20'000) + "\t0");
  }
  EXPECT_NE(found.err.find("all points 40,000"), std::string::npos) << found.err;
}

TEST_F(OutOfCoreFiles, JsonTellsOfEachFile) {
  const std::string first = folder_.file("first.csv", "id,x_m,y_m,z_m\na,1,2,3\nb,1,2,4\n");
  const std::string second = folder_.file("second.csv", "id,x_ft,y_m,z_m\na,0,0,0\n,1,2,4\n");
  const Finished found = small({first, second, "--json"});
  expect_parts(found.out, {"\"inputs\": [", "first.csv", "second.csv", "\"repeated_ids\": 1",
                           "{\"id\": \"a\", \"records\": [0, 2]}",
                           "\"at_risk\": [\"a\", \"b\", \"a\", 3]", "1 bee has an empty id"});
  expect_refused({first, second, "--unique-ids"}, 3, "'a', of data rows 0 and 2");
}

TEST_F(OutOfCoreFiles, StandardInputAndCompressedOnesAreReadAsTheyCome) {
  const std::string file = swarm("plain.csv", 20'000);
  const std::string text = folder_.read("plain.csv");
  const Arguments what = {"--threshold", "1", "--report", "pairs"};
  expect_same(Arguments{"-"} + what, text);
  expect_same(what, text);
  expect_same(what, packed(text));
  const std::string array = swarm("swarm.npy", 20'000);
  expect_answer(Arguments{"-", "--crs", "metres"} + what,
                Arguments{array, "--crs", "metres"} + what, folder_.read("swarm.npy"));
  const std::string gzip = folder_.file("swarm.npy.gz", packed(folder_.read("swarm.npy")));
  expect_same(Arguments{gzip, "--crs", "metres"} + what);
}

TEST_F(OutOfCoreFiles, IdsThatComeAgainAreToldAsWithoutMemory) {
  std::string text = "id,x_m,y_m,z_m\n";
  for (int row = 0; row < 3000; ++row) {
    text += "b" + std::to_string(row % 2500) + ',' + std::to_string(row * 50) + ",0,0\n";
  }
  const std::string file = folder_.file("again.csv", text);
  expect_same({file, "--json"});
  const Finished unique = small({file, "--unique-ids"});
  EXPECT_EQ(unique.exit_code, 3);
  EXPECT_EQ(unique.err, run({"detect", file, "--unique-ids"}).err);
  EXPECT_NE(unique.err.find("rows 0 and 2500"), std::string::npos) << unique.err;
}

TEST_F(OutOfCoreFiles, WhatCannotBeTakenTogetherIsRefused) {
  const auto file = [&](const std::string& name, const std::string& content) {
    return folder_.file(name, content);
  };
  const std::string metres = file("metres.csv", "x_m,y_m,z_m\n1,2,3\n");
  const std::string degrees = file("degrees.csv", "longitude,latitude,height\n8,47,3\n");
  const std::string flat = file("flat.csv", "x_m,y_m\n1,2\n");
  const std::string ids = file("ids.csv", "id,x_m,y_m,z_m\na,1,2,3\n");
  const std::string turned = file("turned.csv", "z_m,y_m,x_m\n1,2,3\n");
  expect_refused({metres, degrees}, 2, "was taken for degrees");
  expect_refused({metres, flat}, 2, "'" + flat + "' has none");
  expect_refused({metres, ids}, 2, "has an id column");
  expect_refused({metres, turned, "--csv"}, 2, "has other columns");
  expect_refused({metres, turned, "--columns", "x=1,y=2,z=3"}, 2, "has other columns");
  expect_refused({"-", metres, "-"}, 2, "read once", "x_m,y_m,z_m\n1,2,3\n");
  const std::string pressure = file("pressure.csv", "longitude,latitude,baroaltitude_m\n8,47,3\n");
  const std::string ellipsoid = file("ellipsoid.csv", "longitude,latitude,geoaltitude_m\n8,47,3\n");
  expect_refused({pressure, ellipsoid, "--crs", "wgs84", "--threshold", "100m"}, 2,
                 "the heights of");
  // Without --memory one file is read.
  const Finished several = run({"detect", metres, turned});
  EXPECT_EQ(several.exit_code, 2);
  EXPECT_NE(several.err.find("unless --memory SIZE is given"), std::string::npos);
}

TEST_F(OutOfCoreFiles, WhatIsWrongSaysWhere) {
  const std::string good = folder_.file("good.csv", "x_m,y_m,z_m\n1,2,3\n4,5,6\n");
  const std::string bad = folder_.file("bad.csv", "x_m,y_m,z_m\n1,2,3\n4,five,6\n");
  expect_refused({good, bad}, 3, "bad.csv:3:2");
  std::string text = "x_m,y_m,z_m\n";
  for (int row = 0; row < 100'000; ++row) text += "1.25,2.5," + std::to_string(row) + "\n";
  const std::string far = folder_.file("far.csv.gz", packed(text + "1,nan,3\n"));
  expect_refused({good, far}, 3, "far.csv.gz:100002:2");
  const std::string whole = packed(text);
  const std::string cut =
      folder_.file("cut.csv.gz", std::string_view(whole).substr(0, whole.size() - 10));
  expect_refused({cut}, 3, "ends too early");
  // Numbers in arrays that are searched where they are.
  std::vector<double> numbers(60'000, 0.5);
  const std::string fine(reinterpret_cast<const char*>(numbers.data()), 2400);
  const std::string first = folder_.file("first.bin", fine);
  numbers[45'001] = 1e300;  // behind the first block, which is looked at when it is opened
  const std::string second = folder_.file(
      "second.bin", std::string(reinterpret_cast<const char*>(numbers.data()), 480'000));
  const Finished outside = small({first, second, "--crs", "metres"});
  EXPECT_EQ(outside.exit_code, 3);
  expect_parts(outside.err, {"second.bin: points[15000]:"});
}

TEST_F(OutOfCoreFiles, BadRecordsAreLeftOutAsWithoutMemory) {
  for (const bool own_ids : {false, true}) {
    const std::string name = own_ids ? "named.csv" : "plain.csv";
    ASSERT_NE(own_ids ? named(30'000) : swarm("plain.csv", 30'000), "");
    std::istringstream in(folder_.read(name));
    std::string text;
    int row = 0;
    for (std::string line; std::getline(in, line); ++row) {
      if (row == 1 || row == 7 || row % 5000 == 3000) line = row % 2 == 0 ? "nothing" : line + ",9";
      if (row > 0 && row % 4000 == 0) line.replace(line.rfind(',') + 1, 3, "1e999");
      text += line + "\n\n";
    }
    const std::string bad = folder_.file("bad.csv", text);
    for (const std::string report : {"at-risk", "pairs", "nearest", "counts"}) {
      for (const std::string form : {"--csv", "--json", "--output=-"}) {
        expect_same({bad, "--skip-bad", "--threshold", "0.8", "--report", report, form});
      }
    }
    const std::size_t half = text.find("\n\n", text.size() / 2) + 2;
    const std::string first = folder_.file("first.csv", text.substr(0, half));
    const std::string header = text.substr(0, text.find('\n') + 1);
    const std::string second = folder_.file("second.csv", header + text.substr(half));
    expect_answer({first, second, "--skip-bad", "--report", "pairs", "--threshold", "1"},
                  {bad, "--skip-bad", "--report", "pairs", "--threshold", "1"});
    expect_refused({bad}, 3, "bad.csv:3");
  }
  const std::string far = folder_.file("far.csv", "x_m,y_m,z_m\n1,2,3\n500,x,3\n900,2,3\n");
  const Finished none = small({far, "--skip-bad", "--fail-on-risk"});
  EXPECT_EQ(none.exit_code, 1);
  expect_parts(none.err, {"none of those that are known; 1 record was left out", "far.csv:3:2"});
  const std::string all = folder_.file("all.csv", "x_m,y_m,z_m\n1,2,a\n500,x,3\n");
  const Finished nothing = small({all, "--skip-bad"});
  EXPECT_EQ(nothing.exit_code, 3);
  EXPECT_EQ(nothing.err, run({"detect", all, "--skip-bad"}).err);
  std::string much = "x_m,y_m,z_m\n1,2,3\n";
  for (int row = 0; row < 150'000; ++row) much += "a,b,c\n";
  expect_refused({folder_.file("much.csv", much), "--skip-bad"}, 3, "too many records are bad");
  // What follows in a line without an end must not become a record.
  const std::string endless = "x,y,z\n0,0,0\n" + std::string(3'000'000, 'q') + "0,0,0.5\n9,9,9\n";
  expect_refused({folder_.file("endless.csv", endless), "--crs", "metres", "--skip-bad"}, 3,
                 "too long for a record");
  expect_refused({swarm("swarm.npy", 10), "--crs", "metres", "--skip-bad"}, 2, "--skip-bad");
}

// In a recording every fix would count as a bee.
TEST_F(OutOfCoreFiles, ARecordingIsRefused) {
  std::string text = "time_s,id,x_m,y_m,z_m\n";
  for (int time = 0; time < 2; ++time) {
    for (int bee = 0; bee < 30'000; ++bee) {
      text +=
          std::to_string(time) + ",b" + std::to_string(bee) + ",1,2," + std::to_string(bee) + "\n";
    }
  }
  expect_refused({folder_.file("flight.csv", text)}, 3, "this is a recording: bee 'b0'");
  const std::string now = folder_.file("now.csv", "time_s,id,x_m,y_m,z_m\n0,a,1,2,3\n0,b,1,2,4\n");
  const std::string then = folder_.file("then.csv", "time_s,id,x_m,y_m,z_m\n1,b,1,2,3\n");
  expect_same({now});
  expect_refused({now, then}, 3, "this is a recording: bee 'b'");
}

}  // namespace
}  // namespace beespace::cli_test
