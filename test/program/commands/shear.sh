# asperity shear: the direct shear box through UINTER

header=normal_stress_nominal,time,displacement,slip,overclosure,separation,\
separation_over_sigma,overlap_area,normal_stress,shear_force,shear_stress_nominal,shear_stress,\
area_fraction,normal_energy,tangential_energy,dissipation,pressure_coupling,elastic_share,\
elastoplastic_share,plastic_share,status,validity
run shear --displacement 5 --displacement-increment 0.05 --csv s.csv --json s.json
check 'shear' is_quiet
check 'shear: columns' test "$(columns s.csv)" = "$header"
check 'shear: three runs of 101 rows' test "$(rows s.csv)" -eq 303
check 'shear: 17 figures' numbers_are_proper s.csv
check 'shear: JSON holds the same figures' same_csv_and_json s.csv s.json
cp s.csv plain.csv

# mu = 0.5, gcrit = 0.31 mm; the replay balances the weight to 1e-11
check 'shear: dead weight' csv s.csv '
   a0 = 3.14159265358979323846*61.8^2/4
   if (far(c["normal_stress"]*c["overlap_area"], c["normal_stress_nominal"]*a0, 1e-10)) fail("weight")'
check 'shear: tau = mu p min(1, slip/gcrit)' csv s.csv '
   u = c["slip"]/0.31; t = 0.5*c["normal_stress"]*(u < 1 ? u : 1)
   if (u > 0 && far(c["shear_stress"], t, 1e-10)) fail(c["shear_stress"] " not " t)'
check 'shear: force over both areas' csv s.csv '
   a0 = 3.14159265358979323846*61.8^2/4
   if (far(c["shear_force"], c["shear_stress"]*c["overlap_area"], 1e-14)) fail("overlap")
   if (far(c["shear_force"], c["shear_stress_nominal"]*a0, 1e-13)) fail("disc")'
# Overlap of two discs at 1, 3, 5 mm: 0.979, 0.938, 0.897 of the disc
check 'shear: overlap of the discs' csv s.csv '
   a = c["overlap_area"]/(3.14159265358979323846*61.8^2/4)
   x = sprintf("%.3f", c["displacement"]); want["1.000"] = 0.979; want["3.000"] = 0.938; want["5.000"] = 0.897
   if (x in want && sprintf("%.3f", a) != want[x]) fail(x " " a)'
# Known to three figures: d/sigma at 0.05 and 0.2 MPa
check 'shear: closure under dead weight' csv s.csv '
   if (c["displacement"] == 0) {
      p = c["normal_stress_nominal"]; d = sprintf("%.2f", c["separation_over_sigma"])
      if (p == 0.05 && d != 3.09 || p == 0.2 && d != 2.69) fail(p " " d) }'
check 'shear: sticks before gcrit, slips after' csv s.csv '
   if ((c["slip"] > 0.3101) != (c["status"] == "slip")) fail(c["status"])'
check 'shear: dissipation never falls' csv s.csv '
   if (c["displacement"] > 0 && c["dissipation"] < before["dissipation"]) fail("falls")'
check 'shear: speed of the box' csv s.csv '
   if (c["displacement"] > 0 && far(c["time"], c["displacement"]*60/1.2, 1e-12)) fail("time")'
summary() { sed -n '/^"summary"/,/^}/p' s.json | sed -n "s/^\"$1\": \[\(.*\)\].*/\1/p"; }
check 'shear: plateau is mu p' awk -v a="$(summary plateau_nominal)" -v b="$(summary mu_p_nominal)" '
   BEGIN { n = split(a, x, ","); split(b, y, ","); for (i = 1; i <= n; i++) {
      d = x[i]/y[i] - 1; if (d > 1e-10 || d < -1e-10) exit 1 } exit n != 3 }'
check 'shear: initial slope is mu p/gcrit' awk -v a="$(summary initial_slope)" -v b="$(summary mu_p_nominal)" '
   BEGIN { n = split(a, x, ","); split(b, y, ","); for (i = 1; i <= n; i++) {
      d = x[i]*0.31/y[i] - 1; if (d > 1e-10 || d < -1e-10) exit 1 } exit n != 3 }'
run shear --displacement 0.1
check 'shear: no plateau before it slips' awk '/^ *0.05 / && !n++ { exit $5 != "-" }' out

run shear --no-shrinking-overlap --normal-stress 0.1 --csv s.csv
check 'shear: overlap that does not shrink' csv s.csv \
   'if (NR > 2 && c["overlap_area"] != before["overlap_area"]) fail("shrinks")'
run shear --shear-compliance 1e-4 --normal-stress 0.1 --displacement 2,-2,0 --csv s.csv
check 'shear: displacement = slip + compliance*force' csv s.csv '
   if (abs(c["displacement"] - c["slip"] - 1e-4*c["shear_force"]) > 1e-11) fail("sum")'
check 'shear: turning points are reached' \
   sh -c 'for x in 2 -2; do cut -d, -f3 s.csv | grep -q -e "^$x.0000000000000000E+000" || exit 1; done'
