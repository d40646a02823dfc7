#!/usr/bin/env bash
# FORD 7.0.13: a character length that is a function of three or more arguments drops the whole file.
#
# A good guess: a documentation tool that meets a declaration it cannot read leaves out that procedure,
# or fails. Seen: `character(len=width(a, b, c))`, which is standard Fortran, makes FORD warn of a bad
# declaration with too many parameters, leave out every page of the file, the module's own too, and
# end with status 0. With two arguments there are all pages.
source "$(dirname "$0")/lib/setup.sh"
python_packages ford==7.0.13
pages() { # arguments
   mkdir -p "src_$2"
   cat >"src_$2/texts.f90" <<F
module texts
   implicit none
contains
   pure integer function width($1)
      integer, intent(in) :: $1
      width = max($1)
   end function width
   pure function text($1) result(line)
      integer, intent(in) :: $1
      character(len=width($1)) :: line
      line = ''
   end function text
end module texts
F
   printf 'module other\n   implicit none\nend module other\n' >"src_$2/other.f90"
   printf -- '---\nproject: p\nsrc_dir: ./src_%s\noutput_dir: ./doc_%s\npreprocess: false\n---\n' "$2" "$2" >"$2.md"
   venv/bin/ford "$2.md" >"$2.log" 2>&1 && status=0 || status=$?
   echo "$2 arguments: status $status, $(find "doc_$2" -path '*module/texts.html' -o -path '*proc/text.html' | wc -l) pages"
}
found=$(pages 'a, b' 2; pages 'a, b, c' 3)
expect $'2 arguments: status 0, 2 pages\n3 arguments: status 0, 0 pages' "$found"
