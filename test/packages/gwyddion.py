"""Gwyddion as a reader and a writer of maps: its own libraries, without its windows.

    xvfb-run -a python gwyddion.py read FILE MAP.npz     heights[j, i] and steps, m, of its channel 0
    xvfb-run -a python gwyddion.py write MAP.npz FILE... the formats are those of the endings

Points that it masks are nan. Its functions are those of its C manual.
"""

import ctypes
import os
import shutil
import subprocess
import sys
from ctypes import c_char_p, c_double, c_int, c_uint, c_void_p
from pathlib import Path

import numpy as np

# Run without questions; GwyRunType
IMMEDIATE = 4
LIBRARIES = ("gwyddion2", "gwyprocess2", "gwydraw2", "gwydgets2", "gwymodule2", "gwyapp2")


def missing():
    """What is not installed of it; empty if it is there."""
    return " and ".join(name for name in ("gwyddion", "xvfb-run") if not shutil.which(name))


def run(folder, *arguments, language="C.UTF-8"):
    """This file in a process of its own, with settings of its own: headers are written."""
    settings = Path(folder, "gwyddion_home", ".gwyddion", "settings")
    settings.parent.mkdir(parents=True, exist_ok=True)
    settings.write_text("Gwyddion Settings 1.0\n" + "".join(
        f'"/module/{module}/add-comment" boolean True\n'
        for module in ("asciiexport", "xyzexport")), encoding="utf-8")
    environment = os.environ | {"HOME": str(settings.parent.parent), "LC_ALL": language}
    done = subprocess.run(["xvfb-run", "-a", sys.executable, __file__, *map(str, arguments)],
                          env=environment, check=False, capture_output=True, text=True, timeout=120)
    if done.returncode:
        raise RuntimeError(f"Gwyddion: {(done.stderr or done.stdout).strip()[-300:]}")


def read(path):
    """(heights[j, i], step_x, step_y) in um."""
    result = Path(path).with_suffix(".npz")
    run(result.parent, "read", path, result)
    with np.load(result) as found:
        return found["heights"]*1e6, *(found["steps"]*1e6)


def write(m, *paths, language="C.UTF-8"):
    """Files of a map."""
    given = Path(paths[0]).with_name("for_gwyddion.npz")
    np.savez(given, heights=m.heights*1e-6, steps=np.array([m.step_x, m.step_y])*1e-6)
    run(given.parent, "write", given, *paths, language=language)


class Gwyddion:
    """Its libraries, started."""

    def __init__(self):
        handles = [ctypes.CDLL(name, ctypes.RTLD_GLOBAL) for name in (
            "libglib-2.0.so.0", "libgtk-x11-2.0.so.0", *(f"lib{name}.so.0" for name in LIBRARIES))]
        self.libraries = handles
        self.call("gtk_init", None, [c_void_p, c_void_p], None, None)
        self.call("gwy_app_init_common", c_int, [c_void_p, *3*[c_char_p], c_void_p],
                  None, b"layer", b"file", None, None)

    def call(self, name, result, types, *arguments):
        """A function by name, from whichever library has it."""
        for library in self.libraries:
            function = getattr(library, name, None)
            if function is not None:
                function.restype, function.argtypes = result, types
                return function(*arguments)
        raise RuntimeError(f"no function {name}")

    def key(self, name):
        """The number that stands for a name."""
        return self.call("g_quark_from_string", c_uint, [c_char_p], name)

    def values(self, field):
        """heights[j, i] of a field, as a view."""
        size = [self.call(f"gwy_data_field_get_{n}res", c_int, [c_void_p], field) for n in "yx"]
        data = self.call("gwy_data_field_get_data", ctypes.POINTER(c_double), [c_void_p], field)
        return np.ctypeslib.as_array(data, size)

    def read(self, path, result):
        """Channel 0 of a file."""
        data = self.call("gwy_file_load", c_void_p, [c_char_p, c_int, c_void_p],
                         str(path).encode(), IMMEDIATE, None)
        if not data:
            raise RuntimeError(f"it does not read {path}")
        fields = []
        for name in (b"/0/data", b"/0/mask"):
            key = self.key(name)
            there = self.call("gwy_container_contains", c_int, [c_void_p, c_uint], data, key)
            fields.append(there and self.call("gwy_container_get_object", c_void_p,
                                              [c_void_p, c_uint], data, key))
        heights = self.values(fields[0]).copy()
        if fields[1]:
            heights[self.values(fields[1]) > 0.5] = np.nan
        steps = [self.call(f"gwy_data_field_get_d{n}", c_double, [c_void_p], fields[0])
                 for n in "xy"]
        np.savez(result, heights=heights, steps=steps)

    def write(self, given, paths):
        """A map into files. Masked points have the height 0 in formats without masks."""
        with np.load(given) as found:
            heights, steps = found["heights"], found["steps"]
        size = heights.shape[::-1]
        data = self.call("gwy_container_new", c_void_p, [])
        fields = {b"/0/data": np.nan_to_num(heights), b"/0/mask": np.isnan(heights).astype(float)}
        for name, values in fields.items():
            if name == b"/0/mask" and not values.any():
                continue
            field = self.call("gwy_data_field_new", c_void_p, [c_int, c_int, c_double, c_double,
                              c_int], *size, *(size*steps), 0)
            self.values(field)[:] = values
            for axes in ("xy", "z") if name == b"/0/data" else ("xy",):
                unit = self.call(f"gwy_data_field_get_si_unit_{axes}", c_void_p, [c_void_p], field)
                self.call("gwy_si_unit_set_from_string", None, [c_void_p, c_char_p], unit, b"m")
            self.call("gwy_container_set_object", None, [c_void_p, c_uint, c_void_p],
                      data, self.key(name), field)
        self.call("gwy_app_data_browser_add", None, [c_void_p], data)
        self.call("gwy_app_data_browser_select_data_field", None, [c_void_p, c_int], data, 0)
        for path in paths:
            if not self.call("gwy_file_save", c_int, [c_void_p, c_char_p, c_int, c_void_p],
                             data, str(path).encode(), IMMEDIATE, None):
                raise RuntimeError(f"it does not write {path}")


if __name__ == "__main__":
    if sys.argv[1] == "read":
        Gwyddion().read(*sys.argv[2:])
    else:
        Gwyddion().write(sys.argv[2], sys.argv[3:])