run shear --shear-compliance 1e-4 --normal-stress 0.1 --displacement 2,-2,0
check 'shear: turning points are shown' \
   sh -c 'grep -q "^ *0.1  *2.0 " out && grep -q "^ *0.1  *-2.0 " out'
check 'shear: a shortened history is said to be so' has out ' rows: evenly spaced ones and turning points'
run shear --friction-rule dissipative --displacement 2,-2,0 --csv s.csv
check 'shear: dissipative rule has no pressure coupling' csv s.csv \
   'if (c["pressure_coupling"] != 0) fail(c["pressure_coupling"])'

refuses 'negative normal stress' 2 '--normal-stress: normal_stress = -0.1 is not' \
   shear --normal-stress 0.05,-0.1
refuses 'no rate' 2 '--rate: rate = 0.0 is not allowed' shear --rate 0
refuses 'displacement past the disc' 2 '--displacement: displacement = 70.0 mm is not' \
   shear --displacement 70
refuses 'a displacement in micrometres' 2 \
   '--displacement: displacement = 3000.0 mm is not allowed: the discs overlap up to 55.62 mm; 3000.0 looks like micrometres, write 3.0' \
   shear --displacement 3000
refuses 'a displacement in metres' 2 \
   '--displacement: displacement = 0.003 mm is outside .*: 0.003 looks like metres, write 3.0; accept_sizes lets it pass' \
   shear --displacement 0.003,-0.003
refuses 'a diameter in metres' 2 '--diameter: diameter = 0.0618 mm is outside .* metres, write 61.8' \
   shear --diameter 0.0618 --displacement 0.003
refuses 'a stress in kPa' 2 '--normal-stress: normal_stress = 50.0 MPa is outside .* kPa, write 0.05' \
   shear --normal-stress 50,100
refuses 'a stress in Pa' 2 '--normal-stress: normal_stress = 200000.0 MPa .* looks like Pa, write 0.2' \
   shear --normal-stress 0.1,200000
refuses 'elastic slip in micrometres' 2 \
   '--critical-slip: critical_slip = 310.0 mm is above 10.0 mm, .* critical_slip looks like um' \
   shear --critical-slip 310
refuses 'steps in micrometres' 2 '--displacement-increment: .* = 20.0 mm .* micrometres, write 0.02' \
   shear --displacement-increment 20
run shear --displacement 0.003 --accept-sizes --csv tiny.csv
check 'a size that is accepted' is_quiet
refuses 'no increment' 2 '--displacement-increment: displacement_increment = 0.0 is not' \
   shear --displacement-increment 0
refuses 'too many increments' 2 '--displacement-increment: .* gives more than' \
   shear --displacement-increment 1e-12 --accept-sizes
refuses 'negative diameter' 2 '--diameter: diameter = -1.0 is not allowed' shear --diameter -1
refuses 'negative compliance' 2 '--shear-compliance: shear_compliance = -1.0 mm/N is not' \
   shear --shear-compliance -1
refuses 'negative critical slip' 2 '--critical-slip: critical_slip = -1.0 is not' \
   shear --critical-slip -1
refuses 'unknown friction rule' 2 "--friction-rule: .* is unknown; known: abaqus, dissipative" \
   shear --friction-rule x

# What UINTER warns of is said once, of the rows of this case, not of a node of the host
run shear --normal-stress 22 --accept-sizes --displacement 0.1 --csv -
check 'shear: limits are told by rows' test "$(head -n 1 err)" = "asperity: warning: real area above nominal area: \
asperities overlap, pressure is too high (6 of 6 rows, the first is row 1)"
run press --peak 25 --csv -
check 'press: limits are told by rows' test "$(grep -c 'rows, the first is row' err)" -eq 2 \
   -a "$(wc -l <err)" -eq 3
check 'press: contacts that grow together are told last' \
   test "$(tail -n 1 err | cut -c-65)" = 'asperity: warning: Real area up to 116 % of the nominal one: the '


# With memory: the weight fixes pressure and shear, so that only the closure on the way back differs
path=(--displacement 3,-3,3 --displacement-increment 0.5 --normal-stress 0.2)
run shear "${path[@]}" --csv s.csv
run shear "${path[@]}" --unloading elastic --csv m.csv --json m.json
check 'shear, memory' is_quiet
check 'shear, memory: columns' test "$(columns m.csv)" = \
   "${header/dissipation,pressure_coupling/dissipation,plastic_dissipation,pressure_coupling}"
check 'shear, memory: JSON holds the same figures' same_csv_and_json m.csv m.json
paste -d, <(csv_column s.csv shear_stress) <(csv_column m.csv shear_stress) \
   <(csv_column s.csv overclosure) <(csv_column m.csv overclosure) >both
check 'shear, memory: the same shear, closer on the way back' awk -F, '
   { if (($1 - $2)^2 > 1e-18) { print "shear " $0; exit 1 } if ($4 < $3 - 1e-12) { print $0; exit 1 }
     closer += $4 > $3 + 1e-5 } END { print closer; exit !(closer > 15) }' both
check 'shear, memory: dissipates to its first peak' csv m.csv '
   if (NR > 2 && (c["plastic_dissipation"] > before["plastic_dissipation"]) != (NR <= 8)) fail("row")'
