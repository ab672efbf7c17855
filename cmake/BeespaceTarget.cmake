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

# Compiles the files of a room (a directory) as one unit. Rooms named after the target, and files with
# options of their own, are compiled file by file.
function(beespace_unite_rooms target)
  if(NOT BEESPACE_COMPILE_BY_ROOM)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH room)
    if(IS_ABSOLUTE "${room}")
      cmake_path(RELATIVE_PATH room BASE_DIRECTORY "${PROJECT_SOURCE_DIR}")
    endif()
    get_source_file_property(own_options ${source} COMPILE_OPTIONS)
    if(own_options OR (ARGN AND room IN_LIST ARGN))
      set_source_files_properties(${source} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    else()
      string(MAKE_C_IDENTIFIER "room_${room}" group)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # Of a name that another file of the room has, too, only Clang warns.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:Clang>:-Wno-shadow>)
endfunction()

# So that ccache may keep what is compiled with precompiled headers. (What Clang precompiles has paths
# inside: of another clone ccache has nothing for it.)
function(beespace_precompiled_for_ccache target)
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
    $<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>)
endfunction()

# Compiles by room, and what nearly all files include once: a target from nothing in less than half of
# the time.
function(beespace_compile_by_room target)
  if(NOT BEESPACE_COMPILE_BY_ROOM)
    return()
  endif()
  beespace_unite_rooms(${target} ${ARGN})
  target_precompile_headers(${target} PRIVATE
    <algorithm> <cmath> <functional> <map> <memory> <optional> <span> <string> <string_view> <utility>
    <variant> <vector> <beespace/result.hpp>)
  beespace_precompiled_for_ccache(${target})
endfunction()
