// The search of a detection with --memory: what the report asks, and what is told besides.
#pragma once

#include "cli/console/progress_bar.hpp"
#include "cli/detect/detection.hpp"
#include "cli/detect/out_of_core/large_table.hpp"
#include "cli/detect/out_of_core/sorted_rows.hpp"

#include <beespace/out_of_core.hpp>
#include <beespace/result.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace beespace::cli {

// How --memory is shared out. Not all of it is in use at a time.
struct LargeMemory {
  std::uint64_t search;  // points in cells
  std::size_t rows;      // of the answer, before they go to the disk
  std::size_t texts;     // ids and records, as they are looked up
  std::size_t block;     // of a file, as it is read

  static LargeMemory of(const DetectRequest& request);
};

// A flag for each point.
class PointFlags {
 public:
  void resize(std::uint64_t size) { words_.resize((size + 63) / 64); }

  void set(LargeId id) {
    std::uint64_t& word = words_[id / 64];
    const std::uint64_t bit = std::uint64_t{1} << (id % 64);
    count_ += (word & bit) == 0 ? 1 : 0;
    word |= bit;
  }
  [[nodiscard]] bool operator[](LargeId id) const {
    return (words_[id / 64] >> (id % 64) & 1U) != 0;
  }
  [[nodiscard]] std::uint64_t count() const { return count_; }

  // Those that are set, ascending.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t at = 0; at < words_.size(); ++at) {
      for (std::uint64_t word = words_[at]; word != 0; word &= word - 1) {
        visit(at * 64 + static_cast<std::uint64_t>(std::countr_zero(word)));
      }
    }
  }

 private:
  std::vector<std::uint64_t> words_;
  std::uint64_t count_ = 0;
};

class LargeSearch {
 public:
  // All must outlive this.
  LargeSearch(const DetectRequest& request, const std::string& folder, const LargeMemory& memory,
              ProgressBar& bar);

  // Where all points go, before find().
  [[nodiscard]] OutOfCore& points() { return *points_; }
  [[nodiscard]] std::uint64_t size() const { return points_ ? points_->size() : size_; }

  // What is asked, once that is known: heights that are apart from positions are compared in the
  // unit of `height_unit`, and pairs are as far apart as `places` are (LargePlace), where these are
  // not null. They must outlive this.
  void set_heights(io::Unit height_unit, bool apart, TextStore* places);

  // Once, when all points are there. Errors: those of OutOfCore and of temporary files;
  // kTooManyResults.
  Status find();

  // Who is at risk; null where that is neither asked nor told.
  [[nodiscard]] const PointFlags* at_risk() const { return knows_at_risk_ ? &at_risk_ : nullptr; }
  // The closest pair, where it is asked or told.
  [[nodiscard]] const std::optional<LargeClosestPair>& closest() const { return closest_; }
  [[nodiscard]] bool knows_closest() const { return knows_closest_; }
  [[nodiscard]] std::uint64_t pairs() const { return pairs_; }
  // Of the report, for the summary; empty where nothing is to be said.
  [[nodiscard]] std::string finding() const;

  // Gives the memory and the files of the search back, once it has found.
  void release();
  // How the last search was cut, after release().
  [[nodiscard]] const OutOfCoreFacts& facts() const { return facts_; }

  // The rows of the report. Once. Errors: those of temporary files.
  Status write(LargeTable& table);

 private:
  [[nodiscard]] bool is(const char* report) const;
  Status find_at_risk();
  Status find_pairs(bool both_ways);
  Status find_counts();
  Status find_nearest();
  Status find_closest();
  // What a search came to, or why it was stopped.
  Status ended(Status status) const;
  void stop_on_failure();

  void show_share(LargeId id);
  void for_each_row(const std::function<void(const LargeRow&)>& visit);
  void write_counts(LargeTable& table);
  void write_neighbors(LargeTable& table);
  void write_nearest(LargeTable& table);
  // All bees from `next` up to that one, which have no neighbours, where all are listed.
  void write_lonely(LargeTable& table, LargeId& next, LargeId end,
                    std::span<const LargeCell> cells) const;

  // In metres; and in what a vertical threshold compares.
  struct LargeDistance {
    double distance_m = 0.0;
    analysis::Apart apart = {};
  };
  [[nodiscard]] LargeDistance distance_of(const LargeRow& pair);

  const DetectRequest& request_;
  SearchOptions options_;
  TextStore* places_ = nullptr;
  double height_unit_m_ = 1.0;
  bool heights_apart_ = false;
  ApartFields fields_;
  ProgressBar& bar_;
  std::stop_source stop_;
  std::optional<OutOfCore> points_;
  std::uint64_t size_ = 0;
  OutOfCoreFacts facts_;
  SortedRows rows_;
  PointFlags at_risk_;
  std::optional<LargeClosestPair> closest_;
  bool knows_at_risk_ = false;
  bool knows_closest_ = false;
  bool is_beyond_limit_ = false;
  std::uint64_t pairs_ = 0;
  std::uint64_t neighbors_ = 0;       // of all bees together
  std::uint64_t most_neighbors_ = 0;  // of one
  std::uint64_t shown_ = 0;           // rows
  double farthest_m_ = 0.0;           // of the nearest
};

}  // namespace beespace::cli
