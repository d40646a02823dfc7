#!/usr/bin/env bash
# SurfaceTopography 1.27.1: a missing point of a binary SDF file of doubles is a height of minus
# infinity; of 32-bit integers, or in a text file, it is a missing point.
#
# A good guess: the data type of an SDF file (ISO 25178-71) does not decide what is missing. sdfio 2.0.0,
# which wrote the files, reads one missing point from each. Seen: -inf and none missing from the
# doubles, so that every mean and slope of the map is lost; one missing from the others.
source "$(dirname "$0")/lib/setup.sh"
python_packages sdfio==2.0.0 SurfaceTopography==1.27.1 numpy==2.4.6
expect 'missing: binary doubles 0 (least -inf), binary integers 1, text doubles 1; sdfio 1 1 1' \
   "$("$python" - <<'PY'
import warnings
import numpy as np
import sdfio
import SurfaceTopography

warnings.simplefilter("ignore")
heights = np.random.default_rng(0).normal(size=(5, 6)) * 1e-6
heights[2, 3] = np.nan
missing, least, own = [], [], []
for form, kind, scale in ((sdfio.FileFormat.BINARY, sdfio.DataType.BINARY64, 1.0),
                          (sdfio.FileFormat.BINARY, sdfio.DataType.INT32, 1e-14),
                          (sdfio.FileFormat.ASCII, sdfio.DataType.BINARY64, 1.0)):
    header = sdfio.Header(revision=sdfio.Revision.ISO_1_0, format=form, x_scale=1e-6,
                          y_scale=1e-6, z_scale=scale, data_type=kind)
    sdfio.SdfFile(header, heights).save("map.sdf")
    read = np.ma.asarray(SurfaceTopography.read_topography("map.sdf").heights(), dtype=float)
    missing.append(int(np.ma.getmaskarray(read).sum()))
    least.append(read.min())
    own.append(int(np.isnan(sdfio.read("map.sdf").data).sum()))
print(f"missing: binary doubles {missing[0]} (least {least[0]}), binary integers {missing[1]},"
      f" text doubles {missing[2]}; sdfio", *own)
PY
)"
