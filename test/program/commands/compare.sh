# asperity compare: results of solvers against expected values

data=$root/test/data/solver_output
expected=$data/expected.csv

# changed NAME AWK: the expected values with something done to the fields of each row of numbers
changed() { awk -F, -v OFS=, "NR > 1 { $2 } 1" "$expected" >"$1"; }
# passes NAME FILE COLUMNS [OPTION...]: the comparison passes in so many columns
passes() {
   local name=$1 file=$2 columns=$3
   shift 3
   run compare "$expected" "$file" "$@"
   check "compare: $name" is_quiet
   check "compare: $name, verdict" has out "Verdict: pass: $columns columns at 5 times within"
}
# departs NAME FILE COLUMNS WORDS: it does not, in these columns, and says why
departs() {
   run compare "$expected" "$2"
   check "compare: $1: status 1, columns" sh -c \
      "[ $status -eq 1 ] && [ \$(wc -l <err) -eq 1 ] && grep -Fq 'departs from $expected in $3' err"
   check "compare: $1: in words" has out "$4"
}

passes 'a file with itself' "$expected" 6
passes 'tables of ABAQUS, four figures' "$data/abaqus.dat" 3
check 'compare: the end of the step that is printed twice is told' has out 'Not compared: 1 of 6 rows of'
check 'compare: columns that a .dat does not have are told' has out \
   'does not have them: pressure, shear_1, shear_2.'
passes 'totals of CalculiX, an exponent without E' "$data/calculix.dat" 3 --tolerance 1e-7
passes 'X-Y data of ABAQUS/Viewer' "$data/viewer.rpt" 3 --tolerance 1e-7
run compare "$expected" "$data/abaqus.dat" --tolerance 1e-4
check 'compare: four figures are not 1e-4' sh -c "[ $status -eq 1 ] && grep -q 'in reaction_3' err"

# the table: the largest departure of each column, by hand: 0.004 beside 0.35e-3, 0.3e-3 and 2e-3 allowed
changed r.csv 'if (NR == 4) { $3 += 0.004; $4 -= 0.0001; $2 += 0.001 }'
run compare "$expected" r.csv --csv c.csv --json c.json
check 'compare: what departs' csv c.csv '
   of = c["column"]; off = c["off_over_allowed"]
   if (of == "shear_1" && (c["passes"] != "no" || c["worst_row"] != 3 || far(c["time"], 0.3, 1e-14) ||
      far(c["expected"], -0.2, 1e-14) || far(c["found"], -0.196, 1e-14) || far(off, 0.004/0.35e-3, 1e-10))) fail(of)
   if (of == "shear_2" && (c["passes"] != "yes" || far(off, 0.0001/0.3e-3, 1e-10))) fail(of)
   if (of == "pressure" && (c["passes"] != "yes" || far(off, 0.5, 1e-10))) fail(of)
   if (c["rows"] != 5) fail("rows")'
check 'compare: JSON holds the same' same_csv_and_json c.csv c.json
check 'compare: the first row that departs' has out 'shear_1 departs from row 3 on, at 0.3 s.'
check 'compare: the verdict names what departs' has out "Verdict: r.csv departs from $expected in shear_1."
check 'compare: and so does the error, status 1' sh -c \
   "[ $status -eq 1 ] && grep -Fqx 'asperity: error: r.csv departs from $expected in shear_1' err"

# what explains a departure
changed r.csv '$2 = -$2'
departs 'the other sign' r.csv pressure 'pressure has the other sign throughout'
changed r.csv '$6 *= 1e3; $7 *= 1e3; $8 *= 1e3'
departs 'forces in another unit' r.csv 'reaction_1, reaction_2, reaction_3' \
   'reaction_1 is 1000.0 times what is expected throughout: check the units'
changed r.csv '$2 *= 1e-3'
departs 'a pressure of a thousandth' r.csv pressure 'pressure is 0.001 times'
changed r.csv '$8 *= 0.25'
departs 'a quarter of the area' r.csv reaction_3 \
   'reaction_3 is 0.25 times what is expected throughout: check area and properties'
changed r.csv '$2 *= 1.02'
departs 'a little more everywhere' r.csv pressure 'is 1.020 times what is expected throughout: check area and'
changed r.csv '$2 = 0'
departs 'no pressure' r.csv pressure 'pressure is zero throughout: was the routine called?'
changed r.csv 'x = $3; $3 = $4; $4 = x'
departs 'two columns changed' r.csv 'shear_1, shear_2' 'shear_1 and shear_2 have changed places.'
changed r.csv 'x = $6; $6 = $7; $7 = -x'
departs 'slip directions turned' r.csv 'reaction_1, reaction_2' \
   'reaction_1 and reaction_2 have changed places, one with the other sign'

