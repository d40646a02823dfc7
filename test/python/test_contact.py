"""Contact points: values, tangents, energies, restarts, refusals."""

import copy
import pickle

import asperity
import numpy as np
import pytest
from conftest import wood

LAWS = {
    "plain": wood(),
    "compiled": wood(compiled=True),
    "memory": wood(unloading="elastic", compiled=True),
    "grain": wood(friction_coefficient_across=0.3, grain_angle=30.0, slip_direction="stress"),
    "decay": wood(static_friction_coefficient=0.8, decay_slip=0.2),
    "summits": wood(stick="summits", shear_modulus=60.0),
    "dissipative": wood(friction_rule="dissipative", slip_integration="backward_euler"),
}


def path(steps, points, seed=1):
    """Motions that close, slide, open and close again: overclosures and slip increments."""
    random = np.random.default_rng(seed)
    phase = random.uniform(0.0, 1.0, points)
    for step in range(steps):
        closure = 0.06 + 0.09*np.sin(0.4*step + 3.0*phase)
        yield closure, random.uniform(-0.1, 0.1, (2, points))


def test_against_the_law(law):
    closure = np.array([0.0, 0.05, 0.1, 0.15])
    response = asperity.Contact(law, 4).update(closure, np.zeros((2, 4)))
    values = law.evaluate(law.properties.initial_separation - closure)
    np.testing.assert_allclose(response.traction[0], values.pressure, rtol=1e-12)
    np.testing.assert_allclose(response.tangent[0, 0], values.stiffness, rtol=1e-9)
    assert not response.traction[1:].any()


def test_coulomb(law):
    """Elastic up to critical_slip, then mu p along the slip."""
    contact = asperity.Contact(law, 1)
    for slid in 0.0775, 0.155, 0.2325, 0.31, 0.3875, 0.465:
        traction = contact.update([0.1], [[0.0775*0.6], [0.0775*0.8]]).traction[:, 0]
        expected = 0.5*traction[0]*min(slid/0.31, 1.0)
        assert traction[1:] == pytest.approx([0.6*expected, 0.8*expected], rel=1e-9)
    assert contact.states["status"][0] == asperity.Status.SLIP
    open_ = contact.update([asperity.NO_OPPOSITE_SURFACE], np.zeros((2, 1)))
    assert not open_.traction.any()
    assert contact.states["status"][0] == asperity.Status.OPEN


@pytest.mark.parametrize("name", LAWS)
def test_tangent(name):
    """Differences of the tractions by each motion, from states within a path."""
    law, points, h = asperity.Law(LAWS[name]), 40, 1e-7
    contact = asperity.Contact(law, points)
    checked = 0
    for step, (closure, slip) in enumerate(path(12, points)):
        start = contact.copy()
        tangent = contact.update(closure, slip).tangent
        if step % 4 != 3:
            continue
        for column in range(3):
            ends = []
            for sign in 1.0, -1.0:
                trial = start.copy()
                motion = np.vstack([closure, slip])
                motion[column] += sign*h
                response = trial.update(motion[0], motion[1:])
                ends.append((response.traction, trial.states["status"]))
            difference = (ends[0][0] - ends[1][0])/(2.0*h)
            smooth = (ends[0][1] == ends[1][1]) & (ends[0][1] == contact.states["status"])
            size = np.abs(tangent).max() + 1.0
            assert np.abs(difference - tangent[:, column])[:, smooth].max() < 2e-5*size
            checked += smooth.sum()
    assert checked > 250


def energy_error(law, parts):
    """Work less what became of it over all that was turned over, along a path in small steps."""
    points = 8
    contact = asperity.Contact(law, points)
    work, turned, spent = np.zeros(points), np.zeros(points), np.zeros(points)
    traction, tangential, start = np.zeros((3, points)), np.zeros(points), np.zeros(points)
    for end, slip in path(5, points, seed=3):
        for part in range(parts):
            closure = start + (end - start)*(part + 1)/parts
            r = contact.update(closure, slip/parts)
            step = 0.5*(traction + r.traction)*np.vstack([(end - start)/parts, slip/parts])
            work += step.sum(axis=0)
            turned += np.abs(step).sum(axis=0)
            spent += r.dissipation + r.plastic_dissipation - r.pressure_coupling
            traction, tangential = r.traction, r.tangential_energy
        start = end
    return np.abs(work - contact.states["normal_energy"] - tangential - spent).max()/turned.max()


@pytest.mark.parametrize("name", LAWS)
def test_energies(name):
    """Work = stored + dissipated - coupled; what the trapezoidal rule leaves goes with the step."""
    law = asperity.Law(LAWS[name])
    errors = [energy_error(law, parts) for parts in (50, 200, 800)]
    # first order: where a point closes or begins to slip within a step
    assert errors[1] < 0.4*errors[0]
    assert errors[2] < 0.4*errors[1]
    assert errors[2] < 3e-4


