#!/usr/bin/env python3
"""Parameters of a surface, computed a second time: every definition of docs/surfaces.md as it is
written, in numpy, sharing nothing with the library.

    python3 surface_statistics.py MAP.txt STEP_X STEP_Y [SHARE]

MAP.txt is a bare matrix of heights in mm, one profile along x a line, `nan` where nothing was
measured; steps are in mm; SHARE of Sz is what Wolf pruning takes away, 0.05 unless it is given.
It prints `name,value`. Needs numpy.

Method, where there is a choice: means over arrays instead of sums over tiles; hills by steepest
ascent and their change tree pruned leaf by leaf, the lowest first, as Wolf's rule is written,
instead of by flooding.
"""
import heapq
import math
import sys

import numpy as np

AROUND = [(dj, di) for dj in (-1, 0, 1) for di in (-1, 0, 1) if (dj, di) != (0, 0)]
# Nayak: of the mean square height of the summits of an isotropic Gaussian surface, in m0/alpha
NAYAK_C = 1 - 3*math.sqrt(3) + 16/math.pi


def level(z, step_x, step_y, degree=1):
    """Heights z[j, i] less their least-squares polynomial of a total degree in x and y."""
    y, x = np.meshgrid(np.arange(z.shape[0])*step_y, np.arange(z.shape[1])*step_x, indexing="ij")
    x, y = 2*x/x.max() - 1, 2*y/y.max() - 1
    columns = np.stack([x**a*y**b for a in range(degree + 1) for b in range(degree + 1 - a)], -1)
    there = np.isfinite(z)
    weights = np.linalg.lstsq(columns[there], z[there], rcond=None)[0]
    return z - columns @ weights


def smoothed(z, cutoff_x, cutoff_y):
    """The Gaussian filter of ISO 16610-61 on a full map, cutoffs in steps. At its ends the value is
    that of the line fitted with the weights that are left, along x and then along y."""
    return lines(z.shape[0], cutoff_y) @ z @ lines(z.shape[1], cutoff_x).T


def lines(points, cutoff):
    """Matrix of the filter of lines of so many points."""
    away = np.arange(points)[None, :] - np.arange(points)[:, None]
    weight = np.exp(-math.pi*away**2/(math.log(2)/math.pi*cutoff**2))
    moment = [(weight*away**p).sum(axis=1, keepdims=True) for p in range(3)]
    return weight*(moment[2] - moment[1]*away)/(moment[0]*moment[2] - moment[1]**2)


def shifted(z, dj, di):
    """z at the neighbour (j + dj, i + di), nan outside."""
    around = np.full((z.shape[0] + 2, z.shape[1] + 2), np.nan)
    around[1:-1, 1:-1] = z
    return around[1 + dj:1 + dj + z.shape[0], 1 + di:1 + di + z.shape[1]]


def inner(z):
    """Measured points with eight measured neighbours."""
    there = np.isfinite(z)
    for dj, di in AROUND:
        there &= np.isfinite(shifted(z, dj, di))
    return there


def heights_in_order(z):
    """Rank of every point, 0 the lowest; of equal heights the later one is the higher."""
    rank = np.empty(z.size, dtype=np.int64)
    rank[np.argsort(np.where(np.isfinite(z), z, -np.inf).ravel(), kind="stable")] = \
        np.arange(z.size)
    return rank.reshape(z.shape)


def derivatives(z, step_x, step_y):
    """Central differences where all eight neighbours are there: z_x, z_y, z_xx, z_yy, z_xy."""
    def at(dj, di):
        return shifted(z, dj, di)
    return ((at(0, 1) - at(0, -1))/(2*step_x), (at(1, 0) - at(-1, 0))/(2*step_y),
            (at(0, 1) - 2*z + at(0, -1))/step_x**2, (at(1, 0) - 2*z + at(-1, 0))/step_y**2,
            (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1))/(4*step_x*step_y))


def summits(z):
    """Which inner points are higher than all eight neighbours."""
    rank, found = heights_in_order(z), inner(z)
    for dj, di in AROUND:
        found &= rank > np.nan_to_num(shifted(rank.astype(float), dj, di), nan=-1.0)
    return found


