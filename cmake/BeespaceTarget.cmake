# What every target of the project has in common: the language, the warnings, exact arithmetic.
function(beespace_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES
    CXX_EXTENSIONS OFF
    CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow
    $<$<BOOL:${BEESPACE_WERROR}>:-Werror>
    # a*b+c must round twice everywhere, or answers would depend on the processor.
    -ffp-contract=off)
endfunction()

# Parses once what nearly all files of a target include: a third less to compile. Clang goes without,
# so that CI sees a file that does not include what it uses.
function(beespace_precompile target)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    return()
  endif()
  target_precompile_headers(${target} PRIVATE
    <algorithm> <cmath> <functional> <map> <memory> <optional> <span> <string> <string_view> <utility>
    <variant> <vector> <beespace/result.hpp>)
  target_compile_options(${target} PRIVATE -fpch-preprocess)  # for ccache
endfunction()
