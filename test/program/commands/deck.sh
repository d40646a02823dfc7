# asperity deck shear and asperity deck tenon: decks of CalculiX and ABAQUS. The meshes themselves are
# tested in the library; here it is the text, and what stock CalculiX makes of small models

run help deck tenon
cp out first
run deck tenon --help
check 'deck tenon --help is help deck tenon' cmp first out
check 'deck tenon describes its options' has out '--inp FILE'
run help deck shear
check 'help deck shear' has out 'usage: asperity deck shear'
refuses 'deck without a model' 2 'deck needs a model: deck shear or deck tenon' deck
refuses 'deck of an unknown model' 2 "unknown command 'deck beam'" deck beam
refuses 'option of the other deck' 2 '--tail: is an option of solid, frame, deck tenon' deck shear --tail 3

# A stiff case, unlike the defaults, whose numbers must be in every deck
cat >case.nml <<'CASE'
&asperity
   pair = 'tangential-tangential'
   sigma = 0.05
   critical_slip = 0.25
   initial_separation = 0.18
   diameter = 60.0
   normal_stress = 0.1
   displacement = 0.5, -0.5
   amplitudes = 2.0, 5.0
   cycles = 1, 2
   column_load = 1000.0
   clearance_below = 0.3
   young_modulus_r = 400.0
/
CASE
joint=(--mesh-size 60)
discs=(--mesh-size 8)
for model in shear tenon; do
   mesh=("${joint[@]}")
   [ $model = shear ] && mesh=("${discs[@]}")
   for contact in uinter table hard; do
      for solver in calculix abaqus; do
         deck=$model.$contact.$solver
         run deck $model case.nml "${mesh[@]}" --contact $contact --solver $solver --inp $deck.inp
         check "deck $deck" is_quiet
         check "deck $deck: says what made it" has $deck.inp \
            "**    asperity deck $model case.nml ${mesh[*]} --contact $contact --solver $solver"
         check "deck $deck: units" has $deck.inp '** Units: N, mm, MPa, s.'
         check "deck $deck: what is chosen is said" has $deck.inp '** Chosen, as the paper'
         check "deck $deck: short lines of plain characters" \
            sh -c "! grep -v '^\*\*    ' $deck.inp | grep -E '.{101}|[^ -~]'"
      done
      check "deck $model $contact: ABAQUS, not run" \
         has $model.$contact.abaqus.inp 'Not run: ABAQUS was not available'
      # nodes, elements, wood, surfaces, supports: the same up to what the solvers write differently
      for solver in calculix abaqus; do
         awk '/^\*\*/ { next }
            /^\*/ { own = /INTERACTION|BEHAVIOR|FRICTION|NODE PRINT|FILE|OUTPUT|CONTROLS/
               if (/^\*STEP/) { print "*STEP"; next } }
            !own' $model.$contact.$solver.inp >same.$solver
      done
      check "deck $model $contact: one model for both solvers" cmp same.calculix same.abaqus
      check "deck $model $contact: that is most of the deck" \
         test "$(wc -l <same.abaqus)" -gt "$(($(wc -l <$model.$contact.abaqus.inp)*3/4))"
      mv same.abaqus $model.$contact.same
   done
   check "deck $model: one mesh for UINTER and table" cmp $model.uinter.same $model.table.same
done

# The numbers of the case, in the order of PROPS
for deck in shear.uinter.calculix shear.uinter.abaqus tenon.uinter.calculix; do
   check "deck $deck: PROPS" has $deck.inp '0.5, 0.25, 134.0, 263.0, 3.141592653589793, 0.1142, 12.14, 0.4'
   check "deck $deck: PROPS, second line" has $deck.inp '0.05, 0.18, 1.0, 1.0'
done
check 'deck tenon: the sides have their own sigma and d0' has tenon.uinter.abaqus.inp '0.0416, 0.1664, 1.0, 1.0'
check 'deck tenon: the sides have the friction of the case' sh -c \
   'test "$(grep -c "^0.5, 0.25, 134.0" tenon.uinter.abaqus.inp)" -eq 2'
check 'deck: UINTER in CalculiX' has shear.uinter.calculix.inp \
   '*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=UINTER, PROPERTIES=12, DEPVAR=11, SEARCH DISTANCE=3.0'