def test_restart():
    """A run from saved states goes on bit by bit, also through pickle and copies."""
    for properties in LAWS.values():
        law = asperity.Law(properties)
        contact, motions = asperity.Contact(law, 6), list(path(20, 6))
        for motion in motions[:10]:
            contact.update(*motion)
        restarted = asperity.Contact(law, 6)
        restarted.states = contact.states
        others = [restarted, contact.copy(), copy.deepcopy(contact), pickle.loads(pickle.dumps(contact))]
        for motion in motions[10:]:
            expected = contact.update(*motion)
            for other in others:
                found = other.update(*motion)
                np.testing.assert_array_equal(found.traction, expected.traction)
                np.testing.assert_array_equal(found.tangent, expected.tangent)


def test_trials_from_a_start(law):
    """copy_from takes a trial back."""
    contact, motions = asperity.Contact(law, 3), list(path(3, 3))
    contact.update(*motions[0])
    start = contact.copy()
    first = contact.update(*motions[1]).traction
    contact.update(*motions[2])
    contact.copy_from(start)
    np.testing.assert_array_equal(contact.update(*motions[1]).traction, first)
    with pytest.raises(asperity.InputError, match="from has 2 points, to has 3"):
        contact.copy_from(asperity.Contact(law, 2))


def test_shapes(law):
    """Points of an array of two axes are those of one axis."""
    closure, slip = next(path(1, 6))
    flat = asperity.Contact(law, 6).update(closure, slip)
    contact = asperity.Contact(law, (2, 3))
    response = contact.update(closure.reshape(2, 3), slip.reshape(2, 2, 3))
    assert response.tangent.shape == (3, 3, 2, 3)
    np.testing.assert_array_equal(response.tangent.reshape(3, 3, 6), flat.tangent)
    np.testing.assert_array_equal(response.traction.reshape(3, 6), flat.traction)
    assert contact.states.shape == (2, 3)
    none = asperity.Contact(law, 0)
    assert none.update(np.empty(0), np.empty((2, 0))).traction.shape == (3, 0)
    assert none.states.shape == (0,)


def test_rotation():
    """A quarter turn takes the shear stress from the first direction to the second."""
    contact = asperity.Contact(asperity.Law(wood()), 2)
    before = contact.update([0.1, 0.1], [[0.1, 0.1], [0.0, 0.0]]).traction
    turn = np.zeros((2, 2, 2))
    turn[:, :, 0] = [[0.0, -1.0], [1.0, 0.0]]
    turn[:, :, 1] = np.eye(2)
    after = contact.update([0.1, 0.1], np.zeros((2, 2)), turn).traction
    assert after[1:, 0] == pytest.approx([0.0, before[1, 0]], abs=1e-15)
    assert after[1:, 1] == pytest.approx([before[1, 1], 0.0], abs=1e-15)
    assert before[1, 0] > 0.0


def test_time():
    """A slip rate at which friction has decayed, and none: the time increment arrives."""
    law = asperity.Law(wood(static_friction_coefficient=1.0, decay_slip_rate=1.0))
    shear = [asperity.Contact(law, 1).update([0.1], [[2.0], [0.0]], time_increment=t).traction
             for t in (0.0, 0.02, 1.0e-4)]
    ratios = [float(t[1, 0]/t[0, 0]) for t in shear]
    assert ratios[0] == pytest.approx(1.0, rel=1e-9)
    assert ratios[1] == pytest.approx(0.5, rel=1e-9)
    assert ratios[2] == pytest.approx(0.5, rel=1e-9)


@pytest.mark.parametrize(("arguments", "message"), [
    (([0.1]*3, np.zeros((2, 2))), r"overclosure has the shape \(3,\); it must be \(2,\)"),
    (([0.1, 0.1], 0.0), r"slip_increment has the shape \(\); it must be \(2, 2\)"),
    (([0.1, 0.1], np.zeros((1, 2))), r"slip_increment has the shape \(1, 2\); it must be \(2, 2\)"),
    (([0.1, 0.1], np.zeros((2, 2)), 1.0), "rotation has the shape"),
    (([0.1, 0.1], np.zeros((2, 2)), np.ones(4)), "rotation has the shape"),
    (([0.1, 0.1j], np.zeros((2, 2))), "overclosure has the type complex128; it must be real numbers"),
    (([0.1, None], np.zeros((2, 2))), "overclosure has the type object"),
    (([0.1, [0.1, 0.2]], np.zeros((2, 2))), "overclosure is no array"),
    (([0.1, 0.1], np.zeros((2, 2)), None, "1"), "time_increment = '1' is not allowed: it must be a number"),
    (([0.1, np.nan], np.zeros((2, 2))), "overclosure"),
    (([0.1, 0.1], np.full((2, 2), np.inf)), "slip_increment"),
    (([0.1, 0.1], np.zeros((2, 2)), np.zeros((2, 2, 3))), "rotation has the shape"),
    (([0.1, 0.1], np.zeros((2, 2)), None, -1.0), "time_increment = -1"),
])
def test_refusals(law, arguments, message):
    """Nothing has changed after one."""
    contact = asperity.Contact(law, 2)
    contact.update([0.05, 0.1], np.full((2, 2), 0.01))
    states = contact.states
    with pytest.raises(asperity.InputError, match=message):
        contact.update(*arguments)
    np.testing.assert_array_equal(contact.states, states)


