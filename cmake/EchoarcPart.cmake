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
  # With ThreadSanitizer's calls in between GCC 12 takes sound code for overruns; warnings are the other trees' matter.
  if(ECHOARC_SANITIZE MATCHES thread)
    target_compile_options(echoarc_build_flags INTERFACE -Wno-error)
  endif()
endif()
if(ECHOARC_COVERAGE)
  target_compile_options(echoarc_build_flags INTERFACE --coverage -fprofile-update=atomic)
  target_link_options(echoarc_build_flags INTERFACE --coverage)
endif()

# echoarc_precompile(TARGET [HEADER...]): the headers of the standard library that most sources include, and the named
# ones, are parsed once for the target. They are half of what a small source costs to compile. Not with ccache, which would
# refuse to cache them; nor where ECHOARC_PRECOMPILE is off, so that a missing #include is found.
function(echoarc_precompile target)
  if(ECHOARC_PRECOMPILE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    target_precompile_headers(${target} PRIVATE <algorithm> <array> <cmath> <cstddef> <cstdint> <functional> <limits> <map>
      <memory> <numbers> <optional> <span> <string> <string_view> <tuple> <utility> <variant> <vector> ${ARGN})
  endif()
endfunction()

# echoarc_part(NAME SOURCES ... [DEPENDS other parts] [PRIVATE third-party targets] [PRECOMPILE further headers])
# One library target per part of the house, `echoarc::NAME` in the build and after installation. DEPENDS are public arrows
# of docs/architecture; a third-party library stays private so that it is not seen through our headers.
function(echoarc_part name)
  cmake_parse_arguments(PARSE_ARGV 1 part "" "" "SOURCES;DEPENDS;PRIVATE;PRECOMPILE")
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
  echoarc_precompile(${target} ${part_PRECOMPILE})
  set_property(GLOBAL APPEND PROPERTY ECHOARC_PARTS ${target})
endfunction()
