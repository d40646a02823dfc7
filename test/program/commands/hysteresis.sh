# asperity hysteresis: post-processing of a record

# plastic [STEP]: displacement and force of an elastic and perfectly plastic spring, stiffness 8,
# yield at 0.5, to 0.5 and 1 once and to 2 twice, on both sides
plastic() {
   awk -v step="${1:-0.125}" '
      function go(to) { while (x != to) { x += x < to ? step : -step; move() } }
      function move() { f += 8*(x - was); f = f > 4 ? 4 : f < -4 ? -4 : f; was = x; print x "," f }
      BEGIN { x = was = f = 0; move(); go(0.5); go(-0.5); go(1); go(-1); go(2); go(-2); go(2); go(-2); go(0) }'
}
{ echo 'displacement,force'; plastic; } >h.csv

run hysteresis h.csv --csv c.csv --json c.json
check 'hysteresis' is_quiet
check 'hysteresis: what the record is, on the screen' has out 'Record: cyclic'
check 'hysteresis: and in JSON' has c.json '"record_kind": "cyclic",'
header=cycle,closed,positive_displacement,positive_force,negative_displacement,negative_force,\
skeleton,secant_stiffness,mean_secant_stiffness,stiffness_ratio,energy,cumulative_energy,loop_area,\
damping,positive_energy,positive_damping,negative_energy,negative_damping,pinching,fullness,first_sample,last_sample
check 'hysteresis: columns' test "$(columns c.csv)" = "$header"
check 'hysteresis: four cycles' test "$(rows c.csv)" -eq 4
check 'hysteresis: 17 figures, counts as they are' sh -c \
   '! tail -n +2 c.csv | tr , "\n" | grep -Ev "^(-?[0-9]\.[0-9]{16}E[+-][0-9]{3}|[a-z]+|[0-9]+)$"'
check 'hysteresis: JSON holds the same figures' same_csv_and_json c.csv c.json
check 'hysteresis: closed loop of a = 2: area 4 Fy (a - dy), damping 2/pi (1 - dy/a)' csv c.csv '
   if (NR == 5) {
      if (far(c["energy"], 4*4*1.5, 1e-14) || far(c["loop_area"], 24, 1e-14)) fail("area")
      if (far(c["damping"], 2/3.14159265358979323846*0.75, 1e-14)) fail("damping")
      if (far(c["pinching"], 1, 1e-14) || far(c["fullness"], 0.75, 1e-14)) fail("shape") }'
check 'hysteresis: secant stiffness and degradation' csv c.csv '
   a = c["positive_displacement"]; k = 8 < 4/a ? 8 : 4/a
   if (far(c["secant_stiffness"], k, 1e-14) || far(c["stiffness_ratio"], k/8, 1e-14)) fail(k)
   if (c["negative_displacement"] + a != 0 || c["negative_force"] + c["positive_force"] != 0) fail("sides")'
check 'hysteresis: energy adds up' csv c.csv '
   if (NR > 2 && far(c["cumulative_energy"], before["cumulative_energy"] + c["energy"], 1e-14)) fail("sum")'
check 'hysteresis: skeleton is the first cycle of each amplitude' \
   test "$(csv_column c.csv skeleton | tr '\n' ' ')" = 'both both both none '
hysteresis_summary() { sed -n '/^"summary"/,/^}/p' c.json | sed -n "s/^\"$1\": \[\(.*\)\].*/\1/p"; }
check 'hysteresis: equal energy finds yield and stiffness' awk -v f="$(hysteresis_summary yield_force)" \
   -v x="$(hysteresis_summary yield_displacement)" -v k="$(hysteresis_summary elastic_stiffness)" '
   function off(a, b) { a = a/b - 1; return a > 1e-12 || a < -1e-12 }
   BEGIN { split(f, F, ","); split(x, X, ","); split(k, K, ",")
      exit off(F[1], 4) || off(F[2], -4) || off(X[1], 0.5) || off(X[2], -0.5) || off(K[1], 8) || off(K[2], 8) }'
check 'hysteresis: JSON is JSON' sh -c 'command -v python3 >/dev/null || exit 0; python3 -m json.tool c.json'
check 'hysteresis: JSON has the points of the skeleton' has c.json \
   '"displacement": [1.2500000000000000E-001, 2.5000000000000000E-001, 3.7500000000000000E-001, '
run hysteresis h.csv --peaks displacement --json c2.json
check 'hysteresis: of the tips, if so wished' has c2.json \
   '"displacement": [5.0000000000000000E-001, 1.0000000000000000E+000, 2.0000000000000000E+000, -5.0'
