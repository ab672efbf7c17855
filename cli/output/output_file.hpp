// The file that an answer goes to, which is none of those that it comes from.
#pragma once

#include "io/bytes/atomic_output.hpp"

#include <beespace/result.hpp>

#include <string>
#include <vector>

namespace beespace::cli {

// `inputs` are all that the command is going to read: files, folders, "-"; empty texts are none.
// Errors: kInvalidArgument where the output would replace one of them, by whichever name; those of
// AtomicOutput::open.
Result<io::AtomicOutput> open_output(const char* command, const std::string& output,
                                     const std::vector<std::string>& inputs,
                                     io::Packing packing = io::Packing::kPlain);

}  // namespace beespace::cli
