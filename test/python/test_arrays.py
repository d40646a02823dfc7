"""Arrays are not copied where that is not needed; threads run side by side; memory is freed."""

import resource
import threading
import time
import tracemalloc

import asperity
import numpy as np
import pytest
from asperity import _arrays
from conftest import wood


def test_inputs_pass_through():
    a = np.linspace(0.0, 1.0, 10)
    assert np.shares_memory(_arrays.given("a", a), a)
    for other in a[::2], a.astype(np.float32), a.astype(">f8"), np.asfortranarray(a.reshape(2, 5)):
        made = _arrays.given("a", other)
        assert made.flags.c_contiguous
        assert made.dtype == np.float64
        np.testing.assert_array_equal(made, other.astype(np.float64))


def test_no_copies(law):
    """With out= nothing of the size of the points is allocated."""
    n = 100_000
    contact, closure, slip = asperity.Contact(law, n), np.full(n, 0.1), np.zeros((2, n))
    turn = np.ascontiguousarray(np.broadcast_to(np.eye(2)[:, :, None], (2, 2, n)))
    response, values = asperity.Response.empty(n), asperity.LawValues.empty(n)
    contact.update(closure, slip, turn.swapaxes(0, 1), out=response)
    tracemalloc.start()
    contact.update(closure, slip, turn.swapaxes(0, 1), out=response)
    law.evaluate(closure, out=values)
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert most < 20_000
    assert response.traction[0, -1] > 0.0
    # and by lists or in another order there are copies, with the same results
    other = asperity.Contact(law, n).update(list(closure), np.asfortranarray(slip))
    np.testing.assert_array_equal(other.traction, response.traction)


def test_parts_of_results(law):
    contact = asperity.Contact(law, 4)
    out = asperity.Response.empty(4, "tangent")
    assert contact.update(np.full(4, 0.1), np.zeros((2, 4)), out=out) is out
    assert out.dissipation is None
    whole = asperity.Contact(law, 4).update(np.full(4, 0.1), np.zeros((2, 4)))
    np.testing.assert_array_equal(out.tangent, whole.tangent)
    values = law.evaluate([0.1, 0.2], out=asperity.LawValues.empty(2, "pressure", "energy"))
    assert values.area_fraction is None
    np.testing.assert_array_equal(values.energy, law.evaluate([0.1, 0.2]).energy)
    with pytest.raises(asperity.InputError, match="Response has no colour"):
        asperity.Response.empty(4, "colour")


def test_arrays_that_do_not_fit(law):
    contact = asperity.Contact(law, 4)

    def refuse(message, **arrays):
        out = asperity.Response.empty(4)
        for name, array in arrays.items():
            setattr(out, name, array)
        with pytest.raises(asperity.InputError, match=message):
            contact.update(np.full(4, 0.1), np.zeros((2, 4)), out=out)

    refuse(r"out.traction must be an array of float64 of the shape \(3, 4\)", traction=np.empty((4, 3)))
    refuse("out.traction must be", traction=[0.0]*12)
    refuse("out.dissipation must be", dissipation=np.empty(4, np.float32))
    refuse("out.validity must be an array of int32", validity=np.empty(4, np.int64))
    refuse("out.tangent cannot be written in place", tangent=np.empty((3, 3, 4)))
    refuse("out.dissipation cannot be written", dissipation=np.empty(8)[::2])
    frozen = np.empty(4)
    frozen.flags.writeable = False
    refuse("out.dissipation cannot be written", dissipation=frozen)
    same = np.empty(4)
    refuse("share memory|overlap", dissipation=same, pressure_coupling=same)
    refuse("traction is NULL", traction=None)


def test_threads():
    """Two threads with one law find what one finds."""
    law, n, turns = asperity.Law(wood()), 20_000, 4
    closure, slip = np.linspace(0.02, 0.15, n), np.full((2, n), 0.01)
    expected = asperity.Contact(law, n)
    for _ in range(turns):
        expected.update(closure, slip)
    contacts = [asperity.Contact(law, n) for _ in range(2)]

    def work(contact):
        for _ in range(turns):
            contact.update(closure, slip)

    threads = [threading.Thread(target=work, args=(contact,)) for contact in contacts]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for contact in contacts:
        np.testing.assert_array_equal(contact.states, expected.states)


def test_others_run_meanwhile():
    """While a thread is in the library, this one never waits nearly as long as the call takes."""
    law, d, times = asperity.Law(wood()), np.linspace(0.02, 0.3, 3_000_000), []

    def work():
        begin = time.perf_counter()
        law.evaluate(d)
        times.append(time.perf_counter() - begin)

    thread = threading.Thread(target=work)
    longest, last = 0.0, time.perf_counter()
    thread.start()
    while thread.is_alive():
        now = time.perf_counter()
        longest, last = max(longest, now - last), now
    thread.join()
    longest = max(longest, time.perf_counter() - last)
    assert longest < 0.5*times[0]


def test_handles_are_freed():
    """Points and laws that are made and dropped leave nothing of their hundreds of megabytes."""
    def peak():
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    for _ in range(3):
        asperity.Contact(asperity.Law(wood(compiled=True)), 200_000)
    before = peak()
    for _ in range(30):
        asperity.Contact(asperity.Law(wood(compiled=True)), 200_000).update(
            np.full(200_000, 0.1), np.zeros((2, 200_000)))
    assert peak() - before < 200_000  # kB
