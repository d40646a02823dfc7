#!/usr/bin/env bash
# CalculiX 2.20 (Debian's calculix-ccx 2.20-1): a pressure-overclosure table has no effect with
# *CONTACT PAIR, TYPE=SURFACE TO SURFACE.
#
# A good guess: the table gives the same pressure in both kinds of contact, as the linear law does in
# face-to-face contact. Seen: the lid of two blocks is pushed down by 0.002 mm on a law of 1000 MPa/mm;
# the reaction is 196 N node to face, 196 N face to face with the linear law, and 0 face to face with
# the table. The faces pass through each other, the job ends with status 0, no message.
source "$(dirname "$0")/lib/setup.sh"
source "$findings/lib/two_blocks.sh"
debian_package calculix-ccx=2.20-1
ccx=$folder/debian/usr/bin/ccx
version_is 2.20 "$ccx" -v

reaction() { # contact-type behaviour
   two_blocks "$slave_faces" "$1" "$2" $'*BOUNDARY\nLID,3,3,-0.002' \
      $'*NODE PRINT, NSET=GROUND, TOTALS=ONLY\nRF' >job.inp
   "$ccx" job >log
   awk 'NF == 3 { printf "%.0f\n", $3 }' job.dat
}
expect 'node to face, table 196 N; face to face, linear 196 N, table 0 N' \
   "node to face, table $(reaction 'NODE TO SURFACE' "$table") N; face to face, linear $(
      reaction 'SURFACE TO SURFACE' "$linear") N, table $(reaction 'SURFACE TO SURFACE' "$table") N"
