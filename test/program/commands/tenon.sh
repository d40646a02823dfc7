# asperity tenon: the cyclic joint under both contact models. What the model itself must fulfil is
# tested in the library; here it is what the command makes of it

# Few points, as checked builds are slow; two amplitudes up to yield
small=(--amplitudes 4,24 --face-points 40 --side-points 4 --displacement-increment 2)
header=model,step,cycle,displacement,rotation,force,moment,pull_out,vertical,axial_force,work,\
contact_work,axial_work,holding_work,stored_energy,friction_dissipation,plastic_dissipation,\
elastic_slip_energy,edge_energy,normal_upper,normal_lower,normal_side_1,normal_side_2,\
normal_upper_shoulder,normal_lower_shoulder,friction_dissipation_upper,friction_dissipation_lower,\
friction_dissipation_side_1,friction_dissipation_side_2,friction_dissipation_upper_shoulder,\
friction_dissipation_lower_shoulder,iterations,halvings,validity
run tenon "${small[@]}" --csv t.csv --json t.json --points t_points.csv
check 'tenon' is_quiet
check 'tenon: columns' test "$(columns t.csv)" = "$header"
# to 4, -4, 0, 24, -24, 0 mm in steps of 2 mm: 2 + 4 + 2 + 12 + 24 + 12 steps and rest, twice
check 'tenon: rows' test "$(rows t.csv)" -eq 114
check 'tenon: JSON holds the same figures' same_csv_and_json t.csv t.json
check 'tenon: no NaN, no infinity' lacks t.json '[Nn]a[Nn]|[Ii]nf'
check 'tenon: rotation over arm, moment' csv t.csv '
   if (far(c["rotation"]*500, c["displacement"], 1e-12)) fail("rotation")
   if (far(c["force"]*500, c["moment"]*1e6, 1e-12)) fail("moment")'
check 'tenon: both models take the same way' sh -c '
   sed -n "s/^hard,//p" t.csv | cut -d, -f1-4 >hard; sed -n "s/^rough,//p" t.csv | cut -d, -f1-4 >rough
   test "$(wc -l <hard)" -eq 57 && cmp hard rough'
check 'tenon: friction of the faces adds up' csv t.csv '
   f = "friction_dissipation"
   sum = c[f "_upper"] + c[f "_lower"] + c[f "_side_1"] + c[f "_side_2"] \
      + c[f "_upper_shoulder"] + c[f "_lower_shoulder"]
   if (far(sum, c[f], 1e-10)) fail(sum " not " c[f])'
check 'tenon: dissipation never falls' csv t.csv '
   if (c["model"] == before["model"] && (c["friction_dissipation"] < before["friction_dissipation"] \
      || c["plastic_dissipation"] < before["plastic_dissipation"])) fail("falls")'
check 'tenon: the joint yields' csv t.csv \
   'p = max(p, c["plastic_dissipation"]); if (NR == 115 && !(p > 1)) fail("no yield")'
check 'tenon: faces only press' csv t.csv '
   if (c["normal_upper"] < 0 || c["normal_lower"] < 0) fail("pull")'

# Table 5 beside ours, if it is the paper's joint and programme, and not beside another
least=$(csv t.csv 'if (c["model"] == "hard" && c["moment"] < least) least = c["moment"]
   if (NR == 115) printf "%.2f", least')
# One unit for one quantity in every file
units_of() { local name file=$1; shift; for name in "$@"; do csv_unit "$file" "$name"; done | tr '\n' ','; }
check 'tenon: units' test "$(units_of t.csv displacement rotation force moment work normal_upper \
   friction_dissipation_upper step)" = 'mm,rad,N,kN m,J,N,J,'

check 'tenon: ultimate moment is the least of all' \
   grep -q "^  hard contact, this model .* $least  *1.000 " out
check 'tenon: another programme has no published figures' sh -c '
   ! grep -E "test, paper|OC-FEM|1[.]221" out && ! grep -F "test, paper" t.json'
check 'tenon: nor is its case the paper'"'"'s' has out 'A prediction, not a fit to a test: compare ratios'
full=(--face-points 40 --side-points 4 --displacement-increment 2)
run tenon "${full[@]}" --height 180
check 'tenon: another joint has no published figures' lacks out 'test, paper|OC-FEM|1.221'
run tenon "${full[@]}" --axial-rule fixed --friction-coefficient 0.24
check 'tenon: the same joint with other wood has them' grep -q '^  test, paper  *-19.56 ' out
run tenon "$root/examples/tenon_joint/clearance.nml" "${full[@]}"
check 'tenon: twice the clearance has not' lacks out 'test, paper|OC-FEM'
run tenon "$root/examples/tenon_joint/base.nml" "${full[@]}"
check 'tenon: the base case is the paper'"'"'s joint' grep -q '^  test, paper  *-19.56 ' out
check 'tenon: the load of the column acts on nothing here' lacks out '^  column_load '
run tenon "${full[@]}" --json full.json
check 'tenon: published figures' \
   sh -c 'grep -q "^  test, paper  *-19.56  1.221  *-22.14  *1.236  *181.06  *1.173" out \
      && grep -q "^  hard contact, paper (OC-FEM)  *-16.02  *1.000  *-17.91 .* 154.39 " out \
      && grep -q "^  rough law, paper (VC-FEM)  *-18.03  *1.125  *-19.84  *1.108  *163.82  *1.061" out'
check 'tenon: no zero has a sign' lacks out '(^| )-0[.]0*( |$)'
check 'tenon: it says that it is a prediction' has out 'A prediction from chosen sizes'
member() { sed -n "/^\"$1\"/,/^}/p" "${3:-t.json}" | sed -n "s/^\"$2\": \[\(.*\)\].*/\1/p"; }
check 'tenon: ratios are to hard contact' awk -v a="$(member summary ultimate_moment full.json)" \
   -v b="$(member summary ultimate_to_hard full.json)" 'BEGIN { split(a, m, ","); split(b, r, ",")
      exit !(r[4] == 1 && (m[5]/m[4] - r[5])^2 < 1e-24 && (r[3] - 19.84/17.91)^2 < 1e-12) }'
