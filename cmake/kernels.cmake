# SPDX-License-Identifier: MIT
#
# Kernels and what is compiled with them, for one release of ac_types. The library exists once a release, because two
# releases must not meet in one program; sources that see no kernel are compiled once and shared.

# sheen_add_kernels(TARGET AC_TYPES_FOLDER): an interface library, the kernels with these ac_types.
function(sheen_add_kernels target ac_types)
  add_library(${target} INTERFACE)
  target_include_directories(${target} INTERFACE "${PROJECT_SOURCE_DIR}/hls/include")
  target_include_directories(${target} SYSTEM INTERFACE "${ac_types}")
endfunction()

# sheen_includes_kernels(RESULT SOURCE): does the source, or a header it reaches, include a kernel? formats.hpp is none.
function(sheen_includes_kernels result source)
  set(pending "${source}")
  set(seen "")
  set(found FALSE)
  while(pending AND NOT found)
    list(POP_FRONT pending file)
    list(APPEND seen "${file}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    get_filename_component(folder "${file}" DIRECTORY)
    file(STRINGS "${file}" lines REGEX "^#include \"")
    foreach(line ${lines})
      string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" header "${line}")
      if(header MATCHES "^sheen/hls/" AND NOT header STREQUAL "sheen/hls/formats.hpp")
        set(found TRUE)
      endif()
      foreach(candidate "${folder}/${header}" "${PROJECT_SOURCE_DIR}/host/include/${header}")
        get_filename_component(candidate "${candidate}" ABSOLUTE)
        if(EXISTS "${candidate}" AND NOT "${candidate}" IN_LIST seen)
          list(APPEND pending "${candidate}")
        endif()
      endforeach()
    endforeach()
  endwhile()
  set(${result} ${found} PARENT_SCOPE)
endfunction()

function(sheen_compile_host target kernels)
  target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/host/include>"
                             "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/hls/include>" "$<INSTALL_INTERFACE:include>")
  target_link_libraries(${target} PUBLIC glm::glm PRIVATE assimp::assimp PNG::PNG fmt::fmt
                        "$<BUILD_INTERFACE:nlohmann_json::nlohmann_json>" "$<BUILD_INTERFACE:sheen_warnings>"
                        "$<BUILD_INTERFACE:${kernels}>")
endfunction()

# sheen_add_host_library(TARGET KERNELS SOURCES...): the host library on top of these kernels.
function(sheen_add_host_library target kernels)
  set(kernel_sources "")
  set(plain_sources "")
  foreach(source ${ARGN})
    sheen_includes_kernels(with_kernels "${source}")
    if(with_kernels)
      list(APPEND kernel_sources "${source}")
    else()
      list(APPEND plain_sources "${source}")
    endif()
  endforeach()
  if(NOT TARGET sheen_host)
    add_library(sheen_host OBJECT ${plain_sources})
    set_target_properties(sheen_host PROPERTIES POSITION_INDEPENDENT_CODE "${BUILD_SHARED_LIBS}")
    sheen_compile_host(sheen_host ${kernels})
  endif()
  add_library(${target} ${kernel_sources} "$<TARGET_OBJECTS:sheen_host>")
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX)
  sheen_compile_host(${target} ${kernels})
endfunction()
