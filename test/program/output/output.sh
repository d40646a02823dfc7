# Files are complete or not there; standard output may be full or closed

run curve --csv a.csv --json a.json
check 'the table is printed beside files' has out 'separation'
check 'no temporary file stays' sh -c '! ls *.part 2>/dev/null'
cp a.csv csv
cp a.json json
run curve --csv -
check '--csv - is the file' cmp out csv
run curve --json -
check '--json - is the file' cmp out json
run curve --csv /dev/stdout --json -
check '--csv /dev/stdout beside --json -' test "$status" -eq 0
if command -v python3 >/dev/null; then
   run press --json p.json
   run shear --json - --displacement 0.1 --sigma 0.06
   check 'JSON is JSON' python3 -c '
import json, sys
def refuse(text): raise ValueError(text)
for name in sys.argv[1:]:
    data = json.load(open(name), parse_constant=refuse)
    assert data["asperity"] and len({len(c) for c in data["data"].values()}) == 1
    assert data["sources"].keys() == data["properties"].keys() | data["settings"].keys()' out json p.json
   check 'JSON: where values come from' python3 -c '
import json
sources = json.load(open("out"))["sources"]
assert [sources[key] for key in ("pair", "eta", "sigma", "displacement", "diameter")] == [
    "default", "pair transverse-tangential", "--sigma", "--displacement", "default"]'
else
   skip 'JSON is JSON' 'no python3'
   skip 'JSON: where values come from' 'no python3'
fi
check 'no NaN, no infinity, no D exponent' lacks json '[Nn]a[Nn]|[Ii]nf|[0-9][Dd][+-]'

refuses 'folder does not exist' 3 '--csv: no/x.csv cannot be written: the folder does not' \
   curve --csv no/x.csv
refuses 'a folder as output' 3 '--json: \. cannot be written: it is a folder' curve --json .
refuses 'disk full: file' 3 '--csv: /dev/full cannot be written: No space left' \
   curve --csv /dev/full
: >out
limited "$program" curve >/dev/full 2>err
status=$?
check 'disk full: standard output' is_refused 3 'standard output cannot be written: No space left'
limited "$program" help >/dev/full 2>err
status=$?
check 'disk full: help' is_refused 3 'standard output cannot be written: No space left'
limited "$program" curve --print-case >/dev/full 2>err
status=$?
check 'disk full: print-case' is_refused 3 'standard output cannot be written: No space left'
refuses 'two outputs on standard output' 2 '--json: standard output already takes --csv' \
   curve --csv - --json -
refuses 'two outputs in one file' 2 '--json: \./x is already written by --csv' \
   curve --csv x --json ./x
check 'one file for two outputs: not written' absent x
refuses 'empty file name' 2 '--csv: csv is empty' curve --csv ''
printf '&asperity sigma = 0.05 /\n' >case.nml
refuses 'the case file as output' 2 '--csv: case.nml is the case file' curve case.nml --csv case.nml
check 'the case file is still there' has case.nml 'sigma = 0.05'

# A failure of one output leaves none, and keeps what was there
mkdir taken.json
echo before >keep.csv
refuses 'one of two outputs fails' 3 '--json: taken.json cannot be written' \
   curve --csv keep.csv --json taken.json
check 'the other keeps what it was' test "$(cat keep.csv)" = before
run curve --sigma -1 --csv keep.csv
check 'bad input keeps an older file' test "$(cat keep.csv)" = before
run curve --csv /dev/null
check '/dev/null stays a device' test -c /dev/null
run curve --csv "a name with ' and blanks.csv"
check 'any file name' cmp "a name with ' and blanks.csv" csv
limited "$program" curve --separation 0.1:0.2:100000 --csv - 2>err | head -n 1 >out
statuses=("${PIPESTATUS[@]}")
check 'closed pipe: quiet' test ! -s err
check 'closed pipe: ended by the pipe, or in time' \
   sh -c '[ "$1" -eq 141 ] || [ "$1" -eq 0 ]' sh "${statuses[0]}"
limited "$program" curve --csv closed.csv 2>err | true
check 'closed pipe: files are complete' cmp closed.csv csv

# An interrupt during the run leaves nothing; in a second 100 000 increments are not done
timeout -k 60 -s INT 1 "$program" press --increments 1000000 --csv int.csv --json int.json >out 2>err
status=$?
check 'interrupt: ends the program' test "$status" -eq 124
check 'interrupt: no file' sh -c '! ls int.csv* int.json* 2>/dev/null'
run curve --csv a.csv
check 'no progress where there is no terminal' test ! -s err
rm -rf taken.json

# Little memory: the results, or one line that says what to do, whatever the limit is
if (ulimit -v 65536 && "$program" version >/dev/null 2>&1); then
   seq 1 5000 | awk 'BEGIN { print "displacement (mm)" } { printf "%.6g\n", sin($1/50) }' >history.csv
   given=0 refused=0 wrong=
   while read -r first step last command; do
      for limit in $(seq "$first" "$step" "$last"); do
         # shellcheck disable=SC2086  # several words are meant
         address_space=$limit run $command large.out
         if is_quiet && [ -s large.out ]; then
            given=$((given + 1))
         elif is_refused 1 '.*not enough memory, .* MiB more .*: make it smaller, or' && absent large.out; then
            refused=$((refused + 1))
         else
            wrong="$wrong [$limit: $command: $status: $(head -n 1 err)]"
         fi
         rm -f large.out
      done
   done <<'END'
65536 20480 147456 curve --separation 0:0.2:50000 --csv
65536 24576 163840 press --increments 30000 --json
65536 24576 114688 shear --normal-stress 0.05:0.2:100 --csv
65536 24576 98304 tenon --history history.csv --csv
65536 16384 81920 deck shear --mesh-size 2 --inp
END
   check "little memory, $given results, $refused refusals:$wrong" \
      test "$given" -gt 4 -a "$refused" -gt 4 -a -z "$wrong"
   rm history.csv
else
   skip 'little memory' 'the program itself needs more than 64 MiB'
fi
