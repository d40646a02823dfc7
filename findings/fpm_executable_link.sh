#!/usr/bin/env bash
# fpm 0.12.0: the libraries that an executable names with `link` come before the package's own library.
#
# A good guess: what [[executable]] link = ["gsl"] names can be used by the modules of src, as with the
# package's [build] link, which spares those who depend on the package. Seen: the linker gets the
# program, -lgsl, and then the archive that needs it. With a static library, or --as-needed, that is too
# early: it is undefined what GSL has. A dependent package links neither, as hoped.
source "$(dirname "$0")/lib/setup.sh"
python_packages fpm==0.12.0
mkdir -p tool/src tool/app other/app
cat >tool/fpm.toml <<'F'
name = "tool"
[[executable]]
name = "tool"
source-dir = "app"
main = "main.f90"
link = ["m"]
F
cat >tool/src/tool.f90 <<'F'
module tool
   implicit none
contains
   subroutine hello()
      print '(a)', 'hello'
   end subroutine hello
end module tool
F
cat >other/fpm.toml <<'F'
name = "other"
[dependencies]
tool = { path = "../tool" }
F
for package in tool other; do
   cat >$package/app/main.f90 <<'F'
program main
   use tool, only: hello
   implicit none
   call hello()
end program main
F
done
order() { # package
   (cd "$1" && "$folder/venv/bin/fpm" build --verbose 2>&1) | grep "/app/$1\$" \
      | grep -o -E ' -lm( |$)|main.f90.o|lib[a-z]*\.a' | tr -d ' ' | paste -sd ' '
}
expect 'tool: main.f90.o -lm libtool.a; other: main.f90.o libother.a' \
   "tool: $(order tool); other: $(order other)"
