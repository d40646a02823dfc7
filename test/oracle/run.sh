#!/usr/bin/env bash
# What the program writes, byte for byte, before and after a change that must not change it.
#
#    test/oracle/run.sh save    FOLDER [PROGRAM [BUILD]]   run all cases and keep what they write
#    test/oracle/run.sh compare FOLDER [PROGRAM [BUILD]]   run them again; 1 if anything differs
#
# PROGRAM is build/asperity and BUILD is build unless given; nothing is built. For each case
# FOLDER/NNN-NAME/ holds command, status, stdout, stderr, and in files/ all that the program wrote.
# Nothing of that is altered: a case runs in its own files/, where `data` and `examples` are links,
# so that no path of this machine gets into it. gnuplot must be the same in both runs.
#
# FOLDER/sources/ holds the one-file sources of BUILD without what a move of procedures between
# modules changes; see `sources` below.
set -euo pipefail
export LC_ALL=C OMP_NUM_THREADS=1 # cases run two at once
export COLUMNS=1000 SOURCE_DATE_EPOCH=0 # lines as wide as any table and remark

fail() { printf 'oracle: error: %s\n' "$*" >&2; exit 2; }

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
[[ ${1:-} == save || ${1:-} == compare ]] && (($# >= 2 && $# <= 4)) \
   || fail 'usage: test/oracle/run.sh save|compare FOLDER [PROGRAM [BUILD]]'
kept=$2
program=$(realpath -q "${3:-$root/build/asperity}") || program=
build=${4:-$root/build}
[[ -x $program ]] || fail "no program ${3:-build/asperity}: build it, or name it after FOLDER"
cases=0

# keep NAME ARGUMENT...: one case. `text=... keep` gives it the case file case.nml
keep() {
   local folder
   folder=$out/$(printf '%03d' $((cases + 1)))-$1
   cases=$((cases + 1))
   while (($(jobs -pr | wc -l) >= 2)); do wait -n || true; done
   keep_files "$folder" "${@:2}" &
}

keep_files() { # folder argument...
   mkdir -p "$1/files"
   cd "$1/files"
   shift
   ln -s "$root/test/data" data
   ln -s "$root/examples" examples
   [[ -z ${text:-} ]] || printf '%s\n' "$text" >case.nml
   { printf 'asperity'; printf ' %q' "$@"; printf '\n'; } >../command
   timeout 300 "$program" "$@" >../stdout 2>../stderr </dev/null && echo 0 >../status || echo $? >../status
   rm data examples
}

# The one-file sources: statements on one line, without comments, indentation, and the statements
# that tell of modules alone (module, use, private, public, implicit none); sorted, where a
# procedure, a type, an enum and an interface are a whole, with its head in front once more.
sources() {
   local name
   mkdir -p "$out/sources"
   for name in asperity_uinter asperity_vuinter asperity_vuinter_single; do
      [[ -f $build/abaqus/$name.f90 ]] || fail "no $build/abaqus/$name.f90"
      awk '
         { sub(/^ +/, ""); if (/^[^\047"]*!/ && !/^!(\$|[Dd][Ii][Rr]\$)/) sub(/ *!.*/, "") }
         /^$/ { next }
         { sub(/^&/, ""); statement = statement $0 }
         statement ~ /& *$/ { sub(/ *& *$/, " ", statement); next }
         { line = statement; statement = "" }
         line ~ /^(end )?module [a-z_0-9]+$/ || line ~ /^(use|private|public|implicit none)($|[ ,:])/ ||
            line == "contains" && !depth { next }
         line !~ /^end / && match(line, /(^| )(subroutine|function) +[a-z_0-9]+/) ||
            line ~ /^(type *(,|::| [a-z_0-9]+$)|enum,|(abstract )?interface( |$))/ {
            if (!depth++) block = RSTART ? substr(line, RSTART + (RSTART > 1)) : line }
         !depth { print line }
         depth { block = block "\t" line }
         line ~ /^end (subroutine|function|type|enum|interface)/ && !--depth { print block }
      ' "$build/abaqus/$name.f90" | sort | tr '\t' '\n' >"$out/sources/$name"
   done
}

all_cases() {
   local name file text
   # Help
   keep help help
   keep no-command
   for name in curve press shear tenon table hysteresis surface pairs compare; do keep "help-$name" help $name; done
   keep help-deck-shear deck shear --help
   keep help-deck-tenon deck tenon --help
   keep version version
   keep citation --citation
   keep pairs pairs

   # The law and its table
   local faces=(--pair tangential-tangential --sigma 0.04 --initial-separation 0.2)
   keep curve curve --csv curve.csv --json curve.json --plot curve.svg
   keep curve-own-faces curve "${faces[@]}" --separation=-0.01:0.2:23 --csv - --json curve.json
   keep curve-case curve examples/cases/own_surface.nml --csv curve.csv --json -
   keep curve-sanded curve examples/cases/sanded_surface.nml
   keep curve-implausible curve --eta 1e-9 --accept-unphysical --csv curve.csv
   keep curve-memory curve --unloading elastic --closest-separation 0.1 --csv curve.csv --json curve.json
   keep curve-print-case curve examples/cases/sanded_surface.nml --sigma 0.0123456789 --print-case
   for name in mesh-200-radial mesh-400-cross; do keep "curve-$name" curve --surface $name; done
   keep press press --csv press.csv --json press.json --plot press.svg
   keep press-overclosure press "${faces[@]}" --control overclosure --peak 0.123 --increments 9 \
      --step-time 3 --csv press.csv
   keep press-memory press --unloading elastic --peak 2,4.7,3 --csv press.csv --json press.json --plot press.svg
   keep press-print-case press --control overclosure --peak 0.123 --print-case
   keep table table --csv table.csv --json table.json --plot table.svg --abaqus law.inp --calculix law.inc
   keep table-own-faces table "${faces[@]}" --tolerance 0.02 --rows 150 --largest-pressure 3 \
      --smallest-pressure 1e-4 --stick-pressure 0.2 --calculix -
   keep table-print-case table --tolerance 0.02 --rows 150 --print-case

   # Shear box
   keep shear shear --csv shear.csv --json shear.json --plot shear.svg
   keep shear-rules shear "${faces[@]}" --friction-rule dissipative --slip-integration backward_euler \
      --normal-stress 0.03,0.07 --displacement 1,-1,0.3 --displacement-increment 0.07 \
      --no-shrinking-overlap --shear-compliance 1.2e-5 --rate 3 --diameter 50 --csv shear.csv --json -
   keep shear-case shear examples/cases/cyclic_shear.nml --csv shear.csv --plot shear.svg
   keep shear-memory shear --unloading elastic --displacement 3,-3 --csv shear.csv --json shear.json
   keep shear-print-case shear examples/cases/cyclic_shear.nml --print-case

   # Tenon joint
   local few=(--amplitudes '1,8' --face-points 30 --side-points 5)
   keep tenon tenon --csv joint.csv --json joint.json
   for file in base clearance fixed free longer_tenon lower_friction; do
      keep "tenon-$file" tenon "examples/tenon_joint/$file.nml" --csv joint.csv
   done
   keep tenon-report tenon "${few[@]}" --csv joint.csv --json joint.json --points points.csv \
      --plot joint.svg --report joint.html
   keep tenon-uinter tenon "${few[@]}" --through uinter --record 3,20 --points - --json joint.json
   keep tenon-memory tenon "${few[@]}" --unloading elastic --csv joint.csv --json joint.json
   keep tenon-shoulders tenon "${few[@]}" --shoulders --shoulder-gap 0.2 --gap first_touch \
      --clearance-above 0.1 --column rigid --csv joint.csv
   keep tenon-force tenon "${few[@]}" --axial-rule force --axial-force 200 --arm-datum column_axis \
      --cycles 1,2 --friction-rule dissipative --csv joint.csv
   keep tenon-history tenon --history data/records/protocol_comma.csv --decimal comma \
      --displacement-column 'load-point displacement' --csv joint.csv --json joint.json
   keep tenon-rotation tenon --history data/records/drift_percent.csv --csv joint.csv --plot joint.svg
   keep tenon-sweep tenon "${few[@]}" --sweep friction_coefficient=0.3,0.5 --sweep clearance=0:0.5:2 \
      --csv sweep.csv --json sweep.json
   keep tenon-sweep-outcomes tenon "${few[@]}" --sweep gap=mean_plane,first_touch \
      --sweep clearance=0.5,20 --csv -
   keep curve-single curve --single --unloading elastic --csv summit.csv --plot summit.svg
   keep curve-sweep curve --sweep sigma=0.04,0.06 --sweep unloading=reversible,elastic \
      --csv sweep.csv --json sweep.json --plot sweep.svg
   keep press-sweep press --sweep pair=transverse-tangential,tangential-tangential --csv sweep.csv
   keep tenon-print-case tenon examples/tenon_joint/base.nml --amplitudes 1,4 --cycles 1,2 --print-case

   # Decks
   local solver contact criterion
   for solver in calculix abaqus; do
      criterion=mises
      [[ $solver == abaqus ]] && criterion=hill
      for contact in uinter table hard; do
         keep "deck-shear-$solver-$contact" deck shear --mesh-size 10 --solver $solver \
            --contact $contact --inp shear.inp
         keep "deck-tenon-$solver-$contact" deck tenon --mesh-size 75 --amplitudes 2,5 --solver $solver \
            --contact $contact --inp tenon.inp
      done
      keep "deck-tenon-$solver-plastic" deck tenon --mesh-size 75 --amplitudes 3 --criterion $criterion \
         --field all --column-load 54000 --side-pressure 0 --tail 40 --solver $solver --inp -
   done
   keep deck-tenon-history deck tenon examples/calculix/joint.nml --mesh-size 60 \
      --history data/records/drift_percent.csv --displacement-column 2 --inp tenon.inp
   keep deck-shear-print-case deck shear examples/calculix/shear.nml --upper-grain normal --print-case
   keep deck-tenon-print-case deck tenon examples/calculix/joint.nml --print-case

   # Height maps that are made
   local map=(surface --generate --map-points '96,64')
   keep surface-generate "${map[@]}" --correlation-length 0.08 --csv map.csv --json map.json --map map.sdf \
      --case map.nml --plot map.svg
   keep surface-anisotropic "${map[@]}" --correlation-length 0.2,0.05 --length-direction 30 \
      --spectrum exponential --ssk -0.5 --sku 3.4 --seed 7 --map map.xyz --csv -
   keep surface-self-affine "${map[@]}" --spectrum self_affine --hurst 0.7 --map map.csv --json -
   keep surface-verify "${map[@]}" --verify --route nayak --case map.nml --csv map.csv --json map.json \
      --plot map.svg
   keep surface-filters "${map[@]}" --short-cutoff 0.03 --long-cutoff 0.5 --form 3 --pruning 0.1 \
      --tiles 2 --csv map.csv
   keep surface-memory "${map[@]}" --verify --unloading elastic --case map.nml --json map.json
   keep surface-example surface data/scans/truth_mm.csv --height-unit um --step 0.01 --verify --json map.json

   # Errors
   text='&asperity
 sigm = 3
/' keep error-key curve case.nml --csv never.csv
   text='&asperity sigma = 0.05, separation = 3*0.1 /' keep error-repeat curve case.nml
   text="&asperity pair = 'foo' /" keep error-pair shear case.nml
   keep error-option curve --sigm 3
   keep error-command crve
   keep error-range tenon --sigma -1
   keep error-slip-of-units shear --sigma 59.3
   keep error-number press --peak nan
   keep error-missing-file curve no.nml
   keep error-two-outputs curve --csv - --json -
   keep error-same-output curve --csv a --json a
   keep error-folder table --csv no/table.csv
   keep error-picture curve --plot curve.gif
   keep error-joint tenon --amplitudes 4,2
   keep error-sweep tenon --sweep foo=1,2
   keep error-deck deck tenon --axial-rule free --inp never.inp
   keep error-column hysteresis data/records/three_tests.csv --force-column load
   keep error-where hysteresis data/records/three_tests.csv --where specimen=Z
   keep error-record hysteresis data/records/protocol_comma.csv
   keep error-unit surface data/scans/truth_mm.csv
   keep error-map surface data/README.md
   keep error-pair-of-maps surface data/maps/surfalize.sdf --pair

   # Records and height maps of test/data
   for file in "$root"/test/data/records/*.csv; do
      name=$(basename "$file" .csv)
      keep "record-$name" hysteresis "data/records/$name.csv" --csv cycles.csv --json cycles.json
   done
   keep record-plot hysteresis data/records/three_tests.csv --plot loops.svg --csv -
   keep record-where hysteresis data/records/three_tests.csv --where specimen=A --peaks force \
      --threshold 0.2 --json -
   keep record-transducers hysteresis data/records/two_transducers.csv \
      --displacement-column 'LVDT south' --force-zero 0.1 --force-factor 2 --csv cycles.csv
   keep record-outliers hysteresis data/records/spike.csv --outliers keep --plot loops.svg
   for file in "$root"/test/data/{maps,scans}/*.*; do
      name=$(basename "$file")
      [[ $name == *.py || $name == *.md ]] || keep "map-$name" surface \
         "data/$(basename "$(dirname "$file")")/$name" --csv map.csv --json map.json
   done
   for file in axes_in_matrix.csv esri_{broken_lines,nodata_nan}.asc width_in_points.txt \
      count_first.pts end_mark.xyz quoted.csv; do
      keep "units-$file" surface "data/scans/$file" --height-unit um --lateral-unit um --json -
   done
   for file in pandas_index.csv truth_mm.csv marker_99999.csv; do
      keep "filled-$file" surface "data/scans/$file" --height-unit um --step 0.0025,0.002 \
         --missing fill --most-missing 0.5 --json - --map filled.csv
   done
   keep pair-of-maps surface data/maps/surfalize.sdf data/maps/surfalize.sur --pair --mirror y --csv map.csv
   wait
   [[ $(find "$out" -name status | wc -l) == "$cases" ]] || fail "not all cases could be run"
}

if [[ $1 == save ]]; then
   [[ ! -e $kept ]] || fail "$kept is there; remove it or name another folder"
   mkdir -p "$kept"
   out=$(realpath "$kept")
   sources
   all_cases
   echo "$cases cases kept in $kept"
   exit
fi

[[ -d $kept/sources ]] || fail "$kept was not written by $0 save"
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
sources
all_cases
different=0
for name in $(ls "$kept" "$out" | grep -v ':$' | sort -u); do
   diff -r --text "$kept/$name" "$out/$name" >"$out/differences" 2>&1 && continue
   different=$((different + 1))
   echo "DIFFERS $name: $(cat "$kept/$name/command" 2>/dev/null)"
   head -n 12 "$out/differences" | cut -c1-200 | sed "s/^/   | /"
done
echo "$cases cases and the one-file sources compared, $different differ"
((different == 0))
