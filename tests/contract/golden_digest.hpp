// One number for all scenes, and one for all answers about them: the same for every variant,
// compiler, optimisation level, instruction set and machine.
//
// A change of a scene or an inquiry changes both; copy them then from the failing test. If the
// second changes alone, either an inquiry has changed or an answer has.
#pragma once

#include <cstdint>

namespace beespace::test {

inline constexpr std::uint64_t kGoldenScenes = 0x6d2e'e6e9'd6f2'0ca1U;
inline constexpr std::uint64_t kGoldenAnswers = 0x1bc8'a7c5'ea9d'e1aaU;

}  // namespace beespace::test
