#!/usr/bin/env bash
# CalculiX 2.20 (Debian's calculix-ccx 2.20-1): forces of an axisymmetric model go in as those of the whole
# ring and come out as those of a wedge of 2 degrees with flat sides.
#
# A good guess: a *CLOAD of 360 N on a CAX4 ring, whose foot is held, gives a reaction of -360 N, and 1 MPa on
# its top of 5 to 15 mm gives -628.32 N, its area. Seen: *NODE PRINT, TOTALS of RF has -2 N, 1/180 of the load;
# for the pressure -3.48995 N, which is sin(2 degrees)/2 (15^2 - 5^2), 2e-4 less than 1/180 of the area: so the
# same total load by *CLOAD and by *DLOAD gives two reactions. Status 0, no message.
source "$(dirname "$0")/lib/setup.sh"
debian_package calculix-ccx=2.20-1
ccx=$folder/debian/usr/bin/ccx
version_is 2.20 "$ccx" -v

reaction() { # load-cards: y component of the total of the foot
   cat >job.inp <<D
*NODE
1, 5., 0.
2, 15., 0.
3, 15., 10.
4, 5., 10.
*ELEMENT, TYPE=CAX4, ELSET=RING
1, 1, 2, 3, 4
*NSET, NSET=FOOT
1, 2
*MATERIAL, NAME=M
*ELASTIC
1000., 0.
*SOLID SECTION, ELSET=RING, MATERIAL=M
*BOUNDARY
FOOT, 2
*STEP
*STATIC
$1
*NODE PRINT, NSET=FOOT, TOTALS=ONLY
RF
*END STEP
D
   "$ccx" job >log || echo "status $?"
   awk '/total force/ { found = 1; next } found && NF == 3 { printf "%.5f\n", $2; exit }' job.dat
}
expect '360 N: -2.00000 N, 1 MPa: -3.48995 N' \
   "360 N: $(reaction $'*CLOAD\n3, 2, 360.') N, 1 MPa: $(reaction $'*DLOAD\n1, P3, -1.') N"
