# One rank of all prints, writes and tells errors
one=(--mesh-size 100 --contact rough --amplitudes 8)
run solid "${one[@]}" --csv alone.csv
cp out alone
ranks 2 solid "${one[@]}" --csv s.csv --json s.json
check 'output: two ranks' is_quiet
check 'output: tables once' test "$(grep -c '^asperity ' out)" -eq 1 -a "$(wc -l <out)" -eq "$(wc -l <alone)"
check 'output: nothing stays but what was asked for' test "$(echo *)" = 'all_err alone alone.csv check.log err out s.csv s.json'
check 'output: CSV and JSON are the same' same_csv_and_json s.csv s.json
check 'output: numbers in full' sh -c '! grep -E "[Nn]a[Nn]|[Ii]nf" s.csv s.json'
check 'output: the same increments' test "$(csv_column alone.csv displacement)" = "$(csv_column s.csv displacement)"
check 'output: no process is left' none_is_left
mkdir alone.vtk ranks.vtk
run solid "${one[@]}" --vtk alone.vtk
ranks 2 solid "${one[@]}" --vtk ranks.vtk
check 'output: files for ParaView' test "$(cd alone.vtk && echo *)" = "$(cd ranks.vtk && echo *)"
check 'output: of the same length' sh -c 'for file in alone.vtk/*; do
   [ "$(wc -c <"$file")" -eq "$(wc -c <"ranks.vtk/${file##*/}")" ] || { echo "$file"; exit 1; }; done'
if command -v gnuplot >/dev/null; then
   ranks 2 solid "${one[@]}" --report s.html --plot s.svg
   check 'output: page and picture' sh -c 'test -s s.html -a -s s.svg'
else
   skip 'output: page and picture' 'there is no gnuplot'
fi
if command -v script >/dev/null; then
   # two seconds on any machine, so that progress is shown
   limited script -qec "mpirun -q -n 2 '$program' solid --mesh-size 60 --amplitudes 8,24" terminal >/dev/null 2>&1 </dev/null
   check 'output: progress on a terminal, of the run and its end' sh -c \
      'grep -q "solid: hard contact, stroke [0-9]* of [0-9]*, [0-9]* %" terminal && grep -q "increments, .* iterations, " terminal'
   check 'output: once' test "$(tr '\r' '\n' <terminal | grep -c 'hard contact: .* increments, .* iterations')" -eq 1
else
   skip 'output: progress' 'there is no script'
fi

# Borders between ranks do not spoil multigrid
by_multigrid=(--mesh-size 60 --contact rough --amplitudes 8 --preconditioner multigrid)
run solid "${by_multigrid[@]}" --json alone.json
ranks 8 solid "${by_multigrid[@]}" --json ranks.json
check 'output: no more than twice as many vectors on eight ranks' python3 -c "
import json
alone, ranks = (json.load(open(f'{name}.json'))['times']['vectors'][0] for name in ('alone', 'ranks'))
print(alone, ranks)
assert 0 < ranks <= 2*alone"

# Wrong input is told once, wherever it is found
tells() { # NAME STATUS PATTERN ARGUMENT...
   local name=$1 expected=$2 pattern=$3
   shift 3
   ranks 2 "$@"
   check "output: $name" is_told_once "$expected" "$pattern"
}
tells 'no such command' 2 'unknown command' sold
tells 'no such option' 2 '--mesh: ' solid --mesh 3
tells 'no number' 2 '--mesh-size: ' solid --mesh-size x
tells 'no case file' 3 'nowhere.nml: cannot be read: ' solid nowhere.nml
printf '&asperity\n mesh_size = 60\n mesh_length = 3\n/\n' >case.nml
tells 'no such key' 2 'case.nml:3: ' solid case.nml
tells 'what the case says' 2 '--amplitudes: nothing touches' solid --mesh-size 100 --amplitudes 0.5 --side-pressure 0
tells 'a mesh too coarse' 2 '--mesh-size: mesh_size = 400.* is larger than the part' solid --mesh-size 400 --accept-sizes
tells 'no folder for results' 3 '--csv: nowhere/s.csv cannot be written: ' solid "${one[@]}" --csv nowhere/s.csv
tells 'no folder for checkpoints' 3 '--checkpoint: nowhere/j.rough.checkpoint cannot be written: ' \
   solid "${one[@]}" --checkpoint nowhere/j
tells 'nothing to go on from' 2 '--resume: there is no solid.rough.checkpoint' solid "${one[@]}" --resume
tells 'no equilibrium at rest' 1 'the joint at rest has no equilibrium' \
   solid --mesh-size 100 --contact hard --penalty 1e12 --amplitudes 8

# Commands whose work is not shared
run tenon --amplitudes 8 --csv alone.csv
cp out alone
ranks 3 tenon --amplitudes 8 --csv t.csv
check 'output: another command runs on one rank' sh -c 'cmp out alone && cmp t.csv alone.csv'
check 'output: and says so' test "$status $(cat err)" = '0 asperity: warning: asperity tenon runs on one rank, not on 3'
for words in 'version' 'help solid' 'solid --print-case'; do
   # shellcheck disable=SC2086  # several words are meant
   run $words
   cp out alone
   # shellcheck disable=SC2086
   ranks 2 $words
   check "output: $words once" sh -c "test $status -eq 0 && cmp out alone && ! test -s err"
done
