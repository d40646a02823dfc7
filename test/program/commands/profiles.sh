# asperity surface: from profiles to the law's parameters

made=$root/examples/surface/profiles
run surface "$made"/across_*.csv --csv p.csv --json p.json --case p.nml
check 'profiles: five files' test "$status" -eq 0
check 'profiles: what they do not tell is left out' lacks p.csv 'spd|summit_density|eta_paper|m2_x'
check 'profiles: one row each' test "$(of_json p.json profiles points | wc -l)" -eq 5
check 'profiles: the files are a list' grep -q '"files": \[".*across_1.csv", ".*across_5.csv"\]' p.json
check 'profiles: m4 is the mean over profiles of equal length' near "$(value p.csv m4)" \
   "$(of_json p.json profiles m4 | awk '{ s += $1 } END { print s/NR }')" 1e-5
check 'profiles: sq^2 = m0' near "$(value p.csv m0)" \
   "$(awk -v s="$(value p.csv sq)" 'BEGIN { print s*s }')" 1e-5
check 'profiles: eta = (m4/m2)/(6 pi sqrt 3)' near "$(value p.csv eta_nayak)" "$(awk \
   -v a="$(value p.csv m4)" -v b="$(value p.csv m2)" 'BEGIN { print a/b/32.64839 }')" 1e-5
