#include "cli/analysis/coverage.hpp"

#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "cli/input/moving_output.hpp"
#include "io/bytes/number_text.hpp"
#include "io/json/json_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace beespace::cli {
namespace {

double length_of(const Gap& gap) {
  return gap.ends_s - gap.begins_s;
}

std::string bees_text(std::size_t count) {
  return io::grouped(std::uint64_t{count}) + (count == 1 ? " bee" : " bees");
}

std::string records_text(std::uint64_t count) {
  return io::grouped(count) + (count == 1 ? " record" : " records");
}

// From the first fix of all to the last one.
std::pair<double, double> whole_time(const io::Recording& recording) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::pair<double, double> time{kInfinity, -kInfinity};
  for (const io::RecordedBee& bee : recording.bees) {
    if (bee.fixes.empty()) continue;
    time.first = std::min(time.first, bee.fixes.front().time_s);
    time.second = std::max(time.second, bee.fixes.back().time_s);
  }
  return time;
}

// Before its first fix and after its last one; of a show's drone, which has no fixes, none.
double outside_s(const io::RecordedBee& bee, const std::pair<double, double>& whole) {
  if (bee.fixes.empty()) return 0.0;
  return (bee.fixes.front().time_s - whole.first) + (whole.second - bee.fixes.back().time_s);
}

}  // namespace

std::vector<double> unknown_times_s(const io::Recording& recording, const std::vector<Gap>& gaps) {
  const auto whole = whole_time(recording);
  std::vector<double> unknown_s;
  for (const io::RecordedBee& bee : recording.bees) unknown_s.push_back(outside_s(bee, whole));
  for (const Gap& gap : gaps) unknown_s[gap.track] += length_of(gap);
  return unknown_s;
}

Coverage coverage_of(const io::Recording& recording, const std::vector<Gap>& gaps,
                     const MaxGap& max_gap) {
  Coverage coverage;
  coverage.max_gap = max_gap;
  coverage.gaps = gaps.size();
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    coverage.in_gaps_s += length_of(gaps[i]);
    if (i == 0 || gaps[i - 1].track != gaps[i].track) ++coverage.bees_with_gaps;
  }
  coverage.longest = gaps;
  const auto named = coverage.longest.begin() +
                     static_cast<std::ptrdiff_t>(std::min(Coverage::kMostNamed, gaps.size()));
  std::partial_sort(coverage.longest.begin(), named, coverage.longest.end(),
                    [](const Gap& a, const Gap& b) {
                      if (length_of(a) != length_of(b)) return length_of(a) > length_of(b);
                      return a.track != b.track ? a.track < b.track : a.begins_s < b.begins_s;
                    });
  coverage.longest.erase(named, coverage.longest.end());
  const auto whole = whole_time(recording);
  for (const io::RecordedBee& bee : recording.bees) {
    const double missing_s = outside_s(bee, whole);
    coverage.outside_s += missing_s;
    if (missing_s > 0.0) ++coverage.bees_partly;
  }
  coverage.missing = recording.missing;
  return coverage;
}

std::string unknown_text(const Coverage& coverage) {
  std::string text;
  const auto append = [&text](const std::string& more) {
    if (!text.empty() && !more.empty()) text += ", ";
    text += more;
  };
  if (coverage.gaps > 0) {
    append(bees_text(coverage.bees_with_gaps) + " unknown for " +
           io::time_span(coverage.in_gaps_s) + " in all");
  }
  if (coverage.bees_partly > 0) {
    append(bees_text(coverage.bees_partly) + " known for a part of the recording only");
  }
  append(missing_text(coverage.missing));
  return text;
}

std::string missing_text(const io::MissingRecords& missing) {
  if (missing.count == 0) return {};
  std::string text;
  if (missing.nowhere > 0) {
    text = io::grouped(missing.nowhere) +
           (missing.nowhere == 1 ? " bee is known nowhere, " : " bees are known nowhere, ");
  }
  return text + records_text(missing.count) + (missing.count == 1 ? " was" : " were") + " left out";
}

