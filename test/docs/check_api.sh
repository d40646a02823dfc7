#!/usr/bin/env bash
# Make the pages of the public names by FORD. Fails at a warning, as for a link to nothing or a file that FORD
# cannot read, and at a public name of `asperity` that has no page or, if a constant, no place on a module's page.
# FORD lists no enumerators.
# usage: test/docs/check_api.sh FORD
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
ford=$1
log=build/api.log
mkdir -p build
"$ford" docs/api.md >"$log" 2>&1 || { cat "$log"; exit 1; }
good=0 bad=0
if grep -A 2 Warning "$log"; then bad=1; fi
names=$(sed -n '/public ::/,/[^&]$/p' src/asperity*.f90 | tr -d '&\n' | sed 's/.*:://; s/,/ /g')
enumerators=" $(grep -rhE '^ *enumerator ::' src interface | tr -c 'a-z_0-9' ' ') "
for name in $names; do
   if [[ $enumerators == *" $name "* ]]; then continue; fi
   if compgen -G "build/api/*/$name.html" >/dev/null \
      || grep -qE "id=\"variable-$name(~[0-9]+)?\"" build/api/module/*.html; then
      ((good += 1))
   else
      echo "FAIL $name has no page"
      ((bad += 1))
   fi
done
echo "$good passed, $bad failed"
((bad == 0))
