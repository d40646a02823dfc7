# asperity hysteresis: what standards make of records, several records at once, the page. Records of
# examples/records, whose formulas stand in make.sh there
made=$root/examples/records
cp "$made"/*.csv .

# value_of TABLE COLUMN ROW [FILE]: one value of a table in JSON, rows from 1
value_of() {
   sed -n "/^\"$1\": {/,/^}/p" "${4:-s.json}" | sed -n "s/^\"$2\": \[\(.*\)\],*$/\1/p" | tr -d ' "' | cut -d, -f"$3"
}
# is_about VALUE EXPECTED TOLERANCE: numbers both, and near to each other
is_about() {
   awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { print a, b
      exit !(a ~ /^-?[0-9]/ && b ~ /^-?[0-9]/ && a - b <= t && b - a <= t) }'
}

same_examples() { mkdir again && bash "$made/make.sh" again && for file in again/*; do cmp "$file" "$made/${file#again/}" || return 1; done; }
check 'standards: the examples are those of their script' same_examples

# EN 26891: the envelope is F = (11 + 0.35 u)(1 - exp(-9 u/11)), u = v - 0.1 at first and v - 0.13 later
run hysteresis en_26891.csv --json s.json
check 'standards: EN 26891' is_quiet
check 'standards: ... is monotonic with unloading' has s.json '"record_kind": "monotonic_with_unloading"'
check 'standards: ... the estimate comes from the unloading' test "$(value_of en_26891 estimated_by 1)" = unloading
check 'standards: ... 0.4 of 16 kN' is_about "$(value_of en_26891 estimated_force 1)" 16 1e-9
envelope_at() { # force, slack: displacement by bisection
   awk -v f="$1" -v slack="$2" 'BEGIN { low = 0; high = 30
      for (i = 0; i < 100; i++) { v = (low + high)/2; if ((11 + 0.35*v)*(1 - exp(-9*v/11)) < f) low = v; else high = v }
      printf "%.15g", v + slack }'
}
v_01=$(envelope_at 1.6 0.1)
# the force is held where the next sample would be above it
v_04=$(awk -F, 'NR > 1 && $2 >= 6.4 { print $1; exit }' en_26891.csv)
check 'standards: ... slip at 0.1' is_about "$(value_of en_26891 slip_at_10_percent 1)" "$v_01" 1e-4
check 'standards: ... slip at 0.4' is_about "$(value_of en_26891 initial_slip 1)" "$v_04" 1e-6
modified=$(awk -v a="$v_01" -v b="$v_04" 'BEGIN { printf "%.15g", 4/3*(b - a) }')
check 'standards: ... v_i,mod' is_about "$(value_of en_26891 modified_initial_slip 1)" "$modified" 2e-4
check 'standards: ... k_s' is_about "$(value_of en_26891 slip_modulus 1)" \
   "$(awk -v v="$modified" 'BEGIN { print 6.4/v }')" 2e-3
# unloaded by 0.32 mm and loaded again along the same line
check 'standards: ... elastic slip' is_about "$(value_of en_26891 elastic_slip 1)" \
   "$(awk 'BEGIN { print 2/3*2*0.32 }')" 1e-6
check 'standards: ... largest force at 15 mm, not the 16.9 kN that come later' is_about \
   "$(value_of en_26891 peak_force 1)" \
   "$(awk 'BEGIN { v = 15 - 0.13; printf "%.10g", (11 + 0.35*v)*(1 - exp(-9*v/11)) }')" 1e-4
peak=$(value_of en_26891 peak_force 1)
v_06=$(envelope_at "$(awk -v f="$peak" 'BEGIN { printf "%.15g", 0.6*f }')" 0.13)
check 'standards: ... slip at 0.6' is_about "$(value_of en_26891 slip_at_60_percent 1)" "$v_06" 3e-3
check 'standards: ... all up to 15 mm' has out 'Slips and slip moduli by EN 26891, up to 15 mm'
tail -n +2 en_26891.csv >bare.csv
run hysteresis bare.csv --json s.json
check 'standards: no unit, no limit' has out 'without its limit of 15 mm, as no unit of displacement is known'
check 'standards: ... the largest force of all' is_about "$(value_of en_26891 peak_force 1)" 16.894 1e-3
run hysteresis bare.csv --displacement-unit mm --json s.json
check 'standards: a unit that is given' is_about "$(value_of en_26891 peak_displacement 1)" 15 1e-9
run hysteresis en_26891.csv --displacement-factor 1e-3 --displacement-unit m --json s.json
check 'standards: in m' is_about "$(value_of en_26891 peak_displacement 1)" 0.015 1e-12
run hysteresis en_26891.csv --estimated-force 12 --json s.json
check 'standards: an estimate that is given' test "$(value_of en_26891 estimated_by 1)" = given
check 'standards: ... and far off' has out 'EN 26891: the largest force, 16.204 kN, is more than 20 % off the estimate'
refuses 'standards: no estimate' 2 '--estimated-force: estimated_force = -1.0 is not allowed' \
   hysteresis en_26891.csv --estimated-force -1
sed 's/slip (mm)/rotation (rad)/; s/force (kN)/moment (kN m)/' en_26891.csv >turned.csv
run hysteresis turned.csv
check 'standards: rotations have no limit in mm' has out 'without its limit of 15 mm, as rotations have none'

# EN 12512 on a cyclic record: second cycles have 0.9, third ones 0.85 of the first force
run hysteresis cyclic_1.csv --json s.json --csv s.csv
check 'standards: EN 12512' is_quiet
check 'standards: ... impairment' is_about "$(value_of amplitudes impairment 3)" 0.15 1e-4
check 'standards: ... of one cycle there is none' test "$(value_of amplitudes impairment 1)" = null
check 'standards: ... three cycles' test "$(value_of amplitudes cycles 3)" = 3
check 'standards: ... second cycle' is_about "$(awk -v a="$(value_of amplitudes second_force 6)" \
   -v b="$(value_of amplitudes first_force 6)" 'BEGIN { print a/b }')" 0.9 1e-4
check 'standards: ... yield point by the tangent, as the envelope bends' test \
   "$(value_of en_12512 yield_method 1)" = tangent
# by its formula, 1e5 points: peak of the samples at 16.2
tangent=$(awk 'function f(v) { return (11 + 0.35*v)*(1 - exp(-9*v/11)) }
   function at(force) { low = 0; high = 16; for (i = 0; i < 100; i++) { m = (low + high)/2; if (f(m) < force) low = m; else high = m }
      return m }
   BEGIN { peak = 16.6*(1 - 0.06*0.2); a = at(0.1*peak); b = at(0.4*peak); k = 0.3*peak/(b - a); c = 0
      for (v = 0; v <= 16; v += 1e-4) if (f(v) - k/6*v > c) c = f(v) - k/6*v
      printf "%.10g", (c - 0.1*peak + k*a)/(k*5/6) }')
check 'standards: ... where its formula says' is_about "$(value_of en_12512 tangent_displacement 1)" "$tangent" 0.02
check 'standards: ... 0.8 of the peak comes first' test "$(value_of en_12512 ultimate_reason 1)" = force
check 'standards: ... at 0.8 of the peak on the falling line' is_about "$(value_of en_12512 ultimate_displacement 1)" \
   "$(awk 'BEGIN { print 16 + (1 - 0.8*(1 - 0.06*0.2))/0.06 }')" 0.02
check 'standards: ... class' test "$(value_of en_12512 ductility_class 1)" = high
check 'standards: the mean of equal sides is either' is_about \
   "$(value_of summary yield_force 1)" "$(value_of summary yield_force 3)" 1e-12
check 'standards: halves of equal sides have the damping of the whole' csv s.csv \
   'if (NR > 2 && far(c["positive_damping"], c["damping"], 1e-9)) fail(c["positive_damping"])'
awk -F, -v OFS=, 'NR > 1 { $2 *= 2 } { print }' cyclic_1.csv >wide.csv
run hysteresis wide.csv --json s.json
check 'standards: 30 mm come first' test "$(value_of en_12512 ultimate_reason 1)" = limit
check 'standards: ... and are the ultimate point' is_about "$(value_of en_12512 ultimate_displacement 1)" 30 1e-9
check 'standards: ... not of ASTM E2126' is_about "$(value_of summary ultimate_displacement 1)" 38.986 1e-2
# one-sided: no damping of whole cycles, but of their halves
awk -F, '$2 >= 0' cyclic_1.csv >one_side.csv
sed -n 1p cyclic_1.csv | cat - one_side.csv | awk 'NR == 1 || !/time/' >one_sided.csv
run hysteresis one_sided.csv --csv s.csv --json s.json
check 'standards: one side' has s.json '"record_kind": "one_sided"'
check 'standards: ... has damping by half cycle' csv s.csv \
   'if (NR > 2 && c["positive_damping"] == "") fail(NR)'

# Several records
run hysteresis cyclic_1.csv cyclic_2.csv cyclic_3.csv --csv s.csv --json s.json
check 'standards: three records' is_quiet
check 'standards: ... the record comes first' test "$(head -n 1 s.csv | cut -d, -f1-2)" = record,cycle
check 'standards: ... with all cycles' test "$(rows s.csv)" -eq 60
check 'standards: ... in JSON all are named' has s.json '"record_file": ["cyclic_1.csv", "cyclic_2.csv", "cyclic_3.csv"]'
cp s.json all.json
cp s.csv all.csv
for i in 1 2 3; do
   run hysteresis cyclic_$i.csv --json s.json --csv s.csv
   check "standards: ... record $i has its yield force" is_about \
      "$(value_of summary yield_force $((3*i - 2)) all.json)" "$(value_of summary yield_force 1)" 0
   check "standards: ... record $i has its cycles" sh -c \
      "tail -n +2 s.csv >one.csv && grep '^cyclic_$i' all.csv | cut -d, -f2- | cmp - one.csv"
done
# mean, variation and fractile of the peak force of the positive side; k_s(3) = 3.1518 is the 75 % quantile
# of the noncentral t
peaks="$(value_of summary peak_force 1 all.json) $(value_of summary peak_force 4 all.json) $(value_of summary peak_force 7 all.json)"
row=$(sed -n '/^"statistics": {/,/^}/p' all.json | sed -n 's/^"quantity": \[\(.*\)\],*$/\1/p' | tr -d ' "' | tr , '\n' | grep -n '^peak_force$' | head -n 1 | cut -d: -f1)
expected() { # formula: of mean (m), variation (v), fractile (q)
   echo "$peaks" | awk "{ m = (\$1 + \$2 + \$3)/3; v = sqrt(((\$1 - m)^2 + (\$2 - m)^2 + (\$3 - m)^2)/2)/m
      l = (log(\$1) + log(\$2) + log(\$3))/3; s = sqrt(((log(\$1) - l)^2 + (log(\$2) - l)^2 + (log(\$3) - l)^2)/2)
      q = exp(l - 3.151842138184501*(s > 0.05 ? s : 0.05)); printf \"%.12g\", $1 }"
}
check 'standards: mean' is_about "$(value_of statistics mean "$row" all.json)" "$(expected m)" 1e-9
check 'standards: coefficient of variation' is_about \
   "$(value_of statistics coefficient_of_variation "$row" all.json)" "$(expected v)" 1e-9
check 'standards: 5 % fractile' is_about "$(value_of statistics fractile_5_percent "$row" all.json)" "$(expected q)" 1e-8
check 'standards: of three tests' test "$(value_of statistics tests "$row" all.json)" = 3
run hysteresis cyclic_1.csv cyclic_2.csv --json s.json
check 'standards: no fractile of two' test "$(value_of statistics fractile_5_percent 1)" = null
# tests of one file are no repeats of each other; those of several files are, if all else is the same
sed '1s/^/specimen,/; 2,$s/^/A,/' cyclic_1.csv >tests_1.csv
sed '2,$s/^/B,/; 1d' cyclic_2.csv >>tests_1.csv
sed 's/^B,/C,/; s/^A,/B,/' tests_1.csv >tests_2.csv
run hysteresis tests_1.csv --json s.json
check 'standards: tests of one file have no statistics' sh -c 'grep -q "\"summary\"" s.json && ! grep -q "\"statistics\"" s.json'
run hysteresis tests_1.csv tests_2.csv --json s.json --csv s.csv
check 'standards: two files, four tests' test "$(rows s.csv)" -eq 80
check 'standards: ... by record and specimen' test "$(head -n 1 s.csv | cut -d, -f1-3)" = record,specimen,cycle
check 'standards: ... statistics of specimen B' test "$(value_of statistics tests_of 1)" = 'specimen=B'
check 'standards: ... of two tests' test "$(value_of statistics tests 1)" = 2
run hysteresis tests_1.csv en_26891.csv --json s.json
check 'standards: nothing to repeat' test "$status" -eq 0
check 'standards: columns that differ are said' has out 'en_26891.csv: displacement is column 1, force column 2, unlike 3 and 4 of tests_1.csv'
sed '1s/(mm)/(m)/' cyclic_2.csv >metres.csv
refuses 'standards: other units' 2 \
   'metres.csv is in m and kN, cyclic_1.csv in mm and kN: records in one call must have the same units' \
   hysteresis cyclic_1.csv metres.csv --csv never.csv
refuses 'standards: one that is not there' 3 'no.csv: cannot be read' hysteresis cyclic_1.csv no.csv --csv never.csv
printf '0,0\n1,-1\n-1,1\n0,0\n' >wrong.csv
refuses 'standards: one that is wrong' 2 'wrong.csv: force points against' \
   hysteresis cyclic_1.csv wrong.csv --displacement-unit mm --force-unit kN --csv never.csv
refuses 'standards: a record as output' 2 '--csv: cyclic_2.csv is the record, it would be lost' \
   hysteresis cyclic_1.csv cyclic_2.csv --csv cyclic_2.csv
check 'standards: nothing was written' absent never.csv

# The page
if command -v gnuplot >/dev/null; then
   run hysteresis cyclic_1.csv cyclic_2.csv cyclic_3.csv --report r.html --plot r.svg
   check 'standards: a page' is_quiet
   check 'standards: ... with its pictures' test "$(grep -c '</svg>' r.html)" -ge 4
   check 'standards: ... ends' sh -c 'tail -n 1 r.html | grep -q "</html>"'
   check 'standards: ... has the statistics' has r.html '5 % fractile'
   check 'standards: ... and the input' has r.html '<td class="text">amplitude_tolerance</td>'
   check 'standards: ... names its kind, no faces, no limit of the law' sh -c \
      'grep -q "Record: cyclic" r.html && ! grep -q "Faces:\|Validity" r.html'
   cp cyclic_1.csv '<b>&.csv'
   run hysteresis '<b>&.csv' --report r.html
   check 'standards: a page of an odd name' sh -c 'grep -q "&lt;b&gt;&amp;.csv" r.html && ! grep -q "<b>" r.html'
   run hysteresis en_26891.csv --report r.html
   check 'standards: a page of a monotonic test' has r.html 'Slips and slip moduli by EN 26891'
   refuses 'standards: a page is HTML' 2 '--report: r.svg' hysteresis cyclic_1.csv --report r.svg
else
   skip 'pages of records' 'no gnuplot'
fi