# a column that is zero throughout may be off as much as others of its unit
awk -F, -v OFS=, 'NR > 1 { $4 = 0 } 1' "$expected" >zero.csv
awk -F, -v OFS=, 'NR > 1 { $4 = 1e-3 } 1' "$expected" >off.csv
run compare zero.csv off.csv
check 'compare: noise in a column of zeros passes' is_quiet
sed 's/1\.0*e-03\|,0\.001,/,0.01,/' off.csv >far.csv
run compare zero.csv far.csv
check 'compare: more than noise does not' sh -c "[ $status -eq 1 ] && grep -q 'in shear_2' err"

# rows
{ head -n 1 "$expected"; tail -n +2 "$expected" | sort -r; } >r.csv
passes 'rows in another order' r.csv 6
check 'compare: the order is told' has out 'not in the order of time'
awk -F, -v OFS=, 'NR > 2 { $1 -= 0.05; print; $1 += 0.05 } 1' "$expected" >r.csv
passes 'rows between' r.csv 6
check 'compare: rows between are told' has out 'Not compared: 4 of 9 rows of r.csv'
head -n 4 "$expected" >r.csv
run compare "$expected" r.csv
check 'compare: rows that are missing' sh -c "[ $status -eq 1 ] && grep -q 'has no row at 2 of 5 times' err"
check 'compare: the first of them' has out 'has no row at 2 of 5 times, the first of them 0.4 s.'
awk -F, -v OFS=, 'NR == 3 { $2 = "" } 1' "$expected" >r.csv
run compare "$expected" r.csv
check 'compare: a value that is missing departs' sh -c "[ $status -eq 1 ] && grep -q 'in pressure' err"
run compare r.csv "$expected"
check 'compare: where nothing is expected, nothing is compared' is_quiet
sed '1s/pressure/Pressure/; s/,/;/g' "$expected" >r.csv
passes 'semicolons, names in any case' r.csv 6

# bad input
refuses 'compare: one file' 2 '1 files are given; two are compared' compare "$expected"
refuses 'compare: three files' 2 '3 files are given' compare "$expected" "$expected" "$expected"
refuses 'compare: no such file' 3 'gone.csv: cannot be read' compare "$expected" gone.csv
refuses 'compare: a tolerance of 0' 2 '--tolerance: tolerance = 0.0 is not allowed' \
   compare "$expected" "$expected" --tolerance 0
printf 'a,b\n1,2\n' >r.csv
refuses 'compare: no time' 2 'r.csv: has no column time; its columns are 1 .a., 2 .b.' compare "$expected" r.csv
printf 'time,b\n0.1,2\n' >r.csv
refuses 'compare: no column in common' 2 'r.csv: has none of the columns of .*: pressure, shear_1' \
   compare "$expected" r.csv
changed r.csv '$1 += 7'
refuses 'compare: no time in common' 2 'r.csv: has no row at any time of .*, which goes from 0.1 to 0.5 s' \
   compare "$expected" r.csv
changed r.csv 'if (NR == 3) $2 = "none"'
refuses 'compare: no number' 2 "r.csv:3: pressure \(column 2\) = 'none' is not a finite number" \
   compare "$expected" r.csv
sed 's/FACE/BASE/' "$data/calculix.dat" | cat "$data/calculix.dat" - >two.dat
refuses 'compare: totals of two sets' 2 'two.dat:[0-9]+: has totals of reaction forces of the sets FACE and BASE' \
   compare "$expected" two.dat
{ grep -v '^ TOTAL \|ZERO' "$data/abaqus.dat"; echo ' TOTAL CPU TIME (SEC)  =       0.10000'; } >none.dat
refuses 'compare: no totals' 2 'none.dat: has reaction forces without totals; \*NODE PRINT' compare "$expected" none.dat
sed -n '1,/SUMMARY/p' "$data/abaqus.dat" >short.dat
refuses 'compare: an analysis that never began' 2 'short.dat: has no totals of reaction forces; \*NODE PRINT' \
   compare "$expected" short.dat
sed 's/^ TOTAL  .*/ TOTAL   ****** 1. 1./' "$data/abaqus.dat" >stars.dat
refuses 'compare: stars' 2 "stars.dat:[0-9]+: '\*\*\*\*\*\*' is not a finite number" compare "$expected" stars.dat
refuses 'compare: the result is not lost' 2 '--csv: r.csv is the result' compare "$expected" r.csv --csv r.csv

if command -v gnuplot >/dev/null; then
   run compare "$expected" "$data/abaqus.dat" --plot p.svg
   check 'compare: a picture' has p.svg 'reaction_3, expected'
fi
