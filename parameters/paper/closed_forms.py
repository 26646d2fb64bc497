# SPDX-License-Identifier: LGPL-2.1-or-later
"""The experiments of the paper by hand, without finite elements.

Closed forms and homogeneous solutions, with numpy alone and no use of the
program. Symbols are those of doc/theory.md, numbers in brackets the paper's
equations; doc/paper.md has the derivations. Stresses are in units of the a of
the wall unless said otherwise, lengths in units of the inner radius R0 of the
tube at rest.

    python3 parameters/paper/tables.py [TABLE ...]

prints them.
"""
from typing import NamedTuple

import numpy as np

LOAD = 0.351        # P R0 / (a T), from the paper's dR/R0 = 0.142
A_LATEX = 0.23      # N/mm^2, the paper's constant in Diagram 1
POISSON_RATIOS = (0.49, 0.499, 0.4999, 0.5)


# --- One material ------------------------------------------------------------

def uniaxial_mooney_rivlin(stretch, a, b):
    """True and nominal stress of an incompressible bar, (7), (9) and (13).

    sigma = (a + b/l) (l^2 - 1/l), the nominal stress is sigma/l: (13) with
    B = diag(l^2, 1/l, 1/l) and p such that the sides are free.
    """
    true = (a + b / stretch) * (stretch**2 - 1 / stretch)
    return true, true / stretch


def uniaxial_neo_hooke(stretch, a):
    """Uniaxial tension with b = 0: a (l^2 - 1/l), the line of Diagram 1."""
    return uniaxial_mooney_rivlin(stretch, a, 0.0)


def hooke_cube(u, nu):
    """Edge across and volume of the unit cube stretched by u, (1) and (2).

    edge = 1 - nu u,  volume = (1 + u) (1 - nu u)^2.
    """
    edge = 1 - nu * u
    return edge, (1 + u) * edge**2


def hooke_cube_collapse(nu):
    """The u = 1/nu beyond which the edge of (2) is negative."""
    return 1 / nu


def neo_hooke_cube(u):
    """Edge across and volume of the same cube, incompressible by (7)."""
    edge = (1 + u)**-0.5
    return edge, (1 + u) * edge**2


# --- The tube, its content a liquid ------------------------------------------

def bisect(function, low, high):
    """The root of an increasing function between low and high."""
    while True:
        middle = 0.5 * (low + high)
        if middle in (low, high):
            return middle
        if function(middle) < 0:
            low = middle
        else:
            high = middle


def thin_tube_tied(load):
    """Hoop stretch l of a thin tube with pressure on all of its wall.

    load = P R/(a T) = l^(1/2) - l^(-5/2).  The ends are free, the wall is in
    uniaxial hoop tension and shortens by l^(-1/2).  Per radian and length at
    rest the liquid pushes with P (l R) l^(-1/2), and the wall holds with its
    nominal hoop force a T (l - 1/l^2).  The paper's analytical calculation.
    """
    return bisect(lambda l: l**0.5 - l**-2.5 - load, 1e-3, 1e6)


def thin_tube_slip(load):
    """Hoop stretch l of a thin tube whose filling shortens inside it.

    load = P R/(a T) = l^2 - 1/l.  Node pairs on filling and wall stay together
    in radial direction only.  The filling keeps its volume and shortens by
    l^(-2), so that per radian and length at rest it pushes with
    P (l R) l^(-2) only.  The wall holds with a T (l - 1/l^2) as before.
    """
    return bisect(lambda l: l**2 - 1 / l - load, 1e-3, 1e6)


def plane_sections_tied(load):
    """Hoop stretch l where tube and filling share the axial stretch l^(-2).

    load = 2 (l^2 - l^(-4)).  The wall is in uniaxial compression along the
    axis: it carries the whole load, and the liquid has no pressure.
    """
    return bisect(lambda l: 2 * (l**2 - l**-4) - load, 1e-3, 1e6)


def slip_recursion(load, thickness_ratio, fluid_ratio, n_solves):
    """dR/R0 and p/P of each solve under slip: nu = 0.5, thin wall.

    P = a T/R (l^2 - 1/l) + a_f (s^2 - s^(-4)),  s = l / (l before):
    sigma_r - sigma_z of the filling is P - q, and its stretches since the last
    reset are s, s and s^(-2).
    """
    P = load * thickness_ratio
    results, last = [], 1.0
    for _ in range(n_solves):
        def surplus(l, last=last):
            s = l / last
            return (thickness_ratio * (l**2 - 1 / l)
                    + fluid_ratio * (s**2 - s**-4) - P)
        last = bisect(surplus, last, 1e6)
        q = thickness_ratio * (last**2 - 1 / last)
        results.append((last - 1, (P + 2 * q) / (3 * P)))
    return results


