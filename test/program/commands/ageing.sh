# Old wood, in the commands that take it

# Factors of 1 are new wood, to the bit
faces=(--ageing-stiffness-along 1 --ageing-stiffness-across 1 --ageing-hardness 1)
most=("${faces[@]}" --ageing-stiffness-shear 1
   --ageing-strength-compression-along 1 --ageing-strength-compression-across 1
   --ageing-strength-tension-along 1 --ageing-strength-tension-across 1 --ageing-strength-shear 1)
all=("${most[@]}" --ageing-friction 1)
joint=(--amplitudes 4,24 --face-points 40 --side-points 4 --displacement-increment 2)
run curve --csv new.csv
run curve "${faces[@]}" --csv old.csv
check 'ageing: neutral factors in curve' cmp new.csv old.csv
check 'ageing: neutral factors are not listed' lacks out ageing
run tenon "${joint[@]}" --side-pressure 0.4 --csv new_joint.csv
run tenon "${joint[@]}" --side-pressure 0.4 "${all[@]}" --csv old_joint.csv
check 'ageing: neutral factors in tenon' cmp new_joint.csv old_joint.csv
run deck shear --mesh-size 10 --inp new.inp
run deck shear --mesh-size 10 "${all[@]}" --inp old.inp
check 'ageing: neutral factors in deck shear' sh -c 'sed 4d new.inp >a; sed 4d old.inp >b; cmp a b'

