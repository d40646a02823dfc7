# Write a subroutine of interface/ and every module it uses, directly or not, into the one file that
# ABAQUS compiles:
#   cmake -D source=<project> -D output=<file> -D version=<text> -D routine=uinter|vuinter
#      [-D single=ON] -P one_file.cmake
# A module comes after those it uses. Its file follows from its name, as everywhere in the project.
# single=ON gives VUINTER's arguments the single precision that ABAQUS/Explicit has by default.

cmake_minimum_required(VERSION 3.20)

# File of a module, empty for one of the compiler's own
function(file_of_module module result)
   set(${result} "" PARENT_SCOPE)
   if(module STREQUAL "asperity")
      set(${result} src/asperity.f90 PARENT_SCOPE)
   elseif(module MATCHES "^asperity_(.+)$")
      set(${result} src/asperity/${CMAKE_MATCH_1}.f90 PARENT_SCOPE)
   elseif(module MATCHES "^v?uinter_")
      set(${result} interface/${module}.f90 PARENT_SCOPE)
   endif()
endfunction()

# Append a file to the list `ordered`, after the files of the modules it uses
function(place name)
   get_property(ordered GLOBAL PROPERTY ordered)
   if(name IN_LIST ordered)
      return()
   endif()
   file(STRINGS ${source}/${name} lines REGEX "^ *use +[a-z]")
   foreach(line IN LISTS lines)
      string(REGEX REPLACE "^ *use +([a-z0-9_]+).*" "\\1" module "${line}")
      file_of_module(${module} file)
      if(file)
         place(${file})
      endif()
   endforeach()
   set_property(GLOBAL APPEND PROPERTY ordered ${name})
endfunction()

place(interface/${routine}.f90)
get_property(ordered GLOBAL PROPERTY ordered)
string(TOUPPER ${routine} title)
set(changed OFF)
if(single)
   string(APPEND title " in single precision")
endif()
file(WRITE ${output}.new
   "! asperity ${version}: ${title} and every module it uses. Generated, do not edit.\n")
foreach(name IN LISTS ordered)
   file(READ ${source}/${name} text)
   if(single AND name STREQUAL "interface/vuinter_precision.f90")
      string(REPLACE real64 real32 text "${text}")
      set(changed ON)
   endif()
   file(APPEND ${output}.new "\n! ${name}\n${text}")
endforeach()
if(single AND NOT changed)
   message(FATAL_ERROR "interface/vuinter_precision.f90 is not used by ${routine}")
endif()
file(RENAME ${output}.new ${output})
