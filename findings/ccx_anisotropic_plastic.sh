#!/usr/bin/env bash
# CalculiX 2.20 (Debian's calculix-ccx 2.20-1): beside orthotropic elasticity, *PLASTIC is a straight line.
#
# A good guess: a cube that is pressed far beyond the last point of its hardening curve, 9 MPa, has 9 MPa,
# as it has with isotropic elasticity and as ABAQUS documents it. Seen: with engineering constants the
# first two points make a line (40 MPa here) that goes on for ever, further points are not used, and
# a warning says that the curve is "possibly nonlinear"; it has 8.65 MPa, on that line.
source "$(dirname "$0")/lib/setup.sh"
debian_package calculix-ccx=2.20-1
ccx=$folder/debian/usr/bin/ccx
version_is 2.20 "$ccx" -v

stress() { # elastic-card-and-data: stress at the end, MPa, and plastic strain
   cat >job.inp <<DECK
*NODE, NSET=ALL
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,0,0,1
6,1,0,1
7,1,1,1
8,0,1,1
*ELEMENT, TYPE=C3D8, ELSET=CUBE
1,1,2,3,4,5,6,7,8
*MATERIAL, NAME=WOOD
$1
*PLASTIC
4.7, 0.0
5.5, 0.02
9.0, 0.04
*SOLID SECTION, ELSET=CUBE, MATERIAL=WOOD
*NSET, NSET=TOP
5,6,7,8
*BOUNDARY
1,1,3,0
2,2,3,0
3,3,3,0
4,1,1,0
4,3,3,0
*STEP
*STATIC
0.02,1.,1e-5,0.02
*BOUNDARY
TOP,3,3,-0.1234
*EL PRINT, ELSET=CUBE, FREQUENCY=50
S,PEEQ
*END STEP
DECK
   "$ccx" job >log
   awk '$1 == 1 && $2 == 1 && NF > 4 { s = -$5 } $1 == 1 && $2 == 1 && NF == 3 { e = $3 }
      END { printf "%.2f MPa at %.3f", s, e }' job.dat
}
expect 'isotropic 9.00 MPa at 0.098, orthotropic 8.65 MPa at 0.099' \
   "isotropic $(stress $'*ELASTIC\n351.01, 0.35'), orthotropic $(
   stress $'*ELASTIC, TYPE=ENGINEERING CONSTANTS\n3727.12, 351.01, 351.01, 0.62, 0.42, 0.35, 224.61, 280.32\n67.16')"
