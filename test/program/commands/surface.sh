# asperity surface: from a height map to the law's parameters

run surface --generate --map-points 256,192 --correlation-length 0.08 --csv s.csv --json s.json \
   --map s.sdf --case s.nml
check 'surface: generated' test "$status" -eq 0
check 'surface: columns' test "$(columns s.csv)" = \
   'parameter,unit,value,uncertainty,step_2,step_4,meaning'
check 'surface: 36 parameters' test "$(rows s.csv)" -eq 36
check 'surface: the map is told' test "$(of_json s.json map points_x) $(of_json s.json map \
   points_y) $(of_json s.json map missing)" = '256 192 0'
check 'surface: sp + sv = sz' near "$(value s.csv sz)" \
   "$(awk -v a="$(value s.csv sp)" -v b="$(value s.csv sv)" 'BEGIN { print a + b }')" 1e-5
check 'surface: the paper takes sq, spd and 1/spc' test "$(value s.csv sigma_paper)" = \
   "$(value s.csv sq)" -a "$(value s.csv eta_paper)" = "$(value s.csv spd)"
check 'surface: alpha = m0 m4/m2^2' near "$(value s.csv alpha)" "$(awk -v a="$(value s.csv m0)" \
   -v b="$(value s.csv m2)" -v c="$(value s.csv m4)" 'BEGIN { print a*c/b^2 }')" 1e-5
check 'surface: Nayak holds for a Gaussian surface, within 5 %' near \
   "$(value s.csv summit_density)" "$(value s.csv eta_nayak)" 0.05
check 'surface: the summit mean plane is that of the summits found, within 5 %' near \
   "$(value s.csv summit_mean)" "$(value s.csv summit_plane)" 0.05
check 'surface: first touch is the highest point' near "$(of_json s.json summary first_touch \
   | head -n 1)" "$(awk -v a="$(value s.csv sp)" -v b="$(value s.csv summit_plane)" \
   'BEGIN { print a - b }')" 1e-4

run surface s.sdf --csv again.csv
check 'surface: the file that was written reads back' near "$(value s.csv m4)" \
   "$(value again.csv m4)" 1e-12
for ending in xyz csv; do
   run surface s.sdf --map map.$ending --csv -
   run surface map.$ending --csv again.csv
   check "surface: $ending, the same spd" near "$(value s.csv spd)" "$(value again.csv spd)" 1e-12
   check "surface: $ending, the same m4" near "$(value s.csv m4)" "$(value again.csv m4)" 1e-9
done
{ grep '^#' map.xyz; grep -v '^#' map.xyz | sort -R --random-source=s.sdf; } >shuffled.xyz
run surface shuffled.xyz --csv again.csv
check 'surface: rows in any order' near "$(value s.csv spc)" "$(value again.csv spc)" 1e-12
run surface --generate --map-points 256,192 --correlation-length 0.08 --csv same.csv
check 'surface: the same seed makes the same surface' cmp s.csv same.csv
run surface --generate --map-points 256,192 --correlation-length 0.08 --seed 2 --csv other.csv
check 'surface: another seed makes another' sh -c '! cmp -s s.csv other.csv'

# Twice the height: lengths twice, curvatures twice, densities as they were; um read as mm: 1000
awk '!/^#/ && NF == 3 { printf "%s %s %.15g\n", $1, $2, 2*$3 }' map.xyz >numbers.xyz
run surface numbers.xyz --lateral-unit mm --height-unit mm --csv twice.csv
check 'surface: twice the height, twice sq' near "$(value twice.csv sq)" \
   "$(awk -v a="$(value s.csv sq)" 'BEGIN { print 2*a }')" 1e-5
check 'surface: twice the height, half the radius' near "$(value twice.csv radius_paper)" \
   "$(awk -v a="$(value s.csv radius_paper)" 'BEGIN { print a/2 }')" 1e-5
check 'surface: twice the height, the same peaks' near "$(value twice.csv spd)" \
   "$(value s.csv spd)" 1e-9
run surface numbers.xyz --lateral-unit mm --height-unit um --csv small.csv
check 'surface: heights in um' near "$(value small.csv sq)" \
   "$(awk -v a="$(value twice.csv sq)" 'BEGIN { print a/1000 }')" 1e-5
refuses 'surface: no unit of heights' 2 'numbers.xyz: .* --height-unit' surface numbers.xyz
refuses 'surface: no unit of lengths' 2 'numbers.xyz: .* --lateral-unit' \
   surface numbers.xyz --height-unit mm
