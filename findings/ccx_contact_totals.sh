#!/usr/bin/env bash
# CalculiX 2.20 (Debian's calculix-ccx 2.20-1): the total contact force of a pair is printed as zero in
# node-to-surface contact.
#
# A good guess: *CONTACT PRINT, SLAVE=..., MASTER=... with CF gives the force between two blocks, 100 N
# under 1 MPa, or stops if it cannot. Seen: 100 N in face-to-face contact; node to face the force is 0 and
# centre and normal are NaN, although CSTR prints 1 MPa at each node. Status 0, no message.
source "$(dirname "$0")/lib/setup.sh"
source "$findings/lib/two_blocks.sh"
debian_package calculix-ccx=2.20-1
ccx=$folder/debian/usr/bin/ccx
version_is 2.20 "$ccx" -v

total() { # contact-type: z component of the total force
   two_blocks "$slave_faces" "$1" "$linear" $'*DLOAD\n2,P2,1.' \
      $'*CONTACT PRINT, SLAVE=SLAVE, MASTER=MASTER\nCF' >job.inp
   "$ccx" job >log || echo "status $?"
   awk '/total surface force/ { found = 1; next } found && NF == 6 { printf "%.1f\n", $3; exit }' job.dat
}
expect 'node to face 0.0 N, face to face 100.0 N' \
   "node to face $(total 'NODE TO SURFACE') N, face to face $(total 'SURFACE TO SURFACE') N"
