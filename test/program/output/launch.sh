# Ranks as launchers say them, before MPI starts; with MPI they are tested in test/mpi
unset OMPI_COMM_WORLD_RANK OMPI_COMM_WORLD_SIZE PMI_RANK PMI_SIZE PMIX_RANK SLURM_PROCID SLURM_STEP_NUM_TASKS
curve=(curve --separation 0.1:0.2:3)
run "${curve[@]}"
check 'launch: none' is_quiet
cp out alone

# launched VARIABLE=VALUE... -- ARGUMENT...: run under a launcher that says this
launched() {
   local words=()
   while [ "$1" != -- ]; do words+=("$1"); shift; done
   shift
   (export "${words[@]}"; limited "$program" "$@") >out 2>err </dev/null
   status=$?
}
is_idle() { [ "$status" -eq 0 ] && [ ! -s out ] && [ ! -s err ] && absent c.csv; }
is_alone() { is_quiet && cmp out alone; }
# What the first of four says
is_first() {
   [ "$status" -eq 0 ] && cmp out alone \
      && [ "$(cat err)" = "asperity: warning: asperity curve runs on one rank, not on 4" ]
}
while read -r launcher rank size; do
   launched "$rank=0" "$size=4" -- "${curve[@]}"
   check "launch: $launcher, first rank" is_first
   launched "$rank=3" "$size=4" -- "${curve[@]}" --csv c.csv
   check "launch: $launcher, last rank" is_idle
   launched "$rank=0" "$size=1" -- "${curve[@]}"
   check "launch: $launcher, one rank" is_alone
   for pair in 4/4 -1/4 x/4 0/ 99999999999999999999/4; do
      launched "$rank=${pair%/*}" "$size=${pair#*/}" -- "${curve[@]}"
      check "launch: $launcher, rank and number $pair are none" is_alone
   done
done <<'LAUNCHERS'
openmpi OMPI_COMM_WORLD_RANK OMPI_COMM_WORLD_SIZE
pmi PMI_RANK PMI_SIZE
slurm SLURM_PROCID SLURM_STEP_NUM_TASKS
LAUNCHERS
launched PMIX_RANK=0 -- "${curve[@]}"
check 'launch: pmix, first rank' is_alone
launched PMIX_RANK=1 -- "${curve[@]}" --csv c.csv
check 'launch: pmix, another one' is_idle
launched SLURM_PROCID=0 SLURM_NTASKS=4 SLURM_NPROCS=4 -- "${curve[@]}"
check 'launch: the script of a batch job is no rank' is_alone
launched OMPI_COMM_WORLD_RANK=0 OMPI_COMM_WORLD_SIZE=4 SLURM_PROCID=1 SLURM_STEP_NUM_TASKS=2 -- "${curve[@]}"
check 'launch: mpirun in a step of slurm' is_first

second=(OMPI_COMM_WORLD_RANK=1 OMPI_COMM_WORLD_SIZE=2)
for words in help 'help curve' version --citation 'curve --print-case' 'solid --print-case' 'pairs'; do
   # shellcheck disable=SC2086  # several words are meant
   launched "${second[@]}" -- $words
   check "launch: $words, told by another rank" is_idle
done

# What only one rank has to tell
began=$SECONDS
launched "${second[@]}" -- solid nowhere.nml --csv c.csv
check 'launch: an error of one rank' is_refused 3 'rank 1: nowhere.nml: cannot be read: '
check 'launch: after it has waited for rank 0' test $((SECONDS - began)) -ge 1
launched "${second[@]}" -- curve --sigma x
check 'launch: an option of one rank' is_refused 2 'rank 1: --sigma: '
launched OMPI_COMM_WORLD_RANK=0 OMPI_COMM_WORLD_SIZE=2 -- solid nowhere.nml
check 'launch: the same of rank 0' is_refused 3 'nowhere.nml: cannot be read: '
launched OMPI_COMM_WORLD_RANK=0 OMPI_COMM_WORLD_SIZE=2 -- solid -
check 'launch: a case from standard input' is_refused 2 'a case from standard input reaches rank 0 alone: '
launched PMIX_RANK=0 -- solid -
check 'launch: nor where their number is unknown' is_refused 2 'a case from standard input reaches rank 0 alone: '
check 'launch: nothing is written' absent c.csv
