# SPDX-License-Identifier: GPL-3.0-or-later
# seam_module(<name> [DEPENDS <module>...] [PRIVATE_LIBS <target>...] [PUBLIC_LIBS <target>...])
#
# Declares the library seam::<name> from every .cpp of the current folder.
#
# A module sees its own headers and those of the modules it depends on, and no
# others: its include root holds a single link, named like the module, to its
# folder. A forbidden #include therefore fails in the compiler, at its own line.
function(seam_module name)
  cmake_parse_arguments(ARG "" "" "DEPENDS;PRIVATE_LIBS;PUBLIC_LIBS" ${ARGN})

  foreach(dependency IN LISTS ARG_DEPENDS)
    if(NOT TARGET seam::${dependency})
      message(FATAL_ERROR
        "module '${name}' depends on '${dependency}', which is not declared above it")
    endif()
  endforeach()
  list(TRANSFORM ARG_DEPENDS PREPEND seam::)

  set(root ${PROJECT_BINARY_DIR}/include_roots/${name})
  file(MAKE_DIRECTORY ${root})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${root}/${name} SYMBOLIC)

  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(sources)
    add_library(seam_${name} STATIC ${sources})
    target_include_directories(seam_${name} PUBLIC $<BUILD_INTERFACE:${root}>)
    target_compile_features(seam_${name} PUBLIC cxx_std_20)
    target_link_libraries(seam_${name} PUBLIC $<BUILD_INTERFACE:seam_flags> ${ARG_DEPENDS} ${ARG_PUBLIC_LIBS}
                          PRIVATE ${ARG_PRIVATE_LIBS})
    set_target_properties(seam_${name} PROPERTIES OUTPUT_NAME seamproof_${name} EXPORT_NAME ${name})
  else()
    add_library(seam_${name} INTERFACE)
    target_include_directories(seam_${name} INTERFACE ${root})
    target_link_libraries(seam_${name} INTERFACE seam_flags ${ARG_DEPENDS})
  endif()
  add_library(seam::${name} ALIAS seam_${name})
endfunction()

# What every target is compiled with: the language and the warnings.
add_library(seam_flags INTERFACE)
target_compile_features(seam_flags INTERFACE cxx_std_20)
target_compile_options(seam_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  # False alarms of GCC 12 in optimised code of std::string and Boost.Multiprecision (its bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-maybe-uninitialized>)
