#include <beespace/version.hpp>

#include <beespace.h>

extern "C" {

// The version is a literal, so it ends with a zero byte.
const char* beespace_version(void) {
  return beespace::version().data();
}

}  // extern "C"
