# What the tests of several ranks share, besides test/program/harness.sh

# More ranks than cores, each of one thread; a rank that waits lets others work. Root may start them, who is
# alone in containers
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_mpi_yield_when_idle=1 \
   OPENBLAS_NUM_THREADS=1
[ "$(id -u)" -ne 0 ] || export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

# A rank begins here: its process is noted, and the file `rank` may change what it does
cat >"$work/start" <<'START'
#!/bin/bash
rank=$OMPI_COMM_WORLD_RANK
echo $$ >"$work/process.$rank"
[ ! -e "$work/rank" ] || . "$work/rank"
exec "$program" "$@"
START
chmod +x "$work/start"
export work program

# start N ARGUMENT...: begin N ranks in the background; `launcher` is the process of mpirun
start() {
   local n=$1
   shift
   rm -f "$work"/process.*
   mpirun -q -n "$n" "$work/start" "$@" >out 2>all_err </dev/null &
   launcher=$!
}

# start_to_checkpoint N ARGUMENT...: begin N ranks, and wait for their first checkpoint
start_to_checkpoint() {
   start "$@"
   while ! compgen -G '*.checkpoint' >/dev/null && kill -0 "$launcher" 2>/dev/null; do sleep 0.02; done
}

# finish: wait for them; leaves files out and err, and status
finish() {
   wait "$launcher"
   status=$?
   own_words all_err >err
}

# ranks N ARGUMENT...: run N ranks to their end
ranks() {
   local n=$1
   shift
   rm -f "$work"/process.*
   limited mpirun -q -n "$n" "$work/start" "$@" >out 2>all_err </dev/null
   status=$?
   own_words all_err >err
}

# on_rank N COMMAND: what that rank does before it begins; on_all_ranks: nothing any more
on_rank() { printf '[ "$rank" -ne %d ] || %s\n' "$1" "$2" >"$work/rank"; }
on_all_ranks() { rm -f "$work/rank"; }

# No process of the last ranks is left. A rank that was killed may be gone a moment later
none_is_left() {
   local process tries
   for process in $(cat "$work"/process.*); do
      for tries in $(seq 50); do
         kill -0 "$process" 2>/dev/null || break
         sleep 0.1
      done
      ! kill -0 "$process" 2>/dev/null || { echo "process $process is left"; return 1; }
   done
}

# The ranks ended with a status and one line that matches a pattern, wrote nothing else, and left neither
# a process nor a temporary file
is_told_once() { is_refused "$@" && none_is_left; }

# same_history FILE FILE TOLERANCE: every number of every increment, but for a share of the largest of its
# column and kind
same_history() {
   python3 - "$@" <<'COMPARE'
import csv, sys
one, other = (list(csv.DictReader(open(path))) for path in sys.argv[1:3])
tolerance = float(sys.argv[3])
if not one or len(one) != len(other):
    sys.exit(f"{len(one)} and {len(other)} increments")
failed = 0
for name in one[0]:
    if name.startswith(("model", "validity", "iterations", "yielding", "energy_balance")):
        continue
    pairs = [(float(a[name]), float(b[name])) for a, b in zip(one, other)]
    scale = max(max(abs(a), abs(b)) for a, b in pairs)
    far = max(abs(a - b) for a, b in pairs)
    print(f"{name}: {far/scale if scale > 0 else 0:.2g}")
    failed += far > tolerance*scale
sys.exit(failed)
COMPARE
}
