// What callers give to advice, as options of the C++ library.
#pragma once

#include <beespace.h>
#include <beespace/advise.hpp>
#include <beespace/mover.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>
#include <beespace/separation.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace beespace::c {

// What options of C++ refer to, kept from call to call.
struct AdviseArrays {
  std::vector<Velocity> preferred;
  std::vector<FlightLimits> limits;
  std::vector<Fence> fences;
  std::vector<UnknownAgent> unknown;
  std::vector<Claim> claims;
  std::vector<Point> claim_places;
  PlaneMemory planes;
};

// A number that has no default: zero stands for one that is not given.
double given_or_not(double value);
// Zero stands for the default.
double given_or(double value, double otherwise);

Result<Separation> separation_of(std::int32_t shape, double vertical_factor, double vertical_m);
// NULL for both is none.
Status read_fences(const beespace_points* directions, const double* offsets_m,
                   std::vector<Fence>& fences);
// One for each agent, or one for all.
Status read_limits(const beespace_limits* limits, std::size_t agents,
                   std::vector<FlightLimits>& into);
Velocity velocity_of(const Point& numbers);

// Refers to `arrays`, and to the caller's.
Result<AdviseOptions> advise_options_of(const beespace_advise_options* options, std::size_t agents,
                                        const RunOptions& run, AdviseArrays& arrays);

}  // namespace beespace::c
