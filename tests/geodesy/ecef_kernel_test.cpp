// Every variant that this machine can run, not only the one that it would pick.
#include "geodesy/ecef_kernel.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <limits>
#include <string>
#include <vector>

#include "tests/geodesy/positions.hpp"

namespace beespace::geodesy {
namespace {

class EcefVariants : public testing::TestWithParam<EcefVariant> {
 protected:
  void SetUp() override {
    if (!is_available(GetParam())) GTEST_SKIP() << "this processor lacks the instructions";
  }
};

void fill_block(EcefBlock& block, const std::vector<Point>& positions, std::size_t first) {
  for (std::size_t i = 0; i < EcefBlock::kSize; ++i) {
    const Point& position = positions[(first + i) % positions.size()];
    block.longitude_deg[i] = position.x;
    block.latitude_deg[i] = position.y;
    block.height_m[i] = position.z;
  }
}

void expect_scalar_bits(const EcefBlock& block) {
  for (std::size_t i = 0; i < EcefBlock::kSize; ++i) {
    const Point scalar =
        convert_position({block.longitude_deg[i], block.latitude_deg[i], block.height_m[i]});
    ASSERT_EQ(std::bit_cast<std::uint64_t>(block.x[i]), std::bit_cast<std::uint64_t>(scalar.x));
    ASSERT_EQ(std::bit_cast<std::uint64_t>(block.y[i]), std::bit_cast<std::uint64_t>(scalar.y));
    ASSERT_EQ(std::bit_cast<std::uint64_t>(block.z[i]), std::bit_cast<std::uint64_t>(scalar.z));
  }
}

TEST_P(EcefVariants, ReturnTheBitsOfTheScalarConversion) {
  for (const auto& positions :
       {geodesy_test::hard_positions(), geodesy_test::random_positions(64'000, 7)}) {
    EcefBlock block;
    for (std::size_t first = 0; first < positions.size(); first += EcefBlock::kSize) {
      fill_block(block, positions, first);
      ASSERT_TRUE(conversion(GetParam())(block));
      expect_scalar_bits(block);
    }
  }
}

TEST_P(EcefVariants, NoticeOneBadPositionInAnyLaneAndField) {
  const std::vector<Point> positions = geodesy_test::random_positions(EcefBlock::kSize, 8);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::quiet_NaN(),
        std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 1e7,
        -1e7}) {
    for (std::size_t lane = 0; lane < EcefBlock::kSize; ++lane) {
      for (const auto field :
           {&EcefBlock::longitude_deg, &EcefBlock::latitude_deg, &EcefBlock::height_m}) {
        EcefBlock block;
        fill_block(block, positions, 0);
        (block.*field)[lane] = bad;
        EXPECT_FALSE(conversion(GetParam())(block)) << bad << " in lane " << lane;
      }
    }
  }
}

std::string name_of(const testing::TestParamInfo<EcefVariant>& variant) {
  constexpr std::array kNames = {"Baseline", "Avx2", "Avx512"};
  return kNames[static_cast<std::size_t>(variant.param)];
}

INSTANTIATE_TEST_SUITE_P(All, EcefVariants,
                         testing::Values(EcefVariant::kBaseline, EcefVariant::kAvx2,
                                         EcefVariant::kAvx512),
                         name_of);

}  // namespace
}  // namespace beespace::geodesy
