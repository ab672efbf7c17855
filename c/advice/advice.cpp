#include "c/advice/advice.hpp"

#include "c/door/door.hpp"
#include "c/door/movers.hpp"
#include "c/door/points.hpp"

#include <cstddef>
#include <utility>

namespace beespace::c {

std::int32_t kind_of(AdviceKind kind) {
  switch (kind) {
    case AdviceKind::kAsPreferred:
      return BEESPACE_AS_PREFERRED;
    case AdviceKind::kDeflected:
      return BEESPACE_DEFLECTED;
    case AdviceKind::kBraking:
      return BEESPACE_BRAKING;
    case AdviceKind::kWaiting:
      return BEESPACE_WAITING;
    case AdviceKind::kNone:
      return BEESPACE_NO_ADVICE;
  }
  return BEESPACE_NO_ADVICE;
}

namespace {

std::int32_t refused_kind_of(RefusedKind kind) {
  switch (kind) {
    case RefusedKind::kState:
      return BEESPACE_REFUSED_STATE;
    case RefusedKind::kPreferred:
      return BEESPACE_REFUSED_PREFERRED;
    case RefusedKind::kIntruder:
      return BEESPACE_REFUSED_INTRUDER;
    case RefusedKind::kUnknown:
      return BEESPACE_REFUSED_UNKNOWN;
  }
  return BEESPACE_REFUSED_STATE;
}

// C++ names some arrays after options that C has in columns, or not at all.
Refused with_place(Refused refused, const MoversView& movers) {
  Error& error = refused.error;
  error.location.record = refused.index;
  switch (refused.kind) {
    case RefusedKind::kState:
      if (error.location.array.empty()) error.location.array = kMovers.positions;
      error = with_array(std::move(error), movers, kMovers);
      break;
    case RefusedKind::kPreferred:
      error.location.array = "preferred";
      break;
    case RefusedKind::kIntruder:
      error.location.array = "intruders";
      break;
    case RefusedKind::kUnknown:
      error.location.array = "unknown";
      break;
  }
  return refused;
}

std::int64_t number(std::size_t index) {
  return static_cast<std::int64_t>(index);
}

}  // namespace

}  // namespace beespace::c

using beespace::c::Findings;

void beespace_advice::clear() {
  velocities.clear();
  kinds.clear();
  certified.clear();
  keeps_apart.clear();
  clear_of_intruders.clear();
  clear_of_unknown.clear();
  clear_of_unknown_s.clear();
  for (Findings& list : findings) list.clear();
  refused.clear();
}

void beespace_advice::write(const beespace::Advised& advised, const beespace::MoversView& movers) {
  const std::size_t size = advised.advice.size();
  velocities.resize(3 * size);
  kinds.resize(size);
  clear_of_unknown_s.resize(size);
  for (auto* const flags : {&certified, &keeps_apart, &clear_of_intruders, &clear_of_unknown}) {
    flags->resize(size);
  }
  for (std::size_t i = 0; i < size; ++i) {
    const beespace::Advice& advice = advised.advice[i];
    beespace::c::write_three(advice.velocity, &velocities[3 * i]);
    kinds[i] = beespace::c::kind_of(advice.kind);
    certified[i] = advice.certified ? 1 : 0;
    keeps_apart[i] = advice.keeps_apart ? 1 : 0;
    clear_of_intruders[i] = advice.clear_of_intruders ? 1 : 0;
    clear_of_unknown[i] = advice.clear_of_unknown ? 1 : 0;
    clear_of_unknown_s[i] = advice.clear_of_unknown_s;
  }
  using beespace::c::number;
  findings[BEESPACE_TOO_CLOSE].write(advised.too_close, true, [](const auto& close) {
    return Findings::Row{close.pair.first, close.pair.second, close.gap_m, close.clear_s};
  });
  findings[BEESPACE_NEAR_OBSTACLE].write(advised.near_obstacle, false, [](const auto& near) {
    return Findings::Row{near.agent, number(near.obstacle), near.gap_m};
  });
  findings[BEESPACE_NEAR_FENCE].write(advised.near_fence, false, [](const auto& near) {
    return Findings::Row{near.agent, number(near.fence), near.gap_m};
  });
  findings[BEESPACE_INTRUDER_CONFLICTS].write(
      advised.intruder_conflicts, true, [](const auto& conflict) {
        return Findings::Row{conflict.agent, number(conflict.intruder), conflict.closest_m,
                             conflict.begins_s};
      });
  findings[BEESPACE_NEAR_UNKNOWN].write(advised.near_unknown, true, [](const auto& near) {
    return Findings::Row{near.agent, number(near.unknown), near.gap_m, near.clear_s};
  });
  refused.clear();
  for (const beespace::Refused& each : advised.refused) {
    refused.push_back(beespace::c::with_place(each, movers));
  }
}

extern "C" {

beespace_advice* beespace_advice_create(void) {
  try {
    return new beespace_advice;
  } catch (...) {
    return nullptr;
  }
}

void beespace_advice_free(beespace_advice* advice) {
  delete advice;
}

int64_t beespace_advice_size(const beespace_advice* advice) {
  return advice == nullptr ? 0 : static_cast<int64_t>(advice->kinds.size());
}

const double* beespace_advice_velocities(const beespace_advice* advice) {
  return advice == nullptr ? nullptr : advice->velocities.data();
}

const int32_t* beespace_advice_kinds(const beespace_advice* advice) {
  return advice == nullptr ? nullptr : advice->kinds.data();
}

const uint8_t* beespace_advice_certified(const beespace_advice* advice) {
  return advice == nullptr ? nullptr : advice->certified.data();
}

const uint8_t* beespace_advice_keeps_apart(const beespace_advice* advice) {
  return advice == nullptr ? nullptr : advice->keeps_apart.data();
}

const uint8_t* beespace_advice_clear_of_intruders(const beespace_advice* advice) {
  return advice == nullptr ? nullptr : advice->clear_of_intruders.data();
}

const uint8_t* beespace_advice_clear_of_unknown(const beespace_advice* advice) {
  return advice == nullptr ? nullptr : advice->clear_of_unknown.data();
}

const double* beespace_advice_clear_of_unknown_s(const beespace_advice* advice) {
  return advice == nullptr ? nullptr : advice->clear_of_unknown_s.data();
}

beespace_code beespace_advice_findings(const beespace_advice* advice, int32_t what,
                                       beespace_findings* findings, beespace_error* error) {
  using beespace::c::invalid;
  return beespace::c::enter(error, [&]() -> beespace::Status {
    if (advice == nullptr) return invalid("the pointer to the advice is NULL", "advice");
    return Findings::show(Findings::of(advice->findings, what), findings);
  });
}

int64_t beespace_advice_refused_count(const beespace_advice* advice) {
  return advice == nullptr ? 0 : static_cast<int64_t>(advice->refused.size());
}

int32_t beespace_advice_refused(const beespace_advice* advice, int64_t index, beespace_error* why) {
  if (index < 0 || index >= beespace_advice_refused_count(advice)) return -1;
  const beespace::Refused& refused = advice->refused[static_cast<std::size_t>(index)];
  beespace::c::refuse(why, refused.error);
  return beespace::c::refused_kind_of(refused.kind);
}

}  // extern "C"
