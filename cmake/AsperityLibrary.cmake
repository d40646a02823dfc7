# A library of the project: static, with its modules, installed as asperity::<name>.

# asperity_library(<name> <pattern>...): the target asperity_<name> from files of these folders and
# those below them; what it is linked to is told afterwards
function(asperity_library name)
   file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${ARGN})
   set(target asperity_${name})
   add_library(${target} STATIC ${sources})
   add_library(asperity::${name} ALIAS ${target})
   asperity_compile_options(${target})
   target_include_directories(${target} PUBLIC
      $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/modules/${target}>
      $<INSTALL_INTERFACE:${asperity_module_folder}>)
   set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
   install(TARGETS ${target} EXPORT asperity-fortran-targets
      ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
   install(DIRECTORY ${PROJECT_BINARY_DIR}/modules/${target}/ DESTINATION ${asperity_module_folder}
      FILES_MATCHING PATTERN "*.mod")
endfunction()
