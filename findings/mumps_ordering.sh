#!/usr/bin/env bash
# MUMPS 5.5.1 (Debian's libmumps-dev 5.5.1): an order of elimination that it has not is taken for another.
#
# A good guess: ICNTL(7) = 5 orders by METIS; where MUMPS is built without it that is an error or a warning
# (INFOG(1)). Seen: INFOG(1) is 0, nothing is printed, and INFOG(7), the ordering used, is 2, approximate minimum
# fill, for 900 equations and 4, PORD, for 14400. 3, Scotch, ends alike. Who compares orderings compares one with
# itself.
source "$(dirname "$0")/lib/setup.sh"
version_is 5.5.1 dpkg-query -W -f '${Version}' libmumps-dev
cat >ordering.c <<'C'
#include <dmumps_c.h>
#include <mpi.h>
#include <stdio.h>

/* analysis of the five-point matrix of a square, by the ordering asked for */
static void analyse(int ordering, int side)
{
   enum { most = 5*120*120 };
   static int rows[most], columns[most];
   DMUMPS_STRUC_C id = { 0 };
   int n = 0;

   for (int i = 0; i < side; i++)
      for (int j = 0; j < side; j++)
         for (int k = 0; k < 5; k++) {
            int a = i + (k == 1) - (k == 2), b = j + (k == 3) - (k == 4);
            if (a < 0 || b < 0 || a >= side || b >= side) continue;
            rows[n] = 1 + i + side*j;
            columns[n++] = 1 + a + side*b;
         }
   id.comm_fortran = -987654;
   id.par = 1;
   id.job = -1;
   dmumps_c(&id);
   for (int k = 0; k < 4; k++) id.icntl[k] = k == 3 ? 0 : -1;
   id.icntl[6] = ordering;
   id.n = side*side;
   id.nnz = n;
   id.irn = rows;
   id.jcn = columns;
   id.job = 1;
   dmumps_c(&id);
   printf("n %d, ICNTL(7) %d: INFOG(1) %d, INFOG(7) %d\n", id.n, ordering, id.infog[0], id.infog[6]);
   id.job = -2;
   dmumps_c(&id);
}

int main(int argc, char **argv)
{
   MPI_Init(&argc, &argv);
   for (int side = 30; side <= 120; side += 90) {
      analyse(4, side);
      analyse(5, side);
      analyse(3, side);
   }
   return MPI_Finalize();
}
C
mpicc ordering.c -o ordering -ldmumps
expect 'n 900, ICNTL(7) 4: INFOG(1) 0, INFOG(7) 4
n 900, ICNTL(7) 5: INFOG(1) 0, INFOG(7) 2
n 900, ICNTL(7) 3: INFOG(1) 0, INFOG(7) 2
n 14400, ICNTL(7) 4: INFOG(1) 0, INFOG(7) 4
n 14400, ICNTL(7) 5: INFOG(1) 0, INFOG(7) 4
n 14400, ICNTL(7) 3: INFOG(1) 0, INFOG(7) 4' "$(OMPI_MCA_ess_singleton_isolated=1 ./ordering)"
