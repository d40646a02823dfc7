# asperity press: the ramp through UINTER

header=time,overclosure,separation,pressure,stiffness,area_fraction,contact_density,energy,\
elastic_share,elastoplastic_share,plastic_share,status,validity
run press --csv p.csv --json p.json
check 'press' is_quiet
check 'press: columns' test "$(columns p.csv)" = "$header"
check 'press: start and two ramps of 50' test "$(rows p.csv)" -eq 101
check 'press: 17 figures' numbers_are_proper p.csv
check 'press: JSON holds the same figures' same_csv_and_json p.csv p.json
# The replay balances the pressure to 1e-12
check 'press: pressure follows the ramp' csv p.csv '
   i = NR - 2; p = 4.7*(50 - (i > 50 ? i - 50 : 50 - i))/50
   if (p > 0 && far(c["pressure"], p, 2e-12)) fail(c["pressure"] " not " p)
   if (i*0.02 - c["time"] > 1e-12 || c["time"] - i*0.02 > 1e-12) fail("time")'
check 'press: open at both ends, closed between' csv p.csv \
   'if ((NR == 2 || NR == 102) != (c["status"] == "open")) fail(c["status"])'
csv_column p.csv separation | head -n 51 >up
csv_column p.csv separation | tail -n 51 | sort -r -g >down
paste -d' ' up down >up_down
check 'press: down is up backwards' \
   awk '{ d = $1 - $2; if (d > 1e-13 || d < -1e-13) { print; exit 1 } }' up_down

# The same law as `asperity curve`: 1e-13, as rounding d = d0 - overclosure moves p by h^2 eps
csv_column p.csv separation | tr '\n' ',' | sed 's/,$//' >separations
run curve --separation "$(cat separations)" --csv c.csv
for name in pressure stiffness energy area_fraction plastic_share; do
   csv_column p.csv $name >pressed
   csv_column c.csv $name >law
   paste -d' ' pressed law >both
   check "press: $name is the law's" awk '{ d = $1 - $2; if (d < 0) d = -d
      if (d > 1e-13*$2) { print; exit 1 } }' both
done

run press --control overclosure --peak 0.15 --increments 10 --csv p.csv
check 'press: overclosure ramp' csv p.csv '
   i = NR - 2; if (far(c["overclosure"], 0.15*(10 - (i > 10 ? i - 10 : 10 - i))/10, 1e-15)) fail("ramp")'
run press --peak 50
check 'press: past the limits, said below the table' has out 'b  pressure above the hardness'
refuses 'overclosure needs a peak' 2 '--control: control = overclosure needs a peak' \
   press --control overclosure
printf "&asperity control = 'overclosure' /\n" >control.nml
run shear control.nml --normal-stress 0.1
check 'which does not matter to shear' test "$status" -eq 0
refuses 'unknown control' 2 "--control: control = 'foo' is unknown" press --control foo
refuses 'no increments' 2 '--increments: increments = 0 is not allowed' press --increments 0
refuses 'negative increments' 2 '--increments: increments = -5 is not' press --increments -5
refuses 'giant increments' 2 '--increments: increments = 2000000000 is not' \
   press --increments 2000000000
refuses 'increments past the integers' 2 '--increments: .* not a whole number within range' \
   press --increments 99999999999
refuses 'increments with a fraction' 2 '--increments: .* not a whole number' \
   press --increments 1.5
refuses 'a peak in Pa' 2 '--peak: peak = 4700000.0 MPa is outside 0.01227 to 245.3 MPa: .* looks like Pa, write 4.7' \
   press --peak 4.7e6
refuses 'a closure in micrometres' 2 '--peak: peak = 140.0 mm .* micrometres, write 0.14' \
   press --control overclosure --peak 140
refuses 'a closure in metres' 2 '--peak: peak = 0.00014 mm .* metres, write 0.14' \
   press --control overclosure --peak 1.4e-4
run press --control overclosure --peak 1.4e-4 --accept-sizes
check 'press: a peak that is accepted' is_quiet
refuses 'negative peak' 2 '--peak: peak = -1.0 is not allowed' press --peak -1
refuses 'no step time' 2 '--step-time: step_time = 0.0 is not allowed' press --step-time 0

# With memory: loops of pressure over closure
run press --unloading elastic --peak 2,4.7,3 --increments 20 --csv p.csv --json p.json
check 'press, memory' is_quiet
check 'press, memory: columns' test "$(columns p.csv)" = \
   "${header/energy,/energy,plastic_dissipation,closest_separation,residual_closure,cycle_loss,}"
check 'press, memory: JSON holds the same figures' same_csv_and_json p.csv p.json
summary() { sed -n '/^"summary"/,/^}/p' p.json | sed -n "s/^\"$1\": \[\(.*\)\].*/\1/p" | tr -d ' '; }
check 'press, memory: start and three times two ramps' test "$(rows p.csv)" -eq 121
check 'press, memory: a row a loop ends with residual and loss' csv p.csv '
   if ((NR == 42 || NR == 82 || NR == 122) != (c["cycle_loss"] != "" && c["residual_closure"] != "")) fail(NR)
   if (NR > 2 && c["plastic_dissipation"] < before["plastic_dissipation"]) fail("falls")'
check 'press, memory: they are those of the summary' test \
   "$(csv_column p.csv cycle_loss | grep . | paste -sd,)" = "$(summary cycle_loss)" -a \
   "$(csv_column p.csv residual_closure | grep . | paste -sd,)" = "$(summary residual_closure)"
check 'press, memory: no loss below the peak before' test "$(summary cycle_loss | cut -d, -f3)" = 0.0000000000000000E+000
# What the loops lose is dissipated, but for what is stored at the opening pressure
check 'press, memory: the losses are the dissipation' near \
   "$(summary cycle_loss | awk -F, '{ print $1 + $2 + $3 }')" \
   "$(csv_column p.csv plastic_dissipation | tail -n 1)" 1e-7
check 'press, memory: the table says so' has out 'residual'
run press --peak 2,4.7 --increments 20 --json p.json --csv p.csv
check 'press: the reversible law loses nothing' test "$(summary cycle_loss)" = \
   0.0000000000000000E+000,0.0000000000000000E+000
check 'press: nor does it remember' test "$(columns p.csv)" = "$header"
run press --unloading elastic --control overclosure --peak 0.12,0.15 --csv p.csv
check 'press, memory: by overclosure' is_quiet
check 'press, memory: it parts on the way back' csv p.csv \
   'if (NR == 102 && (c["pressure"] > 1e-100 || c["status"] != "open")) fail(c["pressure"])'
check 'press, memory: exponents of three digits keep their letter' awk '
   /[0-9][+-][0-9][0-9][0-9]/ { print; bad = 1 } /E-1[0-9][0-9]/ { seen = 1 } END { exit bad || !seen }' out
refuses 'one of several peaks' 2 '--peak: peak = 0.0 is not allowed' press --peak 1,0
refuses 'peaks that are no numbers' 2 "--peak: .* 'x' is not a finite number" press --peak 1,x
refuses 'unloading of no kind' 2 "--unloading: unloading = 'yes' is unknown" press --unloading yes
