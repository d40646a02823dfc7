#!/usr/bin/env bash
# CalculiX 2.20 (Debian's calculix-ccx 2.20-1): PRESSURE-OVERCLOSURE=LINEAR is a line in face-to-face
# contact only.
#
# A good guess: 1000 MPa/mm under 1 MPa closes by 0.001 mm. Seen: so it does face to face, and node to
# face with a table of two rows; node to face with the linear law it closes by 0.00195 mm. The law is
# smoothed there by an arcus tangens of a width of 0.001 times the root of the area, here 0.01 mm, so
# that closures well below that meet half the stiffness that was given.
source "$(dirname "$0")/lib/setup.sh"
source "$findings/lib/two_blocks.sh"
debian_package calculix-ccx=2.20-1
ccx=$folder/debian/usr/bin/ccx
version_is 2.20 "$ccx" -v

closure() { # contact-type behaviour
   two_blocks "$slave_faces" "$1" "$2" $'*DLOAD\n2,P2,1.' \
      $'*NODE PRINT, NSET=CORNERS\nU' >job.inp
   "$ccx" job >log
   awk '$1 == 5 { below = $4 } $1 == 11 { printf "%.5f\n", below - $4 }' job.dat
}
expect 'face to face 0.00100 mm; node to face 0.00195 mm, with a table 0.00100 mm' \
   "face to face $(closure 'SURFACE TO SURFACE' "$linear") mm; node to face $(
      closure 'NODE TO SURFACE' "$linear") mm, with a table $(closure 'NODE TO SURFACE' "$table") mm"
