# A user subroutine and every module it uses, directly or not, as one text: a module comes after
# those it uses.

# Set file_of_<module> for every module of the folders that may be used
macro(find_modules)
   file(GLOB_RECURSE names RELATIVE "${source}" "${source}/src/asperity.f90"
      "${source}/src/base/*.f90" "${source}/src/paper/*.f90" "${source}/src/law/*.f90"
      "${source}/src/contact/*.f90" "${source}/interface/abaqus/routines/*.f90")
   if(NOT names)
      message(FATAL_ERROR "${source} has no src/base/*.f90: cmake/abaqus.cmake works in the "
         "project's own folder, not alone")
   endif()
   foreach(name IN LISTS names)
      file(STRINGS "${source}/${name}" line LIMIT_COUNT 1 REGEX "^module [a-z]")
      string(REGEX REPLACE "^module +([a-z0-9_]+).*" "\\1" module "${line}")
      set(file_of_${module} ${name})
   endforeach()
endmacro()

# Append a file to the list `ordered`, after the files of the modules it uses
function(place name)
   get_property(ordered GLOBAL PROPERTY ordered)
   if(name IN_LIST ordered)
      return()
   endif()
   file(STRINGS "${source}/${name}" lines REGEX "^ *use +[a-z]")
   foreach(line IN LISTS lines)
      string(REGEX REPLACE "^ *use +([a-z0-9_]+).*" "\\1" module "${line}")
      if(DEFINED file_of_${module})
         place(${file_of_${module}})
      elseif(module MATCHES "^asperity_")
         message(FATAL_ERROR "${name} uses ${module}, which is in none of the folders that the "
            "one file may take: src/base, paper, law, contact, interface/abaqus/routines")
      endif()
   endforeach()
   set_property(GLOBAL APPEND PROPERTY ordered ${name})
endfunction()

# The text of a routine; `single` gives VUINTER's arguments the single precision that
# ABAQUS/Explicit has by default
function(text_of_routine routine single result)
   set(kind_file interface/abaqus/routines/vuinter_precision.f90)
   set_property(GLOBAL PROPERTY ordered "")
   place(interface/abaqus/routines/${routine}.f90)
   get_property(ordered GLOBAL PROPERTY ordered)
   if(single AND NOT kind_file IN_LIST ordered)
      message(FATAL_ERROR "${kind_file}, which sets the precision, is not used by ${routine}")
   endif()
   set(whole "")
   foreach(name IN LISTS ordered)
      file(READ "${source}/${name}" text)
      if(single AND name STREQUAL kind_file)
         string(REPLACE real64 real32 text "${text}")
      endif()
      string(APPEND whole "\n! ${name}\n${text}")
   endforeach()
   set(${result} "${whole}" PARENT_SCOPE)
endfunction()
