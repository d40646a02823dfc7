#!/usr/bin/env bash
# Makes the records of this folder by formula; none was measured.
# usage: examples/records/make.sh [FOLDER]     writes into FOLDER, this folder when absent
#
# en_26891.csv: a monotonic test. Envelope F = (11 + 0.35 v)(1 - exp(-9 v/11)) after a slack of 0.1 mm; at 6.4 kN
# (0.4 of an estimate of 16 kN) it creeps by 0.03 mm, goes back to 1.6 kN along 15 kN/mm and comes again; at 17 mm
# the joint breaks.
# cyclic_1.csv to cyclic_3.csv: one programme of EN 12512's kind on joints with slack, alike but for force and stiffness:
# one cycle each of 0.75 and 1.5 mm, three each of 2.25, 3, 6, 12, 18 and 24 mm. The same envelope, falling by 6 % of
# its peak a mm beyond 16 mm; second cycles reach 0.9 of the first force, third ones 0.85; between, a friction of 0.2 kN.
set -euo pipefail
folder=${1:-$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)}

awk 'function envelope(v) { return v > 0 ? (11 + 0.35*v)*(1 - exp(-9*v/11)) : 0 }
   function put(v, f) { printf "%.4f,%.4f\n", v, f }
   BEGIN {
      print "slip (mm),force (kN)"
      put(0, 0)
      for (v = 0.1; envelope(v - 0.1) < 6.4; v += 0.02) put(v, envelope(v - 0.1))
      top = v
      for (i = 0; i <= 3; i++) put(top + 0.01*i, 6.4)
      for (i = 1; i <= 16; i++) put(top + 0.03 - 0.02*i, 6.4 - 0.3*i)
      for (i = 15; i >= 0; i--) put(top + 0.03 - 0.02*i, 6.4 - 0.3*i)
      for (v = top + 0.05; v < 17; v += 0.1) put(v, envelope(v - 0.13))
      put(17.1, 9)
      put(17.2, 5)
   }' >"$folder/en_26891.csv"

cyclic() { # number, factor of force, factor of displacement
   awk -v of_force="$2" -v of_slip="$3" '
      function envelope(v) {
         v /= of_slip
         if (v <= 16) return of_force*(11 + 0.35*v)*(1 - exp(-9*v/11))
         return of_force*16.6*(1 - 0.06*(v - 16))
      }
      # force outwards on the way out: the envelope beyond what was reached, pinched below it
      function outwards(v) {
         f = envelope(v)
         if (v <= reach[side]) f = friction + (kept*envelope(reach[side]) - friction)*(v/reach[side])^4
         return f > friction || reach[1] == 0 ? f : friction
      }
      BEGIN {
         friction = 0.2
         n = split("0.75 1.5 2.25 2.25 2.25 3 3 3 6 6 6 12 12 12 18 18 18 24 24 24", tip, " ")
         print "time (s),displacement (mm),force (kN)"
         printf "0.0,0.000,0.0000\n"
         for (i = 1; i <= n; i++)
            for (side = 1; side >= -1; side -= 2) {
               # the third cycle of a tip comes after two of it
               kept = tip[i] != tip[i - 1] ? 1 : (tip[i] == tip[i - 2] ? 0.85 : 0.9)
               for (j = 1; j <= 20; j++) put(tip[i]*j/20, outwards(tip[i]*j/20))
               peak = outwards(tip[i])
               if (tip[i] > reach[side]) reach[side] = tip[i]
               for (j = 19; j >= 0; j--) {
                  f = peak - 14*(tip[i] - tip[i]*j/20)
                  put(tip[i]*j/20, f > -friction ? f : -friction)
               }
            }
      }
      function put(v, f) { time += 0.5; printf "%.1f,%.3f,%.4f\n", time, side*v, side*f }
   ' >"$folder/cyclic_$1.csv"
}
cyclic 1 1.00 1.00
cyclic 2 1.08 0.95
cyclic 3 0.93 1.04
