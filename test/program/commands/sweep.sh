# --sweep of curve, press and shear: every case is a run of its own, all in one table and one picture

# One case of a sweep: its rows without the columns that lead them
case_rows() { # file, pattern that its rows begin with, number of leading columns
   grep "^$2," "$1" | cut -d, -f$(($3 + 1))-
}

run curve --sweep pair=transverse-tangential,tangential-tangential --csv both.csv --json both.json
check 'curve --sweep' is_quiet
check 'curve --sweep: the key leads the columns' test "$(columns both.csv | cut -d, -f1-3)" = pair,separation,closure
check 'curve --sweep: JSON holds the same figures' same_csv_and_json both.csv both.json
for pair in transverse-tangential tangential-tangential; do
   run curve --pair $pair --csv one.csv
   case_rows both.csv $pair 1 >rows
   check "curve --sweep: $pair is a run of its own" sh -c 'tail -n +2 one.csv | cmp - rows'
done
run curve --sweep sigma=0.04:0.08:3 --sweep unloading=reversible,elastic --separation 0.1,0.15 --csv four.csv
check 'curve --sweep: every combination' test "$(rows four.csv)" -eq 12
check 'curve --sweep: values, and their unit' test "$(csv_unit four.csv sigma) $(csv_column four.csv sigma | uniq | paste -sd ' ')" = \
   'mm 4.0000000000000001E-002 5.9999999999999998E-002 8.0000000000000002E-002'
check 'curve --sweep: a column that only some cases have is empty in others' csv four.csv '
   if ((c["unloading"] == "elastic") != (c["plastic_dissipation"] != "")) fail(c["plastic_dissipation"])'
check 'curve --sweep: what is swept has no value in the listing' sh -c '
   ! grep -E "^  (sigma  .* mm|unloading  *(rev|el)|initial_separation) " out && grep -q "^  eta  *206.0" out'
check 'curve --sweep: no note on faces of one case' lacks out 'Pair:'
check 'curve --sweep: validity counts rows of all cases' sh -c \
   "run() { '$program' curve --sweep sigma=0.04,0.08 --separation 0; }; run | grep -q '(2 of 2 rows, the first is row 1)'"

run press --unloading elastic --sweep surface=unpolished-cross,mesh-400-cross --increments 10 --csv p.csv --json p.json
check 'press --sweep' is_quiet
run press --unloading elastic --surface mesh-400-cross --increments 10 --csv one.csv
case_rows p.csv mesh-400-cross 1 >rows
check 'press --sweep: a surface is a run of its own' sh -c 'tail -n +2 one.csv | cmp - rows'
check 'press --sweep: the summary has a row a case' \
   has p.json '"surface": ["unpolished-cross", "mesh-400-cross"]'
run shear --sweep friction_coefficient=0.3,0.4 --normal-stress 0.05,0.2 --displacement 1 --csv s.csv
check 'shear --sweep' is_quiet
run shear --friction-coefficient 0.4 --normal-stress 0.05,0.2 --displacement 1 --csv one.csv
case_rows s.csv 4.0000000000000002E-001 1 >rows
check 'shear --sweep: a case is a run of its own' sh -c 'tail -n +2 one.csv | cmp - rows'

refuses 'sweep: a value that is refused, with its case' 2 \
   '--sweep, sigma = -1.0 mm, radius = 0.1 mm: --sweep sigma=-1: sigma = -1.0 is not allowed' \
   curve --sweep sigma=0.04,-1 --sweep radius=0.1,0.2
refuses 'sweep: an unknown surface' 2 "--sweep, surface = mesh: --sweep surface=mesh: .*'mesh'" curve --sweep surface=mesh
refuses 'sweep: an unknown key' 2 "--sweep: unknown key 'sigm'; did you mean sigma" curve --sweep sigm=1
refuses 'sweep: a list' 2 '--sweep: separation cannot be swept' curve --sweep separation=0,1
refuses 'sweep: units that differ' 2 '--sweep: peak is in mm in some cases and in MPa in others' \
   press --accept-sizes --peak 0.1 --sweep control=pressure,overclosure
if command -v gnuplot >/dev/null; then
   run curve --sweep sigma=0.04,0.08 --plot c.svg
   check 'sweep: one picture, a legend a case' sh -c \
      'grep -q ">sigma = 0.04 mm<" c.svg && grep -q ">sigma = 0.08 mm<" c.svg && grep -q ">Normal contact law: " c.svg'
   run press --sweep unloading=reversible,elastic --increments 10 --plot p.svg
   check 'sweep: panels of other axes stand beside' sh -c 'grep -q ">overclosure (mm)<" p.svg && test $(grep -c ">normal stress (MPa)<" p.svg) -eq 2'
else
   skip 'sweep: pictures' 'no gnuplot'
fi