check 'hysteresis: the table is printed' sh -c 'grep -Eq "^ +4 +yes +2.0 +4.0 +-2.0 +-4.0 +2.0 " out'
check 'hysteresis: the threshold is said' has out '1/400 of the range'

# The same record in other clothes gives the same cycles, but for the lines they come from
same_cycles() { cut -d, -f1-20 c2.csv | tail -n +2 | cmp - plain.csv; }
cut -d, -f1-20 c.csv | tail -n +2 >plain.csv
same() { # name file options...
   local name=$1 file=$2
   shift 2
   run hysteresis "$file" --csv c2.csv "$@"
   check "hysteresis: $name" is_quiet
   check "hysteresis: $name, same cycles" same_cycles
}
plastic >bare.csv
same 'no column names' bare.csv
same 'no last line break' <(printf '%s' "$(cat h.csv)")
{ printf '\357\273\277'; sed 's/$/\r/' h.csv; } >crlf.csv
same 'byte order mark and CRLF' crlf.csv
tr ',' '\t' <h.csv >tab.csv
same 'tabs' tab.csv
sed 's/,/   /; s/^/  /' h.csv >blank.txt
same 'blanks' blank.txt
tr ',.' ';,' <h.csv >comma.csv
same 'semicolons and decimal commas' comma.csv --decimal comma
{ echo 'logger 7'; echo; echo '# made by hand'; sed 's/^/"a;b";/; s/,/;/; s/displacement/"Stroke, north (mm)"/; s/force/Load [kN]/' h.csv; } >log.csv
same 'columns by name, in any case' log.csv --skip-lines 1 --displacement-column 'stroke, north' \
   --force-column LOAD --separator semicolon
check 'hysteresis: units of the file' grep -Eq 'force_unit +kN +column 3' out
check 'hysteresis: units of what follows' grep -q 'kN/mm .*kN mm' out
same 'columns by number' log.csv --skip-lines 1 --displacement-column 2 --force-column 3
{ echo 'x;y'; echo 'in;[lbf]'; plastic | tr ',' ';'; } >units.csv
same 'a line of units' units.csv
check 'hysteresis: units of a line of their own' grep -Eq 'lbf/in' out
awk -F, '{ print $2*-2 + 7 "," $1*0.5 - 3 }' bare.csv >raw.csv
same 'zero, factor, exchanged columns' raw.csv --displacement-column 2 --force-column=1 \
   --displacement-zero -3 --displacement-factor 2 --force-zero 7 --force-factor -0.5
awk '{ print; print }' bare.csv >twice.csv
same 'every sample twice' twice.csv
run hysteresis --record-file=h.csv --csv -
mv out c2.csv
check 'hysteresis: the record as an option, CSV on standard output' same_cycles

run hysteresis bare.csv --quantity moment --csv c2.csv
check 'hysteresis: moment against rotation' has c2.csv 'positive_rotation (rad),positive_moment ('
check 'hysteresis: its units' grep -Eq 'kN m/rad' out
run hysteresis bare.csv --quantity moment --displacement-unit deg --force-unit 'kN m' --json -
check 'hysteresis: units as given' has out '"energy": "kN m deg"'

# Other records
plastic | head -n 20 >open.csv
run hysteresis open.csv --csv c2.csv
check 'hysteresis: an open cycle is said to be so' has out 'Not closed, so energy is the work done'
check 'hysteresis: and has no damping' csv c2.csv \
   'if (NR == 3 && (c["closed"] != "no" || c["damping"] != "")) fail(c["damping"])'
run hysteresis open.csv --json -
check 'hysteresis: what has no value is null' has out 'null'
check 'hysteresis: a warning beside JSON' has err 'asperity: warning: Not closed'
plastic | head -n 5 >push.csv
run hysteresis push.csv
check 'hysteresis: one push is monotonic' has out 'Record: monotonic'
check 'hysteresis: and need not be closed' lacks out 'Not closed'
printf '0 0\n2 1\n3 10\n4 10\n' >hollow.csv
run hysteresis hollow.csv
check 'hysteresis: yield that is assumed is said to be' has out \
   'The positive skeleton is too hollow for a yield point of equal energy: 0.85'