# One factor on E* and H scales the pressure by it at any separation, exactly for a power of two
scales() { # NEW OLD FACTOR TOLERANCE COLUMN...
   local new=$1 old=$2 factor=$3 tolerance=$4
   shift 4
   paste -d, "$new" "$old" | awk -F, -v names="$*" -v factor="$factor" -v tolerance="$tolerance" '
      NR == 1 { n = split(names, name, " "); columns = NF/2
         for (i = 1; i <= columns; i++) { sub(/ \(.*/, "", $i); place[$i] = i }; next }
      { for (j = 1; j <= n; j++) { i = place[name[j]]; d = factor*$i - $(columns + i)
           if (i == 0 || d*d > (tolerance*$(columns + i))^2) { print NR, name[j], $i, $(columns + i); bad = 1 } } }
      END { exit bad || NR < 3 }'
}
halves=(--ageing-stiffness-along 0.5 --ageing-stiffness-across 0.5 --ageing-hardness 0.5)
for pair in transverse-tangential tangential-tangential; do
   run curve --pair $pair --csv new.csv
   run curve --pair $pair "${halves[@]}" --csv old.csv
   check "ageing: half of E* and H is half of the pressure, $pair" \
      scales new.csv old.csv 0.5 0 pressure stiffness energy
   check "ageing: and the same area and shares, $pair" scales new.csv old.csv 1 0 \
      area_fraction contact_density elastic_share elastoplastic_share plastic_share
   run curve --pair $pair "${halves[@]//0.5/0.7}" --csv old.csv
   check "ageing: as with another factor, $pair" scales new.csv old.csv 0.7 1e-14 pressure
done
check 'ageing: the listing says what was aged' grep -Eq '^  hardness +8.498 MPa +pair tangential-tangential, aged$' out

# A whole joint of it, springs and loads too, has moments that are scaled by it
run tenon "${joint[@]}" "${most[@]//1/0.5}" --axial-stiffness 250 --side-pressure 0.2 --csv old_joint.csv
check 'ageing: a whole joint scales' \
   scales new_joint.csv old_joint.csv 0.5 1e-6 moment normal_upper friction_dissipation

# What is given is taken as it stands; what presets give is aged, and both say so
source_of() { sed -n "s/^  $1  *[^ ]* MPa  *//p" out; }
run curve --modulus 200 --ageing-stiffness-across 0.5 --ageing-hardness 0.5
check 'ageing: a modulus that is given stays' test "$(source_of modulus)" = --modulus
check 'ageing: a hardness that is not, does not' grep -q '^  hardness  *12.265 MPa .*, aged$' out
run shear --ageing-friction 0.5 --shrinking-overlap --csv s.csv
check 'ageing: friction of a pair' grep -q '^  friction_coefficient  *0.25 .*, aged$' out
run shear --friction-coefficient 0.5 --ageing-friction 0.5
check 'ageing: friction that is given' grep -q '^  friction_coefficient  *0.5  *--friction-coefficient$' out
run tenon "${joint[@]}" --side-pressure 0.4 --ageing-friction 0.5
check 'ageing: friction of the sides' grep -q '^  side_friction  *0.25  *as friction_coefficient$' out

# Two faces: Eq. 4 of the old constants of their sections, which the rows of each face say
two=(--face-1 unpolished-cross --face-2 unpolished-tangential)
run curve "${two[@]}" --ageing-stiffness-along 0.5 --ageing-stiffness-across 0.8 --ageing-hardness 0.9
check 'ageing: E* of two faces' sh -c 'near() { awk -v a="$1" -v b="$2" "BEGIN { exit !((a/b - 1)^2 < 1e-10) }"; }
   near "$(sed -n "s/^  modulus *\([0-9.]*\) .*/\1/p" out)" \
      "$(awk "BEGIN { print 1/((1 - 0.42^2)/(0.5*3727.12) + (1 - 0.35^2)/(0.8*351.01)) }")"'
check 'ageing: the softer of two old faces' grep -q '^  hardness  *10.926 MPa  *face_1 and face_2$' out
check 'ageing: the modulus of a section' grep -q '^  young_modulus_2  *280.808 MPa  *tangential section, aged$' out
check 'ageing: its ratio does not age' grep -q '^  poisson_ratio_2  *0.35  *tangential section$' out
run curve "${two[@]}" --csv new.csv
run curve "${two[@]}" "${halves[@]}" --csv old.csv
check 'ageing: half of two faces is half of the pressure' scales new.csv old.csv 0.5 0 pressure stiffness
run shear "${two[@]}" --ageing-friction 0.5 --hardness-2 11 --ageing-hardness 0.5
check 'ageing: friction of two faces' grep -q '^  friction_coefficient  *0.25 .*, aged$' out
check 'ageing: a hardness of a face that is given' grep -q '^  hardness_2  *11.0 MPa  *--hardness-2$' out
run curve --modulus 200 --ageing-stiffness-along 0.5
check 'ageing: the listing says what is not aged' has out 'Old wood: as given, not aged: modulus'

# Each command hands the wood on: cards of a deck, strengths of a replay
run deck shear --mesh-size 10 --ageing-stiffness-along 0.5 --ageing-stiffness-shear 0.25 --inp old.inp
check 'ageing: moduli of a deck' grep -q '^1863.56, 351.01, 351.01, 0.62, 0.42, 0.35, 56.1525, 70.08' old.inp
run deck tenon --mesh-size 100 --ageing-stiffness-across 0.5 --inp old.inp
check 'ageing: moduli of the other deck' grep -q '^3727.12, 175.505, 175.505, 0.62, 0.42, 0.35, ' old.inp
run tenon "${joint[@]}" --ageing-strength-compression-across 0.5 --csv aged.csv
check 'ageing: the new wood is listed' grep -q '^  compression_strength_r  *4.7 MPa  *wood larch$' out
check 'ageing: beside its factor' \
   grep -q '^  ageing_strength_compression_across 0.5 *--ageing-strength-compression-across$' out
run tenon "${joint[@]}" --compression-strength-r 2.35 --csv weak.csv
check 'ageing: a factor or the strength itself' cmp aged.csv weak.csv
run tenon "${joint[@]}" --criterion none --ageing-strength-compression-across 0.5
check 'ageing: a factor of what does not act is not listed' lacks out ageing

# A case file of the input gives the same run, and a sweep has a column for a long name
old=(--ageing-stiffness-across 0.7 --ageing-hardness 0.8 --ageing-friction 0.9
   --ageing-strength-compression-across 0.73)
run tenon "${joint[@]}" "${old[@]}" --print-case
cp out old.nml
run tenon "${joint[@]}" "${old[@]}" --csv options.csv
run tenon old.nml --csv case.csv
check 'ageing: a printed case' cmp options.csv case.csv
run tenon "${joint[@]}" --sweep ageing_strength_compression_across=1,0.5 --csv sweep.csv
check 'ageing: a sweep' is_quiet
check 'ageing: weaker wood, smaller moment' csv sweep.csv '
   if (NR == 3 && !(abs(c["ultimate_moment_rough"]) < 0.8*abs(before["ultimate_moment_rough"]))) fail("moment")'

# Bad input
for key in stiffness_along stiffness_across stiffness_shear hardness strength_compression_along \
   strength_compression_across strength_tension_along strength_tension_across strength_shear friction; do
   option=--ageing-${key//_/-}
   for value in 0 73 -0.5; do
      refuses "ageing: $key = $value" 2 "$option: ageing_$key = .* must be a factor between 0.01 and 10.0" \
         tenon "$option" "$value"
   done
done
printf '&asperity\n  ageing_hardness = 0.0\n/\n' >bad.nml
refuses 'ageing: a case file' 2 'bad.nml:2: ageing_hardness = 0.0 is not allowed' curve bad.nml
refuses 'ageing: moduli that no longer go together' 2 \
   '--ageing-stiffness-along: poisson_ratio_lr = 0.62 .*so it is in old wood' curve --ageing-stiffness-along 0.02
refuses 'ageing: strengths are not of faces alone' 2 '--ageing-strength-shear' curve --ageing-strength-shear 0.5