check 'tenon: energy of the cycles is the area of the loops' awk -F, -v w="$(member cycles energy_hard)" '
   NR > 1 && $1 == "hard" { if (n++) e += 0.5*($7 + m)*($5 - t)*1e3; t = $5; m = $7 }
   END { split(w, x, ","); d = x[1] + x[2] - e; exit d*d > 1e-20*e*e }' t.csv

# Contact points, at the steps chosen and at those asked for
check 'tenon: points of four steps' \
   sh -c 'test "$(cut -d, -f1-3 t_points.csv | sed 1d | sort -u | wc -l)" -eq 8'
check 'tenon: the peaks are among them' sh -c '
   for x in 2.4 -2.4; do grep -q "^rough,[0-9]*,${x}0*E+001,upper,1," t_points.csv || exit 1; done'
check 'tenon: open points carry nothing' csv t_points.csv '
   # the rough law opens below 2.8e-7 MPa, closes above twice that
   if (c["status"] == "open" ? c["pressure"] > 6e-7 : c["pressure"] < 2e-7) fail(c["status"] " " c["pressure"])'
check 'tenon: friction is within mu p' csv t_points.csv '
   t = sqrt(c["shear_1"]^2 + c["shear_2"]^2); if (t > 0.5*c["pressure"]*(1 + 1e-9)) fail(t)'
