# What goes where on installation besides libraries and program: the CMake package, the pkg-config
# file, and in one folder, whose links lead from one file to another, documents, examples, what is
# for ABAQUS, and what puts a UINTER into CalculiX; man page and completion. `cmake --build . --target
# uninstall` removes what was installed last.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/asperity)
set(share_folder ${CMAKE_INSTALL_DATADIR}/asperity)

install(EXPORT asperity-fortran-targets NAMESPACE asperity:: DESTINATION ${package_folder})
if(ASPERITY_BUILD_C)
   install(EXPORT asperity-c-targets NAMESPACE asperity:: DESTINATION ${package_folder})
endif()
configure_package_config_file(cmake/package/asperity-config.cmake.in asperity-config.cmake
   INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(asperity-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES
   ${PROJECT_BINARY_DIR}/asperity-config.cmake
   ${PROJECT_BINARY_DIR}/asperity-config-version.cmake
   DESTINATION ${package_folder})

# Relative to the file itself, so that the installed tree can be moved
set(pc_folder ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH pc_prefix ${pc_folder} ${CMAKE_INSTALL_PREFIX})
file(RELATIVE_PATH pc_modules ${pc_folder}
   ${CMAKE_INSTALL_FULL_INCLUDEDIR}/asperity/${compiler_name})
file(RELATIVE_PATH pc_include ${pc_folder} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
configure_file(cmake/package/asperity.pc.in asperity.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/asperity.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
if(ASPERITY_BUILD_C)
   configure_file(cmake/package/asperity-c.pc.in asperity-c.pc @ONLY)
   install(FILES ${PROJECT_BINARY_DIR}/asperity-c.pc
      DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()

install(FILES README.md ARCHITECTURE.md CONTRIBUTING.md CHANGELOG.md LICENSE CITATION.cff
   DESTINATION ${share_folder})
# The Python package is built from the project's sources alone
install(DIRECTORY docs examples interface DESTINATION ${share_folder} USE_SOURCE_PERMISSIONS
   PATTERN __pycache__ EXCLUDE REGEX "/interface/(abaqus/ready|python)$" EXCLUDE)
# As these sources make it, not as it stands ready
install(DIRECTORY ${abaqus_folder}/ DESTINATION ${share_folder}/interface/abaqus/ready)
# What the glue of interface/calculix and its look at the user's file are compiled with
install(FILES src/base/kinds.f90 src/base/letter_case.f90 src/base/error.f90 src/base/finite.f90
   src/base/number_text.f90 DESTINATION ${share_folder}/src/base)
install(FILES src/check/finding.f90 src/check/argument_lists.f90 src/check/argument_types.f90
   DESTINATION ${share_folder}/src/check)
install(DIRECTORY src/check/source DESTINATION ${share_folder}/src/check)

# The program writes its own man page and completion, where it can run here
if(ASPERITY_BUILD_PROGRAM AND NOT CMAKE_CROSSCOMPILING)
   set(help_files ${PROJECT_BINARY_DIR}/asperity.1 ${PROJECT_BINARY_DIR}/asperity.bash)
   add_custom_command(OUTPUT ${help_files}
      COMMAND asperity_program help --man > ${PROJECT_BINARY_DIR}/asperity.1
      COMMAND asperity_program help --completion bash > ${PROJECT_BINARY_DIR}/asperity.bash
      DEPENDS asperity_program VERBATIM)
   add_custom_target(asperity_help_files ALL DEPENDS ${help_files})
   install(FILES ${PROJECT_BINARY_DIR}/asperity.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
   install(FILES ${PROJECT_BINARY_DIR}/asperity.bash
      DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME asperity)
endif()

if(is_top_level)
   add_custom_target(uninstall
      COMMAND ${CMAKE_COMMAND} -D build=${PROJECT_BINARY_DIR} 
         -P ${PROJECT_SOURCE_DIR}/cmake/package/uninstall.cmake
      VERBATIM)
endif()
