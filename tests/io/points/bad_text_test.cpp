#include "tests/io/points/loading.hpp"

#include <gtest/gtest.h>

#include <string>

namespace beespace::io {
namespace {

TEST(BadText, EmptyInput) {
  expect_error(load_text(""), {ErrorCode::kNoPoints, "bees.csv", "the input is empty"});
  expect_error(load_text("\n \n\r\n"), {ErrorCode::kNoPoints, "bees.csv", "the input is empty"});
  expect_error(load_text("\xEF\xBB\xBF"), {ErrorCode::kNoPoints, "bees.csv", "is empty"});
}

TEST(BadText, HeaderAndNothingElse) {
  expect_error(load_text("x,y,z\n"), {ErrorCode::kNoPoints, "bees.csv", "a header and no record"});
  expect_error(load_text("x,y,z\n\n  \n"), {ErrorCode::kNoPoints, "bees.csv", "a header"});
  expect_error(load_text("x,y,z"), {ErrorCode::kNoPoints, "bees.csv", "a header"});
}

TEST(BadText, NotANumberIsShownWithLineAndColumn) {
  expect_error(load_text("x,y,z\n1,2,3\n4,abc,6\n"),
               {ErrorCode::kNotANumber, "bees.csv:3:2", "'abc' is not a number (y)"});
  expect_error(load_text("x,y,z\n1,2,\n"),
               {ErrorCode::kNotANumber, "bees.csv:2:3", "the field is empty"});
  expect_error(load_text("x,y,z\n0x10,2,3\n"),
               {ErrorCode::kNotANumber, "bees.csv:2:1", "'0x10' is not a number"});
  EXPECT_EQ(load_text("x,y,z\n1,2,3\n4,abc,6\n").error().location.record, 1u);
}

TEST(BadText, TheLowestColumnIsReportedWhateverItsRole) {
  expect_error(load_text("lat,lon,alt\nA,B,C\n1,2,3\n"),
               {ErrorCode::kNotANumber, "bees.csv:2:1", "'A' is not a number (latitude)"});
}

TEST(BadText, DecimalCommasGetAHint) {
  expect_error(load_text("x;y;z\n1,500;2,500;3,500\n"),
               {ErrorCode::kNotANumber, "bees.csv:2:1", "decimals with a point, not with a comma"});
  expect_error(load_text("1,5 2,5 3,5\n", in_metres()),
               {ErrorCode::kNotANumber, "bees.csv:1:1", "decimals with a point"});
}

TEST(BadText, LongTextIsShortenedAndControlBytesAreEscaped) {
  const auto loaded = load_text("x,y,z\n1,2," + std::string(3000, 'q') + "\n");
  expect_error(loaded, {ErrorCode::kNotANumber, "bees.csv:2:3", std::string(40, 'q') + "...'"});
  EXPECT_LT(loaded.error().message.size(), 200u);
  expect_error(load_text("x,y,z\n" + std::string(5000, '\n') + "1,2,\x1b[31m\xff\n"),
               {ErrorCode::kNotANumber, "bees.csv:5002:3", "'\\x1b[31m\\xff'"});
}

TEST(BadText, NanAndInfinity) {
  expect_error(load_text("x,y,z\n1,2,3\n\n4,5,nan\n"),
               {ErrorCode::kNotFinite, "bees.csv:4:3", "'nan' is no position"});
  expect_error(load_text("x,y,z\n-Infinity,2,3\n"),
               {ErrorCode::kNotFinite, "bees.csv:2:1", "'-Infinity' is no position"});
  expect_error(load_text("x,y,z\n1e999,2,3\n"),
               {ErrorCode::kNotFinite, "bees.csv:2:1", "'1e999' is too large"});
}

TEST(BadText, ARecordWithAnotherNumberOfColumns) {
  expect_error(load_text("x,y,z\n1,2,3\n1,2\n"),
               {ErrorCode::kColumnCount, "bees.csv:3", "2 columns where the header has 3"});
  expect_error(load_text("x,y,z\n1,2,3,4\n"),
               {ErrorCode::kColumnCount, "bees.csv:2", "4 columns where the header has 3"});
  expect_error(load_text("x,y,z\n7\n"), {ErrorCode::kColumnCount, "bees.csv:2", "1 column where"});
}

TEST(BadText, QuotesThatDoNotClose) {
  expect_error(load_text("x,y,z\n1,\"2,3\n"),
               {ErrorCode::kMalformedRecord, "bees.csv:2:2", "never closed on this line"});
  expect_error(load_text("x,y,z\n1,\"2\"2,3\n"),
               {ErrorCode::kMalformedRecord, "bees.csv:2:2", "follows a closing quote"});
  expect_error(load_text("x,\"y,z\n1,2,3\n"),
               {ErrorCode::kMalformedRecord, "bees.csv:1:2", "never closed"});
}

TEST(BadText, ALineTooLongForARecord) {
  std::string endless;
  endless.resize(10'000'000, '7');
  expect_error(load_text("x,y,z\n1,2,3\n" + endless + "\n4,5,6\n"),
               {ErrorCode::kMalformedRecord, "bees.csv:3", "a line of 10000000 bytes"});
  expect_error(load_text(endless),
               {ErrorCode::kMalformedRecord, "bees.csv:1", "too long for a record"});
  LoadOptions options;
  options.skip_bad = true;
  const auto skipped = load_text("x,y,z\n1,2,3\n" + endless + "\n4,5,6\n", options);
  EXPECT_EQ(points_of(skipped).size(), 2u);
}

TEST(BadText, BinaryRubbishSaysWhatWasFoundAndWhere) {
  using std::string_literals::operator""s;
  const auto unsupported = [](const std::string& bytes, std::string_view message) {
    expect_error(load_text(bytes), {ErrorCode::kUnsupportedFormat, "bees.csv", message});
  };
  unsupported(
      "\xFF\xFE"
      "1\0,\0"s,
      "UTF-16");
  unsupported(
      "\xFE\xFF\0"
      "1\0,"s,
      "UTF-16");
  unsupported(
      "\xFF\xFE\0\0"
      "1\0\0\0"s,
      "UTF-32");
  unsupported("1\0,\0002\0"s, "UTF-16 text without a mark");
  unsupported("1\0,,2\0"s, "byte 1 is NUL");
  unsupported("1,2,3\n\x01\x02", "byte 6 is 0x01");
  unsupported("PK\x03\x04...", "zip archive");
  unsupported("{\"now\": 1}", "JSON");
  unsupported("\n  [[1,2,3]]", "JSON");
  unsupported("<?xml version=\"1.0\"?>", "XML");
  unsupported(
      "\x7F"
      "ELF\x02",
      "a program");
}

TEST(BadText, NulFarInsideIsFoundToo) {
  using std::string_literals::operator""s;
  std::string text = "x,y,z\n";
  for (int i = 0; i < 2000; ++i) text += "1,2,3\n";
  expect_error(load_text(text + "1,\0002,3\n"s),
               {ErrorCode::kUnsupportedFormat, "bees.csv:2002", "NUL byte"});
}

TEST(BadText, LatitudeLongitudeAndHeightBeyondTheirRange) {
  expect_error(load_text("lon,lat,alt\n1,2,3\n4,95.5,6\n"),
               {ErrorCode::kInvalidLatitude, "bees.csv:3:2", "latitude '95.5' is beyond 90"});
  expect_error(load_text("lat,lon,alt\n\n-91,5,6\n"),
               {ErrorCode::kInvalidLatitude, "bees.csv:3:1", "swapped"});
  expect_error(load_text("lon,lat,alt\n-360.5,2,3\n"),
               {ErrorCode::kInvalidLongitude, "bees.csv:2:1", "longitude '-360.5' is beyond 360"});
  expect_error(load_text("lon,lat,alt\n1,2,1500000\n"),
               {ErrorCode::kInvalidHeight, "bees.csv:2:3", "millimetres or feet"});
  expect_error(load_text("lon,lat,alt\n1,2,-20000\n"),
               {ErrorCode::kInvalidHeight, "bees.csv:2:3", "height '-20000' m"});
}

TEST(BadText, RangesAreCheckedForAnExplicitFrame) {
  LoadOptions options;
  options.frame = Frame::kWgs84;
  expect_error(load_text("x,y,z\n100,200,3\n", options),
               {ErrorCode::kInvalidLatitude, "bees.csv:2:2", "'200'"});
}

TEST(BadText, TheLowerLineWinsBetweenARangeAndASyntaxError) {
  expect_error(load_text("lon,lat,alt\n1,95,3\n1,x,3\n"),
               {ErrorCode::kInvalidLatitude, "bees.csv:2:2", ""});
  expect_error(load_text("lon,lat,alt\n1,x,3\n1,95,3\n"),
               {ErrorCode::kNotANumber, "bees.csv:2:2", ""});
}

TEST(BadText, MetresOutsideTheCoordinateDomain) {
  expect_error(load_text("x,y,z\n1,2,3\n1,1e200,3\n"),
               {ErrorCode::kOutsideDomain, "bees.csv:3:2", "too large"});
  expect_error(load_text("x,y,z\n1,2,1e-200\n"),
               {ErrorCode::kOutsideDomain, "bees.csv:2:3", "too small"});
  expect_error(load_text("x,y,z\n1,2,1e-400\n"),
               {ErrorCode::kOutsideDomain, "bees.csv:2:3", "3.9e-121 m to 2.6e+120 m"});
}

TEST(BadText, ColumnsThatCannotBeRecognised) {
  expect_error(load_text("1,2,3,4\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1", "--columns lon=1,lat=2,height=3"});
  expect_error(load_text("1\n2\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1", "needs two or three columns"});
  expect_error(load_text("lat,foo,bar\n1,2,3\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1", "names 'lat' but not"});
  expect_error(
      load_text("lon,lat,quux\n1,2,3\n"),
      {ErrorCode::kMissingColumn, "bees.csv:1",
       "no column names the height, and 'quux' may or may not be it; say --columns lon=1,lat=2 if "
       "there is none, and add height=N"});
  expect_error(load_text("lon,lat,lat,alt\n1,2,3,4\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1", "several columns look like lat"});
  expect_error(load_text("lon,lat,x,y\n1,2,3,4\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1", "--crs wgs84 or --crs metres"});
}

TEST(BadText, UnitsThatAreNotReadAreRefused) {
  expect_error(load_text("lat [rad],lon [rad],alt_m\n1,2,3\n"),
               {ErrorCode::kUnsupportedFormat, "bees.csv:1:2", "'rad'"});
  EXPECT_TRUE(load_text("lat,lon,alt_ft,alt_m\n1,2,3,4\n").has_value());
}

TEST(BadText, InvalidColumnOptions) {
  const auto invalid = [](const std::string& columns, std::string_view message) {
    expect_error(load_text("a,b,c\n1,2,3\n", with_columns(columns)),
                 {ErrorCode::kInvalidArgument, "bees.csv", message});
  };
  invalid("lon=1", "lon needs lat too");
  invalid("lat=1,height=2", "lat needs lon too");
  invalid("height=1", "height needs lon and lat too");
  invalid("z=1", "z needs x and y too");
  invalid("x=1,lat=2", "do not go together");
  invalid("x=1,y=2,height=3", "do not go together");
  invalid("x=1,y=2,x=3", "x is given twice");
  invalid("x=1,y=1", "cannot be both");
  invalid("foo=1,y=2", "'foo=1' is not understood");
  invalid("1,2,3", "'1' is not understood");
  invalid("x=,y=2", "'x=' is not understood");
  invalid("x=1,y=2,", "'' is not understood");
}

TEST(BadText, ColumnsThatAreNotThere) {
  expect_error(load_text("a,b,c\n1,2,3\n", with_columns("x=a,y=d")),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "no column named 'd'; the columns are 1 'a', 2 'b', 3 'c'"});
  expect_error(
      load_text("1,2,3\n", with_columns("x=1,y=4")),
      {ErrorCode::kMissingColumn, "bees.csv:1", "no column 4; there are 3 columns and no header"});
  expect_error(load_text("1,2,3\n", with_columns("x=0,y=1")),
               {ErrorCode::kMissingColumn, "bees.csv:1", "no column 0"});
  expect_error(load_text("1,2,3\n", with_columns("x=99999999999999999999999,y=1")),
               {ErrorCode::kMissingColumn, "bees.csv:1", "there is no column 9999"});
}

}  // namespace
}  // namespace beespace::io
