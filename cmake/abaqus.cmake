# All that an ABAQUS user needs, without compiler or configuration:
#   cmake [-D output=FOLDER] -P cmake/abaqus.cmake
# It goes to FOLDER, build/abaqus below the current folder unless given: UINTER and VUINTER, each with
# every module it uses and what to know in its head, and what stands ready in interface/abaqus/ready.

cmake_minimum_required(VERSION 3.20)
get_filename_component(source "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)
include("${CMAKE_CURRENT_LIST_DIR}/abaqus/modules.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/abaqus/comments.cmake")

if("${output}" STREQUAL "")
   set(output build/abaqus)
endif()
get_filename_component(output "${output}" ABSOLUTE)
if(EXISTS "${output}" AND NOT IS_DIRECTORY "${output}")
   message(FATAL_ERROR "output = ${output} is a file: give a folder")
endif()

find_modules()
file(STRINGS "${source}/CMakeLists.txt" version LIMIT_COUNT 1 REGEX "^   VERSION [0-9.]+$")
string(REGEX REPLACE "^   VERSION " "" version "${version}")
file(READ "${source}/LICENSE" licence)
string(REGEX REPLACE "\n" "\n! " licence "! ${licence}")
string(REGEX REPLACE " *\n! *$" "\n" licence "${licence}")
string(REGEX REPLACE "! \n" "!\n" licence "${licence}")

# One routine in three files. Only Intel's compilers know the directive, which must begin in the first
# column
function(write_routine name title routine single)
   comments_of_parts(head ${ARGN})
   text_of_routine(${routine} ${single} text)
   set(text "! asperity ${version}: ${title}
! with every module it uses. Generated, do not edit.
${head}!
! More: docs/abaqus.md of asperity, whose parts these are.
!
${licence}${text}")
   if(text MATCHES "([^\n]*[^\n -~][^\n]*)")
      message(FATAL_ERROR "${name} would have a character that is not ASCII: ${CMAKE_MATCH_1}")
   endif()
   file(WRITE "${output}/${name}.f90" "${text}")
   foreach(ending IN ITEMS for f)
      file(WRITE "${output}/${name}.${ending}" "!DIR$ FREEFORM\n${text}")
   endforeach()
endfunction()

set(common props statev output signs)
write_routine(asperity_uinter "UINTER for ABAQUS/Standard" uinter OFF
   uinter "uinter deck" ${common})
write_routine(asperity_vuinter "VUINTER for ABAQUS/Explicit with double" vuinter OFF
   vuinter ${common})
write_routine(asperity_vuinter_single "VUINTER for ABAQUS/Explicit in single precision" vuinter ON
   vuinter ${common})

set(ready "${source}/interface/abaqus/ready")
if(NOT output STREQUAL ready)
   file(COPY "${ready}/" DESTINATION "${output}" PATTERN "asperity_*uinter*" EXCLUDE)
endif()
message(STATUS "asperity ${version} for ABAQUS: ${output}")
