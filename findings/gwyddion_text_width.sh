#!/usr/bin/env bash
# Gwyddion 2.62: the header of its text export prints Width and Height with so few figures that the
# step is lost.
#
# A good guess: `# Width: 57 µm` above 24 columns is their width, so that the step is 57/24 = 2.375 um.
# Seen: the step is 2.371 um and Height, 36 um, 18 steps of 1.987 um: 0.65 % too much, of which a slope
# has 0.65 % and a curvature 1.3 %. Lengths are printed with as many figures as tell two points apart.
# Needs Debian's gwyddion and xvfb installed; it is called as a library, as its own command line writes
# GWY alone.
source "$(dirname "$0")/lib/setup.sh"
export HOME=$folder LC_ALL=C.UTF-8
mkdir .gwyddion
printf 'Gwyddion Settings 1.0\n"/module/asciiexport/add-comment" boolean True\n' >.gwyddion/settings
version_is 'Gwyddion 2.62' gwyddion --version
xvfb-run -a python3 - <<'PY' >log 2>&1 || { cat log; exit 1; }
import ctypes
from ctypes import c_char_p, c_double, c_int, c_uint, c_void_p

libraries = [ctypes.CDLL(f"lib{name}.so.0", ctypes.RTLD_GLOBAL) for name in (
    "glib-2.0", "gtk-x11-2.0", "gwyddion2", "gwyprocess2", "gwydraw2", "gwydgets2", "gwymodule2",
    "gwyapp2")]


def call(name, result, types, *arguments):
    function = next(f for f in (getattr(x, name, None) for x in libraries) if f)
    function.restype, function.argtypes = result, types
    return function(*arguments)


call("gtk_init", None, [c_void_p, c_void_p], None, None)
call("gwy_app_init_common", c_int, [c_void_p, c_char_p, c_char_p, c_void_p], None, b"layer", b"file", None)
field = call("gwy_data_field_new", c_void_p, [c_int, c_int, c_double, c_double, c_int],
             24, 18, 24*2.371e-6, 18*1.987e-6, 1)
unit = call("gwy_data_field_get_si_unit_xy", c_void_p, [c_void_p], field)
call("gwy_si_unit_set_from_string", None, [c_void_p, c_char_p], unit, b"m")
data = call("gwy_container_new", c_void_p, [])
call("gwy_container_set_object", None, [c_void_p, c_uint, c_void_p], data,
     call("g_quark_from_string", c_uint, [c_char_p], b"/0/data"), field)
call("gwy_app_data_browser_add", None, [c_void_p], data)
call("gwy_app_data_browser_select_data_field", None, [c_void_p, c_int], data, 0)
call("gwy_file_save", c_int, [c_void_p, c_char_p, c_int, c_void_p], data, b"map.txt", 4, None)
PY
expect '# Width: 57 µm # Height: 36 µm of 56.904 and 35.766 um' \
   "$(sed -n '2,3p' map.txt | paste -sd ' ') of 56.904 and 35.766 um"
