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
   mkdir -p "$1" && cp -r "$root"/{CMakeLists.txt,LICENSE,CITATION.cff,cmake,docs,interface,src} "$1"
}

symbols() { # build: what libasperity_c.so offers
   nm -D --defined-only "$1/libasperity_c.so" | awk '{ print $3 }'
}

# What ABAQUS needs in a folder, each file with its own routine and precision
abaqus_files_in() { # folder
   local file routine
   for file in uinter vuinter vuinter_single; do
      routine=${file%_single}
      [[ $(head -n 1 "$1/asperity_$file.f90") == "! asperity "*": ${routine^^} for ABAQUS/"* ]] \
         && grep -q "^ *subroutine $routine(" "$1/asperity_$file.f90" \
         && diff "$1/asperity_$file".f{or,} \
         && diff <(echo '!DIR$ FREEFORM' && cat "$1/asperity_$file.f90") "$1/asperity_$file.f" || return
   done
   grep -q "= real64" "$1/asperity_vuinter.f90" \
      && diff <(tail -n +2 "$1/asperity_vuinter.f90" | sed s/real64/real32/g) \
         <(tail -n +2 "$1/asperity_vuinter_single.f90" | sed s/real64/real32/g) \
      && diff -r "$root/interface/abaqus/ready" "$1"
}

abaqus_files() { # build
   configure "$root" "$1" -DASPERITY_BUILD_C=OFF \
      && cmake_within 60 --build "$1" --target abaqus_files && abaqus_files_in "$1/abaqus"
}

# By the script alone, called from elsewhere, with no compiler on PATH; a folder that is given, and one
# that is not
abaqus_script() { # folder
   copy_to "$1" && mkdir -p "$1/elsewhere" "$work/cmake_alone" \
      && ln -sf "$(command -v cmake)" "$work/cmake_alone" || return
   (cd "$1/elsewhere" && PATH=$work/cmake_alone cmake -P ../cmake/abaqus.cmake) \
      && abaqus_files_in "$1/elsewhere/build/abaqus" \
      && (cd "$1/elsewhere" && cmake -D "output=a folder" -P "$1/cmake/abaqus.cmake") \
      && abaqus_files_in "$1/elsewhere/a folder"
}

abaqus_script_refuses() { # pattern copy option...
   ! (cd "$work" && cmake "${@:3}" -P "$2/cmake/abaqus.cmake") >"$log.refused" 2>&1 || return 1
   cat "$log.refused"
   tr -s '\n ' ' ' <"$log.refused" | grep -Eq -- "$1"
}

# The C library from a copy of the project in a folder, by some generator
c_library() { # folder generator
   copy_to "$1" && configure "$1" "$1/build" -G "$2" \
      && cmake_within 240 --build "$1/build" -j 2 && abaqus_files_in "$1/build/abaqus" \
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
   check "files for ABAQUS in a folder called $name" abaqus_files "$work/files/$name/build $name"
   check "files for ABAQUS by the script in a folder called $name" abaqus_script "$work/script/$name"
done
copy=$work/script/uinter
touch "$work/taken"
check 'files for ABAQUS where a file is' abaqus_script_refuses \
   'output = .*/taken is a file: give a folder' "$copy" -D output=taken
rm -r "$copy/src/paper"
check 'files for ABAQUS without a module' abaqus_script_refuses \
   'uses asperity_paper_[a-z]*, which is in none of the folders' "$copy"
sed -i '/head: statev/d' "$copy/docs/abaqus.md"
cp -r "$root/src/paper" "$copy/src"
check 'files for ABAQUS without a part of the page' abaqus_script_refuses \
   "docs/abaqus.md has no part 'statev'" "$copy"
rm -r "$copy/src" "$copy/interface/abaqus/routines"
check 'files for ABAQUS without the project' abaqus_script_refuses \
   'works in the project.s own folder, not alone' "$copy"

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
