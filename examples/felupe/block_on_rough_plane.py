#!/usr/bin/env python3
"""A block of wood, pressed onto a rough plane and slid over it: the law in a finite-element code in Python.

FElupe (`pip install felupe`) does the solid, asperity.Contact what happens between block and plane. FElupe
is under the GNU GPL, version 3; this example of how to use both is under asperity's MIT licence.
"""

import asperity
import felupe
import numpy as np
from scipy.sparse import coo_array

SIZE, CELLS = (40.0, 20.0, 20.0), (8, 4, 4)  # mm; along x, y, z
GAP = 0.02  # mm, at the start
PATH = [(0.0, -0.05), (0.0, -0.10), (0.0, -0.15), (0.0, -0.20),  # mm; the head of the block in x and z
        (0.1, -0.20), (0.2, -0.20), (0.4, -0.20), (0.6, -0.20), (0.8, -0.20)]
ELASTIC = {"E": 351.0, "nu": 0.35}  # MPa; across the grain
UP = np.array([[0, 0, -1], [1, 0, 0], [0, 1, 0]])  # overclosure and two slips of a displacement


class RoughPlane:
    """A rough rigid plane below points of a block: an item of FElupe with its vector and matrix.

    FElupe asks for both at trial displacements, and accepts the last trial once it has converged. So
    every trial starts from a copy of the accepted contact points.
    """

    def __init__(self, field, points, areas, law):
        self.field, self.points, self.areas = field, points, areas
        self.places = 3*points[:, None] + np.arange(3)
        self.results = felupe.mechanics.Results()
        self.results.statevars = asperity.Contact(law, len(points)), self.displacements()
        self.assemble = felupe.mechanics.Assemble(vector=self.vector, matrix=self.matrix)

    def displacements(self):
        """Displacements of the points, (3, n)."""
        return self.field[0].values[self.points].T.copy()

    def vector(self, field, **_):
        """Forces that the block has to bear, N."""
        accepted, start = self.results.statevars
        contact, end = accepted.copy(), self.displacements()
        self.response = contact.update(UP[0] @ end - GAP, UP[1:] @ (end - start))
        self.results._statevars = contact, end
        forces = UP.T @ self.response.traction * self.areas
        return self.sparse(forces.T, self.places, np.zeros_like(self.places), 1)

    def matrix(self, **_):
        """Their derivatives, N/mm; unsymmetric."""
        stiffness = np.einsum("ki,klp,lj,p->pij", UP, self.response.tangent, UP, self.areas)
        return self.sparse(stiffness, self.places[:, :, None], self.places[:, None, :], None)

    def sparse(self, values, rows, columns, width):
        size = self.field[0].values.size
        rows, columns = np.broadcast_arrays(rows, columns)
        return coo_array((values.ravel(), (rows.ravel(), columns.ravel())),
                         shape=(size, width or size)).tocsr()

    def mean(self, values):
        """Mean over the area."""
        return values @ self.areas/self.areas.sum()


def nodal_areas(mesh, points):
    """Area of the face below that belongs to each point: FElupe's forces are those of points."""
    region = felupe.RegionHexahedronBoundary(mesh, only_surface=True, mask=mesh.z == 0)
    field = felupe.FieldContainer([felupe.Field(region, dim=1)])
    areas = felupe.IntegralForm([np.ones((1, 1, 1))], v=field, dV=region.dV, grad_v=[False]).assemble()
    return areas.toarray()[points, 0]


def main():
    mesh = felupe.Cube(b=SIZE, n=tuple(n + 1 for n in CELLS))
    field = felupe.FieldContainer([felupe.Field(felupe.RegionHexahedron(mesh), dim=3)])
    block = felupe.SolidBody(felupe.LinearElastic(**ELASTIC), field)
    law = asperity.Law(asperity.Properties.from_pair("transverse-tangential", compiled=True))
    points = np.flatnonzero(mesh.z == 0)
    plane = RoughPlane(field, points, nodal_areas(mesh, points), law)
    np.testing.assert_allclose(plane.areas.sum(), SIZE[0]*SIZE[1], rtol=1e-12)
    held, free = felupe.dof.partition(field, {"head": felupe.Boundary(field[0], fz=SIZE[2])})

    print("    x      z  pressure  over the law's  shear over  residuals of the iterations\n"
          "   mm     mm       MPa                    pressure  over the force at the head")
    for x, z in PATH:
        # the fields of the items follow, and so does this one
        found = felupe.newtonraphson(items=[block, plane], x0=field, dof0=held, dof1=free, tol=1e-9,
                                     ext0=np.tile((x, 0.0, z), len(held)//3), verbose=0)
        pressure, *shear = plane.response.traction
        closure = plane.mean(UP[0] @ plane.displacements() - GAP)
        of_law = law.pressure(law.properties.initial_separation - closure)
        states = plane.results.statevars[0].states
        print(f"{x:5.2f} {z:6.2f} {plane.mean(pressure):9.5f} {plane.mean(pressure)/of_law:15.5f} "
              f"{abs(plane.mean(shear[0]))/plane.mean(pressure):11.5f}  "
              + " ".join(f"{r:.0e}" for r in found.fnorms))

        # quadratic: each residual is of the order of the square of the one before, until round-off
        residuals = np.array(found.fnorms)
        assert np.all(residuals[1:] < np.maximum(5*residuals[:-1]**2, 1e-10)), residuals
        assert len(residuals) <= 6
        # what the plane bears is what the head presses with
        np.testing.assert_allclose(plane.mean(pressure)*SIZE[0]*SIZE[1],
                                   -found.fun[held].reshape(-1, 3)[:, 2].sum(), rtol=1e-7)
        if x == 0.0:
            # nearly even: the head holds the sides of the block
            np.testing.assert_allclose(plane.mean(pressure), of_law, rtol=1e-3)
            np.testing.assert_allclose(plane.mean(shear[0]), 0.0, atol=1e-9)
        if x > 0.5:
            # the block tilts, so that pressures differ by a half, yet every point slips at mu p
            assert np.all(states["status"] == asperity.Status.SLIP)
            np.testing.assert_allclose(np.hypot(*shear), 0.5*pressure, rtol=1e-9)
            assert pressure.max() > 1.5*pressure.min()


if __name__ == "__main__":
    main()
