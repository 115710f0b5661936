# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(parts GLOBAL PROPERTY ECHOARC_PARTS)
install(TARGETS ${parts} EXPORT echoarc-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
set(without_io)
if(NOT ECHOARC_BUILD_IO)
  set(without_io PATTERN io EXCLUDE)
endif()
install(DIRECTORY include/echoarc DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${without_io})

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/echoarc)
install(EXPORT echoarc-targets NAMESPACE echoarc:: DESTINATION ${package_dir})
configure_package_config_file(cmake/echoarc-config.cmake.in ${PROJECT_BINARY_DIR}/echoarc-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/echoarc-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/echoarc-config.cmake ${PROJECT_BINARY_DIR}/echoarc-config-version.cmake DESTINATION ${package_dir})

install(FILES LICENSE README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
