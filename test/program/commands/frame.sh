# asperity frame: two joints on a mesh of large elements. Balances and meshes: test/petsc, test/solid
frame=(--mesh-size 100 --tail 150 --column-height 2000 --column-places 0,1500 --column-loads 40000
   --amplitudes 20 --stroke-increments 3 --contact rough)
run frame "${frame[@]}" --csv f.csv --json f.json
if grep -q 'PETSc is not installed' err; then
   skip 'frame' 'PETSc is not installed'
   return
fi
check 'frame' is_quiet
check 'frame: JSON holds the same figures' same_csv_and_json f.csv f.json
check 'frame: what is to be known beside its figures' has out 'are not accounted for; larger stroke_increments'
check 'frame: numbers in full' sh -c '! grep -E "[Nn]a[Nn]|[Ii]nf" f.csv f.json'
check 'frame: nothing stays but what was asked for' sh -c '! ls frame.*checkpoint 2>/dev/null'
refuses 'frame: a beam without a column' 2 '--beam-to: beam 1 goes from column 1 to 3' frame --beam-to 3
refuses 'frame: columns too near' 2 '--column-places: column_places = 0.0, 250.0 mm are nearer than the columns are deep' frame --column-places 0,250
refuses 'frame: a load without a column' 2 '--column-loads: column_loads has 3 values for 2 columns' frame --column-loads 1e4,1e4,1e4
refuses 'frame: one column' 2 '--column-places: column_places has 1 values: a frame has two columns at least' frame --column-places 0
refuses 'frame: no height' 2 '--column-height: column_height = 0.0' frame --column-height 0
run frame "${frame[@]}" --print-case
check 'frame: --print-case runs nothing' is_quiet
