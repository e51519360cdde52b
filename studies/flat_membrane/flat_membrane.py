#!/usr/bin/python3
"""Solves the lattice exactly around a flat membrane. Finds the viscosity profile and the dipoles that remove its error of first order in dx, in
the mean over the directions of the membrane, and what is left of this error.

    studies/flat_membrane/flat_membrane.py > studies/flat_membrane/results.md      ten seconds

Units: dx = mu_a = 1. The membrane lies at z = 0 across the normal n, the inner fluid of viscosity V > 1 at z < 0. Everything depends on z only,
apart from an imposed velocity E x, so that the density rho and the momentum g of the planes of cells across n are the unknowns.

The scheme is the steady two-relaxation-time lattice Boltzmann equation (D3Q19) with magic parameter 1/4, from which the populations are
eliminated link by link. R is the viscosity ratio of a cell, x' = x - e its neighbour along a link, and k = 2/(R + R'):

    mass        sum over links of  w k [ (rho' - rho) + 3 R' e.(g' - g) ]             = 0
    momentum    R times sum over links of  w k e [ (rho' - rho) + 3 R' e.(g' - g) ] + F = 0
    velocity    u = g - F/(2 R)

The viscous force is that of a network of dashpots with the harmonic mean k R R' of the two cells' viscosities. A viscosity of R = 1 is one of
1/6 in lattice units, so that F is 1/6 of a force in the units above, and a stress is 6 times the flux of momentum.

The viscosity has a smoothed jump, an excess on its viscous side, and an excess of fluidity on its thin side:

    1/R = 1/(V^(1 - H) + viscosity (V - 1) b_v(z)) + fluidity (1 - 1/V) b_f(z)

with a smoothed step H of z - SHIFT, and two bumps b of integral 1. With the two excesses no stress along the membrane is missing compared
with a sharp jump, and the outer fluid does not slip under a shear stress across the membrane. Any shape of the jump and of the bumps can meet
these two conditions, which are of first order in dx. The shape decides on the error of second order: see the README beside this file. A
tangential force F of the membrane is spread as F - div(s F n delta), and the velocity is read with the transpose of this; a normal force F_n is
spread as F_n - div(2 t F_n n n delta). Here s cancels the slip that a tangential force causes, and t the spurious tension that a normal force
causes. C is the kink that is left: a tangential force f makes the velocity that is read smaller by C f. The tension of a normal force is tied to
the velocity n.u that is read under a strain that changes areas: this is minus twice the tension.

All of these are means over the surface of a sphere in shear flow, since what remains in single directions depends on the strain, too: over the
directions of n, and over shear along each pair of axes of the grid. There the strain rate E of the flow gives a membrane across n the strain
along itself that follows from E, a tangential force and a shear stress proportional to (I - n n) E n, and a normal force proportional to n.E n.

For V < 1 the more viscous fluid is outside, and the mirror image of this profile is used. Its numbers follow from those for 1/V:
R(z; V) = V R(-z; 1/V), s(V) = -s(1/V), C(V) = C(1/V)/V, t(V) = -t(1/V).
"""
import itertools

import numpy as np
import scipy.linalg
import scipy.optimize
import scipy.spatial

HALF_WIDTH = 0.6  # of the jump of the viscosity
SHIFT = 0.1
VISCOUS_BUMP = (-0.5, 1.3)  # centre and width
FLUID_BUMP = (1, 2)
REACH = 9  # beyond this distance kernels, jump and their effects are over
POSITIONS = 4  # of the membrane between two planes
CLASSES = [(1, 0, 0), (1, 1, 0), (1, 1, 1), (2, 1, 0), (2, 1, 1), (2, 2, 1), (3, 1, 0), (3, 1, 1), (3, 2, 1)]  # of directions of n

LINKS = [np.array(e) for e in itertools.product((-1, 0, 1), repeat=3) if 1 <= sum(map(abs, e)) <= 2]
WEIGHTS = [{1: 1 / 18, 2: 1 / 36}[int(abs(e).sum())] for e in LINKS]
IDENTITY = np.eye(3)
SHEARS = [np.outer(a, b) + np.outer(b, a) for a, b in itertools.combinations(IDENTITY, 2)]
NONE = np.zeros(3)
AT_REST = np.zeros((3, 3))


def bump(z, centre, width):
    return np.where(abs(z - centre) < width / 2, 2 / width * np.cos(np.pi * (z - centre) / width) ** 2, 0)


