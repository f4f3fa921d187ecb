"""Pictures of two-dimensional packings, as contents of a panel: discs, forces of their contacts, velocities."""
from .charts import BLUE, GREEN, GREY, ORANGE, RED
from .errors import package


def frame(length_x, length_y):
    """A box from the origin on."""
    def paint(axes):
        axes.add_patch(package("matplotlib.patches").Rectangle((0, 0), length_x, length_y, fill=False, color="black"))
    return paint


def packing(run, width, across, arrow):
    """Discs at the end of a run with their ids, and forces of their contacts; those without contacts in orange, with an
    arrow of a length (m) along their velocity. width: of the lines of normal forces (points/N); across: length of those
    of tangential forces (m/N)."""
    contacts, discs = run.contacts(), run.bodies().set_index("id")
    touching = {*contacts.a, *contacts.b.dropna()}

    def paint(axes):
        draw_forces(axes, contacts, discs[["x", "y"]], width, across)
        for name, disc in discs.iterrows():
            draw_disc(axes, name, disc, None if name in touching else arrow)
    return paint


def draw_forces(axes, contacts, centres, width, across):
    """Lines between centres, or to walls, as wide as normal forces; lines across them as long as tangential forces."""
    numpy = package("numpy")
    for _, contact in contacts.iterrows():
        begin, point = centres.loc[contact.a].to_numpy(), contact[["x", "y"]].to_numpy(float)
        normal, force = (contact[[f"{name}_x", f"{name}_y"]].to_numpy(float) for name in ("normal", "force"))
        end = point + normal * contact.overlap / 2 if contact.wall else centres.loc[contact.b].to_numpy()
        axes.plot(*zip(begin, end), color=BLUE, linewidth=width * (force @ normal))
        middle, along = (begin + end) / 2, numpy.array([normal[1], -normal[0]])
        half = across * abs(force @ along) * along
        axes.plot(*zip(middle - half, middle + half), color=RED, linewidth=2, zorder=4)


def draw_disc(axes, name, disc, arrow):
    """A disc with its id, and an arrow of a length along its velocity unless the length is None."""
    numpy, patches = package("numpy"), package("matplotlib.patches")
    place, colour = numpy.array([disc.x, disc.y]), "#eeeeee" if arrow is None else ORANGE
    axes.add_patch(patches.Circle(place, disc.radius, facecolor=colour, edgecolor=GREY))
    white = {"boxstyle": "round,pad=0.15", "facecolor": "white", "edgecolor": "none", "alpha": 0.8}
    axes.annotate(f"{name}", place, ha="center", va="center", fontsize=8, zorder=3, bbox=white)
    if arrow is not None:
        velocity = numpy.array([disc.vx, disc.vy])
        end = place + arrow * velocity / (numpy.linalg.norm(velocity) or 1)
        axes.annotate("", end, place, arrowprops={"arrowstyle": "->", "color": GREEN, "linewidth": 1.8}, zorder=4)
