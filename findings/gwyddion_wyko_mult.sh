#!/usr/bin/env bash
# Gwyddion 2.62 (Debian) and SurfaceTopography 1.27.1: the same Wyko ASCII file with `Mult` 2 has
# heights four times as high in one as in the other.
#
# A good guess: heights in wave lengths are over Mult, as both have it in the binary form (OPD). Seen:
# for 10 wave lengths of 600 nm SurfaceTopography reads 10 x 600/2 nm, Gwyddion 10 x 600 x 2 nm. With
# Mult 1 both read 6000 nm. Needs Gwyddion and xvfb-run.
source "$(dirname "$0")/lib/setup.sh"
version_is 'Gwyddion 2.62' gwyddion --version
python_packages SurfaceTopography==1.27.1 gwyfile==0.3.0
for mult in 1 2; do
   {
      printf 'Wyko ASCII Data File Format 0\t0\t1\r\nX Size\t5\r\nY Size\t4\r\n'
      printf 'Block Name\tType\tLength\tValue\r\nWavelength\t7\t4\t600\r\nPixel_size\t7\t4\t0.002\r\n'
      printf 'Mult\t7\t4\t%s\r\nRAW_DATA\t3\t80\t\r\n' "$mult"
      printf '%s\t%s\t%s\t%s\r\n' 10 1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9 1
   } >"$mult.asc"
   HOME=$folder xvfb-run -a gwyddion --disable-gl --convert-to-gwy="$mult.gwy" "$mult.asc" \
      >gwyddion.log 2>&1 </dev/null || { cat gwyddion.log; exit 1; }
done
expect 'Mult 1: Gwyddion 6000 nm, SurfaceTopography 6000 nm
Mult 2: Gwyddion 12000 nm, SurfaceTopography 3000 nm' "$("$python" - 2>/dev/null <<'PY'
import gwyfile
from SurfaceTopography import read_topography

for mult in 1, 2:
    gwyddion = gwyfile.load(f"{mult}.gwy")["/0/data"].data.max()*1e9
    other = read_topography(f"{mult}.asc").heights().max()
    print(f"Mult {mult}: Gwyddion {gwyddion:.0f} nm, SurfaceTopography {other:.0f} nm")
PY
)"
