# asperity fit: parameters from a record

# The example: a record of known numbers with noise, eta 260, datum 0.21 mm, machine 0.004 mm/MPa
record=$root/examples/fit/press.csv
fit() { run fit "$@" --kind press; }
summary() { sed -n '/^"summary"/,/^}/p' f.json | sed -n "s/^\"$1\": \[\(.*\)\].*/\1/p"; }
values_near() { awk -v a="$(summary "$1")" -v b="$2" -v part="$3" 'BEGIN {
   n = split(a, A, ", "); m = split(b, B, " "); if (n != m) exit 1
   for (i = 1; i <= n; i++) { d = A[i]/B[i] - 1; if (d > part || d < -part) exit 1 } }'; }
holds() { awk -v l="$(summary low_95)" -v h="$(summary high_95)" -v t="$1" 'BEGIN {
   n = split(l, L, ", "); split(h, H, ", "); split(t, T, " ")
   for (i = 1; i <= n; i++) if (L[i] > T[i] || H[i] < T[i]) exit 1 }'; }
pair=pair=transverse-tangential

"$root/examples/fit/make_press.sh" "$program" >made.csv 2>/dev/null
check 'fit: the example is what its script makes' cmp made.csv "$record"
fit "$record" --free eta,initial_separation,machine_compliance --fix $pair --case f.nml --json f.json --csv f.csv
check 'fit' test "$status" -eq 0
check 'fit: intervals hold the numbers of the record' holds '260 0.21 0.004'
check 'fit: what is fixed and where from' sh -c 'grep -Eq "hardness +24.53 +MPa +pair transverse-tangential" out &&
   grep -Eq "unloading +elastic +- +the record returns" out'
check 'fit: the columns of the record' has f.json '"chosen_by": ["name", "name"]'
check 'fit: record and model in CSV' test "$(columns f.csv)" = closure,pressure,model_pressure,difference
check 'fit: as many rows as the record' test "$(rows f.csv)" -eq "$(rows "$record")"
check 'fit: the difference' csv f.csv 'if (far(c["pressure"] + c["difference"], c["model_pressure"], 1e-12)) fail("sum")'
check 'fit: the case says where its numbers come from' sh -c 'grep -q "^!   eta .* to .* 1/mm^2" f.nml &&
   grep -q "^!   hardness 24.53 MPa: pair transverse-tangential" f.nml && grep -q "machine_compliance .*of the test" f.nml'
run press f.nml --peak 3 --csv p.csv
check 'fit: press takes the case' test "$status" -eq 0
run shear f.nml
check 'fit: so does shear' test "$status" -eq 0
run fit "$record" --kind press --free eta,initial_separation --model f.nml --fix machine_compliance=0.004 --json f.json
check 'fit: a case file fixes what is not free' sh -c 'grep -Eq "sigma +0.0593 +mm +f.nml:" out'
check 'fit: and says where the search begins' values_near start "$(sed -n 's/^  eta = \([^ ]*\).*/\1/p' f.nml) \
   $(sed -n 's/^  initial_separation = \([^ ]*\).*/\1/p' f.nml)" 1e-12

# What press writes is found again, from starts far off, in other units and columns
run press --peak 3 --increments 40 --csv p.csv
head -n 41 p.csv >load.csv
six=modulus=297,radius=0.1477,hardness=24.53,yield_factor=0.4
fit load.csv --free eta,sigma,initial_separation --fix $six --json f.json --start eta=20000,sigma=0.6
check 'fit: numbers of press, from starts ten and a hundred times off' values_near value '206 0.0593 0.2372' 1e-6
fit load.csv --free eta,hardness,sigma,initial_separation --fix modulus=297,radius=0.1477,yield_factor=0.4 --json f.json
check 'fit: four numbers of a record without noise' values_near value '206 24.53 0.0593 0.2372' 1e-5
awk -F, 'NR == 1 { print "Weg (um);Druck (kPa)" } NR > 1 { printf "%.17g;%.17g\n", -1000*$2 - 5, 1000*$4 }' load.csv >other.csv
fit other.csv --free eta,sigma,initial_separation --fix $six --json f.json --displacement-zero -5 --displacement-factor -1
check 'fit: the same in um and kPa, downwards, off zero' values_near value '206 0.0593 0.2372' 1e-6
awk -F, 'NR == 1 { print "closure (mm),force (kN)" } NR > 1 { printf "%.17g,%.17g\n", $2, 1.2*$4 }' load.csv >force.csv
fit force.csv --free eta,sigma,initial_separation --fix $six --json f.json --force-column 2 --force-factor 0.83333333333333333 --force-unit MPa
check 'fit: forces over an area' values_near value '206 0.0593 0.2372' 1e-6
fit load.csv --free eta,sigma,initial_separation --fix $six --json f.json --residual-scale relative
check 'fit: noise in proportion' values_near value '206 0.0593 0.2372' 1e-6

# What the residuals tell
awk -F, 'NR == 1 { print } NR > 1 { printf "%.6f,%.6f\n", $1, $2 + 0.003*(NR - 2) }' "$record" >drift.csv
fit drift.csv --free eta,initial_separation,machine_compliance --fix $pair
check 'fit: a record that drifts is told' has out 'or the record drifts'
fit "$record" --free eta,initial_separation --fix $pair
check 'fit: a machine that was forgotten, too' has out 'the model misses the shape'

