#!/usr/bin/env bash
# Errors in docs/equations.md and the measurements of the tests, a folder of files of
# lines `key value`.
# usage: test/equations.sh update|check MEASUREMENTS
#   update  write the largest value of each key before its mark <!-- key -->
#   check   fail when a key is missing or its value has grown more than tenfold
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
document=docs/equations.md

values() {
   awk '{ v = $2 ~ /^[-+0-9.eE]+$/ ? $2 + 0 : 1e300; if (!($1 in most) || v > most[$1]) most[$1] = v }
      END { for (key in most) printf "%s %.1e\n", key, most[key] }' "$1"/*
}

case ${1:-} in
update)
   values "$2" >"$2.most"
   awk 'NR == FNR { most[$1] = $2; next }
      { line = $0; out = ""
        while (match(line, /[0-9.e+-]+ <!-- [a-z_0-9.]+ -->/)) {
           found = substr(line, RSTART, RLENGTH)
           key = found; sub(/^.*<!-- /, "", key); sub(/ -->$/, "", key)
           if (key in most) found = most[key] " <!-- " key " -->"
           out = out substr(line, 1, RSTART - 1) found
           line = substr(line, RSTART + RLENGTH)
        }
        print out line }' "$2.most" "$document" >"$document.part"
   mv "$document.part" "$document"
   ;;
check)
   values "$2" >"$2.most"
   grep -o -E '[0-9.e+-]+ <!-- [a-z_0-9.]+ -->' "$document" | awk -v file="$2.most" '
      BEGIN { while ((getline line < file) > 0) { split(line, f, " "); most[f[1]] = f[2] } }
      { n++
        if (!($3 in most)) { print "FAIL " $3 " was not measured"; bad++ }
        else if (most[$3] > 10 * $1 + 1e-15) {
           print "FAIL " $3 ": documented " $1 ", measured " most[$3]; bad++ } }
      END { if (n == 0) bad++; printf "%d passed, %d failed\n", n - bad, bad; exit bad > 0 }'
   ;;
*)
   sed -n '2,6s/^# //p' "${BASH_SOURCE[0]}" >&2
   exit 2
   ;;
esac
