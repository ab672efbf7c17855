// Holding one variant against another, inquiry by inquiry, and saying where they part.
#pragma once

#include "tests/contract/variants.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace beespace::test {

// The digests of what brute force answers to all inquiries; worked out once.
const std::vector<std::uint64_t>& expected_digests();

// Runs all queries that `variant` supports, and compares; prints the first few differences.
void expect_brute_force_of(const Variant& variant);

// "9 words instead of 8; the first difference is word 3: 17 instead of 18".
std::string first_difference(const Answer& found, const Answer& expected);

}  // namespace beespace::test
