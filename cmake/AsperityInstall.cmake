# What goes where on installation: library, modules, CMake package, pkg-config file, and the
# sources that ABAQUS compiles.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/asperity)
set(share_folder ${CMAKE_INSTALL_DATADIR}/asperity)

install(TARGETS asperity EXPORT asperity-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_BINARY_DIR}/modules/asperity/ DESTINATION ${asperity_module_folder}
   FILES_MATCHING PATTERN "*.mod")
install(EXPORT asperity-targets NAMESPACE asperity:: DESTINATION ${package_folder})

configure_package_config_file(cmake/asperity-config.cmake.in asperity-config.cmake
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
configure_file(cmake/asperity.pc.in asperity.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/asperity.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

install(DIRECTORY interface/ DESTINATION ${share_folder}/interface
   FILES_MATCHING PATTERN "*.f90" PATTERN "*.inc" PATTERN "c" EXCLUDE)
install(FILES ${one_files} DESTINATION ${share_folder})
install(FILES LICENSE CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
