# A deck of two cubes of 10 mm, one on the other, with matching faces, of a material a thousand times
# stiffer than the contact, held sideways; the lower one stands. What contact and load are comes from
# the finding.
two_blocks() { # slave-surface contact-type behaviour load output
   cat <<DECK
*NODE, NSET=ALL
1,0,0,0
2,10,0,0
3,10,10,0
4,0,10,0
5,0,0,10
6,10,0,10
7,10,10,10
8,0,10,10
11,0,0,10
12,10,0,10
13,10,10,10
14,0,10,10
15,0,0,20
16,10,0,20
17,10,10,20
18,0,10,20
*NSET, NSET=GROUND
1,2,3,4
*NSET, NSET=LID
15,16,17,18
*NSET, NSET=CORNERS
5,11
*ELEMENT, TYPE=C3D8, ELSET=BLOCKS
1,1,2,3,4,5,6,7,8
2,11,12,13,14,15,16,17,18
*MATERIAL, NAME=STIFF
*ELASTIC
1e6,0
*SOLID SECTION, ELSET=BLOCKS, MATERIAL=STIFF
*SURFACE, NAME=MASTER
1,S2
$1
*SURFACE INTERACTION, NAME=LAW
$3
*CONTACT PAIR, INTERACTION=LAW, TYPE=$2
SLAVE, MASTER
*BOUNDARY
ALL,1,2
GROUND,3
*STEP
*STATIC
1,1
$4
$5
*END STEP
DECK
}
slave_faces=$'*SURFACE, NAME=SLAVE\n2,S1'
slave_nodes=$'*SURFACE, NAME=SLAVE, TYPE=NODE\n11\n12\n13\n14'
# 1000 MPa/mm, by a table and by the linear law
table=$'*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR\n0,0\n1000,1'
linear=$'*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1000,'
