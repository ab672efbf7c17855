// From a file, or standard input, to points in metres.
//
// Reads text tables (the course format, x,y,z, any delimiter), .npy arrays and raw float64, each
// plain or gzip-compressed. The format is told by the content where the content says it.
#pragma once

#include "io/bytes/byte_source.hpp"
#include "io/points/load_options.hpp"
#include "io/points/loaded_points.hpp"
#include "io/table/table_layout.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace beespace::io {

// `path` is a file name, or "-" for standard input. Errors carry file, line and column.
Result<LoadedPoints> load_points(const std::string& path, const LoadOptions& options = {});

// The same for bytes in memory (copied); `name` stands for the file in messages, and its ending
// tells raw float64 (".bin") as a file's does.
Result<LoadedPoints> load_points_from_memory(std::string_view content, const std::string& name,
                                             const LoadOptions& options = {});

// For readers of parts (stream_points.hpp).

// How unpacked bytes that begin so are to be read: never kAuto.
Format format_of(std::string_view bytes, const std::string& path, Format asked);

// What is wrong where so many records were left out, and no other is there.
std::string all_bad_text(std::uint64_t records, const Error& first);

// That a point, where loggers write zeros, is no place. Without source.
Error no_place_error(const LoadedPoints& loaded, std::size_t point);

struct TableBeginning {
  TableLayout layout;          // of `text`
  std::string_view text = {};  // without a byte-order mark
};
// Of the beginning of a table. Errors: what it is instead of text; those of find_layout().
Result<TableBeginning> find_points_table(std::string_view bytes, const LoadOptions& options);

// The records of whole lines in the middle of a table, which may be blank, whose layout and frame
// are known: `layout` lies at their beginning, with the lines before it. Errors without source, and
// with records counted from there.
Result<LoadedPoints> load_lines(Bytes lines, const TableLayout& layout, const FrameDecision& frame,
                                const LoadOptions& options);

}  // namespace beespace::io
