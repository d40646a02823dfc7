#!/usr/bin/env bash
# The README's picture: pressure over closure, rough law and hard contact, by `asperity curve`.
# usage: docs/pictures/pressure.sh ASPERITY PICTURE.png
set -euo pipefail
asperity=$1 picture=$2
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
for pair in transverse-tangential tangential-tangential; do
   "$asperity" curve --pair "$pair" --separation 0:0.26:261 --csv "$folder/$pair.csv" \
      >"$folder/$pair.txt" 2>&1 || { cat "$folder/$pair.txt" >&2; exit 1; }
done
gnuplot <<TEXT
set terminal pngcairo size 1600, 900 font 'sans,26' linewidth 2
set output '$picture'
set datafile separator ','
set xrange [-0.05:0.2]
set yrange [0:8]
set xtics format '%g'
set xlabel 'closure, mm'
set ylabel 'pressure, MPa'
set grid linecolor '#dddddd'
set border 3
set tics nomirror
set arrow from -0.05, 4.7 to 0.2, 4.7 nohead dashtype 2 linecolor '#777777'
set label 'wood yields across the grain' at 0.004, 5.0 textcolor '#555555'
set label 'hard contact' at -0.004, 7 right textcolor '#b03030'
set label "rough law,\ntangential on\ntangential face" at 0.098, 2.9 right textcolor '#207030'
set label "rough law,\ntransverse on\ntangential face" at 0.143, 3.2 left textcolor '#1f5f9f'
unset key
set arrow from 0, 0 to 0, 8 nohead linewidth 4 linecolor '#b03030'
set arrow from -0.05, 0 to 0, 0 nohead linewidth 4 linecolor '#b03030' front
plot '$folder/transverse-tangential.csv' using 2:3 every ::1 with lines linewidth 3 linecolor '#1f5f9f', \
   '$folder/tangential-tangential.csv' using 2:3 every ::1 with lines linewidth 3 linecolor '#207030'
TEXT
