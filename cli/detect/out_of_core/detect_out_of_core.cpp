#include "cli/detect/out_of_core/detect_out_of_core.hpp"

#include "cli/command_line/option_values.hpp"
#include "cli/console/progress_bar.hpp"
#include "cli/console/stopwatch.hpp"
#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "cli/detect/json_facts.hpp"
#include "cli/detect/load_inputs.hpp"
#include "cli/detect/out_of_core/large_ids.hpp"
#include "cli/detect/out_of_core/large_input.hpp"
#include "cli/detect/out_of_core/large_search.hpp"
#include "cli/detect/out_of_core/large_table.hpp"
#include "cli/detect/summary.hpp"
#include "cli/input/temporary_folder.hpp"
#include "cli/output/block_writer.hpp"
#include "cli/output/output_file.hpp"
#include "io/bytes/number_text.hpp"

#include <beespace/version.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace beespace::cli {
namespace {

// The summary names no more files than these.
constexpr std::size_t kFilesShown = 5;

class Detecting {
 public:
  Detecting(const DetectRequest& request, LargeInput& input, const LargeMemory& memory,
            io::AtomicOutput& output, ProgressBar& bar)
      : request_(request),
        input_(input),
        memory_(memory),
        output_(output),
        bar_(bar),
        folder_(temporary_folder(request.temporary)),
        search_(request, folder_, memory, bar),
        ids_(folder_),
        records_(folder_),
        places_(folder_),
        shown_(input.own_ids() ? &ids_ : nullptr, input.skipped()) {}

  Result<ExitCode> run() {
    if (auto status = input_.check_room(folder_, writes_records()); !status) return status.error();
    Status status = read();
    if (status) status = search_.find();
    if (!status) return input_.placed(std::move(status).error());
    timings_.search_s = watch_.lap();
    // What was searched where it is, was it the same all the time?
    if (status = input_.check_unchanged(); !status) return std::move(status).error();
    search_.release();
    bar_.enter_stage("writing");
    if (status = write(); !status) return std::move(status).error();
    status = output_.commit();
    if (!status && output_.pipe_closed()) return ExitCode::kPipeClosed;
    if (!status) return std::move(status).error();
    timings_.write_s = watch_.lap();
    bar_.finish();
    if (!request_.quiet) say(summary());
    const bool finds_risk = search_.at_risk() != nullptr && search_.at_risk()->count() > 0;
    const bool is_risky = finds_risk || skipped() > 0;
    return request_.fail_on_risk && is_risky ? ExitCode::kRiskFound : ExitCode::kFine;
  }

 private:
  // Whether the answer has the records of bees themselves.
  [[nodiscard]] bool writes_records() const {
    const std::string_view report = request_.report->name;
    return request_.form.form == Form::kCsv && report != "pairs" && report != "closest-pair";
  }

  // Whether how far a pair is apart is told of them.
  [[nodiscard]] bool needs_places() const {
    return request_.vertical && std::string_view(request_.report->name) == "pairs";
  }

  [[nodiscard]] std::array<TextStore*, 3> stores() { return {&ids_, &records_, &places_}; }

  [[nodiscard]] std::uint64_t skipped() const { return input_.skipped().rows.size(); }

  Status read() {
    const LargeInputSinks sinks = {search_.points(), input_.own_ids() ? &ids_ : nullptr,
                                   writes_records() ? &records_ : nullptr,
                                   needs_places() ? &places_ : nullptr};
    search_.set_heights(input_.height_unit(), input_.heights_are_apart(), sinks.places);
    if (auto status = input_.read(sinks, bar_); !status) return status;
    const std::size_t texts = memory_.texts / (writes_records() || needs_places() ? 2 : 1);
    for (TextStore* const store : stores()) {
      store->finish(texts);
      if (!store->status()) return store->status();
    }
    if (input_.own_ids() && (!request_.quiet || request_.unique_ids || in_json())) {
      bar_.enter_stage("comparing ids");
      auto repeated = shown_.find_repeated(search_.size(), folder_, memory_.rows);
      if (!repeated) return std::move(repeated).error();
      repeated_ = *std::move(repeated);
      if (request_.unique_ids && repeated_.count > 0) return repeated_error();
    }
    timings_.read_s = watch_.lap();
    return std::monostate{};
  }

  // Of several files the place of the second record is told as any other.
  [[nodiscard]] Error repeated_error() const {
    Error error = cli::repeated_error(repeated_, input_.front().path);
    error.location.source.clear();
    return error;
  }

  [[nodiscard]] bool in_json() const { return request_.form.form == Form::kJson; }

  Status write() {
    BlockWriter out(output_);
    io::JsonWriter json(out.text);
    const auto table =
        LargeTable::make(request_.form.form, {out, json, input_.front(), shown_, &records_});
    Status status = std::monostate{};
    if (in_json()) {
      write_facts(json);
      if (*request_.report->key != '\0') {
        json.key(request_.report->key);
        status = search_.write(*table);
      }
      json.end();
      out.text += '\n';
    } else {
      status = search_.write(*table);
    }
    for (const TextStore* const store : stores()) {
      if (status) status = store->status();
    }
    return status;
  }

