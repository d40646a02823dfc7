# asperity surface: layouts of files, what is said of them, and little memory

scans=$root/test/data/scans
# reads_scan FILE SQ POINTS_X POINTS_Y STEP_X STEP_Y MISSING OPTIONS...: the map as it should be; sq in
# mm to six figures, about the plane that the scans' README names
reads_scan() {
   scan=$1 expected="$3 $4 $5 $6 $7" right=$2
   shift 7
   run surface "$scans/$scan" "$@" --csv scan.csv --json scan.json
   check "surface files: $scan is read" test "$status" -eq 0
   check "surface files: $scan, points, steps, missing" test "$(for column in points_x \
      points_y step_x step_y missing; do of_json scan.json map $column; done \
      | awk '{ printf "%s%.6g", (NR > 1 ? " " : ""), $1 }')" = "$expected"
   check "surface files: $scan, sq" near "$(value scan.csv sq)" "$right" 4e-6
}
both='--lateral-unit um --height-unit um'
um='--height-unit um'
# shellcheck disable=SC2086  # several words are meant
{
reads_scan pandas_index.csv 0.00169677 24 18 0.0025 0.002 0 $um --step 0.0025,0.002
check 'surface files: numbers of columns are said' has out 'the first line counts the columns'
check 'surface files: and in JSON' has scan.json 'pandas_index.csv: the first column counts the rows'
reads_scan axes_in_matrix.csv 0.00169677 24 18 0.0025 0.002 0 $um --step 0.0025,0.002
reads_scan axes_in_matrix.csv 0.00169677 24 18 0.0025 0.002 0 $both
check 'surface files: axes are said' has out 'the first column is the axis of y, from 0.0'
reads_scan holography_factor.txt 0.00169677 24 18 0.0025 0.0025 0
reads_scan holography_factor.txt 0.00169677 24 18 0.0025 0.0025 0 $um --step 0.0025
check 'surface files: a factor is said' has out 'height of 6.30079E-5 mm, by the factor'
reads_scan width_in_points.txt 0.00169677 24 18 0.0025 0.0025 0 $both
reads_scan width_in_points.txt 0.00169677 24 18 0.0025 0.0025 0 $um --step 0.0025
reads_scan y_first.csv 0.00169677 24 18 0.0025 0.002 0
reads_scan keyence_vk.csv 0.00169677 24 18 0.0025 0.0025 0
reads_scan keyence_vk_no_quotes.csv 0.00169677 24 18 0.0025 0.0025 0 $um --step 0.0025
reads_scan zygo_header.xyz 0.00170121 24 18 0.0025 0.0025 3
check 'surface files: what an export leaves open is said' has out 'heights are taken for um'
reads_scan wyko.asc 0.00170121 24 18 0.0025 0.002 3
check 'surface files: wave lengths are said' has out 'wave lengths of 633'
reads_scan spip.asc 0.00169677 24 18 0.0025 0.002 0
reads_scan surfer.grd 0.00169677 24 18 0.0025 0.002 0 $um --step 0.0025,0.002
reads_scan marker_99999.csv 0.00177928 48 36 0.0025 0.002 42 $um --step 0.0025,0.002 \
   --missing-value -99999.9999
run surface "$scans/marker_99999.csv" $um --step 0.0025,0.002
}
check 'surface files: many equal extremes are called a marker, before the units' sh -c \
   "grep -e '42 points have the same lowest height, -99999.9999,' -e 'check units' out | head -n 1 \
   | grep -q '42 points' && grep -q -e '--missing-value -99999.9999' out && grep -q 'check units' out"
refuses 'surface files: intensities' 2 '.*percent.sur: byte 212: the unit of z is %, which is no length' \
   surface "$scans/percent.sur" --height-unit um
sed 's/"Output image data","Height"/"Output image data","Color"/' "$scans/keyence_vk.csv" >colour.csv
refuses 'surface files: an image of colours' 2 "colour.csv:11:1: .*an image of 'Color', no heights" \
   surface colour.csv --height-unit um
refuses 'surface files: a profile without units' 2 '.*profile.txt: .*in which unit its heights are' \
   surface "$scans/profile.txt"
sed '/factor/d' "$scans/holography_factor.txt" >rad.txt
refuses 'surface files: phases without a factor' 2 \
   'rad.txt:3:11: the unit of this line, rad, is unknown as one of heights: .*m, cm, mm, um and nm' \
   surface rad.txt --height-unit um
{ printf 'Objective: 50x\n'; cat "$scans/width_in_points.txt"; } >header.txt
run surface header.txt --lateral-unit um --height-unit um --json header.json
check 'surface files: a line that was not understood' has out "not used: 'Objective: 50x'"
check 'surface files: and in JSON' has header.json "not used: 'Objective: 50x'"
refuses 'surface files: a marker of a made map' 2 '--missing-value: is for files' \
   surface --generate --missing-value 0
run surface --generate --map-points 64 --map s.sdf
run surface s.sdf --missing-value 0
check 'surface files: a marker of a format that has its own' has out '--missing-value is for text'

# Holes in SDF: 32-bit integers, heights to 1/(2^31 - 1) of the largest
map_with_holes >holes.csv
run surface holes.csv --step 0.01 --map holes.sdf --csv holes_out.csv
run surface holes.sdf --csv holes_again.csv --json holes_again.json
check 'surface files: holes in SDF come back' test "$(of_json holes_again.json map missing)" = 40
check 'surface files: and heights' near "$(value holes_out.csv sq)" "$(value holes_again.csv sq)" 1e-9
check 'surface files: as integers of 4 bytes' test "$(wc -c <holes.sdf)" -eq $((81 + 4*50*40))

# Little memory: the result, or an error that says how much was asked for, whatever the limit is
run surface --generate --map-points 1024 --map large.sdf --csv -
run surface large.sdf --map large.csv --csv -
if (ulimit -v 200000) 2>/dev/null && (ulimit -v 200000; "$program" version) >/dev/null 2>&1; then
   given=0 refused=0 wrong=
   for limit in $(seq 34000 8000 130000); do
      (ulimit -v "$limit"; OPENBLAS_NUM_THREADS=1 "$program" version) >/dev/null 2>&1 || continue
      for command in '--generate --map-points 1024 --map out.sdf' 'large.sdf --verify' \
         'large.csv --map out.csv' 'large.sdf --short-cutoff 0.03 --long-cutoff 2' \
         'large.sdf large.sdf --pair'; do
         # shellcheck disable=SC2086  # several words are meant
         (ulimit -v "$limit"; OPENBLAS_NUM_THREADS=1 "$program" surface $command) >out 2>err
         case $? in
            0) given=$((given + 1)) ;;
            1) if grep -q -E 'MiB more were asked for: make it smaller|MiB: give fewer points' err; then
                  refused=$((refused + 1))
               else
                  wrong="$wrong [$limit: $command: $(tail -n 1 err)]"
               fi ;;
            *) wrong="$wrong [$limit: $command: $(tail -n 1 err)]" ;;
         esac
      done
   done
   check "surface files: little memory, $given results, $refused refusals:$wrong" \
      test "$given" -gt 9 -a "$refused" -gt 9 -a -z "$wrong"
else
   skip 'surface files: little memory' 'no limit of memory can be set'
fi
rm -f large.sdf large.csv out.sdf out.csv
