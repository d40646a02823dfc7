# asperity curve: columns, formulas, presets

header=separation,closure,pressure,stiffness,area_fraction,contact_density,energy,\
elastic_share,elastoplastic_share,plastic_share,validity
for pair in transverse-tangential tangential-tangential; do
   run curve --pair $pair --csv c.csv --json c.json
   check "curve $pair" test "$status" -eq 0
   check "curve $pair: columns" test "$(columns c.csv)" = "$header"
   check "curve $pair: 41 separations" test "$(rows c.csv)" -eq 41
   check "curve $pair: 17 figures" numbers_are_proper c.csv
   # 4 eps: the shares are three rounded quotients of one sum
   check "curve $pair: shares sum to one" csv c.csv \
      'if (far(c["elastic_share"] + c["elastoplastic_share"] + c["plastic_share"], 1, 9e-16)) fail("sum")'
   check "curve $pair: closer is stiffer" csv c.csv \
      'if (NR > 2 && (c["pressure"] <= before["pressure"] || c["stiffness"] <= before["stiffness"])) fail("not monotone")'
   check "curve $pair: JSON holds the same figures" same_csv_and_json c.csv c.json
done

run curve --csv c.csv
cp c.csv default.csv
check 'default pair is named' has out 'transverse-tangential   default'
run curve --pair transverse-tangential --csv c.csv
check 'default pair is transverse-tangential' cmp c.csv default.csv
check 'closure = 4 sigma - separation' csv default.csv \
   'if (c["closure"] != 0.2372 - c["separation"]) fail(c["closure"])'
check 'first separation is 4 sigma, last is 0' csv default.csv \
   'if (NR == 2 && c["separation"] != 4*0.0593 || NR == 42 && c["separation"] != 0) fail("end")'
run curve --initial-separation -0.01 --separation 0.05,0 --csv c.csv
check 'negative initial separation' csv c.csv \
   'if (c["closure"] != -0.01 - c["separation"]) fail(c["closure"])'

# The plane below all summits, d = -30 sigma: every summit is plastic, pressed by |d| on average,
# F = 2 pi R H w: all columns in closed form. 1e-14: a few roundings of the closed form itself
run curve --separation=-1.779 --csv deep.csv
check 'deep contact in closed form, transverse-tangential' csv deep.csv '
   pi = 3.14159265358979323846; s = 2*pi*206*0.1477*24.53; d = 1.779
   if (far(c["pressure"], s*d, 1e-14)) fail("pressure")
   if (far(c["stiffness"], s, 1e-14)) fail("stiffness")
   if (far(c["area_fraction"], s*d/24.53, 1e-14)) fail("area")
   if (far(c["contact_density"], 206, 1e-14)) fail("density")
   if (c["plastic_share"] != 1) fail("share")'
run curve --pair tangential-tangential --separation=-1.248 --csv deep.csv
check 'deep contact in closed form, tangential-tangential' csv deep.csv '
   pi = 3.14159265358979323846; s = 2*pi*134*0.1142*12.14; d = 1.248
   if (far(c["pressure"], s*d, 1e-14)) fail("pressure")
   if (far(c["stiffness"], s, 1e-14)) fail("stiffness")
   if (far(c["area_fraction"], s*d/12.14, 1e-14)) fail("area")
   if (far(c["contact_density"], 134, 1e-14)) fail("density")
   if (c["plastic_share"] != 1) fail("share")'

# So hard that nothing yields: Hertz, p = 4/3 E* R^1/2 sigma^3/2 eta F_3/2(d/sigma) with
# F_3/2(0) = 0.43001999 and F_3/2(2) = 0.0066481776, known to half a unit of the last figure
run curve --hardness 1e7 --accept-unphysical --yield-factor 1 --separation 0,0.1186 --csv hertz.csv
check 'elastic contact is Hertz' csv hertz.csv '
   p = 4/3*297*sqrt(0.1477)*0.0593^1.5*206*(NR == 2 ? 0.43001999 : 0.0066481776)
   if (far(c["pressure"], p, 2e-8)) fail(c["pressure"] " not " p)
   if (far(c["elastic_share"], 1, 1e-15)) fail("share")'

# Lengths times 2, density over 4: same pressure at the same d/sigma, powers of two are exact
run curve --sigma 0.1186 --radius 0.2954 --eta 51.5 --csv scaled.csv
csv_column scaled.csv pressure >scaled
csv_column default.csv pressure >unscaled
check 'lengths scale' cmp scaled unscaled

