# romascope_module(NAME SOURCES ... DEPENDS module... LIBRARIES target...)
# One folder of renderer/ as one static library, romascope_NAME. DEPENDS names the folders below it.
function(romascope_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;LIBRARIES" ${ARGN})
  add_library(romascope_${name} STATIC ${ARG_SOURCES})
  foreach(module IN LISTS ARG_DEPENDS)
    target_link_libraries(romascope_${name} PUBLIC romascope_${module})
  endforeach()
  target_link_libraries(romascope_${name} PUBLIC romascope_options ${ARG_LIBRARIES})
endfunction()

# romascope_embed(OUT NAME ROOT PATTERN...)
# Sets OUT to a generated source with a function NAME() that gives the texts of all files below ROOT
# that match (see EmbedText.cmake).
function(romascope_embed out name root)
  list(TRANSFORM ARGN PREPEND ${root}/ OUTPUT_VARIABLE patterns)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE ${root} ${patterns})
  list(TRANSFORM files PREPEND ${root}/ OUTPUT_VARIABLE paths)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  set(script ${PROJECT_SOURCE_DIR}/cmake/EmbedText.cmake)
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DROOT=${root} "-DFILES=${files}" -DOUT=${source} -DNAME=${name} -P ${script}
    DEPENDS ${paths} ${script}
    COMMENT "Embedding ${name}" VERBATIM)
  set(${out} ${source} PARENT_SCOPE)
endfunction()
