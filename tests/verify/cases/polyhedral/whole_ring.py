"""A whole polyhedral ring on a separate mesh of triangles, loaded as in a clutch.

It shares neither formulas nor meshes nor finite elements with the cases.
"""

from cmath import phase, rect
from math import atan, pi

import gmsh
import numpy as np
import skfem
from scipy.sparse.linalg import splu
from skfem.helpers import ddot, dot, eye, sym_grad, trace

FINE, BLUNT, COARSE = 0.02, 0.12, 0.9  # cells [mm]: below rollers, at hub and fillets, outside
PULL = skfem.LinearForm(lambda v, w: dot(w.t, v))


class WholeRing:
    """The elastic ring with the measures of `q`, in N and mm; quadratic displacements.

    Points are x + iy; the middle of a flat lies on the x axis, `flats` turns it onto the others.
    """

    def __init__(self, q):
        self.z, self.r_e, self.rho = q.z, 500 * q.d_e, 1e3 * q.rho
        self.flats = np.exp(2j * pi / q.z * np.arange(q.z))
        self.centre = rect(self.r_e - 1e3 * (q.delta_1 + q.rho), pi / q.z)
        self.end = self.centre + self.rho  # of a flat, where the fillet begins
        self.hub = self.end.real + 1e3j * q.e
        shear = q.E / 2e6 / (1 + q.nu)
        self.elastic = 2 * shear * q.nu / (1 - q.nu), shear
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
        corner = rect(self.r_e, pi / self.z)
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

    def folded(self, angle):
        """From the middle of the nearest flat [rad]."""
        return (angle + pi / self.z) % (2 * pi / self.z) - pi / self.z

    def size(self, x):
        """Of the cells [mm] about a point."""
        x = rect(abs(x), abs(self.folded(phase(x))))
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

    def mean_growth(self, u):
        return PULL.assemble(self.rim, t=self.rim.normals) @ u / self.rim.dx.sum()

    def pressed(self):
        """Loads of the unit pressure in the bore."""
        return PULL.assemble(self.bore, t=-self.bore.normals)

    def rolled(self, a, *, inwards=0.0, turning=0.0):
        """Loads on every patch with these forces: semi-elliptic pressures over an arc, -a to a."""
        x = [1, 1j] @ np.asarray(self.rim.global_coordinates()).transpose(1, 0, 2)
        q = np.sqrt(np.maximum(1 - (self.r_e * self.folded(np.angle(x)) / a) ** 2, 0))
        q = q * self.z / (q * self.rim.dx).sum() * (1j * turning - inwards) * x / np.abs(x)
        return PULL.assemble(self.rim, t=np.stack([q.real, q.imag]))

    def driven(self, tan_phi):
        """Loads of unit hub forces that lean to the flats' middles, and one's moment on the axis.

        The rollers hold these moments.
        """
        push, f = rect(1, -atan(tan_phi)), np.zeros(self.basis.N)
        for x in self.flats:
            f[self.at(x * self.hub)] += (x * push).real, (x * push).imag
        moment = -(self.hub.conjugate() * push).imag
        return f + self.rolled(0.1, turning=moment / self.r_e), moment
