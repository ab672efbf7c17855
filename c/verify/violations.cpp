#include "c/verify/violations.hpp"

namespace beespace::c {

namespace {

// One row after the other.
class ViolationWriter {
 public:
  explicit ViolationWriter(beespace_violations& into) : into_(into) {}

  void add(std::int32_t kind, std::int64_t first, std::int64_t second, double begins_s,
           double ends_s, double value) {
    into_.kinds[row_] = kind;
    into_.first[row_] = first;
    into_.second[row_] = second;
    into_.begins_s[row_] = begins_s;
    into_.ends_s[row_] = ends_s;
    into_.values[row_] = value;
    ++row_;
  }

 private:
  beespace_violations& into_;
  std::size_t row_ = 0;
};

std::int32_t number_of(BreachKind kind) {
  return kind == BreachKind::kSpeed ? BEESPACE_VIOLATION_SPEED : BEESPACE_VIOLATION_ACCELERATION;
}

}  // namespace

void write_violations(const Verdict& verdict, std::span<const double> breach_ends_s,
                      beespace_violations& into) {
  into.resize(verdict.first_losses.size() + verdict.first_clearance_losses.size() +
              verdict.first_breaches.size());
  ViolationWriter rows(into);
  for (const Loss& loss : verdict.first_losses) {
    rows.add(BEESPACE_VIOLATION_LOSS, loss.pair.first, loss.pair.second, loss.begins_s, loss.ends_s,
             loss.closest_m);
  }
  for (const ClearanceLoss& loss : verdict.first_clearance_losses) {
    rows.add(BEESPACE_VIOLATION_CLEARANCE, loss.agent, static_cast<std::int64_t>(loss.obstacle),
             loss.begins_s, loss.ends_s, loss.closest_m);
  }
  std::size_t breach = 0;
  for (const Breach& each : verdict.first_breaches) {
    rows.add(number_of(each.kind), each.agent, -1, each.begins_s, breach_ends_s[breach++],
             each.value);
  }
}

}  // namespace beespace::c

void beespace_violations::resize(std::size_t size) {
  kinds.resize(size);
  first.resize(size);
  second.resize(size);
  begins_s.resize(size);
  ends_s.resize(size);
  values.resize(size);
}

extern "C" {

const char* beespace_violation_name(int32_t kind) {
  switch (kind) {
    case BEESPACE_VIOLATION_LOSS:
      return "loss";
    case BEESPACE_VIOLATION_CLEARANCE:
      return "clearance";
    case BEESPACE_VIOLATION_SPEED:
      return "speed";
    case BEESPACE_VIOLATION_ACCELERATION:
      return "acceleration";
    default:
      return "unknown";
  }
}

beespace_violations* beespace_violations_create(void) {
  try {
    return new beespace_violations;
  } catch (...) {
    return nullptr;
  }
}

void beespace_violations_free(beespace_violations* violations) {
  delete violations;
}

int64_t beespace_violations_size(const beespace_violations* violations) {
  return violations == nullptr ? 0 : static_cast<int64_t>(violations->kinds.size());
}

const int32_t* beespace_violations_kinds(const beespace_violations* violations) {
  return violations == nullptr ? nullptr : violations->kinds.data();
}

const int64_t* beespace_violations_first(const beespace_violations* violations) {
  return violations == nullptr ? nullptr : violations->first.data();
}

const int64_t* beespace_violations_second(const beespace_violations* violations) {
  return violations == nullptr ? nullptr : violations->second.data();
}

const double* beespace_violations_begins_s(const beespace_violations* violations) {
  return violations == nullptr ? nullptr : violations->begins_s.data();
}

const double* beespace_violations_ends_s(const beespace_violations* violations) {
  return violations == nullptr ? nullptr : violations->ends_s.data();
}

const double* beespace_violations_values(const beespace_violations* violations) {
  return violations == nullptr ? nullptr : violations->values.data();
}

}  // extern "C"
