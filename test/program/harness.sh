# What the tests share. They run in an empty folder that is removed at the end.
passed=0
failed=0
skipped=0

# lines as wide as any table and remark; output.sh looks at narrow ones
export COLUMNS=1000

# limited COMMAND...: a command that hangs is stopped, with status 124
timeout=$(command -v timeout)
limited() { "$timeout" -k 10 600 "$@"; }

# own_words FILE: what the program itself said, without what gfortran's checks (-fcheck=all) remark about
# copies of arrays
own_words() { sed '/^At line .* of file /{N;/Fortran runtime warning: An array temporary/d;}' "$1"; }

# run ARGUMENT...: run the program; leaves files out and err, and status. With `address_space`, in so
# many KiB
run() {
   (if [ -n "${address_space:-}" ]; then ulimit -v "$address_space"; fi; limited "$program" "$@") >out 2>all_err </dev/null
   status=$?
   own_words all_err >err
}

# check NAME COMMAND...: one test, passed if the command succeeds
check() {
   local name=$1
   shift
   if "$@" >check.log 2>&1; then
      passed=$((passed + 1))
      echo "ok   $name"
   else
      failed=$((failed + 1))
      echo "FAIL $name"
      printf '     | %s\n' "status $status of the last run" "check: $*"
      head -n 5 check.log | sed 's/^/     | /'
      head -n 3 err | sed 's/^/     | stderr: /'
   fi
}

skip() {
   skipped=$((skipped + 1))
   echo "skip $1: $2"
}

# The last run succeeded without a word on standard error
is_quiet() { [ "$status" -eq 0 ] && [ ! -s err ]; }

# The last run failed with a status and one line on standard error that matches a pattern, wrote
# nothing else and left no temporary file
is_refused() {
   [ "$status" -eq "$1" ] && [ ! -s out ] && [ "$(wc -l <err)" -eq 1 ] \
      && grep -Eq "^asperity: error: $2" err && ! ls ./*.part 2>/dev/null
}

# refuses NAME STATUS PATTERN ARGUMENT...: one test of bad input
refuses() {
   local name=$1 expected=$2 pattern=$3
   shift 3
   run "$@"
   check "$name" is_refused "$expected" "$pattern"
}

# rows FILE: lines of a CSV file without its header
rows() { echo $(($(wc -l <"$1") - 1)); }

# columns FILE: the names of the columns of a CSV file, without the units in brackets after them
columns() { head -n 1 "$1" | sed 's/ ([^)]*)//g'; }

# csv FILE PROGRAM: an awk program over the rows of a CSV file, whose columns are c["name"] of
# the row and before["name"] of the row before; `fail(text)` fails; far(a, b, tolerance) is true
# when a and b differ by more than tolerance times the larger
csv() {
   local file=$1 program_text=$2
   shift 2
   awk -F, "$@" '
      function abs(x) { return x < 0 ? -x : x }
      function max(a, b) { return a > b ? a : b }
      function far(a, b, t) { return !(abs(a - b) <= t*max(abs(a), abs(b))) }
      function fail(text) { print "row " NR - 1 ": " text; failures++; if (failures > 3) exit }
      NR == 1 { gsub(/ \([^)]*\)/, ""); for (i = 1; i <= NF; i++) name[i] = $i; next }
      { for (i = 1; i <= NF; i++) { before[name[i]] = c[name[i]]; c[name[i]] = $i }
        '"$program_text"' }
      END { if (NR < 2) { print "no rows"; failures++ }; exit failures > 0 }' "$file"
}

# numbers_are_proper FILE: every number of a CSV file has 17 figures and an E exponent
numbers_are_proper() {
   awk -F, 'NR > 1 { for (i = 1; i <= NF; i++)
      if ($i !~ /^-?[0-9]\.[0-9][0-9][0-9][0-9][0-9][0-9][0-9][0-9][0-9][0-9][0-9][0-9][0-9][0-9][0-9][0-9]E[+-][0-9][0-9][0-9]$/ \
         && $i !~ /^[a-z_+]+$/) { print "row " NR - 1 ": " $i; bad = 1 } }
      END { exit bad }' "$1"
}

# json_column FILE NAME: values of a column of the data of a JSON file, one per line, none for null
json_column() {
   awk -v name="\"$2\": [" '/^"data"/ { data = 1 }
      data && index($0, name) == 1 { sub(/^[^[]*\[/, ""); sub(/\],?$/, ""); print }' "$1" \
      | tr ',' '\n' | tr -d ' "' | sed 's/^null$//'
}

# csv_column FILE NAME
csv_column() { csv "$1" 'print c["'"$2"'"]'; }

# csv_unit FILE NAME: the unit of a column of a CSV file, empty if it has none
csv_unit() { head -n 1 "$1" | tr ',' '\n' | sed -n "s/^$2 (\(.*\))\$/\1/p"; }

# json_unit FILE NAME: the same of a JSON file, which has - for none
json_unit() { sed -n 's/^"units": {\(.*\)},$/\1/p' "$1" | grep -o "\"$2\": \"[^\"]*\"" | cut -d '"' -f 4 | grep -vx -e -; }

# same_csv_and_json CSV JSON: every column has the same texts and the same unit
same_csv_and_json() {
   local name
   for name in $(columns "$1" | tr ',' ' '); do
      [ "$(csv_unit "$1" "$name")" = "$(json_unit "$2" "$name")" ] || { echo "unit of $name"; return 1; }
      csv_column "$1" "$name" >column.csv || return
      json_column "$2" "$name" >column.json
      cmp column.csv column.json || return
   done
}

# value FILE NAME: one parameter of a CSV file of asperity surface, in full
value() { awk -F, -v name="$2" '$1 == name { print $3 }' "$1"; }
# of_json FILE TABLE COLUMN: a column of one of the tables of a JSON file, one value a line
of_json() {
   sed -n "/^\"$2\": {/,/^}/p" "$1" | sed -n "s/^\"$3\": \[\(.*\)\].*/\1/p" | tr ',' '\n' \
      | tr -d ' "'
}
# near A B TOLERANCE: within a share of the larger
near() { awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { d = a - b; m = a*a > b*b ? a : b
   print a, b; exit !(a != "" && b != "" && d*d <= t*t*m*m) }'; }

# map_with_holes: a map of 50 by 40 points, of which 40 were not measured
map_with_holes() {
   printf '# height unit: um\n# step: 10 um\n'
   awk 'BEGIN { srand(3); for (j = 0; j < 40; j++) { for (i = 0; i < 50; i++)
      printf "%s%s", i ? ";" : "", i + j == 40 ? "NaN" : i + 2*j + rand(); print "" } }'
}

has() { grep -Fq -- "$2" "$1"; }
lacks() { ! grep -Eq -- "$2" "$1"; }
absent() { [ ! -e "$1" ]; }

# has_nearly CASE NAME VALUE TOLERANCE: a case file has a value, but for a share of it
has_nearly() {
   awk -v name="$2" -v value="$3" -v tolerance="$4" '$1 == name { found = 1; d = $3/value - 1
      if (d < -tolerance || d > tolerance) { print name " " $3; exit 1 } } END { if (!found) exit 1 }' "$1"
}