refuses 'shear: unloading of no kind' 2 "--unloading: unloading = 'plastic' is unknown" \
   shear --unloading plastic

# Summits that stick each for itself: stiffer than one critical slip, bent, with the same plateau
run shear --stick summits --normal-stress 0.2 --displacement 0.1,-0.1,0.1 \
   --displacement-increment 0.005 --csv s.csv --json s.json
check 'shear: summits that stick: full slip before 0.04 mm' csv s.csv '
   if (c["displacement"] > 0.04 && NR < 20 && c["status"] != "slip") fail(c["status"])
   if (c["status"] == "slip" && far(abs(c["shear_stress"]), 0.5*c["normal_stress"], 1e-10)) fail("plateau")'
check 'shear: summits that stick: the curve bends' csv s.csv '
   s = (c["shear_stress"] - before["shear_stress"])/0.005
   if (c["displacement"] > 0 && NR > 3 && NR < 10 && !(s < slope)) fail("straight"); slope = s'
check 'shear: energies of summits that stick' csv s.csv '
   if (NR > 2 && c["dissipation"] < before["dissipation"]) fail("dissipation falls")'
check 'shear: stiffness of the summits and by gcrit' \
   awk -v a="$(summary shear_stiffness)" -v b="$(summary stiffness_by_gcrit)" \
   'BEGIN { exit !(a > 10.78 && a < 10.80 && b > 0.3225 && b < 0.3226) }'
run shear --stick summits --normal-stress 0.2 --displacement 0.1 --shear-modulus 63.286 --json s.json
check 'shear: stiffness in proportion to the shear modulus' \
   awk -v a="$(summary shear_stiffness)" 'BEGIN { exit !(a > 21.56 && a < 21.60) }'
refuses 'shear: shear modulus without summits' 2 '.*stick = summits' shear --shear-modulus 30
refuses 'shear: too few elements' 2 '.*4 to 16' shear --stick summits --stick-elements 3
refuses 'shear: summits with memory' 2 '.*unloading = reversible' shear --stick summits --unloading elastic

# Friction beyond one coefficient: decay by slip at 0.2 MPa, tau = p (0.17 + 0.07 exp(-l/0.5)) with the
# slip l = slip - tau gcrit/(0.24 p)
run shear --friction-coefficient 0.17 --static-friction-coefficient 0.24 --decay-slip 0.5 --normal-stress 0.2 \
   --no-shrinking-overlap --csv f.csv --json s.json
check 'shear, rest and motion: peak and decay' csv f.csv '
   t = c["shear_stress"]; l = c["slip"] - t*0.31/0.048
   if (c["slip"] <= 0.31) { if (far(t, c["slip"]*0.048/0.31, 1e-9)) fail("stick " t) }
   else if (far(t, 0.2*(0.17 + 0.07*exp(-l/0.5)), 1e-9)) fail("decay " t)'
check 'shear, rest and motion: peak of the summary' awk -v a="$(summary peak_nominal)" \
   'BEGIN { exit !(a > 0.0476 && a < 0.048) }'
# across the grain, at a limit: 0.3/0.5 of 0.08 MPa
run shear --friction-coefficient-across 0.3 --grain-angle 90 --shear-limit 0.08 --normal-stress 0.2 \
   --no-shrinking-overlap --csv f.csv
check 'shear, grain and limit: plateau' csv f.csv '
   if (c["slip"] > 0.32 && far(c["shear_stress"], 0.048, 1e-9)) fail(c["shear_stress"])'
run shear --friction-points 0.1,1,0.3,0.6 --normal-stress 0.2 --no-shrinking-overlap --csv f.csv
check 'shear, friction by points: plateau' csv f.csv '
   if (c["slip"] > 0.32 && far(c["shear_stress"], 0.5*0.8*0.2, 1e-9)) fail(c["shear_stress"])'
refuses 'shear: across of zero' 2 '--friction-coefficient-across: friction_coefficient_across = 0.0 is not allowed' \
   shear --friction-coefficient-across 0
refuses 'shear: static below kinetic' 2 '--static-friction-coefficient: static_friction_coefficient = 0.4 is not' \
   shear --static-friction-coefficient 0.4 --decay-slip 1
refuses 'shear: static without decay' 2 '.*nothing leads from one to the other' shear --static-friction-coefficient 0.6
refuses 'shear: decay without static' 2 '--decay-slip: needs static_friction_coefficient' shear --decay-slip 1
refuses 'shear: angle without ellipse' 2 '--grain-angle: needs friction_coefficient_across' shear --grain-angle 10
refuses 'shear: exponent without pressure' 2 '--pressure-exponent: .* needs reference_pressure' shear --pressure-exponent -0.1
refuses 'shear: points in pairs' 2 '--friction-points: friction_points has 3 numbers' shear --friction-points 1,1,2
refuses 'shear: points that rise' 2 '--friction-points: .* is not above the one before' shear --friction-points 1,1,1,0.9
refuses 'tenon: no rate' 2 '--decay-slip-rate: is an option of' tenon --decay-slip-rate 1