# a pause of the test makes no cycle, a return does, unless the threshold is larger
printf '0 0\n1 8\n0.9 7\n2 9\n-2 -9\n0 0\n' >pause.csv
run hysteresis pause.csv --csv c2.csv
check 'hysteresis: a pause is no cycle' test "$(rows c2.csv)" -eq 1
printf '0 0\n1 8\n0.1 0\n2 9\n-2 -9\n0 0\n' >return.csv
run hysteresis return.csv --csv c2.csv
check 'hysteresis: a return is one' test "$(rows c2.csv)" -eq 2
run hysteresis return.csv --threshold 0.9 --csv c2.csv
check 'hysteresis: unless below the threshold' test "$(rows c2.csv)" -eq 1
check 'hysteresis: the threshold given' grep -Eq 'threshold +0.9 +--threshold' out
# the program's own files
run shear --displacement 2,-2,0 --normal-stress 0.1 --no-shrinking-overlap --csv s.csv
run hysteresis s.csv --displacement-column displacement --force-column shear_force --csv c2.csv
check 'hysteresis: of a shear box, friction pinches nothing' csv c2.csv \
   'if (far(c["pinching"], 1, 1e-9)) fail(c["pinching"])'

check 'hysteresis: one amplitude makes no skeleton to speak of' has out \
   'The negative skeleton is a straight line, having one amplitude'

check 'hysteresis: force that the other side has left' has out 'The negative side begins with -'

# a joint whose moment falls within its last cycle: the tenon's skeleton goes through tips
run tenon --amplitudes 8,150 --length 80 --cycles 1,1 --side-pressure 0.2 --accept-sizes
check 'tenon: more moment than the tips of cycles' grep -Eq \
   'hard contact: the replay has 2.6471 kN m, 6.[0-9]+ % more than its skeleton' out

# noise does not change the cycles; printed seed
seed=20260402
echo "     seed $seed"
plastic 0.015625 | awk -F, -v seed=$seed 'BEGIN { srand(seed) }
   { printf "%.9g,%.9g\n", $1 + 0.006*(rand() - 0.5), $2 + 0.04*(rand() - 0.5) }' >noisy.csv
run hysteresis noisy.csv --csv c2.csv
check 'hysteresis: four noisy cycles' test "$(rows c2.csv)" -eq 4
check 'hysteresis: their damping within 2 %' csv c2.csv '
   if (NR == 5 && far(c["damping"], 2/3.14159265358979323846*0.75, 0.02)) fail(c["damping"])'

# and where it is above 1/400 of the range it makes the threshold
plastic 0.015625 | awk -F, -v seed=$seed 'BEGIN { srand(seed) }
   { printf "%.9g,%.9g\n", $1 + 0.06*(rand() - 0.5), $2 + 0.04*(rand() - 0.5) }' >noisy.csv
run hysteresis noisy.csv --csv c2.csv
check 'hysteresis: four cycles in more noise' test "$(rows c2.csv)" -eq 4
check 'hysteresis: which makes the threshold' grep -Eq 'threshold +0.1[0-9.]* +noise of displacement' out

# Records of test/data/records, whose numbers are in its README
records=$root/test/data/records
# summary_of NAME: a column of the summary, the positive side first
summary_of() { sed -n '/^"summary"/,/^}/p' c2.json | sed -n "s/^\"$1\": \[\([^,]*\),.*/\1/p"; }
is_near() { awk -v a="$(summary_of "$1")" -v b="$2" -v t="$3" 'BEGIN { exit !(a != "" && a - b <= t && b - a <= t) }'; }
for name in en26891 en26891_without_unloading; do
   run hysteresis "$records/$name.csv" --json c2.json --csv c2.csv
   check "hysteresis: $name, largest force" is_near peak_force 12.398 1e-6
   check "hysteresis: $name, its displacement" is_near peak_displacement 11.988 1e-6
   check "hysteresis: $name, ultimate" is_near ultimate_displacement 12.04864 1e-5
   check "hysteresis: $name, ductility" is_near ductility 8.211282 1e-6
   check "hysteresis: $name, one cycle" test "$(rows c2.csv)" -eq 1
   sed -n '/^"summary"/,/^}/p' c2.json >$name.summary
done
check 'hysteresis: the unloading changes no number' cmp en26891.summary en26891_without_unloading.summary
run hysteresis "$records/en26891.csv" --json c2.json
check 'hysteresis: EN 26891 is told' has c2.json '"record_kind": "monotonic_with_unloading"'
for name in peak_inside spike gap; do
   run hysteresis "$records/$name.csv" --json c2.json
   check "hysteresis: $name, largest force" is_near peak_force 11.536 1e-6
   check "hysteresis: $name, its displacement" is_near peak_displacement 7.9664 1e-6
   check "hysteresis: $name, ultimate" is_near ultimate_displacement 9.218535 1e-6
   check "hysteresis: $name, cyclic" has c2.json '"record_kind": "cyclic"'
   check "hysteresis: $name, fullness above 1" has out 'Fullness above 1, a loop outside the rectangle of its peaks: cycle 9'
