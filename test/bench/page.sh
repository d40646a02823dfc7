#!/usr/bin/env bash
# Put the table of a benchmark run between its two marks in a document.
# usage: test/bench/page.sh TABLE.md DOCUMENT.md NAME; the marks are <!-- NAME: begin --> and end
set -euo pipefail
table=$1 document=$2 begin="<!-- $3: begin -->" end="<!-- $3: end -->"
awk -v begin="$begin" -v end="$end" '$0 == begin { begins++ } $0 == end && begins == 1 { ends++ }
   END { exit !(begins == 1 && ends == 1) }' "$document" || {
   echo "page.sh: error: $document has not one line '$begin' and, after it, one '$end'" >&2
   exit 1
}
[[ -s $table ]] || { echo "page.sh: error: $table is empty" >&2; exit 1; }
awk -v begin="$begin" -v end="$end" 'NR == FNR { text = text $0 "\n"; next }
   $0 == end { inside = 0 }
   !inside { print }
   $0 == begin { inside = 1; printf "\n%s\n", text }' "$table" "$document" \
   >"$document.part"
mv "$document.part" "$document"
