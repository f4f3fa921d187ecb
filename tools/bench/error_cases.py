"""Cases of `tools/bench/peers --error`: contact laws, initial bodies, and known results."""
import csv
import dataclasses
import math
import random
import typing

import packings

RADIUS, DENSITY, PHASES = 0.005, 2500.0, 8
MASS = DENSITY * 4 / 3 * math.pi * RADIUS**3
YOUNG, POISSON = 5e8, 0.25  # LIGGGHTS refuses more than 1e9 Pa
STIFFNESS = 1e8  # high, so that the line of centres rotates little during a sliding contact
SPACING = 8 * RADIUS  # between pairs, which never interact
WAIT = 2  # steps before the first contact begins


@dataclasses.dataclass
class Law:
    """One contact law, translated for each code by error_codes."""
    kind: str  # "linear" or "hertz"
    restitution: float
    friction: float = 0.0
    young: float = YOUNG
    stiffness: float = STIFFNESS
    mass: float = MASS / 2  # of a pair, m*; the dashpots of linear contacts are the same for all pairs
    history: str = ""  # of scree's Hertz-Mindlin springs; "" is its default
    lammps_history: str = "mindlin_rescale/force"

    def damping(self):
        """Damping ratio for the restitution of a contact with tensile dashpot force."""
        log = math.log(self.restitution)
        return -log / math.hypot(math.pi, log)

    def dashpots(self):
        """Damping coefficients of linear contacts, kg/s: normal, tangential."""
        normal = 2 * self.damping() * math.sqrt(self.stiffness * self.mass)
        return normal, 0.5 * normal

    def tangential_stiffness(self):
        return 2 / 7 * self.stiffness

    def tangential_over_normal(self):
        """Ratio of tangential to normal damping of Hertz contacts in scree and LIGGGHTS: 2 sqrt(G*/E*)."""
        modulus, shear = self.young / (2 * (1 - POISSON**2)), self.young / (4 * (2 - POISSON) * (1 + POISSON))
        return 2 * math.sqrt(shear / modulus)

    def contact_time(self, speed, reduced_radius=RADIUS / 2):
        """Contact time of an elastic contact, s."""
        if self.kind == "linear":
            return math.pi * math.sqrt(self.mass / self.stiffness)
        stiffness = self.young / (2 * (1 - POISSON**2)) * math.sqrt(reduced_radius)
        overlap = (15 * self.mass * speed**2 / (16 * stiffness)) ** 0.4
        return 2.9432750 * overlap / speed


@dataclasses.dataclass
class Body:
    position: list
    velocity: list
    spin: list
    radius: float = RADIUS


@dataclasses.dataclass
class Scene:
    """Initial state for every code."""
    bodies: list
    bounds: list  # (low, high) of each axis
    periodic: bool
    law: Law
    step: float
    steps: int
    skin: float  # of the neighbour lists of LIGGGHTS and LAMMPS; scree chooses its own


@dataclasses.dataclass
class Case:
    name: str
    title: str
    law: Law
    ladder: list  # steps per contact, coarse to fine
    reference: int  # steps per contact of the converged run of each code
    scene: typing.Callable  # (case, steps per contact, copies) -> Scene
    error: typing.Callable  # (case, state, reference) -> relative error
    contact_time: float
    timed: tuple  # steps per contact and copies for the timing
    unit: tuple  # time per what, its unit, microseconds per unit
    known: typing.Callable = lambda case, state: ""  # comparison of the converged result with theory
    duration: int = 1  # duration of the timed unit, in contacts


# --- impacts of two spheres -------------------------------------------------------------------------------------------


@dataclasses.dataclass
class Impact(Case):
    normal: float = 0.2  # relative speed along the line of centres
    tangential: float = 0.0