def viscosity_ratio(z, V, excesses):
    viscosity, fluidity = excesses
    s = np.clip((z - SHIFT) / HALF_WIDTH, -1, 1)
    outer_part = (1 + s + np.sin(np.pi * s) / np.pi) / 2
    viscous = V ** (1 - outer_part) + viscosity * (V - 1) * bump(z, *VISCOUS_BUMP)
    return 1 / (1 / viscous + fluidity * (1 - 1 / V) * bump(z, *FLUID_BUMP))


def kernels(n, z):
    """The sharpened kernel and its slope at the planes (sharpening.hpp)."""
    k = np.arange(0, 40, 0.05)
    waves = np.outer(k, n)
    transform = np.sinc(waves / (2 * np.pi)).prod(axis=1) ** 4 * 0.05 / np.pi
    transform[0] /= 2
    d = 6 - 2 * np.cos(waves).sum(axis=1)
    transform *= 1 + d / 6 + 7 / 240 * d * d
    return np.cos(np.outer(z, k)) @ transform, -np.sin(np.outer(z, k)) @ (transform * k)


def frame(direction):
    n = np.array(direction) / np.linalg.norm(direction)
    t1 = np.cross(n, [0, 0, 1] if abs(n[2]) < 0.9 else [1, 0, 0])
    t1 = t1 / np.linalg.norm(t1)
    return n, t1, np.cross(n, t1)


class Planes:
    """The planes of cells around a membrane: what does not depend on the viscosity."""

    def __init__(self, direction, offset):
        self.frame = frame(direction)
        self.n = self.frame[0]
        self.h = 1 / np.linalg.norm(direction)
        self.steps = [int(e @ np.array(direction)) for e in LINKS]  # planes that a link spans
        self.beyond = max(self.steps)
        half = int(np.ceil(REACH / self.h))
        self.count = 2 * half + 1
        self.z_all = (np.arange(-half - self.beyond, half + self.beyond + 1) + offset) * self.h  # with those beyond the ends
        self.z = self.z_all[self.beyond : -self.beyond]
        self.kernel, self.slope = kernels(self.n, self.z)

    def sources(self, step):
        """The planes that a link of this step comes from, among those with the planes beyond the ends."""
        return np.arange(self.count) + self.beyond - step


class Layer:
    """The lattice on these planes, with a viscosity profile."""

    def __init__(self, planes, V, excesses):
        self.planes, self.V = planes, V
        self.ratio_all = viscosity_ratio(planes.z_all, V, excesses)
        self.ratio = self.ratio_all[planes.beyond : -planes.beyond]
        self.assemble()

    def assemble(self):
        """The left sides of mass and momentum as a matrix of (rho, g), with columns for the planes beyond the ends. Beyond the outer end the
        fluid moves like the last plane."""
        planes = self.planes
        count, beyond = planes.count, planes.beyond
        here = np.arange(count)
        matrix = np.zeros((count, 4, count + 2 * beyond, 4))
        self.blocks = []
        for link, weight, step in zip(LINKS, WEIGHTS, planes.steps):
            source = planes.sources(step)
            R, R_source = self.ratio, self.ratio_all[source]
            received = np.column_stack([np.ones(count), np.outer(R, link)])
            sent = np.column_stack([np.ones(count), np.outer(3 * R_source, link)])
            block = (2 * weight / (R + R_source))[:, None, None] * received[:, :, None] * sent[:, None, :]
            matrix[here, :, source, :] += block
            matrix[here, :, here + beyond, :] -= block
            self.blocks.append(block)
        self.matrix_all = matrix.reshape(4 * count, -1)
        inside = matrix[:, :, beyond:-beyond, :].copy()
        inside[:, :, -1, 1:] += matrix[:, :, -beyond:, 1:].sum(axis=2)
        self.factors = scipy.linalg.lu_factor(inside.reshape(4 * count, 4 * count))

    def solve(self, force=NONE, dipole=NONE, E=AT_REST, stress=NONE):
        """Under a force f delta(z) - d delta'(z) of the membrane, the strain rate E, and a mean shear stress on the membrane from both sides.
        Returns by how much the outer fluid slips, the velocity that is read by the kernel and by its slope, and the stress along the membrane
        that is missing compared with a sharp jump."""
        planes, n, h = self.planes, self.planes.n, self.planes.h
        beyond = planes.beyond
        tangential = force - force @ n * n
        slope_inside, slope_outside = (stress + tangential / 2) / self.V, stress - tangential / 2  # of the velocity
        density_inside = (self.V - 1) * n @ E @ n - force @ n / 2  # a pressure p is a density p/2

        far = np.zeros((len(planes.z_all), 4))
        far[:beyond, 0] = density_inside
        far[:beyond, 1:] = np.outer(planes.z_all[:beyond], slope_inside)
        far[-beyond:, 1:] = np.outer(planes.z_all[-beyond:] - planes.z[-1], slope_outside)
        spread = (np.outer(planes.kernel, force) - np.outer(planes.slope, dipole)) / 6
        right = -self.matrix_all @ far.ravel()
        right += sum(block[:, :, 1:] @ (E @ link) for block, link in zip(self.blocks, LINKS)).ravel()
        right.reshape(-1, 4)[:, 1:] -= spread
        unknowns = scipy.linalg.lu_solve(self.factors, right).reshape(-1, 4)

        far[beyond:-beyond] = unknowns
        far[-beyond:, 1:] += unknowns[-1, 1:]
        slip = unknowns[-1, 1:] - slope_outside * planes.z[-1]
        velocity = unknowns[:, 1:] - spread / (2 * self.ratio[:, None])
        sharp_inside = 2 * (self.V * E - density_inside * IDENTITY)
        sharp = (h / 2 - planes.z[0]) * sharp_inside + (h / 2 + planes.z[-1]) * 2 * E
        return slip, h * planes.kernel @ velocity, h * planes.slope @ velocity, sharp - self.sum_of_stress(far, E)

    def sum_of_stress(self, solution, E):
        """The integral of the stress over z: what the links pass on, with (R rho' + R' rho)/(R + R') as the density of a link."""
        planes = self.planes
        total = np.zeros((3, 3))
        for link, weight, step in zip(LINKS, WEIGHTS, planes.steps):
            source = planes.sources(step)
            here, there = solution[planes.beyond : -planes.beyond], solution[source]
            R, R_source = self.ratio, self.ratio_all[source]
            stretch = (there - here)[:, 1:] @ link - link @ E @ link
            passed = (R * there[:, 0] + R_source * here[:, 0] + 3 * R * R_source * stretch) / (R + R_source)
            total -= 6 * planes.h * weight * passed.sum() * np.outer(link, link)
        return total