# Central differences over 2e-5 sigma: -dp/dd is the stiffness, -d energy/dd the pressure. Their
# error is about (1e-5 h)^2 = 1e-9, and 1e-16/1e-5 = 1e-11 of rounding
h=0.000000593
run curve --csv slopes.csv --separation "$(awk -v h=$h 'BEGIN { for (i = -4; i <= 8; i++)
   { d = 0.0593*i/2; printf "%s%.17g,%.17g,%.17g", (i > -4 ? "," : ""), d + h, d, d - h } }')"
check 'stiffness and pressure are slopes' csv slopes.csv '
   k = (NR - 2) % 3; d[k] = c["separation"]; p[k] = c["pressure"]; e[k] = c["energy"]
   if (k == 1) { s = c["stiffness"] }
   if (k == 2) {
      if (far((p[2] - p[0])/(d[0] - d[2]), s, 1e-8)) fail("stiffness " s)
      if (far((e[2] - e[0])/(d[0] - d[2]), p[1], 1e-8)) fail("pressure " p[1]) }'

# 30-digit values through options and CSV: 1e-12, as promised for the law
awk -F, '$1 == "paper" || $1 == "plausible"' "$root/test/data/normal_law_reference.csv" >reference
: >found
while IFS=, read -r kind sigma eta modulus radius hardness k h separation rest; do
   run curve --sigma "$sigma" --eta "$eta" --modulus "$modulus" --radius "$radius" \
      --hardness "$hardness" --yield-factor "$k" --separation "$separation" \
      --accept-unphysical --csv c.csv
   tail -n 1 c.csv | cut -d, -f3-10 >>found
done <reference
cut -d, -f10-17 reference >expected
paste -d, found expected >both
check "60 reference values" awk -F, '
   function abs(x) { return x < 0 ? -x : x }
   { for (i = 1; i <= 8; i++) if ($(i + 8) > 1e-300) {
      n++; e = abs($i - $(i + 8))/$(i + 8); if (e > worst) worst = e } }
   END { print n, worst; exit !(NR == 60 && n > 400 && worst < 1e-12) }' both

run curve --separation 0.1:0.2:5 --csv range.csv
check 'range start:stop:count' test "$(csv_column range.csv separation | tr '\n' ' ')" = \
"1.0000000000000001E-001 1.2500000000000000E-001 1.5000000000000002E-001 1.7500000000000002E-001 2.0000000000000001E-001 "
run curve --separation '0.2 0.1' --csv list.csv
check 'list with blanks' test "$(rows list.csv)" -eq 2

run curve --surface mesh-400-cross --json -
check 'a surface replaces eta, radius, sigma' \
   has out '"eta": 3.2200000000000000E+002, "modulus": 2.9700000000000000E+002, "radius": 4.4650000000000001E-001'
run curve --surface mesh-400-cross --sigma 0.03 --json -
check 'an explicit value overrides a surface' has out '"sigma": 2.9999999999999999E-002'
run curve --eta 206 --modulus 297 --radius 0.1477 --hardness 24.53 --yield-factor 0.4 \
   --sigma 0.0593 --csv c.csv --json c.json
check 'all properties given: no pair' lacks c.json '"pair"'
check 'all properties given: same numbers' cmp c.csv default.csv
refuses 'pair without effect' 2 '--pair: has no effect' curve --pair transverse-tangential \
   --eta 206 --modulus 297 --radius 0.1477 --hardness 24.53 --yield-factor 0.4 --sigma 0.0593

run curve --separation 0 --csv - --pair tangential-tangential
check 'validity in the CSV' has out ',area_above_nominal+pressure_above_hardness'
check 'validity in words on standard error' has err \
   'asperity: warning: real area above nominal area'
run curve --separation 0 --json -
check 'validity in the JSON' has out '"remarks": ["real area above nominal area'
run curve --separation 0
check 'validity in words below the table' has out 'a  real area above nominal area'
run curve --separation 0.2
check 'valid results are said to be so' has out 'no limit of the law is passed'
run curve --eta 2.06e-4 --accept-unphysical --separation 0.2
check 'unphysical roughness accepted and said' has out 'no isotropic Gaussian surface has it'

