#include "c/verify/findings.hpp"

namespace beespace::c {

namespace {

// One row after the other.
class FindingWriter {
 public:
  explicit FindingWriter(beespace_findings& into) : into_(into) {}

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
  beespace_findings& into_;
  std::size_t row_ = 0;
};

std::int32_t number_of(BreachKind kind) {
  return kind == BreachKind::kSpeed ? BEESPACE_FINDING_SPEED : BEESPACE_FINDING_ACCELERATION;
}

}  // namespace

void write_findings(const Verdict& verdict, std::span<const double> breach_ends_s,
                    beespace_findings& into) {
  into.resize(verdict.first_losses.size() + verdict.first_clearance_losses.size() +
              verdict.first_breaches.size());
  FindingWriter rows(into);
  for (const Loss& loss : verdict.first_losses) {
    rows.add(BEESPACE_FINDING_LOSS, loss.pair.first, loss.pair.second, loss.begins_s, loss.ends_s,
             loss.closest_m);
  }
  for (const ClearanceLoss& loss : verdict.first_clearance_losses) {
    rows.add(BEESPACE_FINDING_CLEARANCE, loss.agent, static_cast<std::int64_t>(loss.obstacle),
             loss.begins_s, loss.ends_s, loss.closest_m);
  }
  std::size_t breach = 0;
  for (const Breach& each : verdict.first_breaches) {
    rows.add(number_of(each.kind), each.agent, -1, each.begins_s, breach_ends_s[breach++],
             each.value);
  }
}

}  // namespace beespace::c

void beespace_findings::resize(std::size_t size) {
  kinds.resize(size);
  first.resize(size);
  second.resize(size);
  begins_s.resize(size);
  ends_s.resize(size);
  values.resize(size);
}

extern "C" {

const char* beespace_finding_name(int32_t kind) {
  switch (kind) {
    case BEESPACE_FINDING_LOSS:
      return "loss";
    case BEESPACE_FINDING_CLEARANCE:
      return "clearance";
    case BEESPACE_FINDING_SPEED:
      return "speed";
    case BEESPACE_FINDING_ACCELERATION:
      return "acceleration";
    default:
      return "unknown";
  }
}

beespace_findings* beespace_findings_create(void) {
  try {
    return new beespace_findings;
  } catch (...) {
    return nullptr;
  }
}

void beespace_findings_free(beespace_findings* findings) {
  delete findings;
}

int64_t beespace_findings_size(const beespace_findings* findings) {
  return findings == nullptr ? 0 : static_cast<int64_t>(findings->kinds.size());
}

const int32_t* beespace_findings_kinds(const beespace_findings* findings) {
  return findings == nullptr ? nullptr : findings->kinds.data();
}

const int64_t* beespace_findings_first(const beespace_findings* findings) {
  return findings == nullptr ? nullptr : findings->first.data();
}

const int64_t* beespace_findings_second(const beespace_findings* findings) {
  return findings == nullptr ? nullptr : findings->second.data();
}

const double* beespace_findings_begins_s(const beespace_findings* findings) {
  return findings == nullptr ? nullptr : findings->begins_s.data();
}

const double* beespace_findings_ends_s(const beespace_findings* findings) {
  return findings == nullptr ? nullptr : findings->ends_s.data();
}

const double* beespace_findings_values(const beespace_findings* findings) {
  return findings == nullptr ? nullptr : findings->values.data();
}

}  // extern "C"
