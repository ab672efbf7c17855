// Long names that begin or end alike, in pictures.
#include "report/figure/picture_names.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace beespace::report {
namespace {

std::string first_of(std::vector<std::string> texts) {
  return picture_name({std::move(texts), {}}, 0);
}

TEST(PictureNames, AreToldByWhatDiffers) {
  EXPECT_EQ(first_of({"2026-09-21 16-13-20 vehicle1", "2026-09-21 16-13-20 vehicle2"}),
            "\u2026vehicle1");
  EXPECT_EQ(first_of({"/drone1/mavros/local_position/pose", "/drone2/mavros/local_position/pose"}),
            "/drone1\u2026");
  EXPECT_EQ(first_of({"/swarm/cf1/mavros/local", "/swarm/cf12/mavros/local"}), "\u2026cf1\u2026");
}

TEST(PictureNames, OfOneOrShortOnesOrOthersStand) {
  EXPECT_EQ(first_of({"2026-09-21 16-13-20 vehicle1"}), "2026-09-21 16-13-20 vehicle1");
  EXPECT_EQ(first_of({"flight one", "flight two"}), "flight one");
  EXPECT_EQ(first_of({"a name of some length", "another one of some size"}),
            "a name of some length");
  EXPECT_FALSE(first_of({"the very same long name", "the very same long name"}).empty());
}

}  // namespace
}  // namespace beespace::report
