#!/usr/bin/env bash
# The table of docs/old_wood.md: the joint of new wood, then one property older at a time, all, and the example.
# usage: examples/old_joint/sweep.sh [PROGRAM]     prints Markdown
set -euo pipefail
program=${1:-asperity}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
base=$here/../tenon_joint/base.nml
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# rows NAME CASE OPTION...: one row a combination, named by the keys that are swept
rows() {
   local name=$1
   shift
   "$program" tenon "$@" --csv "$folder/table.csv" >"$folder/log" || { cat "$folder/log" >&2; exit 1; }
   awk -F, -v name="$name" 'NR == 1 { gsub(/ \([^)]*\)/, ""); for (i = 1; i <= NF; i++) column[$i] = i
        key = $2; next }
      { printf "| %s | %.2f | %.2f | %.3f | %.2f | %.0f | %.0f |\n",
           name != "" ? name : sprintf("`%s` = %.3g", key, $2), -$column["ultimate_moment_hard"],
           -$column["ultimate_moment_rough"], $column["ultimate_moment_ratio"],
           -$column["yield_moment_rough"], $column["loop_energy_hard"],
           $column["loop_energy_rough"] }' "$folder/table.csv"
   rm -f "$folder/table.csv"
}

echo '| old over new | Mu hard, kN m | Mu rough, kN m | Mu rough:hard | My rough, kN m | energy hard, J | energy rough, J |'
echo '|---|---|---|---|---|---|---|'
rows 'new wood' "$base" --sweep ageing_hardness=1
for key in strength_compression_across strength_compression_along stiffness_across stiffness_along \
   hardness friction; do
   rows '' "$base" --sweep "ageing_$key=0.5,0.73"
done
rows 'old_joint.nml' "$here/old_joint.nml" --sweep ageing_hardness=1
