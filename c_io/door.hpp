// How each function of <beespace_io.h> is entered and left: as those of <beespace.h> are (c/door),
// with an error that knows of files.
#pragma once

#include <beespace_io.h>
#include <beespace/result.hpp>

#include <new>
#include <utility>

namespace beespace::c_io {

// Fills the caller's error, as far as it is one; returns the code.
beespace_code refuse(beespace_io_error* error, const Error& cause);
beespace_code refuse_out_of_memory(beespace_io_error* error);
beespace_code refuse_internal(beespace_io_error* error);

// Calls work(), which returns a Status.
template <class Work>
beespace_code enter(beespace_io_error* error, Work&& work) {
  try {
    const Status status = std::forward<Work>(work)();
    return status ? BEESPACE_OK : refuse(error, status.error());
  } catch (const std::bad_alloc&) {
    return refuse_out_of_memory(error);
  } catch (...) {
    return refuse_internal(error);
  }
}

}  // namespace beespace::c_io
