"""The pictures of a gate run: free end against the published curves, the flow every 0.04 s, the stresses in the gate."""
import numpy as np

from gate_outline import fluid_spacing_by_id, spacing_of
from lib import style
from lib.run_output import FLUID, SOLID, WALL

FLOW_TIMES = np.arange(0.0, 0.41, 0.04)  # the paper's Fig. 13
STRESS_TIME = 0.15                       # the paper's Figs. 16-18
MAX_PRESSURE = 1400                      # Pa: hydrostatic at the floor
EXPERIMENT_ERROR = 2.0                   # mm: by how much two digitisations of the measured curve differ

PUBLISHED = (  # column, label, colour, line style
    ("paper_sph", "Antoci 2007, SPH", style.ORANGE, (0, (5, 2))),
    ("yang2012", "Yang 2012, SPH-FEM", style.GREEN, (0, (1, 1.2))),
    ("khayyer2018", "Khayyer 2018, ISPH-SPH", style.PURPLE, (0, (4, 1.5, 1, 1.5))),
    ("ng2020", "Ng 2020, SPH-VCPM", style.SKY, (0, (2, 1))),
)


def draw_displacement(runs, reference, mean, path):
    """runs: (label, run), from the coarsest to the finest; curves that agree are seen one within the other."""
    plt = style.use()
    figure, (*axes, below) = plt.subplots(3, 1, figsize=(6.3, 7.0), layout="constrained",
                                          gridspec_kw={"height_ratios": (1, 1, 0.22)})
    for axis, component, label in zip(axes, "xy", ("horizontal displacement", "vertical displacement")):
        t, experiment = reference["t_s"], mean[component]
        axis.fill_between(t, experiment - EXPERIMENT_ERROR, experiment + EXPERIMENT_ERROR, color="0.86", linewidth=0,
                          label=f"experiment ± {EXPERIMENT_ERROR:g} mm")
        for name, marker in (("exp1", "o"), ("exp2", "s")):
            axis.plot(t, reference[f"{name}_{component}"], marker, markersize=3.2, markerfacecolor="white",
                      markeredgecolor="0.25", markeredgewidth=0.7, label=f"experiment, digitisation {name[-1]}")
        for name, text, colour, dashes in PUBLISHED:
            axis.plot(t, reference[f"{name}_{component}"], color=colour, linestyle=dashes, linewidth=1.2, label=text)
        for i, (text, run) in enumerate(runs):
            left = len(runs) - 1 - i
            axis.plot(run.time, 1e3 * run.probe(f"free_end.{component}"), color=style.BLUE, linewidth=2.0 + 1.8 * left,
                      alpha=1 / (1 + 1.5 * left), solid_capstyle="butt", label=text)
        axis.set_ylabel(f"{label} [mm]")
        axis.grid(color="0.92", linewidth=0.5)
        axis.set_axisbelow(True)
        axis.set_xlim(0, 0.4)
    axes[0].set_ylim(-2, 56)
    axes[1].set_ylim(-1, 23)
    axes[0].tick_params(labelbottom=False)
    axes[1].set_xlabel("time [s]")
    handles, labels = axes[0].get_legend_handles_labels()
    order = sorted(range(len(labels)), key=lambda i: not labels[i].startswith("sluice"))
    below.axis("off")
    below.legend([handles[i] for i in order], [labels[i] for i in order], loc="center", ncol=3, fontsize=8)
    style.save(figure, path)


def draw_flow(run, path):
    """Frames like the paper's Fig. 13: water coloured by pressure, the gate by von Mises stress."""
    plt = style.use()
    times = [t for t in FLOW_TIMES if t <= run.frame_times().max() + 1e-6]
    columns = min(3, len(times))
    rows = -(-len(times) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(3.4 * columns + 0.4, 2.2 * rows + 1.2), squeeze=False,
                                layout="constrained")
    top_stress = max(_typical_top(run.frame_near(t)) for t in times)
    water = style.scale(style.WATER, 0, MAX_PRESSURE)
    rubber = style.scale(style.RUBBER, 0, 1e-3 * top_stress)
    for i, axis in enumerate(axes.flat):
        _prepare_axis(axis, labels_below=i + columns >= len(times), label_left=i % columns == 0)
        axis.set_visible(i < len(times))
    for scale, label in ((water, "pressure of the water [Pa]"), (rubber, "von Mises stress in the gate [kPa]")):
        figure.colorbar(scale, ax=axes, location="bottom", aspect=50, shrink=0.6, label=label, extend="max")
    figure.draw_without_rendering()  # fixes the axes' sizes, from which the dots' sizes follow
    spacing = fluid_spacing_by_id(run.frame_near(0.0))
    for axis, time in zip(axes.flat, times):
        _draw_frame(axis, run.frame_near(time), spacing, water, rubber)
    style.save(figure, path)


