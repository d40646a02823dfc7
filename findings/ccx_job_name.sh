#!/usr/bin/env bash
# CalculiX 2.20 (Debian's calculix-ccx 2.20-1): the results of a job whose name has a blank are strewn
# over two names.
#
# A good guess: `ccx "my deck"` reads "my deck.inp" and writes "my deck.dat", or refuses. Seen: it reads
# the deck and ends with status 0, the field file is "my deck.frd", and the printed results, the status
# and the convergence are in "my.dat", "my.sta" and "my.cvg", where another job's may have been.
source "$(dirname "$0")/lib/setup.sh"
source "$findings/lib/two_blocks.sh"
debian_package calculix-ccx=2.20-1
ccx=$folder/debian/usr/bin/ccx
version_is 2.20 "$ccx" -v

two_blocks "$slave_faces" 'NODE TO SURFACE' "$table" $'*DLOAD\n2,P2,1.' \
   $'*CONTACT PRINT\nCSTR' >'my deck.inp'
"$ccx" 'my deck' >log
expect "'my deck.frd' 'my.cvg' 'my.dat' 'my.sta'" \
   "$(for file in my*.{frd,cvg,dat,sta}; do [[ ! -s $file ]] || printf "%q\n" "$file"; done \
      | sed "s/\\\\ / /; s/.*/'&'/" | sort | paste -sd ' ')"
