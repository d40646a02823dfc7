# asperity fit --kind shear: records that asperity shear writes, and what is refused

fit=(fit --kind shear --fix diameter=61.8)

# Without noise the numbers come back, wherever the search begins; half of a pass is not settled
run shear --friction-coefficient 0.42 --critical-slip 0.25 --displacement 1,-1 --normal-stress 0.05,0.1,0.2 --csv s.csv
run "${fit[@]}" s.csv --free friction_coefficient,critical_slip --start critical_slip=5,friction_coefficient=10 \
   --csv curve.csv --json fit.json --case found.nml
check 'fit shear' is_quiet
check 'fit shear: mu' has_nearly found.nml friction_coefficient 0.42 1e-6
check 'fit shear: gcrit' has_nearly found.nml critical_slip 0.25 1e-6
check 'fit shear: three normal stresses' grep -q '^  normal_stress = 0.05, 0.1, 0.2 ' found.nml
check 'fit shear: model beside record' csv curve.csv '
   if (abs(c["shear_force"] - c["model_shear_force"]) > 1e-3) fail(c["shear_force"])'
check 'fit shear: every row of the record' test "$(rows curve.csv)" -eq "$(rows s.csv)"
run shear found.nml
check 'fit shear: the case runs' is_quiet
check 'fit shear: the case runs with what was found' grep -Eq '^ *friction_coefficient +0\.42[0 ]+found\.nml:' out
run "${fit[@]}" s.csv --free friction_coefficient,critical_slip --where normal_stress_nominal=0.1 --fix diameter=61.8
check 'fit shear: one fix' is_refused 2 '--fix: is given twice'

# Stresses need no size, and units are those of the column
awk -F, 'NR == 1 { print "normal_stress (kPa),displacement (um),shear_stress (kPa)"; next }
   { printf "%g,%.17g,%.17g\n", 1000*$1, 1000*$3, 1000*$11 }' s.csv >kpa.csv
refuses 'fit shear: which of two stresses' 2 'kpa.csv: columns 1 and 3 may both be pressure: choose with --force-column' \
   fit --kind shear kpa.csv --free friction_coefficient,critical_slip
run fit --kind shear kpa.csv --force-column shear_stress --free friction_coefficient,critical_slip --case kpa.nml
check 'fit shear: kPa and um' has_nearly kpa.nml friction_coefficient 0.42 1e-6
check 'fit shear: kPa and um, gcrit' has_nearly kpa.nml critical_slip 0.25 1e-6

# Machine, rest and motion
run shear --friction-coefficient 0.42 --critical-slip 0.25 --shear-compliance 1e-3 --displacement 1.5,-1.5 \
   --normal-stress 0.05,0.2 --csv machine.csv
run "${fit[@]}" machine.csv --free friction_coefficient,critical_slip,shear_compliance --case machine.nml
check 'fit shear: with a machine' is_quiet
check 'fit shear: with a machine, gcrit' has_nearly machine.nml critical_slip 0.25 1e-4
check 'fit shear: machine' has_nearly machine.nml shear_compliance 1e-3 1e-4
run shear "$root/examples/friction/pine_transverse.nml" --csv pine.csv
run fit --kind shear pine.csv --fix diameter=61.8,normal_stress=0.2 \
   --free friction_coefficient,static_friction_coefficient,critical_slip,decay_slip --case pine.nml
check 'fit shear: rest and motion' is_quiet
check 'fit shear: in motion' has_nearly pine.nml friction_coefficient 0.17 1e-4
check 'fit shear: at rest' has_nearly pine.nml static_friction_coefficient 0.24 1e-4
check 'fit shear: decay' has_nearly pine.nml decay_slip 0.5 1e-4

# Held out: what is not fitted is followed with the values found
head -n 1 s.csv >first.csv
grep '^5.0000000000000003E-002' s.csv >>first.csv
run "${fit[@]}" first.csv --free friction_coefficient,critical_slip --hold-out s.csv
check 'fit shear: held out' test "$(grep -c '^ *s.csv normal_stress_nominal.* no ' out)" -eq 3

# The only test of a file has its normal stress in a leading column as well, and one that is chosen
run "${fit[@]}" s.csv --free friction_coefficient,critical_slip --where normal_stress_nominal=0.2 --case chosen.nml
check 'fit shear: one test of three' grep -q '^  normal_stress = 0.2 ' chosen.nml

