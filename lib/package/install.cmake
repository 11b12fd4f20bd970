# Installs what find_package(delabole) finds: the mechanics library and its headers, without the rooms above it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

add_library(delabole::lib ALIAS delabole_lib)
set_target_properties(delabole_lib PROPERTIES EXPORT_NAME lib OUTPUT_NAME delabole)

set(header_directory ${CMAKE_INSTALL_INCLUDEDIR}/delabole)
set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/delabole)

target_compile_features(delabole_lib PUBLIC cxx_std_20)
install(TARGETS delabole_lib EXPORT delabole_targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
    INCLUDES DESTINATION ${header_directory})
install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION ${header_directory} COMPONENT library
    FILES_MATCHING PATTERN "*.hpp"
    PATTERN package EXCLUDE)
install(EXPORT delabole_targets NAMESPACE delabole:: FILE delabole-targets.cmake
    DESTINATION ${package_directory} COMPONENT library)

configure_package_config_file(
    ${CMAKE_CURRENT_LIST_DIR}/delabole-config.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/delabole-config.cmake
    INSTALL_DESTINATION ${package_directory}
    NO_SET_AND_CHECK_MACRO)
# Before 1.0 a new minor version may break its users.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/delabole-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES
    ${CMAKE_CURRENT_BINARY_DIR}/delabole-config.cmake
    ${CMAKE_CURRENT_BINARY_DIR}/delabole-config-version.cmake
    ${CMAKE_CURRENT_LIST_DIR}/find_glpk.cmake
    ${CMAKE_CURRENT_LIST_DIR}/find_klu.cmake
    DESTINATION ${package_directory} COMPONENT library)
