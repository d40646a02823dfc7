# Write UINTER and every module it uses, directly or not, into the one file that ABAQUS compiles:
#   cmake -D source=<project> -D output=<file> -D version=<text> -P uinter_file.cmake
# A module comes after those it uses. Its file follows from its name, as everywhere in the project.

cmake_minimum_required(VERSION 3.20)

# File of a module, empty for one of the compiler's own
function(file_of_module module result)
   set(${result} "" PARENT_SCOPE)
   if(module STREQUAL "asperity")
      set(${result} src/asperity.f90 PARENT_SCOPE)
   elseif(module MATCHES "^asperity_(.+)$")
      set(${result} src/asperity/${CMAKE_MATCH_1}.f90 PARENT_SCOPE)
   elseif(module MATCHES "^uinter_")
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

place(interface/uinter.f90)
get_property(ordered GLOBAL PROPERTY ordered)
file(WRITE ${output}.new
   "! asperity ${version}: UINTER and every module it uses. Generated, do not edit.\n")
foreach(name IN LISTS ordered)
   file(READ ${source}/${name} text)
   file(APPEND ${output}.new "\n! ${name}\n${text}")
endforeach()
file(RENAME ${output}.new ${output})
