# asperity replay: a given motion through UINTER, and through another's

cat >path.csv <<'END'
time,overclosure,slip_1,slip_2
1,0.02,0,0
2,0.06,0,0
3,0.1,0.05,0
4,0.1,0.3,0
5,0.1,0.6,0.1
6,0.12,0.5,0.3
7,0.05,0.2,0.3
8,-0.05,0,0
9,-1e36,0,0
10,0.1,0,0
END
header=time,overclosure,slip_1,slip_2,pressure,shear_1,shear_2,stored_energy,friction_dissipation,\
plastic_dissipation,status,validity
run replay path.csv --csv r.csv --json r.json
check 'replay' is_quiet
check 'replay: columns' test "$(columns r.csv)" = "$header"
check 'replay: a row an increment' test "$(rows r.csv)" -eq 10
check 'replay: 17 figures' numbers_are_proper r.csv
check 'replay: JSON holds the same figures' same_csv_and_json r.csv r.json
# separations are d0 less the overclosure, d0 = 0.2372 mm
run curve --separation 0.2172,0.1772,0.1372,0.1172 --csv c.csv
csv_column c.csv pressure >law
csv_column r.csv pressure | sed -n '1,3p;6p' | paste -d' ' - law >both
check 'replay: pressures are the law' awk '{ d = $1/$2 - 1; if (d > 1e-12 || d < -1e-12) { print; exit 1 } }
   END { if (NR != 4) exit 1 }' both
# stuck while the slip is below gcrit = 0.31 mm: mu p s/gcrit, mu = 0.5; at most mu p later; nothing
# when nothing is opposite, and history forgotten
check 'replay: shear stresses are mu p s/gcrit, then mu p' csv r.csv '
   p = c["pressure"]; t = sqrt(c["shear_1"]^2 + c["shear_2"]^2)
   if (NR < 6 && far(c["shear_1"], 0.5*p*c["slip_1"]/0.31, 1e-12)) fail(c["shear_1"])
   if (t > 0.5*p*(1 + 1e-12)) fail(t)
   if (NR == 10 && p + t + c["stored_energy"] != 0) fail("open")
   if (NR == 11 && t != 0) fail("anew")'
check 'replay: dissipation never falls' csv r.csv '
   if (NR > 2 && c["friction_dissipation"] < before["friction_dissipation"]) fail("falls")'
run press --control overclosure --peak 0.1 --increments 4 --csv p.csv
cut -d, -f1,2 p.csv >from_press.csv
run replay from_press.csv --csv r2.csv
csv_column p.csv pressure >a
csv_column r2.csv pressure >b
check 'replay: the closures of a press, to the bits' cmp a b
printf "&asperity pair = 'tangential-tangential' model = 'rough' /\n" >case.nml
run replay case.nml path.csv --csv r2.csv
check 'replay: a case file before the path, which may have keys of others' is_quiet
run replay path.csv --pair tangential-tangential --csv r3.csv
check 'replay: it is as its options' cmp r2.csv r3.csv
run replay path.csv --properties 0.5,0.31,206,297,3.141592653589793,0.1477,24.53,0.4,0.0593 --csv r3.csv
check 'replay: PROPS in place of the faces' cmp r.csv r3.csv
run replay path.csv --ndir 2
check 'replay: slip across needs three components' is_refused 2 '--ndir: path.csv: has slip_2, which is not zero and needs ndir = 3'
cut -d, -f1-3 path.csv >plane.csv
run replay plane.csv --ndir 2 --csv r3.csv
check 'replay: in the plane' test \
   "$(columns r3.csv)" = time,overclosure,slip_1,pressure,shear_1,stored_energy,friction_dissipation,plastic_dissipation,status,validity
check 'replay: same stresses in the plane' sh -c 'cut -d, -f4,5 r3.csv | head -n 5 >a
   cut -d, -f5,6 r.csv | head -n 5 | cmp - a'

