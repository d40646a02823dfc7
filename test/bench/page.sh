#!/usr/bin/env bash
# Put the table of a benchmark run between its two marks in a document.
# usage: test/bench/page.sh TABLE.md DOCUMENT.md
set -euo pipefail
table=$1 document=$2
awk '/^<!-- bench: begin -->$/ { begin++ } /^<!-- bench: end -->$/ && begin == 1 { end++ }
   END { exit !(begin == 1 && end == 1) }' "$document" || {
   echo "page.sh: error: $document has not one line '<!-- bench: begin -->' and, after it, one" \
      "'<!-- bench: end -->'" >&2
   exit 1
}
[[ -s $table ]] || { echo "page.sh: error: $table is empty" >&2; exit 1; }
awk 'NR == FNR { text = text $0 "\n"; next }
   /^<!-- bench: end -->$/ { inside = 0 }
   !inside { print }
   /^<!-- bench: begin -->$/ { inside = 1; printf "\n%s\n", text }' "$table" "$document" \
   >"$document.part"
mv "$document.part" "$document"
