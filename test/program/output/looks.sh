# What a reader sees: lines that fit, numbers without noise, pictures that say what they show

# Lines of 80 characters where nobody says how many there are, else as many as COLUMNS says
longest() { awk '{ if (length($0) > n) n = length($0) } END { print n + 0 }' "$1"; }
narrow() { # COLUMNS ARGUMENT...
   COLUMNS=$1 run "${@:2}"
   status_and_longest="$status $(longest out)"
}
awk 'function p(x, y) { printf "%.4f,%.4f\n", x, y }
   BEGIN { print "displacement (mm),force (kN)"
      for (i = 0; i <= 3; i++) p(0.1*i, 0.07*i)
      for (i = 2; i >= -3; i--) p(0.1*i, 0.07*i)
      for (i = -2; i <= 0; i++) p(0.1*i, 0.07*i)
      for (i = 1; i <= 9; i++) p(0.3*i, 0.21 + 0.001*i)
      for (i = 8; i >= -9; i--) p(0.3*i, -0.21 + 0.001*i)
      for (i = -8; i <= 0; i++) p(0.3*i, 0.21 + 0.001*i) }' >two_cycles.csv
while read -r arguments; do
   # shellcheck disable=SC2086  # several words are meant
   narrow '' $arguments
   check "80 columns: $arguments" test "${status_and_longest% *}" -eq 0 -a "${status_and_longest#* }" -le 80
   # shellcheck disable=SC2086
   narrow 60 $arguments
   check "60 columns: $arguments" test "${status_and_longest#* }" -le 60
   check "no minus before zero: $arguments" lacks out '(^| )-0\.0*(E[+-]0+)?( |$)'
done <<'END'
curve
press
shear --displacement 0.5,-0.5
tenon --amplitudes 1,8 --face-points 20 --side-points 3
table
pairs
hysteresis two_cycles.csv
surface --generate --map-points 64 --step 0.02 --sq 0.04 --correlation-length 0.1 --verify
deck shear --mesh-size 6 --inp x.inp
END
rm x.inp
check 'a wide terminal: one block a table' test "$(COLUMNS=200 "$program" pairs | grep -c ' kind ')" -eq 1
check 'a narrow one: leading columns lead every block' \
   test "$(COLUMNS=80 "$program" pairs | grep -c '^  kind     name')" -eq 2
words() { tr -s ' ' '\n' <"$1" | sort -u; }
run curve
words out >wide
narrow 60 curve
words out >thin
check 'a narrow one: nothing is lost' cmp wide thin
run hysteresis two_cycles.csv
check 'an energy at round-off does not make a column scientific' \
   sh -c 'grep -q "  0.0000      0.0000 " out && ! grep -q "E[+-]" out'

command -v gnuplot >/dev/null || { skip 'looks of pictures' 'no gnuplot'; return; }
small=(--amplitudes 0.5,1,1.5,2,3,4,5,6 --face-points 20 --side-points 3)
for name in 'a b' again; do
   SOURCE_DATE_EPOCH=0 run tenon "${small[@]}" --clearance 0.1234567891 --report "$name.html"
done
check 'report: by which command' has 'a b.html' "tenon ${small[*]} --clearance 0.1234567891 --report 'a b.html'"
check 'report: when and by which version' has 'a b.html' \
   "Made on 1970-01-01 00:00:00 UTC by asperity $("$program" --version | sed -n 's/^asperity //p')"
check 'report: lists and numbers in full' sh -c \
   'grep -q "0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0 mm" "a b.html" && grep -q "0.1234567891 mm" "a b.html"'
check 'report: the same again, but for its name' cmp <(sed "s/'a b.html'/again.html/" 'a b.html') again.html
check 'report: now, where no other time is asked for' sh -c \
   '"$1" tenon --amplitudes 1 --face-points 20 --side-points 3 --report now.html >/dev/null \
      && grep -q "Made on $(date -u +%Y-%m-%d)" now.html' sh "$program"
check 'report: tables scroll in themselves' test "$(grep -c '<table' now.html)" -eq "$(grep -c '<div class="table"><table' now.html)"
run tenon "${small[@]}" --plot sheet.svg
for words in 'yield points' 'lower | upper face' 'hard contact, load point at -6.0 mm'; do
   check "picture of the joint says: $words" has sheet.svg "$words"
done
for command in curve press shear table tenon; do
   [ $command = tenon ] || run $command --plot sheet.svg
   check "picture of $command: labels of ticks are centred" lacks sheet.svg '<text> '
done
run curve --plot sheet.svg
check 'picture of curve: area over nominal area ends at 1' sh -c \
   'grep -q "<text>0.8</text>" sheet.svg && ! grep -q "<text>1.2</text>" sheet.svg'