# What it writes is a path with expected values
run replay r.csv --csv r2.csv --json r2.json
check 'replay: its own result' is_quiet
check 'replay: byte by byte' cmp r.csv r2.csv
check 'replay: the verdict' has out 'Verdict: pass: 3 columns in 10 rows within 1.0E-6 of the largest value of each.'
check 'replay: nothing departs' has r2.json '"found"'
check 'replay: by no bit' test "$(sed -n 's/^"off_over_allowed": \[\(.*\)\].*/\1/p' r2.json | tr -d ' ')" = \
   0.0000000000000000E+000,0.0000000000000000E+000,0.0000000000000000E+000
awk -F, -v OFS=, 'NR == 6 { $6 *= 1 + 1e-5 } { print }' r.csv >off.csv
run replay off.csv
check 'replay: a departure ends with 1' test "$status" -eq 1
check 'replay: and is named' grep -q 'the result departs from what off.csv expects, in shear_1$' err
check 'replay: and in the verdict' has out 'Verdict: departs from what is expected in shear_1.'
check 'replay: with its row' has out 'shear_1 departs from row 5 on, at 5.0 s'
run replay off.csv --tolerance 1e-4
check 'replay: within a larger tolerance' is_quiet
sed 's/(mm)/(um)/g; s/(MPa)/(kPa)/g; s/(s)/(min)/' r.csv | awk -F, -v OFS=, 'NR > 1 { $1 /= 60; $2 *= $2 < -1 ? 1 : 1000
   for (i = 3; i < 8; i++) $i *= 1000 } { print }' OFMT=%.17g CONVFMT=%.17g >units.csv
run replay units.csv --tolerance 1e-9
check 'replay: other units' is_quiet
tr ',.' ';,' <r.csv >comma.csv
run replay comma.csv
check 'replay: semicolons and decimal commas' is_quiet
sed '1s/overclosure/Closure/' path.csv >closure.csv
run replay closure.csv --csv r3.csv
check 'replay: closure is overclosure' cmp r.csv r3.csv
if command -v gnuplot >/dev/null; then
   run replay r.csv --plot r.svg
   check 'replay: picture' sh -c 'test "$1" -eq 0 && grep -q "shear_2, expected" r.svg' - "$status"
fi

refuses 'replay: no path' 2 'no path is given: asperity replay PATH.csv' replay
refuses 'replay: no file' 3 'none.csv: cannot be read: ' replay none.csv
refuses 'replay: two paths' 2 "'r.csv': there is already the path 'path.csv'" replay path.csv r.csv
bad_path() { # name pattern text
   printf "$3" >bad.csv
   refuses "replay: $1" 2 "bad.csv$2" replay bad.csv
}
bad_path 'an empty file' ': has no line of data' ''
bad_path 'no rows' ': has no line of numbers' 'time,overclosure\n'
bad_path 'no names' ': its first line must name the columns: time, overclosure' '1,2\n2,3\n'
bad_path 'no time' ': there is no column time; its columns are' 'slip_1,overclosure\n1,2\n'
bad_path 'no closure' ': there is no column overclosure; its columns are' 'time,slip_1\n1,2\n'
bad_path 'two of them' ': columns 2 and 3 are both overclosure' 'time,closure,overclosure\n1,2,3\n'
bad_path 'a name that is near' ": there is no column 'presure' of a path, did you mean pressure" \
   'time,overclosure,presure\n1,2,3\n'
bad_path 'slip without its direction' ": there is no column 'slip' of a path, did you mean slip_1" \
   'time,overclosure,slip\n1,2,3\n'