def _prepare_axis(axis, labels_below, label_left):
    axis.set_xlim(-0.105, 0.16)
    axis.set_ylim(-0.004, 0.152)
    axis.set_aspect("equal")
    axis.set_xticks(np.arange(-0.1, 0.16, 0.05), [f"{v:g}" for v in range(-100, 160, 50)])
    axis.set_yticks(np.arange(0, 0.16, 0.05), [f"{v:g}" for v in range(0, 160, 50)])
    axis.tick_params(labelbottom=labels_below, labelleft=label_left)
    axis.set_xlabel("x [mm]" if labels_below else "")
    axis.set_ylabel("y [mm]" if label_left else "")
    axis.plot([-0.1, -0.1, 0.16], [0.15, 0, 0], color=style.WALL_GREY, linewidth=1.2, zorder=0)


def _draw_frame(axis, frame, spacing, water, rubber):
    fluid, solid, wall = frame.of(FLUID), frame.of(SOLID), frame.of(WALL)
    d = spacing[frame["id"][fluid].astype(int)]
    axis.scatter(*frame.points[fluid].T, s=style.dot_area(axis, d), c=water.to_rgba(frame["pressure"][fluid]),
                 linewidths=0)
    near = d.min()  # the gate and its wall are as fine as the water beside them
    axis.scatter(*frame.points[wall].T, s=style.dot_area(axis, near), c=style.WALL_GREY, linewidths=0, marker="s")
    axis.scatter(*frame.points[solid].T, s=style.dot_area(axis, near), linewidths=0,
                 c=rubber.to_rgba(1e-3 * _von_mises(frame)[solid]))
    axis.set_title(f"t = {frame.time:.2f} s", loc="left")


def draw_stress(run, path, time=STRESS_TIME):
    """σ_xx, σ_yy and σ_xy in the gate, on the paper's scales of ±150 and ±200 kPa for the first and the last."""
    plt = style.use()
    frame = run.frame_near(time)
    solid = frame.of(SOLID)
    x, y = 1e3 * frame.points[solid].T
    figure, axes = plt.subplots(1, 3, figsize=(8.4, 4.3), sharey=True, layout="constrained")
    for axis in axes:
        axis.set_xlim(x.min() - 3, x.max() + 3)
        axis.set_ylim(y.min() - 3, y.max() + 3)
        axis.set_aspect("equal")
        axis.set_xlabel("x [mm]")
    axes[0].set_ylabel("y [mm]")
    yy = 50 * np.ceil(np.percentile(np.abs(frame["stress_yy"][solid]), 99) / 50e3)
    panels = (("stress_xx", r"$\sigma_{xx}$", 150), ("stress_yy", r"$\sigma_{yy}$", max(yy, 50)),
              ("stress_xy", r"$\sigma_{xy}$", 200))
    bars = [(axis, axis.scatter(x, y, s=1, c=1e-3 * frame[name][solid], cmap=style.SIGNED, vmin=-top, vmax=top,
                                linewidths=0), label)
            for axis, (name, label, top) in zip(axes, panels)]
    for axis, dots, label in bars:
        figure.colorbar(dots, ax=axis, location="bottom", aspect=22, label=f"{label} [kPa]", extend="both")
    figure.draw_without_rendering()
    d = 1e3 * spacing_of(run.frame_near(0.0).points[run.frame_near(0.0).of(SOLID), 0])
    for axis, dots, _ in bars:
        dots.set_sizes([1.5 * style.dot_area(axis, d)])
    figure.suptitle(f"Stress in the gate at t = {frame.time:.2f} s", x=0.01, ha="left", fontsize=9)
    style.save(figure, path)


def _von_mises(frame):
    if "von_mises" in frame:
        return frame["von_mises"]
    xx, yy, xy = frame["stress_xx"], frame["stress_yy"], frame["stress_xy"]
    zz = frame["stress_zz"] if "stress_zz" in frame else 0.5 * (xx + yy)
    return np.sqrt(0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) + 3 * xy ** 2)


def _typical_top(frame):
    """The stress that one particle in fifty of the gate exceeds."""
    return max(float(np.percentile(_von_mises(frame)[frame.of(SOLID)], 98)), 1e3)