def test_states_that_no_update_leaves(law):
    contact = asperity.Contact(law, 3)
    with pytest.raises(ValueError, match="read-only"):
        contact.states["status"][1] = asperity.Status.OPEN  # which would change no point
    states = contact.states.copy()
    states["status"][1] = 9
    with pytest.raises(asperity.InputError, match=r"status = 9 of state\[1\]"):
        contact.states = states
    with pytest.raises(asperity.InputError, match="states has the shape"):
        contact.states = states[:2]
    kinds = [(name, states.dtype[name]) for name in states.dtype.names]
    for other in np.zeros(3), None, states.astype([*kinds[:-1], ("wear", kinds[-1][1])]):
        with pytest.raises(asperity.InputError, match="states has the type"):
            contact.states = other
    assert not contact.states["status"].any()


def test_numbers_of_points(law):
    for shape in -1, (2, -1), (-2, -1):
        with pytest.raises(asperity.InputError, match="numbers of points are zero or more"):
            asperity.Contact(law, shape)
    with pytest.raises(asperity.InputError, match="too many"):
        asperity.Contact(law, 2**31)
    for shape in 1.5, (2.0, 3), None:
        with pytest.raises(TypeError):
            asperity.Contact(law, shape)
    contact = asperity.Contact(law, [2, np.int64(3)])
    assert contact.shape == (2, 3)
    # arrays of another shape would be written past their end
    with pytest.raises(AttributeError):
        contact.shape = (2,)


def test_what_is_no_law_or_answer(law):
    for other in None, wood():
        with pytest.raises(TypeError, match="it must be a Law"):
            asperity.Contact(other, 3)
    contact = asperity.Contact(law, 3)
    for out in {}, asperity.LawValues.empty(3), np.empty((3, 3)):
        with pytest.raises(TypeError, match=r"it must be made by Response.empty\(\)"):
            contact.update(0.1, [0.0, 0.0], out=out)
    assert repr(contact).startswith("<Contact of the shape (3,): Law(Properties(")


def test_one_value_for_all_points(law):
    """A number, a slip, a rotation, and lengths of 1."""
    turn = np.array([[0.8, -0.6], [0.6, 0.8]])
    whole = asperity.Contact(law, (2, 3)).update(
        np.full((2, 3), 0.1), np.multiply.outer([0.1, 0.05], np.ones((2, 3))),
        np.multiply.outer(turn, np.ones((2, 3))))
    for closure, slip, rotation in (
            (0.1, [0.1, 0.05], turn),
            (np.array(0.1, np.longdouble), np.reshape([0.1, 0.05], (2, 1, 1)), turn[:, :, None, None]),
            (np.full((2, 1), 0.1), np.reshape([0.1, 0.05]*3, (3, 2)).T[:, None, :], turn)):
        response = asperity.Contact(law, (2, 3)).update(closure, slip, rotation)
        np.testing.assert_array_equal(response.traction, whole.traction)
        np.testing.assert_array_equal(response.tangent, whole.tangent)
    assert asperity.Contact(law, ()).update(0.1, [0.1, 0.05], turn).traction.tolist() \
        == whole.traction[:, 0, 0].tolist()


def test_copies_share_the_law(law):
    contact = asperity.Contact(law, 2)
    assert copy.copy(contact).law is law
    assert copy.deepcopy(contact).law is law


def test_handles_end(law):
    with asperity.Contact(law, 1) as contact:
        contact.update([0.1], np.zeros((2, 1)))
    with pytest.raises(asperity.InputError, match="this contact is closed"):
        contact.update([0.1], np.zeros((2, 1)))
    gone = asperity.Law(wood())
    contact = asperity.Contact(gone, 1)
    gone.close()
    with pytest.raises(asperity.InputError, match="this law is closed"):
        contact.update([0.1], np.zeros((2, 1)))
