// Gzip-compressed input, unpacked in memory. One or more members one after the other, as written
// by gzip, pigz, bgzip or `cat a.gz b.gz`.
#pragma once

#include "io/bytes/byte_source.hpp"

#include <beespace/result.hpp>

#include <string>
#include <string_view>

namespace beespace::io {

// By the first two bytes, whatever the file is called.
bool is_gzip(std::string_view bytes);

// Errors: kTruncated when the end is missing, kCorrupt when the content is damaged.
Result<Bytes> gunzip(std::string_view compressed, const std::string& source, Progress* progress);

// The bytes themselves, or where they are compressed what is in them. Errors: those of gunzip(),
// and kUnsupportedFormat for what is compressed twice; with `source` as place.
Result<Bytes> unpacked(Bytes bytes, const std::string& source);

}  // namespace beespace::io
