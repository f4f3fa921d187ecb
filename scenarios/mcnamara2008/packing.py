"""A packing of discs with the forces of its contacts, as in figure 16 of McNamara et al. (2008)."""
from series import numpy
from style import BLUE, GREEN, GREY, ORANGE, RED, label, pyplot

NORMAL, FORCE = ["normal_x", "normal_y"], ["force_x", "force_y"]


def draw_forces(axes, contacts, centres):
    """A line between centres, or to a wall, as wide as the normal force; one across it as long as the tangential force."""
    for _, contact in contacts.iterrows():
        begin, point = centres.loc[contact.a].to_numpy(), contact[["x", "y"]].to_numpy(float)
        normal, force = contact[NORMAL].to_numpy(float), contact[FORCE].to_numpy(float)
        end = point + normal * contact.overlap / 2 if contact.wall else centres.loc[contact.b].to_numpy()
        axes.plot(*zip(begin, end), color=BLUE, linewidth=8 * (force @ normal))
        middle, along = (begin + end) / 2, numpy.array([normal[1], -normal[0]])
        across = 3 * abs(force @ along) * along  # L for 1 N, of which there are hundredths
        axes.plot(*zip(middle - across, middle + across), color=RED, linewidth=2, zorder=4)


def draw_packing(axes, run):
    """Discs at the end, their forces, and velocities of discs without contacts."""
    contacts, box = run.contacts(), run.series["load"].iloc[-1]
    discs = run.bodies().set_index("id")
    touching = {*contacts.a, *contacts.b.dropna()}
    axes.add_patch(pyplot.Rectangle((0, 0), box.length_x, box.length_y, fill=False, color="black"))
    draw_forces(axes, contacts, discs[["x", "y"]])
    for name, disc in discs.iterrows():
        place = numpy.array([disc.x, disc.y])
        colour = "#eeeeee" if name in touching else ORANGE
        axes.add_patch(pyplot.Circle(place, disc.radius, facecolor=colour, edgecolor=GREY))
        white = {"boxstyle": "round,pad=0.15", "facecolor": "white", "edgecolor": "none", "alpha": 0.8}
        axes.annotate(f"{name}", place, ha="center", va="center", fontsize=8, zorder=3, bbox=white)
        if name not in touching:
            velocity = numpy.array([disc.vx, disc.vy])
            end = place + 0.12 * velocity / (numpy.linalg.norm(velocity) or 1)
            axes.annotate("", end, place, arrowprops={"arrowstyle": "->", "color": GREEN, "linewidth": 1.8}, zorder=4)
    axes.set(xlim=(-0.02, box.length_x + 0.02), ylim=(-0.02, box.length_y + 0.02), aspect="equal")
    title = f"Packing {run.row['seed']} (figure 16): normal forces blue,\ntangential red across them, velocity green"
    label(axes, title, "$x$ / L", "$y$ / L")
    axes.grid(False)