def hills(z):
    """Number of the hill that steepest ascent leads to from every point, -1 where there is none,
    and the place of each hill's top in the flattened map."""
    rank, there = heights_in_order(z), np.isfinite(z)
    best, towards = rank.copy(), np.arange(z.size).reshape(z.shape)
    places = np.arange(z.size, dtype=float).reshape(z.shape)
    for dj, di in AROUND:
        other = np.where(np.isfinite(shifted(z, dj, di)),
                         np.nan_to_num(shifted(rank.astype(float), dj, di)), -1)
        higher = other > best
        best = np.where(higher, other, best)
        towards = np.where(higher, np.nan_to_num(shifted(places, dj, di)), towards)
    towards = towards.ravel().astype(np.int64)
    while True:
        further = towards[towards]
        if np.array_equal(further, towards):
            break
        towards = further
    tops, number = np.unique(towards[there.ravel()], return_inverse=True)
    hill = np.full(z.size, -1, dtype=np.int64)
    hill[there.ravel()] = number
    return hill.reshape(z.shape), tops


def saddles(z, hill):
    """[{other hill: height of the highest saddle to it}] of each hill."""
    found = [{} for _ in range(hill.max() + 1)]
    for dj, di in ((0, 1), (1, -1), (1, 0), (1, 1)):
        other = np.nan_to_num(shifted(hill.astype(float), dj, di), nan=-1.0).astype(np.int64)
        height = np.fmin(z, shifted(z, dj, di))
        edge = (hill >= 0) & (other >= 0) & (hill != other)
        for a, b, h in zip(hill[edge], other[edge], height[edge]):
            if h > found[a].get(b, -np.inf):
                found[a][b] = found[b][a] = h
    return found


def wolf_peaks(z, share=0.05):
    """Tops that Wolf pruning leaves, wherever they are: the lowest hill, measured from its top to
    its highest saddle, joins the hill beyond that saddle, until none is lower than share*Sz."""
    hill, tops = hills(z)
    beside = saddles(z, hill)
    rank = heights_in_order(z).ravel()
    limit = share*(np.nanmax(z) - np.nanmin(z))
    top = list(tops)
    height = z.ravel()

    def entry(a):
        if not beside[a]:
            return np.inf, a, None, None
        to, saddle = max(beside[a].items(), key=lambda item: (item[1], rank[top[item[0]]]))
        # of two that are equally low the one with the lower top goes first
        return height[top[a]] - saddle, rank[top[a]], a, (to, top[a], saddle)

    heap = [e for e in map(entry, range(len(tops))) if e[0] < np.inf]
    heapq.heapify(heap)
    alive = [True]*len(tops)
    while heap:
        low, _, a, was = heapq.heappop(heap)
        if not alive[a]:
            continue
        now = entry(a)
        if now[3] != was:
            if now[0] < np.inf:
                heapq.heappush(heap, now)
            continue
        if not low < limit:
            break
        to = was[0]
        alive[a] = False
        for other, saddle in beside[a].items():
            del beside[other][a]
            if other != to:
                beside[other][to] = beside[to][other] = max(saddle, beside[to].get(other, -np.inf))
        beside[a] = {}
        if rank[top[a]] > rank[top[to]]:
            top[to] = top[a]
        for changed in {to, *beside[to]}:
            new = entry(changed)
            if new[0] < np.inf:
                heapq.heappush(heap, new)
    peaks = np.zeros(z.size, dtype=bool)
    peaks[[top[a] for a in range(len(tops)) if alive[a]]] = True
    return peaks.reshape(z.shape)


