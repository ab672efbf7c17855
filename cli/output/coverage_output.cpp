#include "cli/output/coverage_output.hpp"

#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "io/bytes/number_text.hpp"
#include "io/json/json_text.hpp"

#include <cmath>
#include <cstddef>

namespace beespace::cli {

void append_coverage(std::string& out, const analysis::Coverage& coverage,
                     const io::Recording& recording) {
  if (coverage.max_gap.typical_s || coverage.max_gap.asked) {
    append_summary_line(out, "max gap", analysis::max_gap_text(coverage.max_gap));
  }
  if (coverage.gaps > 0) {
    append_summary_line(out, "unknown",
                        red(io::counted(coverage.bees_with_gaps, "bee", "bees")) + " in " +
                            io::grouped(coverage.gaps) + (coverage.gaps == 1 ? " gap" : " gaps") +
                            " between two fixes, for " + io::time_span(coverage.in_gaps_s) +
                            " in all");
  }
  for (const Gap& gap : coverage.longest) {
    append_summary_line(out, "", printable(analysis::gap_text(gap, recording)));
  }
  if (coverage.gaps > coverage.longest.size()) {
    append_summary_line(out, "", "and shorter ones");
  }
  if (coverage.bees_partly > 0) {
    append_summary_line(out, coverage.gaps > 0 ? "" : "unknown",
                        io::counted(coverage.bees_partly, "bee", "bees") +
                            " before the first or after the last fix, for " +
                            io::time_span(coverage.outside_s) + " in all");
  }
  append_missing(out, coverage.missing);
}

std::string coverage_json(const analysis::Coverage& coverage, const io::Recording& recording) {
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
    out += ", \"lasts_s\": " + io::exact(analysis::length_of(gap)) + "}";
  }
  return out + "]}";
}

void append_missing(std::string& out, const io::MissingRecords& missing) {
  if (missing.count == 0) return;
  std::string text = red(io::counted(missing.count, "record", "records"));
  if (missing.without_id < missing.count) text += " of " + io::counted(missing.bees, "bee", "bees");
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

}  // namespace beespace::cli
