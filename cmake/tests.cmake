# SPDX-License-Identifier: MIT
#
# One test program for each tests/*_test.cpp; a test of kernels exists a second time, as <name>_ac_old, compiled with
# the old ac_types. One benchmark for each tests/*_bench.cpp. The lint's own tests.

enable_testing()
include(GoogleTest)
find_package(GTest REQUIRED)
find_package(benchmark REQUIRED)
find_package(Python3 REQUIRED COMPONENTS Interpreter)

file(GLOB test_sources CONFIGURE_DEPENDS tests/*_test.cpp)
if(AC_TYPES_OLD)
  sheen_add_kernels(sheen_hls_ac_old "${AC_TYPES_OLD}")
  sheen_add_host_library(sheen_ac_old sheen_hls_ac_old ${host_sources})
  set_target_properties(sheen_ac_old PROPERTIES EXCLUDE_FROM_ALL ON)
endif()

# sheen_add_test(NAME SOURCE LIBRARY KERNELS SUFFIX)
function(sheen_add_test name source library kernels suffix)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE ${library} ${kernels} sheen_warnings GTest::gtest_main rapidcheck fmt::fmt
                        nlohmann_json::nlohmann_json)
  target_compile_definitions(${name} PRIVATE SHEEN_COMMAND="${PROJECT_BINARY_DIR}/sheen")
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST TEST_SUFFIX "${suffix}" WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
endfunction()

foreach(source ${test_sources})
  get_filename_component(name ${source} NAME_WE)
  sheen_add_test(${name} ${source} sheen sheen_hls "")
  sheen_includes_kernels(with_kernels "${source}")
  if(AC_TYPES_OLD AND with_kernels)
    sheen_add_test(${name}_ac_old ${source} sheen_ac_old sheen_hls_ac_old " (old ac_types)")
  endif()
endforeach()

add_custom_target(benchmarks)
file(GLOB benchmark_sources CONFIGURE_DEPENDS tests/*_bench.cpp)
foreach(source ${benchmark_sources})
  get_filename_component(name ${source} NAME_WE)
  add_executable(${name} EXCLUDE_FROM_ALL ${source})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/benchmarks")
  target_link_libraries(${name} PRIVATE sheen sheen_hls sheen_warnings benchmark::benchmark_main)
  add_dependencies(benchmarks ${name})
endforeach()

# Every bad kernel is refused, for the reason that its name tells; the good ones are accepted.
file(GLOB lint_sources CONFIGURE_DEPENDS tests/lint/*.cpp)
foreach(source ${lint_sources})
  get_filename_component(name ${source} NAME_WE)
  string(REGEX REPLACE "_(step|core)$" "" reason ${name})
  add_test(NAME check_synthesizable.${name}
           COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/scripts/check_synthesizable.py" --expect ${reason}
                   --ac-types "${AC_TYPES}" --out "${PROJECT_BINARY_DIR}/lint" "${source}")
endforeach()
