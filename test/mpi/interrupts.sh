# Ctrl-C at mpirun, which is a signal to it alone, and what batch systems send
case=(--mesh-size 60 --contact rough --amplitudes 8,24,48)
run solid "${case[@]}" --csv uncut.csv
for signal in INT TERM; do
   start_to_checkpoint 2 solid "${case[@]}" --csv bad.csv
   kill -$signal "$launcher"
   finish
   check "interrupts: $signal ends all" test "$status" -ne 0
   check 'interrupts: no process is left' none_is_left
   check 'interrupts: nothing is told or written' sh -c 'test ! -s out && ! grep -q asperity: err && ! ls bad.csv *.part 2>/dev/null'
   ranks 2 solid "${case[@]}" --resume --csv resumed.csv
   check 'interrupts: the run goes on' is_quiet
   check 'interrupts: to the same joint' same_history uncut.csv resumed.csv 1e-2
   check 'interrupts: and its checkpoint is gone' absent solid.rough.checkpoint
   rm -f resumed.csv solid.rough.checkpoint
done

# While checkpoints are written one after the other, at any moment: no part of one is left
short=(--mesh-size 60 --contact hard --amplitudes "$(seq -s , 4 0.5 12)" --stroke-increments 1)
clean=0
for tenth in $(seq 10 2 24); do
   start 2 solid "${short[@]}" --csv bad.csv
   sleep "$((tenth/10)).$((tenth % 10))"
   kill -INT "$launcher" 2>/dev/null
   finish
   if none_is_left && ! ls ./*.part 2>/dev/null; then ((clean += 1)); else echo "interrupted after $tenth tenths of a second"; fi
   rm -f solid.hard.checkpoint bad.csv
done
check 'interrupts: at any moment, no process and no part of a file is left' test "$clean" -eq 8
