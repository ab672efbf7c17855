#include <beespace/version.hpp>

#include <beespace_io.h>

extern "C" {

// The version is a literal, so it ends with a zero byte.
const char* beespace_io_version(void) {
  return beespace::version().data();
}

}  // extern "C"
