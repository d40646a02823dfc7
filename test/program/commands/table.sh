# asperity table: rows of the law for ABAQUS and CalculiX

run table --csv t.csv --json t.json --abaqus t.abaqus --calculix t.calculix
check 'table' is_quiet
check 'table: CalculiX, said beside the table' has out 'CalculiX: TYPE=NODE TO SURFACE only'
check 'table: stick slope is said' has out '7.5806'
check 'table: columns' test "$(columns t.csv)" = \
   'pressure,overclosure,separation,law_pressure,validity'
check 'table: 44 rows' test "$(rows t.csv)" -eq 44
check 'table: ascending from zero, on a row a little below the law' csv t.csv '
   if (NR == 2 && c["pressure"] != 0) fail("first row")
   if (NR > 2 && !(c["pressure"] > before["pressure"] && c["overclosure"] > before["overclosure"]))
      fail("not ascending")
   if (NR > 2 && NR < 45 && far(c["pressure"], 0.99*c["law_pressure"], 3e-4)) fail("lowered")
   if (NR == 45 && !(c["pressure"] > 400 && c["law_pressure"] == "")) fail("last row")'

# Interpolated at the separations of a curve, which are none of the rows
separations=0.0958:0.32:500
run curve --separation "$separations" --csv c.csv
interpolated() { # TABLE CURVE TOLERANCE
   awk -F, -v tolerance="$3" '
      FNR == 1 { file++; next }
      file == 1 { p[++n] = $1; x[n] = $2; next }
      { u = $2; for (i = n - 1; i > 1 && x[i] > u; i--) continue
        e = (p[i] + (p[i + 1] - p[i])*(u - x[i])/(x[i + 1] - x[i]))/$3 - 1
        if (e > largest) largest = e; if (e < smallest) smallest = e }
      END { print smallest, largest
         exit !(largest <= tolerance && smallest >= -tolerance && largest > 0.9*tolerance \
            && smallest < -0.9*tolerance) }' "$1" "$2"
}
check 'table: interpolation is within 1 % of the curve' interpolated t.csv c.csv 0.01
run table --tolerance 0.001 --csv fine.csv
check 'table: interpolation is within 0.1 % of the curve' interpolated fine.csv c.csv 0.001

# The rows of the decks are those of the CSV file to 12 figures
same_rows() {
   sed -n '/TABULAR/,/FRICTION/{/^[-0-9]/p}' "$1" | tr -d ' ' | paste -d, - <(tail -n +2 t.csv) \
      | awk -F, '{ if (($1 - $3)^2 > 1e-22*$3^2 || ($2 - $4)^2 > 1e-22*$4^2) { print; exit 1 } }
           END { exit NR != 44 }'
}
for host in abaqus calculix; do
   check "table: rows for $host" same_rows t.$host
   check "table: numbers for $host have up to 20 characters" \
      sh -c "! grep '^[-0-9]' t.$host | tr -d ' ' | tr ',' '\n' | grep -E '.{21}'"
   check "table: lines for $host are short" sh -c "! grep -E '.{100}' t.$host"
   check "table: $host, error" has t.$host '44 rows: linear interpolation is within 0.998'
   check "table: $host, range" has t.$host 'between 2.781E-7 and 4.7 MPa'
   check "table: $host, datum" has t.$host 'separation of the mean planes = 0.2372 mm - overclosure'
