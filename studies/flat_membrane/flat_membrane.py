#!/usr/bin/python3
"""Solves the composite lattice exactly around a flat membrane, and prints what its coupling does to first order in dx.

    studies/flat_membrane/flat_membrane.py > studies/flat_membrane/results.md      half a minute

Units: dx = mu_a = 1. The membrane lies at z = 0 across the normal n, the inner fluid at z < 0. Everything depends on z only, apart from an
imposed velocity E x, so that the moments of the planes of cells across n are the unknowns: the density, the momentum and the stress P of
solver/fluid/quasisteady/moment_sweep.hpp, with the stresses of stress_tensor.hpp and the coupling of solver/coupling/membrane_layer.hpp.
"""
import itertools

import numpy as np
import scipy.linalg
import scipy.spatial

HALF_WIDTH = 0.5  # of the jump of the viscosity
REACH = 9  # beyond this distance kernels, jump and their effects are over
POSITIONS = 4  # of the membrane between two planes
CLASSES = [(1, 0, 0), (1, 1, 0), (1, 1, 1), (2, 1, 0), (2, 1, 1), (2, 2, 1), (3, 1, 0), (3, 1, 1), (3, 2, 1)]  # of directions of n

LINKS = [np.array(e) for e in itertools.product((-1, 0, 1), repeat=3) if sum(map(abs, e)) <= 2]
WEIGHTS = [{0: 1 / 3, 1: 1 / 18, 2: 1 / 36}[int(abs(e).sum())] for e in LINKS]
PAIRS = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]
COUNTS = np.array([1, 1, 1, 2, 2, 2])  # of the components of a symmetric tensor
IDENTITY = np.eye(3)


def components(tensor):
    return np.array([tensor[pair] for pair in PAIRS])


def traceless(tensor):
    return tensor - np.trace(tensor) / 3 * IDENTITY


def tensor_map(function):
    """The matrix of a linear function of symmetric tensors."""
    columns = []
    for k, (i, j) in enumerate(PAIRS):
        unit = np.zeros((3, 3))
        unit[i, j] = unit[j, i] = 1
        columns.append(components(function(unit)))
    return np.array(columns).T


TRACELESS = tensor_map(traceless)
SENT = [4.5 * components(np.outer(e, e)) * COUNTS for e in LINKS]  # what Q contributes to phi of a link
RECEIVED = [components(traceless(np.outer(e, e))) for e in LINKS]  # what a population contributes to P**


def factor(ratio):
    return 1 - 2 / (1 + ratio)


def inner_part(z):
    s = np.clip(z / HALF_WIDTH, -1, 1)
    return (1 - s - np.sin(np.pi * s) / np.pi) / 2


def shear_of(P, n):
    t = (IDENTITY - np.outer(n, n)) @ P @ n
    return np.outer(n, t) + np.outer(t, n)


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