def shares_of_classes():
    """The share of the unit sphere that is nearest to the directions of each class."""
    directions = [
        (np.array(order) * signs, c)
        for c, direction in enumerate(CLASSES)
        for order in sorted(set(itertools.permutations(direction)))
        for signs in itertools.product((1, -1), repeat=3)
        if all(sign == 1 or entry for sign, entry in zip(signs, order))
    ]
    cells = scipy.spatial.SphericalVoronoi(np.array([d / np.linalg.norm(d) for d, _ in directions]))
    return np.bincount([c for _, c in directions], cells.calculate_areas()) / (4 * np.pi)


SHARES = shares_of_classes()
ALL_PLANES = [[Planes(direction, (k + 0.5) / POSITIONS - 0.5) for k in range(POSITIONS)] for direction in CLASSES]


def layers_of(V, excesses):
    """For each class of directions, a layer at each position of the membrane."""
    return [[Layer(planes, V, excesses) for planes in of_class] for of_class in ALL_PLANES]


def by_class(measure, layers):
    """The mean over the positions of the membrane, for each class of directions."""
    return np.array([np.mean([measure(layer) for layer in of_class], axis=0) for of_class in layers])


def over_directions(of_classes):
    return SHARES @ of_classes


def root_mean_square(of_classes):
    return np.sqrt(SHARES @ of_classes**2)


def in_plane(E, n):
    plane = IDENTITY - np.outer(n, n)
    return plane @ E @ plane


def strain_along(E, n):
    """The part of E in the plane of the membrane, and the stretching along n that keeps the volume."""
    return in_plane(E, n) - np.trace(in_plane(E, n)) * np.outer(n, n)


def along(E, n):
    """(I - n n) E n"""
    return E @ n - (n @ E @ n) * n


def work_of_missing_stress(layer):
    """In cells of the inner fluid, times the square of the strain along the membrane."""
    n = layer.planes.n
    return sum(np.sum(in_plane(E, n) * layer.solve(E=strain_along(E, n))[3]) for E in SHEARS) / (2 * (layer.V - 1))


def slip_under_stress(layers):
    """In the direction of the stress, per unit of it."""

    def measure(layer):
        stresses = [along(E, layer.planes.n) for E in SHEARS]
        return [sum(stress @ layer.solve(stress=stress)[0] for stress in stresses), sum(stress @ stress for stress in stresses)]

    slip, square = over_directions(by_class(measure, layers))
    return slip / square