done
check 'table: gcrit for ABAQUS' has t.abaqus '*FRICTION, ELASTIC SLIP=0.31'
check 'table: stick slope for CalculiX' test "$(tail -n 1 t.calculix)" = '0.5, 7.58064516129'
check 'table: CalculiX, surface to surface' has t.calculix 'NODE TO SURFACE on *CONTACT PAIR only'
check 'table: CalculiX, a table with surface to surface' has t.calculix 'no pressure at all, without a message'
check 'table: CalculiX, penetration at the start' has t.calculix 'Penetration at the start stays'
check 'table: CalculiX, penetration is not taken away' lacks t.calculix 'taken away'
check 'table: CalculiX, what *CONTACT PRINT gives' has t.calculix 'the totals CF, CFN, CFS are zero'
check 'table: CalculiX, clearance' has t.calculix '0.001 sqrt(area of the slave node)'
run table --stick-pressure 0.2 --calculix -
check 'table: stick slope at another pressure' test "$(tail -n 1 out)" = '0.5, 0.322580645161'
check 'table: CalculiX, which pressure' has out 'mu p/gcrit at p = 0.2 MPa'
run table --friction-coefficient 0 --calculix t0.calculix --abaqus t0.abaqus
check 'table: no friction' sh -c 'cat t0.* | grep -c "No friction" | grep -q 2 && ! grep FRICTION t0.*'
run table --abaqus -
check 'table: no remark on CalculiX for ABAQUS' is_quiet
check 'table: --abaqus - is the deck' cmp out t.abaqus
run table --largest-pressure 22 --abaqus t22.abaqus
check 'table: past a limit, in the deck' has t22.abaqus 'CAUTION: real area above nominal area'
check 'table: past a limit, on the terminal' has out 'real area above nominal area'
run table --initial-separation 0 --csv shifted.csv
check 'table: rows move with the datum' sh -c "paste -d, t.csv shifted.csv | tail -n +2 | awk -F, \
   '{ d = \$2 - \$7 - 0.2372; if (d*d > 1e-28 || \$1 != \$6) { print; exit 1 } }'"
run table --rows 500 --tolerance 1e-4 --abaqus many.abaqus
check 'table: more rows for ABAQUS' test "$status" -eq 0 -a "$(grep -c '^[-0-9]' many.abaqus)" -gt 400

refuses 'table: too many rows needed' 2 '--tolerance: tolerance = 0.0001 .*|rows = 200 is too few' \
   table --tolerance 1e-4 --abaqus never.inc
refuses 'table: too few allowed' 2 '--rows: rows = 40 is too few: tolerance = 0.01 .* needs 44' \
   table --rows 40 --csv never.csv --calculix never.inc
refuses 'table: no table of three rows' 2 '--rows: rows = 3 is not allowed' table --rows 3
refuses 'table: too many rows for CalculiX' 2 '--?r?o?w?s?:? ?rows = 4[0-9][0-9] is too many for Calc' \
   table --rows 500 --tolerance 1e-4 --calculix never.inc --abaqus never.inc2
refuses 'table: pressure above the hardness' 2 \
   '--largest-pressure: largest_pressure = 25.0 MPa is above the hardness, 24.53 MPa' \
   table --largest-pressure 25 --calculix never.inc
refuses 'table: negative pressure' 2 '--largest-pressure: largest_pressure = -1.0 is not' \
   table --largest-pressure -1
refuses 'table: pressure of an open point' 2 \
   '--largest-pressure: .* must be above smallest_pressure, 2.781E-7' table --largest-pressure 1e-7
refuses 'table: no range' 2 '--largest-pressure: .* above smallest_pressure, 1.0 MPa' \
   table --largest-pressure 1 --smallest-pressure 1
refuses 'table: a table cannot unload' 2 \
   '--unloading: unloading = elastic is not allowed with the law as a table: .* must be reversible, or take UINTER' \
   table --unloading elastic --abaqus never.inc
printf "&asperity unloading = 'elastic' /\n" >memory.nml
refuses 'table: nor can that of a case' 2 'memory.nml:1: unloading = elastic is not allowed with the law' \
   table memory.nml --csv never.csv
refuses 'table: no tolerance' 2 '--tolerance: tolerance = 0.0 is not' table --tolerance 0
refuses 'table: no stick pressure' 2 '--stick-pressure: stick_pressure = 0.0 is not' \
   table --stick-pressure 0
