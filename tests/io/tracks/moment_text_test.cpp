// Moments of a recording, as text.
#include "io/recording/moment_text.hpp"

#include <gtest/gtest.h>

namespace beespace::io {
namespace {

TEST(MomentText, IsADateWhereSecondsCountFrom1970) {
  Recording recording;
  EXPECT_EQ(moment_text(12.5, recording), "12.50 s");
  recording.since_1970 = true;
  EXPECT_EQ(moment_text(0.0, recording), "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(moment_text(59.9996, recording), "1970-01-01T00:01:00.000Z");
  EXPECT_EQ(moment_text(-1.5, recording), "1969-12-31T23:59:58.500Z");
}

}  // namespace
}  // namespace beespace::io
