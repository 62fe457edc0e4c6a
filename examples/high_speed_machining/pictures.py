"""Pictures of the machining runs: chip, forces, interface temperature, energy."""
import os

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt                                                        # noqa: E402
import numpy as np                                                                     # noqa: E402
from matplotlib.collections import EllipseCollection, PolyCollection                   # noqa: E402
from matplotlib.colors import LinearSegmentedColormap                                  # noqa: E402

import measure as M                                                                    # noqa: E402

COLORS = {"heat": "#c0392b", "no_heat": "#2c5d8f"}
LABELS = {"heat": "with heat", "no_heat": "without heat"}
WARM = LinearSegmentedColormap.from_list("warm", ["#e3e8ee", "#ffe08a", "#f89540", "#d9352b", "#6d0a1c"])
FLOW = LinearSegmentedColormap.from_list("flow", ["#e6ebe8", "#a8d8b9", "#4bb5a0", "#1f7a8c", "#152f52"])
TOOL_FACE, TOOL_LINE = "#b9bec4", "#4a4f55"
plt.rcParams.update({"font.size": 11, "axes.spines.top": False, "axes.spines.right": False, "figure.dpi": 110,
                     "legend.frameon": False, "savefig.bbox": "tight"})


def discs(ax, x, y, size, values, cmap, lo, hi):
    c = EllipseCollection(size, size, 0, units="xy", offsets=np.stack([x, y], axis=1), transOffset=ax.transData,
                          array=values, cmap=cmap, edgecolors=(0, 0, 0, 0.45), linewidths=0.35)
    c.set_clim(lo, hi)
    ax.add_collection(c)
    return c


def section(ax, run, key, cmap, lo, hi, scale=lambda v: v):
    """Particles of the middle two layers, seen along z, with the tool's profile; lengths in mm."""
    f = run.final
    mid = np.abs(f["z"]) < run.dp
    c = discs(ax, 1e3 * f["x"][mid], 1e3 * f["y"][mid], 1.12e3 * run.dp, scale(f[key][mid]), cmap, lo, hi)
    x0 = run.tool_x(f["time"])
    ax.fill(1e3 * (M.TOOL.profile[:, 0] + x0), 1e3 * M.TOOL.profile[:, 1], fc=TOOL_FACE, ec=TOOL_LINE, lw=1.2, zorder=0)
    ax.set_aspect("equal")
    ax.set_xlim(-1.2, 7.4)
    ax.set_ylim(-3.1, 3.9)
    ax.set_xlabel("x (mm)")
    ax.annotate("", (1e3 * x0 + 1.9, 3.1), (1e3 * x0 + 3.2, 3.1),
                arrowprops=dict(arrowstyle="->", lw=1.6, color="#222222"))
    ax.text(1e3 * x0 + 2.55, 3.25, "tool, %.0f m/s" % run.speed, ha="center", fontsize=10)
    return c


def chip(path, runs, key, title, label, cmap, lo, hi, scale=lambda v: v):
    fig, axes = plt.subplots(1, len(runs), figsize=(14.5, 5.6), sharey=True, constrained_layout=True)
    for ax, (v, r) in zip(axes, runs.items()):
        c = section(ax, r, key, cmap, lo, hi, scale)
        ax.set_title("%s: %s, %.1f mm cut" % (title, LABELS[v], 1e3 * r.h["cut"][-1]), fontsize=12)
    axes[0].set_ylabel("y (mm)")
    fig.colorbar(c, ax=axes, shrink=0.85, pad=0.015, label=label)
    fig.savefig(path)
    plt.close(fig)


def solid(path, run, key, title, label, cmap, lo, hi, scale=lambda v: v):
    """The scene in space, seen from ahead of the tool; painted from back to front."""
    f, x0 = run.final, run.tool_x(run.final["time"])
    view = np.array([-0.62, 0.42, 0.66]) / np.linalg.norm([-0.62, 0.42, 0.66])          # towards the eye
    right = np.cross([0.0, 1.0, 0.0], view)
    right /= np.linalg.norm(right)
    up = np.cross(view, right)
    flat = lambda p: np.stack([1e3 * (p @ right), 1e3 * (p @ up)], axis=-1)
    pts = np.stack([f["x"], f["y"], f["z"]], axis=1)
    ahead = (f["x"] - x0) * M.TOOL.rake_normal[0] + f["y"] * M.TOOL.rake_normal[1] > -0.5 * run.dp
    fig, ax = plt.subplots(figsize=(11, 7.4), constrained_layout=True)
    tri = M.TOOL.triangles + np.array([x0, 0.0, 0.0])
    n = np.cross(tri[:, 1] - tri[:, 0], tri[:, 2] - tri[:, 0])
    n /= np.linalg.norm(n, axis=1)[:, None]
    seen = n @ view > 0
    shade = np.clip(0.66 + 0.25 * (n[seen] @ np.array([-0.3, 0.75, 0.6])), 0.4, 0.95)
    for part, level in ((~ahead, 1), (ahead, 3)):
        order = np.argsort(pts[part] @ view)
        uv = flat(pts[part][order])
        c = discs(ax, uv[:, 0], uv[:, 1], 1.25e3 * run.dp, scale(f[key][part][order]), cmap, lo, hi)
        c.set_zorder(level)
    ax.add_collection(PolyCollection(flat(tri[seen]), facecolors=[(g, g, g) for g in shade],
                                     edgecolors=[(g, g, g) for g in shade], linewidths=0.3, zorder=2))
    ax.set_aspect("equal")
    ax.autoscale_view()
    ax.axis("off")
    fig.colorbar(c, ax=ax, shrink=0.7, pad=0.01, label=label)
    ax.set_title("%s, %.1f mm cut at %.0f m/s" % (title, 1e3 * run.h["cut"][-1], run.speed), fontsize=12)
    fig.savefig(path)
    plt.close(fig)


