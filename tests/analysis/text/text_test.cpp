// Names of bees and moments of a recording, as text.
#include "analysis/text/bee_name.hpp"
#include "analysis/text/moment_text.hpp"

#include <gtest/gtest.h>

namespace beespace::analysis {
namespace {

TEST(MomentText, IsADateWhereSecondsCountFrom1970) {
  io::Recording recording;
  EXPECT_EQ(moment_text(12.5, recording), "12.50 s");
  recording.since_1970 = true;
  EXPECT_EQ(moment_text(0.0, recording), "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(moment_text(59.9996, recording), "1970-01-01T00:01:00.000Z");
  EXPECT_EQ(moment_text(-1.5, recording), "1969-12-31T23:59:58.500Z");
}

TEST(BeeName, HasItsLabelBesideTheId) {
  EXPECT_EQ(text_of({"a1b2c3", ""}), "a1b2c3");
  EXPECT_EQ(text_of({"a1b2c3", "UAL123"}), "a1b2c3 (UAL123)");
  io::Recording recording;
  recording.bees.resize(2);
  EXPECT_FALSE(has_labels(recording));
  recording.bees[1].label = "UAL123";
  EXPECT_TRUE(has_labels(recording));
  EXPECT_EQ(name_of(1, recording).label, "UAL123");
}

}  // namespace
}  // namespace beespace::analysis
