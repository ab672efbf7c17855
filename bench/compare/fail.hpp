// Ends a program of the comparison: a sentence on standard error, and exit status 1.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace beespace::compare {

[[noreturn]] inline void fail(const std::string& sentence) {
  std::fprintf(stderr, "compare: %s\n", sentence.c_str());
  std::exit(1);
}

}  // namespace beespace::compare
