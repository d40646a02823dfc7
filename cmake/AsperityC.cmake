# The C interface as a shared library, for C, C++ and anything that loads such libraries: the law,
# the contact point and asperity.h.

# See the file's head: a warning of flang's that the standard does not share
if(CMAKE_Fortran_COMPILER_ID STREQUAL "LLVMFlang")
   set_source_files_properties(interface/c/contents.f90 PROPERTIES COMPILE_OPTIONS -w)
endif()

if(ASPERITY_BUILD_C)
   file(GLOB c_sources CONFIGURE_DEPENDS interface/c/*.f90)
   add_library(asperity_c SHARED ${c_sources})
   add_library(asperity::c ALIAS asperity_c)
   asperity_compile_options(asperity_c)
   target_link_libraries(asperity_c PRIVATE asperity_law)
   set_target_properties(asperity_c PROPERTIES EXPORT_NAME c)
   if(SKBUILD)
      # A wheel of interface/python has its own copy, and wheels have no links between files
      install(TARGETS asperity_c LIBRARY DESTINATION asperity COMPONENT python)
   else()
      # 0.x may change the interface with every x
      set_target_properties(asperity_c PROPERTIES VERSION ${PROJECT_VERSION}
         SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
   endif()
   target_include_directories(asperity_c INTERFACE
      $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/interface/c>
      $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
   if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
      # Nothing is left for the program to supply, and nothing but asperity_* is seen from outside
      set(symbols ${PROJECT_BINARY_DIR}/asperity_c.map)
      configure_file(cmake/asperity_c.map ${symbols} COPYONLY)
      # -Wl, itself, as CMake 3.25 does not know how flang passes options on. It splits at commas,
      # which a folder may have: the map's path is relative to where the linker is started
      set(link_folder ${PROJECT_BINARY_DIR})
      if(CMAKE_GENERATOR MATCHES "^Ninja")
         set(link_folder ${CMAKE_BINARY_DIR})
      endif()
      file(RELATIVE_PATH relative_symbols ${link_folder} ${symbols})
      target_link_options(asperity_c PRIVATE
         -Wl,-z,defs -Wl,--version-script=${relative_symbols})
      set_target_properties(asperity_c PROPERTIES LINK_DEPENDS ${symbols})
   endif()

   install(TARGETS asperity_c EXPORT asperity-c-targets
      LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
   install(FILES interface/c/asperity.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endif()
