# SPDX-License-Identifier: MIT
#
# What `make install` copies: headers (host and kernels), libsheen, the command, the program behind SSIM and FLIP, the
# VHDL, a CMake package that exports sheen::sheen, and sheen.pc. Kernels need the user's own ac_types beside them.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS sheen EXPORT sheen_targets)
if(TARGET sheen_command)
  install(TARGETS sheen_command)
endif()
install(DIRECTORY host/include/sheen hls/include/sheen TYPE INCLUDE FILES_MATCHING PATTERN "*.hpp")
install(FILES scripts/metrics/picture_metrics.py DESTINATION "${CMAKE_INSTALL_DATADIR}/sheen/metrics")
install(DIRECTORY rtl_vhdl DESTINATION "${CMAKE_INSTALL_DATADIR}/sheen" FILES_MATCHING PATTERN "*.vhd")

set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/sheen")
install(EXPORT sheen_targets NAMESPACE sheen:: DESTINATION "${package_folder}")
configure_package_config_file(cmake/sheenConfig.cmake.in sheenConfig.cmake INSTALL_DESTINATION "${package_folder}")
write_basic_package_version_file(sheenConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/sheenConfig.cmake" "${PROJECT_BINARY_DIR}/sheenConfigVersion.cmake"
        DESTINATION "${package_folder}")

# The file finds its prefix from where it lies: `make install PREFIX=…` chooses that after configuring.
file(RELATIVE_PATH pc_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
configure_file(cmake/sheen.pc.in sheen.pc @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/sheen.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