refuses 'surface: units that the file contradicts' 2 's.sdf: ' surface s.sdf --height-unit um

# The case is taken by every command that takes properties
for command in curve 'press --peak 0.2' shear table \
   'tenon --amplitudes 4 --face-points 20 --side-points 4'; do
   # shellcheck disable=SC2086  # several words are meant
   run ${command%% *} s.nml ${command#"${command%% *}"} --json case.json
   check "surface: its case is taken by ${command%% *}" test "$status" -eq 0
   check "surface: and means the same to ${command%% *}" near "$(value s.csv eta_nayak)" \
      "$(sed -n 's/^"properties".*"eta": \([^,]*\),.*/\1/p' case.json)" 1e-12
done
check 'surface: the case tells route and datum' sh -c \
   'grep -q "route" s.nml && grep -q "mean plane of the surface" s.nml'
check 'surface: a plain Gaussian map is taken by the law unaided' lacks s.nml 'accept_unphysical = .true.'
run surface s.sdf --route nayak --case n.nml --csv -
check 'surface: the route of Nayak is the default' \
   test "$(grep '^! eta, radius' s.nml)" = "$(grep '^! eta, radius' n.nml)"
check 'surface: its sigma' sh -c "grep -q '  sigma = $(value s.csv sigma_nayak | sed \
   's/E-002//;s/^1\./0.01/;s/0\{1,\}$//' | cut -c 1-8)' n.nml"

# The verdict: the route, eta R sigma, the sum over summits; the case passes the law's checks, or
# says in its first line why it does not. Of eight seeds none needs help, and none is flagged
for seed in 1 2 3 4 5 6 7 8; do
   run surface --generate --seed $seed --case g.nml --json g.json
   check "surface: verdict, seed $seed" grep -q \
      '^"verdict": "route nayak, eta R sigma = 0\.0[23][0-9]*: .* it holds at both\."' g.json
   run shear g.nml --csv -
   check "surface: seed $seed passes the law" is_quiet
   check "surface: seed $seed without flags" test "$(csv_column out validity | sort -u)" = valid
done
run surface --generate
check 'surface: the verdict ends the output' sh -c "tail -n 2 out | head -n 1 | grep -q '^Verdict: route nayak, '"
run surface --generate --route paper --case paper.nml
check 'surface: route paper: the verdict names the other' has out \
   "Verdict: take --route nayak, eta R sigma = 0.0290, unless values like the paper's are wanted: route paper has eta R sigma = 0.0168"
check 'surface: route paper: 0.0249 is a remark' has out 'route is 0.0168, below 0.0249'
run surface --generate --map-points 256 --correlation-length 0.8,0.08 --route paper --case low.nml
check 'surface: a case that the law refuses says so first' sh -c \
   "head -n 1 low.nml | grep -q '^! The law refuses this case, hence accept_unphysical: eta.radius.sigma = .* is below 0.0158'"
run curve low.nml --separation 0.1
check 'surface: and is taken, flagged' has out 'eta*radius*sigma below 0.0158'
awk 'BEGIN { for (j = 0; j < 60; j++) for (i = 0; i < 60; i++)
   print i, j, sin(i/5)*cos(j/5) + 0.001*((7*i + 3*j) % 5) }' >waves.xyz
run surface waves.xyz --lateral-unit um --height-unit um
check 'surface: no Gaussian surface has so small an alpha: the verdict names the other route' has out \
   'Verdict: route nayak does not describe this map, eta R sigma = 0.00793; take --route paper'
run surface --generate --step 20 --case wide.nml
check 'surface: a radius of 394 m is told in the verdict' grep -q \
   '^Verdict: .*The law takes it only with accept_unphysical: radius = .* mm is above 10000.0 mm' out

run surface s.sdf --case m.nml --pair --csv -
refuses 'surface: --pair and one map' 2 '--pair: needs the maps of two faces' surface s.sdf --pair
run surface s.sdf --case m.nml --modulus 500 --hardness 20 --friction-coefficient 0.3 \
   --initial-separation 0.05 --material tangential-tangential --csv -
check 'surface: properties that are given' sh -c 'grep -q "modulus = 500" m.nml \
   && grep -q "friction_coefficient = 0.3" m.nml && grep -q "initial_separation = 0.05" m.nml'