bad_path 'slip without a name' ':2: the line has 3 fields for 2 names' 'time,overclosure\n1,0.1,2\n'
bad_path 'times that do not rise' ': time = 1.0 s of row 2 is not later than 1.0 s' 'time,overclosure\n1,0.1\n1,0.2\n'
bad_path 'NaN' ':3: overclosure \(column 2\) = .nan. is not a finite number' 'time,overclosure\n1,0.1\n2,nan\n'
bad_path 'an empty field' ':3: overclosure \(column 2\) is empty' 'time,overclosure\n1,0.1\n2,\n'
bad_path '1e36' ': overclosure = 1.0E36 is not between -1e20 and 1e20' 'time,overclosure\n1,1e36\n'
bad_path 'slip of -1e36' ': slip_1 = -1.0E36 is not between' 'time,overclosure,slip_1\n1,0.1,-1e36\n'
bad_path 'a unit of something else' ': overclosure is in s, which is no unit like mm' 'time,overclosure (s)\n1,2\n'
refuses 'replay: PROPS and faces' 2 '--eta: is of asperity.s faces, where neither' replay path.csv --properties 1,2 --eta 3
refuses 'replay: PROPS that our UINTER refuses' 2 'PROPERTIES = 2 is not allowed' replay path.csv --properties 1,2
refuses 'replay: NSTATV of ours' 2 '--nstatv: is for --uinter' replay path.csv --nstatv 3
refuses 'replay: four components' 2 '--ndir: ndir = 4 is not allowed: 2 or 3' replay path.csv --ndir 4
refuses 'replay: no tolerance' 2 '--tolerance: tolerance = 0.0 is not' replay path.csv --tolerance 0
refuses 'replay: NSTATV not given' 2 '--uinter needs the length of STATEV as well' replay path.csv --uinter none.so
refuses 'replay: no library' 3 'none.so: there is no such file' replay path.csv --uinter none.so --nstatv 2
cp path.csv text.so
refuses 'replay: no library but a text' 2 'text.so: ' replay path.csv --uinter text.so --nstatv 2
refuses 'replay: no source but a text' 2 'path.csv' replay path.csv --uinter path.csv --nstatv 2

# A penalty law by another hand: K = PROPS(1), mu = PROPS(2), elastic slip until G = PROPS(3) times
# it is mu p; STATEV: elastic slip, accepted increments. PROPS(4) is a fault
cat >penalty.f <<'END'
      subroutine uinter(stress,ddsddr,amki,amski,flux,ddfddt,ddsddt,
     1 ddfddr,statev,sed,sfd,spd,svd,scd,pnewdt,rdisp,drdisp,
     2 temp,dtemp,predef,dpred,time,dtime,freqr,ciname,slname,
     3 msname,props,coords,alocaldir,drot,area,chrlngth,node,ndir,
     4 nstatv,npred,nprops,mcrd,kstep,kinc,kit,linper,lopenclose,
     5 lstate,lsdi,lprint)
      implicit real*8 (a-h,o-z)
      character*80 ciname,slname,msname
      dimension stress(ndir),ddsddr(ndir,ndir),amki(ndir,ndir),
     1 amski(ndir,ndir),flux(2),ddfddt(2,2),ddsddt(ndir,2),
     2 ddfddr(2,ndir),statev(nstatv),rdisp(ndir),drdisp(ndir),
     3 temp(2),dtemp(2),predef(2,npred),dpred(2,npred),time(2),
     4 props(nprops),coords(mcrd),alocaldir(3,3),drot(2,2)
      fault = props(4)
      p = max(0.d0, props(1)*rdisp(1))
      s = statev(1) + drdisp(2)
      g = props(3)
      if (g*abs(s) .gt. props(2)*p) s = sign(props(2)*p/g, s)
      stress(1) = p
      stress(2) = g*s
      sfd = stress(2)*(drdisp(2) - s + statev(1))
      sed = 0.5d0*(p*p/props(1) + g*s*s)
      do 10 i = 1, ndir
      do 10 j = 1, ndir
         if (.not. (fault .eq. 1.d0 .and. i .eq. 2)) ddsddr(i,j) = 0.d0
   10 continue
      if (p .gt. 0.d0) ddsddr(1,1) = props(1)
      if (fault .ne. 1.d0) ddsddr(2,2) = g
      if (ndir .gt. 2) stress(3) = 0.d0
      statev(1) = s
      statev(2) = statev(2) + 1.d0
      if (fault .eq. 2.d0 .and. abs(drdisp(2)) .gt. 0.2d0) pnewdt = 0.5
      if (fault .eq. 3.d0) pnewdt = 0.5
      if (fault .eq. 4.d0) stress(2) = (p - p)/(s - s)
      end
