# asperity solid: the joint as a solid, on meshes of a few large elements. What it must fulfil itself
# is tested in the library (test/petsc); here it is what the command makes of it
one=(--mesh-size 100 --contact rough --amplitudes 8)
run solid "${one[@]}" --csv s.csv --json s.json
if grep -q 'PETSc is not installed' err; then
   check 'solid: without PETSc it says what to install' is_refused 1 \
      'PETSc is not installed, .*apt-get install libpetsc-real3.18 .*Nothing else needs it'
   check 'solid: and writes nothing' sh -c '! ls s.csv s.json solid.* 2>/dev/null'
   skip 'solid' 'PETSc is not installed'
   return
fi
check 'solid' is_quiet
check 'solid: nothing stays but what was asked for' test "$(echo *)" = "$(echo all_err check.log err out s.csv s.json)"

faces='upper lower side'
of_faces() { local face; for face in $faces; do printf ',%s_%s' "$1" "$face"; done; }
header=model,increment,stroke,displacement,drift,rotation,force,moment,pull_out,work,stored_energy,\
friction_dissipation,plastic_dissipation,elastic_slip_energy,edge_energy,energy_balance,iterations,\
yielding,plastic_strain$(of_faces normal)$(of_faces largest_pressure)$(of_faces area_stick)\
$(of_faces area_slip)$(of_faces friction_dissipation),validity
check 'solid: columns' test "$(columns s.csv)" = "$header"
check 'solid: JSON holds the same figures' same_csv_and_json s.csv s.json
check 'solid: numbers in full' sh -c '! grep -E "[Nn]a[Nn]|[Ii]nf" s.csv s.json'
units_of() { local name file=$1; shift; for name in "$@"; do csv_unit "$file" "$name"; done | tr '\n' ','; }
check 'solid: units' test "$(units_of s.csv displacement drift force moment work normal_side \
   largest_pressure_side area_slip_side)" = 'mm,rad,N,kN m,J,N,MPa,mm^2,'
check 'solid: one model, three strokes, ten increments each or more' csv s.csv '
   if (c["model"] != "rough") fail(c["model"])
   if (c["increment"] != NR - 1) fail("number")
   n[c["stroke"]]++; if (NR > 31 && (n[1] < 10 || n[2] < 10 || n[3] < 10 || c["stroke"] > 3)) fail("strokes")'
check 'solid: turns of the programme' csv s.csv '
   if (c["stroke"] != before["stroke"] && NR > 2) turns = turns " " before["displacement"]*1
   d = c["displacement"]*1
   if (c["stroke"] == 3 && d*d < 1e-18 && turns != " 8 -8") fail(turns)
   if (d > 8 + 1e-12 || d < -8 - 1e-12) fail(d)'
check 'solid: drift over arm, moment' csv s.csv '
   if (far(c["drift"]*500, c["displacement"], 1e-9)) fail("drift")
   if (far(c["force"]*500, c["moment"]*1e6, 1e-12)) fail("moment")'
check 'solid: friction of the faces adds up, and never falls' csv s.csv '
   f = "friction_dissipation"
   if (far(c[f "_upper"] + c[f "_lower"] + c[f "_side"], c[f], 1e-10)) fail(c[f])
   if (c[f] < before[f] || c["plastic_dissipation"] < before["plastic_dissipation"]) fail("falls")'
check 'solid: work is accounted for' csv s.csv '
   rest = c["work"] - c["stored_energy"] - c["plastic_dissipation"] - c["friction_dissipation"] \
      + c["elastic_slip_energy"] - c["edge_energy"]
   if (far(rest + c["work"], c["energy_balance"] + c["work"], 1e-10)) fail(rest)
   if (c["increment"] > 3 && abs(c["energy_balance"]) > 0.05*c["work"]) fail("balance")'
check 'solid: the first face pressed is the upper one' csv s.csv '
   if (c["stroke"] == 1 && c["displacement"] > 4 && !(c["normal_upper"] > c["normal_lower"])) fail("upper")'

# The case file that is printed is the case
run solid "${one[@]}" --print-case
cp out case.nml
check 'solid: --print-case runs nothing' is_quiet
run solid case.nml --csv again.csv
check 'solid: the printed case is the same joint' cmp s.csv again.csv
run tenon case.nml --print-case
check 'solid: asperity tenon reads it' is_quiet
refuses 'solid: contact of the deck' 2 "case.nml:[0-9]+: contact = 'rough' is unknown; known: uinter, table, hard" \
   deck tenon case.nml
sed "s/contact = .*/contact = 'table'/" case.nml >deck.nml
refuses 'solid: contact of a deck is none of its own' 2 \
   "deck.nml:[0-9]+: contact = 'table' is unknown; known: hard, rough, both" solid deck.nml