class Layer:
    """The planes of cells around a membrane, with the jumps of both means of the viscosity at the membrane.

    with_b: whether (b) of stress_tensor.hpp is added, as in the solver for V > 1"""

    def __init__(self, direction, V, offset, with_b):
        self.V, self.direction = V, np.array(direction)
        self.n = frame(direction)[0]
        self.h = 1 / np.linalg.norm(direction)
        self.beyond = max(int(abs(e @ self.direction)) for e in LINKS)  # planes that a link spans
        half = int(np.ceil(REACH / self.h))
        self.z = (np.arange(-half, half + 1) + offset) * self.h
        all_z = self.h * np.arange(-self.beyond, len(self.z) + self.beyond) + self.z[0]
        c = factor(1 + (V - 1) * inner_part(all_z))
        harmonic = factor(1 / (1 + (1 / V - 1) * inner_part(all_z)))
        shear = tensor_map(lambda P: shear_of(traceless(P), self.n))
        self.passed = [c[i] * TRACELESS + (harmonic[i] - c[i]) * shear for i in range(len(all_z))]
        self.without_shear = [c[i] * (TRACELESS - shear) for i in range(len(all_z))]
        self.kernel, self.slope = kernels(self.n, self.z)
        matrix, self.beyond_ends = self.assemble()
        if with_b:
            self.add_b(matrix)
        self.factors = scipy.linalg.lu_factor(matrix)

    def assemble(self):
        """m - m** as a matrix, and for each plane the terms of moments of planes beyond the ends. Beyond the outer end the fluid moves like
        the last plane."""
        planes = len(self.z)
        matrix, beyond_ends = np.eye(10 * planes), []
        for j, (link, weight, sent, received) in itertools.product(range(planes), zip(LINKS, WEIGHTS, SENT, RECEIVED)):
            source = j - int(link @ self.direction)
            phi = np.concatenate([[1], 3 * link, sent @ self.passed[source + self.beyond]])
            term = weight * np.outer(np.concatenate([[1], link, received]), phi)
            rows = slice(10 * j, 10 * j + 10)
            if 0 <= source < planes:
                matrix[rows, 10 * source : 10 * source + 10] -= term
            else:
                beyond_ends.append((j, source, term))
                if source >= planes:
                    matrix[rows, 10 * planes - 9 : 10 * planes - 6] -= term[:, 1:4]
        return matrix, beyond_ends

    def add_b(self, matrix):
        """D = L[c P' - A[c P']]. The inner end has a uniform stress, of which D is 0."""
        planes = len(self.z)
        difference = np.zeros((6 * planes, 6 * planes))
        smoothed = np.zeros((planes, planes))
        binomial = np.array([1, 4, 6, 4, 1]) / 16
        steps = [(np.dot(step, self.direction), np.prod(binomial[np.array(step) + 2])) for step in itertools.product(range(-2, 3), repeat=3)]
        for j in range(planes):
            difference[6 * j : 6 * j + 6, 6 * j : 6 * j + 6] += TRACELESS
            for link, weight, sent, received in zip(LINKS, WEIGHTS, SENT, RECEIVED):
                source = max(j - int(link @ self.direction), 0)
                if source < planes:
                    difference[6 * j : 6 * j + 6, 6 * source : 6 * source + 6] -= weight * np.outer(received, sent)
            for step, share in steps:
                source = max(j - step, 0)
                if source < planes:
                    smoothed[j, source] += share
        operator = np.kron(smoothed, np.eye(6)) @ difference
        operator[np.repeat(self.z < -REACH + 3.5, 6)] = 0
        for j, i in itertools.product(range(planes), repeat=2):
            block = operator[6 * j : 6 * j + 6, 6 * i : 6 * i + 6]
            if block.any():
                matrix[10 * j + 4 : 10 * j + 10, 10 * i + 4 : 10 * i + 10] -= block @ self.without_shear[i + self.beyond]

    def far(self, ratio, E, stress):
        """Density, slope of the velocity and P far from the membrane, in a fluid of this viscosity ratio."""
        slope = stress / ratio
        strain = E + (np.outer(slope, self.n) + np.outer(self.n, slope)) / 2
        return (ratio - 1) * self.n @ E @ self.n, slope, -2 / 3 * components(strain) / (1 - factor(ratio))

    def solve(self, force=np.zeros(3), E=np.zeros((3, 3)), s=0):
        """Under a tangential force of the membrane and the strain rate E. Returns by how much the outer fluid slips, the
        velocity that is read, and the stress along the membrane that is missing, in units of that of a cell under E = 1 in ambient fluid."""
        planes = len(self.z)
        inside, outside = self.far(self.V, E, force / 2), self.far(1, E, -force / 2)
        spread = np.outer(self.kernel - s * self.slope, force)
        right = np.zeros((planes, 10))
        right[:, 1:4] = spread / 6
        right[:, 4:] = components(traceless(-2 / 3 * E))
        for j, source, term in self.beyond_ends:
            rho, slope, P = inside if source < 0 else outside
            z = self.z[0] + self.h * source if source < 0 else self.h * (source - planes + 1)
            right[j] += term @ np.concatenate([[rho], slope * z, P])
        moments = scipy.linalg.lu_solve(self.factors, right.ravel()).reshape(planes, 10)
        slip = moments[-1, 1:4] - outside[1] * self.z[-1]
        read = self.h * ((self.kernel - s * self.slope)[:, None] * (moments[:, 1:4] - spread / 12)).sum(axis=0)
        passed = np.array([m[0] / 3 * components(IDENTITY) + self.passed[j + self.beyond] @ m[4:] for j, m in enumerate(moments)])
        sharp = inside[0] / 3 * components(IDENTITY) + factor(self.V) * inside[2]
        missing = 3 * (self.h * passed.sum(axis=0) - (self.h / 2 - self.z[0]) * sharp)
        full = np.zeros((3, 3))
        for pair, value in zip(PAIRS, missing):
            full[pair] = full[pair[::-1]] = value
        return slip, read, full


