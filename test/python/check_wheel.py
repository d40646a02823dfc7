"""The installed wheel, made portable: what it holds, and that it needs no library of the system's but
the C library's. Not among the tests that a plain `pip install` passes."""

import re
import sysconfig
from importlib import metadata
from pathlib import Path

import asperity

PACKAGE = metadata.distribution("asperity")
PROJECT = Path(__file__).parents[2]


def test_libraries():
    """The C interface and the run-time libraries of gfortran, none under the GPL alone."""
    libraries = {re.sub(r"(-[0-9a-f]{8})?\.so.*", "", file.name) for file in PACKAGE.files
                 if ".so" in file.name}
    assert libraries == {"libasperity_c", "libgfortran", "libquadmath"}


def test_loaded_libraries():
    """What the process has in memory of these comes from the wheel; numpy has its own of some."""
    maps = Path("/proc/self/maps").read_text(encoding="utf-8")
    loaded = set(re.findall(r"/\S*lib(?:asperity|gfortran|quadmath)\S*", maps))
    packages = sysconfig.get_paths()["platlib"]
    assert all(path.startswith(packages) for path in loaded), loaded
    assert len([path for path in loaded if path.startswith(packages + "/asperity")]) == 3


def test_licences():
    texts = {file.name: file.read_text() for file in PACKAGE.files if "licenses" in file.parts}
    assert texts["LICENSE"] == (PROJECT / "LICENSE").read_text(encoding="utf-8")
    assert "GCC Runtime Library Exception" in texts["LICENSE_BUNDLED"]


def test_metadata():
    assert re.search(r"^Tag: py3-none-manylinux_2_\d+_", PACKAGE.read_text("WHEEL"), re.MULTILINE)
    assert PACKAGE.version == asperity.__version__
    assert [r for r in PACKAGE.requires if "extra" not in r] == ["numpy>=1.24"]
    assert "asperity/py.typed" in map(str, PACKAGE.files)