# The law on the map
run surface s.sdf --verify --route nayak --json v.json
check 'surface: --verify' has out 'sum over the'
check 'surface: nothing of memory without it' lacks v.json '"unloading": {'
run surface s.sdf --verify --route nayak --unloading elastic --case memory.nml --json u.json
check 'surface: --verify on the way back' has out 'Pressed to 4.7 MPa of the Gaussian law and released, with memory'
check 'surface: the sum parts as the law does, within 25 %' near \
   "$(of_json u.json unloading pressure_nayak | sed -n 3p)" \
   "$(of_json u.json unloading pressure_summits | sed -n 3p)" 0.25
check 'surface: the case has its unloading' has memory.nml "unloading = 'elastic'"
run curve memory.nml --closest-separation "$(of_json u.json unloading separation | head -n 1)" \
   --separation "$(of_json u.json unloading separation | sed -n 4p)" --csv curve.csv
check 'surface: the way back is that of the case' near "$(csv_column curve.csv pressure)" \
   "$(of_json u.json unloading pressure_nayak | sed -n 4p)" 1e-8
refuses 'surface: elastic unloading below its yield factor' 2 \
   '--yield-factor: yield_factor = 0.15 is not allowed with elastic' surface s.sdf --unloading elastic --yield-factor 0.15
check 'surface: sums over summits meet the Gaussian integral at small separations' near \
   "$(of_json v.json law pressure_nayak | tail -n 1)" \
   "$(of_json v.json law pressure_summits | tail -n 1)" 0.25
check 'surface: separations from the surface' near "$(awk \
   -v a="$(of_json v.json law separation | head -n 1)" -v b="$(value s.csv summit_plane)" \
   'BEGIN { print a + b }')" "$(of_json v.json law separation_surface | head -n 1)" 1e-5
run curve n.nml --separation "$(of_json v.json law separation | sed -n 9p)" --csv curve.csv
check 'surface: the curve is that of the case' near "$(csv_column curve.csv pressure)" \
   "$(of_json v.json law pressure_nayak | sed -n 9p)" 1e-9

# Two faces
run surface --generate --map-points 256,192 --correlation-length 0.08 --seed 2 --map t.sdf --csv -
run surface s.sdf t.sdf --pair --json p.json --csv p.csv
check 'surface: --pair' test "$status" -eq 0
check 'surface: squares of a pair add' near "$(of_json p.json faces m0 | sed -n 3p)" \
   "$(of_json p.json faces m0 | awk 'NR < 3 { s += $1 } END { print s }')" 1e-5
check 'surface: the sum of the maps has them within 10 %' near "$(value p.csv m0)" \
   "$(of_json p.json faces m0 | sed -n 3p)" 0.1
of_json p.json gap gap | sort -g -c
check 'surface: quantiles of the gap are in order' test $? -eq 0
run surface s.sdf s.sdf --pair --mirror none --csv p.csv
check 'surface: a face on itself, recorded from the same side, is twice as high' near \
   "$(value p.csv sq)" "$(awk -v a="$(value s.csv sq)" 'BEGIN { print 2*a }')" 1e-5
check 'surface: and correlation is said' has out 'Correlation of the two maps: 1.'
run surface --generate --map-points 128 --map small.sdf --csv -
run surface s.sdf small.sdf --pair --csv p.csv
check 'surface: maps that do not fit: squares only' test "$status" -eq 0 \
   -a -z "$(value p.csv spd)" -a -n "$(value p.csv eta_nayak)"
refuses 'surface: no picture of maps that do not fit' 2 '--verify: needs maps of the same points' \
   surface s.sdf small.sdf --pair --verify
refuses 'surface: two maps without --pair' 2 't.sdf: a second map is only taken with --pair' \
   surface s.sdf t.sdf
refuses 'surface: three maps' 2 "x.sdf: --pair takes the maps of two faces" \
   surface s.sdf t.sdf x.sdf --pair

# One lay across the other: aligned or not, the same equivalent surface
run surface --generate --map-points 200 --correlation-length 0.4,0.05 --map lay.sdf --csv -
run surface --generate --map-points 200 --correlation-length 0.05,0.4 --seed 2 --map cross.sdf \
   --csv -
run surface --generate --map-points 201,200 --correlation-length 0.05,0.4 --seed 2 \
   --map wide.sdf --csv -
run surface lay.sdf cross.sdf --pair --csv aligned.csv
run surface lay.sdf wide.sdf --pair --csv apart.csv
check 'surface: crossed lays, maps that do not fit: the density of those that do' near \
   "$(value aligned.csv eta_nayak)" "$(value apart.csv eta_nayak)" 0.05
