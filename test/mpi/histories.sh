# Any number of ranks comes to the same joint, within what the tolerance leaves
coarse=$(cd "$here/../.." && pwd)/examples/solid_joint/coarse.nml

# To ten times the tolerance of an increment: both models, three cycles
run solid "$coarse" --csv 1.csv
check 'histories: one rank' is_quiet
for n in 2 4; do
   ranks $n solid "$coarse" --csv $n.csv
   check "histories: $n ranks" is_quiet
   check "histories: of the same joint" same_history 1.csv $n.csv 1e-2
done

# Where nothing is left to iterate: one cycle, every force and energy to a hundred millionth
tight=(--mesh-size 60 --amplitudes 8 --tolerance 1e-11 --forcing 1e-12)
for more in '--contact both' '--contact rough --unloading elastic' '--contact rough --through uinter'; do
   # shellcheck disable=SC2086  # several words are meant
   run solid "${tight[@]}" $more --csv 1.csv
   for n in 2 4; do
      # shellcheck disable=SC2086
      ranks $n solid "${tight[@]}" $more --csv $n.csv
      check "histories: $more, $n ranks" is_quiet
      check 'histories: the same to 1e-8' same_history 1.csv $n.csv 1e-8
   done
done

# So does a frame; forces of its joints are a tenth of those that the tolerance is a share of
frame=(frame "$(dirname "$coarse")/../frame/two_columns.nml" --contact rough --amplitudes 50 --mesh-size 100
   --stroke-increments 3 --tolerance 1e-7)
run "${frame[@]}" --csv 1.csv
ranks 2 "${frame[@]}" --csv 2.csv
check 'histories: a frame on two ranks' is_quiet
check 'histories: of the same joints' same_history 1.csv 2.csv 1e-5
