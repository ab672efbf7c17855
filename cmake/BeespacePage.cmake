# The page of 'beespace report': web/ built by esbuild, put into a target.
#
#   beespace_page(TARGET)
#
# Needs Node.js and npm; what comes from npm is installed by scripts/web-packages.
function(beespace_page target)
  if(NOT BEESPACE_WEB)
    target_sources(${target} PRIVATE "${PROJECT_SOURCE_DIR}/report/no_page_template.cpp")
    return()
  endif()
  find_program(NODE_EXECUTABLE NAMES node nodejs)
  find_program(NPM_EXECUTABLE npm)
  if(NOT NODE_EXECUTABLE OR NOT NPM_EXECUTABLE)
    message(FATAL_ERROR
      "The page of 'beespace report' needs Node.js (18 or newer) and npm: install them (Debian: "
      "apt-get install nodejs npm), or configure with -DBEESPACE_WEB=OFF to do without the page.")
  endif()
  set(page "${PROJECT_BINARY_DIR}/web/page.html")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/web/src/*")
  add_custom_command(
    OUTPUT "${page}"
    COMMAND "${PROJECT_SOURCE_DIR}/scripts/web-packages"
    COMMAND "${NODE_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/web/build.mjs" "${page}"
    DEPENDS ${sources} "${PROJECT_SOURCE_DIR}/web/build.mjs" "${PROJECT_SOURCE_DIR}/web/ground.mjs"
      "${PROJECT_SOURCE_DIR}/web/package-lock.json" "${PROJECT_SOURCE_DIR}/scripts/web-packages"
    COMMENT "Building the page of 'beespace report'"
    VERBATIM)
  target_sources(${target} PRIVATE "${PROJECT_SOURCE_DIR}/report/page_template.cpp" "${page}")
  set_source_files_properties("${page}" PROPERTIES HEADER_FILE_ONLY ON GENERATED ON)
  set_source_files_properties("${PROJECT_SOURCE_DIR}/report/page_template.cpp" PROPERTIES
    OBJECT_DEPENDS "${page}"
    COMPILE_DEFINITIONS "BEESPACE_PAGE=\"${page}\"")
endfunction()
