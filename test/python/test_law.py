"""The law: reference values, derivatives, energies, memory, properties."""

import copy
import csv
import dataclasses
import pickle
from pathlib import Path

import asperity
import numpy as np
import pytest
from conftest import wood

DATA = Path(__file__).parents[1] / "data"


def rows(name):
    with open(DATA / name, encoding="utf-8") as file:
        return list(csv.DictReader(file))


def law_of(row, **changes):
    names = ("sigma", "eta", "modulus", "radius", "hardness", "yield_factor")
    return asperity.Law(asperity.Properties(
        **{name: float(row[name]) for name in names}, friction_coefficient=0.5, critical_slip=0.3,
        accept_unphysical=True, **changes))


def test_reference_values():
    """High-precision values, to the error that docs/equations.md gives."""
    names = ("pressure", "stiffness", "area_fraction", "contact_density", "energy")
    for row in rows("normal_law_reference.csv"):
        values = law_of(row).evaluate(float(row["separation"]))
        for name in names:
            assert getattr(values, name) == pytest.approx(float(row[name]), rel=1e-12), row


def test_shapes(law):
    for shape in (), (4,), (2, 3), (0,):
        values = law.evaluate(np.full(shape, 0.1))
        for field in dataclasses.fields(values):
            assert getattr(values, field.name).shape == shape
        assert law.pressure(np.full(shape, 0.1)).shape == shape
    # one row by another: no order is mixed up
    d = np.linspace(0.02, 0.2, 6).reshape(2, 3)
    np.testing.assert_array_equal(law.evaluate(d.T).pressure, law.evaluate(d).pressure.T)
    np.testing.assert_array_equal(law.evaluate(d[:, ::2]).energy, law.evaluate(d).energy[:, ::2])
    assert law.evaluate([0, 1]).pressure.shape == (2,)


def test_stiffness_is_the_derivative():
    law = asperity.Law(wood())
    d, h = np.linspace(0.03, 0.22, 40), 1e-6
    values = law.evaluate(d)
    difference = (law.pressure(d - h) - law.pressure(d + h))/(2.0*h)
    np.testing.assert_allclose(values.stiffness, difference, rtol=1e-7)
    # and the pressure of the work
    work = (law.evaluate(d - h).energy - law.evaluate(d + h).energy)/(2.0*h)
    np.testing.assert_allclose(values.pressure, work, rtol=1e-7)


def test_compiled_and_direct(law):
    d = np.linspace(0.0, 0.3, 200)
    np.testing.assert_allclose(law.pressure(d), asperity.Law(wood()).pressure(d), rtol=1e-9)


def test_separation(law):
    p = np.array([[1e-6, 0.2], [3.0, 20.0]])
    d = law.separation(p)
    assert d.shape == p.shape
    np.testing.assert_allclose(law.pressure(d), p, rtol=1e-9)
    with pytest.raises(asperity.InputError, match="pressure"):
        law.separation(-1.0)


def test_memory():
    """Unloading values: reference, derivative, energy."""
    law = asperity.Law(wood(unloading="elastic"))
    closest, r, h = np.full(30, 0.08), np.linspace(0.0, 0.05, 30)[:], 1e-7
    values = law.evaluate_unloading(closest, r)
    first = law.evaluate(closest)
    assert values.pressure[0] == pytest.approx(first.pressure[0], rel=1e-12)
    # what was put in is stored or dissipated
    assert values.energy[0] + values.plastic_dissipation[0] == pytest.approx(first.energy[0], rel=1e-9)
    up, down = law.evaluate_unloading(closest, r + h), law.evaluate_unloading(closest, r - h)
    inner = slice(2, -2)
    np.testing.assert_allclose(values.stiffness[inner], ((down.pressure - up.pressure)/(2*h))[inner],
                               rtol=1e-5)
    np.testing.assert_allclose(values.pressure[inner], ((down.energy - up.energy)/(2*h))[inner],
                               rtol=1e-5)
    assert np.all(values.plastic_dissipation == values.plastic_dissipation[0])
    assert values.pressure[-1] < 0.1*values.pressure[0]
    with pytest.raises(asperity.InputError, match="retraction has the shape"):
        law.evaluate_unloading(closest, r[:3])
    np.testing.assert_array_equal(law.evaluate_unloading(0.08, r).pressure, values.pressure)
    np.testing.assert_array_equal(law.evaluate_unloading([[0.08], [0.1]], r).pressure[0], values.pressure)
    with pytest.raises(asperity.InputError, match="unloading"):
        asperity.Law(wood()).evaluate_unloading(closest, r)