# The law with memory: first loading is the curve without it, what that stores is recoverable or lost
memory=(--unloading elastic)
run curve "${memory[@]}" --csv m.csv --json m.json
check 'memory' is_quiet
check 'memory: columns' test "$(columns m.csv)" = "${header/energy,/energy,plastic_dissipation,}"
check 'memory: the properties tell it' has m.json '"unloading": "elastic"'
check 'memory: 17 figures' numbers_are_proper m.csv
check 'memory: JSON holds the same figures' same_csv_and_json m.csv m.json
paste -d, <(cut -d, -f1-6 default.csv) <(cut -d, -f1-6 m.csv) >both
check 'memory: first loading is the law' awk -F, 'NR > 1 { for (i = 1; i <= 6; i++) if ($i != $(i + 6)) { print; exit 1 } }' both
paste -d, <(csv_column default.csv energy) <(csv_column m.csv energy) <(csv_column m.csv plastic_dissipation) >both
# 1e-12, as promised for the law
check 'memory: work is stored or dissipated' awk -F, '{ e = ($2 + $3)/$1 - 1; if (e*e > 1e-24) { print; exit 1 } }' both
# The way back from 0.1 mm, and closer than that
run curve "${memory[@]}" --closest-separation 0.1 --separation 0.09,0.1,0.100001,0.11,0.12,0.13 --csv m.csv
run curve --separation 0.09,0.1,0.100001,0.11,0.12,0.13 --csv c.csv
paste -d, <(csv_column c.csv pressure) <(csv_column m.csv pressure) <(csv_column m.csv plastic_dissipation) >both
check 'memory: the law down to the closest separation, below it on the way back' awk -F, '
   { d[NR] = $3; if (NR <= 2 ? $1 != $2 : !($2 < $1*(1 - 1e-6))) { print NR ": " $0; exit 1 } }
   END { for (i = 3; i <= 6; i++) if (d[i] != d[2]) exit 1; exit !(d[1] > d[2] && d[2] > 0) }' both
# 25-digit values through options and CSV. 1e-9: a separation is a retraction with a rounding of
# the closest one, which moves far pressures by as much. Without retraction the stiffness is that
# of closing, which the reference does not have
: >found
tail -n +2 "$root/test/data/unloading_reference.csv" >reference
while IFS=, read -r pair eta modulus radius hardness k sigma closest retraction rest; do
   run curve "${memory[@]}" --sigma "$sigma" --eta "$eta" --modulus "$modulus" --radius "$radius" \
      --hardness "$hardness" --yield-factor "$k" --accept-unphysical --closest-separation "$closest" \
      --separation "$(awk -v a="$closest" -v b="$retraction" 'BEGIN { printf "%.17g", a + b }')" --csv c.csv
   tail -n 1 c.csv | cut -d, -f3-7 >>found
done <reference
cut -d, -f9-14 reference | paste -d, found - >both
check 'memory: 60 reference values' awk -F, '
   { for (i = 1; i <= 5; i++) if (i != 2 || $6 > 0) {
      n++; e = $i/$(i + 6) - 1; if (e < 0) e = -e; if (e > worst) worst = e } }
   END { print NR, n, worst; exit !(NR == 60 && n > 280 && worst < 1e-9) }' both
refuses 'closest separation of the reversible law' 2 \
   '--closest-separation: closest_separation = 0.1 mm is for unloading = elastic alone' \
   curve --closest-separation 0.1
refuses 'closest separation far off' 2 '--closest-separation: closest_separation = 1.0E200 mm is not' \
   curve "${memory[@]}" --closest-separation 1e200
refuses 'closest separation that is no number' 2 "--closest-separation: .* 'x' is not a finite number" \
   curve "${memory[@]}" --closest-separation x
refuses 'unknown unloading' 2 \
   "--unloading: unloading = 'plastic' is unknown; known: reversible, elastic" curve --unloading plastic
refuses 'elastic unloading below its yield factor' 2 \
   '--yield-factor: yield_factor = 0.19 is not allowed with elastic unloading: it must be 0.1907' \
   curve "${memory[@]}" --yield-factor 0.19
run curve "${memory[@]}" --yield-factor 0.191 --csv m.csv
check 'memory: just above it' test "$status" -eq 0
refuses 'closest separation is of curve' 2 '--closest-separation: is an option of curve' \
   press "${memory[@]}" --closest-separation 0.1

# Plastic ratio and heights that are not Gaussian
run curve --separation 0.2,0.15,0.1 --csv c110.csv
run curve --separation 0.2,0.15,0.1 --plastic-ratio 54 --csv c54.csv
check 'plastic ratio: 54 gives 1.21, 1.20, 1.18 times the pressure of 110' awk -F, '
   FNR == 1 { for (i = 1; i <= NF; i++) if ($i ~ /^pressure/) p = i; n = 0; next }
   NR == FNR { a[++n] = $p; next }
   { n++; if ($p/a[n] < 1.175 || $p/a[n] > 1.215) bad++ } END { exit n != 3 || bad > 0 }' c110.csv c54.csv