def contraction(l, thickness_ratio, fluid_ratio):
    """What a reset leaves of the distance to the solution at hoop stretch l.

    6 a_f / (6 a_f + (2 l^2 + 1/l) a T/R): slip_recursion linearised in ln l.
    """
    fluid = 6 * fluid_ratio
    return fluid / (fluid + (2 * l**2 + 1 / l) * thickness_ratio)


def bulk_modulus(mu, nu):
    """kappa = 2 mu (1 + nu) / (3 (1 - 2 nu)), infinite at nu = 0.5."""
    return np.inf if nu == 0.5 else 2 * mu * (1 + nu) / (3 * (1 - 2 * nu))


def lasting_divergence(l, nu):
    """|dev sigma|/|p| that mode 'full' does not go below, thin wall.

    sqrt(2/3) 2 (1 - 3 c) a_f/kappa,  c = (l^2 - 1/l) / (2 l^2 + 1/l).
    Each reset takes d ln V = -P/kappa from the filling, the wall follows with
    d ln l = c d ln V, and ln(r/z) of the filling changes by (3 c - 1) d ln V.
    To first order in 1 - 2 nu; a_f cancels with that in kappa.
    """
    c = (l**2 - 1 / l) / (2 * l**2 + 1 / l)
    return np.sqrt(2 / 3) * 2 * (1 - 3 * c) / bulk_modulus(1.0, nu)


# --- The filled cylinder, homogeneous ----------------------------------------

class Solve(NamedTuple):
    """The state after one solve, which `resets` resets came before."""
    resets: int
    dR: float           # dR / R0 of the interface
    pressure: float     # -tr(sigma)/3 of the filling, over P
    dV: float           # dV / V0 of the filling
    divergence: float   # |dev sigma| / |p| of the filling
    wall_length: float  # axial stretch of the wall


class Filling:
    """The rubber fluid under stretches r, r, z; doc/theory.md, Energy.

    psi = J_v [ a_f/2 (I1bar - 3) + p (J/J_v - 1) - p^2 / (2 kappa) ],
    F = diag(r, r, z),  G = diag(g, g, g^(-2)).
    """

    def __init__(self, a, nu):
        self.a = a
        self.compressibility = 1 / bulk_modulus(a, nu)
        self.g, self.J_v = 1.0, 1.0

    def deviator(self, r, z):
        """sigma_r - sigma_z = J_v/J a_f (bbar_r - bbar_z)."""
        J = r * r * z
        bbar_r = J**(-2 / 3) * (r / self.g)**2
        bbar_z = J**(-2 / 3) * (z * self.g**2)**2
        return self.J_v / J * self.a * (bbar_r - bbar_z)

    def stresses(self, r, z, p):
        """sigma_r and sigma_z."""
        deviator = self.deviator(r, z)
        return p + deviator / 3, p - 2 * deviator / 3

    def volume_residual(self, r, z, p):
        """d psi / dp = J - J_v (1 + p/kappa)."""
        return r * r * z - self.J_v * (1 + p * self.compressibility)

    def reset(self, r, z, mode):
        """The present shape becomes the stress-free one."""
        self.g = (r / z)**(1 / 3)
        self.J_v = {"full": r * r * z, "isochoric": 1.0}[mode]


def thickness_stretch(r, w, nu):
    """The stretch h of the thickness of a thin wall, free at its outside.

    h = 1/(r w) at nu = 0.5, else the root of
    sigma_h = kappa (J - 1) + a J^(-5/3) (h^2 - I1/3), J = r w h.
    """
    if nu == 0.5:
        return 1 / (r * w)
    kappa = bulk_modulus(1.0, nu)

    def sigma_h(h):
        J = r * w * h
        return (kappa * (J - 1)
                + J**(-5 / 3) * (h * h - (r * r + w * w + h * h) / 3))
    return bisect(sigma_h, 0.1 / (r * w), 10 / (r * w))


def thin_wall(r, w, thickness_ratio, nu):
    """Nominal forces of a membrane with hoop stretch r and axial stretch w.

    f = T a J^(-2/3) (r - h^2/r), radial, per radian and length at rest;
    n = T a J^(-2/3) (w - h^2/w), axial, per radian.
    """
    h = thickness_stretch(r, w, nu)
    scale = thickness_ratio * (r * w * h)**(-2 / 3)
    return scale * (r - h * h / r), scale * (w - h * h / w)


def squared_hoop_stretch(r, w, R):
    """m^2 = r^2/R^2 + (1 - 1/R^2)/w at R in an incompressible thick wall."""
    return (r * r + (R * R - 1) / w) / R**2


