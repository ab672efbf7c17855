#include "cli/recorded/near_limit.hpp"

#include "io/bytes/number_text.hpp"
#include "io/units/units.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

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

// In what steps heights are told, of those that transponders have; nothing of others. A few between
// are of other sources.
std::optional<double> height_step_ft(const io::Recording& recording) {
  constexpr double kNearlyAll = 0.98;
  constexpr double kRoundedFeet = 0.02;  // of metres in centimetres
  if (!recording.of_aircraft || recording.flat) return std::nullopt;
  for (const double step_ft : {100.0, 25.0}) {
    std::size_t all = 0;
    std::size_t whole = 0;
    for (const io::RecordedBee& bee : recording.bees) {
      for (const Fix& fix : bee.fixes) {
        const double steps = io::from_metric(fix.position.z, io::Unit::kFoot) / step_ft;
        ++all;
        if (std::abs(steps - std::round(steps)) * step_ft <= kRoundedFeet) ++whole;
      }
    }
    if (all > 0 && static_cast<double>(whole) >= kNearlyAll * static_cast<double>(all)) {
      return step_ft;
    }
  }
  return std::nullopt;
}

// Of conflicts that are by one step of the heights, which waver by that.
std::string one_step_text(const std::vector<Conflict>& conflicts, const MovingRequest& request,
                          const Distances& distances, const io::Recording& recording) {
  if (request.vertical->unit != io::Unit::kFoot) return {};
  const auto step_ft = height_step_ft(recording);
  const double limit = request.vertical->value;
  if (!step_ft || !(limit > 2.0 * *step_ft)) return {};
  const auto by_step =
      std::count_if(conflicts.begin(), conflicts.end(), [&](const Conflict& conflict) {
        constexpr double kRounded = 1e-6;
        const auto least = distances.least_height(conflict);
        return least && io::from_metric(least->apart.vertical_m, io::Unit::kFoot) >=
                            limit - *step_ft - kRounded * limit;
      });
  if (by_step == 0) return {};
  MovingRequest lower = request;
  lower.separation = nullptr;
  lower.vertical->value = limit - *step_ft;
  const auto count = static_cast<std::uint64_t>(by_step);
  return io::exact(*step_ft) + " ft is one step of the reported heights, and " +
         io::counted(count, "conflict is", "conflicts are") +
         " by no more than that:" + separation_typed(lower) + " leaves " +
         (count == 1 ? "it" : "them") + " out";
}

// Of conflicts most of which are nearly none.
std::string mostly_near_text(const std::vector<Conflict>& conflicts, const MovingRequest& request,
                             const Distances& distances) {
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

}  // namespace

std::string near_limit_text(const std::vector<Conflict>& conflicts, const MovingRequest& request,
                            const Distances& distances, const io::Recording& recording) {
  if (conflicts.empty() || !request.vertical || !distances.least_height) return {};
  std::string text = mostly_near_text(conflicts, request, distances);
  const std::string step = one_step_text(conflicts, request, distances, recording);
  if (!text.empty() && !step.empty()) text += "; ";
  return text + step;
}

}  // namespace beespace::cli
