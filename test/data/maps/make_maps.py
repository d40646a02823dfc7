"""Makes the height maps of this folder with programs that know nothing of asperity: surfalize,
SurfaceTopography and sdfio, all three from PyPI. Only needed to make them anew.

7 x 6 points, 2 um by 3 um apart, i and j counted from 0:
z = i^2 - 3 j + i j/4 um; points (0, 0) and (3, 2) are missing. Of sdfio's maps it is |z|.
"""

from pathlib import Path

import numpy as np
import sdfio
from surfalize import Surface
from SurfaceTopography import Topography
from SurfaceTopography.IO.X3P import write_x3p

FOLDER = Path(__file__).parent
nx, ny = 7, 6
i, j = np.meshgrid(np.arange(nx), np.arange(ny))
z = i * i - 3 * j + 0.25 * i * j
z[0, 0] = z[2, 3] = np.nan

surface = Surface(z, 2.0, 3.0)
for ending, name, options in [
    ("sdf", "surfalize", {}),
    ("sdf", "surfalize_text", {"binary": False}),
    ("x3p", "surfalize", {}),
    ("sur", "surfalize", {}),
    ("sur", "surfalize_packed", {"compressed": True}),
]:
    surface.save(FOLDER / f"{name}.{ending}", **options)

metres = np.ma.masked_invalid(1e-6 * z.T)
topography = Topography(metres, (nx * 2e-6, ny * 3e-6), unit="m")
for kind in "DFLI":
    write_x3p(topography, FOLDER / f"surface_topography_{kind}.x3p", dtype=kind)

for revision, form, kind in [
    ("ISO_1_0", "ASCII", "BINARY64"),
    ("ISO_2_0", "ASCII", "BINARY32"),
    ("ISO_2_0", "BINARY", "INT16"),
    ("BCR_1_0", "BINARY", "UINT16"),
    ("BCR_1_0", "ASCII", "INT32"),
]:
    sdfio.write(
        FOLDER / f"sdfio_{revision}_{form}_{kind}.sdf".lower(),
        1e-6 * np.abs(z),
        x_scale=2e-6,
        y_scale=3e-6,
        format=sdfio.FileFormat[form],
        metadata=sdfio.Metadata(
            revision=sdfio.Revision[revision],
            data_type=sdfio.DataType[kind],
            create_date=None,
            mod_date=None,
        ),
    )
