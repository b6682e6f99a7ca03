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
  file(STRINGS "${source}" command_lines REGEX "command_fixture.hpp")
  if(command_lines)
    target_compile_definitions(${name} PRIVATE SHEEN_COMMAND="$<TARGET_FILE:sheen_command>")
    add_dependencies(${name} sheen_command)
  endif()
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

# Tests that count the clocks of each stream width.
foreach(name cycle_model_test throughput_test)
  add_dependencies(${name} device_verilator device_verilator-w32 device_verilator-w128)
endforeach()

# make_vectors_<unit> OUTDIR [seed] [count] writes a bench's vectors.
file(GLOB vector_sources CONFIGURE_DEPENDS tests/vectors/make_vectors_*.cpp)
foreach(source ${vector_sources})
  get_filename_component(name ${source} NAME_WE)
  add_executable(${name} ${source})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/vectors")
  target_link_libraries(${name} PRIVATE sheen sheen_hls sheen_warnings)
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

# throughput quick|full OUT.json counts the core's clocks; it finds the devices beside itself.
add_executable(throughput EXCLUDE_FROM_ALL tests/bench/throughput.cpp)
target_link_libraries(throughput PRIVATE sheen sheen_hls sheen_warnings fmt::fmt nlohmann_json::nlohmann_json)
add_dependencies(throughput device_ghdl device_verilator device_verilator-w32 device_verilator-w128)
add_dependencies(benchmarks throughput)

# paper_results FOLDER measures and draws what the papers show. It counts the operations of the library's own parts.
file(GLOB paper_sources CONFIGURE_DEPENDS tests/paper/*.cpp)
add_executable(paper_results EXCLUDE_FROM_ALL ${paper_sources} host/apps/sheen/output.cpp)
target_include_directories(paper_results PRIVATE host/src host/apps/sheen)
target_link_libraries(paper_results PRIVATE sheen sheen_hls sheen_warnings CLI11::CLI11 fmt::fmt
                      nlohmann_json::nlohmann_json)

# cosim_pictures [--full] compares whole pictures and random streams on all devices.
add_executable(cosim_pictures tests/cosim/pictures.cpp)
target_include_directories(cosim_pictures PRIVATE tests)
target_link_libraries(cosim_pictures PRIVATE sheen sheen_hls sheen_warnings fmt::fmt)
add_dependencies(cosim_pictures devices)

# make_ip_example writes the vectors of the example of `make ip`.
add_executable(make_ip_example EXCLUDE_FROM_ALL tests/ip/make_ip_example.cpp)
target_link_libraries(make_ip_example PRIVATE sheen sheen_hls sheen_warnings fmt::fmt)

# Every bad kernel tests/lint/<reason>/*.cpp is refused, for that reason; those of tests/lint/accepted pass.
file(GLOB lint_sources CONFIGURE_DEPENDS tests/lint/*/*.cpp)
foreach(source ${lint_sources})
  cmake_path(GET source PARENT_PATH reason)
  cmake_path(GET reason FILENAME reason)
  cmake_path(GET source STEM name)
  add_test(NAME check_synthesizable.${reason}.${name}
           COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/scripts/check_synthesizable.py" --expect ${reason}
                   --ac-types "${AC_TYPES}" --out "${PROJECT_BINARY_DIR}/lint" "${source}")
endforeach()
