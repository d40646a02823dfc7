#!/usr/bin/env bash
# PETSc 3.18.5 (Debian's libpetsc-real-dev 3.18.5, which has MUMPS 5.5.1): a factorisation that MUMPS has
# refused is the last of its preconditioner.
#
# A good guess: after a singular matrix, PCSetUp factorises good values of the same pattern as it did
# before, or says that it did not. Seen: it returns 0 and PCGetFailedReason gives 0, no failure, but
# INFOG(1) of MUMPS still is the -10 of the singular matrix: MUMPS has not been called. The solution then
# ends with error 76. After PCReset, or with a new preconditioner, all is well.
source "$(dirname "$0")/lib/setup.sh"
version_is 3.18.5 pkg-config --modversion PETSc
cat >refused.c <<'C'
#include <petscksp.h>
#include <stdio.h>

/* the same value on the whole diagonal */
static void fill(Mat matrix, double value)
{
   for (PetscInt i = 0; i < 3; i++) MatSetValue(matrix, i, i, value, INSERT_VALUES);
   MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY);
   MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY);
}

static void factorise(PC pc, Mat matrix, double value)
{
   Mat factors;
   Vec b, x;
   PetscInt infog;
   PCFailedReason reason;
   PetscErrorCode set_up, apply;

   fill(matrix, value);
   set_up = PCSetUp(pc);
   PCGetFailedReason(pc, &reason);
   PCFactorGetMatrix(pc, &factors);
   MatMumpsGetInfog(factors, 1, &infog);
   MatCreateVecs(matrix, &x, &b);
   VecSet(b, 1.0);
   apply = PCApply(pc, b, x);
   printf("%g: PCSetUp %d, reason %d, INFOG(1) %d, PCApply %d\n", value, (int)set_up, (int)reason,
          (int)infog, (int)apply);
   VecDestroy(&b);
   VecDestroy(&x);
}

int main(void)
{
   Mat matrix;
   PC pc;

   PetscInitializeNoArguments();
   PetscPushErrorHandler(PetscReturnErrorHandler, NULL);
   MatCreateSeqAIJ(PETSC_COMM_SELF, 3, 3, 1, NULL, &matrix);
   fill(matrix, 1.0);
   PCCreate(PETSC_COMM_SELF, &pc);
   PCSetOperators(pc, matrix, matrix);
   PCSetType(pc, PCLU);
   PCFactorSetMatSolverType(pc, MATSOLVERMUMPS);
   factorise(pc, matrix, 2.0);
   factorise(pc, matrix, 4.0);
   factorise(pc, matrix, 0.0);
   factorise(pc, matrix, 2.0);
   PCReset(pc);
   PCSetOperators(pc, matrix, matrix);
   factorise(pc, matrix, 2.0);
   PCDestroy(&pc);
   MatDestroy(&matrix);
   return PetscFinalize();
}
C
read -ra libraries < <(pkg-config --cflags --libs PETSc)
mpicc refused.c -o refused "${libraries[@]}"
expect '2: PCSetUp 0, reason 0, INFOG(1) 0, PCApply 0
4: PCSetUp 0, reason 0, INFOG(1) 0, PCApply 0
0: PCSetUp 0, reason 2, INFOG(1) -10, PCApply 0
2: PCSetUp 0, reason 0, INFOG(1) -10, PCApply 76
2: PCSetUp 0, reason 0, INFOG(1) 0, PCApply 0' "$(OMPI_MCA_ess_singleton_isolated=1 ./refused)"
