#!/usr/bin/env bash
# Open MPI 4.1.4 (Debian's openmpi-bin 4.1.4): two jobs at the same time share a core, while others are idle.
#
# A good guess: two one-rank jobs, started beside each other on a machine of several cores, each get a core.
# Seen: mpirun binds ranks to cores from the first one on and knows nothing of other jobs, so both are bound to
# the same one core and each runs at half the speed. OMPI_MCA_hwloc_base_binding_policy=none (or --bind-to none)
# leaves all cores to both.
source "$(dirname "$0")/lib/setup.sh"
version_is 4.1.4 mpirun --version
(($(nproc) >= 2)) || { echo 'this needs two cores'; exit 1; }
((EUID != 0)) || export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
# the cores that a rank may use, of two jobs that are there at the same time
cat >cores.sh <<'SH'
touch "here.$1"
while [[ ! -e here.1 || ! -e here.2 ]]; do sleep 0.1; done
sed -n 's/^Cpus_allowed_list:\t//p' "/proc/$$/status"
SH
two_jobs() {
   rm -f here.*
   mpirun -n 1 bash cores.sh 1 >first &
   mpirun -n 1 bash cores.sh 2 >second
   wait
   local count
   count=$(sort -u first second | wc -l)
   if [[ $count == 1 && $(cat first) =~ ^[0-9]+$ ]]; then
      echo 'the same core'
   elif [[ $count == 1 ]]; then
      echo 'all cores'
   else
      echo 'different cores'
   fi
}
expect 'bound: the same core, binding policy none: all cores' \
   "bound: $(two_jobs), binding policy none: $(OMPI_MCA_hwloc_base_binding_policy=none two_jobs)"