END
compiler=
for try in "${FC:-}" gfortran flang-new-19 flang; do
   [ -n "$try" ] && "$try" -shared -fPIC penalty.f -o penalty.so 2>/dev/null && compiler=$try && break
done
if [ -z "$compiler" ]; then
   skip 'replay: the UINTER of another' 'there is no compiler'
else
   penalty() { run replay plane.csv --uinter penalty.so --properties "100,0.3,50,$1" --nstatv 2 "${@:2}"; }
   penalty 0 --csv u.csv --json u.json
   check 'replay: another UINTER' test "$status" -eq 0
   check 'replay: its columns' test "$(columns u.csv)" = time,overclosure,slip_1,slip_2,pressure,shear_1,shear_2,\
stored_energy,friction_dissipation,plastic_dissipation,viscous_dissipation,creep_dissipation,lopenclose,lstate,\
parts,statev_1,statev_2
   # elastic slip by hand: it follows the slip, but stays within mu p/G
   check 'replay: K u, and G times the elastic slip within mu p' csv u.csv '
      p = c["overclosure"] > 0 ? 100*c["overclosure"] : 0; e += c["slip_1"] - was; was = c["slip_1"]
      last = e; if (e > 0.3*p/50) e = 0.3*p/50; if (e < -0.3*p/50) e = -0.3*p/50; d += 50*e*(last - e)
      if (far(c["pressure"], p, 1e-14)) fail(c["pressure"] " not " p)
      if (abs(c["shear_1"] - 50*e) > 1e-13) fail(c["shear_1"] " not " 50*e)
      if (abs(c["statev_1"] - e) > 1e-15 || c["statev_2"] != NR - 1) fail("STATEV")
      if (abs(c["friction_dissipation"] - d) > 1e-13) fail("dissipation")
      if (abs(c["stored_energy"] - p*p/200 - 25*e*e) > 1e-13) fail("energy")'
   check 'replay: what it left unset is said' grep -q \
      'UINTER left unset, .*: DVISCOUS, DSTRUCTURAL, DDFDDT, DDSDDT, DDFDDR, SPD, SVD, SCD\.' out
   penalty 0 --ndir 2 --csv u2.csv
   check 'replay: it in the plane' sh -c 'cut -d, -f5,6 u.csv >a; cut -d, -f4,5 u2.csv | cmp - a'
   run replay u.csv --uinter ./penalty.so --properties 100,0.3,50,0 --nstatv 2
   check 'replay: its own result as expected' test "$status" -eq 0
   run replay u.csv --uinter ./penalty.so --properties 101,0.3,50,0 --nstatv 2
   check 'replay: a change of the routine is found' grep -q 'departs from what u.csv expects, in pressure, shear_1$' err
   check 'replay: and explained' has out 'pressure is 1.01 times what is expected throughout'
   penalty 2 --csv u3.csv
   check 'replay: a cut is repeated in parts' test "$(csv_column u3.csv parts | tr '\n' ' ')" = '1 1 1 2 2 1 2 1 1 1 '
   check 'replay: and said' has out '3 of 10 were computed in parts, rows 4, 5, 7.'
   check 'replay: with the same end' awk -F, 'NR == FNR { a[FNR] = $5 " " $6; next } a[FNR] != $5 " " $6 {
      split(a[FNR], x, " "); if (x[2] - $6 > 1e-13 || $6 - x[2] > 1e-13) bad = 1 } END { exit bad }' u.csv u3.csv
   penalty 1
   check 'replay: a required output left unset' is_refused 1 \
      'plane.csv, row 1, time = 1.0 s: UINTER left DDSDDR\(2,1\) DDSDDR\(2,2\) DDSDDR\(2,3\) unset at overclosure = '
   penalty 4
   check 'replay: a stress that is no number' is_refused 1 'plane.csv, row 1, .*: UINTER computed STRESS\(2\), which is not a finite number'
   penalty 3
   check 'replay: cut for ever' is_refused 1 'plane.csv, row 1, .*: UINTER asks to cut the increment for ever'
   sed 's/subroutine uinter/subroutine umat/' penalty.f >other.f
   "$compiler" -shared -fPIC other.f -o other.so 2>/dev/null
   refuses 'replay: a library without UINTER' 2 'other.so has no subroutine UINTER' \
      replay path.csv --uinter other.so --nstatv 2
   # a library that takes its process down
   sed 's/fault = props(4)/fault = props(4)\n      if (kinc .eq. 3) stop 7/' penalty.f >stops.f
   "$compiler" -shared -fPIC stops.f -o stops.so 2>/dev/null
   stops() { run replay plane.csv --uinter "$1" --properties 100,0.3,50,0 --nstatv 2 "${@:2}"; }
   stops stops.so
   check 'replay: a STOP is named' is_refused 1 'stops.so: .*STOP, EXIT or an error of Fortran in trial replay: exit status 7'
   sed 's/fault = props(4)/fault = props(4)\n      print *, kinc/' penalty.f >prints.f
   "$compiler" -shared -fPIC prints.f -o prints.so 2>/dev/null
   stops prints.so --csv u4.csv
   check 'replay: what it prints is no output of the program' sh -c 'cmp u.csv u4.csv && test ! -s err'
   check 'replay: and is remarked' has out 'lines in trial replay, the first'
