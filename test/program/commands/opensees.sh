# --opensees FILE: a material of OpenSees that follows a record or a joint

# Loops of a joint with friction and slack: an envelope 10 x/(1 + x), unloaded to a plateau of 1
slack() {
   awk 'function move(to) { n = 16; for (i = 1; i <= n; i++) { y = x + (to - x)*i/n; print y "," force(y) }; x = to }
      function envelope(y) { return y >= 0 ? 10*y/(1 + y) + (y > 0.2 ? 1 : 5*y) : -envelope(-y) }
      function force(y) { s = to_sign; z = s*y
         return z >= reach[s] ? s*envelope(z) : s*(z < 0.7*reach[s] ? 1 : 1 + (envelope(reach[s]) - 1)*(z/reach[s] - 0.7)/0.3) }
      function go(a) { to_sign = a > 0 ? 1 : -1; move(a); if (a*to_sign > reach[to_sign]) reach[to_sign] = a*to_sign }
      BEGIN { print "displacement (mm),force (kN)"; x = 0; reach[1] = reach[-1] = 0; print "0,0"
         for (k = 1; k <= 4; k++) for (j = 1; j <= 2; j++) { go(2*k); go(-2*k) } to_sign = 1; move(0) }'
}
slack >slack.csv

run hysteresis slack.csv --opensees joint.py --json joint.json
check 'opensees: a file in Python' test -s joint.py
check 'opensees: which says its units' has joint.py '# Units: displacement in mm, force in kN, energy in kN mm'
check 'opensees: and how many steps' has joint.py 'Half a cycle takes at least'
check 'opensees: the comparison is on the screen' has out 'Materials of OpenSees'
check 'opensees: both materials that take energy were tried' sh -c \
   'grep -q "^ *dowel_type " out && grep -q "^ *pinching4 " out'
check 'opensees: and in JSON' has joint.json '"material_energy": '
check 'opensees: the head has each cycle' test "$(grep -c '^# *[1-8] .* ' joint.py)" -eq 8
check 'opensees: Python parses' sh -c 'command -v python3 >/dev/null || exit 0; python3 -m py_compile joint.py'
run hysteresis slack.csv --opensees - --opensees-material pinching4
check 'opensees: to standard output, of a material that is named' has out "ops.uniaxialMaterial('Pinching4', tag,"
run hysteresis slack.csv --opensees joint.tcl --opensees-material elastic_gap
check 'opensees: a file in Tcl' has joint.tcl 'uniaxialMaterial ElasticMultiLinear [expr {$tag}]'
check 'opensees: no energy is said' has out 'elastic_gap misses the energy of a cycle by up to 100'
check 'opensees: Tcl parses' sh -c \
   'command -v tclsh >/dev/null || exit 0; printf "source joint.tcl\nputs [llength \$ends]\n" >t.tcl; tclsh t.tcl | grep -Eq "^[0-9]+$"'

# What is refused
run hysteresis slack.csv --opensees joint.txt
check 'opensees: neither .py nor .tcl' is_refused 2 '--opensees: joint.txt is neither .py nor .tcl'
printf '%s\n' x,f 0,0 1,5 2,8 3,9 4,9 >out_only.csv
run hysteresis out_only.csv --opensees none.py
check 'opensees: a monotonic record' is_refused 2 '--opensees: out_only.csv: the record is monotonic: a material with loops takes a cyclic one'
check 'opensees: then nothing is written' test ! -e none.py
printf '%s\n' displacement 0 5 2 9 >push.csv
run tenon --opensees none.py --history push.csv
check 'opensees: a history to one side' is_refused 2 '--opensees: a material with loops takes cycles to both sides'
run tenon --opensees none.py --sweep clearance=0.1,0.2
check 'opensees: a sweep' is_refused 2 '--opensees: is for one run, not for --sweep'
