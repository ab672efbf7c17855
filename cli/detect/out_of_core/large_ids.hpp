// The ids that people know of many points: those of the files, or the numbers of their rows, which
// also stand for ids that are empty. As analysis::ShownIds.
#pragma once

#include "cli/detect/out_of_core/text_store.hpp"
#include "io/json/json_writer.hpp"
#include "io/points/repeated_ids.hpp"
#include "io/problems/skipped_records.hpp"

#include <beespace/out_of_core.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace beespace::cli {

class LargeIds {
 public:
  // A null store: the files have no ids. Both must outlive this.
  LargeIds(TextStore* store, const io::SkippedRecords& skipped)
      : store_(store), skipped_(&skipped) {}

  // The number of the record, those included that were left out.
  [[nodiscard]] std::uint64_t row(LargeId point) const { return skipped_->row_of(point); }

  // For people and lines of text.
  void append(std::string& out, LargeId point) const;
  [[nodiscard]] std::string text(LargeId point) const;
  // A number when it is a row, a string when it is the file's own.
  void write(io::JsonWriter& json, LargeId point) const;

  // Which of so many ids come again, with so much memory. Empty ids are none. Errors: those of
  // temporary files.
  [[nodiscard]] Result<io::RepeatedIds> find_repeated(std::uint64_t points,
                                                      const std::string& folder,
                                                      std::size_t memory_bytes) const;

 private:
  TextStore* store_;
  const io::SkippedRecords* skipped_;
};

}  // namespace beespace::cli
