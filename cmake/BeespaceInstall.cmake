# What `cmake --install` puts where: the library and its headers, the CMake package, beespace.pc,
# and, where it is built, the command with its manual page and completions.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# A static library and a shared one may stand side by side in one prefix: what differs between them
# is in files of their own names.
if(BUILD_SHARED_LIBS)
  set(kind shared)
else()
  set(kind static)
endif()

install(TARGETS beespace
  EXPORT beespace-${kind}
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/beespace"
  DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
  FILES_MATCHING PATTERN "*.hpp")
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}")

# A wheel has the libraries for C beside the modules that load them, and nothing else.
if(SKBUILD)
  install(TARGETS ${beespace_python_libraries} LIBRARY DESTINATION beespace COMPONENT python)
  return()
endif()

# The library for C, which the static one is inside of.
if(TARGET beespace_c)
  install(TARGETS beespace_c
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  install(FILES "${PROJECT_SOURCE_DIR}/include/beespace.h" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/beespace/c"
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/beespace")
endif()

# The library for C that reads files, where the command is built.
if(TARGET beespace_c_io)
  install(TARGETS beespace_c_io
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  install(FILES "${PROJECT_SOURCE_DIR}/include/beespace_io.h"
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
endif()

# find_package(beespace), or find_package(beespace COMPONENTS static)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/beespace")
configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/beespaceConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/beespaceConfig.cmake"
  INSTALL_DESTINATION "${package_dir}"
  NO_SET_AND_CHECK_MACRO)
# While the version is 0.x, a new minor version may break its users.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/beespaceConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(EXPORT beespace-${kind} NAMESPACE beespace:: DESTINATION "${package_dir}"
  FILE beespace-${kind}.cmake)
install(FILES
  "${PROJECT_BINARY_DIR}/beespaceConfig.cmake"
  "${PROJECT_BINARY_DIR}/beespaceConfigVersion.cmake"
  DESTINATION "${package_dir}")

# pkg-config. The prefix is found from where the file lies, so that the tree may be moved.
set(pc_dir "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig")
file(RELATIVE_PATH pc_to_prefix "${pc_dir}" "${CMAKE_INSTALL_PREFIX}")
string(REGEX REPLACE "/$" "" pc_to_prefix "${pc_to_prefix}")
if(BUILD_SHARED_LIBS)
  set(pc_cflags "")
  set(pc_libs "-L\${libdir} -lbeespace++")
else()
  # An archive does not know what it needs, so the program that links it must name it. By its path:
  # -lbeespace would take the library for C beside it.
  set(pc_cflags " -DBEESPACE_STATIC")
  set(pc_libs "\${libdir}/${CMAKE_STATIC_LIBRARY_PREFIX}beespace${CMAKE_STATIC_LIBRARY_SUFFIX} -pthread")
endif()
set(pc_names beespace beespace-${kind})  # "beespace" is the kind that was installed last
if(TARGET beespace_c)
  list(APPEND pc_names beespace-c)
endif()
if(TARGET beespace_c_io)
  list(APPEND pc_names beespace-io)
endif()
foreach(name IN LISTS pc_names)
  if(name STREQUAL "beespace-c")
    set(pc_cflags "")
    set(pc_libs "-L\${libdir} -lbeespace")
  elseif(name STREQUAL "beespace-io")
    set(pc_cflags "")
    set(pc_libs "-L\${libdir} -lbeespace_io -lbeespace")
  endif()
  configure_file("${PROJECT_SOURCE_DIR}/cmake/beespace.pc.in" "${PROJECT_BINARY_DIR}/${name}.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/${name}.pc"
    DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
endforeach()

if(TARGET beespace_cli)
  install(TARGETS beespace_cli RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
  install(FILES man/beespace.1 DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
  install(FILES completions/beespace.bash
    DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions"
    RENAME beespace)
  install(FILES completions/_beespace
    DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/site-functions")
  install(FILES completions/beespace.fish
    DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d")
  if(BUILD_SHARED_LIBS)
    # The installed command finds the installed library, wherever the prefix is.
    file(RELATIVE_PATH bin_to_lib "${CMAKE_INSTALL_FULL_BINDIR}" "${CMAKE_INSTALL_FULL_LIBDIR}")
    set_target_properties(beespace_cli PROPERTIES INSTALL_RPATH "$ORIGIN/${bin_to_lib}")
  endif()
endif()