# rows by face: from the points of the last two steps, the sides both together
faces_of() { # file of points
   awk -F, -v OFS=, -v OFMT=%.17g 'NR > 1 { face = $4 ~ /^side/ ? "sides" : $4; at = $2; key = at "," face "," $1
         if (!(at in seen)) { seen[at] = 1; order[++steps] = at }
         if ($9 > 0 && $10 > most[key]) most[key] = $10
         force[key] += $9*$10; area[key, $6] += $9; there[key] = 1 }
      END { split("upper lower sides", faces, " "); split("hard rough", models, " ")
         for (i = 3; i <= 4; i++) for (j = 1; j <= 3; j++) for (k = 1; k <= 2; k++) {
            key = order[i] "," faces[j] "," models[k]
            print faces[j], models[k], most[key], force[key], area[key, "open"] + 0, area[key, "stick"] + 0,
               area[key, "slip"] + 0 } }' "$1"
}
faces_of t_points.csv >faces.csv
check 'tenon: rows of two steps, three faces and two models' test "$(rows faces.csv)" -eq 11
i=0
for name in face model largest_pressure normal_force area_open area_stick area_slip; do
   i=$((i + 1))
   check "tenon: $name of each face" awk -F, -v list="$(member faces $name)" -v i=$i '
      BEGIN { gsub(/[" ]/, "", list); n = split(list, x, ",") }
      i < 3 ? x[NR] != $i : (x[NR] - $i)^2 > 1e-12*(1 + $i^2) { print x[NR], $i; bad = 1 }
      END { exit bad || n != NR || n != 12 }' faces.csv
done
check 'tenon: rows of faces are listed' grep -Eq '^ +-48[.]0  lower  rough  +[0-9.]+  +[0-9.]+' out
run tenon "${small[@]}" --side-pressure 0 --shoulders --json -
check 'tenon: shoulders have rows, sides without pressure none' sh -c '
   grep "^\"face\"" out | grep "upper_shoulder.*lower_shoulder" | grep -v sides'
run tenon "${small[@]}" --record 3,20 --points - --csv t2.csv
check 'tenon: points of steps asked for' \
   sh -c 'test "$(cut -d, -f2 out | sed 1d | sort -n -u | tr "\n" " ")" = "3 20 "'
check 'tenon: which changes no result' cmp t.csv t2.csv

# A recorded history, and the programme as one, are the same joint
csv_column t.csv displacement | sed -n '2,57p' | sed '1i displacement\nmm' >way.csv
run tenon "${small[@]}" --history way.csv --csv t3.csv
check 'tenon: a history' test "$status" -eq 0
check 'tenon: a history takes the place of amplitudes in the listing' \
   sh -c '! grep -E "^  (amplitudes|cycles) " out && grep -q "^  history  *way.csv" out'
run tenon "${small[@]}" --history way.csv --json -
check 'tenon: and in JSON' lacks out '"amplitudes": \['
run tenon --arm 100 --history way.csv "${small[@]:2}"
check 'tenon: nor are they checked against the arm then' test "$status" -eq 0
run tenon "${small[@]}" --clearance-above 0.4 --clearance-below 0.6
check 'tenon: a clearance that nothing follows is not listed' \
   sh -c '! grep "^  clearance " out && grep -q "^  clearance_above  *0.4 mm" out && grep -q "^  clearance_below  *0.6 mm" out'
run tenon "${small[@]}" --clearance-above 0.4
check 'tenon: one that is followed is' \
   sh -c 'grep -q "^  clearance  *0.5 mm  *default" out && grep -q "^  clearance_below  *0.5 mm  *as clearance" out'
check 'tenon: what does not act is not listed' \
   sh -c '! grep -E "^  (shoulder_height|shoulder_gap|shoulder_points|axial_force|displacement_column) " out'
check 'tenon: a history gives the same forces' \
   sh -c 'cut -d, -f1,2,4-31 t.csv >a; cut -d, -f1,2,4-31 t3.csv >b; cmp a b'

run tenon "${small[@]}" --through uinter --csv t4.csv
check 'tenon: through UINTER' test "$status" -eq 0
# The compiled law is within 1e-10; a joint amplifies that little
check 'tenon: through UINTER it is the same joint' sh -c '
   cut -d, -f1,7 t.csv >a; cut -d, -f7 t4.csv | paste -d, a - | awk -F, "NR > 1 {
      d = \$2 - \$3; if (d*d > 1e-8) { print; exit 1 } }"'

# A limit that UINTER warns of is told of the joint, not of an interaction and a node
run tenon "${small[@]}" --through uinter --yield-factor 0.1
check 'tenon: a limit is told by rows' grep -q 'yield_factor below 2/sqrt(plastic_ratio): .*, the first is row' out
check 'tenon: and by no node of a host' lacks out 'INTERACTION|NODE [0-9]'
check 'tenon: nor on standard error' lacks err 'INTERACTION|NODE [0-9]'

# Sizes that follow from the height, to the bit, and where they come from
run tenon "${small[@]}" --height 180 --csv follows.csv
check 'tenon: a depth says what it follows from' sh -c '
   grep -q "^  bearing_depth  *90.0 mm  *half of height$" out && grep -q "^  column_depth  *90.0 mm  *half of height$" out \
      && grep -q "^  extension  *36.0 mm  *a fifth of height$" out'
run tenon "${small[@]}" --height 180 --bearing-depth 90 --column-depth 90 --extension 36 --csv named.csv
check 'tenon: sizes that follow are those sizes' cmp follows.csv named.csv
run tenon "${small[@]}" --sweep height=180,300 --csv heights.csv
check 'sweep: sizes follow in every case' csv heights.csv '
   if (NR == 3 && sprintf("%.2f", c["ultimate_moment_hard"]) != a) fail(a)' -v a="$least"

# Wood: what the replay does not take changes nothing, and is not listed
run tenon "${small[@]}" --csv larch.csv
for criterion in mises hill crushing; do
   run tenon "${small[@]}" --criterion $criterion --young-modulus-t 500 --shear-modulus-lr 300 --shear-strength-lr 3 \
      --tension-strength-l 60 --hardening-curve 0,4.7,1,9 --csv other.csv
   check "tenon: no other wood with $criterion" cmp larch.csv other.csv
   check "tenon: that $criterion acts is not said" lacks out '^  (criterion|young_modulus_t|shear_|tension_|hardening_curve)'
done
run tenon "${small[@]}" --criterion none --csv elastic.csv
check 'tenon: elastic wood' sh -c 'grep -q "^  criterion  *none  *--criterion$" out && ! grep -E "^  (compression|hardening)" out'
check 'tenon: elastic wood is not crushed' csv elastic.csv \
   'if (NR > 2 && c["plastic_dissipation"] != 0) fail(c["plastic_dissipation"])'
run tenon "${small[@]}" --column rigid --csv rigid.csv
check 'tenon: of a rigid column no wood is listed' lacks out '_modulus_l|_strength_l|hardening_along|column_depth'
check 'tenon: a rigid column is stiffer' sh -c '! cmp -s larch.csv rigid.csv'

# Warnings and failures
run tenon --axial-rule free --side-pressure 0.05 --amplitudes 24 --cycles 10 --face-points 40 \
   --displacement-increment 2
check 'tenon: pull-out beyond a quarter is warned of' \
   has out 'more than a quarter of its length'
run tenon --axial-rule free --side-pressure 0 --amplitudes 24 --cycles 30 --face-points 40 \
   --displacement-increment 2 --csv never.csv
check 'tenon: pull-out beyond a half is an error of its step' is_refused 1 \
   'step [0-9]+, displacement .* more than half its length.*asperity tenon failed_step.nml replays it'
cp err first_err
check 'tenon: no results then' absent never.csv
run tenon failed_step.nml
check 'tenon: the step that failed fails again' sh -c '
   sed "s/; asperity tenon.*//" first_err >a; sed "s/; asperity tenon.*//" err >b; cmp a b'
rm -f failed_step.*

refuses 'tenon: no length' 2 '--length: length = 0.0 is not allowed' tenon --length 0
refuses 'tenon: negative width' 2 '--width: width = -1.0 is not' tenon --width -1
refuses 'tenon: negative clearance' 2 '--clearance: clearance_above = -1.0 mm is not' \
   tenon --clearance -1
refuses 'tenon: arm inside the column' 2 '--arm: arm = 100.0 mm .* inside the column' \
   tenon --arm 100 --arm-datum column_axis
refuses 'tenon: force on an open joint' 2 '--axial-force: axial_force = 9.0 N has no equilibrium' \
   tenon --axial-rule force --axial-force 9 --side-pressure 0
refuses 'tenon: force of another rule' 2 '--axial-force: axial_force needs axial_rule = force' \
   tenon --axial-force 9
refuses 'tenon: amplitude zero' 2 '--amplitudes: amplitudes = 0.0 is not' tenon --amplitudes 0,1
refuses 'tenon: amplitudes out of order' 2 '--amplitudes: .* out of order' tenon --amplitudes 2,1
refuses 'tenon: cycles of other amplitudes' 2 '--cycles: cycles has 1 entries' \
   tenon --amplitudes 1,2 --cycles 3
refuses 'tenon: half a cycle' 2 '--cycles: cycles = 1.5 is not allowed: whole' \
   tenon --amplitudes 1 --cycles 1.5
refuses 'tenon: no cycle' 2 '--cycles: cycles = 0 is not allowed' tenon --amplitudes 1 --cycles 0
refuses 'tenon: no points' 2 '--face-points: face_points = 0.0 is not' tenon --face-points 0
refuses 'tenon: unknown side pair' 2 "--side-pair: side_pair = 'foo' is unknown" \
   tenon --side-pair foo
refuses 'tenon: negative friction of the sides' 2 '--side-friction: side_friction = -1.0 is not' \
   tenon --side-friction -1
refuses 'tenon: no elastic slip of the sides' 2 '--side-critical-slip: side_critical_slip = 0.0' \
   tenon --side-critical-slip 0
refuses 'tenon: unknown rule' 2 "--axial-rule: .* is unknown; known: spring, fixed" \
   tenon --axial-rule loose
refuses 'tenon: step that is not there' 2 '--record: record = 999 is not allowed: the programme' \
   tenon "${small[@]}" --record 9,999
refuses 'tenon: steps out of order' 2 '--record: record = 3 is out of order' tenon --record 9,3
refuses 'tenon: history is missing' 3 'no.csv: cannot be read: No such file' \
   tenon --history no.csv
sed '5s/.*/abc/' way.csv >bad.csv
refuses 'tenon: history with text' 2 'bad.csv:5: .*abc.* is not a finite number' \
   tenon --history bad.csv
sed '5s/.*/700/' way.csv >bad.csv
refuses 'tenon: history too far' 2 'bad.csv: displacement = 700.0 mm is a rotation of 1.4 rad' \
   tenon --history bad.csv
# Every size in metres, and what else looks like another unit. The reasons are in src/replay/sizes.f90
refuses 'tenon: a joint in metres' 2 \
   '--length: length = 0.25 mm is outside 5.0 to 4000.0 mm: 0.25 looks like metres, write 250.0; accept_sizes lets it pass$' \
   tenon --length 0.25 --height 0.18 --width 0.06 --clearance 0.001
refuses 'tenon: height in metres' 2 '--height: height = 0.18 mm .* metres, write 180.0' \
   tenon --length 250 --height 0.18
refuses 'tenon: clearance in metres' 2 \
   '--clearance: clearance_above = 0.001 mm is outside 0.01 to 9.0 mm: 0.001 looks like metres, write 1.0' \
   tenon --clearance 0.001
refuses 'tenon: clearance in micrometres' 2 '--clearance: .* = 200.0 mm .* micrometres, write 0.2' \
   tenon --clearance 200
refuses 'tenon: clearance for that height' 2 '--clearance: .* = 8.0 mm is outside 0.01 to 6.0 mm' \
   tenon --clearance 8 --height 60
refuses 'tenon: arm in metres' 2 '--arm: arm = 0.5 mm .* metres, write 500.0' tenon --arm 0.5
refuses 'tenon: pressure in kPa' 2 '--side-pressure: .* = 200.0 MPa .* kPa, write 0.2' \
   tenon --side-pressure 200
for key in young_modulus_{l,r} compression_strength_{l,r}; do
   refuses "tenon: $key in Pa" 2 "--${key//_/-}: $key = .* looks like Pa, write 50.0" tenon --${key//_/-} 5e7
   refuses "tenon: negative $key" 2 "--${key//_/-}: $key = -1.0 is not" tenon --${key//_/-} -1
done
for key in hardening_along hardening_across; do
   refuses "tenon: negative $key" 2 "--${key//_/-}: $key = -0.1 is not" tenon --${key//_/-} -0.1
done
refuses 'tenon: unknown column' 2 '--column: .* known: elastic, rigid' tenon --column stiff
while read -r before now; do
   printf '&asperity\n %s = 1.0\n/\n' "$before" >before.nml
   refuses "tenon: $before has another name now" 2 "before.nml:2: unknown key '$before'; did you mean $now" tenon before.nml
   refuses "tenon: --${before//_/-} too" 2 "--${before//_/-}: unknown option of tenon; did you mean --${now//_/-}" \
      tenon --${before//_/-} 1
done <<'KEYS'
bearing_modulus young_modulus_r
bearing_strength compression_strength_r
hardening hardening_across
column_modulus young_modulus_l
column_strength compression_strength_l
column_hardening hardening_along
KEYS
refuses 'tenon: elastic slip of the sides in micrometres' 2 \
   '--side-critical-slip: side_critical_slip = 310.0 mm .* looks like um' tenon --side-critical-slip 310
refuses 'tenon: amplitudes in metres' 2 '--amplitudes: amplitudes = 0.048 mm is a rotation of .* metres, write 48.0' \
   tenon --amplitudes 0.0005,0.048
awk 'NR > 2 { $0 = $0/1000 } 1' way.csv >metres.csv
refuses 'tenon: a history in metres' 2 \
   'metres.csv: displacement = -?0.024 mm is a rotation of .* 0.024 looks like metres, write -?24.0, or like a rotation in rad' \
   tenon --history metres.csv
awk 'NR > 2 { $0 = $0*1000 } 1' way.csv >micrometres.csv
refuses 'tenon: a history in micrometres' 2 'micrometres.csv: .* looks like micrometres, write -?24.0$' \
   tenon --history micrometres.csv
printf 'displacement\nmm\n0\n400\n0\n' >far.csv
refuses 'tenon: a rotation of 0.8 rad' 2 \
   'far.csv: displacement = 400.0 mm is a rotation of 0.8 rad at arm = 500.0 mm, outside 0.00026 to 0.25 rad' \
   tenon --history far.csv
run tenon "${small[@]}" --clearance 9.5 --accept-sizes
check 'tenon: a size that is accepted' is_quiet
run tenon "${small[@]}" --clearance 9 --csv large.csv
check 'tenon: the largest clearance' test "$status" -eq 0
refuses 'tenon: history without that column' 2 "--displacement-column: way.csv: there is no column 'drift'; its columns are 1 'displacement' in mm" \
   tenon --history way.csv --displacement-column drift

# An interrupt leaves nothing; a programme of 1e5 steps takes minutes
timeout -k 60 -s INT 1 "$program" tenon --displacement-increment 0.016 --csv int.csv --points int_p.csv \
   >out 2>err
status=$?
check 'tenon: interrupt ends the program' test "$status" -eq 124
check 'tenon: interrupt leaves no file' sh -c '! ls int* failed_step* 2>/dev/null'

# No contact: of one model alone, of the faces while the sides rub, of the whole joint
quiet=(--side-pressure 0 --face-points 40 --displacement-increment 0.1)
run tenon "${quiet[@]}" --amplitudes 1.2 --csv one_touches.csv --json one_touches.json
check 'tenon: hard contact touches nothing' sh -c '
   grep -q "^hard contact: the faces touch in no step, and there is no moment$" out && ! grep "^rough law: the faces" out'
check 'tenon: then nothing is formed from its moments' sh -c '
   sed -n "/^\"summary\"/,/^}/p" one_touches.json | grep -q "^\"ultimate_to_hard\": \[null, null\]" \
      && sed -n "/^\"cycles\"/,/^}/p" one_touches.json | grep -q "^\"damping_hard\": \[null\]"'
check 'tenon: the rough law has its moment' sh -c '
   sed -n "/^\"summary\"/,/^}/p" one_touches.json | grep -q "^\"ultimate_moment\": \[null, -[0-9]"'
check 'tenon: no number out of round-off' lacks one_touches.json '[Nn]a[Nn]|[Ii]nf|E\+30[0-9]'
run tenon "${full[@]}" --clearance 9 --amplitudes 8
check 'tenon: the sides alone, said' sh -c '
   test "$(grep -c ": the faces touch in no step, so that all moment is friction of the sides$" out)" -eq 2 \
      && grep -q "^Validity: the faces touch in no step, so that the law was not used" out'
refuses 'tenon: no contact at all' 2 \
   '--amplitudes: amplitudes up to 8.0 mm move the joint within its clearance: neither hard nor rough' \
   tenon "${full[@]}" --clearance 9 --amplitudes 8 --side-pressure 0
run tenon "${quiet[@]}" --amplitudes 1.2 --sweep clearance=0.5,5 --csv untouched.csv
check 'sweep: no contact is an outcome' sh -c '
   sed -n 2p untouched.csv | grep -q "done: the faces of hard contact touch in no step$" \
      && sed -n 3p untouched.csv | grep -q "neither hard nor rough contact carries a moment"'

# Sweeps
sweep=(--sweep friction-coefficient=0.3:0.5:2 --sweep gap=mean_plane,first_touch)
run tenon "${small[@]}" "${sweep[@]}" --csv sweep.csv
check 'sweep' is_quiet
check 'sweep: a row for each combination' test "$(rows sweep.csv)" -eq 4
check 'sweep: columns' sh -c 'head -n 1 sweep.csv | grep -q "^case,friction_coefficient,gap,yield_moment_hard (kN m),"'
check 'sweep: units' test "$(units_of sweep.csv gap ultimate_moment_rough bending_stiffness_hard loop_energy_hard \
   friction_dissipation_rough ultimate_moment_ratio)" = 'kN m,kN m/rad,J,J,'
check 'sweep: ratio' csv sweep.csv '
   if (c["outcome"] != "done") fail(c["outcome"])
   if (far(c["ultimate_moment_rough"]/c["ultimate_moment_hard"], c["ultimate_moment_ratio"], 1e-14)) fail("ratio")'
check 'sweep: no partial file stays' absent sweep.csv.partial
check 'sweep: what is swept has no value in the listing' \
   sh -c '! grep -E "^  (friction_coefficient|side_friction|gap) " out && grep -q "^  clearance  *0.5 mm" out'
run tenon "${small[@]}" --sweep clearance=0.2,0.4 --sweep pair=transverse-tangential,tangential-tangential
check 'sweep: nor has what follows from it' \
   sh -c '! grep -E "^  (clearance|clearance_above|clearance_below|pair|sigma|eta|initial_separation) " out'
# No more threads than cases: a slow sweep of two cases, looked at while it runs
if [ -r /proc/self/status ]; then
   OMP_NUM_THREADS=16 OPENBLAS_NUM_THREADS=1 "$program" tenon --displacement-increment 0.1 \
      --sweep gap=mean_plane,first_touch >/dev/null 2>&1 &
   other=$!
   most=0
   while state=$(sed -n 's/^Threads:[^0-9]*//p' "/proc/$other/status" 2>/dev/null) && [ -n "$state" ]; do
      [ "$state" -gt "$most" ] && most=$state
      [ "$most" -ge 2 ] && [ "$((looks = ${looks:-0} + 1))" -gt 10 ] && break
      sleep 0.02
   done
   kill "$other" 2>/dev/null
   wait "$other" 2>/dev/null
   check 'sweep: no more threads than cases' test "$most" -le 2 -a "$most" -ge 1
else
   skip 'sweep: threads' 'no /proc'
fi
run tenon "${small[@]}" --friction-coefficient 0.5 --gap first_touch --json one.json
check 'sweep: a row is the run of its own' awk -F, -v a="$(sed -n '/^"summary"/,/^}/p' one.json \
   | sed -n 's/^"ultimate_moment": \[\(.*\)\].*/\1/p')" '
   NR == 5 { split(a, m, ", "); exit !(m[1] == $5 && m[2] == $12) }' sweep.csv
OMP_NUM_THREADS=1 run tenon "${small[@]}" "${sweep[@]}" --csv serial.csv
check 'sweep: threads change nothing' cmp sweep.csv serial.csv
# What a killed run leaves: the head, some rows in any order, and a piece of one
longer=(--amplitudes 4,24 --face-points 40 --side-points 4 --displacement-increment 0.5
   --sweep friction-coefficient=0.3:0.5:6 --sweep gap=mean_plane,first_touch)
run tenon "${longer[@]}" --csv keep.csv
"$program" tenon "${longer[@]}" --csv again.csv >/dev/null 2>&1 &
other=$!
for i in $(seq 200); do
   [ "$(grep -c '^[0-9]' again.csv.partial 2>/dev/null)" -ge 2 ] 2>/dev/null && break
   sleep 0.02
done
kill -KILL "$other" 2>/dev/null
wait "$other" 2>/dev/null
if [ -e again.csv.partial ]; then
   check 'sweep: a killed run leaves no result' absent again.csv
   printf '3,5.0000' >>again.csv.partial
   run tenon "${small[@]}" --sweep gap=mean_plane,first_touch --csv again.csv
   check 'sweep: the partial file of another sweep' is_refused 2 \
      'again.csv.partial: is of another sweep; remove it'
   sed 's/, version .*/, version 0.0.1/' again.csv.partial >old.csv.partial
   run tenon "${longer[@]}" --csv old.csv
   check 'sweep: the partial file of another version' is_refused 2 \
      'old.csv.partial: was begun by another version; remove it'
   rm old.csv.partial
   run tenon "${longer[@]}" --csv again.csv
   check 'sweep: it goes on' grep -q '^[0-9]* of 12 cases were taken from again.csv.partial' out
   check 'sweep: to the same results' cmp keep.csv again.csv
   check 'sweep: and its partial file is gone' absent again.csv.partial
else
   skip 'sweep: restart' 'the run was over before it could be killed'
fi
# A record may go too far for the arm that is swept, not for one of the sweep
printf 'displacement\n0\n150\n-150\n0\n' >wide.csv
run tenon "${full[@]}" --history wide.csv --sweep arm=500,1000 --csv arms.csv
check 'sweep: a record within reach of its arm' sh -c '
   sed -n 2p arms.csv | grep -q "displacement = 150.0 mm is a rotation of 0.3 rad" && sed -n 3p arms.csv | grep -q ",done$"'
# A record that changes below its name makes another sweep; the same displacements do not
stopped() { # NAME HISTORY: a partial file with some of the rows
   printf 'displacement\n0\n%s\n-%s\n0\n' "$2" "$2" >changes.csv
   "$program" tenon "${full[@]}" --history changes.csv --sweep friction_coefficient=0.1:0.9:40 --csv "$1" \
      >/dev/null 2>&1 &
   other=$!
   for i in $(seq 500); do
      [ "$(grep -c '^[0-9]' "$1.partial" 2>/dev/null)" -ge 4 ] 2>/dev/null && break
      sleep 0.02
   done
   kill -KILL "$other" 2>/dev/null
   wait "$other" 2>/dev/null
   [ -e "$1.partial" ]
}
history=("${full[@]}" --history changes.csv --sweep friction_coefficient=0.1:0.9:40)
if stopped resumed.csv 8; then
   cp resumed.csv.partial kept
   printf 'displacement\n0\n24\n-24\n0\n' >changes.csv
   run tenon "${history[@]}" --csv resumed.csv
   check 'sweep: a history that has changed' is_refused 2 \
      'resumed.csv.partial: changes.csv has changed since it was begun; remove it, or name another file'
   check 'sweep: no row of another history is written' sh -c 'test ! -e resumed.csv && cmp kept resumed.csv.partial'
   printf 'displacement\n"0.0"\n8.00\n-8e0\n0\n' >changes.csv
   run tenon "${history[@]}" --csv resumed.csv
   check 'sweep: one with the same displacements' grep -q 'of 40 cases were taken from resumed.csv.partial' out
   run tenon "${history[@]}" --csv anew.csv
   check 'sweep: to the results of one run' cmp resumed.csv anew.csv
else
   skip 'sweep: a history that changes' 'the run was over before it could be killed'
fi
run tenon "${small[@]}" --sweep clearance=0.2,-1,0.4 --csv some.csv
check 'sweep: a case that fails says so in its row' sh -c '
   test "$(wc -l <some.csv)" -eq 4 && sed -n 3p some.csv | grep -q "clearance_above = -1.0 mm is not" \
      && sed -n 4p some.csv | grep -q ",done$"'
refuses 'sweep: unknown key' 2 "--sweep: unknown key 'clearnce'; did you mean clearance" \
   tenon --sweep clearnce=0,1
refuses 'sweep: a list' 2 '--sweep: amplitudes cannot be swept' tenon --sweep amplitudes=1,2
refuses 'sweep: no values' 2 '--sweep: the list is empty' tenon --sweep clearance=
refuses 'sweep: no name' 2 "--sweep: 'clearance' is not NAME=values" tenon --sweep clearance
refuses 'sweep: text for a number' 2 "--sweep clearance=a: clearance = 'a' is not a finite" \
   tenon --sweep clearance=a
refuses 'sweep: an unknown choice' 2 "--sweep gap=x: gap = 'x' is unknown" tenon --sweep gap=x
refuses 'sweep: a fraction of a point' 2 '--sweep face_points=1.5: .* not a whole number' \
   tenon --sweep face-points=1:2:3
refuses 'sweep: twice the same' 2 '--sweep: clearance is swept twice' \
   tenon --sweep clearance=0,1 --sweep clearance=2,3
refuses 'sweep: too many' 2 '--sweep: more than 100000 combinations' \
   tenon --sweep clearance=0:1:1000 --sweep length=200:300:1000
refuses 'sweep: no picture' 2 '--plot: is for one run, not for --sweep' \
   tenon --sweep clearance=0,1 --plot x.svg

# The page and the sheet of pictures
refuses 'report on standard output' 2 '--report: - must end in .html' tenon --report -
refuses 'report of another kind' 2 '--report: x.pdf must end in .html' tenon --report x.pdf
if command -v gnuplot >/dev/null; then
   run tenon "${small[@]}" --report r.html --plot r.svg --csv r.csv
   check 'report' is_quiet
   check 'report: complete' sh -c 'tail -n 1 r.html | grep -q "^</body></html>$" && head -n 1 r.html | grep -q "^<!DOCTYPE html>"'
   check 'report: all pictures' test "$(grep -c '</svg>' r.html)" -eq 12
   check 'report: every picture draws' sh -c 'test "$(grep -c "title>" r.html)" -gt 30'
   # names of namespaces are no addresses that anything loads
   check 'report: needs nothing else' sh -c '
      ! sed "s/xmlns[:a-z]*=\"[^\"]*\"//g" r.html | grep -E "https?://|src=|@import|url\([^#]|<script|<link"'
   check 'report: no name twice' sh -c \
      'test -z "$(grep -o " id=[\"'"'"'][^\"'"'"']*[\"'"'"']" r.html | sort | uniq -d)"'
   check 'report: what was chosen' has r.html 'chosen: '
   check 'report: of another programme no published figures' \
      lacks r.html 'test, paper|-17\.91|As Table 5|The paper reports|compared with Table 5|own figures'
   run tenon "${full[@]}" --report paper.html
   check 'report: published and computed figures' sh -c 'grep -q ">-17.91<" paper.html && grep -q "rough law, this model" paper.html'
   check 'report: what cannot be compared' has paper.html 'cannot be compared with Table 5'
   if command -v python3 >/dev/null; then
      check 'report: elements are closed' python3 -c '
import html.parser, sys
class Page(html.parser.HTMLParser):
    open = []
    def handle_starttag(self, tag, attributes):
        if tag not in ("meta", "br"): self.open.append(tag)
    def handle_endtag(self, tag):
        if self.open.pop() != tag: sys.exit("not closed before " + tag)
page = Page()
page.feed(open("r.html", encoding="utf-8").read())
sys.exit(str(page.open) if page.open else 0)'
   fi
   check 'sheet: SVG' sh -c "tail -n 3 r.svg | grep -q '^</svg>'"
   run tenon "${small[@]}" --plot r.png
   check 'sheet: PNG' sh -c 'head -c 4 r.png | grep -q PNG'
   check 'report: no temporary file stays' sh -c '! ls *.part 2>/dev/null'
   refuses 'report of a joint that touches nothing' 2 \
      '--amplitudes: amplitudes up to 0.3 mm .* within its clearance: neither hard nor rough contact carries' \
      tenon --amplitudes 0.3 --side-pressure 0 --report gone.html
   mkdir taken.csv
   refuses 'report beside an output that fails' 3 '--csv: taken.csv cannot be written' \
      tenon "${small[@]}" --report gone.html --csv taken.csv
   check 'report: not written then' absent gone.html
   rmdir taken.csv
else
   skip 'report' 'no gnuplot'
fi

# With memory: what the summits dissipate is in the ledgers, and every point through UINTER is the same
memory=("${small[@]}" --unloading elastic)
run tenon "${memory[@]}" --csv m.csv --json m.json
check 'tenon, memory' is_quiet
check 'tenon, memory: columns' test "$(columns m.csv)" = \
   "${header/plastic_dissipation,/plastic_dissipation,plastic_dissipation_faces,}"
check 'tenon, memory: JSON holds the same figures' same_csv_and_json m.csv m.json
check 'tenon, memory: summits yield under the rough law alone' csv m.csv '
   f = "plastic_dissipation_faces"
   if (c["model"] == "hard" && c[f]*1 != 0) fail("hard")
   if (c["model"] == before["model"] && c[f] < before[f]) fail("falls")
   if (NR == 115 && !(c[f] > 1 && c[f] < 10)) fail(c[f])'
check 'tenon, memory: hard contact does not change' test "$(grep '^hard' t.csv | cut -d, -f2-17 | cksum)" = \
   "$(grep '^hard' m.csv | cut -d, -f2-17 | cksum)"
check 'tenon, memory: totals' test "$(of_json m.json totals plastic_dissipation_faces | tail -n 1)" = \
   "$(csv_column m.csv plastic_dissipation_faces | tail -n 1)"
run tenon "${memory[@]}" --through uinter --csv u.csv
paste -d, <(csv_column m.csv moment) <(csv_column u.csv moment) <(csv_column m.csv plastic_dissipation_faces) \
   <(csv_column u.csv plastic_dissipation_faces) >both
check 'tenon, memory: through UINTER' awk -F, '
   { if (($1 - $2)^2 > 1e-14 || ($3 - $4)^2 > 1e-14) { print; exit 1 } }' both
refuses 'tenon: elastic unloading below its yield factor' 2 '--yield-factor: yield_factor = 0.15 is not allowed with elastic' \
   tenon "${memory[@]}" --yield-factor 0.15
