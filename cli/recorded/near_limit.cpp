#include "cli/recorded/near_limit.hpp"

#include "io/bytes/number_text.hpp"
#include "io/units/units.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace beespace::cli {
namespace {

// Of minima of 1000 ft and more; of others a share.
constexpr double kNearFeet = 50.0;
constexpr double kLeastLimitFeet = 1'000.0;
constexpr double kNearShare = 0.02;
constexpr double kLowerLimit = 0.9;  // of what was asked

// To what is told and typed.
double with_few_digits(double value) {
  constexpr double kFine = 1e6;
  return std::round(value * kFine) / kFine;
}

}  // namespace

std::string near_limit_text(const std::vector<Conflict>& conflicts, const MovingRequest& request,
                            const Distances& distances) {
  if (conflicts.empty() || !request.vertical || !distances.least_height) return {};
  const double limit = request.vertical->value;
  const io::Unit unit = request.vertical->unit;
  const bool levels = unit == io::Unit::kFoot && limit >= kLeastLimitFeet;
  const double near = levels ? kNearFeet : with_few_digits(kNearShare * limit);
  MovingRequest lower = request;
  lower.separation = nullptr;
  lower.vertical->value = with_few_digits(kLowerLimit * limit);
  std::size_t close = 0;
  std::size_t left = 0;
  for (const Conflict& conflict : conflicts) {
    const auto least = distances.least_height(conflict);
    // Of whom that is not known, it may be anything.
    const double least_apart = least ? io::from_metric(least->apart.vertical_m, unit) : 0.0;
    // Instants are rounded, and so a little off what was flown.
    constexpr double kRounded = 1e-6;
    if (least_apart >= limit - near - kRounded * limit) ++close;
    if (least_apart < lower.vertical->value * (1.0 - kRounded)) ++left;
  }
  if (2 * close <= conflicts.size()) return {};
  const std::string name(io::symbol_of(unit));
  const std::string who =
      close == conflicts.size()
          ? (close == 1 ? "the only conflict is"
                        : "all " + io::grouped(std::uint64_t{close}) + " conflicts are")
          : io::grouped(std::uint64_t{close}) + " of " +
                io::counted(conflicts.size(), "conflict", "conflicts") +
                (close == 1 ? " is" : " are");
  return who + " within " + io::exact(near) + " " + name +
         " of the vertical limit:" + separation_typed(lower) + " would leave " +
         io::grouped(std::uint64_t{left});
}

}  // namespace beespace::cli
