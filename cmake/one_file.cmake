# Write a subroutine and every module it uses, directly or not, into the one file that ABAQUS
# compiles:
#   cmake -D source=<project> -D output=<file> -D version=<text> -D routine=uinter|vuinter
#      [-D single=ON] -P one_file.cmake
# A module comes after those it uses. single=ON gives VUINTER's arguments the single precision that
# ABAQUS/Explicit has by default.

cmake_minimum_required(VERSION 3.20)

# The file of each module of the folders that may be used, in file_of_<module>
file(GLOB_RECURSE names RELATIVE ${source} ${source}/src/asperity.f90 ${source}/src/base/*.f90
   ${source}/src/paper/*.f90 ${source}/src/law/*.f90 ${source}/src/contact/*.f90
   ${source}/interface/abaqus/routines/*.f90)
foreach(name IN LISTS names)
   file(STRINGS ${source}/${name} line LIMIT_COUNT 1 REGEX "^module [a-z]")
   string(REGEX REPLACE "^module +([a-z0-9_]+).*" "\\1" module "${line}")
   set(file_of_${module} ${name})
endforeach()

# Append a file to the list `ordered`, after the files of the modules it uses
function(place name)
   get_property(ordered GLOBAL PROPERTY ordered)
   if(name IN_LIST ordered)
      return()
   endif()
   file(STRINGS ${source}/${name} lines REGEX "^ *use +[a-z]")
   foreach(line IN LISTS lines)
      string(REGEX REPLACE "^ *use +([a-z0-9_]+).*" "\\1" module "${line}")
      # the compiler's own modules have none
      if(DEFINED file_of_${module})
         place(${file_of_${module}})
      endif()
   endforeach()
   set_property(GLOBAL APPEND PROPERTY ordered ${name})
endfunction()

place(interface/abaqus/routines/${routine}.f90)
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
   if(single AND name STREQUAL "interface/abaqus/routines/vuinter_precision.f90")
      string(REPLACE real64 real32 text "${text}")
      set(changed ON)
   endif()
   file(APPEND ${output}.new "\n! ${name}\n${text}")
endforeach()
if(single AND NOT changed)
   message(FATAL_ERROR "interface/abaqus/routines/vuinter_precision.f90 is not used by ${routine}")
endif()
file(RENAME ${output}.new ${output})
