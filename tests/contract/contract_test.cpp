// Every variant gives brute force's answer to every question about every scene at every radius.
#include "tests/contract/agreement.hpp"
#include "tests/contract/golden_digest.hpp"

#include "kernels/sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

class Contract : public testing::TestWithParam<Variant> {};

TEST_P(Contract, EqualsBruteForceOnEveryInquiry) {
  expect_brute_force_of(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Everything, Contract, testing::ValuesIn(contract_variants()),
                         [](const auto& instance) { return instance.param.name; });

// With the test above: the same digest for every variant.
TEST(ContractAnswers, AreTheSameEverywhere) {
  EXPECT_EQ(digest(expected_digests()), kGoldenAnswers)
      << std::hex << "it is now 0x" << digest(expected_digests());
}

TEST(ContractVariants, HaveEveryKernelOfThisProcessor) {
  std::size_t available = 0;
  for (const cpu::InstructionSet set : cpu::kInstructionSets) {
    if (!cpu::is_available(set)) continue;
    ++available;
    const auto is_of_set = [&](const Variant& variant) {
      return variant.name.rfind(cpu::name_of(set), 0) == 0 && variant.questions.empty();
    };
    const std::vector<Variant> all = contract_variants();
    EXPECT_GE(std::count_if(all.begin(), all.end(), is_of_set), 5) << cpu::name_of(set);
  }
  EXPECT_GE(available, 1U);
}

}  // namespace
}  // namespace beespace::test
