# two faces from numbers: formulas, precedence, sides, faces that are files, what is refused

# number FILE NAME: a property of a JSON file
number() { grep '^"properties"' "$1" | grep -o "\"$2\": [-+0-9.E]*" | cut -d ' ' -f 2; }
cross='--face-1 unpolished-cross' tangential='--face-2 unpolished-tangential'

run curve $cross $tangential --json f.json
check 'two faces: E* by Eq. 4' near "$(number f.json modulus)" \
   "$(awk 'BEGIN { printf "%.17g", 1/(0.8236/3727.12 + 0.8775/351.01) }')" 1e-15
check 'two faces: 1/R^2 adds' near "$(number f.json radius)" \
   "$(awk 'BEGIN { printf "%.17g", 1/sqrt(1/0.1477^2 + 1/0.1142^2) }')" 1e-15
check 'two faces: 1/(R^2 eta) adds' near "$(number f.json eta)" "$(awk 'BEGIN { a = 1/0.1477^2; b = 1/0.1142^2
   printf "%.17g", (a + b)/(a/206 + b/134) }')" 1e-15
check 'two faces: the softer one' near "$(number f.json hardness)" 12.14 0
check 'two faces: the note tells how' has out 'Faces: E* by Eq. 4; eta, radius, sigma of the sum of both'
check 'two faces: no note of a pair' lacks out 'Table 4'
check 'two faces: yield factor of the paper' has out 'as the pairs of the paper'
run curve $cross $tangential --hardness-rule harder --roughness-rule face_1 --modulus 297 --csv f.csv
cp out f.out
run curve --csv p.csv
check 'two faces by the rules of Table 4 are its pair' cmp f.csv p.csv
check 'two faces: no note of what is given' lacks f.out 'Faces:'
check 'a smooth face has no summits listed' lacks f.out 'sigma_2'
run curve --face-1 unpolished-radial --roughness-rule face_1 --hardness-1 9 --young-modulus-2 2e5 \
   --poisson-ratio-2 0.3 --hardness-2 2000 --json f.json
check 'wood on a smooth plate of steel' near "$(number f.json modulus)" \
   "$(awk 'BEGIN { printf "%.17g", 1/(0.8775/351.01 + 0.91/2e5) }')" 1e-15

# all pairs of sections
for one in cross tangential radial; do
   for other in cross tangential radial; do
      run curve --face-1 mesh-400-$one --face-2 mesh-400-$other --hardness-1 10 --hardness-2 11
      check "curve of $one on $other" test "$status" -eq 0
   done
done

# notes and sources are of what is used
run curve --surface unpolished-radial --hardness 12.14
check 'no note of values that are overridden' has out 'Pair: Table 4; E* not from Eq. 4'
run curve --modulus 300 --hardness 20 --eta 200 --sigma 0.05
check 'radius alone is of the pair' has out 'Pair: Table 4'
check 'nothing is told of the rest' lacks out 'read as|harder|Eq. 4'

# explicit values before faces, these before a surface and a pair, options before a case
run curve $cross $tangential --sigma 0.05 --json f.json
check 'an explicit value goes before the faces' near "$(number f.json sigma)" 0.05 0
run curve $cross $tangential --sigma-2 0.05 --young-modulus-1 1000 --json f.json
check 'a number of a face goes before its name' near "$(number f.json modulus)" \
   "$(awk 'BEGIN { printf "%.17g", 1/(0.8236/1000 + 0.8775/351.01) }')" 1e-15
run curve $cross $tangential --print-case
cp out faces.nml
check 'a case keeps the faces' has faces.nml "face_1 = 'unpolished-cross'"
check 'a case does not fix what they give' lacks faces.nml '^  (eta|modulus|sigma_1|young_modulus_1) ='
run curve $cross $tangential --csv f.csv
run curve faces.nml --csv g.csv
check 'the case is the same run' cmp f.csv g.csv
run curve faces.nml --face-1 mesh-400-tangential --json f.json
check 'an option names another face and section' near "$(number f.json young_modulus_1)" 351.01 0
run curve faces.nml --pair tangential-tangential --csv g.csv
run curve --pair tangential-tangential --csv f.csv
check 'a pair as an option goes before the faces of a case' cmp f.csv g.csv
run curve faces.nml --surface mesh-400-cross --csv g.csv
run curve --surface mesh-400-cross --csv f.csv
check 'so does a surface' cmp f.csv g.csv
printf "&asperity\n eta = 100.0, hardness = 9.0\n/\n" >own.nml
run curve own.nml $cross $tangential --csv g.csv
run curve $cross $tangential --csv f.csv
check 'faces as options go before the values of a case' cmp f.csv g.csv

