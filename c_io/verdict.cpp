// What a verification along curves found, in columns.
#include "c_io/verdict.hpp"

#include "c/door/door.hpp"
#include "c/door/structs.hpp"
#include "c_io/door.hpp"

#include <beespace_io.h>
#include <beespace/verify_path.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

using namespace beespace::c_io;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Status;
using beespace::c::invalid;

namespace beespace::c_io {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

static_assert(static_cast<int>(PathLimit::kSpeed) == BEESPACE_IO_SPEED);
static_assert(static_cast<int>(PathLimit::kHorizontalSpeed) == BEESPACE_IO_HORIZONTAL);
static_assert(static_cast<int>(PathLimit::kClimb) == BEESPACE_IO_CLIMB);
static_assert(static_cast<int>(PathLimit::kDescent) == BEESPACE_IO_DESCENT);
static_assert(static_cast<int>(PathLimit::kAcceleration) == BEESPACE_IO_ACCELERATION);
static_assert(static_cast<int>(PathLimit::kHeight) == BEESPACE_IO_HEIGHT);

struct Finding {
  std::int32_t kind;
  std::int64_t first;
  std::int64_t second;
  double begins_s;
  double ends_s;
  double value;
  double at_s;
};

void append(const Finding& finding, beespace_io_verdict& into) {
  into.kinds.push_back(finding.kind);
  into.first.push_back(finding.first);
  into.second.push_back(finding.second);
  into.begins_s.push_back(finding.begins_s);
  into.ends_s.push_back(finding.ends_s);
  into.values.push_back(finding.value);
  into.at_s.push_back(finding.at_s);
}

// Down is no climb, and up no descent.
double shown_value(double value, std::size_t limit) {
  const bool signed_one = limit == BEESPACE_IO_CLIMB || limit == BEESPACE_IO_DESCENT;
  return signed_one ? std::max(0.0, value) : value;
}

}  // namespace

void write_findings(const analysis::PathVerdict& found, beespace_io_verdict& into) {
  for (const Conflict& loss : found.losses) {
    append({BEESPACE_IO_LOSS, loss.first, loss.second, loss.begins_s, loss.ends_s, loss.closest_m,
            loss.closest_s},
           into);
  }
  for (const auto& [bee, loss] : found.clearance_losses) {
    append({BEESPACE_IO_CLEARANCE, bee, static_cast<std::int64_t>(loss.obstacle), loss.begins_s,
            loss.ends_s, loss.closest_m, kNothing},
           into);
  }
  for (const auto& [bee, excess, beside] : found.breaches) {
    append({static_cast<std::int32_t>(excess.limit), bee, -1, excess.begins_s, excess.ends_s,
            excess.peak.value, excess.peak.at_s},
           into);
  }
  into.facts.losses = static_cast<std::int64_t>(found.losses.size());
  into.facts.clearance_losses = static_cast<std::int64_t>(found.clearance_losses.size());
  into.facts.breaches = static_cast<std::int64_t>(found.breaches.size());
  into.facts.ignored = static_cast<std::int64_t>(found.low.left_out.size());
  into.facts.takeoff_unknown = static_cast<std::int64_t>(found.low.bees_not_known);
}

void write_extremes(const analysis::PathVerdict& found, beespace_io_verdict_facts& into) {
  for (std::size_t k = 0; k < kPathLimits; ++k) {
    const auto& peak = found.peaks[k];
    into.greatest[k] = peak ? shown_value(peak->peak.value, k) : kNothing;
    into.greatest_s[k] = peak ? peak->peak.at_s : kNothing;
    into.greatest_agent[k] = peak ? peak->bee : std::int64_t{-1};
  }
  const auto& closest = found.closest;
  into.closest_first = closest ? closest->first : std::int64_t{-1};
  into.closest_second = closest ? closest->second : std::int64_t{-1};
  into.closest_m = closest ? closest->closest_m : kNothing;
  into.closest_s = closest ? closest->closest_s : kNothing;
}

}  // namespace beespace::c_io

namespace {

// Of programs that were built before there was `ignored`.
constexpr std::size_t kFirstVerdictFacts = offsetof(beespace_io_verdict_facts, ignored);

template <class Number>
const Number* column(const beespace_io_verdict* verdict,
                     std::vector<Number> beespace_io_verdict::*numbers) {
  if (verdict == nullptr || (verdict->*numbers).empty()) return nullptr;
  return (verdict->*numbers).data();
}

}  // namespace

extern "C" {

void beespace_io_verdict_free(beespace_io_verdict* verdict) {
  delete verdict;
}

beespace_code beespace_io_verdict_facts_of(const beespace_io_verdict* verdict,
                                           beespace_io_verdict_facts* facts,
                                           beespace_io_error* error) {
  return enter(error, [&]() -> Status {
    if (verdict == nullptr) return invalid("the verdict is NULL", "verdict");
    return beespace::c::write_struct(facts, verdict->facts, "facts", kFirstVerdictFacts);
  });
}

beespace_code beespace_io_verdict_coverage(const beespace_io_verdict* verdict,
                                           beespace_io_coverage* coverage,
                                           beespace_io_error* error) {
  return enter(error, [&]() -> Status {
    if (verdict == nullptr) return invalid("the verdict is NULL", "verdict");
    return beespace::c::write_struct(coverage, verdict->coverage, "coverage");
  });
}

int64_t beespace_io_verdict_size(const beespace_io_verdict* verdict) {
  return verdict == nullptr ? 0 : static_cast<int64_t>(verdict->kinds.size());
}

const int32_t* beespace_io_verdict_kinds(const beespace_io_verdict* verdict) {
  return column(verdict, &beespace_io_verdict::kinds);
}

const int64_t* beespace_io_verdict_first(const beespace_io_verdict* verdict) {
  return column(verdict, &beespace_io_verdict::first);
}

const int64_t* beespace_io_verdict_second(const beespace_io_verdict* verdict) {
  return column(verdict, &beespace_io_verdict::second);
}

const double* beespace_io_verdict_begins_s(const beespace_io_verdict* verdict) {
  return column(verdict, &beespace_io_verdict::begins_s);
}

const double* beespace_io_verdict_ends_s(const beespace_io_verdict* verdict) {
  return column(verdict, &beespace_io_verdict::ends_s);
}

const double* beespace_io_verdict_values(const beespace_io_verdict* verdict) {
  return column(verdict, &beespace_io_verdict::values);
}

const double* beespace_io_verdict_at_s(const beespace_io_verdict* verdict) {
  return column(verdict, &beespace_io_verdict::at_s);
}

const char* beespace_io_verdict_not_looked_at(const beespace_io_verdict* verdict) {
  return verdict == nullptr ? "" : verdict->not_looked_at.c_str();
}

const char* beespace_io_finding_name(int32_t kind) {
  switch (kind) {
    case BEESPACE_IO_SPEED:
      return "speed";
    case BEESPACE_IO_HORIZONTAL:
      return "horizontal";
    case BEESPACE_IO_CLIMB:
      return "climb";
    case BEESPACE_IO_DESCENT:
      return "descent";
    case BEESPACE_IO_ACCELERATION:
      return "acceleration";
    case BEESPACE_IO_HEIGHT:
      return "height";
    case BEESPACE_IO_LOSS:
      return "loss";
    case BEESPACE_IO_CLEARANCE:
      return "clearance";
    default:
      return "unknown";
  }
}

}  // extern "C"