fi
if ! gfortran --version >/dev/null 2>&1 || [ ! -s u.csv ]; then
   skip 'replay: a source' 'there is no gfortran'
else
   run replay plane.csv --uinter penalty.f --properties 100,0.3,50,0 --nstatv 2 --csv u5.csv
   check 'replay: the source in place of the library' sh -c 'cut -d, -f1-4,14- u.csv >a; cut -d, -f1-4,14- u5.csv >b
      test "$1" -eq 0 && cut -d, -f5 u.csv | cmp - c && cmp a b' - "$status" <<<"$(cut -d, -f5 u5.csv >c)"
   sed 's/lprint)/lprint,extra)/' penalty.f >longer.f
   refuses 'replay: another argument list' 2 'longer.f: .*' \
      replay plane.csv --uinter longer.f --properties 100,0.3,50,0 --nstatv 2
   sed "s/fault = props(4)/fault = props(4)\n      if (kinc .eq. 2) call xit/" penalty.f >ends.f
   run replay plane.csv --uinter ends.f --properties 100,0.3,50,0 --nstatv 2
   check 'replay: XIT is named' is_refused 1 'ends.f: message of the routine in trial replay: XIT was called'
   check 'replay: nothing is left behind' sh -c '! ls abaqus_messages fort.* 2>/dev/null'
   # asperity's own UINTER as ABAQUS compiles it
   run replay r.csv --uinter "$root/interface/abaqus/ready/asperity_uinter.f" --nstatv 20 \
      --properties 0.5,0.31,206,297,3.141592653589793,0.1477,24.53,0.4,0.0593 --tolerance 1e-12
   check 'replay: the file for ABAQUS answers as the program' has out 'Verdict: pass: 3 columns in 10 rows'
fi

# A box that finds no balance leaves its motion and its properties
rm -f failed_point.*
run shear --normal-stress 1.2 --displacement 3 --displacement-increment 2 --shear-compliance 0.1 \
   --critical-slip 1e-4 --static-friction-coefficient 4 --decay-slip 2e-3 --pressure-exponent 2.9 \
   --reference-pressure 0.2 --accept-unphysical
check 'replay: what fails in the shear box is kept' is_refused 1 \
   'no balance found at displacement = 1.5 mm; .*; asperity replay failed_point.nml replays the motion of the box$'
run replay failed_point.nml --csv r4.csv
check 'replay: and replayed' is_quiet
check 'replay: from the weight of the box on' csv r4.csv \
   'if (NR == 2 && (far(c["pressure"], 1.2, 1e-12) || c["shear_1"] != 0)) fail(c["pressure"])'
check 'replay: as it was' sh -c 'cut -d, -f1-4 r4.csv | cmp - failed_point.csv'
rm -f failed_point.*
