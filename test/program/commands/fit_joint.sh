# asperity fit --kind joint: the records of examples/fit, and what is refused

examples=$root/examples/fit
cat >small.nml <<'TEXT'
&asperity
  pair = 'transverse-tangential'
  wood = 'larch'
  length = 120.0
  height = 150.0
  width = 60.0
  arm = 600.0
  clearance = 0.4
  side_pressure = 0.3
  axial_stiffness = 500.0
  face_points = 10
  side_points = 2
  displacement_increment = 2.0
  amplitudes = 10.0, 20.0
/
TEXT
run tenon small.nml --csv small.csv
fit=(fit --kind joint --model small.nml --where model=rough --searches 1)

# Without noise the numbers come back from starts far off; clearance_above follows the clearance
run "${fit[@]}" small.csv --free clearance,side_pressure --start clearance=2,side_pressure=0.04 --case found.nml \
   --csv curve.csv --json fit.json
check 'fit joint' is_quiet
check 'fit joint: clearance' has_nearly found.nml clearance 0.4 1e-4
check 'fit joint: side pressure' has_nearly found.nml side_pressure 0.3 1e-4
check 'fit joint: clearance above follows' grep -q '^  ! clearance_above: as clearance' found.nml
check 'fit joint: model beside record' csv curve.csv '
   if (abs(c["force"] - c["model_force"]) > 1) fail(c["force"])'
run tenon found.nml --csv found.csv
check 'fit joint: the case replays' is_quiet
check 'fit joint: as the record' test "$(rows found.csv)" -eq "$(rows small.csv)"

# Rotation and moment are the same record; so are cm and kN
run fit --kind joint --model small.nml --where model=rough --searches 1 small.csv --free clearance,side_pressure \
   --displacement-column rotation --force-column moment --case moment.nml
check 'fit joint: rotation and moment' has_nearly moment.nml clearance 0.4 1e-4
check 'fit joint: rotation and moment, side pressure' has_nearly moment.nml side_pressure 0.3 1e-4

# Threads share the replays, and give the same bits
for threads in 1 2; do
   (export OMP_NUM_THREADS=$threads; run "${fit[@]}" small.csv --free clearance,side_pressure --case $threads.nml)
done
check 'fit joint: the same with two threads' cmp 1.nml 2.nml

# Two records at once, and one that is held out
awk -F, 'NR == 1 { print "displacement (mm),force (kN)" } $1 == "rough" { print $4 "," $6/1000 }' small.csv >a.csv
run tenon small.nml --amplitudes 15 --csv one.csv
awk -F, 'NR == 1 { print "displacement (mm),force (kN)" } $1 == "rough" { print $4 "," $6/1000 }' one.csv >b.csv
cp b.csv kept.csv
run fit --kind joint --model small.nml --searches 1 a.csv b.csv --free clearance,side_pressure --hold-out kept.csv \
   --case both.nml
check 'fit joint: two records' is_quiet
check 'fit joint: two records, clearance' has_nearly both.nml clearance 0.4 1e-3
check 'fit joint: three rows of records' test "$(grep -Ec '^ *([ab]|kept).csv +(yes|no) ' out)" -eq 3

awk -F, 'NR > 1 { OFS = ","; $1 += 5 } { print }' a.csv >offset.csv
run fit --kind joint --model small.nml --searches 1 offset.csv --free side_pressure
check 'fit joint: a zero that is off is said' grep -q 'The record begins at 5.0 mm' out

refuses 'fit joint: what nobody gave' 2 'nothing says pair, length, height, width, arm, side_pressure, axial_stiffness, wood' \
   fit --kind joint a.csv --free clearance
refuses 'fit joint: a text is not free' 2 '--free: wood is no real number' "${fit[@]}" small.csv --free wood
refuses 'fit joint: fixed and free' 2 '--free: clearance is also fixed' "${fit[@]}" small.csv --free clearance --fix clearance=1
refuses 'fit joint: what does nothing' 2 'small.csv|--free: axial_stiffness does nothing' \
   "${fit[@]}" small.csv --free axial_stiffness --fix axial_rule=fixed
refuses 'fit joint: an arm of moments' 2 '--free: the arm makes displacement' "${fit[@]}" small.csv --free arm \
   --displacement-column rotation --force-column moment
refuses 'fit joint: two that do the same' 1 'a.csv: .*(bearing_depth|young_modulus_r)' \
   fit --kind joint --model small.nml --searches 1 --fix column=rigid a.csv \
   --free bearing_depth,young_modulus_r --case none.nml
check 'fit joint: no case of what is not settled' test ! -e none.nml
run press --csv press.csv
refuses 'fit joint: a press record' 2 'press.csv: ' fit --kind joint --model small.nml press.csv --free clearance
run shear --csv shear.csv
refuses 'fit joint: a shear record' 2 'shear.csv: column normal_stress_nominal is that of shear' \
   fit --kind joint --model small.nml shear.csv --free clearance
refuses 'fit joint: hard contact' 2 'small.csv: .*--where model=rough' \
   fit --kind joint --model small.nml small.csv --free clearance
refuses 'fit joint: hard contact alone' 2 'small.csv: .*--where model=rough' \
   fit --kind joint --model small.nml small.csv --free clearance --where model=hard
refuses 'fit joint: a programme is not fixed' 2 '--fix: history cannot be fixed' \
   "${fit[@]}" small.csv --free clearance --fix history=a.csv
# A clearance of zero is no start, but bounds make one
sed 's/^  clearance = 0.4/  clearance = 0.0/' small.nml >closed.nml
refuses 'fit joint: no clearance to begin at' 2 'a.csv: clearance begins at 0.0 .*: bounds must lie below and above' \
   fit --kind joint --model closed.nml --searches 1 a.csv --free clearance
run fit --kind joint --model closed.nml --searches 1 a.csv --free clearance --bounds clearance=0.1:4 --case opened.nml
check 'fit joint: clearance between bounds' has_nearly opened.nml clearance 0.4 1e-3
printf 'displacement (mm),force (N)\n0,0\n0,1\n0,2\n' >still.csv
refuses 'fit joint: it does not move' 2 'still.csv: The record does not move' fit --kind joint --model small.nml still.csv --free clearance
printf 'displacement (mm),force (N)\n0,0\n5,0\n9,0\n' >free.csv
refuses 'fit joint: no force' 2 'free.csv: .*no force' fit --kind joint --model small.nml free.csv --free clearance
refuses 'fit joint: a press record held out' 2 'press.csv: no column is force' \
   fit --kind joint --model small.nml --searches 1 a.csv --free clearance --hold-out press.csv
awk -F, 'NR == 1 { print "rotation (rad),moment (kN m)" } $1 == "rough" { print $5 "," $7 }' small.csv >moment.csv
refuses 'fit joint: other quantities held out' 2 '--hold-out: moment.csv has rotation and moment' \
   fit --kind joint --model small.nml --searches 1 a.csv --free clearance --hold-out moment.csv
refuses 'fit joint: fitted and held out' 2 'a.csv: is given twice' \
   fit --kind joint --model small.nml a.csv --free clearance --hold-out a.csv
refuses 'fit joint: files of two quantities' 2 'moment.csv: has rotation and moment' \
   fit --kind joint --model small.nml --searches 1 a.csv moment.csv --free clearance