# A test that begins under load is said
awk -F, 'NR == 1 || $3 > 0.3 || n { if (NR > 1) n = 1; print $3 "," $10 }' s.csv | sed '1s/.*/displacement,force/' | head -n 90 >late.csv
run fit --kind shear late.csv --fix diameter=61.8,normal_stress=0.05 --free friction_coefficient,critical_slip
check 'fit shear: begins under load' grep -q 'Test 1 begins with 100' out

# A load cell that drifts by a twentieth: residuals go on, which is said; mu is off by less
awk -F, 'NR == 1 { print } NR > 1 { OFS = ","; $10 += 6*NR/600; print }' s.csv >drift.csv
run "${fit[@]}" drift.csv --free friction_coefficient,critical_slip --case drift.nml
check 'fit shear: drift is said' grep -q 'Durbin-Watson' out
check 'fit shear: drift' has_nearly drift.nml friction_coefficient 0.42 0.05

refuses 'fit shear: no normal stress' 2 'late.csv: nothing says the normal stress' \
   "${fit[@]}" late.csv --free friction_coefficient,critical_slip
refuses 'fit shear: a diameter below zero' 2 's.csv: diameter = -61.8 is not allowed' \
   fit --kind shear s.csv --fix diameter=-61.8 --free friction_coefficient,critical_slip
refuses 'fit shear: no size' 2 's.csv: the record has forces: give the diameter' \
   fit --kind shear s.csv --free friction_coefficient,critical_slip
refuses 'fit shear: neither free nor fixed' 2 'nothing says critical_slip: free it, or fix it' "${fit[@]}" s.csv --free friction_coefficient
refuses 'fit shear: a decay without rest' 2 'nothing says static_friction_coefficient' \
   "${fit[@]}" s.csv --free friction_coefficient,critical_slip,decay_slip
refuses 'fit shear: a size is not free' 2 '--free: normal_stress is measured' \
   "${fit[@]}" s.csv --free normal_stress,friction_coefficient,critical_slip
refuses 'fit shear: what is fixed is wrong' 1 '.*shear.csv: the model misses [0-9]+.0 % of the readings' \
   fit --kind shear "$root/examples/fit/shear.csv" --fix diameter=61.8,shear_compliance=1e100 --free friction_coefficient,critical_slip --case none.nml
check 'fit shear: no case of no model' test ! -e none.nml
# At one normal stress a machine is a longer critical slip
awk -F, 'NR == 1 { print "displacement (mm),force (N)" } $1 == 0.1 { printf "%.3f,%.1f\n", $3, $10 }' s.csv >one.csv
refuses 'fit shear: one normal stress and a machine' 1 'one.csv: .*(critical_slip|shear_compliance)' \
   fit --kind shear one.csv --fix diameter=61.8,normal_stress=0.1 \
   --free friction_coefficient,critical_slip,shear_compliance
# A push within the elastic slip knows mu/gcrit alone
run shear --displacement 0.1 --normal-stress 0.1 --displacement-increment 0.005 --csv stick.csv
refuses 'fit shear: it never slips' 1 'stick.csv: .*(friction_coefficient|critical_slip)' \
   fit --kind shear stick.csv --fix diameter=61.8,normal_stress=0.1 --free friction_coefficient,critical_slip \
   --case none.nml
check 'fit shear: no case of what is not settled' test ! -e none.nml
run press --csv press.csv
refuses 'fit shear: a press record' 2 'press.csv: ' "${fit[@]}" press.csv --free friction_coefficient,critical_slip
printf 'normal_stress,displacement (mm),force (N)\n0.1,0,0\n0.1,0,1\n0.1,0,2\n0.2,0,0\n0.2,0,1\n0.2,0,2\n' >still.csv
refuses 'fit shear: it does not move' 2 'still.csv: shear test 1 does not move' \
   "${fit[@]}" still.csv --free friction_coefficient,critical_slip
sed '2,$s/^0\.1/-0.1/' still.csv >pulled.csv
refuses 'fit shear: normal stress below zero' 2 'pulled.csv: .*compression positive' \
   "${fit[@]}" pulled.csv --free friction_coefficient,critical_slip
printf 'normal_stress,displacement (mm),force (N)\n0.1,0,0\n0.1,1,1\n0.1,2,1\n0.1,3,1\n' >few.csv
refuses 'fit shear: fewer data than parameters' 2 'few.csv: 4 numbers of the record cannot settle 4' \
   fit --kind shear few.csv --fix diameter=60,normal_stress=0.1 \
   --free friction_coefficient,critical_slip,decay_slip,static_friction_coefficient
