# What fails on one rank ends all of them, is named, and leaves nothing half-written
case=(--mesh-size 60 --contact rough --amplitudes 8,24,48)

# A rank that dies
for victim in 0 1; do
   rm -f solid.rough.checkpoint
   start_to_checkpoint 2 solid "${case[@]}" --csv bad.csv
   kill -KILL "$(cat "$work/process.$victim")"
   finish
   check "faults: rank $victim is killed: a status that is not zero" test "$status" -ne 0 -a ! -s out
   check 'faults: no process is left' none_is_left
   check 'faults: nothing half-written' sh -c 'test -s solid.rough.checkpoint && ! ls bad.csv *.part 2>/dev/null'
   ranks 2 solid "${case[@]}" --resume --csv resumed.csv
   check 'faults: the run goes on' is_quiet
   [ -e uncut.csv ] || run solid "${case[@]}" --csv uncut.csv
   check 'faults: to the same joint' same_history uncut.csv resumed.csv 1e-2
   rm -f resumed.csv
done
rm -f solid.rough.checkpoint

# Files that only one rank cannot have
cp "$(cd "$here/../.." && pwd)/examples/solid_joint/coarse.nml" case.nml
on_rank 1 'set -- solid nowhere.nml'
ranks 3 solid case.nml --csv bad.csv
check 'faults: a case that one rank cannot read' is_told_once 3 'rank 1: nowhere.nml: cannot be read: '
sed 's/mesh_size = .*/mesh_size = 80.0/' case.nml >other.nml
on_rank 1 'set -- solid other.nml'
ranks 2 solid case.nml --csv bad.csv
check 'faults: a case that is another one for a rank' is_told_once 2 'rank 1: its case is not that of rank 0'
on_rank 1 'export ASPERITY_PETSC=/nowhere/libpetsc.so'
ranks 2 solid "${case[@]}" --csv bad.csv
check 'faults: a rank without PETSc' is_told_once 2 'rank 1: environment variable ASPERITY_PETSC = /nowhere/libpetsc.so'
on_rank 1 'set -- --colour'
ranks 2 solid "${case[@]}" --csv bad.csv
check 'faults: options that only one rank has' is_told_once 2 'rank 1: '
on_all_ranks
check 'faults: nothing is written' sh -c '! ls bad.csv *.checkpoint *.part 2>/dev/null'

# A disk that is full: results, then the checkpoint of the second stroke or so
ranks 2 solid "${case[@]:0:4}" --amplitudes 8 --csv /dev/full --json bad.json
check 'faults: no room for results' sh -c "test $status -eq 3 && grep -q \
   '^asperity: error: --csv: /dev/full cannot be written: No space left' err && test \$(wc -l <err) -eq 1"
check 'faults: the checkpoint stays' sh -c 'test -s solid.rough.checkpoint && ! ls *.part 2>/dev/null'
check 'faults: no process is left' none_is_left
rm -f solid.rough.checkpoint bad.json
# files are limited for rank 0 to a little more than its first checkpoint; messages then go without shared
# memory
start_to_checkpoint 1 solid "${case[@]}" --csv bad.csv
kill -KILL "$(cat "$work/process.0")"
finish
on_rank 0 "trap '' XFSZ; ulimit -f $(($(wc -c <solid.rough.checkpoint)/1024 + 8))"
rm -f solid.rough.checkpoint
OMPI_MCA_btl=self,tcp ranks 2 solid "${case[@]}" --csv bad.csv
on_all_ranks
check 'faults: no room for a checkpoint' is_told_once 3 'checkpoint solid.rough.checkpoint cannot be written: '
check 'faults: the one before stays' test -s solid.rough.checkpoint
ranks 2 solid "${case[@]}" --resume --csv resumed.csv
check 'faults: the run goes on from it' same_history uncut.csv resumed.csv 1e-2
rm -f resumed.csv

# No equilibrium, in too few iterations, where a point of the rough law moves most: it is one rank's
few=(--mesh-size 60 --contact rough --amplitudes 8 --side-pressure 0 --column-load 0 --most-iterations 4
   --tolerance 1e-8 --forcing 0.5)
run solid "${few[@]}"
cp err alone
cut -d, -f1-3 failed_point.csv >alone.csv
for n in 2 3; do
   rm -f solid.rough.checkpoint failed_point.*
   ranks $n solid "${few[@]}" --csv bad.csv
   check "faults: no equilibrium on $n ranks" is_told_once 1 'no increment is small enough in stroke 1 .*; '\
'asperity replay failed_point.nml replays the motion of the point of the upper faces .*--resume$'
   check 'faults: told as by one rank' cmp err alone
   run replay failed_point.nml --csv point.csv
   check 'faults: the motion of its point is replayed' is_quiet
   check 'faults: as it was' sh -c 'cut -d, -f1-4 point.csv | cmp - failed_point.csv'
   cut -d, -f1-3 failed_point.csv >motion.csv
   check 'faults: and as one rank finds it' same_history alone.csv motion.csv 1e-6
done
rm -f solid.rough.checkpoint failed_point.*

# Ranks that MPI does not join
OMPI_COMM_WORLD_RANK=0 OMPI_COMM_WORLD_SIZE=2 run solid "${case[@]}"
check 'faults: ranks that do not know each other' is_refused 2 \
   'the launcher has started rank 0 of 2, which is 0 of 1 for MPI: '
check 'faults: and nothing is written' sh -c '! ls bad.csv *.checkpoint *.part failed_point.* 2>/dev/null'
