// What the command's exit codes mean, as the manual says.
#pragma once

namespace beespace::cli_test {

constexpr int kRisk = 1;
constexpr int kUsage = 2;
constexpr int kBadInput = 3;
constexpr int kSystem = 4;

}  // namespace beespace::cli_test