run solid --print-case
check 'solid: its keys' sh -c 'for key in contact mesh_size strain contact_cells penalty soft_overclosure \
   stroke_increments tolerance forcing preconditioner most_iterations through criterion; do
   grep -q "^ *!* *$key *[=:]" out || { echo "$key"; exit 1; }; done'
run solid --help
check 'solid: help' sh -c 'for option in mesh-size rim-mesh-size strain contact-cells penalty soft-overclosure \
   stroke-increments tolerance forcing preconditioner most-iterations through criterion checkpoint resume vtk report; do
   grep -Eq -- "^  --(\[no-\])?$option( |$)" out || { echo "$option"; exit 1; }; done'
# UINTER evaluates the law itself, which is compiled here
for through in direct uinter; do
   run solid "${one[@]}" --tolerance 1e-8 --through $through --csv $through.csv
   csv_column $through.csv force >$through
done
check 'solid: through UINTER the same forces' sh -c 'paste -d , direct uinter | awk -F, "{ d = \$1 - \$2
   if (d*d > most) most = d*d; if (\$1*\$1 > peak) peak = \$1*\$1 }
   END { print most, peak; exit !(NR == 30 && most < 1e-14*peak) }"'

# With memory
for through in direct uinter; do
   run solid "${one[@]}" --unloading elastic --through $through --csv $through.csv
   check "solid, memory: $through" is_quiet
   csv_column $through.csv plastic_dissipation_faces >$through
done
check 'solid, memory: columns' test "$(columns direct.csv)" = \
   "${header/plastic_dissipation,/plastic_dissipation,plastic_dissipation_faces,}"
check 'solid, memory: work is accounted for' csv direct.csv '
   f = "plastic_dissipation_faces"
   rest = c["work"] - c["stored_energy"] - c["plastic_dissipation"] - c[f] - c["friction_dissipation"] \
      + c["elastic_slip_energy"] - c["edge_energy"]
   if (far(rest + c["work"], c["energy_balance"] + c["work"], 1e-10)) fail(rest)
   if (c[f] < before[f]) fail("falls")
   if (c["increment"] > 3 && abs(c["energy_balance"]) > 0.05*c["work"]) fail("balance")'
check 'solid, memory: summits yield, through UINTER alike' sh -c 'paste -d , direct uinter | awk -F, "
   { d = \$1 - \$2; if (d*d > most) most = d*d; last = \$1 }
   END { print most, last; exit !(last > 0.1 && most < 1e-8*last*last) }"'

# Both contact models, and every criterion
run solid "${one[@]:0:2}" --amplitudes 8 --csv both.csv
check 'solid: both models' test "$(csv_column both.csv model | uniq | tr '\n' ' ')" = 'hard rough '
sed -n '1p; /^rough/p' both.csv >rough.csv
check 'solid: each as alone' cmp rough.csv s.csv
check 'solid: ratios to hard contact' grep -Eq '^ +rough law, this model +-[0-9.]+ +1[.][0-9]+ ' out
least() { csv_column "$1" force | sort -g | head -n 1; }
for criterion in none mises hill crushing; do
   run solid "${one[@]:0:4}" --amplitudes 16 --criterion $criterion --csv $criterion.csv
   check "solid: $criterion" is_quiet
done
check 'solid: elastic wood does not yield' csv none.csv \
   'if (c["plastic_dissipation"]*1 != 0 || c["plastic_strain"]*1 != 0) fail("yields")'
check 'solid: other wood does, and bears less' sh -c '
   for criterion in '"$(for c in mises hill crushing; do echo "$c=$(least $c.csv)"; done | tr '\n' ' ')"'; do
      awk -v least="${criterion#*=}" -v elastic='"$(least none.csv)"' \
         "BEGIN { exit !(least > 0.99*elastic && least < 0) }" || { echo "$criterion"; exit 1; }
   done'

# Logarithmic strain: at small strains nearly the same joint
run solid "${one[@]}" --strain logarithmic --csv logarithmic.csv
check 'solid: logarithmic strain' is_quiet
csv_column s.csv force >s.force
csv_column logarithmic.csv force >l.force
check 'solid: is nearly engineering strain at 8 mm' sh -c 'paste -d , s.force l.force | awk -F, "{ d = \$1 - \$2
   if (d*d > most) most = d*d; if (\$1*\$1 > peak) peak = \$1*\$1 }
   END { print most, peak; exit !(most > 1e-8*peak && most < 1e-4*peak) }"'
check 'solid: and its work is accounted for' csv logarithmic.csv '
   if (c["increment"] > 3 && abs(c["energy_balance"]) > 0.05*c["work"]) fail("balance")'

