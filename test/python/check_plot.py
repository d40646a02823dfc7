"""Pictures: names, units and the data of lines; how they look is for the eye."""

import sys
from pathlib import Path

import asperity
import matplotlib
import numpy as np
import pytest
from asperity import plot, program
from conftest import wood
from matplotlib import pyplot

matplotlib.use("agg")
EXAMPLES = Path(__file__).parents[2]/"examples"


@pytest.fixture(autouse=True)
def no_pictures_stay():
    yield
    pyplot.close("all")


@pytest.fixture(scope="module")
def joint():
    return program.tenon(amplitudes=[4, 8], cycles=[1, 1])


def labels(ax):
    return ax.get_xlabel(), ax.get_ylabel(), [line.get_label() for line in ax.get_lines()]


def test_pressure_of_a_law():
    law = asperity.Law(wood())
    ax = plot.pressure(law, color="black")
    assert labels(ax) == ("overclosure (mm)", "pressure (MPa)", ["law"])
    assert ax.get_legend() is None
    line, = ax.get_lines()
    closure, pressure = line.get_data()
    assert line.get_color() == "black"
    np.testing.assert_array_equal(pressure, law.pressure(4*0.0593 - closure))
    assert closure[0] == 0.0
    assert pressure[-1] == pytest.approx(0.2*24.53, rel=1e-9)
    assert plot.pressure(law, largest=1.0).get_lines()[0].get_ydata()[-1] == pytest.approx(1.0, rel=1e-9)


def test_labels_of_ones_own(joint):
    law = asperity.Law(wood())
    assert labels(plot.pressure(law, label="mine"))[2] == ["mine"]
    assert labels(plot.pressure(program.run("curve"), label="mine"))[2] == ["mine"]
    assert labels(plot.moment_rotation(joint.data.where(model="rough"), label="mine"))[2] == ["mine"]
    with pytest.raises(TypeError, match="dry is of the class Properties; it must be a Law or a Result"):
        plot.pressure({"law": law, "dry": wood()})


def test_pressures_together():
    """A law and what the program finds of the same faces lie on each other."""
    law = asperity.Law(wood())
    curve = program.run("curve", separation=np.linspace(0.09, 0.2, 12))
    ax = plot.pressure({"law": law, "program": curve})
    assert labels(ax)[2] == ["law", "program"]
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["law", "program"]
    closure, pressure = ax.get_lines()[1].get_data()
    np.testing.assert_allclose(pressure, law.pressure(4*0.0593 - closure), rtol=1e-12)
    assert plot.pressure(law, ax=ax) is ax
    assert len(ax.get_lines()) == 3


def test_pressures_of_tables():
    """A scan by both routes beside the sums over its summits; a record beside its model; a sweep."""
    scan = program.surface(generate=True, map_points=64, correlation_length=0.08, step=0.01, sq=0.005,
                           verify=True)
    assert labels(plot.pressure(scan))[2] == [
        "pressure paper", "pressure nayak", "pressure summits", "pressure own radii"]
    assert [line.get_linestyle() for line in plot.pressure(scan).get_lines()] \
        == ["-", "-", "None", "None"]
    swept = program.run("press", sweep={"sigma": [0.04, 0.06]})
    ax = plot.pressure(swept)
    assert labels(ax)[2] == ["sigma 0.04 mm", "sigma 0.06 mm"]
    np.testing.assert_array_equal(ax.get_lines()[1].get_ydata(),
                                  swept.data.where(sigma=0.06)["pressure"])
    with pytest.raises(asperity.InputError, match="shear has no pressures over an overclosure"):
        plot.pressure(program.run("shear", displacement=0.1))


def test_moment_rotation(joint):
    ax = plot.moment_rotation(joint)
    assert labels(ax) == ("rotation (rad)", "moment (kN m)", ["hard", "rough"])
    rough = joint.data.where(model="rough")
    np.testing.assert_array_equal(ax.get_lines()[1].get_data(), [rough["rotation"], rough["moment"]])


def test_moment_rotation_of_the_solid():
    solid = program.solid(EXAMPLES/"solid_joint/coarse.nml", mesh_size=60, amplitudes=[2], cycles=[1],
                          properties=wood())
    ax = plot.moment_rotation(solid)
    assert labels(ax) == ("rotation (rad)", "moment (kN m)", ["hard", "rough"])
    rough = solid.data.where(model="rough")
    np.testing.assert_array_equal(ax.get_lines()[1].get_data(), [rough["rotation"], rough["moment"]])
    assert rough["displacement"].max() == pytest.approx(2.0, rel=1e-12)
    assert rough["drift"].min() == pytest.approx(-2.0/solid.settings["arm"], rel=1e-12)
    assert rough["moment"].max() > 0.9*solid.data["moment"].max() > 0.0


def test_loops(joint):
    ax = plot.loops(joint.data.where(model="rough", cycle=2))
    assert labels(ax) == ("displacement (mm)", "force (N)", ["rough"])
    shear = program.run("shear", normal_stress=[0.05, 0.2], displacement=[1, -1])
    ax = plot.loops(shear)
    assert labels(ax) == ("displacement (mm)", "shear stress (MPa)", [
        "normal stress nominal 0.05 MPa", "normal stress nominal 0.2 MPa"])
    assert labels(plot.loops(shear, "slip", "area_fraction"))[:2] == ("slip (mm)", "area fraction")
    with pytest.raises(asperity.InputError, match="there is no strain; there are normal_stress_nominal"):
        plot.loops(shear, "strain", "shear_stress")
    with pytest.raises(asperity.InputError, match="x and y must be given, of"):
        plot.loops(joint.summary)


def test_without_matplotlib(monkeypatch, joint):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(ImportError, match="pip install matplotlib"):
        plot.moment_rotation(joint)
