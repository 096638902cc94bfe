# Two things to install: component `cpp`, the libraries, the program and a CMake package for other
# C++ projects; component `python`, what goes into the wheel beside the Python sources.

if(PILOTAGE_PYTHON)
  # In the wheel the libraries of `lcm` and `cmeel-yaml-cpp` are neighbours in site-packages.
  set_target_properties(_core PROPERTIES
    INSTALL_RPATH "$ORIGIN/../lib:$ORIGIN/../cmeel.prefix/lib")
  install(TARGETS _core LIBRARY DESTINATION pilotage COMPONENT python)
  install(DIRECTORY configs DESTINATION pilotage COMPONENT python)
endif()

if(SKBUILD)
  set_target_properties(pilotage-node PROPERTIES
    INSTALL_RPATH "$ORIGIN/../../lib:$ORIGIN/../../cmeel.prefix/lib")
  install(TARGETS pilotage-node RUNTIME DESTINATION pilotage/bin COMPONENT python)
  return()
endif()

# Where the libraries were found; INSTALL_RPATH_USE_LINK_PATH would leave out a .venv in this folder.
set(rpath "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
foreach(library lcm ${PILOTAGE_YAML_CPP})
  get_target_property(imported ${library} IMPORTED)
  if(imported)
    list(APPEND rpath "$<TARGET_FILE_DIR:${library}>")
  endif()
endforeach()
set_target_properties(pilotage-node PROPERTIES INSTALL_RPATH "${rpath}")
set_target_properties(pilotage_core PROPERTIES EXPORT_NAME core)
set_target_properties(pilotage_engine PROPERTIES EXPORT_NAME engine)
set_target_properties(pilotage_lcmtypes PROPERTIES EXPORT_NAME lcmtypes)
install(TARGETS pilotage_core pilotage_engine pilotage_lcmtypes EXPORT pilotageTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT cpp)
install(TARGETS pilotage-node RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT cpp)
install(DIRECTORY cpp/include/pilotage DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT cpp)
install(DIRECTORY cpp/engine DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pilotage COMPONENT cpp
  FILES_MATCHING PATTERN "*.hpp")

include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/pilotage)
configure_package_config_file(cmake/pilotageConfig.cmake.in pilotageConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(pilotageConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/pilotageConfig.cmake"
              "${PROJECT_BINARY_DIR}/pilotageConfigVersion.cmake"
  DESTINATION ${package_dir} COMPONENT cpp)
install(EXPORT pilotageTargets NAMESPACE pilotage:: DESTINATION ${package_dir} COMPONENT cpp)
