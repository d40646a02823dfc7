#!/usr/bin/env bash
# The sensitivity table of docs/tenon_joint.md: one value of the base case changed at a time.
# usage: examples/tenon_joint/sensitivity.sh [PROGRAM]     prints Markdown
set -euo pipefail
program=${1:-asperity}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

echo '| changed | Mu hard, kN m | Mu rough, kN m | Mu rough:hard | energy hard, J | energy rough, J | energy rough:hard |'
echo '|---|---|---|---|---|---|---|'
for sweep in gap=mean_plane,first_touch friction_coefficient=0.1,0.3,0.4,0.6 \
   critical_slip=0.1,1 clearance=0,0.25,1 bearing_depth=75,300 hardening_across=0,0.1 \
   sigma=0.0297,0.1779,0.593 side_pressure=0,0.2,1 axial_stiffness=100,5000 length=250,450; do
   # ten times the roughness is no face that is known
   "$program" tenon "$here/base.nml" --accept-unphysical --sweep "$sweep" --csv "$folder/table.csv" >"$folder/log" \
      || { cat "$folder/log" >&2; exit 1; }
   awk -F, 'NR == 1 { gsub(/ \([^)]*\)/, ""); for (i = 1; i <= NF; i++) column[$i] = i; name = $2; next }
      { value = $2 ~ /^[-+0-9.E]+$/ ? sprintf("%.4g", $2) : $2
        if ($column["outcome"] != "done") {
           printf "| %s = %s | %s |||||| \n", name, value, $column["outcome"]; next }
        printf "| %s = %s | %.2f | %.2f | %.3f | %.0f | %.0f | %.3f |\n", name, value,
           -$column["ultimate_moment_hard"], -$column["ultimate_moment_rough"],
           $column["ultimate_moment_ratio"], $column["loop_energy_hard"],
           $column["loop_energy_rough"], $column["loop_energy_ratio"] }' "$folder/table.csv"
   rm -f "$folder/table.csv"
done