check 'deck: the blank line of UINTER in ABAQUS' sh -c \
   'grep -A1 "^\*SURFACE INTERACTION, NAME=WOOD, USER, PROPERTIES=12, DEPVAR=11, UNSYMM$" shear.uinter.abaqus.inp \
      | tail -n 1 | grep -q "^$"'
# With memory: UINTER gets PROPS(14), a table cannot unload, and hard contact has nothing to remember
run deck shear case.nml "${discs[@]}" --unloading elastic --inp memory.inp
check 'deck: PROPS with memory' sh -c 'grep -q "UINTER, PROPERTIES=14, DEPVAR=11, SEARCH" memory.inp \
   && grep -q "^0.05, 0.18, 1.0, 1.0, 0.0, 1.0$" memory.inp && tr -d "\n*" <memory.inp | grep -q "accept unphysical, unloading"'
# With friction beyond one coefficient: as many PROPS and STATEV as it needs; ABAQUS' own friction where it can
while read -r name properties depvar options; do
   run deck shear case.nml "${discs[@]}" $options --inp $name.calculix.inp
   check "deck: PROPS and STATEV with $name" has $name.calculix.inp \
      "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=UINTER, PROPERTIES=$properties, DEPVAR=$depvar, SEARCH DISTANCE=3.0"
   run deck shear case.nml "${discs[@]}" $options --solver abaqus --inp $name.abaqus.inp
   for solver in calculix abaqus; do
      check "deck $name.$solver: syntax" python3 -B "$here/commands/check_deck.py" $solver $name.$solver.inp
   done
