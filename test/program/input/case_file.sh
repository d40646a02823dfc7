# Case files: what is read, overridden, printed back, and that namelist READ reads the same

cat >case.nml <<'CASE'
! head
&Asperity
   Pair = "tangential-tangential", sigma = 5.0d-2   ! mm
   accept_unphysical = F, hardness=1.3E1
   separation = 0.15 0.12,
                0.1
   0.05
   increments = +7 rate = 2.4  ! of other commands
/
! tail
CASE
run curve case.nml --json -
check 'case file' test "$status" -eq 0
check 'case file: a pair and explicit values' \
   has out '"pair": "tangential-tangential", "eta": 1.3400000000000000E+002'
check 'case file: d exponent' has out '"sigma": 5.0000000000000003E-002'
check 'case file: list over lines' has out '"separation": [1.4999999999999999E-001, 1.2000000000000000E-001, 1.0000000000000001E-001, 5.0000000000000003E-002]'
run press case.nml --json -
check 'case file: keys of other commands wait for them' has out '"increments": 7'
run curve case.nml --sigma 0.04 --pair transverse-tangential --separation 0.2 --json -
check 'options override the case file' \
   has out '"pair": "transverse-tangential", "eta": 2.0600000000000000E+002'
check 'options override explicit values' has out '"sigma": 4.0000000000000001E-002'
run shear case.nml --pair transverse-tangential --print-case
cp out pair.nml
check 'a pair as option overrides all values of the case file' \
   sh -c 'grep -q "eta = 206.0 " pair.nml && grep -q "sigma = 0.0593 " pair.nml && grep -q "hardness = 24.53 " pair.nml'
run shear pair.nml --surface mesh-400-cross --radius 0.3 --print-case
check 'a surface as option overrides those that it gives' \
   sh -c 'grep -q "eta = 322.0 " out && grep -q "sigma = 0.0239 " out && grep -q "radius = 0.3 " out && grep -q "modulus = 297.0 " out'
cp out surface.nml
run shear surface.nml --pair tangential-tangential --print-case
check 'a pair as option overrides a surface of the case file' \
   sh -c 'grep -q "eta = 134.0 " out && ! grep -q surface out'
run curve case.nml
check 'the table says where values come from' has out 'case.nml:3'
printf '&asperity\r\n sigma = 0.05\r\n/\r\n' >dos.nml
run curve dos.nml --json -
check 'case file with carriage returns' has out '"sigma": 5.0000000000000003E-002'
mkfifo pipe.nml
timeout 10 sh -c 'cat case.nml >pipe.nml' >/dev/null 2>&1 &
run curve pipe.nml
check 'case file from a pipe' test "$status" -eq 0

# --print-case writes the input that gives the same run
round_trip() {
   local name=$1
   shift
   run "$@" --csv direct.csv
   run "$@" --print-case
   cp out printed.nml
   check "print-case $name" is_quiet
   run "$1" printed.nml --csv printed.csv
   check "print-case $name: the same run" cmp direct.csv printed.csv
   run "$1" printed.nml --print-case
   check "print-case $name: printed again the same" cmp printed.nml out
}
round_trip 'curve' curve
# what follows from sigma must follow that of another pair
run shear --print-case
cp out printed.nml
run shear printed.nml --pair tangential-tangential --csv switched.csv
run shear --pair tangential-tangential --csv direct.csv
check 'print-case, then another pair: the same run' cmp direct.csv switched.csv
round_trip 'curve with options' curve --surface mesh-200-radial --sigma 0.0123456789012345678 \
   --separation=-0.01:0.07:33 --initial-separation=-1e-20
round_trip 'the longest list' curve --separation 0.1:0.2:100000
round_trip 'curve of a case' curve case.nml
round_trip 'curve without a pair' curve --eta 206 --modulus 297 --radius 0.1477 \
   --hardness 24.53 --yield-factor 0.4 --sigma 0.0593
round_trip 'unphysical' curve --eta 1e-9 --accept-unphysical
round_trip 'press' press --control overclosure --peak 0.123 --increments 9 --step-time 3
round_trip 'tenon' tenon --amplitudes 1,4 --face-points 20 --side-points 4 --clearance 0.3 \
   --clearance-above 0.1 --shoulders --axial-rule free --friction-coefficient 0.3 \
   --gap first_touch --displacement-increment 2 --history "$here/input/joint_history.csv"
round_trip 'table' table --tolerance 0.02 --rows 150 --largest-pressure 3 --smallest-pressure 1e-4 \
   --initial-separation 0.3 --friction-coefficient 0.3
round_trip 'table, stick pressure' table --stick-pressure 0.2
round_trip 'shear' shear --friction-rule dissipative --slip-integration backward_euler \
   --normal-stress 0.03,0.07 --displacement 1,-1,0.3 --displacement-increment 0.07 \
   --no-shrinking-overlap --shear-compliance 1.23456789e-5 --rate 3 --diameter 50

# Every example runs
for file in "$root"/examples/cases/*.nml; do
   for command in curve press shear table; do
      run $command "$file" --csv example.csv
      check "example $(basename "$file") with $command" test "$status" -eq 0 -a -s example.csv
   done
done

# What the program accepts, Fortran's own namelist READ reads alike
compiler=
for try in "${FC:-}" gfortran flang-new-19 flang; do
   [ -n "$try" ] && command -v "$try" >/dev/null && compiler=$try && break
done

commands=(curve press shear tenon table solid frame 'deck shear' 'deck tenon')

# read_alike FILE...: READ finds in each file what --print-case of some command prints
read_alike() {
   local file command
   for file in "$@"; do
      : >effective
      for command in "${commands[@]}"; do
         limited "$program" $command "$file" --print-case >printed.nml 2>/dev/null </dev/null || continue
         ./read_case printed.nml >>effective || return
      done
      [ -s effective ] || continue
      accepted=$((accepted + 1))
      ./read_case "$file" >read || return
      if grep -vxFf effective read; then
         cat "$file"
         return 1
      fi
   done
}

if [ -z "$compiler" ]; then
   skip 'namelist READ' 'no Fortran compiler'
elif ! { for command in "${commands[@]}"; do "$program" help $command; done \
      | awk -f "$here/input/read_case.awk" >read_case.f90 && "$compiler" read_case.f90 -o read_case; } >check.log 2>&1; then
   check "compile read_case.f90 with $compiler" false
else
   accepted=0
   check 'READ reads every example alike' read_alike "$root"/examples/*/*.nml
   check 'READ reads these cases alike' read_alike case.nml dos.nml
   check 'all of them were accepted' test "$accepted" -ge 13
   accepted=0
   for seed in $(seq 120); do
      awk -v seed="$seed" -f "$here/input/random_case.awk" >"random-$seed.nml"
   done
   check 'READ reads 120 random cases alike' read_alike random-*.nml
   # About 3 in 10 of them are proper
   check 'many of them were accepted' test "$accepted" -ge 20
fi
rm -f random-*.nml pipe.nml