check 'surface: and the radius' near "$(value aligned.csv radius_nayak)" \
   "$(value apart.csv radius_nayak)" 0.05
refuses 'surface: no case by the paper of maps that do not fit' 2 '--case: route paper needs maps' \
   surface lay.sdf wide.sdf --pair --route paper --case never.nml
run surface lay.sdf wide.sdf --pair --route nayak --case apart.nml
check 'surface: a case by moments of maps that do not fit' has apart.nml 'no first touch is known'
run surface numbers.xyz s.sdf --pair --lateral-unit mm --height-unit um --csv -
check 'surface: units for the one of two files that needs them' test "$status" -eq 0

# Preparation
run surface s.sdf --short-cutoff 0.2 --csv short.csv
check 'surface: an S filter lowers m4' awk -v a="$(value short.csv m4)" -v b="$(value s.csv m4)" \
   'BEGIN { exit !(a < 0.3*b) }'
run surface s.sdf --long-cutoff 0.5 --csv long.csv
check 'surface: an L filter lowers sq and leaves m4' awk -v a="$(value long.csv sq)" \
   -v b="$(value s.csv sq)" -v c="$(value long.csv m4)" -v d="$(value s.csv m4)" \
   'BEGIN { exit !(a < b && c > 0.95*d) }'
run surface s.sdf --form 4 --csv form.csv
check 'surface: a form of degree 4 lowers sq' awk -v a="$(value form.csv sq)" \
   -v b="$(value s.csv sq)" 'BEGIN { exit !(a < b) }'
run surface s.sdf --pruning 0 --csv all.csv
check 'surface: without pruning every summit is a peak' test "$(value all.csv spd)" = \
   "$(value all.csv summit_density)"
map_with_holes >holes.csv
run surface holes.csv --step 0.01 --csv holes_out.csv --json holes.json
check 'surface: holes are left out' test "$(of_json holes.json map missing)" = 40
run surface holes.csv --step 0.01 --missing fill --csv filled.csv --json filled.json
check 'surface: or filled' test "$(of_json filled.json map missing)" = 0
refuses 'surface: too many holes' 2 '--most-missing: .*missing|holes.csv: 40 of 2000 points' \
   surface holes.csv --step 0.01 --most-missing 0.01

# Three times the map's 32 MiB, and 24 MiB for the program itself
if /usr/bin/time -f %M true 2>/dev/null; then
   run surface --generate --map-points 2048 --map large.sdf --csv -
   for options in '' '--short-cutoff 0.03 --long-cutoff 2' '--spectrum'; do
      file=large.sdf
      if [ "$options" = --spectrum ]; then
         options=''
         file=noise.sdf
         run surface --generate --map-points 2048 --spectrum exponential --correlation-length 0.02 \
            --map noise.sdf --csv -
      fi
      # shellcheck disable=SC2086  # several words are meant
      memory=$(limited /usr/bin/time -f %M "$program" surface $file $options 2>&1 >out | tail -n 1)
      check "surface: memory, $file $options: $memory KiB" test "$memory" -le 122880 -a -s out
   done
   rm -f large.sdf noise.sdf
else
   skip 'surface: memory' 'no GNU time'
fi

awk 'NR == 5000 { $3 = 5 } { print }' numbers.xyz >spike.xyz
run surface spike.xyz --lateral-unit mm --height-unit mm
check 'surface: a spike is told, with its place' has out "times sq, at x $(awk 'NR == 5000 \
   { print $1 + 0 }' numbers.xyz) mm"
run surface numbers.xyz --lateral-unit nm --height-unit mm
check 'surface: slopes of wrong units are told' has out 'check units and step'

awk '{ print $0, 1.5, 2, 3 }' numbers.xyz >more.xyz
run surface more.xyz --step 0.01 --height-unit um
check 'surface: columns taken for a matrix are told' has out 'columns of x, y, z and more'

if command -v gnuplot >/dev/null; then
   cp s.sdf 'n`touch was_run`"; a=" .sdf'
   run surface 'n`touch was_run`"; a=" .sdf' --plot named.svg
   check 'surface: a file name is no command of gnuplot' test "$status" -eq 0 -a ! -e was_run
   awk 'BEGIN { for (j = 0; j < 9; j++) for (i = 0; i < 9; i++) print i, j, (i - 4)^2 + j }' >pit.xyz
   run surface pit.xyz --lateral-unit mm --height-unit um --plot pit.svg
   check 'surface: picture of a map without peaks' test "$status" -eq 0 -a -s pit.svg
   for ending in svg png pdf; do
      run surface s.sdf --verify --plot p.$ending
      check "surface: picture, $ending" test "$status" -eq 0 -a -s p.$ending
   done
