// Names of bees, as text.
#include "analysis/text/bee_name.hpp"

#include <gtest/gtest.h>

namespace beespace::analysis {
namespace {

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
