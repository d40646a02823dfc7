#!/usr/bin/env bash
# CalculiX 2.20 (Debian's calculix-ccx 2.20-1): a slave surface made of nodes (*SURFACE, TYPE=NODE)
# carries less pressure than one made of the same nodes' faces.
#
# A good guess: both give the pressure that is applied, as the nodes are the same, the blocks match and
# the load is 1 MPa. Seen: 1 MPa with faces, 1/3 MPa with nodes, so that the faces close by a third.
# The tributary area of a node is taken over all faces of the mesh that meet there, the sides of the
# block among them: 75 in place of 25 mm2 at each corner. The job ends with status 0, no message.
source "$(dirname "$0")/lib/setup.sh"
source "$findings/lib/two_blocks.sh"
debian_package calculix-ccx=2.20-1
ccx=$folder/debian/usr/bin/ccx
version_is 2.20 "$ccx" -v

pressure() { # slave-surface
   two_blocks "$1" 'NODE TO SURFACE' "$table" $'*DLOAD\n2,P2,1.' $'*CONTACT PRINT\nCSTR' >job.inp
   "$ccx" job >log
   awk '$1 == 11 { printf "%.3f\n", $2 }' job.dat
}
expect 'faces: 1.000 MPa, nodes: 0.333 MPa' \
   "faces: $(pressure "$slave_faces") MPa, nodes: $(pressure "$slave_nodes") MPa"