refuses 'plastic ratio' 2 '--plastic-ratio: plastic_ratio = 9.0 is not allowed: it must be' \
   curve --plastic-ratio 9
refuses 'kurtosis of Gaussian heights' 2 '--kurtosis: needs height_distribution = johnson' \
   curve --kurtosis 3.5
refuses 'skewness of Gaussian heights' 2 '--skewness: needs height_distribution = johnson' \
   curve --skewness 0.5
refuses 'a kurtosis that no heights have' 2 \
   '--skewness: skewness = 2.0 with kurtosis = 4.0 is not allowed: no heights have kurtosis' \
   curve --height-distribution johnson --skewness 2 --kurtosis 4
refuses 'Johnson heights that remember' 2 \
   '--height-distribution: height_distribution = johnson is not possible with elastic unloading' \
   curve --unloading elastic --height-distribution johnson
run curve --height-distribution johnson --separation 0.2,0.15,0.1 --csv johnson.csv
check 'Johnson heights of kurtosis 3 are Gaussian' cmp c110.csv johnson.csv
run curve --surface unpolished-cross --height-distribution johnson
check 'kurtosis of the surface' grep -Eq '^ *kurtosis +3.61 +surface unpolished-cross$' out

# Interaction of summits: from a tenth of the area on, and from three tenths with more to say. The
# area is linear in eta: 206 has 0.184989 of it at 0.1 mm
area() { # eta for a fraction of the area at 0.1 mm
   awk -v f="$1" 'BEGIN { printf "%.10g", 206*f/0.184988893028 }'
}
check 'interaction: the area at 0.1 mm' near "$(run curve --separation 0.1 --csv c.csv; csv_column c.csv area_fraction)" 0.184988893028 1e-10
run curve --separation 0.1 --eta "$(area 0.0999)"
check 'interaction: nothing below a tenth of the area' lacks out 'Real area'
run curve --separation 0.1 --eta "$(area 0.1001)"
check 'interaction: from a tenth on' sh -c 'grep -q "^Real area up to 10 % of the nominal one" out && ! grep -q "grow together" out'
run curve --separation 0.1 --eta "$(area 0.2999)"
check 'interaction: less below three tenths' lacks out 'grow together'
run curve --separation 0.2,0.1 --eta "$(area 0.3001)" --json c.json
check 'interaction: from three tenths on' sh -c 'tr "\n" " " <out | grep -q "up to 30 %.* contacts  *grow together"'
check 'interaction: once, in JSON as well' test "$(grep -c 'Real area up to' c.json)" -eq 1
for command in press 'shear --normal-stress 4.7 --accept-sizes --displacement 1' 'tenon --amplitudes 24 --cycles 1'; do
   # shellcheck disable=SC2086  # several words are meant
   run $command
   check "interaction: told by ${command%% *}" test "$(grep -c '^Real area up to 2[34] %' out)" -eq 1
done

# Heights: what a kurtosis of Table 2 does to the pressure
run curve --surface unpolished-cross --separation 0.2 --json c.json
check 'heights: a surface whose kurtosis matters' has c.json 'surface unpolished-cross has a kurtosis of 3.61: where the Gaussian '
check 'heights: by these factors' has c.json ' give 4.94 and 2.89 times as much'
run curve --surface mesh-400-radial --separation 0.2
check 'heights: one whose kurtosis does not' lacks out 'kurtosis'
run curve --surface unpolished-cross --height-distribution johnson --separation 0.2
check 'heights: nothing to say of the law that has it' lacks out 'has a kurtosis'
run curve --separation 0.2
check 'heights: nothing of a pair' lacks out 'kurtosis'
for command in press 'shear --displacement 1' 'tenon --amplitudes 24 --cycles 1'; do
   # shellcheck disable=SC2086  # several words are meant
   run $command --surface unpolished-cross
   check "heights: told by ${command%% *}" test "$(grep -c '^surface unpolished-cross has a kurtosis' out)" -eq 1
done
run curve --sweep surface=unpolished-cross,mesh-400-radial --separation 0.2
check 'heights: told of its case of a sweep' test "$(grep -c '^surface = unpolished-cross: surface unpol' out)" -eq 1