def impact_scene(case, fineness, copies):
    """PHASES x copies pairs that collide along x, with the start of contact spread over a step."""
    step = case.contact_time / fineness
    pairs, bodies = PHASES * copies, []
    row = math.ceil(math.sqrt(pairs))
    for k in range(pairs):
        touch = (WAIT + (k % PHASES + 0.37) / PHASES) * step  # never at the end of a step, where round-off matters
        centre = (0.0, SPACING * (k % row), SPACING * (k // row))
        for side in (-1, 1):
            velocity = [-side * case.normal / 2, -side * case.tangential / 2, 0.0]
            at_touch = (centre[0] + side * RADIUS, centre[1], centre[2])
            bodies.append(Body([x - v * touch for x, v in zip(at_touch, velocity)], velocity, [0.0, 0.0, 0.0]))
    bounds = [(-SPACING, SPACING)] + [(-SPACING, SPACING * (row + 1))] * 2
    steps = math.ceil(WAIT + 1 + (1.6 if copies == 1 else 1.02) * fineness)
    return Scene(bodies, bounds, False, case.law, step, steps, 0.2 * RADIUS)


def outcomes(state):
    """Velocities after the impact of each pair: both bodies, spins times the radius."""
    moving = [(*body.velocity, *(RADIUS * w for w in body.spin)) for body in state]
    return [a + b for a, b in zip(moving[::2], moving[1::2])]


def impact_error(case, state, reference):
    """Root mean square over the phases, relative to the change of velocity."""
    for a, b in zip(state[::2], state[1::2]):
        if math.dist(a.position, b.position) < a.radius + b.radius:
            return math.inf  # still in contact: the step is too long
    mean = [sum(column) / PHASES for column in zip(*outcomes(reference))]
    before = outcomes(impact_scene(case, 1, 1).bodies)[0]
    total = sum(math.dist(one, mean) ** 2 for one in outcomes(state)) / PHASES
    return math.sqrt(total) / math.dist(before, mean)


def impact_known(case, state):
    """Deviation of restitution and sliding impulse from their closed forms."""
    mean = [sum(column) / PHASES for column in zip(*outcomes(state))]
    normal, tangential = mean[6] - mean[0], case.tangential - (mean[1] - mean[7])
    if not case.tangential:
        return f"e = {normal / case.normal:.6f}"
    if case.law.kind == "linear":
        slide = tangential / (case.law.friction * (1 + case.law.restitution) * case.normal)
        return f"friction impulse / mu(1+e)v_n = {slide:.4f}"
    return f"friction impulse {tangential / case.tangential:.4f} v_t"


# Not integers: with these a contact would end at the same phase of a step as it began, and errors of both ends cancel.
LADDER = [4.2 * 1.5**k for k in range(21)]


def impact(name, title, law, tangential=0.0):
    normal = 0.2
    return Impact(name, title, law, LADDER, 16 * LADDER[-1], impact_scene, impact_error, law.contact_time(normal),
                  (8192, 32), ("contact", "µs", 1.0), impact_known, normal=normal, tangential=normal * tangential)


# --- many bodies ------------------------------------------------------------------------------------------------------


@dataclasses.dataclass
class Many(Case):
    scale: float = 1.0  # reference length of position errors, m
    start: tuple = ()  # bodies, period


def many_scene(case, fineness, _):
    bodies, period = case.start
    steps = round(case.duration * fineness)
    return Scene(bodies, [(0.0, period)] * 3, True, case.law, case.duration * case.contact_time / steps, steps,
                 0.3 * min(body.radius for body in bodies))


def many_error(case, state, reference):
    packing = [[(*body.position, body.radius) for body in each] for each in (state, reference)]
    return packings.difference(*packing, [case.start[1]] * 3) / case.scale


def many_known(case, state):
    touching = packings.overlaps([(*body.position, body.radius) for body in state], [case.start[1]] * 3)
    return f"{len(touching)} contacts after {case.duration * case.contact_time * 1e3:.3g} ms"


def gas_start(count=6, spacing=2.6, seed=1):
    """A lattice of count^3 spheres with small displacements, random velocities and spins; spacing in radii."""
    pick, period = random.Random(seed), count * spacing * RADIUS
    bodies = [Body([(c + 0.5) * spacing * RADIUS + pick.uniform(-0.25, 0.25) * RADIUS for c in cell],
                   [pick.gauss(0, 0.5) for _ in range(3)], [pick.gauss(0, 50) for _ in range(3)])
              for cell in ((i, j, k) for i in range(count) for j in range(count) for k in range(count))]
    return bodies, period


def gas():
    law = Law("linear", 0.9, 0.3, stiffness=1e5)
    return Many("gas", "gas of 216 spheres, e = 0.9, μ = 0.3", law, LADDER[:15], 65536, many_scene, many_error,
                law.contact_time(1.0), (128, 1), ("run", "ms", 1e3), many_known, duration=40, scale=RADIUS,
                start=gas_start())


def assembly_start(seed=1):
    """The packing of scenes/beads-256.csv with small initial velocities."""
    pick = random.Random(seed)
    with open(packings.SCENES / "beads-256.csv") as lines:
        period = float(lines.readline().split()[-1])
        rows = list(csv.DictReader(lines))
    bodies = [Body([float(row[axis]) for axis in "xyz"], [pick.gauss(0, 0.01) for _ in range(3)], [0.0] * 3,
                   float(row["radius"])) for row in rows]
    return bodies, period


def assembly():
    bodies, period = assembly_start()
    depths = packings.overlaps([(*body.position, body.radius) for body in bodies], [period] * 3)
    overlap, radius = sum(depths) / len(depths), sum(body.radius for body in bodies) / len(bodies)
    law = Law("hertz", 0.9, 0.22, young=2e8, mass=DENSITY * 2 / 3 * math.pi * radius**3)
    # Half the period of the fastest oscillation of beads on their contacts serves as contact time.
    stiffness = 2 * law.young / (2 * (1 - POISSON**2)) * math.sqrt(radius / 2 * overlap)
    time = math.pi * math.sqrt(law.mass / stiffness)
    return Many("assembly", "256 beads, Hertz-Mindlin, e = 0.9, μ = 0.22", law, LADDER[:15], 20480, many_scene,
                many_error, time, (128, 1), ("run", "ms", 1e3), many_known, duration=16, scale=overlap,
                start=(bodies, period))


def all_cases():
    """All cases by name, in the order of the table."""
    to_20, to_45, to_75 = (math.tan(math.radians(angle)) for angle in (20, 45, 75))
    damped = (0.5, 0.9)
    cases = [impact(f"linear-{e}", f"linear, e = {e}", Law("linear", e)) for e in damped]
    cases += [impact(f"sliding-{e}", f"linear, sliding at 75°, e = {e}", Law("linear", e, 0.3), to_75) for e in damped]
    cases += [impact(f"hertz-{e}", f"Hertz, e = {e}", Law("hertz", e)) for e in damped]
    # Friction so high that nothing slides; requires e = 1, as under tension the friction limit is 0.
    cases.append(impact("sticking-1", "Hertz-Mindlin, sticking at 45°, e = 1", Law("hertz", 1.0, 1000.0), to_45))
    cases.append(impact("sticking-0.9", "Hertz-Mindlin, 20°, e = 0.9, μ = 0.8", Law("hertz", 0.9, 0.8), to_20))
    cases.append(impact("elastic-linear", "linear, e = 1", Law("linear", 1.0)))
    cases.append(impact("elastic-hertz", "Hertz, e = 1", Law("hertz", 1.0)))
    cases += [assembly(), gas()]
    return {case.name: case for case in cases}