check 'profiles: isotropy is said to be assumed' has out 'That the surface is isotropic is assumed'
check 'profiles: the verdict is of profiles' has p.json 'with the moments of these profiles'
check 'profiles: the case names them' has p.nml "! Profiles: '"
check 'profiles: no first touch' has p.nml 'no first touch is known'
for command in curve 'press --peak 0.2' shear 'tenon --amplitudes 4 --face-points 20 --side-points 4'; do
   # shellcheck disable=SC2086  # several words are meant
   run ${command%% *} p.nml ${command#"${command%% *}"} --json case.json
   check "profiles: the case is taken by ${command%% *}" test "$status" -eq 0
   check "profiles: and means the same to ${command%% *}" near "$(value p.csv eta_nayak)" \
      "$(sed -n 's/^"properties".*"eta": \([^,]*\),.*/\1/p' case.json)" 1e-12
done

# The same numbers in other files: a column with their count, X3P is a test of the reader
awk -F, 'NR > 1 { print $2 }' "$made/across_1.csv" >column.txt
{ wc -l <column.txt; cat column.txt; } >counted.txt
run surface "$made/across_1.csv" --csv one.csv
check 'profiles: one' has out 'A single profile: uncertainties are from 16 parts of it'
for file in column counted; do
   run surface $file.txt --height-unit um --step 0.01 --csv same.csv
   check "profiles: $file, the same m4" near "$(value one.csv m4)" "$(value same.csv m4)" 1e-9
   check "profiles: $file, the same m0" near "$(value one.csv m0)" "$(value same.csv m0)" 1e-9
done
check 'profiles: a count is said' has out 'the first number is that of the heights behind it'

# Lines of a map
run surface --generate --map-points 200,90 --map m.sdf --csv map.csv
run surface --generate --map-points 200,90 --profiles --csv lines.csv
run surface m.sdf --profiles --csv again.csv --json again.json
check 'profiles: lines of a made map' near "$(value map.csv m4_x)" "$(value lines.csv m4)" 1e-9
check 'profiles: lines of a file' near "$(value map.csv m4_x)" "$(value again.csv m4)" 1e-9
check 'profiles: many are not shown' lacks out 'each about its own mean line'
check 'profiles: but kept' test "$(of_json again.json profiles line | tail -n 1)" -eq 90
check 'profiles: lines that lie close are told' has out 'The lines of the map lie close'
awk 'BEGIN { for (j = 0; j < 3; j++) { for (i = 0; i < 60; i++) printf "%.4f ", sin(i*(0.3 + 0.1*j)); print "" } }' >three.txt
run surface three.txt --profiles --height-unit um --step 0.01,1 --csv three.csv
check 'profiles: three lines' test "$status" -eq 0

# Two directions, and their geometric mean
run surface "$made"/across_*.csv --perpendicular "$made"/along_*.csv --csv both.csv --json both.json \
   --case both.nml
check 'profiles: m2 is the geometric mean' near "$(value both.csv m2)" "$(awk \
   -v a="$(value both.csv m2_x)" -v b="$(value both.csv m2_y)" 'BEGIN { print sqrt(a*b) }')" 1e-5
check 'profiles: along x as alone' near "$(value both.csv m4_x)" "$(value p.csv m4)" 1e-12
check 'profiles: the case tells both' has both.nml 'at right angles'
check 'profiles: the lay is told' has out 'The surface has a lay'

# The robust filter leaves pores deeper, and the line between them where it is
for kind in gaussian robust; do
   run surface "$made"/across_*.csv --long-cutoff 0.8 --long-filter $kind --csv $kind.csv
   check "profiles: $kind filter" test "$status" -eq 0
done
check 'profiles: robust keeps more of the pores' sh -c "awk 'BEGIN { exit !($(value robust.csv m0) \
   > 1.2*$(value gaussian.csv m0)) }'"
run surface --generate --map-points 96 --long-cutoff 0.4 --long-filter robust
check 'profiles: robust filter of a map' test "$status" -eq 0

run surface "$made/across_1.csv" --stylus-radius 0.005
check 'profiles: stylus' has out 'The stylus has a radius of 0.005 mm'
if command -v gnuplot >/dev/null; then
   run surface "$made"/across_*.csv --plot p.svg
   check 'profiles: picture' test "$status" -eq 0 -a -s p.svg
else
   skip 'profiles: picture' 'no gnuplot'
fi

# Bad input
um='--lateral-unit um --height-unit um'
# shellcheck disable=SC2086  # several words are meant
{
printf '1 2\n' >point.txt
refuses 'profiles: one point' 2 'point.txt: 1 points in a line are no profile' surface point.txt $um
printf '0 1\n1 2\n2 3\n3.4 2\n4 4\n5 3\n6 1\n' >unequal.txt
refuses 'profiles: unequal x' 2 'unequal.txt: the points are on no regular grid in x' \
   surface unequal.txt $um
awk 'BEGIN { for (i = 0; i < 50; i++) print 2*i, sin(i) }' >coarse.txt
awk 'BEGIN { for (i = 0; i < 50; i++) print i, sin(i) }' >fine.txt
refuses 'profiles: steps that differ' 2 'coarse.txt: its step, 0.002 mm, is not that of fine.txt, 0.001 mm' \
   surface fine.txt coarse.txt $um
awk 'BEGIN { for (i = 0; i < 50; i++) print i, (i % 5 ? sin(i) : "nan") }' >holes.txt
refuses 'profiles: many holes' 2 'holes.txt: 10 of 50 points are missing' surface holes.txt $um
run surface holes.txt $um --most-missing 0.3
check 'profiles: holes that are allowed' test "$status" -eq 0
awk 'BEGIN { for (i = 0; i < 50; i++) print i, (i % 5 ? sin(i) : "inf") }' >inf.txt
refuses 'profiles: no finite number' 2 'inf.txt:1:3: ' surface inf.txt $um
awk 'BEGIN { for (i = 0; i < 50; i++) print i, 3 + i }' >flat.txt
refuses 'profiles: a straight line' 2 'flat.txt: has no roughness' surface flat.txt $um
refuses 'profiles: a map among them' 2 'm.sdf: is a map of 200 x 90 points among profiles' \
   surface fine.txt m.sdf $um
refuses 'profiles: and the other way round' 2 'fine.txt: a second map is only taken with --pair' \
   surface m.sdf fine.txt $um
refuses 'profiles: of a pair' 2 'fine.txt: is a profile of 50 points, and no map' \
   surface fine.txt fine.txt --pair $um
refuses 'profiles: lines of a pair' 2 '--pair: adds the maps of two faces' \
   surface m.sdf m.sdf --pair --profiles
refuses 'profiles: too few lines of a map' 2 'three.txt: 60 x 3 points are no map: .*--profiles' \
   surface three.txt --height-unit um --step 0.01
refuses 'profiles: one twice' 2 'fine.txt: is given twice' surface fine.txt $um --perpendicular fine.txt
refuses 'profiles: peaks' 2 '--route paper: counts peaks' surface fine.txt $um --route paper
refuses 'profiles: summits' 2 '--verify: sums over the summits' surface fine.txt $um --verify
refuses 'profiles: as a map' 2 '--map: writes a map' surface fine.txt $um --map p.sdf
refuses 'profiles: tiles' 2 '--tiles: tiles = 0 is not allowed' surface fine.txt $um --tiles 0
refuses 'profiles: a stylus of a map' 2 '--stylus-radius: is for profiles' surface m.sdf \
   --stylus-radius 0.002
refuses 'profiles: a stylus without radius' 2 '--stylus-radius: stylus_radius = 0.0 mm' surface fine.txt \
   $um --stylus-radius 0
refuses 'profiles: a kind of filter without filter' 2 '--long-filter: is for --long-cutoff' surface \
   fine.txt $um --long-filter robust
cp fine.txt other.txt
refuses 'profiles: one of them as output' 2 '--case: other.txt is the map' surface fine.txt other.txt \
   $um --case other.txt
refuses 'profiles: one at right angles as output' 2 '--csv: fine.txt is the profile' surface \
   "$made/across_1.csv" --perpendicular fine.txt --csv fine.txt
}
