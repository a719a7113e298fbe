# What 'cmake --install' puts where, for the relocatable folder that tools/bundle/make.sh makes.
# The program looks for libraries in ../lib and for scenes in ../share/romascope/assets.
set_target_properties(romascope PROPERTIES INSTALL_RPATH "$ORIGIN/../lib")
# RPATH, not RUNPATH: it holds for the libraries of the libraries, too.
target_link_options(romascope PRIVATE -Wl,--disable-new-dtags)
install(TARGETS romascope RUNTIME DESTINATION bin)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets/ DESTINATION share/romascope/assets
  FILES_MATCHING PATTERN "*.glb" PATTERN "generator" EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/romascope)
