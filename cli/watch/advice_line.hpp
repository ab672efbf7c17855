// The lines of JSON that `beespace watch --advise` writes at a look.
#pragma once

#include "cli/output/rows.hpp"
#include "io/recording/recording.hpp"

#include <beespace/advise.hpp>
#include <beespace/mover.hpp>

#include <array>
#include <cstdint>
#include <string>

namespace beespace::cli {

// Why a bee is not certified.
enum class Doubt : std::uint8_t {
  kNone,
  kHeardOnce,     // no report has borne out the first, or the first after it flew otherwise
  kNoVelocity,    // its reports do not say how fast it flies
  kNotAsAdvised,  // its last report is not where advice had led it
  kOldReport,     // its last report is older than two steps
  kStale,         // it has not been heard of for so long that it may be anywhere
  kTooClose,      // by Adviser::advise
  kNearUnknown,   // the same: to where one of which nothing is known may be
  kRefused,       // Adviser::advise cannot use its state
  kUnplaced,      // another bee has been heard of, and it is not known where
  kClockOff,      // its clock is not believed: when it was where is known about only
};
inline constexpr std::size_t kDoubts = 11;
const char* name_of(Doubt doubt);

// When a look is taken, and from when on it is to be flown.
struct AdviceTimes {
  double time_s;
  double effective_s;
};

// Of kNone there is nothing to fly by.
void append_advice_line(std::string& out, const AdviceTimes& times, const analysis::BeeName& name,
                        const Mover& mover, const Advice& advice, Doubt doubt, io::Frame frame);

// Of a look, the last line: how many bees it was about, how many lines it has told, and how many
// bees are not certified and why.
struct LookCounts {
  std::uint64_t bees = 0;
  std::uint64_t told = 0;
  std::array<std::uint64_t, kDoubts> doubts{};  // by kind
};
void append_advised_line(std::string& out, const AdviceTimes& times, const LookCounts& counts);

}  // namespace beespace::cli
