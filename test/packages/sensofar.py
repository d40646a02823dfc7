"""Files of Sensofar's microscopes: by the layout that src/height_map/plu has, and real ones."""

import hashlib
import struct
import urllib.error
import urllib.request
import zipfile

import numpy as np

# Test data of other readers, at a commit, with their SHA-256
REAL = {
    "plu-1.plu": (
        "ContactEngineering/SurfaceTopography/119cb66ade8917a0a62a878c82d459f959566760/"
        "test/file_format_examples/plu-1.plu",
        "8ed6026dee4fc1d65c78e0bd9e1b9a760926bf18a3ce8e3dc5960478558cfab0"),
    "test_1.plu": (
        "fredericjs/surfalize/f037904592486dfa15b5f13a99343465f3dcfa6e/tests/test_files/test_1.plu",
        "d54b40acdb1d350ca0d5f645ae1368766e8ece579e7460fad69b45ed7e92391b")}


def real_files(folder):
    """Paths of the scans that are there, fetched if the network gives them."""
    for name, (place, digest) in REAL.items():
        path = folder/name
        if not path.exists():
            try:
                with urllib.request.urlopen(f"https://raw.githubusercontent.com/{place}",
                                            timeout=20) as answer:
                    path.write_bytes(answer.read())
            except (urllib.error.URLError, TimeoutError) as problem:
                print(f"     left out: {name}, which cannot be fetched: {problem}")
                continue
        if hashlib.sha256(path.read_bytes()).hexdigest() == digest:
            yield path
        else:
            print(f"     left out: {name}, which is not the file that was meant")


def write_plu(m, path):
    """PLU: lengths in um, 1000001 where a point is missing."""
    ny, nx = m.heights.shape
    heights = np.nan_to_num(m.heights, nan=1000001.0).astype("<f4")
    with open(path, "wb") as file:
        file.write(struct.pack("<128sI256s", b"Mon Nov 30 09:15:00 2026", 1796030100, b"(None)"))
        file.write(struct.pack("<3I7f", ny, nx, nx, 1, m.step_x, m.step_y, 0, 0, m.step_x, 0))
        # a topography, and settings
        file.write(struct.pack("<5I5IdfII", 3, 3, 0, 14, 3, ny, nx, ny, nx, 1, 0.1, 50, 23, 0))
        file.write(struct.pack("<5B3xI", 0, 1, 251, 6, 1, 1))
        file.write(struct.pack("<2I", ny, nx) + heights.tobytes())
        file.write(struct.pack("<2f", np.nanmin(m.heights), np.nanmax(m.heights)))
        # the image
        file.write(bytes(3*nx*ny))


def write_plux(m, path):
    """PLUX: lengths in um, NaN where a point is missing."""
    ny, nx = m.heights.shape
    index = ("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<xml>\n <GENERAL>\n"
             "  <DATE>Mon Nov 30 09:15:00 2026</DATE>\n"
             f"  <IMAGE_SIZE_X>{nx}</IMAGE_SIZE_X>\n  <IMAGE_SIZE_Y>{ny}</IMAGE_SIZE_Y>\n"
             f"  <FOV_X>{m.step_x}</FOV_X>\n  <FOV_Y>{m.step_y}</FOV_Y>\n </GENERAL>\n"
             " <LAYER_0>\n  <FILENAME_STACK>LAYER_0.stack.raw</FILENAME_STACK>\n"
             "  <FILENAME_Z>LAYER_0.raw</FILENAME_Z>\n </LAYER_0>\n <INFO>\n"
             "  <ITEM_0><NAME>Device</NAME><VALUE>S neox</VALUE></ITEM_0>\n </INFO>\n</xml>\n")
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("LAYER_0.raw", m.heights.astype("<f4").tobytes())
        archive.writestr("LAYER_0.stack.raw", bytes(3*nx*ny))
        archive.writestr("index.xml", index)
        archive.writestr("recipe.txt", "<xml><RECIPE>none</RECIPE></xml>")