done <<'LIST'
decay 20 13 --static-friction-coefficient 0.6 --decay-slip 0.05
ellipse 23 13 --friction-coefficient-across 0.2 --grain-angle 30
points 35 13 --friction-points 0.1,1.2,2.0,0.6
summits 30 29 --stick summits
LIST
while read -r name card options; do
   run deck shear case.nml "${discs[@]}" $options --contact table --solver abaqus --inp $name.abaqus.inp
   check "deck: ABAQUS' own friction, $name" has $name.abaqus.inp "*FRICTION, ELASTIC SLIP=0.25$(tr -d - <<<"${card//_/ }")"
   check "deck $name.abaqus: syntax" python3 -B "$here/commands/check_deck.py" abaqus $name.abaqus.inp
done <<'LIST'
rate ,_EXPONENTIAL_DECAY --static-friction-coefficient 0.6 --decay-slip-rate 4
grain ,_ANISOTROPIC --friction-coefficient-across 0.2
limit ,_TAUMAX=2.5 --shear-limit 2.5
pressure - --friction-points 0.1,1.2,2.0,0.6
LIST
for model in shear tenon; do
   refuses "deck $model: a table cannot unload" 2 \
      '--unloading: unloading = elastic is not allowed with the law as a table' deck $model case.nml \
      --mesh-size 8 --contact table --unloading elastic --inp never.inp
done
run deck shear case.nml "${discs[@]}" --contact hard --unloading elastic --inp hard.inp
check 'deck: hard contact with memory' cmp <(grep -v '^\*\*' hard.inp) <(grep -v '^\*\*' shear.hard.calculix.inp)
run table case.nml --largest-pressure 12.14 --calculix law.inc
for solver in calculix abaqus; do
   check "deck: the rows of asperity table, $solver" sh -c "
      sed -n '/^\*SURFACE BEHAVIOR/,/FRICTION/{/^[-0-9]/p}' law.inc >rows
      sed -n '/^\*SURFACE BEHAVIOR/,/FRICTION/{/^[-0-9]/p}' shear.table.$solver.inp | tr -d , | paste - rows \
         | tr -d , | awk '{ if ((\$1 - \$3)^2 > 1e-20*\$3^2 || (\$2 - \$4)^2 > 1e-20*\$4^2) exit 1 } END { exit NR < 40 }'"
done
check 'deck: stick slope for CalculiX at the normal stress' \
   has shear.table.calculix.inp '0.5, 0.2' # 0.5*0.1/0.25
check 'deck: gcrit for ABAQUS' has shear.hard.abaqus.inp '*FRICTION, ELASTIC SLIP=0.25'
for deck in {shear,tenon}.hard.{calculix,abaqus}; do
   check "deck $deck: modulus of the case" has $deck.inp '3727.12, 400.0, 351.01, 0.62, 0.42, 0.35, 224.61, 280.32'
done
check 'deck: a step for each stroke' sh -c \
   'test "$(grep -c "^TIP, 3, 3, [-0-9]" tenon.hard.calculix.inp)" -eq 8 \
      && grep "^TIP, 3, 3," tenon.hard.calculix.inp | cut -d, -f4 | tr -d "\n" | grep -q "^ 0.0 2.0 -2.0 5.0 -5.0 5.0 -5.0 0.0$"'
run deck tenon case.nml --height 180 --length 250 --inp follows.inp
check 'deck tenon: sizes follow from the joint' sh -c '
   grep -q "^  mesh_size  *18.0 mm  *a tenth of height$" out && grep -q "^  column_height  *600.0 mm  *10/3 of height$" out \
      && grep -q "^  column_width  *250.0 mm  *as length$" out && grep -q "^  edge_relief  *1.8 mm  *a hundredth of height$" out'
check 'deck tenon: the column of that joint' has follows.inp '- Column 600.0 mm high and 250.0 mm wide'
run deck tenon case.nml --mesh-size 60 --rim-mesh-size 12 --mesh-growth 2 --inp graded.calculix.inp
check 'deck tenon: graded towards the rims' has graded.calculix.inp \
   '- Elements: edges of 12.0 mm at the rims of mortise and tenon, each 2.0 times its neighbour up'
check 'deck tenon: even meshes have no such words' lacks tenon.uinter.calculix.inp 'times its neighbour'
# both halves, within 1 % of the paper's 7144
run deck tenon "$root/examples/tenon_joint/paper_mesh.nml" --inp paper.calculix.inp
check 'deck tenon: elements of the paper, both halves' awk '$1 == "column" || $1 == "beam" { n += 2*$3 }
   END { print n; exit !(n == 7152 && (n/7144 - 1)^2 < 0.01^2) }' out
run deck tenon case.nml "${joint[@]}" --inp -
check 'deck: --inp - is the deck' sh -c 'sed "/^\*\*    asperity/d" out >a; sed "/^\*\*    asperity/d" tenon.uinter.calculix.inp | cmp - a'
run deck tenon case.nml "${joint[@]}" --criterion mises --field all --contact hard --inp plastic.calculix.inp
check 'deck: Mises in CalculiX is said' has plastic.calculix.inp 'Yield of CalculiX beside these elastic constants is that of Mises'
check 'deck: stress in all steps' test "$(grep -c '^\*EL FILE' plastic.calculix.inp)" \
   -eq "$(grep -c '^\*STEP' plastic.calculix.inp)"
check 'deck: plastic strain is written' sh -c \
   'test "$(grep -c "^S, PEEQ$" plastic.calculix.inp)" -eq "$(grep -c "^\*STEP" plastic.calculix.inp)"'
check 'deck: one curve a part, along the grain and across it' sh -c '
   grep -A1 "^\*PLASTIC" plastic.calculix.inp | grep -v "^--" | tr "\n" " " | grep -q "^\*PLASTIC 50.1, 0.0 \*PLASTIC 4.7, 0.0 $"'
run deck tenon case.nml "${joint[@]}" --criterion hill --solver abaqus --inp plastic.abaqus.inp
check 'deck: Hill in ABAQUS' sh -c 'grep -A1 "^\*POTENTIAL" plastic.abaqus.inp | grep -q "^10.659574468085"'
run deck tenon case.nml "${joint[@]}" --side-pressure 0 --contact table --inp open.calculix.inp
check 'deck: no sides' sh -c 'test "$(grep -c "^\*CONTACT PAIR" open.calculix.inp)" -eq 2 && ! grep EXPANSION open.calculix.inp'
check 'deck: springs may vanish then' has open.calculix.inp '** springs may vanish'
check 'deck: else they may not' lacks tenon.table.calculix.inp 'springs may vanish'

# --print-case gives the same deck
for model in shear tenon; do
   mesh=("${joint[@]}" --contact table --stick-pressure 0.3 --largest-pressure 9)
   [ $model = shear ] && mesh=("${discs[@]}" --upper-grain normal)
   run deck $model case.nml "${mesh[@]}" --inp direct.inp
   run deck $model case.nml "${mesh[@]}" --print-case
   cp out printed.nml
   check "deck $model: --print-case" is_quiet
   run deck $model printed.nml --inp printed.inp
   check "deck $model: --print-case gives the same deck" sh -c \
      'for i in direct printed; do sed "/^\*\*    asperity/d" $i.inp >$i.text; done; cmp direct.text printed.text'
done
run deck shear case.nml --upper-grain normal --inp on_end.inp
check 'deck shear: grain of the upper disc' sh -c \
   'grep -A1 "NAME=UPPER_AXES" shear.hard.abaqus.inp | grep -q "^1.0, 0.0, 0.0" && 
    grep -A1 "NAME=UPPER_AXES" on_end.inp | grep -q "^0.0, 0.0, 1.0"'

# Bad input: a clear error, nothing written
refuses 'deck: unknown pair' 2 "--pair: pair = 'foo' is unknown; known pairs" \
   deck shear --pair foo --inp never.inp
refuses 'deck: mesh larger than the disc' 2 \
   '--mesh-size: mesh_size = 11.0 mm is larger than the part: disc_height is 10.0 mm' \
   deck shear --mesh-size 11 --inp never.inp
refuses 'deck: mesh larger than the beam' 2 \
   '--mesh-size: mesh_size = 106.0 mm is larger than the part: width is 105.0 mm' \
   deck tenon --mesh-size 106 --inp never.inp
refuses 'deck: rims coarser than the rest' 2 \
   '--rim-mesh-size: rim_mesh_size = 31.0 mm is larger than mesh_size, 30.0 mm' \
   deck tenon --rim-mesh-size 31 --inp never.inp
refuses 'deck: rims in metres' 2 '--rim-mesh-size: rim_mesh_size = 0.008 mm .* metres, write 8.0' \
   deck tenon --rim-mesh-size 0.008 --inp never.inp
refuses 'deck: edges that do not grow' 2 '--mesh-growth: mesh_growth = 1.0 is not allowed' \
   deck tenon --rim-mesh-size 8 --mesh-growth 1 --inp never.inp
refuses 'deck: no mesh' 2 '--mesh-size: mesh_size = 0.0 is not allowed' \
   deck tenon --mesh-size 0 --inp never.inp
refuses 'deck: pressure above the hardness' 2 \
   '--largest-pressure: largest_pressure = 25.0 MPa is above the hardness, 24.53 MPa' \
   deck shear --contact table --largest-pressure 25 --inp never.inp
refuses 'deck: a side pressure that the law cannot reach' 2 \
   '--side-pressure: side_pressure = 13.0 MPa is above the hardness, 12.14 MPa' \
   deck tenon --side-pressure 13 --accept-sizes --inp never.inp
refuses 'deck: a mesh in metres' 2 \
   '--mesh-size: mesh_size = 0.03 mm is outside 0.5 to 490.0 mm: 0.03 looks like metres, write 30.0' \
   deck tenon --mesh-size 0.03 --inp never.inp
refuses 'deck: a mesh in micrometres' 2 \
   '--mesh-size: mesh_size = 2500.0 mm .* looks like micrometres, write 2.5' \
   deck shear --mesh-size 2500 --inp never.inp
refuses 'deck: a disc in metres' 2 '--disc-height: disc_height = 0.01 mm .* metres, write 10.0' \
   deck shear --disc-height 0.01 --inp never.inp
refuses 'deck: a column in metres' 2 '--column-height: column_height = 1.0 mm .* metres, write 1000.0' \
   deck tenon --column-height 1 --inp never.inp
refuses 'deck: a column width in micrometres' 2 '--column-width: .* micrometres, write 300.0' \
   deck tenon --column-width 3e5 --inp never.inp
refuses 'deck: a tail in metres' 2 '--tail: tail = 0.04 mm .* metres, write 40.0' \
   deck tenon --tail 0.04 --inp never.inp
refuses 'deck: a relief in metres' 2 '--edge-relief: edge_relief = 0.003 mm .* metres, write 3.0' \
   deck tenon --edge-relief 0.003 --inp never.inp
refuses 'deck: an interference in metres' 2 '--side-interference: .* metres, write 0.3' \
   deck tenon --side-interference 0.0003 --inp never.inp
refuses 'deck: a search distance in micrometres' 2 '--search-distance: .* micrometres, write 3.0' \
   deck tenon --search-distance 3000 --inp never.inp
refuses 'deck: a load in kN' 2 '--column-load: column_load = 54.0 N .* kN, write 54000.0' \
   deck tenon --column-load 54 --inp never.inp
refuses 'deck: a normal stress that the law cannot reach' 2 \
   '--normal-stress: normal_stress = 25.0 MPa is above the hardness, 24.53 MPa' \
   deck shear --normal-stress 25 --accept-sizes --inp never.inp
refuses 'deck: too many rows' 2 '--rows: rows = 30 is too few' \
   deck shear --contact table --rows 30 --inp never.inp
refuses 'deck: too many rows for CalculiX' 2 '--rows: rows = 900 lets the table have' \
   deck shear --contact table --rows 900 --tolerance 1e-4 --inp never.inp
run deck shear --contact table --rows 900 --tolerance 1e-4 --solver abaqus --inp many.inp
check 'deck: more rows for ABAQUS' is_quiet
for rule in free force; do
   refuses "deck: axial_rule = $rule" 2 \
      "--axial-rule: axial_rule = $rule leaves the beam without axial hold" \
      deck tenon --axial-rule $rule --inp never.inp
done
refuses 'deck: shoulders' 2 '--shoulders: shoulders = true is not in the deck' \
   deck tenon --shoulders --inp never.inp
refuses 'deck: rigid column' 2 '--column: column = rigid is not in the deck' \
   deck tenon --column rigid --inp never.inp
refuses 'deck: column too narrow' 2 '--column-width: column_width = 100.0 mm is too small' \
   deck tenon --column-width 100 --inp never.inp
refuses 'deck: several normal stresses' 2 '--normal-stress: normal_stress has 2 values' \
   deck shear --normal-stress 0.1,0.2 --inp never.inp
refuses 'deck: no increments' 2 '--stroke-increments: stroke_increments = 0' \
   deck tenon --stroke-increments 0 --inp never.inp
refuses 'deck: side interference' 2 '--side-interference: side_interference = -0.1 mm is not' \
   deck tenon --side-interference -0.1 --inp never.inp
refuses 'deck: folder does not exist' 3 '--inp: no/x.inp cannot be written' deck shear --inp no/x.inp
refuses 'deck: the case file as deck' 2 '--inp: case.nml is the case file' \
   deck shear case.nml --inp case.nml
check 'deck: nothing is written then' sh -c '! ls never* 2>/dev/null'

# Wood: one group of keys. Curves in pairs, in either deck and solver, and in what --print-case writes
for solver in calculix abaqus; do
   points=0,4.7,0.1,5.5 rows='4.7, 0.0 5.5, 0.1'
   [ $solver = abaqus ] && points=$points,0.4,9 rows="$rows 9.0, 0.4"
   curve=(--hardening-curve $points --hardening-curve-along 0,50.1,0.05,60 --criterion mises)
   run deck tenon case.nml "${joint[@]}" "${curve[@]}" --contact hard --solver $solver --inp curve.$solver.inp
   check "deck tenon $solver: a curve a part" sh -c '
      grep -A3 "^\*PLASTIC" $1 | tr "\n" " " | grep -q "PLASTIC 50.1, 0.0 60.0, 0.05 .*PLASTIC $2"' \
      _ curve.$solver.inp "$rows"
   run deck shear case.nml "${discs[@]}" "${curve[@]}" --upper-grain normal --solver $solver --inp discs.$solver.inp
   check "deck shear $solver: lower disc across, upper along the grain" sh -c '
      grep -A3 "^\*PLASTIC" $1 | tr "\n" " " | grep -q "PLASTIC $2 .*PLASTIC 50.1, 0.0 60.0, 0.05"' \
      _ discs.$solver.inp "$rows"
done
check 'deck: what does not act is not listed' lacks out 'hardening_across|tension_strength_l|compression_strength_t'
run deck tenon case.nml "${joint[@]}" "${curve[@]}" --contact hard --solver abaqus --print-case
cp out curve.nml
run deck tenon curve.nml --inp again.inp
check 'deck: --print-case keeps the curve' sh -c \
   'for i in curve.abaqus again; do sed "/^\*\*    asperity/d" $i.inp >$i.text; done; cmp curve.abaqus.text again.text'
run deck tenon case.nml "${joint[@]}" --wood larch --contact hard --inp larch.inp
check 'deck: --wood goes before the case' has larch.inp '3727.12, 351.01, 351.01, 0.62, 0.42, 0.35, 224.61, 280.32'
run deck tenon case.nml "${joint[@]}" --wood larch --young-modulus-t 300 --contact hard --inp larch.inp
check 'deck: a value goes before --wood' has larch.inp '3727.12, 351.01, 300.0, 0.62, 0.42, 0.35, 224.61, 280.32'
check 'deck: and where it comes from' sh -c \
   'grep -q "^  young_modulus_r  *351.01 MPa  *wood larch$" out && grep -q "^  young_modulus_t  *300.0 MPa  *--young-modulus-t$" out'
for key in young_modulus_{l,r,t} shear_modulus_{lr,lt,rt} compression_strength_{l,r,t} \
   tension_strength_{l,r,t} shear_strength_{lr,lt,rt}; do
   for model in shear tenon; do
      refuses "deck $model: $key in Pa" 2 "--${key//_/-}: $key = .* MPa is outside .* looks like Pa, write" \
         deck $model --${key//_/-} 5e7 --inp never.inp
   done
   refuses "deck: no $key" 2 "--${key//_/-}: $key = 0.0 is not allowed" deck shear --${key//_/-} 0 --inp never.inp
done
for key in hardening_along hardening_across; do
   refuses "deck: negative $key" 2 "--${key//_/-}: $key = -0.1 is not allowed" \
      deck shear --${key//_/-} -0.1 --inp never.inp
done
for key in poisson_ratio_{lr,lt,rt}; do
   refuses "deck: $key too large" 2 "--${key//_/-}: $key = 5.0 is not allowed: it must be a number between" \
      deck tenon --${key//_/-} 5 --inp never.inp
done
refuses 'deck: half a pair' 2 '--hardening-curve: hardening_curve has 3 values: it takes pairs' \
   deck tenon --hardening-curve 0,4.7,0.1 --inp never.inp
refuses 'deck: a curve from elsewhere' 2 \
   '--hardening-curve: hardening_curve begins at .* 4.6 MPa: it must begin at 0 and compression_strength_r = 4.7 MPa' \
   deck tenon --hardening-curve 0,4.6,0.1,5 --inp never.inp
refuses 'deck: a curve that softens' 2 '--hardening-curve-along: .* stresses must not fall' \
   deck tenon --hardening-curve-along 0,50.1,0.1,40 --inp never.inp
refuses 'deck: a curve that CalculiX does not follow' 2 '--hardening-curve: hardening_curve has 3 points: beside nine' \
   deck shear --criterion mises --hardening-curve 0,4.7,0.1,5,0.2,6 --inp never.inp
refuses 'deck: unknown wood' 2 "--wood: wood = 'oak' is unknown; known: larch" deck shear --wood oak --inp never.inp
refuses 'deck: unknown criterion' 2 "--criterion: .* known: none, mises, hill, crushing" \
   deck shear --criterion tresca --inp never.inp
for model in shear tenon; do
   refuses "deck $model: Hill in CalculiX" 2 '--criterion: criterion = hill cannot be written for CalculiX' \
      deck $model --criterion hill --inp never.inp
   for solver in calculix abaqus; do
      refuses "deck $model: crushing in $solver" 2 '--criterion: criterion = crushing cannot be written: no card' \
         deck $model --criterion crushing --solver $solver --inp never.inp
   done
   refuses "deck $model: Hill without a closed surface" 2 '--compression-strength-t: compression_strength_l = 50.1, .* are not allowed with criterion' \
      deck $model --criterion hill --solver abaqus --compression-strength-t 4 --inp never.inp
done
refuses 'deck: a key that has another name now' 2 '--plasticity: unknown option of deck tenon; did you mean --criterion' \
   deck tenon --plasticity plastic --inp never.inp
check 'deck: nothing is written then either' sh -c '! ls never* 2>/dev/null'

# Syntax, and that the checker finds what is wrong
if command -v python3 >/dev/null; then
   syntax() { python3 -B "$here/commands/check_deck.py" "$@"; }
   finds() { ! syntax "$1" wrong.inp >wrong.log && grep -q "$2" wrong.log; }
   for deck in {shear,tenon}.{uinter,table,hard}.{calculix,abaqus} {plastic,curve,discs}.{calculix,abaqus} {open,graded,paper}.calculix; do
      check "deck $deck: syntax" syntax ${deck##*.} $deck.inp
   done
   sed '/USER/{n;d;}' shear.uinter.abaqus.inp >wrong.inp
   check 'deck syntax: UINTER without the blank line' finds abaqus 'the blank data line'
   sed 's/PROPERTIES=12/PROPERTIES=11/' shear.uinter.calculix.inp >wrong.inp
   check 'deck syntax: PROPERTIES' finds calculix 'PROPERTIES is not the number'
   sed 's/^UPPER_FACE, LOWER_FACE/UPPER_FACE, FACE/' shear.hard.calculix.inp >wrong.inp
   check 'deck syntax: surface' finds calculix 'no such surface'
   sed '/^\*FRICTION/,+1d' shear.table.calculix.inp >wrong.inp
   check 'deck syntax: friction' finds calculix 'WOOD is not complete'
   sed 's/^\*NSET, NSET=TIP/*NSET, NSET=TOP2/' tenon.hard.abaqus.inp >wrong.inp
   check 'deck syntax: set' finds abaqus 'no node set TIP'
   sed 's/^\*CONTROLS.*/*CONTROL/' tenon.hard.calculix.inp >wrong.inp
   check 'deck syntax: keyword' finds calculix 'CONTROL is unknown'
   check 'deck syntax: the other solver' sh -c \
      '! python3 -B "$1" abaqus shear.table.calculix.inp | grep -q " 0 faults"' _ "$here/commands/check_deck.py"
   sed 's/^0.5, 0.25, 134.0/0.5, 0.25, 134.00000000000000000/' shear.uinter.abaqus.inp >wrong.inp
   check 'deck syntax: long field' finds abaqus 'more than 20 characters'
   sed '/^\*ELEMENT/{n;d;}' shear.hard.abaqus.inp >wrong.inp
   check 'deck syntax: element missing' finds abaqus 'no element 1'
else
   skip 'deck syntax' 'no python3'
fi

# In stock CalculiX: the forces of each increment, step by step. solve NAME: leaves NAME.dat
solve() {
   OMP_NUM_THREADS=1 timeout 600 ccx -i "$1" >"$1.log" 2>&1 && grep -q 'Job finished' "$1.log"
}
# sums NAME SET: times and sums of the forces
sums() {
   awk -v set="$2" '/total force/ && $0 ~ "for set " set " " { time = $NF; getline; getline
      print time, $1, $2, $3 }' "$1.dat"
}
# balance NAME SCALE SET...: forces of the sets add up to nothing in z, within 1e-4 of a scale, N
balance() {
   local name=$1 scale=$2 set
   shift 2
   for set in "$@"; do sums "$name" "$set"; done | awk -v scale="$scale" '
      { sum[$1] += $4; n++ }
      END { for (t in sum) if (sum[t]^2 > (1e-4*scale)^2) { print t, sum[t]; bad = 1 }
         exit bad || n < 8 }'
}
if command -v ccx >/dev/null; then
   for contact in table hard; do
      run deck shear --mesh-size 10 --displacement 0.8 --displacement-increment 0.1 --contact $contact \
         --inp discs.inp
      check "deck shear $contact: CalculiX converges" solve discs
      check "deck shear $contact: balance" balance discs 150 BOTTOM TOP
      # 0.05 MPa on pi/4 61.8^2, mu 0.5; 75 N where it slips, less what sticks at lost nodes
      check "deck shear $contact: normal force and friction" sh -c "tail -n 400 discs.dat >/dev/null
         $(declare -f sums); sums discs BOTTOM | tail -n 1 | awk '{ n = 0.05*3.14159265*61.8^2/4; print
            exit !((\$4/n - 1)^2 < 1e-8 && (\$2/(0.5*n) - 1)^2 < 1e-6) }'"
      # first step: the overclosure is that of the mesh, as the law carries the load there
      check "deck shear $contact: closure under the normal stress" awk '
         /displacements.*set (LOWER|UPPER)_MIDDLE and time  0.1000000E.01/ {
            s = /UPPER/ ? -1 : 1; getline; getline; more += s*$4; n++ }
         END { print more, n; exit !(n == 2 && more^2 < 2e-4^2) }' discs.dat
      run deck tenon --mesh-size 75 --amplitudes 3 --column-load 54000 --stroke-increments 5 \
         --contact $contact --inp joint.inp
      check "deck tenon $contact: CalculiX converges" solve joint
      check "deck tenon $contact: balance" balance joint 3000 BOTTOM TOP TIP
      check "deck tenon $contact: every stroke resists" sh -c "$(declare -f sums)
         sums joint TIP | awk '\$1 == 3 && \$4 > 1000 { up++ } \$1 == 4 && \$4 < -1000 { down++ }
            END { exit !(up == 1 && down == 1) }'"
   done
else
   skip 'decks in CalculiX' 'no ccx'
fi
