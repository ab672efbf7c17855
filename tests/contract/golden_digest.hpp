// One number for all scenes, and one for all answers about them: the same for every variant,
// compiler, optimisation level, instruction set and machine.
//
// A change of a scene or an inquiry changes both; copy them then from the failing test. If the
// second changes alone, either an inquiry has changed or an answer has.
#pragma once

#include <cstdint>

namespace beespace::test {

inline constexpr std::uint64_t kGoldenScenes = 0x01e7'04f9'9a1e'3287U;
inline constexpr std::uint64_t kGoldenAnswers = 0x8525'965c'3364'59d3U;

}  // namespace beespace::test
