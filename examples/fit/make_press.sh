#!/bin/sh
# Write press.csv, a press record as a test would give it, but of known numbers: loading and unloading
# of faces of eta 260 /mm^2 that meet 0.21 mm below the datum, on a machine that yields 0.004 mm/MPa,
# with noise of 0.01 MPa (seed 7).
#    make_press.sh ASPERITY >press.csv
"$1" press --eta 260 --initial-separation 0.21 --unloading elastic --peak 3 --increments 40 --csv - 2>/dev/null |
   awk -F, -v state=7 '
      function uniform() { state = (48271*state)%2147483647; return state/2147483647 }
      function noise() { return sqrt(-2*log(uniform()))*cos(6.283185307179586*uniform()) }
      NR == 1 { for (i = 1; i <= NF; i++) { if ($i ~ /^overclosure/) x = i; if ($i ~ /^pressure/) p = i }
                print "closure (mm),pressure (MPa)"; next }
      $p > 1e-3 { printf "%.5f,%.4f\n", $x + 0.004*$p, $p + 0.01*noise() }'