def test_values_of_one_kind_are_not_written_as_the_other():
    law = asperity.Law(wood(unloading="elastic"))
    more = asperity.UnloadingValues.empty(3)
    more.plastic_dissipation[:] = 7.0
    law.evaluate([0.1, 0.1, 0.1], out=more)
    assert np.all(more.plastic_dissipation == 7.0)


def test_properties_of_a_law(law):
    # a law that exists has been accepted
    given = wood(compiled=True, accept_unphysical=True)
    kept = law.properties
    assert kept.initial_separation == 4.0*given.sigma
    assert dataclasses.replace(kept, initial_separation=given.initial_separation) == given


def test_every_property_reaches_the_law():
    """What goes in comes out, so no member is left or mixed up."""
    given = wood(
        initial_separation=0.25, friction_rule="dissipative", slip_integration="backward_euler",
        accept_unphysical=True, plastic_ratio=54.0, height_distribution="johnson",
        skewness=0.3, kurtosis=3.61, static_friction_coefficient=0.75, decay_slip=0.125,
        decay_slip_rate=2.0, friction_coefficient_across=0.25, grain_angle=30.0,
        slip_direction="stress", shear_limit=0.7, friction_pressures=(0.125, 1.5),
        friction_factors=(1.25, 0.5))
    assert asperity.Law(given).properties == given
    other = wood(accept_unphysical=True, pressure_exponent=-0.25, reference_pressure=2.0,
                 stick="summits", stick_elements=6, shear_modulus=31.6, compiled=True,
                 initial_separation=0.3)
    assert asperity.Law(other).properties == other
    memory = wood(unloading="elastic", accept_unphysical=True, initial_separation=0.0)
    assert asperity.Law(memory).properties == memory
    default = wood()
    for field in dataclasses.fields(given):
        if field.name not in ("eta", "modulus", "radius", "hardness", "yield_factor", "sigma",
                              "friction_coefficient", "critical_slip"):
            values = {getattr(p, field.name) for p in (given, other, memory, default)}
            assert len(values) > 1, field.name


def test_properties_are_values():
    given = wood(friction_pressures=(0.1, 1.0), friction_factors=(1.2, 0.8))
    assert pickle.loads(pickle.dumps(given)) == given == copy.deepcopy(given)
    assert hash(given) == hash(copy.copy(given))
    assert eval(repr(given), {"Properties": asperity.Properties}) == given
    assert "grain_angle" not in repr(given)
    with pytest.raises(dataclasses.FrozenInstanceError):
        given.sigma = 1.0
    law = pickle.loads(pickle.dumps(asperity.Law(given)))
    assert law.pressure(0.1) == asperity.Law(given).pressure(0.1)


def test_properties_of_arrays():
    """Numbers of numpy and lists are values as Python's own are."""
    plain = wood(eta=200.0, sigma=0.05, compiled=True, stick="summits", stick_elements=6, shear_modulus=60.0,
                 friction_pressures=(1.0, 2.0), friction_factors=(1.0, 0.9))
    other = wood(eta=np.int64(200), sigma=np.array(0.05), compiled=np.True_, stick="summits",
                 stick_elements=np.int32(6), shear_modulus=60, friction_pressures=[1, 2],
                 friction_factors=np.array([1.0, 0.9]))
    assert other == plain
    assert hash(other) == hash(plain)
    assert repr(other) == repr(plain)
    assert asperity.Law(other).pressure(0.1) == asperity.Law(plain).pressure(0.1)


@pytest.mark.parametrize(("changes", "message"), [
    ({"sigma": "0.05"}, "sigma = '0.05' is not allowed: it must be a number"),
    ({"sigma": None}, "sigma = None"),
    ({"sigma": np.array([0.05])}, "sigma = array"),
    ({"sigma": 0.05 + 1j}, "sigma = .* it must be a number"),
    ({"compiled": "no"}, "compiled = 'no' is not allowed: it must be True or False"),
    ({"stick_elements": 2**40}, "stick_elements = 1099511627776 is not allowed"),
    ({"stick_elements": 8.0}, "stick_elements = 8.0 is not allowed: it must be a whole number"),
    ({"friction_pressures": ("a",)}, "friction_pressures has the type"),
    ({"stick": ["summits"]}, "it must be one of critical_slip, summits"),
    ({"sigma": -1.0}, "sigma = -1"),
    ({"sigma": float("nan")}, "sigma = NaN"),
    ({"friction_rule": "coulomb"}, "friction_rule = 'coulomb' is not allowed: it must be one of "
                                   "abaqus, dissipative"),
    ({"friction_pressures": (1.0, 2.0)}, "2 friction_pressures and 0 friction_factors"),
    ({"friction_pressures": (1.0,)*9, "friction_factors": (1.0,)*9}, "up to 8"),
    ({"stick": "summits"}, "shear_modulus"),
    ({"plastic_ratio": 1.0}, "plastic_ratio"),
])
def test_refusals(changes, message):
    with pytest.raises(asperity.InputError, match=message):
        asperity.Law(wood(**changes))