def statistics(heights, step_x, step_y, share=0.05, degree=1):
    """{parameter: value}, in mm; heights[j, i] in mm, nan where nothing was measured. Degree 0 is
    for points taken from a levelled map: they keep its plane, of whose heights sa, sp and sv are;
    the rest is about their mean."""
    z = level(heights, step_x, step_y, degree) if degree else heights
    within = inner(z)
    p = {"sa": np.nanmean(abs(z)), "sp": np.nanmax(z), "sv": -np.nanmin(z)}
    p["sz"] = p["sp"] + p["sv"]
    z = z - np.nanmean(z)
    p["m0"] = np.nanmean(z**2)
    p["sq"] = math.sqrt(p["m0"])
    p["ssk"] = np.nanmean(z**3)/p["sq"]**3
    p["sku"] = np.nanmean(z**4)/p["sq"]**4
    z_x, z_y, z_xx, z_yy, z_xy = derivatives(z, step_x, step_y)
    p["m2_x"] = np.nanmean(((shifted(z, 0, 1) - z)/step_x)**2)
    p["m2_y"] = np.nanmean(((shifted(z, 1, 0) - z)/step_y)**2)
    p["m4_x"], p["m4_y"] = np.nanmean(z_xx**2), np.nanmean(z_yy**2)
    p["sdq"] = math.sqrt(p["m2_x"] + p["m2_y"])
    p.update(directions(p["m2_x"], p["m2_y"], *(d[within] for d in (z_x, z_y, z_xx, z_yy, z_xy))))
    p["m2"] = math.sqrt(p["m2_across"]*p["m2_along"])
    p["m4"] = math.sqrt(p["m4_across"]*p["m4_along"])
    p["alpha"] = p["m0"]*p["m4"]/p["m2"]**2

    area = within.sum()*step_x*step_y
    curvature = -(z_xx + z_yy)/2
    top = summits(z)
    peak = wolf_peaks(z, share) & within
    p["summit_density"] = top.sum()/area
    p["summit_curvature"] = curvature[top].mean()
    p["summit_mean"], p["summit_sigma"] = z[top].mean(), z[top].std()
    p["spd"], p["spc"] = peak.sum()/area, curvature[peak].mean()
    p["peak_mean"], p["peak_sigma"] = z[peak].mean(), z[peak].std()

    p["eta_paper"], p["radius_paper"], p["sigma_paper"] = p["spd"], 1/p["spc"], p["sq"]
    p["eta_nayak"] = p["m4"]/p["m2"]/(6*math.pi*math.sqrt(3))
    p["radius_nayak"] = 3/8*math.sqrt(math.pi/p["m4"])
    p["sigma_nayak"] = math.sqrt(max(0.0, 1 - NAYAK_C/p["alpha"])*p["m0"])
    p["summit_plane"] = 4*math.sqrt(p["m0"]/(math.pi*p["alpha"]))
    return {name: float(value) for name, value in p.items()}


def directions(m2_x, m2_y, z_x, z_y, z_xx, z_yy, z_xy):
    """Moments of profiles along the axes of the mean gradient tensor. Its axes and the correlation
    of the two slopes are those of central differences, the mean squares those of neighbours."""
    cross = np.mean(z_x*z_y)
    tensor = np.array([[np.mean(z_x**2), cross], [cross, np.mean(z_y**2)]])
    c, s = np.linalg.eigh(tensor)[1][:, 1]
    cross *= math.sqrt(m2_x*m2_y/(tensor[0, 0]*tensor[1, 1]))
    return {"direction": math.degrees(math.atan2(s, c)) % 180,
            "m2_across": c*c*m2_x + 2*c*s*cross + s*s*m2_y,
            "m2_along": s*s*m2_x - 2*c*s*cross + c*c*m2_y,
            "m4_across": np.mean((c*c*z_xx + 2*c*s*z_xy + s*s*z_yy)**2),
            "m4_along": np.mean((s*s*z_xx - 2*c*s*z_xy + c*c*z_yy)**2)}


def main(arguments):
    """The program."""
    if len(arguments) not in (3, 4):
        sys.exit("usage: surface_statistics.py MAP.txt STEP_X STEP_Y [SHARE]")
    share = float(arguments[3]) if len(arguments) == 4 else 0.05
    for name, value in statistics(np.loadtxt(arguments[0]), float(arguments[1]),
                                  float(arguments[2]), share).items():
        print(f"{name},{value!r}")


if __name__ == "__main__":
    main(sys.argv[1:])