# Refused, and no case is written
is_unwritten() { is_refused "$@" && [ ! -e none.nml ]; }
refuses_fit() {
   local name=$1 expected=$2 pattern=$3
   shift 3
   fit "$@" --case none.nml
   check "fit: $name" is_unwritten "$expected" "$pattern"
}
head -n 40 "$record" >noisy.csv
refuses_fit 'what cannot be told apart' 1 'noisy.csv: eta and radius cannot be told apart by this record: fix 1 of them' \
   noisy.csv --free eta,radius,sigma,initial_separation --fix $pair,machine_compliance=0.004
refuses_fit 'a parameter at its bound' 1 'load.csv: eta came to its bound 200.0 1/mm\^2: widen it' \
   load.csv --free eta,initial_separation --fix $pair --bounds eta=10:200
refuses_fit 'fewer data than parameters' 2 '.*: 3 numbers of the record cannot settle 3 free parameters' \
   <(head -n 4 load.csv) --free eta,sigma,initial_separation --fix $six
refuses_fit 'what nothing says' 2 'nothing says radius, hardness, yield_factor, initial_separation: free them' \
   load.csv --free eta,sigma --fix modulus=297
refuses_fit 'nothing free' 2 'nothing is free' load.csv --fix $pair
refuses_fit 'a key that is none' 2 "--free: the model has no key 'etaa'; did you mean eta" load.csv --free etaa --fix $pair
refuses_fit 'a key that is no number' 2 '--free: unloading is no real number' load.csv --free unloading --fix $pair
refuses_fit 'a key that may not be free' 2 '--free: plastic_ratio cannot be free' \
   load.csv --free plastic_ratio --fix $pair,initial_separation=0.2
refuses_fit 'free and fixed' 2 '--free: eta is also fixed' load.csv --free eta --fix eta=200
refuses_fit 'free twice' 2 '--free: eta is named twice' load.csv --free eta,eta --fix $pair
refuses_fit 'no value' 2 "--fix: 'eta' is not KEY=VALUE" load.csv --free sigma --fix eta
refuses_fit 'no number' 2 "--fix: eta = 'x' is not a finite number" load.csv --free sigma --fix eta=x
refuses_fit 'fixed twice' 2 '--fix: eta is given twice' load.csv --free sigma --fix eta=1,eta=2
refuses_fit 'bounds of what is not free' 2 "--bounds: 'sigma' is not free" load.csv --free eta --bounds sigma=1:2 \
   --fix $pair,initial_separation=0.2
refuses_fit 'bounds that are none' 2 "--bounds: 'eta=2' is not KEY=LOW:HIGH" load.csv --free eta --bounds eta=2 \
   --fix $pair,initial_separation=0.2
refuses_fit 'bounds upside down' 2 '.*: the first must be below the second, and both above 0' load.csv --free eta \
   --bounds eta=2:1 --fix $pair,initial_separation=0.2
refuses_fit 'a start outside' 2 'load.csv: eta begins at 9.0 between 10.0 and 20.0' load.csv --free eta --bounds eta=10:20 \
   --start eta=9 --fix $pair,initial_separation=0.2
refuses_fit 'bounds twice' 2 '--bounds: eta is given twice' load.csv --free eta --bounds eta=2:900,eta=3:400 \
   --fix $pair,initial_separation=0.2
refuses_fit 'two starts' 2 '--start: eta is given twice' load.csv --free eta --start eta=200,eta=300 \
   --fix $pair,initial_separation=0.2
# What is held out is read before the search, which would not be settled here
refuses_fit 'no such record to hold out' 3 'test.csv: cannot be read' noisy.csv --free eta,radius,sigma,initial_separation \
   --fix $pair,machine_compliance=0.004 --hold-out test.csv
printf 'displacement (mm),force (N)\n0,0\n1,5\n2,9\n' >joint.csv
refuses_fit 'a record of forces' 2 'joint.csv: no column is pressure by its name and unit' joint.csv --free eta \
   --fix $pair,initial_separation=0.2
printf 'closure (mm),pressure (MPa)\n0,0\n1e-30,5\n2e-30,8\n' >small.csv
refuses_fit 'readings of another unit' 2 'small.csv: the largest displacement is 2.0E-30 mm, which is not between 1e-20' \
   small.csv --free eta --fix $pair,initial_separation=0.2
refuses_fit 'two records' 2 'load.csv, noisy.csv: there are 2 tests, of which press takes one: give one file' \
   load.csv noisy.csv --free eta --fix $pair,initial_separation=0.2
printf 'closure (mm),pressure (MPa)\n0,0\n1,5\n0,0\n-1,-5\n0,0\n' >cyclic.csv
refuses_fit 'faces that pull' 2 'cyclic.csv: pressures go down to -5.0 MPa' cyclic.csv --free eta --fix $pair,initial_separation=0.2
printf 'closure (mm),pressure (MPa)\n0,5\n1,3\n2,1\n3,0\n' >down.csv
refuses_fit 'closing downwards' 2 'down.csv: .*closing is counted downwards' down.csv --free eta --fix $pair,initial_separation=0.2
refuses_fit 'no such record' 3 'test.csv: cannot be read' test.csv --free eta --fix $pair,initial_separation=0.2
run fit load.csv --free eta --fix $pair
check 'fit: a record of no kind' is_refused 2 'nothing says what the record is'
run fit --kind press
check 'fit: no record' is_refused 2 'no record is given'
fit load.csv --free eta,sigma,initial_separation --fix $six --case load.csv
check 'fit: the record is not overwritten' is_refused 2 '--case: load.csv is the record, it would be lost'
