#!/usr/bin/env bash
# flang 19.1.7: the end of a line within an internal record is no separator of list-directed input.
#
# A good guess: numbers of a file that is held in a text, `1.0, 2.0,` and `3.0` on two lines, are read by one
# `read (text, *) values`, the newline being as good as a blank; so it is by gfortran 12.2. Seen: flang ends with
# "invalid character (0xa) after list-directed input value"; with a blank in the newline's place it reads them.
source "$(dirname "$0")/lib/setup.sh"
version_is 12.2 gfortran --version
version_is 19.1.7 flang-new-19 --version
cat >lines.f90 <<'F'
program lines
   implicit none
   character(len=:), allocatable :: text
   character(len=80) :: message
   real(8) :: values(3)
   integer :: status
   text = '1.0, 2.0'//new_line('a')//'3.0'//new_line('a')
   read (text, *, iostat=status, iomsg=message) values
   if (status == 0) then
      print '(a, 3f4.1)', 'read', values
   else
      print '(a)', trim(message)
   end if
   text = '1.0, 2.0'//' '//'3.0'//' '
   read (text, *) values
   print '(a, 3f4.1)', 'read', values
end program lines
F
gfortran lines.f90 -o g && flang-new-19 lines.f90 -o f 2>>log
expect 'read 1.0 2.0 3.0' "$(./g | head -n 1)"
expect 'invalid character (0xa) after list-directed input value' "$(./f | head -n 1 | sed 's/, at column.*//')"
expect 'read 1.0 2.0 3.0' "$(./f | tail -n 1)"
