#include "c/advice/options.hpp"

#include <beespace/not_given.hpp>

#include "c/door/door.hpp"
#include "c/door/movers.hpp"
#include "c/door/number_column.hpp"
#include "c/door/points.hpp"
#include "c/door/structs.hpp"
#include "c/obstacles/obstacles.hpp"

#include <limits>
#include <optional>
#include <span>
#include <variant>

namespace beespace::c {

namespace {

constexpr MoverNames kIntruders = {"intruder_positions", "intruder_velocities"};

// The numbers of the caller, one for each of `size`; or a refusal.
template <class Number>
Result<NumberColumn<Number>> column_of(const Number* first, std::size_t size, const char* name) {
  const NumberColumn<Number> column(first);
  if (const char* const problem = size == 0 ? nullptr : column.problem(size)) {
    return invalid(problem, name);
  }
  return column;
}

Status read_intruders(const beespace_advise_options& given, AdviseOptions& options) {
  if (given.intruder_positions == nullptr) {
    if (given.intruder_velocities == nullptr && given.intruder_margins_m == nullptr) {
      return std::monostate{};
    }
    return invalid("this is NULL, but there is more about intruders", kIntruders.positions);
  }
  const Result<MoversView> movers =
      movers_of(given.intruder_positions, given.intruder_velocities, kIntruders);
  if (!movers) return movers.error();
  options.intruders = *movers;
  if (given.intruder_margins_m == nullptr) return std::monostate{};
  const auto margins = column_of(given.intruder_margins_m, movers->size(), "intruder_margins");
  if (!margins) return margins.error();
  options.intruder_margins_m = std::span<const double>(given.intruder_margins_m, movers->size());
  return std::monostate{};
}

Result<std::optional<PointId>> index_of_agent(std::int64_t agent, std::size_t record) {
  if (agent == -1) return std::optional<PointId>();
  if (agent >= 0 && agent <= std::numeric_limits<PointId>::max()) {
    return std::optional<PointId>(static_cast<PointId>(agent));
  }
  Error error = invalid("this is no index of an agent; give one, or -1 for none", "unknown_agents");
  error.location.record = record;
  return error;
}

Status read_unknown(const beespace_advise_options& given, std::vector<UnknownAgent>& unknown) {
  unknown.clear();
  if (given.unknown_centers == nullptr) {
    if (given.unknown_radii_m == nullptr && given.unknown_growths_mps == nullptr &&
        given.unknown_agents == nullptr) {
      return std::monostate{};
    }
    return invalid("this is NULL, but there is more about unknown agents", "unknown_centers");
  }
  const Result<PointsView> centers = view_of(given.unknown_centers, "unknown_centers");
  if (!centers) return centers.error();
  const std::size_t size = centers->size();
  const auto radii = column_of(given.unknown_radii_m, size, "unknown_radii");
  if (!radii) return radii.error();
  const auto growths = column_of(given.unknown_growths_mps, size, "unknown_growths");
  if (!growths) return growths.error();
  const bool some_are_agents = given.unknown_agents != nullptr;
  const auto agents = column_of(given.unknown_agents, some_are_agents ? size : 0, "unknown_agents");
  if (!agents) return agents.error();
  for (std::size_t k = 0; k < size; ++k) {
    const auto agent = index_of_agent(some_are_agents ? (*agents)[k] : -1, k);
    if (!agent) return agent.error();
    unknown.push_back({(*centers)[k], (*radii)[k], (*growths)[k], *agent});
  }
  return std::monostate{};
}

// One of the caller's for each agent, or `otherwise`.
template <class Number>
struct ForEach {
  const Number* numbers;
  Number otherwise;
  Number operator[](std::size_t agent) const {
    return numbers == nullptr ? otherwise : NumberColumn<Number>(numbers)[agent];
  }
};

template <class Number>
Result<ForEach<Number>> for_each_agent(const Number* numbers, std::size_t agents,
                                       const char* name) {
  const auto column = column_of(numbers, numbers == nullptr ? 0 : agents, name);
  if (!column) return column.error();
  return ForEach<Number>{numbers, 0};
}

// Where the places of each agent begin; checked.
Status check_offsets(const NumberColumn<std::int64_t>& offsets, std::size_t agents,
                     std::size_t places) {
  std::int64_t before = 0;
  for (std::size_t i = 0; i <= agents; ++i) {
    const bool is_first = i == 0 && offsets[i] != 0;
    const bool is_last = i == agents && offsets[i] != static_cast<std::int64_t>(places);
    if (offsets[i] < before || is_first || is_last) {
      Error error = invalid("these ascend, from 0 to the number of places", "claim_offsets");
      error.location.record = i;
      return error;
    }
    before = offsets[i];
  }
  return std::monostate{};
}

// The places of all agents into the arrays, and where those of each are.
Status read_claim_places(const beespace_advise_options& given, AdviseArrays& arrays) {
  arrays.claim_places.clear();
  if (given.claim_places == nullptr) {
    if (given.claim_offsets == nullptr) return std::monostate{};
    return invalid("this is NULL, but there are offsets", "claim_places");
  }
  const Result<PointsView> places = view_of(given.claim_places, "claim_places");
  if (!places) return places.error();
  const std::size_t agents = arrays.claims.size();
  const auto offsets = column_of(given.claim_offsets, agents + 1, "claim_offsets");
  if (!offsets) return offsets.error();
  Status fine = check_offsets(*offsets, agents, places->size());
  if (!fine) return fine;
  for (std::size_t k = 0; k < places->size(); ++k) arrays.claim_places.push_back((*places)[k]);
  const std::span<const Point> all = arrays.claim_places;
  for (std::size_t i = 0; i < agents; ++i) {
    const auto begin = static_cast<std::size_t>((*offsets)[i]);
    const auto end = static_cast<std::size_t>((*offsets)[i + 1]);
    arrays.claims[i].places = all.subspan(begin, end - begin);
  }
  return std::monostate{};
}

// One claim for each agent, where there is anything of claims at all.
Status read_claims(const beespace_advise_options& given, std::size_t agents, AdviseArrays& arrays) {
  arrays.claims.clear();
  if (given.radii_m == nullptr && given.tubes_m == nullptr && given.claim_places == nullptr &&
      given.claim_offsets == nullptr && given.holds == nullptr) {
    return std::monostate{};
  }
  const auto radii = for_each_agent(given.radii_m, agents, "radii");
  if (!radii) return radii.error();
  const auto tubes = for_each_agent(given.tubes_m, agents, "tubes");
  if (!tubes) return tubes.error();
  const auto holds = for_each_agent(given.holds, agents, "holds");
  if (!holds) return holds.error();
  for (std::size_t i = 0; i < agents; ++i) {
    arrays.claims.push_back({{}, (*tubes)[i], (*radii)[i], (*holds)[i] != 0});
  }
  return read_claim_places(given, arrays);
}

}  // namespace

double given_or_not(double value) {
  return value == 0.0 ? kNotGiven : value;
}

double given_or(double value, double otherwise) {
  return value == 0.0 ? otherwise : value;
}

Velocity velocity_of(const Point& numbers) {
  return {numbers.x, numbers.y, numbers.z};
}

Result<Separation> separation_of(std::int32_t shape, double vertical_factor, double vertical_m) {
  if (shape < BEESPACE_FREE_SPHERE || shape > BEESPACE_FREE_CYLINDER) {
    return invalid(
        "shape is none of BEESPACE_FREE_SPHERE, BEESPACE_FREE_ELLIPSOID and "
        "BEESPACE_FREE_CYLINDER",
        "options");
  }
  if (shape != BEESPACE_FREE_ELLIPSOID && vertical_factor != 0.0) {
    return invalid("vertical_factor is given, but shape is not BEESPACE_FREE_ELLIPSOID", "options");
  }
  if (shape != BEESPACE_FREE_CYLINDER && vertical_m != 0.0) {
    return invalid("vertical_m is given, but shape is not BEESPACE_FREE_CYLINDER", "options");
  }
  return Separation{static_cast<SeparationShape>(shape), given_or(vertical_factor, 1.0),
                    given_or_not(vertical_m)};
}

Status read_fences(const beespace_points* directions, const double* offsets_m,
                   std::vector<Fence>& fences) {
  fences.clear();
  if (directions == nullptr) {
    if (offsets_m == nullptr) return std::monostate{};
    return invalid("this is NULL, but there are offsets", "fence_directions");
  }
  const Result<PointsView> inward = view_of(directions, "fence_directions");
  if (!inward) return inward.error();
  const auto offsets = column_of(offsets_m, inward->size(), "fence_offsets");
  if (!offsets) return offsets.error();
  for (std::size_t k = 0; k < inward->size(); ++k) fences.push_back({(*inward)[k], (*offsets)[k]});
  return std::monostate{};
}

Status read_limits(const beespace_limits* limits, std::size_t agents,
                   std::vector<FlightLimits>& into) {
  const Result<beespace_limits> given = read_struct(limits, "limits");
  if (!given) return given.error();
  const bool limited = given->max_accelerations_mps2 != nullptr;
  const bool for_all =
      given->max_speeds_stride == 0 && (!limited || given->max_accelerations_stride == 0);
  const std::size_t size = for_all ? 1 : agents;
  const NumberColumn speeds(given->max_speeds_mps, given->max_speeds_stride);
  const NumberColumn accelerations(given->max_accelerations_mps2, given->max_accelerations_stride);
  into.clear();
  if (agents == 0) {
    into.emplace_back();  // any will do
    return std::monostate{};
  }
  if (const char* const problem = speeds.problem(size)) return invalid(problem, "limits");
  if (const char* const problem = limited ? accelerations.problem(size) : nullptr) {
    return invalid(problem, "limits");
  }
  for (std::size_t i = 0; i < size; ++i) {
    into.push_back({speeds[i], limited ? accelerations[i] : FlightLimits().max_acceleration_mps2});
  }
  return std::monostate{};
}

Result<AdviseOptions> advise_options_of(const beespace_advise_options* options, std::size_t agents,
                                        const RunOptions& run, AdviseArrays& arrays) {
  const Result<beespace_advise_options> given = read_struct(options, "options");
  if (!given) return given.error();
  constexpr std::uint32_t kKnown = BEESPACE_PLANAR | BEESPACE_REMEMBER;
  if ((given->flags & ~kKnown) != 0) {
    return invalid("flags ask for what this function cannot do", "options");
  }
  if (given->method < BEESPACE_CERTIFIED || given->method > BEESPACE_MVP) {
    return invalid("method is none of BEESPACE_CERTIFIED, BEESPACE_ORCA and BEESPACE_MVP",
                   "options");
  }
  Status fences = read_fences(given->fence_directions, given->fence_offsets_m, arrays.fences);
  if (!fences) return std::move(fences).error();
  Status unknown = read_unknown(*given, arrays.unknown);
  if (!unknown) return std::move(unknown).error();
  Status claims = read_claims(*given, agents, arrays);
  if (!claims) return std::move(claims).error();
  const auto separation = separation_of(given->shape, given->vertical_factor, given->vertical_m);
  if (!separation) return separation.error();
  AdviseOptions all;
  Status intruders = read_intruders(*given, all);
  if (!intruders) return std::move(intruders).error();
  all.threshold_m = given->threshold_m;
  all.separation = *separation;
  all.step_s = given_or(given->step_s, all.step_s);
  if (given->obstacles != nullptr) all.obstacles = &given->obstacles->map;
  all.fences = arrays.fences;
  all.planar = (given->flags & BEESPACE_PLANAR) != 0;
  all.uncertainty_m = given->uncertainty_m;
  all.clearance_m = given_or_not(given->clearance_m);
  all.intruder_horizon_s = given_or(given->intruder_horizon_s, all.intruder_horizon_s);
  all.unknown = arrays.unknown;
  all.claims = arrays.claims;
  if ((given->flags & BEESPACE_REMEMBER) != 0) all.planes = &arrays.planes;
  all.unknown_horizon_s = given_or(given->unknown_horizon_s, all.unknown_horizon_s);
  all.method = static_cast<AdviseMethod>(given->method);
  all.threads = run.threads;
  all.stop = run.stop;
  return all;
}

}  // namespace beespace::c
