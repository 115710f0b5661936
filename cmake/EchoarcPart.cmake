# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

# Flags that every target of the project is built with; nothing here reaches a consumer.
add_library(echoarc_build_flags INTERFACE)
target_compile_features(echoarc_build_flags INTERFACE cxx_std_20)
target_compile_options(echoarc_build_flags INTERFACE
  # A fused multiply-add rounds once where the written expression rounds twice. Whether the compiler fuses depends on flags
  # and surrounding code; forbidding it keeps results equal between builds, dispatch paths and thread counts.
  -ffp-contract=off
  # -Wno-missing-field-initializers: a designated initialiser that leaves a member at its default is how we write options.
  -Wall -Wextra -Wpedantic -Wno-missing-field-initializers -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual
  # libstdc++ 12's own stable_sort uses what it declares deprecated.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations>
  $<$<BOOL:${ECHOARC_WERROR}>:-Werror>)
if(ECHOARC_SANITIZE)
  target_compile_options(echoarc_build_flags INTERFACE -fsanitize=${ECHOARC_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(echoarc_build_flags INTERFACE -fsanitize=${ECHOARC_SANITIZE})
endif()
if(ECHOARC_COVERAGE)
  target_compile_options(echoarc_build_flags INTERFACE --coverage -fprofile-update=atomic)
  target_link_options(echoarc_build_flags INTERFACE --coverage)
endif()

# echoarc_part(NAME SOURCES ... [DEPENDS other parts] [PRIVATE third-party targets])
# One library target per part of the house, `echoarc::NAME` in the build and after installation. DEPENDS are public arrows
# of docs/architecture; a third-party library stays private so that it is not seen through our headers.
function(echoarc_part name)
  cmake_parse_arguments(PARSE_ARGV 1 part "" "" "SOURCES;DEPENDS;PRIVATE")
  set(target echoarc_${name})
  add_library(${target} STATIC ${part_SOURCES})
  add_library(echoarc::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  foreach(dependency IN LISTS part_DEPENDS)
    target_link_libraries(${target} PUBLIC echoarc_${dependency})
  endforeach()
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:echoarc_build_flags> ${part_PRIVATE})
  set_property(GLOBAL APPEND PROPERTY ECHOARC_PARTS ${target})
endfunction()