@pytest.mark.parametrize("values", [
    np.array([0.1 + 1.0j]), "0.1", [0.1, None], np.array(["2020-01-01"], "M8[D]"), [[0.1], [0.1, 0.2]]])
def test_what_is_no_number(law, values):
    for evaluate in law.evaluate, law.pressure, law.separation:
        with pytest.raises(asperity.InputError):
            evaluate(values)


def test_what_is_no_property():
    for other in None, {"sigma": 0.05}:
        with pytest.raises(TypeError, match="it must be Properties"):
            asperity.Law(other)
    with pytest.raises(asperity.InputError, match="hardness = '2' is not allowed"):
        asperity.Face(young_modulus=1.0, poisson_ratio=0.3, hardness="2")


def test_pickles_of_another_version():
    """A property that this version does not know is refused, not forgotten."""
    made, arguments = wood().__reduce__()[:2]
    made.keywords["wear_rate"] = 0.1
    assert arguments == ()
    with pytest.raises(TypeError, match="wear_rate"):
        made()


def test_names_that_are_not_there():
    with pytest.raises(asperity.InputError, match="known pairs: transverse-tangential"):
        asperity.Properties.from_pair("oak")
    with pytest.raises(asperity.InputError, match="unpolished-cross"):
        asperity.Face.from_paper("oak", "transverse")
    with pytest.raises(asperity.InputError, match="section = 'top'"):
        asperity.Face.from_paper("unpolished-cross", "top")
    with pytest.raises(TypeError):
        wood(colour="red")


def test_faces():
    """E* by Eq. 4, the softer hardness, spectral moments that add: by hand."""
    one = asperity.Face(sigma=0.04, radius=0.1, eta=150.0, young_modulus=600.0, poisson_ratio=0.3,
                        hardness=25.0)
    smooth = asperity.Face(young_modulus=2.0e5, poisson_ratio=0.25, hardness=2000.0)
    pair = asperity.Properties.from_faces(one, smooth, roughness_rule="face_1", compiled=True)
    modulus = 1.0/((1.0 - 0.3**2)/600.0 + (1.0 - 0.25**2)/2.0e5)
    assert pair.modulus == pytest.approx(modulus, rel=1e-14)
    assert (pair.hardness, pair.sigma, pair.radius, pair.eta) == (25.0, 0.04, 0.1, 150.0)
    assert pair.compiled
    assert asperity.Properties.from_faces(
        smooth, one, hardness_rule="harder", roughness_rule="face_2").hardness == 2000.0
    both = asperity.Properties.from_faces(one, one)
    # the moments double: radius falls by the square root of two, density stays
    assert both.radius == pytest.approx(0.1/2.0**0.5, rel=1e-9)
    assert both.eta == pytest.approx(150.0, rel=1e-9)
    cross = asperity.Face.from_paper("unpolished-cross", "transverse")
    assert cross.sigma > 0.0
    with pytest.raises(asperity.InputError, match="hardness"):
        asperity.Face.from_paper("unpolished-cross", "radial")


def test_handles_end():
    with asperity.Law(wood()) as law:
        assert law.pressure(0.1) > 0.0
    for action in (lambda: law.pressure(0.1), lambda: law.properties, lambda: law.separation(1.0)):
        with pytest.raises(asperity.InputError, match="this law is closed"):
            action()
    law.close()  # again does nothing


def test_remarks():
    assert asperity.Validity(0).remark == ""
    assert "hardness" in asperity.Validity.PRESSURE_ABOVE_HARDNESS.remark
    deep = asperity.Law(wood()).evaluate(-0.1)
    assert asperity.Validity(int(deep.validity)) & asperity.Validity.PRESSURE_ABOVE_HARDNESS
