# find_package(relievo) for others: a target per installed room (relievo::textures, …) and the
# packages that those targets link.
include(CMakePackageConfigHelpers)
set(relievo_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/relievo")

install(EXPORT relievoTargets NAMESPACE relievo:: DESTINATION "${relievo_package_dir}")
configure_package_config_file(cmake/relievoConfig.cmake.in "${PROJECT_BINARY_DIR}/relievoConfig.cmake"
  INSTALL_DESTINATION "${relievo_package_dir}"
  NO_SET_AND_CHECK_MACRO)
# Before version 1.0 a minor version may change the interfaces.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/relievoConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${PROJECT_BINARY_DIR}/relievoConfig.cmake"
    "${PROJECT_BINARY_DIR}/relievoConfigVersion.cmake"
  DESTINATION "${relievo_package_dir}")

# Scenes that relievo-view can show.
install(DIRECTORY scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/relievo)