def energy(path, runs):
    """Where the work of the tool goes, as shares of it."""
    names = [("heat", "heat of plastic work and friction", "#d9352b"), ("plastic", "plastic work kept", "#8e7cc3"),
             ("friction", "friction, not as heat of particles", "#f89540"),
             ("artificial", "artificial terms", "#7f8c8d"), ("elastic", "elastic", "#4bb5a0"),
             ("kinetic", "kinetic", "#2c5d8f"), ("contact", "contact", "#c8a951")]
    fig, axes = plt.subplots(1, len(runs), figsize=(11, 4.4), sharey=True, constrained_layout=True)
    for ax, (v, r) in zip(axes, runs.items()):
        cut, work = 1e3 * r.h["cut"], -r.h["external"]
        use = cut > 0.1
        for key, name, color in names:
            ax.plot(cut[use], 100 * r.h[key][use] / work[use], color=color, lw=1.8, label=name)
        ax.set_title(LABELS[v], fontsize=12)
        ax.set_xlabel("length of cut (mm)")
        ax.axhline(0, color="#888888", lw=0.6)
    axes[0].set_ylabel("share of the tool's work (%)")
    axes[1].legend(fontsize=9, loc="center right")
    fig.savefig(path)
    plt.close(fig)


def forces(path, runs, s):
    fig, axes = plt.subplots(3, 1, figsize=(9.5, 9.0), sharex=True, constrained_layout=True,
                             gridspec_kw={"height_ratios": [3, 2, 2]})
    smooth = {v: r.curve() for v, r in runs.items()}
    for v, r in runs.items():
        cut, fx, fy = smooth[v]
        for ax, raw, mean, key in ((axes[0], r.h["fx"], fx, "mean_normal_force_N"),
                                   (axes[1], r.h["fy"], fy, "mean_tangential_force_N")):
            ax.plot(cut, raw, color=COLORS[v], lw=0.7, alpha=0.35)
            ax.plot(cut, mean, color=COLORS[v], lw=2.0, label="%s, mean %.0f N" % (LABELS[v], s[v][key]))
            ax.plot([M.STEADY_MM, cut[-1]], 2 * [s[v][key]], color=COLORS[v], lw=1.2, ls="--")
    cut = smooth["heat"][0]
    other = np.interp(cut, smooth["no_heat"][0], smooth["no_heat"][1])
    axes[2].plot(cut, smooth["heat"][1] / np.maximum(other, 1.0), color="#333333", lw=2.0, label="at this cut")
    axes[2].axhline(0.854, color="#333333", ls=":", lw=1.4, label="F15, means: 0.854 (its own geometry)")
    axes[2].plot([M.STEADY_MM, cut[-1]], 2 * [s["force_ratio_heat_over_no_heat"]], color="#333333", ls="--", lw=1.2,
                 label="means of the shaded part: %.3f" % s["force_ratio_heat_over_no_heat"])
    axes[2].set_ylim(0.6, 1.1)
    names = ("normal (cutting) force (N)", "tangential (thrust) force (N)", "normal force,\nheat / no heat")
    for ax, name in zip(axes, names):
        ax.axvspan(M.STEADY_MM, cut[-1], color="#000000", alpha=0.04, lw=0)
        ax.set_ylabel(name)
        ax.legend(loc="best")
    axes[1].axhline(0, color="#888888", lw=0.6)
    axes[0].set_title("Forces on the tool; thin: every 20 steps, thick: mean over 0.2 mm of cut, dashed: mean of the "
                      "shaded part", fontsize=10)
    axes[2].set_xlabel("length of cut (mm)")
    axes[2].set_xlim(0, cut[-1])
    fig.savefig(path)
    plt.close(fig)


def temperature(path, run, s):
    cut, hot = run.interface()
    fig, ax = plt.subplots(figsize=(9.5, 4.2), constrained_layout=True)
    ax.plot(1e3 * cut, hot, color=COLORS["heat"], lw=1.6, label="maximum at the interface")
    ax.axhline(s["max_interface_temperature_C"], color=COLORS["heat"], ls="--", lw=1.2,
               label="mean over the cut %.0f C" % s["max_interface_temperature_C"])
    ax.axhline(376, color="#333333", ls=":", lw=1.4, label="F15: 376 C (its own geometry)")
    ax.axhline(582, color="#999999", lw=0.8, label="melting: 582 C")
    ax.set_xlabel("length of cut (mm)")
    ax.set_ylabel("temperature (C)")
    ax.set_xlim(0, None)
    ax.set_ylim(0, 650)
    ax.legend(loc="lower right")
    fig.savefig(path)
    plt.close(fig)


def draw_all(out, runs, s):
    celsius = lambda T: T - 273.15
    at = lambda name: os.path.join(out, name)
    top = 50.0 * np.ceil((np.percentile(runs["heat"].final["T"], 99.9) - 273.15) / 50.0)
    strain = 0.5 * np.ceil(np.percentile(runs["heat"].final["pstrain"], 99.5) / 0.5)
    chip(at("chip_temperature.png"), runs, "T", "temperature", "temperature (C)", WARM, 20, top, celsius)
    chip(at("chip_strain.png"), runs, "pstrain", "plastic strain", "equivalent plastic strain", FLOW, 0, strain)
    solid(at("chip_3d.png"), runs["heat"], "T", "AL 6082-T6, with heat", "temperature (C)", WARM, 20, top, celsius)
    forces(at("forces.png"), runs, s)
    temperature(at("interface_temperature.png"), runs["heat"], s["heat"])
    energy(at("energy.png"), runs)