def thick_wall(r, w, thickness_ratio, nu):
    """f and n of an incompressible wall of finite thickness, outside free.

    Derivatives with respect to r and w of the energy per radian and length,
    int a/2 (m^2 + w^2 + 1/(m w)^2 - 3) R dR for R from 1 to 1 + T/R0: radial
    equilibrium integrated, and the axial stress over the section.
    """
    if nu != 0.5:
        raise ValueError("the thick wall is incompressible: nu_wall = 0.5")
    points, weights = np.polynomial.legendre.leggauss(20)
    R = 1 + thickness_ratio * (points + 1) / 2
    m2 = squared_hoop_stretch(r, w, R)
    hoop = 1 - 1 / (m2 * w)**2
    f = hoop * r / R
    n = (w - 1 / (m2 * w**3)) * R - hoop * (R - 1 / R) / (2 * w**2)
    weights = weights * thickness_ratio / 2
    return weights @ f, weights @ n


WALLS = {"thin": thin_wall, "thick": thick_wall}


def equilibrium(filling, wall, P, coupling):
    """The residual as a function of ln r, ln z, p/P and ln w.

    radial    sigma_r r z + f = 0             at the interface
    axial     (sigma_z + P) r^2/2 + n = 0     on a section
    volume    d psi / dp = 0
    coupling  n = 0 (slip: the wall's ends are free) or w = z (tied)

    with f and n the wall's nominal forces and w its axial stretch.
    """
    def residual(x):
        r, z, w = np.exp(x[[0, 1, 3]])
        p = P * x[2]
        sigma_r, sigma_z = filling.stresses(r, z, p)
        f, n = wall(r, w)
        return np.array([(sigma_r * r * z + f) / P,
                         ((sigma_z + P) * r * r / 2 + n) / P,
                         filling.volume_residual(r, z, p),
                         n / P if coupling == "slip" else w - z])
    return residual


def jacobian(function, x, step=1e-6):
    """Central differences."""
    columns = [function(x + e) - function(x - e)
               for e in step * np.eye(len(x))]
    return np.array(columns).T / (2 * step)


def newton(residual, x, largest_step=0.3, tolerance=1e-11):
    """Newton's method with increments of at most largest_step."""
    for _ in range(100):
        increment = np.linalg.solve(jacobian(residual, x), -residual(x))
        size = np.abs(increment).max()
        x = x + increment * largest_step / max(size, largest_step)
        if size < tolerance:
            return x
    raise RuntimeError(f"no convergence: increment {size:.1e} after 100 steps")


def filled_cylinder(load=LOAD, thickness_ratio=0.01, fluid_ratio=0.01,
                    nu=0.499, mode="full", n_resets=20, coupling="slip",
                    wall="thin", nu_wall=0.5):
    """The states after 0, 1, ... n_resets resets of the paper's cylinder.

    load = P R0/(a T), thickness_ratio = T/R0 with R0 the inner radius of the
    wall, fluid_ratio = a_f/a, nu of the filling; mode 'full' or 'isochoric';
    coupling 'slip' (the radial displacement is shared) or 'tied' (the axial
    stretch too: sections stay plane); wall 'thin' or 'thick'. P is a follower
    pressure on the front faces of the filling.
    """
    P = load * thickness_ratio
    filling = Filling(fluid_ratio, nu)

    def wall_forces(r, w):
        return WALLS[wall](r, w, thickness_ratio, nu_wall)
    residual = equilibrium(filling, wall_forces, P, coupling)
    x, solves = np.array([0.0, 0.0, -1.0, 0.0]), []
    for resets in range(n_resets + 1):
        x = newton(residual, x)
        r, z, w = np.exp(x[[0, 1, 3]])
        dev = np.sqrt(2 / 3) * abs(filling.deviator(r, z))
        solves.append(Solve(resets, r - 1, -x[2], r * r * z - 1,
                            dev / abs(P * x[2]), w))
        filling.reset(r, z, mode)
    return solves


def thick_tube(load, thickness_ratio, contact):
    """Stretches r and w at the interface of a thick tube filled with liquid.

    f = P r z and n = 0 with z = w (contact 'whole': the liquid wets all of the
    wall, as in thin_tube_tied) or z = r^(-2) ('slip': as in thin_tube_slip).
    """
    P = load * thickness_ratio

    def residual(x):
        r, w = np.exp(x)
        f, n = thick_wall(r, w, thickness_ratio, 0.5)
        z = {"whole": w, "slip": r**-2}[contact]
        return np.array([f / P - r * z, n / P])
    return np.exp(newton(residual, np.zeros(2)))


# --- The paper's diagrams ----------------------------------------------------

def diagram1(a=A_LATEX):
    """Stretch, true stress and nominal stress of the line of Diagram 1."""
    stretch = np.linspace(1.0, 3.0, 9)
    return np.column_stack((stretch, *uniaxial_neo_hooke(stretch, a)))


def diagram2_and_3(**settings):
    """The solves of every mode and nu, by (mode, nu).

    Their pressures are Diagram 2, their dV Diagram 3.
    """
    return {(mode, nu): filled_cylinder(nu=nu, mode=mode, **settings)
            for mode in ("full", "isochoric") for nu in POISSON_RATIOS}