done
check 'hysteresis: a gap is said' has out 'Gaps in sampling, 1: a step of 3.8302 mm after sample 755'
run hysteresis "$records/spike.csv" --json c2.json
check 'hysteresis: an outlier is said' has out 'Outliers, 1: displacement 400.0 mm in sample 701,'
run hysteresis "$records/spike.csv" --outliers keep --json c2.json
check 'hysteresis: and kept, if so wished' is_near ultimate_displacement 400 0
check 'hysteresis: and still said' has out 'taken as measured'
run hysteresis "$records/peak_inside.csv" --peaks displacement
check 'hysteresis: more in the record than in the tips' has out \
   'The record has 11.536 kN, 15.0 % more (sample 1671, 7.9664 mm) than the positive skeleton'
run hysteresis "$records/peak_inside.csv" --peaks force
check 'hysteresis: peaks by force, no loop outside its rectangle' lacks out 'Fullness above 1'
run hysteresis "$records/offset.csv"
check 'hysteresis: a zero that is none' has out 'The record begins at 60.0 mm without force'
run hysteresis "$records/offset.csv" --displacement-zero 60 --json c2.json
check 'hysteresis: set as said, the same' is_near ultimate_displacement 9.2185 1e-3
awk -F, '{ print $1 "," $2 + 6 }' bare.csv >loaded.csv
run hysteresis loaded.csv
check 'hysteresis: a force that is not zeroed' has out 'The record begins with force 6.0 N at zero displacement'
printf '0,0\n10,1\n10.5,10\n14,10\n14.1,0\n' >late.csv
run hysteresis late.csv
check 'hysteresis: a ductility below 1' has out 'The positive ductility is below 1'
check 'hysteresis: of a hollow skeleton' has out 'The positive skeleton is too hollow'

# Pictures
if command -v gnuplot >/dev/null; then
   for file in h open push hollow; do
      run hysteresis $file.csv --plot $file.svg
      check "hysteresis: picture of $file" sh -c "tail -n 3 $file.svg | grep -q '^</svg>'"
   done
   cp h.csv "it's \`touch ran\` \$(touch ran).csv"
   run hysteresis "it's \`touch ran\` \$(touch ran).csv" --plot odd.svg --force-unit "'\`touch ran\`"
   check 'hysteresis: any name and unit in a picture' test "$status" -eq 0 -a -s odd.svg
   check 'hysteresis: which are never run' absent ran
else
   skip 'pictures of records' 'no gnuplot'
fi

# Bad input: the line and the column are named
bad_record() { # name pattern text options...
   local name=$1 pattern=$2
   printf "$3" >bad.csv
   shift 3
   refuses "hysteresis: $name" 2 "$pattern" hysteresis bad.csv --csv never.csv "$@"
}
bad_record 'text for a number' "bad.csv:3: force \(column 2\) = 'abc' is not a finite number" \
   'x,f\n0,0\n1,abc\n'
bad_record 'NaN' "bad.csv:4: displacement \(column 1\) = 'NaN' is not" '# x\nx,f\n0,0\nNaN,1\n'
bad_record 'infinity' "bad.csv:2: force \(column 2\) = '-inf' is not" '0,0\n1,-inf\n'
bad_record 'overflow' "bad.csv:2: force \(column 2\) = '1e999' is not" '0,0\n1,1e999\n'
bad_record 'number with a unit' "bad.csv:2: .*'1 kN' is not" '0,0\n1,1 kN\n'
bad_record 'empty field' 'bad.csv:3: force \(column 2\) is empty' 'x,f\n0,0\n1,\n2,1\n'
bad_record 'missing column' 'bad.csv:3: force \(column 2\) is missing: the line has 1 columns' \
   'x,f\n0,0\n1\n'
bad_record 'column that is not there' 'bad.csv:2: force \(column 7\) is missing: the line has 2' \
   'x,f\n0,0\n1,1\n' --force-column 7
bad_record 'unknown name' "--force-column: bad.csv: there is no column 'forse', did you mean force\?; its columns are 1 'x', 2 'force' in N" \
   'x,force (N)\n0,0\n1,1\n' --force-column forse
bad_record 'name twice' "--force-column: bad.csv: there is more than one column 'f'" 'x,f,F\n0,0,0\n' \
   --force-column f
