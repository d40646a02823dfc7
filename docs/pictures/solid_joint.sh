#!/usr/bin/env bash
# The joint as a solid, by a CSV file of `asperity solid`: loops, skeleton, forces, dissipation of both models.
# usage: docs/pictures/solid_joint.sh RUN.csv PICTURE.png
set -euo pipefail
csv=$1 picture=$2
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
for model in hard rough; do
   awk -F, -v model="$model" 'NR == 1 { for (i = 1; i <= NF; i++) { sub(/ \(.*/, "", $i); column[$i] = i }; next }
      $1 == model { printf "%s %s %s %s %s %s %s %s\n", $column["stroke"], $column["drift"], $column["moment"],
         $column["normal_upper"]/1e3, $column["normal_lower"]/1e3, $column["friction_dissipation"]/1e3,
         $column["plastic_dissipation"]/1e3, $column["pull_out"] }' "$csv" >"$folder/$model"
   # from rest to the peak, to the reverse peak and back
   awk '{ line[NR] = $0; stroke[NR] = $1; drift[NR] = $2; size = $2 < 0 ? -$2 : $2
        if (size > largest*1.000001) { largest = size; top = $1; side = $2 > 0 ? 1 : -1 } }
      END { for (i = 1; i <= NR; i++) if (stroke[i] == top + 1 || (stroke[i] == top && side*drift[i] >= 0) \
         || (stroke[i] == top + 2 && side*drift[i] <= 0)) print line[i] }' "$folder/$model" >"$folder/$model.loop"
   awk '{ if (NR > 1 && $1 != before) print row; before = $1; row = $0 } END { print row }' \
      "$folder/$model" >"$folder/$model.turns"
   # turns further than any before
   awk '{ side = $2 > 0; size = $2 > 0 ? $2 : -$2; if (size > far[side]*1.000001) { far[side] = size; print $2, $3 } }
      END { print 0, 0 }' "$folder/$model.turns" | sort -g >"$folder/$model.skeleton"
done
gnuplot <<TEXT
set terminal pngcairo size 2000, 1240 font 'sans,22' linewidth 2
set output '$picture'
set multiplot layout 2, 3
set grid linecolor '#dddddd'
set border 3
set tics nomirror
set key top left samplen 1 reverse Left
set lmargin 9
set xlabel 'drift, rad'
set xtics 0.05
hard = '#1f5f9f'; rough = '#d55e00'
set title 'moment, kN m'
plot '$folder/hard' using 2:3 with lines linecolor rgb hard title 'hard contact', \
   '$folder/rough' using 2:3 with lines dashtype 2 linecolor rgb rough title 'rough law'
unset key
set title 'moment, largest loop, kN m'
plot '$folder/hard.loop' using 2:3 with lines linecolor rgb hard, \
   '$folder/rough.loop' using 2:3 with lines dashtype 2 linecolor rgb rough
set title 'skeleton, kN m'
plot '$folder/hard.skeleton' with linespoints pointtype 4 linecolor rgb hard, \
   '$folder/rough.skeleton' with linespoints pointtype 7 dashtype 2 linecolor rgb rough
set key top center
set title 'normal force, largest loop, kN'
plot '$folder/hard.loop' using 2:4 with lines linecolor rgb hard title 'upper face', \
   '$folder/rough.loop' using 2:4 with lines dashtype 2 linecolor rgb rough notitle, \
   '$folder/hard.loop' using 2:5 with lines linewidth 0.5 linecolor rgb hard title 'lower face', \
   '$folder/rough.loop' using 2:5 with lines linewidth 0.5 dashtype 2 linecolor rgb rough notitle
unset key
set title 'pull-out, largest loop, mm'
plot '$folder/hard.loop' using 2:8 with lines linecolor rgb hard, \
   '$folder/rough.loop' using 2:8 with lines dashtype 2 linecolor rgb rough
set key top left
set xtics autofreq
set xlabel 'cycle'
set title 'energy, kJ'
plot '$folder/hard.turns' using (\$1/2):6 with lines linecolor rgb hard title 'lost to friction', \
   '$folder/rough.turns' using (\$1/2):6 with lines dashtype 2 linecolor rgb rough notitle, \
   '$folder/hard.turns' using (\$1/2):7 with lines linewidth 0.5 linecolor rgb hard title 'to plastic strain', \
   '$folder/rough.turns' using (\$1/2):7 with lines linewidth 0.5 dashtype 2 linecolor rgb rough notitle
TEXT
