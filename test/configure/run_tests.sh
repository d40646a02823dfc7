#!/usr/bin/env bash
# Tests of the build itself: run_tests.sh
# The same results in whatever folder the project is built, and what cannot be built is refused with
# the reason. The last line is `N passed, N failed`.
set -u -o pipefail
export LC_ALL=C
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT
log=$work/log
passed=0
failed=0

check() { # name command...
   if "${@:2}" >"$log" 2>&1 </dev/null; then
      passed=$((passed + 1))
      echo "ok   $1"
   else
      failed=$((failed + 1))
      echo "FAIL $1"
      tail -n 20 "$log" | sed 's/^/     | /'
   fi
}

# No configuration takes a minute, no library four
cmake_within() { # seconds argument...
   timeout -k 5 "$1" cmake "${@:2}"
}

configure() { # source build option...
   cmake_within 60 -S "$1" -B "$2" -DBUILD_TESTING=OFF -DASPERITY_BUILD_PROGRAM=OFF \
      -DCMAKE_BUILD_TYPE=None "${@:3}"
}

# What the library and the C interface are built from, in a folder of the user's
copy_to() { # folder
   mkdir -p "$1" && cp -r "$root"/{CMakeLists.txt,LICENSE,CITATION.cff,cmake,interface,src} "$1"
}

symbols() { # build: what libasperity_c.so offers
   nm -D --defined-only "$1/libasperity_c.so" | awk '{ print $3 }'
}

# The three files that ABAQUS compiles, each with its own routine and precision
one_files_in() { # build
   local file head
   for file in uinter vuinter vuinter_single; do
      head=$(head -n 1 "$1/asperity_$file.f90") || return
      echo "$file: $head"
      case $file in
         uinter) [[ $head == *': UINTER and '* ]] ;;
         vuinter) [[ $head == *': VUINTER and '* ]] ;;
         vuinter_single) [[ $head == *': VUINTER in single precision and '* ]] ;;
      esac || return
      grep -q "^ *subroutine ${file%_single}(" "$1/asperity_$file.f90" || return
   done
   grep -q "= real64" "$1/asperity_vuinter.f90" \
      && diff <(tail -n +2 "$1/asperity_vuinter.f90" | sed s/real64/real32/g) \
         <(tail -n +2 "$1/asperity_vuinter_single.f90" | sed s/real64/real32/g)
}

one_files() { # build
   configure "$root" "$1" -DASPERITY_BUILD_C=OFF \
      && cmake_within 60 --build "$1" --target uinter_file && one_files_in "$1"
}

# The C library from a copy of the project in a folder, by some generator
c_library() { # folder generator
   copy_to "$1" && configure "$1" "$1/build" -G "$2" \
      && cmake_within 240 --build "$1/build" -j 2 && one_files_in "$1/build" \
      && symbols "$1/build" >"$work/symbols" && grep -qx asperity_law_new "$work/symbols" \
      && ! grep -v '^asperity_' "$work/symbols"
}

# The same within another project
inside_another() { # folder generator
   copy_to "$1/asperity" || return
   printf '%s\n' 'cmake_minimum_required(VERSION 3.20)' 'project(other LANGUAGES Fortran)' \
      'add_subdirectory(asperity)' >"$1/CMakeLists.txt"
   configure "$1" "$1/build" -G "$2" -DASPERITY_BUILD_C=ON \
      && cmake_within 240 --build "$1/build" -j 2 --target asperity_c \
      && symbols "$1/build/asperity" >"$work/symbols" && ! grep -v '^asperity_' "$work/symbols"
}

# Configuration stops, and says why
refused() { # pattern option...
   rm -rf "$work/refused"
   ! configure "$root" "$work/refused" "${@:2}" >"$log.refused" 2>&1 || return 1
   cat "$log.refused"
   # CMake breaks lines
   tr -s '\n ' ' ' <"$log.refused" | grep -Eq -- "$1"
}

for name in vuinter_single my_single uinter vuinter 'a,b' 'a b' "it's" 'a+b(c' asperity_c_x; do
   check "one-file sources in a folder called $name" one_files "$work/files/$name/build $name"
done

check 'C library in .../src/asperity, Ninja' c_library "$work/src/asperity" Ninja
check 'C library in a folder with comma, make' c_library "$work/a,b" 'Unix Makefiles'
check 'C library in a folder with comma, blank, + and quote, Ninja' \
   c_library "$work/a,b c+d'e/uinter" Ninja
check 'C library inside another project in a folder with comma, Ninja' \
   inside_another "$work/other,1" Ninja
check 'C library inside another project in a folder with comma, make' \
   inside_another "$work/other,2" 'Unix Makefiles'

unsafe='asperity.s results would be wrong'
check '-Ofast' refused "CMAKE_Fortran_FLAGS .* has -Ofast.*$unsafe" -DCMAKE_Fortran_FLAGS='-g -Ofast'
check '-ffast-math' refused "has -ffast-math.*$unsafe" -DCMAKE_Fortran_FLAGS='-O3 -ffast-math -g'
check '-ffinite-math-only' refused "has -ffinite-math-only.*$unsafe" \
   -DCMAKE_Fortran_FLAGS=-ffinite-math-only