def layers_of(V, with_b):
    """For each class of directions, a layer at each position of the membrane."""
    return [[Layer(direction, V, (k + 0.5) / POSITIONS - 0.5, with_b) for k in range(POSITIONS)] for direction in CLASSES]


def in_the_mean(measure, layers):
    return np.mean([measure(layer) for layer in layers], axis=0)


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


def over_directions(measure, layers):
    return sum(share * in_the_mean(measure, of_class) for of_class, share in zip(layers, SHARES))


def slip_and_read(layer, s):
    """Of a unit force, in its direction."""
    results = []
    for t in frame(layer.direction)[1:]:
        slip, read, _ = layer.solve(force=t, s=s)
        results.append([slip @ t, read @ t])
    return np.mean(results, axis=0)


def slip_and_kink(layers, V):
    """s and C of membrane_layer.hpp. The slip is linear in s, the velocity that is read is quadratic."""
    at_0, at_1, at_minus_1 = over_directions(lambda layer: [slip_and_read(layer, s) for s in (0, 1, -1)], layers)
    s = 0 if V == 1 else at_0[0] / (at_0[0] - at_1[0])
    linear, quadratic = (at_1[1] - at_minus_1[1]) / 2, (at_1[1] + at_minus_1[1]) / 2 - at_0[1]
    return s, -(at_0[1] + linear * s + quadratic * s * s)


def strains_along(layer):
    """One that changes areas, and the two shears."""
    n, t1, t2 = frame(layer.direction)
    areal = np.outer(t1, t1) + np.outer(t2, t2) - 2 * np.outer(n, n)
    return areal, np.outer(t1, t1) - np.outer(t2, t2), np.outer(t1, t2) + np.outer(t2, t1)


def missing_stress(layers, V):
    """In cells of the inner fluid, under a strain that changes areas and under shear."""

    def measure(layer):
        _, t1, t2 = frame(layer.direction)
        areal, stretch, shear = (layer.solve(E=E)[2] for E in strains_along(layer))
        return [(t1 @ areal @ t1 + t2 @ areal @ t2) / 6, ((t1 @ stretch @ t1 - t2 @ stretch @ t2) / 2 + t1 @ shear @ t2) / 2]

    return over_directions(measure, layers) / (V - 1)


def slip_under_strain(layers):
    """Root mean square over the directions, under a strain that changes areas."""

    def measure(layer):
        return layer.solve(E=strains_along(layer)[0])[0]

    slips = [in_the_mean(measure, of_class) for of_class in layers]
    return np.sqrt(np.average([slip @ slip for slip in slips], weights=SHARES))


def main():
    print("<!-- made by flat_membrane.py -->\n")
    print("| V | s | C | missing stress: change of areas | shear | mean of the three strains | 0.15 (V - 1)/(V + 2.85) | slip under strain | without (b) |")
    print("|---" * 9 + "|")
    for V in (0.2, 0.5, 1, 2, 3, 4, 5, 7, 10, 12):
        layers = layers_of(V, with_b=V > 1)
        s, C = slip_and_kink(layers, V)
        row = f"| {V} | {s:.3f} | {C:.3f} |"
        if V != 1:
            areal, shear = missing_stress(layers, V)
            row += f" {areal:.3f} | {shear:.3f} | {(areal + 2 * shear) / 3:.3f} | {0.15 * (V - 1) / (V + 2.85):.3f} |"
            row += f" {slip_under_strain(layers):.3f} | {slip_under_strain(layers_of(V, with_b=False)):.3f} |"
        else:
            row += " | | | | | |"
        print(row, flush=True)


if __name__ == "__main__":
    main()
