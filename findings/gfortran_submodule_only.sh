#!/usr/bin/env bash
# gfortran 12.2: a submodule cannot name again what its module uses from iso_c_binding.
#
# A good guess: what a submodule names in a use statement of its own hides the same name of its module,
# which is the same thing anyhow; so it is with iso_fortran_env, with modules of one's own, and with flang
# 19.1.7. Seen: with iso_c_binding and ieee_arithmetic that name "conflicts", and the whole list is lost
# with it, so that further messages blame names which only the submodule has. A submodule that names
# nothing which its module has compiles.
source "$(dirname "$0")/lib/setup.sh"
version_is 12.2 gfortran --version
version_is 19.1.7 flang-new-19 --version
status() { # module names-in-the-module names-in-the-submodule value
   cat >parts.f90 <<F
module own
   implicit none
   integer, parameter :: one = 1, two = 2
end module own
module parent
   use :: $1, only: $2
   implicit none
   interface
      module subroutine set(n)
         integer, intent(out) :: n
      end subroutine set
   end interface
end module parent
submodule(parent) child
   use :: $1, only: $3
   implicit none
contains
   module procedure set
      n = int($4)
   end procedure set
end submodule child
F
   local compiler
   for compiler in gfortran flang-new-19; do
      "$compiler" -c parts.f90 >>"$compiler.log" 2>&1 && echo -n ' 0' || echo -n " $?"
      rm -f -- *.mod *.smod
   done
}
c=$(status iso_c_binding c_int 'c_int, c_long' 1_c_long)
ieee=$(status ieee_arithmetic ieee_rint 'ieee_rint, ieee_logb' 'ieee_logb(8.0)')
env=$(status iso_fortran_env int32 'int32, int64' 1_int64)
own=$(status own one 'one, two' two)
further=$(status iso_c_binding c_int c_long 1_c_long)
messages=$(grep -h '^Error' gfortran.log | tr -d '‘’' | paste -sd ';')
expect "iso_c_binding 1 0, ieee_arithmetic 1 0, iso_fortran_env 0 0, own 0 0, other names 0 0
Error: Symbol c_int at (1) conflicts with the symbol at (2);Error: Missing kind-parameter at (1);Error:\
 Symbol ieee_rint at (1) conflicts with the symbol at (2);Error: Function ieee_logb at (1) has no\
 IMPLICIT type" \
   "iso_c_binding$c, ieee_arithmetic$ieee, iso_fortran_env$env, own$own, other names$further
$messages"
