#!/usr/bin/env bash
# CMake 3.25.1 with Ninja: sources of Fortran that are not preprocessed are read again in every build.
#
# A good guess: CMAKE_Fortran_PREPROCESS OFF, for sources without a preprocessor, spares work. Seen:
# whatever was built before, each build looks for the modules of every source again, as the file of
# dependencies that CMake writes does not name the output that Ninja expects ("ninja -d explain").
# Nothing is compiled again, but with hundreds of files each build takes seconds. With preprocessing
# there is no work to do.
source "$(dirname "$0")/lib/setup.sh"
python_packages cmake==3.25.2 ninja==1.11.1
PATH=$folder/venv/bin:$PATH
mkdir project
printf 'module one\n   implicit none\nend module one\n' >project/one.f90
printf 'program main\n   use one\n   implicit none\nend program main\n' >project/main.f90
second_build() { # ON|OFF
   printf '%s\n' 'cmake_minimum_required(VERSION 3.20)' 'project(p LANGUAGES Fortran)' \
      "set(CMAKE_Fortran_PREPROCESS $1)" 'add_executable(main main.f90 one.f90)' >project/CMakeLists.txt
   cmake -S project -B "$1" -G Ninja >"$1.log" 2>&1 && ninja -C "$1" >>"$1.log" || { cat "$1.log"; exit 1; }
   # a second later, so that no time is as old as another
   sleep 1
   ninja -C "$1" | grep -c 'Generating Fortran dependencies' || true
}
off=$(second_build OFF)
on=$(second_build ON)
expect 'sources read again in a second build: OFF 2, ON 0' \
   "sources read again in a second build: OFF $off, ON $on"
