"""Text that programs of instruments export, written by other programs or after their layout, and
read by asperity and by others.

No reader of Keyence's csv and Zygo's XYZ text is published as a package: they are written here as
public programs write them, and read by asperity alone.
"""

import warnings

import formats
import gwyddion
import numpy as np
import packages
import rasterio
import rasterio.shutil
from rasterio.transform import from_origin

EXACT = 1e-12
UM = ("--lateral-unit", "um", "--height-unit", "um")
WAVE = 632.8  # nm
BLANK = 1.70141e38


def write_keyence(m, path):
    """Keyence's csv, one step for both directions."""
    rows, columns = m.heights.shape
    head = (("Measured date", "2026-01-15 09:30:00"), ("Model", "VK-X3000 Series"),
            ("Data type", "ImageDataCsv"), ("File version", "1000"),
            ("XY Calibration", f"{1e3*m.step_x:g}", "nm"), ("Output image data", "Height"),
            ("Horizontal", columns), ("Vertical", rows), ("Minimum value", np.nanmin(m.heights)),
            ("Maximum value", np.nanmax(m.heights)), ("Unit", "um"), ("Reference data name", ""),
            (), ("Height",), *([("" if np.isnan(z) else repr(float(z))) for z in row]
                               for row in m.heights))
    path.write_text("".join(",".join(f'"{field}"' for field in line) + "\r\n" for line in head),
                    encoding="ascii")


def write_zygo(m, path):
    """Zygo's XYZ text of MetroPro, one step for both directions."""
    rows, columns = m.heights.shape
    head = ("Zygo XYZ Data File - Format 1", '1 8 3 5 "Tue Nov 24 10:00:00 2026"', "0 0 0 0 0 0",
            f"3 5 {columns} {rows}", '"spruce"', '""', '""',
            f"0 0.5 {WAVE*1e-9} 0 1 0 {m.step_x*1e-6} 1795515600", *4*("0 0 0 0",), "1 0", "#")
    points = (f"{i + 3} {j + 5} " + ("No Data" if np.isnan(m.heights[j, i])
                                     else repr(float(m.heights[j, i])))
              for j in range(rows) for i in range(columns))
    path.write_text("\n".join((*head, *points, "#", "")), encoding="ascii")


def write_wyko(m, path, has_points=False, is_real=True):
    """Wyko's ASCII text: a matrix or points, nm or wave lengths."""
    rows, columns = m.heights.shape
    head = [f"Wyko ASCII Data File Format {has_points:d}\t{is_real:d}\t1", f"X Size\t{columns}",
            f"Y Size\t{rows}", "Block Name\tType\tLength\tValue", f"Wavelength\t7\t4\t{WAVE}",
            f"Aspect\t7\t4\t{m.step_y/m.step_x!r}", f"Pixel_size\t7\t4\t{m.step_x*1e-3!r}",
            "Mult\t7\t4\t1", f"RAW_DATA\t3\t{4*m.heights.size}\t"]
    z = [["Bad" if np.isnan(height) else repr(float(height)) for height in line]
         for line in m.heights.T*1e3/(1.0 if is_real else WAVE)]
    if has_points:
        lines = [f"{i*m.step_x*1e-3:.6f}\t{j*m.step_y*1e-3:.6f}\t{z[i][j]}"
                 for i in range(columns) for j in range(rows)]
    else:
        lines = ["\t".join(line) for line in z]
    path.write_text("".join(line + "\r\n" for line in head + lines), encoding="ascii")


def write_spip(m, path):
    """SPIP's ASCII text; a matrix behind the heights is 1 where one is missing."""
    rows, columns = m.heights.shape
    missing = np.isnan(m.heights)
    head = ("File Format = ASCII", "Created by SPIP", f"x-pixels = {columns}", f"y-pixels = {rows}",
            f"x-length = {1e3*columns*m.step_x!r}", f"y-length = {1e3*rows*m.step_y!r}",
            "x-offset = 0", "y-offset = 0", "z-unit = nm", f"voidpixels = {missing.sum()}",
            "Start of Data:")
    with open(path, "w", encoding="ascii") as file:
        file.writelines(f"# {line}\n" for line in head)
        np.savetxt(file, np.nan_to_num(1e3*m.heights), fmt="%.17g", delimiter="\t")
        if missing.any():
            np.savetxt(file, missing, fmt="%d", delimiter="\t")


def write_surfer(m, path):
    """Surfer's ASCII grid, by GDAL; the first row is at the largest y."""
    geotiff = path.with_suffix(".tif")
    rows, columns = m.heights.shape
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", rasterio.errors.NotGeoreferencedWarning)
        with rasterio.open(geotiff, "w", driver="GTiff", width=columns, height=rows, count=1,
                           dtype="float64", nodata=BLANK,
                           transform=from_origin(0, 0, m.step_x, m.step_y)) as file:
            file.write(np.nan_to_num(m.heights, nan=BLANK), 1)
        rasterio.shutil.copy(geotiff, path, driver="GSAG")


def read_surfer(path):
    """(heights[j, i], step_x, step_y), by GDAL."""
    with rasterio.open(path) as file:
        heights = file.read(1)
        return np.where(heights >= BLANK, np.nan, heights), file.transform.a, -file.transform.e


def read_wyko_by_surfacetopography(path):
    """The same of a Wyko file, whose lines it takes for lines of constant y."""
    heights, step_x, step_y = packages.read_by_surfacetopography(path)
    return heights.T, step_y, step_x


def compare_exports(program, _):
    """Every export."""
    for m in formats.two_maps():
        square = m._replace(step_y=m.step_x)
        compare_one(program, "Keyence csv", "csv", write_keyence, square)
        compare_one(program, "Zygo XYZ", "xyz", write_zygo, square)
        compare_one(program, "GDAL's Surfer grid", "grd", write_surfer, m, UM, True,
                    (("GDAL", read_surfer, False),))
        wyko = [("SurfaceTopography", read_wyko_by_surfacetopography, False)]
        spip = []
        if not gwyddion.missing():
            # its first row is the one of the largest y
            wyko.append(("Gwyddion", gwyddion.read, True))
            spip.append(("Gwyddion", gwyddion.read, False))
            if m.name == "full":
                compare_one(program, "Gwyddion's SPIP", "asc", gwyddion.write, m, (), False, spip)
        compare_one(program, "SPIP", "asc", write_spip, m, (), False, spip)
        for name, is_real in (("nm", True), ("waves", False)):
            compare_one(program, f"Wyko matrix of {name}", "asc",
                        lambda m, path, r=is_real: write_wyko(m, path, False, r), m, (), False, wyko)
            compare_one(program, f"Wyko points of {name}", "asc",
                        lambda m, path, r=is_real: write_wyko(m, path, True, r), m, (), False,
                        wyko[1:])


def compare_one(program, name, ending, write, m, hints=(), turned=False, readers=()):
    """A file as asperity and others read it; turned: asperity's rows the other way round."""
    path = program.folder / f"export {name} {m.name}.{ending}".replace(" ", "_").replace("'", "")
    write(m, path)
    formats.compare(f"{name}, {m.name}, read by asperity",
                    formats.read_by_asperity(program, path, hints), m, EXACT, turned)
    for reader, read, is_turned in readers:
        formats.compare(f"{name}, {m.name}, read by {reader}", read(path), m, EXACT, is_turned)