bad_record 'the same column twice' 'bad.csv: displacement and force are both column 1' \
   'x,f\n0,0\n1,1\n2,2\n' --force-column x --displacement-column 1
bad_record 'decimal comma' "bad.csv:2: .*'1,5' is not .*; for decimal commas use --decimal comma" \
   '0;0\n1,5;1\n' --decimal point
bad_record 'thousands' "bad.csv:2: .*'1.000,5' is not a finite number$" '0;0\n1.000,5;1\n' \
   --decimal comma
bad_record 'text in the middle' 'bad.csv:3: displacement' '0,0\n1,1\nend,of\n'
bad_record 'empty' 'bad.csv: has no line of data' ''
bad_record 'only comments' 'bad.csv: has no line of data' '# x\n\n! y\n'
bad_record 'only names' 'bad.csv: has no line of numbers' 'x,f\nmm,kN\n'
bad_record 'all skipped' 'bad.csv: has no line of data' '0,0\n1,1\n' --skip-lines 9
bad_record 'too short' 'bad.csv: the record is too short: 2 samples' '0,0\n1,1\n'
bad_record 'constant' 'bad.csv: displacement is 1.0 in every sample' '1,0\n1,1\n1,2\n'
bad_record 'no force' 'bad.csv: force is zero in every sample' '0,0\n1,0\n2,0\n'
bad_record 'wrong sign' 'bad.csv: force points against the displacement' '0,0\n1,-1\n-1,1\n0,0\n'
bad_record 'too large' 'bad.csv: force = 1.0E200 in sample 2 is not' '0,0\n1,1e200\n2,3\n'
bad_record 'a large threshold' 'bad.csv: displacement changes by no more than 2.0' \
   '0,0\n1,1\n-1,-1\n0,0\n' --threshold 5
head -c 4096 "$program" >bad.csv
refuses 'hysteresis: a binary' 2 'bad.csv:' hysteresis bad.csv --csv never.csv
refuses 'hysteresis: no record' 2 'no record is given: asperity hysteresis FILE.csv' hysteresis
printf 'displacement (mm),force (kN)\n0,0\n1e-200,1\n0,0.5\n' >tiny.csv
refuses 'hysteresis: displacements of another unit' 2 'tiny.csv: displacement is below 1e-100' hysteresis tiny.csv
refuses 'hysteresis: the same record twice' 2 'h.csv: is given twice' hysteresis h.csv crlf.csv h.csv
refuses 'hysteresis: empty name' 2 'the name of the record is empty' hysteresis ''
refuses 'hysteresis: missing file' 3 'no.csv: cannot be read: No such file' hysteresis no.csv
refuses 'hysteresis: a folder' 3 '\.: cannot be read: Is a directory' hysteresis .
refuses 'hysteresis: the record as output' 2 '--csv: h.csv is the record, it would be lost' \
   hysteresis h.csv --csv h.csv
refuses 'hysteresis: negative threshold' 2 '--threshold: threshold = -1.0 is not allowed' \
   hysteresis h.csv --threshold -1
refuses 'hysteresis: amplitude tolerance' 2 '--amplitude-tolerance: amplitude_tolerance = 2.0 is' \
   hysteresis h.csv --amplitude-tolerance 2
refuses 'hysteresis: elastic fraction' 2 '--elastic-fraction: elastic_fraction = 1.0 is not' \
   hysteresis h.csv --elastic-fraction 1
refuses 'hysteresis: ultimate fraction' 2 '--ultimate-fraction: ultimate_fraction = 0.0 is not' \
   hysteresis h.csv --ultimate-fraction 0
refuses 'hysteresis: zero factor' 2 '--force-factor: force_factor = 0.0 is not allowed' \
   hysteresis h.csv --force-factor 0
refuses 'hysteresis: negative lines' 2 '--skip-lines: skip_lines = -1 is not allowed' \
   hysteresis h.csv --skip-lines -1
refuses 'hysteresis: unknown peaks' 2 "--peaks: peaks = 'x' is unknown; known: envelope, displacement" \
   hysteresis h.csv --peaks x
refuses 'hysteresis: unknown outliers' 2 "--outliers: outliers = 'x' is unknown; known: drop, keep" \
   hysteresis h.csv --outliers x
refuses 'hysteresis: unknown separator' 2 "--separator: .* is unknown; known: auto, comma" \
   hysteresis h.csv --separator pipe
refuses 'hysteresis: no case files' 2 '--print-case: is an option of curve' \
   hysteresis h.csv --print-case
check 'hysteresis: nothing was written' absent never.csv
