#include "io/table/unit_choice.hpp"

#include "io/problems/excerpt.hpp"
#include "io/table/header_words.hpp"
#include "io/table/record_problems.hpp"

#include <algorithm>
#include <utility>

namespace beespace::io {
namespace {

bool is_metric(Unit unit) {
  return unit == Unit::kMetre || unit == Unit::kMetrePerSecond;
}

// What is usual in aviation.
Unit usual(UnitRole role) {
  if (role == UnitRole::kClimb) return Unit::kFootPerMinute;
  return role == UnitRole::kSpeed ? Unit::kKnot : Unit::kFoot;
}

Unit ours(UnitRole role) {
  return quantity_of(role) == Quantity::kLength ? Unit::kMetre : Unit::kMetrePerSecond;
}

}  // namespace

UnitChoice::UnitChoice(const std::vector<std::string>& names, const UnitOverrides& overrides)
    : names_(names),
      overrides_(overrides),
      source_(source_of(names)),
      aviation_(words_of_aviation(names)) {
}

// As --units aviation or metric says.
Unit UnitChoice::by_convention(UnitRole role) const {
  if (overrides_.convention == UnitConvention::kNone) return Unit::kUnstated;
  return overrides_.convention == UnitConvention::kMetric ? ours(role) : usual(role);
}

Error UnitChoice::unknown(UnitRole role, std::size_t column) const {
  const std::string name = column < names_.size() ? names_[column] : std::string();
  const std::string word(role_name(role));
  const std::string unit(symbol_of(usual(role)));
  const std::string metric(symbol_of(ours(role)));
  return at_column(ErrorCode::kInvalidArgument,
                   "column " + std::to_string(column + 1) +
                       (name.empty() ? "" : " " + excerpt(name)) + " holds the " + word +
                       ", but in which unit? " +
                       (units_differ()      ? std::string(source_->units_differ)
                        : aviation_.empty() ? overrides_.spoken_of + " speaks of aviation"
                                            : "The header speaks of aviation (" + aviation_ + ")") +
                       ", where it may be " + unit + " or " + metric + "; say it " +
                       (name.empty() ? ""
                                     : "in the header, as in " + excerpt(name + " [" + unit + "]") +
                                           " or " + excerpt(name + " [" + metric + "]") + ", or ") +
                       "with --units " + word + "=" + unit + " or " + word + "=" + metric +
                       (role == UnitRole::kPosition
                            ? ""
                            : "; --units aviation says ft, kt and ft/min of all, --units "
                              "metric m and m/s"),
                   column);
}

// Of a known source, in other units than --units aviation or metric says; with what to type where
// the answers alone shall be so.
Error UnitChoice::contradicts(const KnownColumn& known, Unit said, std::size_t column) const {
  const std::string convention =
      overrides_.convention == UnitConvention::kMetric ? "metric" : "aviation";
  std::string as_known;
  std::string as_said;
  for (const auto& [of, role] : {std::pair{Role::kHeight, UnitRole::kHeight},
                                 std::pair{Role::kGroundSpeed, UnitRole::kSpeed},
                                 std::pair{Role::kClimb, UnitRole::kClimb}}) {
    const auto first = source_->first(of, names_);
    if (!first) continue;
    const std::string before = "," + std::string(role_name(role)) + "=";
    as_known += before + std::string(symbol_of(source_->find(names_[*first])->unit));
    as_said += before + std::string(symbol_of(by_convention(role)));
  }
  return at_column(ErrorCode::kInvalidArgument,
                   "column " + std::to_string(column + 1) + " " + excerpt(names_[column]) +
                       " is in " + std::string(symbol_of(known.unit)) + " in tables of " +
                       std::string(source_->name) + ", whose header this is, but --units " +
                       convention + " says " + std::string(symbol_of(said)) +
                       "; leave that out, or, for answers in these units "
                       "only, say --units " +
                       convention + as_known + ", or, if the table is in them too, --units " +
                       convention + as_said,
                   column);
}

Result<UnitTaken> UnitChoice::choose(UnitRole role, const std::string& of, std::size_t column,
                                     Unit stated) {
  const std::string name = column < names_.size() ? excerpt(names_[column]) : "";
  Unit asked = overrides_.of(role);
  // What is said of all of a position holds for a height that says nothing of itself.
  if (asked == Unit::kUnstated && role == UnitRole::kHeight && stated == Unit::kUnstated) {
    asked = overrides_.position;
  }
  if (stated != Unit::kUnstated) {
    if (asked != Unit::kUnstated && asked != stated) {
      return at_column(ErrorCode::kInvalidArgument,
                       "column " + std::to_string(column + 1) + " " + name + " names its unit, " +
                           std::string(symbol_of(stated)) + ", but --units says " +
                           std::string(symbol_of(asked)) + "; leave one of them out",
                       column);
    }
    return UnitTaken{of, stated, UnitEvidence::kNamed, "the header names it: " + name};
  }
  if (asked != Unit::kUnstated)
    return UnitTaken{of, asked, UnitEvidence::kAsked, "asked for with --units"};
  if (source_ != nullptr && !name.empty()) {
    const KnownColumn* const known = source_->find(names_[column]);
    if (known != nullptr && known->unit != Unit::kUnstated) {
      const Unit said = role == UnitRole::kPosition ? Unit::kUnstated : by_convention(role);
      if (said != Unit::kUnstated && said != known->unit) return contradicts(*known, said, column);
      return UnitTaken{
          of, known->unit, UnitEvidence::kSource,
          "the header is that of " + std::string(source_->name) + ", which has " + name + " in it"};
    }
  }
  const UnitConvention convention = overrides_.convention;
  if (convention == UnitConvention::kMetric) {
    return UnitTaken{of, ours(role), UnitEvidence::kAsked, "asked for with --units metric"};
  }
  if (convention == UnitConvention::kAviation && role != UnitRole::kPosition) {
    return UnitTaken{of, usual(role), UnitEvidence::kAsked, "asked for with --units aviation"};
  }
  if ((!aviation_.empty() || units_differ()) && !name.empty()) {
    return unknown(role, column);
  }
  if (!overrides_.spoken_of.empty() && role == UnitRole::kHeight) return unknown(role, column);
  if (convention == UnitConvention::kAviation) {
    return at_column(ErrorCode::kInvalidArgument,
                     "--units aviation does not say in which unit x, y and z are; add it, as in "
                     "--units aviation,position=NM or position=m",
                     column);
  }
  return UnitTaken{of, ours(role), UnitEvidence::kUsual,
                   names_.empty() ? "there is no header that says otherwise"
                                  : "no unit is named, and nothing speaks of aviation"};
}

std::optional<Error> half_stated(const std::vector<std::string>& names,
                                 const std::vector<ColumnUnit>& units) {
  const auto foreign = std::find_if(units.begin(), units.end(), [](const ColumnUnit& one) {
    return one.evidence == UnitEvidence::kNamed && !is_metric(one.unit);
  });
  const auto silent = std::find_if(units.begin(), units.end(), [](const ColumnUnit& one) {
    return one.evidence == UnitEvidence::kUsual;
  });
  if (foreign == units.end() || silent == units.end()) return std::nullopt;
  return at_column(
      ErrorCode::kInvalidArgument,
      "column " + excerpt(names[foreign->column]) + " is in " +
          std::string(symbol_of(foreign->unit)) + ", but " + excerpt(names[silent->column]) +
          " beside it names no unit; name it in the header too, as in " +
          excerpt(names[silent->column] + " [" + std::string(symbol_of(foreign->unit)) + "]"),
      silent->column);
}

}  // namespace beespace::io
