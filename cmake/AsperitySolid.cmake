# The joint as a solid. Without PETSc it compiles, and its solver says what to install.

option(ASPERITY_PETSC "Solve solids by PETSc, if it is found" ON)
set(engine src/solid/engine/without_petsc.f90)
if(ASPERITY_PETSC)
   # Real numbers and Open MPI, as Debian's libpetsc-real-dev has them
   find_library(asperity_petsc_library petsc_real)
   mark_as_advanced(asperity_petsc_library)
   if(asperity_petsc_library)
      set(engine interface/petsc/*.f90)
   endif()
endif()
set(asperity_has_petsc OFF)
if(engine MATCHES petsc/)
   set(asperity_has_petsc ON)
endif()
message(STATUS "asperity solid: PETSc ${asperity_petsc_library}")

file(GLOB_RECURSE solid_sources CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} src/solid/*.f90)
list(FILTER solid_sources EXCLUDE REGEX "without_petsc")
asperity_library(solid ${solid_sources} ${engine})
target_link_libraries(asperity_solid PUBLIC asperity_deck)
if(asperity_has_petsc)
   target_link_libraries(asperity_solid PRIVATE
      "$<BUILD_INTERFACE:${asperity_petsc_library}>$<INSTALL_INTERFACE:petsc_real>")
endif()
