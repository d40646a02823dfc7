# What asperity cannot be built for: refused here, with the reason, before anything is compiled.

# Addresses and doubles at multiples of 8 bytes are what UINTER and the C interface are made for,
# and the 80-bit arithmetic of 32-bit x86 is not that of the law's error bounds. Where CMake cannot
# tell, src/base/kinds.f90 does not compile
if(CMAKE_SIZEOF_VOID_P AND NOT CMAKE_SIZEOF_VOID_P EQUAL 8)
   math(EXPR pointer_bits "8*${CMAKE_SIZEOF_VOID_P}")
   message(FATAL_ERROR "asperity needs a 64-bit system, and ${CMAKE_Fortran_COMPILER} compiles "
      "for ${pointer_bits} bits. Take -m32 out of the flags, or use a 64-bit compiler.")
endif()

# Sums are compensated and values that are not numbers are looked for: a compiler that reorders
# sums or assumes that there are none gives wrong results
set(unsafe_flag "-Ofast|-f?fast|-ffast-math|-funsafe-math-optimizations|-fassociative-math"
   "|-freciprocal-math|-ffinite-math-only|-fno-honor-(nans|infinities)|-fno-protect-parens"
   "|[-/]f?fp-model[ =](fast|aggressive)[^ ;]*|/fp:fast[^ ;]*")
list(JOIN unsafe_flag "" unsafe_flag)

# Stop if a variable or property, by its name for the user, has such a flag
function(asperity_refuse_unsafe_flag name flags)
   if("${flags}" MATCHES "(^|[ ;])(${unsafe_flag})($|[ ;])")
      message(FATAL_ERROR "${name} has ${CMAKE_MATCH_2}, with which compilers reorder sums and do "
         "not see values that are not numbers: asperity's results would be wrong. Take it out; "
         "-O3 and -march=native do no harm.")
   endif()
endfunction()

asperity_refuse_unsafe_flag(CMAKE_Fortran_COMPILER "${CMAKE_Fortran_COMPILER_ARG1}")
asperity_refuse_unsafe_flag("CMAKE_Fortran_FLAGS (or FFLAGS in the environment)"
   "${CMAKE_Fortran_FLAGS}")
set(configurations ${CMAKE_CONFIGURATION_TYPES})
if(NOT configurations)
   set(configurations ${CMAKE_BUILD_TYPE})
endif()
foreach(configuration IN LISTS configurations)
   string(TOUPPER CMAKE_Fortran_FLAGS_${configuration} variable)
   string(REPLACE CMAKE_FORTRAN CMAKE_Fortran variable ${variable})
   asperity_refuse_unsafe_flag(${variable} "${${variable}}")
endforeach()
get_directory_property(inherited_options COMPILE_OPTIONS)
asperity_refuse_unsafe_flag("add_compile_options of the project around asperity"
   "${inherited_options}")
