#!/usr/bin/env bash
# One summit pressed flat (the paper's Fig. 5): force, area and mean pressure over its deformation, by
# examples/summit.
# usage: docs/pictures/summit.sh SUMMIT PICTURE.png     SUMMIT is the compiled example
set -euo pipefail
summit=$1 picture=$2
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
"$summit" >"$folder/summit.csv"
read -r w1 w2 < <(sed -n 's/^# w1 = *\([^ ]*\) mm, w2 = *\([^ ]*\) mm/\1 \2/p' "$folder/summit.csv")
gnuplot <<TEXT
set terminal pngcairo size 2000, 760 font 'sans,24' linewidth 2
set output '$picture'
set datafile separator ','
set multiplot layout 1, 3
set logscale xy
set format '10^{%T}'
set xlabel 'deformation w, mm'
set grid linecolor '#dddddd'
set border 3
set tics nomirror
set key bottom right samplen 1
set arrow 1 from $w1, graph 0 to $w1, graph 1 nohead dashtype 2 linecolor '#777777'
set arrow 2 from $w2, graph 0 to $w2, graph 1 nohead dashtype 2 linecolor '#777777'
set label 1 'w1' at $w1, graph 0.96 offset -0.4 right textcolor '#555555'
set label 2 'w2' at $w2, graph 0.96 offset 0.4 textcolor '#555555'
do for [i = 2:4] {
   if (i == 2) { set title 'force, N' }
   if (i == 3) { set title 'real area, mm²' }
   if (i == 4) { set title 'mean pressure, MPa' }
   plot '$folder/summit.csv' every ::3 using 1:(strcol(5) eq 'elastic' ? column(i) : 1/0) with lines linewidth 3 linecolor '#1f5f9f' title 'elastic', \
      '' every ::3 using 1:(strcol(5) eq 'elasto-plastic' ? column(i) : 1/0) with lines linewidth 3 linecolor '#207030' title 'elasto-plastic', \
      '' every ::3 using 1:(strcol(5) eq 'plastic' ? column(i) : 1/0) with lines linewidth 3 linecolor '#b03030' title 'plastic'
}
TEXT
