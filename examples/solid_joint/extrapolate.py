"""A number found on meshes of falling size, extrapolated to elements of no size."""

from typing import NamedTuple

# Orders between which a fitted one is believed: first order at kinks of contact and plastic rims, second
# of the elements in smooth fields
ORDERS = (1.0, 2.0)


class Limit(NamedTuple):
    """What a number tends to: the value, how far it may be off, and the order that was taken."""
    value: float
    uncertainty: float
    order: float


def at_order(sizes, values, order):
    """The limit of values that differ from it by a constant times size**order, from the last two."""
    coarse, fine = (size**order for size in sizes[-2:])
    return values[-1] + (values[-1] - values[-2])*fine/(coarse - fine)


def fitted_order(sizes, values):
    """The order at which the last three values lie on limit + constant*size**order; None where none does
    or it is not within ORDERS."""
    if len(values) < 3 or values[-1] == values[-2]:
        return None
    ratio = (values[-3] - values[-2])/(values[-2] - values[-1])

    def excess(order):
        first, second, third = (size**order for size in sizes[-3:])
        return (first - second)/(second - third) - ratio

    low, high = ORDERS
    # it rises with the order
    if not excess(low) <= 0.0 <= excess(high):
        return None
    while high - low > 1e-12:
        middle = 0.5*(low + high)
        low, high = (middle, high) if excess(middle) < 0.0 else (low, middle)
    return 0.5*(low + high)


def limit(sizes, values):
    """Richardson's extrapolation of values on meshes of falling sizes, two at least.

    The order is fitted to the last three; where that is not possible, or it is not between 1 and 2, it is
    1, which goes furthest. The uncertainty is the larger one of the distance between the finest value and
    the limit, and that between the limits of orders 1 and 2."""
    if len(values) < 2 or len(sizes) != len(values) or any(b >= a for a, b in zip(sizes, sizes[1:])):
        raise ValueError("values on two meshes at least, of falling sizes")
    order = fitted_order(sizes, values) or ORDERS[0]
    value = at_order(sizes, values, order)
    first, second = (at_order(sizes, values, each) for each in ORDERS)
    return Limit(value, max(abs(values[-1] - value), abs(first - second)), order)


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
