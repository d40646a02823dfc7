# Pictures through gnuplot

refuses 'unknown kind of picture' 2 '--plot: x.jpg has no known ending' curve --plot x.jpg
refuses 'picture without ending' 2 '--plot: x has no known ending' curve --plot x
refuses 'picture on standard output' 2 '--plot: - has no known ending' curve --plot -
refuses 'picture in a folder that does not exist' 3 '--plot: no/x.svg cannot be written' \
   curve --plot no/x.svg
if command -v gnuplot >/dev/null; then
   for command in curve press shear table; do
      run $command --plot $command.svg
      check "$command: SVG" sh -c "tail -n 3 $command.svg | grep -q '^</svg>'"
      check "$command: title in the SVG" has $command.svg 'transverse-tangential'
      run $command --plot $command.png
      check "$command: PNG" sh -c "head -c 4 $command.png | grep -q PNG"
      run $command --plot $command.PDF
      check "$command: PDF" sh -c "head -c 4 $command.PDF | grep -q PDF"
   done
   run curve --separation 100 --plot far.svg
   check 'picture of one point without pressure' test "$status" -eq 0 -a -s far.svg
   run curve --unloading elastic --closest-separation 0.1 --plot parting.svg
   check 'picture of faces that part: twelve decades of pressure' \
      sh -c 'grep -q "1e-10" parting.svg && ! grep -q "1e-[2-9][0-9]" parting.svg'
   run shear --displacement 0 --plot rest.svg
   check 'picture of a box at rest' test "$status" -eq 0 -a -s rest.svg
   run shear --normal-stress 0.05:0.2:60 --plot many.svg
   check 'picture of many runs' test "$status" -eq 0 -a -s many.svg
   run curve --plot "it's.svg"
   check 'any name of a picture' test "$status" -eq 0 -a -s "it's.svg"
   check 'no temporary picture stays' sh -c '! ls *.part 2>/dev/null'
else
   skip 'pictures' 'no gnuplot'
fi

# Without gnuplot, and with one that fails or fills the disk
mkdir tools
refuses_with_tools() {
   local name=$1 expected=$2 pattern=$3
   shift 3
   PATH=$PWD/tools:$tools_path limited "$program" "$@" >out 2>err </dev/null
   status=$?
   check "$name" is_refused "$expected" "$pattern"
}
tools_path=
refuses_with_tools 'no gnuplot' 1 '--plot: gnuplot is not installed; .* gnuplot-nox' \
   curve --plot never.svg --csv never.csv
tools_path=$PATH
printf '#!/bin/sh\ncat >/dev/null\nexit 3\n' >tools/gnuplot
chmod +x tools/gnuplot
refuses_with_tools 'gnuplot fails' 1 '--plot: gnuplot failed with exit status 3$' \
   curve --plot never.svg --csv never.csv
printf '#!/bin/sh\nexit 3\n' >tools/gnuplot
refuses_with_tools 'gnuplot fails without reading' 1 '--plot: gnuplot failed with exit status 3$' \
   curve --separation 0.1:0.2:100000 --plot never.svg --csv never.csv
for signal in 9 11 15; do
   printf '#!/bin/sh\nkill -%s $$\n' $signal >tools/gnuplot
   refuses_with_tools "gnuplot is ended by signal $signal" 1 \
      "--plot: gnuplot was ended by signal $signal\$" curve --plot never.svg --csv never.csv
done
printf '#!/bin/sh\ncat >/dev/null\necho "<svg>"\n' >tools/gnuplot
refuses_with_tools 'gnuplot leaves half a picture' 3 '--plot: never.svg cannot be written' \
   curve --plot never.svg --csv never.csv
check 'no picture and no table then' sh -c '! ls never* 2>/dev/null'

# Signals that would end the program reach it while gnuplot draws, when a temporary file is there
for signal in HUP INT QUIT USR1 USR2 ALRM TERM XCPU; do
   printf '#!/bin/sh\ncat >/dev/null\nkill -%s $PPID\necho "<svg></svg>"\n' $signal >tools/gnuplot
   PATH=$PWD/tools:$tools_path limited "$program" curve --plot held.svg >out 2>err </dev/null
   status=$?
   check "SIG$signal while a picture is drawn: it is whole, nothing else stays" \
      sh -c '[ "$1" -eq 0 ] && grep -q "</svg>" held.svg && ! ls *.part 2>/dev/null' sh $status
   rm -f held.svg
done
