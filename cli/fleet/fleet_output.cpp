#include "cli/fleet/fleet_output.hpp"

#include "analysis/recorded/unknown_while_set.hpp"
#include "io/recording/moment_text.hpp"

#include <beespace/version.hpp>

#include <cmath>
#include <string>
#include <utility>

namespace beespace::cli {
namespace {

using analysis::BeeDeviation;
using analysis::Extreme;
using analysis::TrackingFigures;

// No finer than fixes are.
double to_thousandths(double value) {
  return std::round(value * 1e3) / 1e3;
}

// The same of how far the farthest was, but never on the other side of the limit.
double shown_m(double metres, const std::optional<double>& limit_m) {
  const double shown = to_thousandths(metres);
  const bool crosses = limit_m && (metres > *limit_m) != (shown > *limit_m);
  return crosses ? metres : shown;
}

void write_extreme(io::JsonWriter& json, const char* name, const Extreme& extreme) {
  json.begin_object(name);
  json.member("greatest", extreme.greatest).member("usual", extreme.usual).end();
}

void write_farthest(io::JsonWriter& json, const FleetAnswer& answer) {
  const auto bee = farthest_bee(answer);
  if (!bee) return;
  const BeeDeviation& of = *answer.figures.each[*bee];
  json.begin_object("farthest");
  json.member("id", answer.both.flown_ids[*bee]).member("set_id", answer.both.set_ids[*bee]);
  json.member("deviation_m", of.farthest_m);
  const io::Calendar calendar = io::calendar_of(answer.flown);
  if (calendar.tells()) {
    json.member("at", calendar.text(of.farthest_s));
  } else {
    json.member("at_s", of.farthest_s);
  }
  json.end();
}

void write_unmatched(io::JsonWriter& json, const SetBesideFlown& both) {
  json.member("only_one", std::uint64_t{both.only_flown.size() + both.only_set.size()});
  json.begin_array("only_flown");
  for (const std::string& id : both.only_flown) json.value(id);
  json.end().begin_array("only_set");
  for (const OnlySet& one : both.only_set) json.value(one.id);
  json.end();
}

}  // namespace

double up_to_mm(double value) {
  return std::ceil(value * 1e3) / 1e3;
}

std::optional<std::size_t> farthest_bee(const FleetAnswer& answer) {
  const auto& each = answer.figures.each;
  std::optional<std::size_t> farthest;
  for (std::size_t i = 0; i < each.size(); ++i) {
    if (!each[i]) continue;
    if (!farthest || each[i]->farthest_m > each[*farthest]->farthest_m) farthest = i;
  }
  return farthest;
}

std::vector<std::size_t> bees_too_far(const FleetAnswer& answer) {
  std::vector<std::size_t> bees;
  if (!answer.max_deviation_m) return bees;
  const auto& each = answer.figures.each;
  for (std::size_t i = 0; i < each.size(); ++i) {
    if (each[i] && each[i]->farthest_m > *answer.max_deviation_m) bees.push_back(i);
  }
  return bees;
}

double unknown_s(const FleetAnswer& answer, std::size_t bee) {
  return analysis::length_of(answer.both.unknown[bee]);
}

double unknown_s(const FleetAnswer& answer) {
  double seconds = 0.0;
  for (std::size_t i = 0; i < answer.both.unknown.size(); ++i) seconds += unknown_s(answer, i);
  for (const OnlySet& one : answer.both.only_set) seconds += one.seconds;
  return seconds;
}

bool is_known(const FleetAnswer& answer) {
  return unknown_s(answer) <= 0.0 && answer.both.only_flown.empty() &&
         answer.both.only_set.empty() && answer.flown.missing.none();
}

Rows fleet_rows(const FleetAnswer& answer) {
  Rows rows{{{"id"},
             {"set_id"},
             {"farthest_m"},
             {"farthest_s", nullptr, "farthest"},
             {"mean_m"},
             {"p95_m"},
             {"fixes"},
             {"unknown_s"}},
            {},
            false,
            io::calendar_of(answer.flown)};
  const SetBesideFlown& both = answer.both;
  for (std::size_t bee = 0; bee < both.bees.size(); ++bee) {
    std::vector<Value> row{both.flown_ids[bee], both.set_ids[bee]};
    if (const auto& of = answer.figures.each[bee]) {
      row.insert(row.end(), {shown_m(of->farthest_m, answer.max_deviation_m), of->farthest_s,
                             to_thousandths(of->mean_m), to_thousandths(of->p95_m), of->fixes});
    } else {
      row.insert(row.end(), {Value(), Value(), Value(), Value(), std::uint64_t{0}});
    }
    row.emplace_back(to_thousandths(unknown_s(answer, bee)));
    rows.rows.push_back(std::move(row));
  }
  for (const OnlySet& one : both.only_set) {
    rows.rows.push_back({Value(), one.id, Value(), Value(), Value(), Value(), std::uint64_t{0},
                         to_thousandths(one.seconds)});
  }
  for (const std::string& id : both.only_flown) {
    rows.rows.push_back(
        {id, Value(), Value(), Value(), Value(), Value(), std::uint64_t{0}, Value()});
  }
  return rows;
}

void write_figures(io::JsonWriter& json, const FleetAnswer& answer) {
  const TrackingFigures& figures = answer.figures;
  json.member("version", version()).member("command", "fleet");
  json.member("bees", std::uint64_t{answer.both.bees.size()});
  write_unmatched(json, answer.both);
  json.member("fixes", figures.fixes).member("not_set", figures.not_set);
  json.member("known", is_known(answer)).member("unknown_s", unknown_s(answer));
  if (answer.max_deviation_m) {
    json.member("max_deviation_m", *answer.max_deviation_m);
    json.member("farther", std::uint64_t{bees_too_far(answer).size()});
  }
  write_extreme(json, "deviation_m", figures.deviation_m);
  write_extreme(json, "rate_mps", figures.rate_mps);
  write_extreme(json, "acceleration_mps2", figures.acceleration_mps2);
  json.member("lag_s", figures.lag_s);
  write_extreme(json, "without_lag_m", figures.without_lag_m);
  json.begin_object("plan").member("sensing_error_m", up_to_mm(figures.deviation_m.greatest));
  json.member("deviation_mps", 0.0);
  json.member("correction_mps", up_to_mm(figures.rate_mps.greatest)).end();
  write_farthest(json, answer);
}

}  // namespace beespace::cli
