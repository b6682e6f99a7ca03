# SPDX-License-Identifier: MIT
#
# The VHDL core as devices: programs beside the command that play beats into it.
#   sheen-device-ghdl             GHDL, all configurations (generics are set when it starts)
#   sheen-device-verilator[-X]    Verilator, on the Verilog that GHDL makes of the same VHDL; X names a configuration

find_program(GHDL ghdl REQUIRED)
find_program(VERILATOR verilator REQUIRED)

set(rtl_folder "${PROJECT_SOURCE_DIR}/rtl_vhdl")
file(STRINGS "${rtl_folder}/files.txt" rtl_names)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${rtl_folder}/files.txt")
list(TRANSFORM rtl_names PREPEND "${rtl_folder}/" OUTPUT_VARIABLE rtl_files)

set(ghdl_library "${PROJECT_BINARY_DIR}/ghdl")
file(MAKE_DIRECTORY "${ghdl_library}")
set(ghdl_options --std=08 --work=sheen --workdir=${ghdl_library})

add_custom_command(
  OUTPUT "${ghdl_library}/analysed"
  COMMAND ${GHDL} -a ${ghdl_options} ${rtl_files}
  COMMAND ${CMAKE_COMMAND} -E touch "${ghdl_library}/analysed"
  DEPENDS ${rtl_files}
  WORKING_DIRECTORY "${ghdl_library}"
  COMMENT "GHDL: analysing the VHDL")
add_custom_target(rtl_analysed DEPENDS "${ghdl_library}/analysed")

set(device_bench "${PROJECT_SOURCE_DIR}/testbench/device/device_bench.vhd")
set(ghdl_device "${PROJECT_BINARY_DIR}/sheen-device-ghdl")
add_custom_command(
  OUTPUT "${ghdl_device}"
  COMMAND ${GHDL} -a ${ghdl_options} ${device_bench}
  COMMAND ${GHDL} -e ${ghdl_options} -o "${ghdl_device}" device_bench
  DEPENDS "${ghdl_library}/analysed" ${device_bench}
  WORKING_DIRECTORY "${ghdl_library}"
  COMMENT "GHDL: building sheen-device-ghdl")
add_custom_target(device_ghdl DEPENDS "${ghdl_device}")
add_dependencies(product device_ghdl)
install(PROGRAMS "${ghdl_device}" DESTINATION "${CMAKE_INSTALL_LIBEXECDIR}/sheen")

# sheen_add_verilator_device(<suffix, "" or "-name"> <words per beat> <generic=value>…)
function(sheen_add_verilator_device suffix words_per_beat)
  set(program "${PROJECT_BINARY_DIR}/sheen-device-verilator${suffix}")
  set(folder "${PROJECT_BINARY_DIR}/verilog${suffix}")
  set(verilog "${folder}/shading_core.v")
  set(harness "${PROJECT_SOURCE_DIR}/testbench/device/verilator_main.cpp")
  file(MAKE_DIRECTORY "${folder}")
  list(TRANSFORM ARGN PREPEND "-g" OUTPUT_VARIABLE generics)
  add_custom_command(
    OUTPUT "${verilog}"
    COMMAND "${PROJECT_SOURCE_DIR}/scripts/vhdl_to_verilog.sh" "${verilog}" ${GHDL} --synth ${ghdl_options}
            -gwords_per_beat=${words_per_beat} ${generics} --out=verilog shading_core
    DEPENDS "${ghdl_library}/analysed" "${PROJECT_SOURCE_DIR}/scripts/vhdl_to_verilog.sh"
    WORKING_DIRECTORY "${ghdl_library}"
    VERBATIM
    COMMENT "GHDL: shading_core${suffix} as Verilog")
  # What GHDL writes has widths, initial values and cases as VHDL has them: Verilator's style warnings are not about it.
  add_custom_command(
    OUTPUT "${program}"
    COMMAND ${VERILATOR} --cc --exe --build -j 2 -O3 --x-initial unique -Wno-lint -Wno-INITIALDLY -Wno-COMBDLY --top-module shading_core
            --Mdir "${folder}/model" -CFLAGS "-O2 -std=c++17 -DSHEEN_WORDS_PER_BEAT=${words_per_beat}"
            -o "${program}" "${verilog}" "${harness}" > "${folder}/build.log"
    DEPENDS "${verilog}" "${harness}"
    VERBATIM
    COMMENT "Verilator: building sheen-device-verilator${suffix}")
  add_custom_target(device_verilator${suffix} DEPENDS "${program}")
  add_dependencies(devices device_verilator${suffix})
endfunction()

add_custom_target(devices DEPENDS device_ghdl)
# What the kernels of device hls are built with, too: device_config of hls_device.cpp.
sheen_add_verilator_device("" 2 log_channels=3 has_power=true)
sheen_add_verilator_device("-w32" 1 log_channels=3 has_power=true)
sheen_add_verilator_device("-w128" 4 log_channels=3 has_power=true)
sheen_add_verilator_device("-plain" 2 log_channels=3 has_power=true slices=1)
add_dependencies(product device_verilator)
install(PROGRAMS "${PROJECT_BINARY_DIR}/sheen-device-verilator" DESTINATION "${CMAKE_INSTALL_LIBEXECDIR}/sheen")
