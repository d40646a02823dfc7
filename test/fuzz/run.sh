#!/usr/bin/env bash
# Builds the fuzzing of the readers of height maps with checks of addresses, leaks and undefined
# behaviour, and runs it:
#   test/fuzz/run.sh [files for each reader, 100000 if not given [seed]]
# The last line is `N passed, N failed`, one for each reader.
set -u -o pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1
build=build/fuzz
count=${1:-100000}
seed=${2:-20240611}
cmake -S . -B $build -G Ninja -DCMAKE_BUILD_TYPE=None -DASPERITY_BUILD_FUZZ=ON \
   -DASPERITY_BUILD_C=OFF -DBUILD_TESTING=OFF >/dev/null \
   && cmake --build $build --target asperity_fuzz >/dev/null
if (($? != 0)); then
   echo 'the fuzzing cannot be built: cmake --build build/fuzz --target asperity_fuzz shows why'
   echo '0 passed, 1 failed'
   exit 1
fi
# No more than 512 MiB at once, and no more than 2 GiB in all
export ASAN_OPTIONS=detect_leaks=1:max_allocation_size_mb=512:allocator_may_return_null=0:hard_rss_limit_mb=2048
export UBSAN_OPTIONS=print_stacktrace=1
log=$build/fuzz.log
if $build/asperity_fuzz "$count" "$seed" 2>&1 | tee "$log"; then
   exit 0
fi
# A fault that the checks found ends the program before its last line
tail -n 1 "$log" | grep -qE '^[0-9]+ passed, [0-9]+ failed$' || echo '0 passed, 1 failed'
exit 1
