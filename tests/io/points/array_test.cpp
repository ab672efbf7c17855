#include "tests/io/points/loading.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

template <class Number>
std::string bytes_of(const std::vector<Number>& values) {
  std::string bytes(values.size() * sizeof(Number), '\0');
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

// A .npy file as NumPy writes it: header padded with blanks to a multiple of 64.
std::string npy(const std::string& dictionary, const std::string& data, char version = 1) {
  const std::size_t fixed = version == 1 ? 10 : 12;
  std::string header = dictionary;
  while ((fixed + header.size() + 1) % 64 != 0) header += ' ';
  header += '\n';
  std::string file = "\x93NUMPY";
  file += version;
  file += '\0';
  const std::size_t size = header.size();
  file += static_cast<char>(size % 256);
  file += static_cast<char>(size / 256);
  if (version > 1) file += std::string(2, '\0');
  return file + header + data;
}

std::string dictionary(const std::string& descr, const std::string& shape,
                       const std::string& order = "False") {
  return "{'descr': '" + descr + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }";
}

Result<LoadedPoints> load_array(const std::string& bytes, const std::string& name = "bees.npy") {
  return load_points_from_memory(bytes, name, in_metres());
}

const std::vector<double> kRows = {1, 2, 3, 4, 5, 6};
const std::vector<Point> kPoints = {{1, 2, 3}, {4, 5, 6}};

TEST(Npy, ReadsBothTypesBothOrdersAndAllVersions) {
  const std::string rows = bytes_of(kRows);
  EXPECT_EQ(points_of(load_array(npy(dictionary("<f8", "(2, 3)"), rows))), kPoints);
  EXPECT_EQ(points_of(load_array(npy(dictionary("<f8", "(2, 3)"), rows, 2))), kPoints);
  EXPECT_EQ(points_of(load_array(npy(dictionary("<f8", "(2, 3)"), rows, 3))), kPoints);
  const std::string singles = bytes_of(std::vector<float>{1, 2, 3, 4, 5, 6});
  EXPECT_EQ(points_of(load_array(npy(dictionary("<f4", "(2, 3)"), singles))), kPoints);
  const std::string columns = bytes_of(std::vector<double>{1, 4, 2, 5, 3, 6});
  EXPECT_EQ(points_of(load_array(npy(dictionary("<f8", "(2, 3)", "True"), columns))), kPoints);
}

TEST(Npy, IsKnownByItsContentNotByItsName) {
  const auto loaded = load_array(npy(dictionary("<f8", "(2, 3)"), bytes_of(kRows)), "-");
  EXPECT_EQ(points_of(loaded), kPoints);
  EXPECT_EQ(loaded.value().format_description, "npy float64 (2, 3)");
}

TEST(Npy, AcceptsAnyOrderOfTheHeadersEntries) {
  const std::string header = "{\"shape\":(2,3),\"fortran_order\":False,\"descr\":\"<f8\"}";
  EXPECT_EQ(points_of(load_array(npy(header, bytes_of(kRows)))), kPoints);
}

TEST(Npy, RefusesOtherTypesAndShapes) {
  const std::string data = bytes_of(kRows);
  const auto unsupported = [&data](const std::string& header, std::string_view message) {
    expect_error(load_array(npy(header, data)),
                 {ErrorCode::kUnsupportedFormat, "bees.npy", message});
  };
  unsupported(dictionary("<i8", "(2, 3)"), "the .npy array holds '<i8'");
  unsupported(dictionary(">f8", "(2, 3)"), "array.astype('<f8')");
  unsupported("{'descr': [('x', '<f8')], 'fortran_order': False, 'shape': (6,), }", "('x', '<f8')");
  unsupported(dictionary("|O", "()"), "of trajectories of idtracker.ai make CSV: idtrackerai_csv");
  unsupported(dictionary("<f8", "(6,)"), "has the shape (6,)");
  unsupported(dictionary("<f8", "(3, 2)"), "has the shape (3, 2)");
  unsupported(dictionary("<f8", "(1, 2, 3)"), "has the shape (1, 2, 3)");
  unsupported(dictionary("<f8", "()"), "has the shape ()");
  expect_error(load_array(npy(dictionary("<f8", "(2, 3)"), data, 4)),
               {ErrorCode::kUnsupportedFormat, "bees.npy", "version 4"});
}

TEST(Npy, RefusesDamagedHeaders) {
  const std::string data = bytes_of(kRows);
  for (const char* header :
       {"", "{}", "{'descr': '<f8'}", "{'descr': '<f8', 'fortran_order': 0, 'shape': (2, 3)}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3)} x",
        "{'descr': '<f8', 'descr': '<f8', 'fortran_order': False, 'shape': (2, 3)}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (2, -3)}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (99999999999999999999999, 3)}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), 'more': 1}", "{'descr': '<f8"}) {
    expect_error(load_array(npy(header, data)), {ErrorCode::kCorrupt, "bees.npy", "header"});
  }
}

TEST(Npy, EveryTruncationIsAnError) {
  const std::string whole = npy(dictionary("<f8", "(2, 3)"), bytes_of(kRows));
  for (std::size_t size = 1; size < whole.size(); ++size) {
    const auto loaded = load_array(whole.substr(0, size));
    ASSERT_FALSE(loaded.has_value()) << size;
    EXPECT_EQ(loaded.error().code, ErrorCode::kTruncated) << size;
  }
  expect_error(load_array(whole.substr(0, whole.size() - 1)),
               {ErrorCode::kTruncated, "bees.npy", "after 1 of 2 points"});
  expect_error(load_array(whole + "x"), {ErrorCode::kCorrupt, "bees.npy", "1 byte follows"});
}