else
   skip 'surface: pictures' 'no gnuplot'
fi

# Bad input
refuses 'surface: no map' 2 'no map is given: asperity surface FILE' surface
refuses 'surface: no such file' 3 'no.sdf: ' surface no.sdf
refuses 'surface: a folder' 3 '\.: ' surface .
: >empty
refuses 'surface: an empty file' 2 'empty: ' surface empty
head -c 1000 s.sdf >cut.sdf
refuses 'surface: a truncated file' 2 'cut.sdf: ' surface cut.sdf
printf '0 0 1\n1 0 2\n0 1 x\n1 1 2\n' >text.xyz
refuses 'surface: text where a number belongs' 2 "text.xyz:3:.*'?x'?" surface text.xyz \
   --lateral-unit mm --height-unit mm
printf '0 0 1,5\n1 0 2,5\n0 1 1,5\n1 1 2,5\n' >comma.xyz
awk 'BEGIN { for (j = 0; j < 9; j++) for (i = 0; i < 9; i++) print i, j, 3 + 0.1*i }' >flat.xyz
refuses 'surface: a plane' 2 'flat.xyz: has no roughness' surface flat.xyz --lateral-unit mm \
   --height-unit um
refuses 'surface: decimal commas' 2 'comma.xyz:1:.*decimal' surface comma.xyz --lateral-unit mm \
   --height-unit mm
refuses 'surface: the ending of a map' 2 '--map: .*stl: allowed are sdf, xyz and csv' surface s.sdf --map s.stl
refuses 'surface: the map as output' 2 '--map: s.sdf is the map' surface s.sdf --map s.sdf
refuses 'surface: no tiles' 2 '--tiles: tiles = 0 is not allowed' surface s.sdf --tiles 0
refuses 'surface: too many tiles' 2 '--tiles: tiles = 99 is not allowed' surface s.sdf --tiles 99
refuses 'surface: pruning above 1' 2 '--pruning: ' surface s.sdf --pruning 1.5
refuses 'surface: form of degree 9' 2 '--form: form = 9' surface s.sdf --form 9
refuses 'surface: a cutoff of nothing' 2 '--short-cutoff: short_cutoff = 0.0 mm' \
   surface s.sdf --short-cutoff 0
refuses 'surface: cutoffs in the wrong order' 2 '--long-cutoff: .* above short_cutoff' \
   surface s.sdf --short-cutoff 0.2 --long-cutoff 0.1
refuses 'surface: S cutoff below the step' 2 '--short-cutoff: .*below two steps' \
   surface s.sdf --short-cutoff 0.001
refuses 'surface: share of missing points' 2 '--most-missing: most_missing = 1.0' \
   surface s.sdf --most-missing 1
refuses 'surface: options of --generate' 2 '--seed: is for --generate' surface s.sdf --seed 3
refuses 'surface: options of a file' 2 '--height-unit: is for files' surface --generate \
   --height-unit um
refuses 'surface: a map and --generate' 2 's.sdf: --generate makes a map' surface s.sdf --generate
refuses 'surface: --mirror without a pair' 2 '--mirror: is for --pair' surface s.sdf --mirror y
run surface --generate --ssk -0.5 --sku 3.43 --json s.json
check 'surface: heights by what they do to the pressure' has s.json '"ssk = -0.57'
check 'surface: beside them the own summits' has s.json ' own summits, each with its own radius, give '
run surface --generate
check 'surface: Gaussian heights are not remarked on' lacks out 'own summits, each'
refuses 'surface: no such kurtosis' 2 '.*sku' surface --generate --ssk 2 --sku 3
refuses 'surface: half a point' 2 '--map-points: map_points' surface --generate --map-points 64.5
refuses 'surface: a short correlation length' 2 '--correlation-length: correlation_length|.*corr' \
   surface --generate --correlation-length 0.001
refuses 'surface: three steps' 2 '--step: step: takes one value or two' surface s.sdf --step 1,2,3
refuses 'surface: a pair of the paper' 2 '--material: .*unknown' surface s.sdf --material oak \
   --case never.nml
check 'surface: nothing is written then' absent never.nml