# Bad input: named, and nothing half-written
while read -r key value what; do
   refuses "solid: $key" 2 "--${key//_/-}: $key = $value.* $what" solid --mesh-size 100 --amplitudes 8 \
      --${key//_/-} "$value" --csv bad.csv
done <<'KEYS'
contact_cells 0 .*between 1.0 and 10.0
penalty 0 .*above zero
soft_overclosure 2 .*between 0.0 and 1.0 mm
stroke_increments 0 .*between 1.0 and 10000.0
tolerance 1 .*between 1.0E-12 and 0.1
forcing 0.9 .*between 1.0E-12 and 0.5
most_iterations 3 .*between 4.0 and 1000.0
rim_mesh_size 200 larger than mesh_size
axial_rule free .*take spring or fixed
column rigid .*is of wood
column_height 200 .*too small for the mortise
column_width 50 .*too small for the mortise
young_modulus_r 0 .*above zero
KEYS
refuses 'solid: contact' 2 "--contact: contact = 'soft' is unknown; known: hard, rough, both" solid --contact soft
refuses 'solid: strain' 2 "--strain: strain = 'green' is unknown; known: engineering, logarithmic" solid --strain green
refuses 'solid: preconditioner' 2 "--preconditioner: preconditioner = 'ilu' is unknown; known: lu, multigrid" \
   solid --preconditioner ilu
refuses 'solid: through' 2 "--through: through = 'no' is unknown; known: direct, uinter" solid --through no
refuses 'solid: criterion' 2 "--criterion: .* known: none, mises, hill, crushing" solid --criterion tresca
refuses 'solid: mesh of the parts' 2 '--mesh-size: mesh_size = 400.* is larger than the part' solid --mesh-size 400 \
   --accept-sizes
refuses 'solid: mesh too coarse for the indentation' 2 \
   '--mesh-size: mesh_size = 100.0 mm is too coarse for the indentation: at 2.3 mm the tenon meets its faces over' \
   solid --mesh-size 100 --amplitudes 2.3 --side-pressure 0
refuses 'solid: no contact in the programme' 2 \
   '--amplitudes: nothing touches: the largest displacement is 0.5 mm, and the tenon meets its faces at' \
   solid --mesh-size 100 --amplitudes 0.5 --side-pressure 0
refuses 'solid: shoulders' 2 '--shoulders: ' solid --shoulders
refuses 'solid: option of another command' 2 '--points: is an option of tenon, not of solid' solid --points p.csv
refuses 'solid: no folder for results' 3 '--csv: nowhere/s.csv cannot be written: ' solid --mesh-size 100 --csv nowhere/s.csv
refuses 'solid: no folder for checkpoints' 3 '--checkpoint: nowhere/j.rough.checkpoint cannot be written: ' \
   solid "${one[@]}" --checkpoint nowhere/j
check 'solid: nothing half-written' sh -c '! ls bad* solid.* 2>/dev/null'

ASPERITY_PETSC=$work/libpetsc.so refuses 'solid: a PETSc that is not there' 2 \
   "environment variable ASPERITY_PETSC = $work/libpetsc.so is no library that can be loaded" solid "${one[@]}"

# What cannot be solved, at rest and in a stroke
refuses 'solid: no equilibrium at rest' 1 'the joint at rest has no equilibrium \(fit of the sides\): ' \
   solid --mesh-size 100 --contact hard --penalty 1e12 --amplitudes 8
check 'solid: nothing to go on from' sh -c '! ls solid.* 2>/dev/null'
# Hard increments get shorter, and no shorter than the shortest
refuses 'solid: few iterations allowed' 1 'no increment is small enough in stroke 1 from 0.0 to 8.0 mm, at ' \
   solid --mesh-size 60 --contact rough --amplitudes 8 --side-pressure 0 --column-load 0 --most-iterations 4 \
   --tolerance 1e-8 --forcing 0.5
rm -f solid.rough.checkpoint failed_point.*
refuses 'solid: no equilibrium in a stroke' 1 'no increment is small enough in stroke 2 from 8.0 to -8.0 mm, at '\
'-?[0-9.]+ mm: .*It begins again from solid.hard.checkpoint with --resume$' \
   solid --mesh-size 100 --contact hard --penalty 1e9 --amplitudes 8 --csv bad.csv
check 'solid: its checkpoint stays, and no result' sh -c 'test -f solid.hard.checkpoint && ! ls bad* *.part 2>/dev/null'
refuses 'solid: that checkpoint is not written over' 2 \
   'solid.hard.checkpoint is there, .* go on from it with --resume, remove it, or name others with --checkpoint' \
   solid --mesh-size 100 --amplitudes 8
refuses 'solid: another case does not go on from it' 2 \
   'checkpoint solid.hard.checkpoint is of another case or version: run that one, or remove the file' \
   solid --mesh-size 100 --contact hard --amplitudes 8 --resume
refuses 'solid: nor does the same one with memory' 2 \
   'checkpoint solid.hard.checkpoint is of another case or version' \
   solid --mesh-size 100 --contact hard --penalty 1e9 --amplitudes 8 --unloading elastic --resume
head -c 9000 solid.hard.checkpoint >cut && mv cut solid.hard.checkpoint
refuses 'solid: nor does a piece of it serve' 3 'checkpoint solid.hard.checkpoint cannot be read: it is not complete' \
   solid --mesh-size 100 --contact hard --penalty 1e9 --amplitudes 8 --resume
rm solid.hard.checkpoint
refuses 'solid: --resume without a checkpoint' 2 \
   '--resume: there is no solid.rough.checkpoint: begin without --resume' solid "${one[@]}" --resume

# A point of the rough law that is left behind: friction that grows faster than the pressure, and few
# iterations: with a weaker law rounding decides whether it fails
unstable=(--mesh-size 60 --contact rough --amplitudes 8 --side-pressure 0 --critical-slip 1e-4 \
   --static-friction-coefficient 8 --decay-slip 5e-4 --pressure-exponent 2.9 --reference-pressure 0.1 \
   --most-iterations 5 --accept-unphysical)
run solid "${unstable[@]}" --csv bad.csv
check 'solid: the point at which it fails is kept' is_refused 1 'no increment is small enough in stroke [12] from '\
'[08].0 to -?8.0 mm, at -?[0-9.]+ mm: .*; asperity replay failed_point.nml replays the motion of the point of the '\
'(upper|lower) faces at x, y, z = -?[0-9.]+, [0-9.]+, -?150.* mm. It begins again from solid.rough.checkpoint with --resume$'
run replay failed_point.nml --csv point.csv
check 'solid: and replayed' is_quiet
check 'solid: as it was' sh -c 'cut -d, -f1-4 point.csv | cmp - failed_point.csv'
check 'solid: undeformed at first' csv point.csv '
   if (NR == 2 && (c["slip_1"] != 0 || c["slip_2"] != 0 || c["overclosure"] > 0)) fail("first")'
check 'solid: and pressed on the way' awk -F, 'NR > 1 && $5 > 0.5 { n++ } END { exit n == 0 }' point.csv
rm failed_point.*
run solid "${unstable[@]}" --resume --csv bad.csv
check 'solid: a run that was resumed says that it keeps none' is_refused 1 \
   'no increment is small enough .*; no motion of a point is left \(resumed, or no memory\). It begins again from .*'
check 'solid: and leaves none' sh -c '! ls bad* failed_point.* 2>/dev/null'
rm solid.rough.checkpoint

# A disk that is full keeps the checkpoint before
(trap '' XFSZ; ulimit -f 160; limited "$program" solid "${one[@]}" --csv bad.csv) >out 2>err </dev/null
status=$?
if [ "$status" -ne 0 ] && [ -e solid.rough.checkpoint ]; then
   check 'solid: a full disk' sh -c "test $status -eq 3 && ! ls bad* *.part 2>/dev/null && grep -q \
      '^asperity: error: checkpoint solid.rough.checkpoint cannot be written: ' err"
   run solid "${one[@]}" --resume --csv after.csv
   check 'solid: and the run goes on from it' cmp s.csv after.csv
else
   skip 'solid: full disk' 'sizes of files are not limited here'
fi
rm -f solid.rough.checkpoint

# Killed at a checkpoint, in the first model and in the second one, and taken up again
programme=(--mesh-size 100 --amplitudes 4,16,24 --checkpoint joint)
run solid "${programme[@]}" --csv uncut.csv
for model in hard rough; do
   "$program" solid "${programme[@]}" --csv cut.csv >/dev/null 2>&1 &
   other=$!
   while [ ! -e joint.$model.checkpoint ] && kill -0 "$other" 2>/dev/null; do sleep 0.01; done
   kill -KILL "$other" 2>/dev/null
   wait "$other" 2>/dev/null
   if [ -e joint.$model.checkpoint ]; then
      check "solid: killed in the $model model, no result" absent cut.csv
      run solid "${programme[@]}" --resume --csv cut.csv
      check "solid: it goes on" is_quiet
      check "solid: to the same results, bit for bit" cmp uncut.csv cut.csv
      check "solid: and its checkpoints are gone" sh -c '! ls joint.* 2>/dev/null'
   else
      skip "solid: killed in the $model model" 'the run was over before it could be killed'
   fi
   rm -f cut.csv joint.*
done
