// How each function of <beespace.h> is entered and left: what goes wrong inside becomes a code and
// an error of the caller's; nothing is thrown across.
#pragma once

#include <beespace.h>
#include <beespace/result.hpp>

#include <new>
#include <utility>

namespace beespace::c {

beespace_code code_of(ErrorCode code);

// Fills the caller's error, as far as it is one; returns the code.
beespace_code refuse(beespace_error* error, const Error& cause);
beespace_code refuse_out_of_memory(beespace_error* error);
beespace_code refuse_internal(beespace_error* error);

// An argument that makes no sense.
Error invalid(const char* message, const char* place = "");

// Calls work(), which returns a Status.
template <class Work>
beespace_code enter(beespace_error* error, Work&& work) {
  try {
    const Status status = std::forward<Work>(work)();
    return status ? BEESPACE_OK : refuse(error, status.error());
  } catch (const std::bad_alloc&) {
    return refuse_out_of_memory(error);
  } catch (...) {
    return refuse_internal(error);
  }
}

}  // namespace beespace::c
