#!/usr/bin/env bash
# Moment over rotation of the joint of new and of old wood, rough law, by `asperity tenon`: skeletons as one factor
# falls, and the loops of examples/old_joint.
# usage: docs/pictures/old_joint.sh ASPERITY PICTURE.png
set -euo pipefail
asperity=$1 picture=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
base=$here/../../examples/tenon_joint/base.nml
old=$here/../../examples/old_joint/old_joint.nml
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

# run NAME ARGUMENT...: rotation and moment of the rough law, and the turns that go further than any before
run() {
   local name=$1
   shift
   "$asperity" tenon "$@" --csv "$folder/csv" >"$folder/log" 2>&1 || { cat "$folder/log" >&2; exit 1; }
   awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) { sub(/ \(.*/, "", $i); column[$i] = i }; next }
      $1 == "rough" { print $column["rotation"], $column["moment"] }' "$folder/csv" >"$folder/$name"
   awk '{ side = $1 > 0; size = $1 > 0 ? $1 : -$1; x[NR] = $1; m[NR] = $2 }
      END { for (i = 2; i <= NR; i++) { side = x[i] > 0; size = side ? x[i] : -x[i]
               next_size = i < NR && (x[i + 1] > 0) == side ? (side ? x[i + 1] : -x[i + 1]) : 0
               if (size > next_size && size > far[side]*1.000001) { far[side] = size; print x[i], m[i] } }
            print 0, 0 }' "$folder/$name" | sort -g >"$folder/$name.skeleton"
}

run new "$base"
run old "$old"
run across "$base" --ageing-strength-compression-across 0.5
run friction "$base" --ageing-friction 0.5
run stiffness "$base" --ageing-stiffness-across 0.5 --ageing-stiffness-along 0.5
run hardness "$base" --ageing-hardness 0.5
gnuplot <<TEXT
set terminal pngcairo size 2000, 800 font 'sans,24' linewidth 2
set output '$picture'
set multiplot layout 1, 2
set grid linecolor '#dddddd'
set border 3
set tics nomirror
set xlabel 'rotation, rad'
set ylabel 'moment, kN m'
set xtics 0.05
set yrange [-20:20]
set key top left samplen 1.5 reverse Left
set title 'skeletons, one property halved'
plot '$folder/hardness.skeleton' with lines linewidth 5 linecolor rgb '#bbbbbb' title 'hardness of faces', \
   '$folder/new.skeleton' with linespoints pointtype 7 linecolor rgb '#1f5f9f' title 'none: new wood', \
   '$folder/stiffness.skeleton' with linespoints pointtype 6 linecolor rgb '#207030' title 'stiffness', \
   '$folder/friction.skeleton' with linespoints pointtype 5 linecolor rgb '#d55e00' title 'friction', \
   '$folder/across.skeleton' with linespoints pointtype 4 linecolor rgb '#b03030' title 'strength across'
set title 'loops, new wood and examples/old\\_joint'
plot '$folder/new' with lines linecolor rgb '#1f5f9f' title 'new', \
   '$folder/old' with lines linecolor rgb '#b03030' title 'old'
TEXT