  // All but the rows.
  void write_facts(io::JsonWriter& json) {
    json.begin_object(io::JsonLayout::kLines);
    json.member("version", version()).member("report", request_.report->name);
    if (input_.files().size() == 1) {
      write_input(json.key("input"), facts_of(input_.front()));
    } else {
      json.begin_array("inputs", io::JsonLayout::kLines);
      for (const LargeFile& file : input_.files()) write_input(json, facts_of(file));
      json.end();
      write_repeated(json, repeated_);
    }
    write_search(json, request_, input_.height_unit());
    const std::uint64_t at_risk = search_.at_risk()->count();
    json.member("at_risk_count", at_risk);
    json.member("share", static_cast<double>(at_risk) / static_cast<double>(search_.size()));
    if (const auto& closest = search_.closest()) {
      json.begin_object("closest_pair");
      write_pair(json, shown_, closest->pair, closest->distance_m);
      json.end();
    } else {
      json.key("closest_pair").null();
    }
    write_timings(json, timings_);
    if (std::string_view(request_.report->name) == "pairs") {
      json.member("pair_count", search_.pairs());
    }
  }

  [[nodiscard]] InputFacts facts_of(const LargeFile& file) const {
    return {file.path, file.facts, file.points, input_.files().size() == 1 ? &repeated_ : nullptr};
  }

  [[nodiscard]] std::string summary() const {
    std::string out;
    const auto& files = input_.files();
    for (std::size_t number = 0; number < std::min(files.size(), kFilesShown); ++number) {
      append_input(out, "input", facts_of(files[number]));
    }
    if (files.size() > kFilesShown) {
      append_summary_line(
          out, "", "and " + io::counted(files.size() - kFilesShown, "file", "files") + " more");
    }
    if (files.size() > 1) {
      append_summary_line(out, "all points", io::grouped(search_.size()));
      append_repeated(out, repeated_);
    }
    append_search(out, request_, input_.height_unit());
    if (const PointFlags* const at_risk = search_.at_risk()) {
      append_summary_line(out, "at risk",
                          at_risk_text(at_risk->count(), search_.size(), skipped()));
    }
    const std::string finding = search_.finding();
    if (!finding.empty()) append_summary_line(out, request_.report->label, finding);
    if (search_.knows_closest()) append_summary_line(out, "closest", closest_text());
    append_summary_line(out, "memory", memory_text());
    append_summary_line(out, "time",
                        "read " + io::duration(timings_.read_s) + ", search " +
                            io::duration(timings_.search_s) + ", write " +
                            io::duration(timings_.write_s));
    return out;
  }

  [[nodiscard]] std::string closest_text() const {
    const auto& closest = search_.closest();
    if (!closest) return "none: there is one point only";
    const auto& [pair, distance_m] = *closest;
    return printable(shown_.text(pair.first)) + " and " + printable(shown_.text(pair.second)) +
           ", " + io::length_below(request_.search.threshold_m, distance_m) + " apart";
  }

  [[nodiscard]] std::string memory_text() const {
    const OutOfCoreFacts facts = search_.facts();
    std::string text =
        io::byte_count(*request_.memory_bytes) + ", " + io::counted(facts.cells, "cell", "cells");
    if (facts.crowded_cells > 0) {
      text += ", " + io::grouped(facts.crowded_cells) +
              " of them too full for --memory: searched in pieces, which takes longer";
    }
    return text;
  }

  const DetectRequest& request_;
  LargeInput& input_;
  const LargeMemory& memory_;
  io::AtomicOutput& output_;
  ProgressBar& bar_;
  std::string folder_;
  LargeSearch search_;
  TextStore ids_;
  TextStore records_;
  TextStore places_;
  LargeIds shown_;
  io::RepeatedIds repeated_;
  Stopwatch watch_;
  Timings timings_;
};

}  // namespace

Status check_out_of_core(const DetectRequest& request) {
  const std::string_view report = request.report->name;
  const struct {
    const char* what;
    bool fits;
  } table[] = {{"--others", !request.others},
               {"--vertical with nearest", !request.vertical || report != "nearest"},
               {"--vertical with --json: name another form",
                !request.vertical || request.form.form != Form::kJson},
               {"--geojson, whose maps do not hold so many points: --csv or --json",
                request.form.form != Form::kGeoJson},
               {"--report groups, for which all points must be in memory", report != "groups"}};
  for (const auto& [what, fits] : table) {
    if (!fits) return usage_error("detect", std::string("--memory does not take ") + what);
  }
  return std::monostate{};
}

Result<ExitCode> run_detect_out_of_core(const DetectRequest& request) {
  auto output = open_output("detect", request.output, request.inputs, request.form.packing);
  if (!output) return std::move(output).error();
  ProgressBar bar(!request.quiet);
  const LargeMemory memory = LargeMemory::of(request);
  auto input = LargeInput::open(request, memory.block);
  if (!input) return std::move(input).error();
  return Detecting(request, *input, memory, *output, bar).run();
}

}  // namespace beespace::cli
