#!/usr/bin/env bash
# Open MPI 4.1.4 (Debian's libopenmpi-dev 4.1.4): a program that is started without mpirun starts a
# second process.
#
# A good guess: a program that calls MPI_Init and is run by itself is one process, as there is nothing to
# launch or to watch. Seen: MPI_Init starts orted as its child, in a session of its own; so does every
# library that starts MPI, PETSc for one. With OMPI_MCA_ess_singleton_isolated=1 there is none.
source "$(dirname "$0")/lib/setup.sh"
version_is 4.1.4 mpirun --version
cat >alone.c <<'C'
#include <mpi.h>
#include <stdio.h>

/* says when MPI has started, and waits for a character */
int main(int argc, char **argv)
{
   MPI_Init(&argc, &argv);
   puts("started");
   fflush(stdout);
   getchar();
   return MPI_Finalize();
}
C
mpicc alone.c -o alone
children() { # names of the program's children, or none, while it waits
   local program started
   coproc alone { exec ./alone; }
   program=$alone_PID
   read -r started <&"${alone[0]}"
   [[ $started == started ]]
   ps --ppid "$program" -o comm= || echo none
   echo >&"${alone[1]}"
   wait "$program"
}
found=$(children)
isolated=$(OMPI_MCA_ess_singleton_isolated=1 children)
expect 'children: orted, isolated: none' "children: $found, isolated: $isolated"
