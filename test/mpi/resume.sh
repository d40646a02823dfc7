# A run goes on from its checkpoint on any number of ranks
case=(--mesh-size 60 --contact rough --amplitudes 8,16 --tolerance 1e-11 --forcing 1e-12)
run solid "${case[@]}" --csv uncut.csv
# leave_checkpoint N: what N ranks leave that are killed after a stroke
leave_checkpoint() {
   start_to_checkpoint "$1" solid "${case[@]}" --csv cut.csv
   kill -KILL "$(cat "$work/process.0")" 2>/dev/null
   finish
}
for pair in '1 2' '2 1' '2 3'; do
   leave_checkpoint "${pair% *}"
   if [ ! -e solid.rough.checkpoint ]; then
      skip "resume: ${pair/ / ranks, then }" 'the run was over before it could be killed'
      continue
   fi
   ranks "${pair#* }" solid "${case[@]}" --resume --csv resumed.csv
   check "resume: ${pair/ / ranks, then }" is_quiet
   check 'resume: to the same joint' same_history uncut.csv resumed.csv 1e-8
   check 'resume: and its checkpoint is gone' absent solid.rough.checkpoint
   rm -f ./*.checkpoint resumed.csv cut.csv
done

# What cannot be gone on from, told once
leave_checkpoint 2
cp solid.rough.checkpoint kept
ranks 2 solid --mesh-size 100 "${case[@]:2}" --resume --csv bad.csv
check 'resume: a checkpoint of another mesh' is_told_once 2 \
   'checkpoint solid.rough.checkpoint is of another case or version: run that one, or remove the file'
ranks 2 solid "${case[@]}" --csv bad.csv
check 'resume: one that is there is not written over' is_told_once 2 'solid.rough.checkpoint is there, '
head -c 9000 kept >solid.rough.checkpoint
ranks 2 solid "${case[@]}" --resume --csv bad.csv
check 'resume: a piece of one' is_told_once 3 'checkpoint solid.rough.checkpoint cannot be read: it is not complete'
cp kept solid.rough.checkpoint
on_rank 1 'cd /'
ranks 2 solid "${case[@]}" --resume --csv bad.csv
check 'resume: one that only a rank cannot read' is_told_once 2 '--resume: rank 1: there is no solid.rough.checkpoint: '
on_all_ranks
check 'resume: nothing is written' sh -c 'cmp kept solid.rough.checkpoint && ! test -e bad.csv'