TEST(Npy, ShapesThatWouldOverflowAreTruncations) {
  expect_error(load_array(npy(dictionary("<f8", "(18446744073709551615, 3)"), bytes_of(kRows))),
               {ErrorCode::kTruncated, "bees.npy", "after 2 of"});
}

TEST(Npy, EmptyArrayIsNoPoints) {
  expect_error(load_array(npy(dictionary("<f8", "(0, 3)"), "")),
               {ErrorCode::kNoPoints, "bees.npy", "the array is empty"});
}

TEST(Array, NotFiniteIsAnErrorWithItsPointOrSkipped) {
  std::vector<double> rows = kRows;
  rows[4] = std::numeric_limits<double>::quiet_NaN();
  rows.insert(rows.end(), {7, 8, 9});
  const std::string bytes = npy(dictionary("<f8", "(3, 3)"), bytes_of(rows));
  expect_error(load_array(bytes), {ErrorCode::kNotFinite, "bees.npy: point 1", "4, nan, 6"});
  LoadOptions options = in_metres();
  options.skip_bad = true;
  const auto loaded = load_points_from_memory(bytes, "bees.npy", options);
  EXPECT_EQ(points_of(loaded), (std::vector<Point>{{1, 2, 3}, {7, 8, 9}}));
  EXPECT_EQ(loaded.value().skipped_count, 1u);
  std::vector<std::uint64_t> ids;
  for_each_record(loaded.value(), {0, 1},
                  [&ids](const Record& record) { ids.push_back(record.row); });
  EXPECT_EQ(ids, (std::vector<std::uint64_t>{0, 2}));
}

TEST(Array, ValuesDecideTheFrameOrItIsRefused) {
  const auto load = [](const std::vector<double>& rows) {
    return load_points_from_memory(bytes_of(rows), "bees.bin");
  };
  expect_error(load(kRows), {ErrorCode::kUnknownFrame, "bees.bin", "--crs"});
  const auto metres = load({1, 2, 3, 1000, 5, 6});
  ASSERT_EQ(points_of(metres).size(), 2u);
  EXPECT_EQ(metres.value().frame, Frame::kMetres);
  expect_error(load({-75.50, 6.30, 1400, -75.51, 6.31, 1500}),
               {ErrorCode::kUnknownFrame, "bees.bin", "--crs wgs84"});
  std::vector<double> swarm;
  for (int i = 0; i < 40; ++i) swarm.insert(swarm.end(), {-175.5 + i / 1e3, 6.3, 1400.0 + 10 * i});
  const auto degrees = load(swarm);
  ASSERT_EQ(points_of(degrees).size(), 40u);
  EXPECT_EQ(degrees.value().frame, Frame::kWgs84);
  EXPECT_EQ(degrees.value().notes.size(), 1u);
  swarm[5] = 2e6;
  expect_error(load(swarm), {ErrorCode::kInvalidHeight, "bees.bin: point 1", "height 2e+06 m"});
}

TEST(Raw, IsTakenByItsNameOrWhenAskedFor) {
  EXPECT_EQ(points_of(load_array(bytes_of(kRows), "bees.bin")), kPoints);
  LoadOptions options = in_metres();
  options.format = Format::kRawFloat64;
  EXPECT_EQ(points_of(load_points_from_memory(bytes_of(kRows), "bees.dat", options)), kPoints);
}

TEST(Raw, AnOddSizeIsATruncation) {
  expect_error(load_array(bytes_of(kRows).substr(0, 47), "bees.bin"),
               {ErrorCode::kTruncated, "bees.bin", "47 bytes are no whole number of points"});
  expect_error(load_array("", "bees.bin"), {ErrorCode::kNoPoints, "bees.bin", "empty"});
}

TEST(Array, RecordsShowTheNumbersAsShortAsTheyAre) {
  const std::string singles = bytes_of(std::vector<float>{0.1f, 2, 3});
  const auto loaded = load_array(npy(dictionary("<f4", "(1, 3)"), singles));
  ASSERT_TRUE(loaded.has_value());
  std::string text;
  for_each_record(loaded.value(), {0}, [&text](const Record& record) { text = record.text; });
  EXPECT_EQ(text, "0.1,2,3");
  EXPECT_FALSE(has_id_column(loaded.value()));
  EXPECT_EQ(header_line(loaded.value()), "");
  EXPECT_EQ(delimiter(loaded.value()), ',');
}

TEST(Array, ColumnsCannotBeChosen) {
  expect_error(load_points_from_memory(bytes_of(kRows), "bees.bin", with_columns("x=1,y=2")),
               {ErrorCode::kInvalidArgument, "bees.bin", "--columns is for text tables"});
}

TEST(Array, AskingForNpyWhereThereIsNoneIsAnError) {
  LoadOptions options;
  options.format = Format::kNpy;
  expect_error(load_text("x,y,z\n1,2,3\n", options),
               {ErrorCode::kUnsupportedFormat, "bees.csv", "this is no .npy file"});
}

}  // namespace
}  // namespace beespace::io