def excesses_for(V):
    """The excesses of viscosity and fluidity with which no stress is missing, and no stress causes slip."""

    def left(excesses):
        layers = layers_of(V, excesses)
        return [over_directions(by_class(work_of_missing_stress, layers)), slip_under_stress(layers)]

    return scipy.optimize.root(left, [0.2, 0.25], tol=1e-6).x


def slip_and_read(layer):
    """Under tangential forces, in their direction: the square of the force, the slip as the coefficients of 1 and s, and the velocity that is
    read as those of 1, s and s^2."""
    results = np.zeros(6)
    for force in [along(E, layer.planes.n) for E in SHEARS]:
        slip, read, read_by_slope, _ = layer.solve(force=force)
        slip_of_dipole, read_of_dipole, read_of_dipole_by_slope, _ = layer.solve(dipole=force)
        results += [v @ force for v in (force, slip, slip_of_dipole, read, read_of_dipole - read_by_slope, -read_of_dipole_by_slope)]
    return results


def slip_and_kink(layers):
    """The dipole strength s that cancels the slip, the kink C that is left then, and its deviation in each class of directions with forces."""
    coefficients = by_class(slip_and_read, layers)
    square, slip, slip_of_dipole, *_ = over_directions(coefficients)
    s = -slip / slip_of_dipole
    kinks = -coefficients[:, 3:] @ [1, s, s * s]
    C = over_directions(kinks) / square
    return s, C, np.divide(kinks, coefficients[:, 0], out=np.full(len(CLASSES), C), where=coefficients[:, 0] > 1e-9) - C


def tensions(layer):
    """Of normal forces, and of their normal dipoles with t = 1, times the forces."""
    n, t1, t2 = layer.planes.frame
    missing = [layer.solve(force=n)[3], layer.solve(dipole=2 * n)[3]]
    square = sum((n @ E @ n) ** 2 for E in SHEARS)
    return [-square * (t1 @ stress @ t1 + t2 @ stress @ t2) / 2 for stress in missing]


def normal_dipole(layers):
    """t, with which a normal force causes no tension."""
    of_force, of_dipole = over_directions(by_class(tensions, layers))
    return -of_force / of_dipole


def strains_along(layer):
    """One that changes areas, and the two shears."""
    n, t1, t2 = layer.planes.frame
    areal = np.outer(t1, t1) + np.outer(t2, t2) - 2 * np.outer(n, n)
    return areal, np.outer(t1, t1) - np.outer(t2, t2), np.outer(t1, t2) + np.outer(t2, t1)


def missing_stress(layer):
    """In cells of the inner fluid, under a strain that changes areas and under shear. The former causes three times the stress, since the
    pressure balances the stretching along n."""
    _, t1, t2 = layer.planes.frame
    areal, stretch, shear = (layer.solve(E=E)[3] for E in strains_along(layer))
    of_shear = ((t1 @ stretch @ t1 - t2 @ stretch @ t2) / 2 + t1 @ shear @ t2) / 2
    return np.array([(t1 @ areal @ t1 + t2 @ areal @ t2) / 6, of_shear]) / (2 * (layer.V - 1))


def slips_under_strain(layers):
    """The magnitudes under a strain that changes areas, and under the two shears (root mean square of both)."""

    def measure(layer):
        return [layer.solve(E=E)[0] for E in strains_along(layer)]

    areal, stretch, shear = np.linalg.norm(by_class(measure, layers), axis=2).T
    return areal, np.sqrt((stretch**2 + shear**2) / 2)


def main():
    print("<!-- made by flat_membrane.py -->\n")
    print("| V | viscosity | fluidity | s | C | t | left: slip under change of areas | under shear | C | missing stress: change of areas | shear |")
    print("|---" * 11 + "|")
    _, C, _ = slip_and_kink(layers_of(1, (0, 0)))
    print(f"| 1 | 0 | 0 | 0 | {C:.4f} | 0 | | | | | |", flush=True)
    for V in (1.5, 2, 3, 4, 5, 7, 10, 20, 50):
        excesses = excesses_for(V)
        layers = layers_of(V, excesses)
        s, C, deviations = slip_and_kink(layers)
        left = [*slips_under_strain(layers), deviations, *by_class(missing_stress, layers).T]
        constants = [f"{x:.4f}" for x in (*excesses, s, C, normal_dipole(layers))]
        print(f"| {V} | " + " | ".join(constants + [f"{root_mean_square(x):.3f}" for x in left]) + " |", flush=True)


if __name__ == "__main__":
    main()