# a face that is a case file
run surface --generate --map-points 128 --case scan.nml
check 'surface writes a face' test "$status" -eq 0
run curve --face-1 scan.nml --section-1 tangential --face-2 scan.nml --section-2 tangential --json f.json
eta=$(sed -n 's/^ *eta = \([^ ]*\).*/\1/p' scan.nml)
check 'a face by its case file: twice the same has its density' near "$(number f.json eta)" "$eta" 1e-14
check 'and the square root of two times its sigma' near "$(number f.json sigma)" \
   "$(awk -v s="$(number f.json sigma_1)" 'BEGIN { printf "%.17g", s*sqrt(2) }')" 1e-14
refuses 'a face that is not there' 3 '--face-1: no\.nml: cannot be read' curve --face-1 no.nml $tangential
refuses 'a face without summits' 2 '--face-1: own\.nml: gives no sigma' curve --face-1 own.nml $tangential
refuses 'a file that says no section' 2 'section_1 is not given: only the names' \
   curve --face-1 scan.nml $tangential

# half given
refuses 'one face alone' 2 'face_2 is not given: two faces need both' curve $cross
refuses 'one number of a face' 2 'face_2 is not given' curve $cross --hardness-2 10
refuses 'a face without its radius' 2 'radius_1 is not given' \
   curve --sigma-1 0.05 --eta-1 200 --section-1 tangential $tangential
refuses 'a section without hardness' 2 \
   'hardness_2 is not given: no hardness of the radial section of larch is known; give hardness_2$' \
   curve $cross --face-2 unpolished-radial
refuses 'the same where the wood has keys' 2 'hardness_2 .* give hardness_2 or hardness_radial$' \
   tenon $cross --face-2 unpolished-radial
refuses 'a face that is unknown' 2 "--face-1: face_1 = 'foo' is unknown; known surfaces: .*; or give the path" \
   curve --face-1 foo $tangential
refuses 'a section that is unknown' 2 '--section-1' curve $cross $tangential --section-1 oblique
refuses 'a rule without faces' 2 '--hardness-rule: needs two faces' curve --hardness-rule softer
refuses 'a surface beside two faces' 2 '--surface: has no effect' curve $cross $tangential --surface mesh-400-cross
refuses "Poisson's ratio above one" 2 '--poisson-ratio-2: poisson_ratio_2 = 1.2 is not allowed' \
   curve $cross $tangential --poisson-ratio-2 1.2
refuses 'a face that no face is' 2 '--sigma-1: sigma_1 = -1.0 is not allowed' curve $cross $tangential --sigma-1=-1

# the wood of a joint, and its sides
short='--amplitudes 2 --cycles 1 --side-pressure 0.4'
run tenon $short --csv p.csv
run tenon $short --side-eta 134 --side-modulus 263 --side-radius 0.1142 --side-hardness 12.14 \
   --side-yield-factor 0.4 --side-sigma 0.0416 --csv f.csv
check 'sides by their own numbers are their pair' cmp f.csv p.csv
check 'their numbers are listed' has out 'side_sigma'
run tenon $short --side-surface unpolished-tangential --csv f.csv
check 'sides by the surface of their pair are their pair' cmp f.csv p.csv
run tenon $short --side-face-1 unpolished-tangential --side-face-2 mesh-400-tangential \
   --young-modulus-r 400 --json f.json
check 'sides of two faces take the wood' near "$(number f.json side_modulus)" \
   "$(awk 'BEGIN { printf "%.17g", 400/0.8775/2 }')" 1e-15
check 'and make another joint' test "$status" -eq 0
run tenon $short --face-1 unpolished-radial --face-2 unpolished-radial --hardness-radial 10 \
   --young-modulus-t 250 --json f.json
check 'radial faces take E_T and nu_RT E_T/E_R' near "$(number f.json modulus)" \
   "$(awk 'BEGIN { nu = 0.35*250/351.01; printf "%.17g", 250/(1 - nu^2)/2 }')" 1e-15
check 'the wood that they take is listed' has out 'young_modulus_t'
refuses 'a number of the sides' 2 '--side-sigma: side_sigma = ' tenon $short --side-sigma 1e-9
refuses 'one face of the sides' 2 'side_face_2 is not given' tenon $short --side-face-1 unpolished-cross
run tenon $short $cross $tangential --sweep face_2=unpolished-tangential,mesh-400-tangential --csv f.csv
check 'faces are swept' test "$status" -eq 0 -a "$(rows f.csv)" -eq 2
for face in cross:normal tangential:along; do
   run deck shear --face-1 unpolished-${face%:*} $tangential --inp -
   grep -v '^\*\*' out >unsaid.inp
   run deck shear --face-1 unpolished-${face%:*} $tangential --upper-grain ${face#*:} --inp -
   grep -v '^\*\*' out >said.inp
   check "the grain of an upper disc of $face" cmp unsaid.inp said.inp
done
run deck shear --face-1 unpolished-tangential $tangential --upper-grain normal --inp -
check 'which is another deck' test "$(grep -v '^\*\*' out | cmp - said.inp | wc -l)" -eq 1