void append_missing(std::string& out, const io::MissingRecords& missing) {
  if (missing.count == 0) return;
  std::string text = red(records_text(missing.count));
  if (missing.without_id < missing.count) text += " of " + bees_text(missing.bees);
  if (missing.without_id > 0) {
    text += missing.without_id == missing.count
                ? " of unknown bees"
                : " and " + io::grouped(missing.without_id) + " of unknown ones";
  }
  append_summary_line(out, "left out", text + ": place, height or time is missing or bad");
  if (missing.nowhere == 0) return;
  std::string named;
  for (const std::string& id : missing.nowhere_ids) named += (named.empty() ? "" : ", ") + id;
  if (missing.nowhere > missing.nowhere_ids.size()) named += ", ...";
  append_summary_line(out, "", "known nowhere: " + printable(named));
}

std::string missing_json(const io::MissingRecords& missing) {
  std::string out = "\"left_out_records\": " + std::to_string(missing.count);
  out += ", \"left_out_without_id\": " + std::to_string(missing.without_id);
  out += ", \"left_out_bees\": " + std::to_string(missing.bees);
  out += ", \"bees_known_nowhere\": " + std::to_string(missing.nowhere);
  out += ", \"known_nowhere\": [";
  for (const std::string& id : missing.nowhere_ids) {
    if (&id != &missing.nowhere_ids.front()) out += ", ";
    io::append_json_string(out, id);
  }
  return out + "]";
}

std::string gap_text(const Gap& gap, const io::Recording& recording) {
  return text_of(name_of(gap.track, recording)) + " from " + moment(gap.begins_s, recording) +
         " for " + io::time_span(length_of(gap));
}

void append_coverage(std::string& out, const Coverage& coverage, const io::Recording& recording) {
  if (coverage.max_gap.typical_s || coverage.max_gap.asked) {
    append_summary_line(out, "max gap", max_gap_text(coverage.max_gap));
  }
  if (coverage.gaps > 0) {
    append_summary_line(out, "unknown",
                        red(bees_text(coverage.bees_with_gaps)) + " in " +
                            io::grouped(coverage.gaps) + (coverage.gaps == 1 ? " gap" : " gaps") +
                            " between two fixes, for " + io::time_span(coverage.in_gaps_s) +
                            " in all");
  }
  for (const Gap& gap : coverage.longest) {
    append_summary_line(out, "", printable(gap_text(gap, recording)));
  }
  if (coverage.gaps > coverage.longest.size()) {
    append_summary_line(out, "", "and shorter ones");
  }
  if (coverage.bees_partly > 0) {
    append_summary_line(out, coverage.gaps > 0 ? "" : "unknown",
                        bees_text(coverage.bees_partly) +
                            " before the first or after the last fix, for " +
                            io::time_span(coverage.outside_s) + " in all");
  }
  append_missing(out, coverage.missing);
}

std::string coverage_json(const Coverage& coverage, const io::Recording& recording) {
  const auto finite = [](double value) {
    return std::isfinite(value) ? io::exact(value) : std::string("null");
  };
  const auto& typical_s = coverage.max_gap.typical_s;
  std::string out = std::string("{\"complete\": ") + (coverage.complete() ? "true" : "false");
  out += ", \"max_gap_s\": " + finite(coverage.max_gap.seconds);
  out += ", \"typical_interval_s\": " + (typical_s ? io::exact(*typical_s) : std::string("null"));
  out += ", \"gap_count\": " + std::to_string(coverage.gaps);
  out += ", \"bees_with_gaps\": " + std::to_string(coverage.bees_with_gaps);
  out += ", \"in_gaps_s\": " + io::exact(coverage.in_gaps_s);
  out += ", \"bees_partly_known\": " + std::to_string(coverage.bees_partly);
  out += ", \"before_first_and_after_last_s\": " + io::exact(coverage.outside_s);
  out += ",\n    " + missing_json(coverage.missing);
  out += ",\n    \"longest_gaps\": [";
  for (std::size_t i = 0; i < coverage.longest.size(); ++i) {
    const Gap& gap = coverage.longest[i];
    out += i > 0 ? ",\n      {\"id\": " : "\n      {\"id\": ";
    io::append_json_string(out, recording.bees[gap.track].id);
    out += ", \"begins_s\": " + io::exact(gap.begins_s) + ", \"ends_s\": " + io::exact(gap.ends_s);
    out += ", \"lasts_s\": " + io::exact(length_of(gap)) + "}";
  }
  return out + "]}";
}

}  // namespace beespace::cli