check '-fp-model fast' refused "has -fp-model fast=2.*$unsafe" \
   -DCMAKE_Fortran_FLAGS='-fp-model fast=2' -DCMAKE_Fortran_COMPILER_FORCED=ON
check 'flags of the type of build' refused "CMAKE_Fortran_FLAGS_RELEASE has -Ofast.*$unsafe" \
   -DCMAKE_BUILD_TYPE=Release -DCMAKE_Fortran_FLAGS_RELEASE=-Ofast
check 'flags of one of several types of build' \
   refused "CMAKE_Fortran_FLAGS_RELEASE has -ffast-math.*$unsafe" \
   -G 'Ninja Multi-Config' -DCMAKE_Fortran_FLAGS_RELEASE='-O2 -ffast-math'
export FFLAGS=-Ofast
check 'FFLAGS in the environment' refused "FFLAGS.* has -Ofast.*$unsafe"
unset FFLAGS
with_compiler() {
   local FC="${FC:-gfortran} -ffast-math"
   export FC
   refused "CMAKE_Fortran_COMPILER has -ffast-math.*$unsafe"
}
check 'a flag with the name of the compiler' with_compiler
options_around() {
   mkdir -p "$work/around"
   printf '%s\n' 'cmake_minimum_required(VERSION 3.20)' 'project(other LANGUAGES Fortran)' \
      'add_compile_options(-g -Ofast)' "add_subdirectory($root asperity)" \
      >"$work/around/CMakeLists.txt"
   ! configure "$work/around" "$work/around/build" >"$log.refused" 2>&1 || return 1
   cat "$log.refused"
   tr -s '\n ' ' ' <"$log.refused" | grep -Eq "add_compile_options .* has -Ofast.*$unsafe"
}
check 'options of the project around' options_around
check 'safe flags are taken, whatever their names resemble' configure "$root" "$work/safe" \
   -DCMAKE_Fortran_FLAGS="-O3 -ffp-contract=fast -fno-fast-math -I$work/-Ofast" \
   -DASPERITY_BUILD_C=OFF

# ./run and a build folder of another place or compiler, with a cmake that only says what it is asked
run_on_old_build() { # home compiler FC
   local cmake=$work/fake/cmake
   rm -rf "$work/run" "$work/fake" "$work/asked"
   mkdir -p "$work/run/build/CMakeFiles" "$work/fake" && cp "$root/run" "$work/run" || return
   printf 'CMAKE_HOME_DIRECTORY:INTERNAL=%s\nCMAKE_Fortran_COMPILER:FILEPATH=%s\n' "$1" "$2" \
      >"$work/run/build/CMakeCache.txt"
   printf '#!/bin/sh\necho "$@" >>"%s"\n' "$work/asked" >"$cmake"
   printf '#!/bin/sh\nexec gfortran "$@"\n' >"$work/fake/other-fortran"
   chmod +x "$work/fake/"*
   PATH=$work/fake:$PATH FC=$3 ASPERITY_NO_INSTALL=1 "$work/run/run" build
}
configures_anew() { # text home compiler FC
   run_on_old_build "${@:2}" >"$work/said" && cat "$work/said" && grep -F "$1: configuring anew" "$work/said" \
      && grep -F -- "-DCMAKE_Fortran_COMPILER=${4:-gfortran}" "$work/asked" \
      && [[ ! -d $work/run/build/CMakeFiles ]]
}
goes_on() { # home compiler FC
   run_on_old_build "$@" >"$work/said" && cat "$work/said" && ! grep 'anew' "$work/said" \
      && ! grep -e -DCMAKE_Fortran_COMPILER "$work/asked"
}
gfortran=$(command -v gfortran)
check './run on a moved build' configures_anew 'build/ was made for /elsewhere' /elsewhere "$gfortran" gfortran
check './run on a build of another compiler' configures_anew \
   "build/ was made with $gfortran, not with other-fortran" "$work/run" "$gfortran" other-fortran
check './run on a moved build of a compiler that is gone' configures_anew \
   'build/ was made for /elsewhere' /elsewhere /elsewhere/fortran ''
check './run on a build of its own' goes_on "$work/run" "$gfortran" gfortran
check './run without FC keeps the compiler of the build' goes_on "$work/run" "$work/fake/other-fortran" ''

# Without 32-bit libraries nothing can be linked, which CMake tries first
check '32 bits, configuration' refused 'needs a 64-bit system.* compiles for 32 bits' \
   -DCMAKE_Fortran_FLAGS=-m32 -DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY
compiles_for_32() {
   local fc=${FC:-gfortran}
   (cd "$work" && "$fc" -c "$root/src/base/kinds.f90") || return
   ! (cd "$work" && "$fc" -m32 -c "$root/src/base/kinds.f90") >"$log.32" 2>&1 || return 1
   grep -q asperity_needs_a_64_bit_system "$log.32"
}
check '32 bits, without CMake' compiles_for_32

echo "$passed passed, $failed failed"
((failed == 0))
