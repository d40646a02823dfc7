"""A number found on meshes of falling size, extrapolated to elements of no size."""

from typing import NamedTuple, Optional

# Orders that an extrapolation can use: from a half (Oberkampf and Roy, Verification and Validation in Scientific
# Computing, 2010, chapter 8) to the second of linear elements in smooth fields; from the first on, that of kinks of
# contact and plastic rims, it is believed
LOWEST, BELIEVED, HIGHEST = 0.5, 1.0, 2.0
# Factors of the grid convergence index (Roache, J. Fluids Eng. 116, 1994, 405): of an order that is believed, and
# of another one
BELIEVED_FACTOR, FACTOR = 1.25, 3.0


class Limit(NamedTuple):
    """What a number tends to: the value, how far it may be off, and the order; None is what cannot be told."""
    value: Optional[float]
    uncertainty: Optional[float]
    order: Optional[float]


def fitted_order(sizes, values):
    """The order, between 0 and 10, at which three values that go one way lie on limit + constant*size**order."""
    ratio = (values[0] - values[1])/(values[1] - values[2])

    def excess(order):
        first, second, third = (size**order for size in sizes)
        return (first - second)/(second - third) - ratio

    low, high = 1e-6, 10.0
    # it rises with the order
    while high - low > 1e-12:
        middle = 0.5*(low + high)
        low, high = (middle, high) if excess(middle) < 0.0 else (low, middle)
    return 0.5*(low + high)


def limit(sizes, values):
    """What values on three meshes of falling sizes tend to.

    Values that go one way have an order. From LOWEST to HIGHEST it gives the limit by Richardson's extrapolation,
    uncertain by BELIEVED_FACTOR or FACTOR times what the finest value is off. Below it nothing can be told. Where it is
    higher, or values turn, the finest one stands, uncertain by FACTOR times their range (Eca and Hoekstra, J. Mar. Sci.
    Technol. 13, 2008, 328)."""
    if len(values) != 3 or len(sizes) != 3 or any(b >= a for a, b in zip(sizes, sizes[1:])):
        raise ValueError("values on three meshes, of falling sizes")
    goes_one_way = (values[0] - values[1])*(values[1] - values[2]) > 0.0
    order = fitted_order(sizes, values) if goes_one_way else None
    if order is None or order > HIGHEST:
        return Limit(values[-1], FACTOR*(max(values) - min(values)), None)
    if order < LOWEST:
        return Limit(None, None, None)
    coarse, fine = (size**order for size in sizes[1:])
    change = (values[2] - values[1])*fine/(coarse - fine)
    return Limit(values[2] + change, (BELIEVED_FACTOR if order >= BELIEVED else FACTOR)*abs(change), order)


def interpolate(places, values, place):
    """A value between those of increments, by the parabola through the three nearest places."""
    near = sorted(range(len(places)), key=lambda i: abs(places[i] - place))[:3]
    total = 0.0
    for i in near:
        share = values[i]
        for j in near:
            if j != i:
                share *= (place - places[j])/(places[i] - places[j])
        total += share
    return total
