# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

# echoarc_kernels(TARGET SOURCE...)
# Compiles the sources into TARGET once per instruction set, with ECHOARC_ISA set to its name; the program picks one at run time.
# What is shipped stays runnable on any machine of its architecture: nothing is built with -march=native.
function(echoarc_kernels target)
  set(sets plain)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND sets avx2)
    target_compile_definitions(${target} PRIVATE ECHOARC_HAVE_AVX2)
  endif()
  foreach(isa IN LISTS sets)
    set(kernels ${target}_kernels_${isa})
    add_library(${kernels} OBJECT ${ARGN})
    set_target_properties(${kernels} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_include_directories(${kernels} PRIVATE ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(${kernels} PRIVATE echoarc_build_flags)
    # -O3 in every build type: these loops are written for the vectoriser. Nothing reads errno or the floating-point
    # exception flags after them, so it may use the square root instruction and compute both sides of a choice.
    # Vectors wider than the set's registers are never passed between files: no word about how they would be.
    target_compile_options(${kernels} PRIVATE -O3 -fno-math-errno -fno-trapping-math -Wno-psabi $<$<STREQUAL:${isa},avx2>:-mavx2>)
    target_compile_definitions(${kernels} PRIVATE ECHOARC_ISA=${isa})
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${kernels}>)
  endforeach()
endfunction()