refuses 'table: far datum' 2 '--initial-separation: initial_separation = 1.0E\+?9 mm is not' \
   table --initial-separation 1e9 --accept-unphysical
refuses 'table: key of another command' 2 '--peak: is an option of press' table --peak 3
refuses 'table: two decks on standard output' 2 '--calculix: standard output already takes' \
   table --calculix - --abaqus -
refuses 'table: folder does not exist' 3 '--calculix: no/x.inc cannot be written' \
   table --calculix no/x.inc
printf '&asperity tolerance = 0.02 /\n' >case.nml
refuses 'table: the case file as deck' 2 '--abaqus: case.nml is the case file' \
   table case.nml --abaqus case.nml
check 'table: nothing is written then' sh -c '! ls never* 2>/dev/null'

# In stock CalculiX: two stiff cubes pressed to a known overclosure, then slid; slave above
deck() { # OVERCLOSURE SLIDE INTERACTION
   cat <<TEXT
*NODE, NSET=ALL
1, -5, -5, 0
2, 25, -5, 0
3, 25, 15, 0
4, -5, 15, 0
5, -5, -5, 10
6, 25, -5, 10
7, 25, 15, 10
8, -5, 15, 10
11, 0, 0, 10
12, 10, 0, 10
13, 10, 10, 10
14, 0, 10, 10
15, 0, 0, 20
16, 10, 0, 20
17, 10, 10, 20
18, 0, 10, 20
*ELEMENT, TYPE=C3D8, ELSET=BLOCKS
1, 1, 2, 3, 4, 5, 6, 7, 8
2, 11, 12, 13, 14, 15, 16, 17, 18
*NSET, NSET=BOTTOM
1, 2, 3, 4
*NSET, NSET=TOP
15, 16, 17, 18
*SURFACE, NAME=MASTER
1, S2
*SURFACE, NAME=SLAVE
2, S1
*MATERIAL, NAME=STIFF
*ELASTIC
1.E8, 0.
*SOLID SECTION, ELSET=BLOCKS, MATERIAL=STIFF
$(cat "$3")
*CONTACT PAIR, INTERACTION=WOOD, TYPE=NODE TO SURFACE
SLAVE, MASTER
*STEP, NLGEOM
*STATIC
1., 1.
*BOUNDARY
BOTTOM, 1, 3
TOP, 1, 2
TOP, 3, 3, -$1
*NODE PRINT, NSET=TOP, TOTALS=ONLY
RF
*END STEP
*STEP, NLGEOM
*STATIC
0.5, 1., 1.E-6, 0.5
*BOUNDARY
TOP, 1, 1, $2
*NODE PRINT, NSET=TOP, TOTALS=ONLY
RF
*END STEP
TEXT
}
if command -v ccx >/dev/null; then
   # forces on the cube over its 100 mm^2, at the last time of each step; mu 0.5
   for overclosure in 0 0.02 0.08 0.14; do
      run curve --separation "$(awk -v x=$overclosure 'BEGIN { print 0.2372 - x }')" --csv law.csv
      deck $overclosure 2.5 t.calculix >blocks.inp
      OMP_NUM_THREADS=1 ccx -i blocks >ccx.log 2>&1
      forces=$(awk 'NF == 3 && /[0-9]E/ { print $1, $3 }' blocks.dat | sed -n '1p;$p' | tr '\n' ' ')
      law=$(csv_column law.csv pressure)
      check "table: CalculiX finds the law at $overclosure mm, and mu p: $law MPa, $forces N" \
         awk -v f="$forces" -v p="$law" 'BEGIN { split(f, a)
            e = -a[2]/(100*p) - 1; t = a[3]/(0.5*a[4]); print e, t
            exit !(e*e < 1.02e-2^2 && (t + 1)^2 < 1e-8) }'
   done
else
   skip 'table: in CalculiX' 'no ccx'
fi
