"""Readings that formulas and finite elements of the polyhedral cases share, by a third model.

A whole ring on triangles of its own, driven as a clutch is: the hub pushes every flat on one side
of its middle, the rollers press and drag. It tells apart to which side the hub's friction leans,
which lever the rollers' friction has, diameters and radii, and where K and the clearance are taken.
"""

from functools import cache
from math import atan, pi, sqrt

import gmsh
import numpy as np
import pytest
import skfem
from scipy.optimize import brentq
from scipy.sparse.linalg import splu
from skfem.helpers import ddot, dot, eye, sym_grad, trace

from verify.cases.polyhedral_clutch import CLUTCH
from verify.cases.polyhedral_inputs import HubRing
from verify.cases.polyhedral_ring import RING

pytestmark = pytest.mark.xdist_group("polyhedral-whole-ring")
CLOSE = 2e-3
FINE, BLUNT, COARSE = 0.02, 0.12, 0.9  # cells [mm]: below rollers, at hub and fillets, elsewhere
PULL = skfem.LinearForm(lambda v, w: dot(w.t, v))


class WholeRing:
    """The elastic ring with the measures of `q`, in N and mm; quadratic displacements.

    Points are x + iy; the middle of a flat lies on the x axis, `flats` turns it onto the others.
    """

    def __init__(self, q, *, strain):
        self.z, self.r_e, self.rho = q.z, 500 * q.d_e, 1e3 * q.rho
        self.flats = np.exp(2j * pi / q.z * np.arange(q.z))
        self.centre = (self.r_e - 1e3 * (q.delta_1 + q.rho)) * np.exp(1j * pi / q.z)
        self.end = self.centre + self.rho  # of a flat, where the fillet begins
        self.hub = self.end.real + 1e3j * q.e
        shear = q.E / 2e6 / (1 + q.nu)
        self.elastic = 2 * shear * q.nu / (1 - (2 if strain else 1) * q.nu), shear
        mesh = self.mesh()
        self.basis = skfem.Basis(mesh, skfem.ElementVector(skfem.ElementTriP2()))
        walls = mesh.boundary_facets()
        outside = np.hypot(*mesh.p[:, mesh.facets[:, walls]]).min(axis=0) > self.r_e - 1e-6
        self.rim, self.bore = (
            skfem.FacetBasis(mesh, self.basis.elem, facets=part, intorder=9)
            for part in (walls[outside], walls[~outside])
        )
        held = [*self.at(self.r_e), self.at(1j * self.r_e)[0]]  # of loads in balance
        self.free = np.setdiff1d(np.arange(self.basis.N), held)
        K = skfem.BilinearForm(lambda u, v, _: ddot(self.stress(u), sym_grad(v)))
        K = K.assemble(self.basis)[self.free][:, self.free].tocsc()
        self.lu = splu(K, "MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})

    def mesh(self):
        gmsh.initialize(["gmsh", "-v", "0", "-nt", "1"], interruptible=False)
        try:
            self.draw(gmsh.model.geo)
            gmsh.model.mesh.setSizeCallback(lambda _dim, _tag, x, y, *_: self.size(x + 1j * y))
            gmsh.option.setNumber("Mesh.MeshSizeExtendFromBoundary", 0)
            gmsh.model.mesh.generate(2)
            tags, x, _ = gmsh.model.mesh.getNodes()
            cells = gmsh.model.mesh.getElementsByType(2)[1].reshape(-1, 3)
        finally:
            gmsh.finalize()
        used, t = np.unique(cells, return_inverse=True)
        p = x.reshape(-1, 3)[np.argsort(tags)][np.searchsorted(np.sort(tags), used), :2]
        return skfem.MeshTri(*(np.ascontiguousarray(a.T) for a in (p, t.reshape(-1, 3))))

    def draw(self, geo):
        corner = self.r_e * np.exp(1j * pi / self.z)
        middle, corner, start, hub, end, centre = (
            [geo.addPoint(x.real, x.imag, 0) for x in point * self.flats]
            for point in (self.r_e, corner, self.end.conjugate(), self.hub, self.end, self.centre)
        )
        axis, rim, bore = geo.addPoint(0, 0, 0), [], []
        for k in range(self.z):
            rim.append(geo.addCircleArc(middle[k], axis, corner[k]))
            rim.append(geo.addCircleArc(corner[k], axis, middle[k + 1 - self.z]))
            bore += [geo.addLine(start[k], hub[k]), geo.addLine(hub[k], end[k])]
            bore.append(geo.addCircleArc(end[k], centre[k], start[k + 1 - self.z]))
        geo.addPlaneSurface([geo.addCurveLoop(rim), geo.addCurveLoop(bore)])
        geo.synchronize()

    def folded(self, x):
        """Angles [rad] from the middles of the nearest flats."""
        return (np.angle(x) + pi / self.z) % (2 * pi / self.z) - pi / self.z

    def size(self, x):
        x = abs(x) * np.exp(1j * abs(self.folded(x)))
        fillet = abs(abs(x - self.centre) - self.rho)
        blunt = BLUNT + min(abs(x - self.hub), fillet) / 4
        return min(FINE + max(abs(x - self.r_e) - 0.15, 0) / 4, blunt, COARSE)

    def stress(self, u):
        lame, shear = self.elastic
        return lame * eye(trace(sym_grad(u)), 2) + 2 * shear * sym_grad(u)

    def at(self, x):
        """Unknowns of the node at a point."""
        return self.basis.nodal_dofs[:, np.argmin(np.abs([1, 1j] @ self.basis.mesh.p - x))]

    def solve(self, f):
        u = np.zeros(self.basis.N)
        u[self.free] = self.lu.solve(f[self.free])
        return u

    def growth(self, u, turn=1.0):
        """Mean u_r outside, `turn` from the middles of all flats, so that motions drop out."""
        return np.mean([[x.real, x.imag] @ u[self.at(self.r_e * x)] for x in turn * self.flats])

    def pressed(self):
        return PULL.assemble(self.bore, t=-self.bore.normals)

    def rolled(self, a, *, inwards=0.0, turning=0.0):
        """Loads of these forces on every patch, semi-ellipses over an arc of -a to a."""
        x = [1, 1j] @ np.asarray(self.rim.global_coordinates()).transpose(1, 0, 2)
        q = np.sqrt(np.maximum(1 - (self.r_e * self.folded(x) / a) ** 2, 0))
        q = q * self.z / (q * self.rim.dx).sum() * (1j * turning - inwards) * x / np.abs(x)
        return PULL.assemble(self.rim, t=np.stack([q.real, q.imag]))

    def driven(self, tan_phi):
        """Loads of unit hub forces that lean to the flats' middles, and one's moment on the axis.

        The rollers hold these moments.
        """
        push, f = np.exp(-1j * atan(tan_phi)), np.zeros(self.basis.N)
        for x in self.flats:
            f[self.at(x * self.hub)] += (x * push).real, (x * push).imag
        moment = -(self.hub.conjugate() * push).imag
        return f + self.rolled(0.1, turning=moment / self.r_e), moment


@cache
def ring(z=6, strain=False):
    return WholeRing(HubRing(z=z), strain=strain)


@pytest.mark.parametrize("z", [6, 3])
def test_k_is_taken_at_the_rollers_in_the_mean_and_at_the_corners(z):
    q, model = HubRing(z=z), ring(z)
    v, u = RING.analytic(q), model.solve(model.pressed())
    thin = 4e-9 * q.delta_1 * q.E / ((q.d_e - 2 * q.delta_1) * (q.d_e - q.delta_1))  # MPa/mm
    mean = PULL.assemble(model.rim, t=model.rim.normals) @ u / model.rim.dx.sum()
    corner = model.growth(u, np.exp(1j * pi / z))
    for key, growth in (("mid", model.growth(u)), ("mean", mean), ("corner", corner)):
        assert 1 / (thin * growth) == pytest.approx(v[f"K {key}"], rel=CLOSE), key
    assert 500e6 * q.j_D / model.growth(u) == pytest.approx(v["p_1r"], rel=CLOSE)


def test_a_wide_ring_is_in_plane_strain():
    growth = [model.growth(model.solve(model.pressed())) for model in (ring(), ring(strain=True))]
    v = RING.analytic(HubRing())
    assert growth[0] / growth[1] == pytest.approx(v["K mid, strain"] / v["K mid"], rel=CLOSE)


def test_a_hub_on_one_side_lifts_the_rollers_as_its_mirrored_halves_do():
    q, model = HubRing(), ring()
    lift = model.growth(model.solve(model.driven(q.tan_phi)[0]))
    assert q.R_b * lift / 1e6 == pytest.approx(RING.analytic(q)["hub at e, mid"], rel=1e-3)


def test_the_torque_is_that_of_rollers_and_hub_in_balance():
    q, model = CLUTCH.inputs(), ring()
    v, (turning, moment) = CLUTCH.analytic(q), model.driven(q.tan_phi)
    p, lever, gap = q.p_t / 1e6, 500 * q.D_i, 500 * (q.D_i - q.d_e - 2 * q.d)
    pressed = model.growth(model.solve(model.pressed()))
    lift = q.mu * lever / moment * model.growth(model.solve(turning))

    def left(N):
        a = sqrt(4e6 * N / (pi * q.E * (2e-3 / q.d + 2e-3 / q.d_e)))
        return (
            p * pressed + N * (lift + model.growth(model.solve(model.rolled(a, inwards=1)))) - gap
        )

    N = brentq(left, 100, 500, rtol=1e-5)
    assert 1e6 * gap / pressed == pytest.approx(v["p_1r"], rel=CLOSE)
    assert q.z * q.b * q.mu * lever * N == pytest.approx(v["M rigid"], rel=CLOSE)


def test_the_fillets_bear_pressure_rollers_and_a_hub_on_one_side():
    q, model = CLUTCH.inputs(), ring()
    v, (turning, moment) = CLUTCH.analytic(q), model.driven(q.tan_phi)
    N = v["N series"] / q.b / 1e3
    load = q.p_t / 1e6 * model.pressed() + N * model.rolled(0.1, inwards=1)
    u = model.solve(load + N * q.mu * 500 * q.D_i / moment * turning)
    x, y = np.asarray(model.bore.normals)
    stress = np.asarray(model.stress(model.bore.interpolate(u)))
    hoop = y**2 * stress[0, 0] + x**2 * stress[1, 1] - 2 * x * y * stress[0, 1]
    fillets = np.hypot(*np.asarray(model.bore.global_coordinates())) > abs(model.end)
    assert 1e6 * hoop[fillets].max() == pytest.approx(v["fillet"], rel=1e-2)
