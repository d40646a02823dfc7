# Records as laboratories write them: columns by name and unit, decimal commas, several tests in one
# file, Latin-1, little memory. Inputs: test/data/records (README there), and some made here
records=$root/test/data/records
cp "$records"/*.csv .

# setting NAME: value and source of a setting in the listing on the screen
setting() { sed -n "s/^  $1  *//p" out | tr -s ' '; }
# reaches FILE COLUMN VALUE TOLERANCE: that is the largest value of the column
reaches() { near_to "$(csv_column "$1" "$2" | sort -g | tail -n 1)" "$3" "$4"; }
# work FILE X F: work of a comma-separated file with one line of names, by columns X and F
work() {
   awk -F, -v i="$2" -v j="$3" 'NR > 2 { w += ($j + f)*($i - x)/2 } NR > 1 { x = $i; f = $j }
      END { printf "%.17g", w }' "$1"
}
last_energy() { csv_column "$1" cumulative_energy | tail -n 1; }
near_to() { awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { print a, b; d = a/b - 1; exit !(d*d <= t*t) }'; }

# Columns by name and unit
run hysteresis time_first.csv --csv r.csv --json r.json
check 'records: time comes first' is_quiet
check 'records: ... and is not the displacement' test "$(setting displacement_column)" = '2 its name: displacement'
check 'records: ... the work is that of displacement and force' \
   near_to "$(last_energy r.csv)" "$(work time_first.csv 2 3)" 1e-12
check 'records: ... the choice is in JSON' sh -c 'sed -n "/^\"columns\"/,/^}/p" r.json | tr -d "\n" | grep -Fq \
   "\"quantity\": [\"displacement\", \"force\"],\"column\": [2, 3],\"heading\": [\"displacement\", \"force\"],\"unit\": [\"mm\", \"kN\"],\"chosen_by\": [\"name\", \"name\"]"'
cut -d, -f2-3 time_first.csv >bare_columns.csv
run hysteresis bare_columns.csv --csv r2.csv
check 'records: ... as if time were not there' cmp r.csv r2.csv
refuses 'records: time is no displacement, even if asked for' 2 \
   "time_first.csv: column 1 is in s, which is time and no displacement: choose another with --displacement-column; its columns are 1 'time' in s, 2 'displacement' in mm, 3 'force' in kN" \
   hysteresis time_first.csv --displacement-column time
printf 'time (s);Kraft (kN)\n0;0\n1;1\n2;2\n3;0\n' >no_way.csv
refuses 'records: a file without a displacement' 2 \
   "no_way.csv: no column is displacement by its name and unit: .*--displacement-column; its columns are 1 'time' in s, 2 'Kraft' in kN" \
   hysteresis no_way.csv
refuses 'records: two displacements' 2 \
   'two_transducers.csv: columns 2 and 3 may both be displacement: choose with --displacement-column; its' \
   hysteresis two_transducers.csv
run hysteresis two_transducers.csv --displacement-column 'lvdt south' --csv r.csv
check 'records: the one meant' sh -c 'grep -q "force_column  *4  *its name: load" out'
check 'records: ... goes 2 % further' near_to "$(csv_column r.csv positive_displacement | tail -n 1)" 1.2607 1e-4
run hysteresis kip_inch.csv --csv r.csv
check 'records: inches and kips keep their units' test \
   "$(csv_unit r.csv positive_displacement), $(csv_unit r.csv positive_force)" = 'in, kip'
check 'records: ... and the spring its stiffness' csv r.csv \
   'if (far(c["secant_stiffness"], 16, 1e-12)) fail(c["secant_stiffness"])'
run hysteresis rotation_mrad.csv --csv r.csv
check 'records: rotation and moment without an option' test "$(setting quantity)" = 'moment its columns'
check 'records: ... keep their units' test \
   "$(csv_unit r.csv positive_rotation), $(csv_unit r.csv positive_moment)" = 'mrad, kN m'
# name: heading, expected column by name
for heading in 'Traversenweg (mm)' 'disp_mm' 'Slip [mm]' 'u' 'Standardweg in mm' 'mid-span deflection, mm' \
   'crack opening' 'Channel 7 (mm)' 'drift (mm)' 'STROKE MM'; do
   { printf 'Zeit (s);Max. Kraft (kN);%s\n' "$heading"; printf '0;0;0\n0.5;2;1\n1;-2;-1\n1.5;0;0\n'; } >named.csv
   run hysteresis named.csv
   check "records: '$heading' is a displacement" grep -Eq '^  displacement_column +3 ' out
done
for heading in 'F' 'Load, kip' 'actuator force' 'Prüfkraft (N)' 'P' 'Channel 2 (kN)'; do
   { printf 't;%s;u\n' "$heading"; printf '0;0;0\n0.5;2;1\n1;-2;-1\n1.5;0;0\n'; } >named.csv
   run hysteresis named.csv
   check "records: '$heading' is a force" grep -Eq '^  force_column +2 ' out
done

printf 'D1;E2\n0;0\n0.5;2\n-1;-2\n0;0\n' >named.csv
run hysteresis named.csv --csv r.csv
check 'records: names of a letter and a number are names' test "$(csv_column r.csv first_sample | head -n 1)" = 1
check 'records: ... in the order of the columns' test "$(setting displacement_column)" = \
   '1 what is left of the columns: D1'

# Without names
printf '0 0 0\n1 1 5\n2 4 9\n3 2 1\n4 0 -2\n' >unnamed.csv
refuses 'records: an unnamed column like time among three' 2 \
   'unnamed.csv: column 1 goes on in equal steps of 1.0, as time does, and nothing says .*its columns are 1, 2, 3' \
   hysteresis unnamed.csv
run hysteresis unnamed.csv --displacement-column 2 --force-column 3
check 'records: ... is passed over by numbers of columns' test "$status" -eq 0
awk '{ print $2, $3, $1 }' unnamed.csv >unnamed_2.csv
run hysteresis unnamed_2.csv
check 'records: unnamed columns are 1 and 2, and it is said' test "$(setting displacement_column)" = \
   '1 position: nothing says what columns hold'
printf '0,5 1\n1,5 2\n-2 -2\n' >unnamed.csv
run hysteresis unnamed.csv --csv r.csv
check 'records: decimal commas between blanks' near_to "$(csv_column r.csv positive_displacement | head -n 1)" 1.5 1e-15

# The line of units, and the first line of numbers
printf 'displacement;force\n0,6180;1\n-1;-2\n0;0\n2,5;3\n' >first.csv
run hysteresis first.csv --csv r.csv
check 'records: the first line of numbers is none of units' test "$(csv_column r.csv first_sample | head -n 1)" = 1
check 'records: ... and its commas are decimal' test "$(setting decimal)" = 'comma the numbers of the file'
refuses 'records: ... unless points are asked for' 2 \
   "first.csv:2: displacement \(column 1\) = '0,6180' is not a finite number; for decimal commas use --decimal comma" \
   hysteresis first.csv --decimal point
printf 'displacement;force\nn/a;-\n0;0\n1;2\n' >first.csv
refuses 'records: texts are no units' 2 "first.csv:2: displacement \(column 1\) = 'n/a' is not a finite" \
   hysteresis first.csv
printf 'Weg [mm];Kraft [kN]\n1,234;2,500\n3,250;9,125\n2,100;4,333\n' >thousands.csv
refuses 'records: decimals or thousands' 2 'thousands.csv: every number with a comma has three figures .*--decimal comma' \
   hysteresis thousands.csv
run hysteresis thousands.csv --decimal comma --csv r.csv
check 'records: ... decimals if so said' near_to "$(csv_column r.csv positive_force | head -n 1)" 9.125 1e-15
printf 'displacement,force\n0,5,1,2\n1,5,2,2\n' >commas.csv
refuses 'records: commas for both' 2 'commas.csv:2: the line has 4 fields for 2 names' hysteresis commas.csv
printf 'time in s displacement (mm) force (kN)\n0 0 0\n' >blanks.csv
refuses 'records: names with blanks between blanks' 2 'blanks.csv:2: the line has 3 fields for 5 names' \
   hysteresis blanks.csv
{ printf '\377\376'; printf 'x\0;\0f\0'; } >utf16.csv
refuses 'records: UTF-16' 2 'utf16.csv: is in UTF-16: save it as UTF-8' hysteresis utf16.csv

# Histories of the tenon joint
quick=(--face-points 20 --side-points 4)
history() { # name file value option...
   local name=$1 file=$2 value=$3
   shift 3
   run tenon "${quick[@]}" --history "$file" --csv way.csv "$@"
   check "records: history of $name" is_quiet
   check "records: history of $name, displacement in mm" reaches way.csv displacement "$value" 1e-12
}
history 'time and decimal commas' protocol_comma.csv 12.36
check 'records: ... its column, unit and decimal sign are said' test \
   "$(setting displacement_column); $(setting displacement_unit); $(setting decimal)" = \
   '2 its name: load-point displacement; mm column 2; comma the numbers of the file'
history 'drift in %' drift_percent.csv 6.18          # 0.01236 rad times the arm of 500 mm
check 'records: ... is a rotation' test "$(setting history_quantity)" = 'rotation its name: storey drift'
history 'drift in %, of another arm' drift_percent.csv 9.888 --arm 800
history 'rotation in mrad' rotation_mrad.csv 6.18
history 'inches' kip_inch.csv 15.6972                # 0.618 in of 25.4 mm
history 'inches called cm' kip_inch.csv 6.18 --displacement-unit cm
tail -n +2 protocol_comma.csv | cut -d ';' -f2 >one_column.csv
history 'one unnamed column' one_column.csv 12.36
tr , . <one_column.csv | awk '{ print $1/1000 }' >metres.csv
history 'one unnamed column in m' metres.csv 12.36 --displacement-unit m
sed '1i displacement, m' metres.csv >named_metres.csv
history 'a name and a unit after a comma' named_metres.csv 12.36
{ echo 'logger'; tr ';' '\t' <protocol_comma.csv; } >tabs.csv
history 'skipped lines and a given separator' tabs.csv 12.36 --skip-lines 1 --separator tab --decimal comma
run tenon "${quick[@]}" --history drift_percent.csv --sweep arm=500,1000 --csv sweep_arm.csv
check 'records: rotation takes the arm of each case of a sweep' sh -c '
   grep -c ",done$" sweep_arm.csv | grep -qx 2'
run tenon "${quick[@]}" --arm 1000 --history drift_percent.csv --json one.json
check 'records: ... as a run of its own' test "$(csv_column sweep_arm.csv work_of_load_hard | tail -n 1)" = \
   "$(sed -n '/^"totals"/,/^}/p' one.json | sed -n 's/^"work_of_load": \[\([^,]*\),.*/\1/p')"
refuses 'records: history in s' 2 'time_first.csv: column 1 is in s, which is time and no displacement' \
   tenon --history time_first.csv --displacement-column 1
refuses 'records: history in kN' 2 'time_first.csv: displacement \(column 3\) is in kN, which is no length: mm' \
   tenon --history time_first.csv --displacement-column 3
refuses 'records: no rotation' 2 'time_first.csv: no column is rotation by its name and unit' \
   tenon --history time_first.csv --history-quantity rotation
printf 'rotation\n0\n1.5\n-1.5\n0\n' >bare_rotation.csv
refuses 'records: a rotation that may be in %' 2 \
   'bare_rotation.csv: rotation \(column 1\) has no unit and goes to 1.5: if that is % or mrad' \
   tenon --history bare_rotation.csv
refuses 'records: the history as output' 2 '--csv: way.csv is the history, it would be lost' \
   tenon --history way.csv --csv way.csv
refuses 'records: how it is read cannot be swept' 2 '--sweep: decimal cannot be swept' tenon --sweep decimal=point,comma

# Several tests in one file
run hysteresis three_tests.csv --csv all.csv --json all.json
check 'records: three tests' is_quiet
check 'records: ... have a row for each of three cycles' test \
   "$(csv_column all.csv specimen | tr '\n' ' ')" = 'A A A B B B C C C '
check 'records: ... their own forces' csv all.csv '
   f["A"] = 4; f["B"] = 8; f["C"] = 16
   if (c["positive_force"] != f[c["specimen"]] || c["negative_force"] != -f[c["specimen"]]) fail(c["specimen"])'
check 'records: ... the same in JSON' same_csv_and_json all.csv all.json
for specimen in A B C; do
   grep -e '^specimen' -e "^$specimen" three_tests.csv | cut -d, -f2- >one.csv
   run hysteresis one.csv --csv one_cycles.csv
   run hysteresis three_tests.csv --where specimen=$specimen --csv where.csv
   check "records: ... specimen $specimen alone" cmp where.csv one_cycles.csv
   grep "^$specimen" all.csv | cut -d, -f2- >rows.csv
   tail -n +2 one_cycles.csv >expected.csv
   check "records: ... specimen $specimen among all" cmp rows.csv expected.csv
   check "records: ... specimen $specimen has its own work" near_to "$(last_energy one_cycles.csv)" \
      "$(work one.csv 2 3)" 1e-12
done
refuses 'records: a value that is not there' 2 \
   "--where: no row of three_tests.csv has specimen = 'D'; there are: A, B, C" \
   hysteresis three_tests.csv --where specimen=D
refuses 'records: a column that is not there' 2 \
   "--where: three_tests.csv: there is no column 'specimn', did you mean specimen\?" \
   hysteresis three_tests.csv --where specimn=A
refuses 'records: no condition' 2 "--where: 'A' is not NAME=VALUE" hysteresis three_tests.csv --where A
sed '$d' three_tests.csv >unlike.csv
refuses 'records: tests of different ways are no history' 2 \
   'unlike.csv: has 3 tests below each other, choose one with --where NAME=VALUE: specimen = A; specimen = B; spec' \
   tenon --history unlike.csv
history 'tests that go the same way' three_tests.csv 2
history 'one test of several' unlike.csv 2 --where specimen=B
sed 's/^specimen/cycle/; s/^A/1/; s/^B/2/; s/^C/3/' three_tests.csv >counted.csv
run hysteresis counted.csv --csv r.csv
check 'records: a number of the cycle splits nothing' lacks r.csv '^[0-9]+,[0-9]+,(yes|no)'
# the program's own files, of three normal stresses and of both models
run shear --displacement 3,-3,3 --csv shear.csv
run hysteresis shear.csv --csv r.csv
check 'records: a shear box of three stresses' is_quiet
check 'records: ... each with mu times its weight' csv r.csv '
   # the discs of 61.8 mm have 2999.6 mm^2
   if (far(c["positive_force"], 0.5*c["normal_stress_nominal"]*atan2(0, -1)*61.8^2/4, 1e-9)) fail("force")'
run hysteresis shear.csv --where normal_stress_nominal=0.1 --csv r2.csv
check 'records: a number as a condition' sh -c '
   grep "^1.0000000000000001E-001" r.csv | cut -d, -f2- >a; tail -n +2 r2.csv | cmp - a'
run tenon "${quick[@]}" --amplitudes 4,8 --csv joint.csv --json joint.json
run hysteresis joint.csv --quantity moment --csv r.csv
check 'records: a joint of both models' is_quiet
check 'records: ... in the units of its file' test \
   "$(csv_unit r.csv positive_rotation), $(csv_unit r.csv positive_moment)" = 'rad, kN m'
check 'records: ... with the moments that the joint has' awk -F, -v a="$(sed -n '/^"cycles"/,/^}/p' joint.json \
   | sed -n 's/^"negative_moment_rough": \[\(.*\)\].*/\1/p')" 'NR == 1 { for (i = 1; i <= NF; i++) n[$i] = i }
   $1 == "rough" { k++; split(a, m, ", "); d = m[k]/$(n["negative_moment (kN m)"]) - 1; if (d*d > 1e-24) bad = 1 }
   END { exit bad || k != 2 }' r.csv
run hysteresis joint.csv --displacement-column rotation --force-column moment
check 'records: columns that are asked for say the quantity' test "$(setting quantity)" = 'moment its columns'
if command -v gnuplot >/dev/null; then
   run hysteresis three_tests.csv --plot three.svg
   check 'records: a picture of three tests' sh -c '
      tail -n 3 three.svg | grep -q "^</svg>" && grep -q "specimen = C" three.svg'
fi

# Latin-1
latin=$(printf 'Pr\374f \265m.csv')
cp latin1_unit.csv "$latin"
run hysteresis "$latin" --csv l.csv --json l.json
check 'records: Latin-1 in name and unit' test "$status" -eq 0
if command -v iconv >/dev/null; then
   check 'records: ... CSV, JSON and screen are UTF-8' sh -c 'cat l.csv l.json out | iconv -f UTF-8 -t UTF-16 >/dev/null'
fi
check 'records: ... the unit is a micrometre' test "$(csv_unit l.csv positive_displacement)" = "$(printf '\302\265m')"
sed 's/^\([0-9]*\);/\1000;/' "$latin" >"thousand $latin"
history 'micrometres in Latin-1' "thousand $latin" 2
if command -v python3 >/dev/null; then
   check 'records: ... JSON of it is JSON' python3 -c "
import json
data = json.load(open('l.json', encoding='utf-8'))
assert data['units']['positive_displacement'] == '\u00b5m' and data['settings']['record_file'] == ['Pr\u00fcf \u00b5m.csv']"
   if command -v gnuplot >/dev/null; then
      run hysteresis "$latin" --plot l.svg
      check 'records: ... and its picture XML' python3 -c "
import xml.dom.minidom
assert 'Pr\u00fcf \u00b5m.csv' in xml.dom.minidom.parse('l.svg').toxml()"
   fi
fi

# Little memory: a small record needs little, a large one ends with a word
if (ulimit -v 65536 && "$program" version >/dev/null 2>&1); then
   address_space=65536 run hysteresis time_first.csv
   check 'records: 64 MiB are enough for a small one' is_quiet
   yes '1.23456789,2.3456789' | head -n 2000000 >large.csv
   address_space=65536 run hysteresis large.csv
   check 'records: and too little for one of 40 MB, which is said' is_refused 3 \
      'large.csv: cannot be read: not enough memory: make it smaller, or raise the limit'
   rm large.csv
   # 200 000 samples, 28 500 cycles: at every limit the results, or one line that says what to do
   awk 'BEGIN { print "displacement (mm),force (kN)"
      for (i = 0; i < 200000; i++) { c = i/7.0175; s = sin(6.283185307*c)
         printf "%.6g,%.6g\n", (1 + c/5000)*s, 10*(1 + c/5000)*s + 3*cos(6.283185307*c) } }' >large.csv
   given=0 refused=0 wrong=
   for limit in $(seq 65536 8192 204800); do
      address_space=$limit run hysteresis large.csv --csv out.csv --json out.json
      if is_quiet && [ "$(rows out.csv)" -eq 28501 ]; then
         given=$((given + 1))
      elif { is_refused 1 '.*not enough memory, .* MiB more .*: make it smaller, or' \
         || is_refused 3 'large.csv: cannot be read: not enough memory: make it smaller, or'; } \
         && absent out.csv && absent out.json; then
         refused=$((refused + 1))
      else
         wrong="$wrong [$limit: $status: $(head -n 1 err)]"
      fi
      rm -f out.csv out.json
   done
   check "records: little memory, $given results, $refused refusals:$wrong" \
      test "$given" -gt 2 -a "$refused" -gt 2 -a -z "$wrong"
   rm large.csv
else
   skip 'records: little memory' 'the program itself needs more than 64 MiB'
fi
