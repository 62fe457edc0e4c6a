"""What the two machining runs are measured by; all in SI unless a name says otherwise.

Conventions: the tool cuts along -x with its edge at y = 0; forces are those ON the tool.
  normal force      along +x: the main cutting force, against the cutting motion (F15's "normal")
  tangential force  along +y: the thrust that pushes the tool away from the machined surface
  mean              over the steady part, from STEADY_MM of cut to the end
  interface         the work piece's particles whose centre is within 0.75 dp of the tool's surface; its
                    maximum at each sample, averaged over the whole cut, as F15 defines its temperature
  cluster           particles connected by bonds shorter than 1.5 dp; one cluster means that nothing broke off
  chip thickness    extent of the chip normal to the rake face plus dp, between 1.2 and 1.8 depths of cut up
                    the rake face, in the middle half of the width
"""
import ast
import os
import re
import struct
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
SCRIPT = os.path.join(HERE, "in.high_speed_machining")
COLUMNS = ["step", "time", "cut", "fx", "fy", "fz", "friction_power", "tool_heat", "contacts", "penetration",
           "T_max", "kinetic", "elastic", "plastic", "heat", "contact", "friction", "artificial", "external",
           "energy_sum"]
STEADY_MM = 1.0
INTERFACE_DP = 0.75
BOND_DP = 1.5
F15 = {"force_ratio_heat_over_no_heat": 0.854, "max_interface_temperature_C": 376.0,
       "normal_force_error_heat": -0.039, "normal_force_error_no_heat": 0.125}


def script_variable(name):
    """A number that the input script defines, with the script's own arithmetic."""
    with open(SCRIPT) as f:
        m = re.search(r"^variable\s+%s\s+(?:index|equal)\s+(\S+)" % name, f.read(), re.M)
    if not m:
        sys.exit("measure.py: no variable %s in %s" % (name, SCRIPT))

    def value(node):
        if isinstance(node, ast.BinOp):
            a, b = value(node.left), value(node.right)
            return {ast.Add: a + b, ast.Sub: a - b, ast.Mult: a * b, ast.Div: a / b if b else 0}[type(node.op)]
        return script_variable(node.id[2:]) if isinstance(node, ast.Name) else float(ast.literal_eval(node))
    return value(ast.parse(m.group(1), mode="eval").body)


def fail(out, variant):
    """Ends with the message of a run that stopped."""
    for name in ("log.lammps", "errors.txt"):
        path = os.path.join(out, variant, name)
        if os.path.exists(path):
            with open(path) as f:
                text = f.read()
            lines = [l for l in text.splitlines() if "ERROR" in l] or text.splitlines()[-5:]
            if lines:
                sys.exit("the run '%s' stopped: %s" % (variant, "\n".join(lines)))
    sys.exit("the run '%s' stopped" % variant)


# --- reading ------------------------------------------------------------------------------------

def read_dump(path, last=False):
    """Frames of a custom text dump with 'dump_modify time yes', particles sorted by id."""
    frames = []
    with open(path) as f:
        line = f.readline()
        while line:
            if line.startswith("ITEM: TIMESTEP"):
                step = int(f.readline())
            elif line.startswith("ITEM: TIME"):
                time = float(f.readline())
            elif line.startswith("ITEM: NUMBER"):
                n = int(f.readline())
            elif line.startswith("ITEM: ATOMS"):
                names = [w.replace("c_p[1]", "T").replace("c_p[2]", "pstrain").replace("c_p[3]", "mises")
                         for w in line.split()[2:]]
                text = "".join(f.readline() for _ in range(n))
                values = np.array(text.split(), float).reshape(n, len(names))
                values = values[np.argsort(values[:, 0])]
                frames = [] if last else frames
                frames.append(dict(zip(names, values.T), step=step, time=time))
            line = f.readline()
    return frames


def read_stl(path):
    """Triangles of a binary STL, n x 3 x 3."""
    with open(path, "rb") as f:
        data = f.read()
    n = struct.unpack("<I", data[80:84])[0]
    rows = np.frombuffer(data[84:84 + 50 * n], dtype=np.dtype([("n", "<3f4"), ("p", "<9f4"), ("a", "<u2")]))
    return rows["p"].reshape(n, 3, 3).astype(float)


def hull(points):
    """Convex hull of plane points, counter-clockwise."""
    pts = sorted(set(map(tuple, points)))

    def half(seq):
        out = []
        for p in seq:
            while len(out) > 1 and ((out[-1][0] - out[-2][0]) * (p[1] - out[-2][1])
                                    - (out[-1][1] - out[-2][1]) * (p[0] - out[-2][0])) <= 1e-9:
                out.pop()
            out.append(p)
        return out[:-1]
    return np.array(half(pts) + half(pts[::-1]))


class Tool:
    """The insert: extruded convex profile, edge at the origin of its own frame."""

    def __init__(self):
        self.triangles = 1e-3 * read_stl(os.path.join(HERE, "insert.stl"))
        self.profile = 1e-3 * hull(1e3 * np.round(self.triangles[:, :, :2].reshape(-1, 2), 9))
        p, q = self.profile, np.roll(self.profile, -1, axis=0)
        t = (q - p) / np.linalg.norm(q - p, axis=1)[:, None]
        normal = np.stack([t[:, 1], -t[:, 0]], axis=1)
        self.rake_normal = normal[np.argmax(np.where(normal[:, 0] < 0, np.linalg.norm(q - p, axis=1), 0))]
        self.rake = np.arctan2(self.rake_normal[1], -self.rake_normal[0])         # angle, radian
        self.up = np.array([-self.rake_normal[1], self.rake_normal[0]])
        if self.up[1] < 0:
            self.up = -self.up

    def distance(self, x, y):
        """Of points in the tool's frame to the profile's boundary."""
        p, q = self.profile, np.roll(self.profile, -1, axis=0)
        pts, best = np.stack([x, y], axis=1), np.full(len(x), np.inf)
        for a, b in zip(p, q):
            d = b - a
            t = np.clip(((pts - a) @ d) / (d @ d), 0, 1)
            best = np.minimum(best, np.linalg.norm(pts - a - t[:, None] * d, axis=1))
        return best


TOOL = Tool()


def clusters(x, y, z, bond):
    """Number of groups connected by distances below bond, and the sizes, largest first."""
    pts = np.stack([x, y, z], axis=1)
    cell = np.floor((pts - pts.min(axis=0)) / bond).astype(int)
    dims = cell.max(axis=0) + 3
    key = ((cell[:, 0] + 1) * dims[1] + cell[:, 1] + 1) * dims[2] + cell[:, 2] + 1
    order = np.argsort(key, kind="stable")
    sorted_key = key[order]
    parent = np.arange(len(pts))

    def root(i):
        while parent[i] != i:
            parent[i] = parent[parent[i]]
            i = parent[i]
        return i
    offsets = [(i * dims[1] + j) * dims[2] + k for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)]
    for off in offsets:
        lo = np.searchsorted(sorted_key, key + off, "left")
        hi = np.searchsorted(sorted_key, key + off, "right")
        for shift in range(int((hi - lo).max(initial=0))):
            i = np.nonzero(lo + shift < hi)[0]
            j = order[lo[i] + shift]
            near = (i < j) & (((pts[i] - pts[j]) ** 2).sum(axis=1) < bond * bond)
            for a, b in zip(i[near], j[near]):
                ra, rb = root(a), root(b)
                if ra != rb:
                    parent[rb] = ra
    sizes = np.bincount([root(i) for i in range(len(pts))])
    return np.sort(sizes[sizes > 0])[::-1]


# --- one run ------------------------------------------------------------------------------------

class Run:
    """History, frames and log of one variant."""

    def __init__(self, folder, dp=None):
        """dp: the spacing, where it is not that of the script."""
        self.folder = folder
        rows = np.loadtxt(os.path.join(folder, "history.dat"), comments="#", ndmin=2)
        self.h = dict(zip(COLUMNS, rows.T))
        self.dp, self.depth, self.width = (script_variable(k) for k in ("dp", "depth", "width"))
        self.dp = dp or self.dp
        self.speed, self.start = script_variable("speed"), script_variable("start")
        with open(os.path.join(folder, "log.lammps")) as f:
            log = f.read()
        loop = re.findall(r"^Loop time of (\S+) on (\d+) procs for (\d+) steps with (\d+) atoms", log, re.M)[-1]
        self.wall, self.ranks, self.steps = float(loop[0]), int(loop[1]), int(loop[2])
        self.created = [int(n) for n in re.findall(r"^Created (\d+) atoms", log, re.M)]      # work piece, tool
        whole = read_dump(os.path.join(folder, "final.dump"))[-1]
        self.final, self.inside = self.of_type(whole, 1), self.of_type(whole, 2)

    @staticmethod
    def of_type(frame, t):
        use = frame["type"] == t
        return {k: (v[use] if isinstance(v, np.ndarray) else v) for k, v in frame.items()}

    def chip_frames(self):
        return read_dump(os.path.join(self.folder, "chip.dump"))

    def tool_x(self, time):
        return self.start - self.speed * time

    def mean(self, name, lo_mm, hi_mm=np.inf):
        use = (self.h["cut"] >= 1e-3 * lo_mm) & (self.h["cut"] <= 1e-3 * hi_mm)
        return float(self.h[name][use].mean()), float(self.h[name][use].std())

    def interface(self):
        """Cut length and maximum interface temperature (C) at every chip frame with contact."""
        cut, hot = [], []
        for f in self.chip_frames():
            x = f["x"] - self.tool_x(f["time"])
            touch = TOOL.distance(x, f["y"]) < INTERFACE_DP * self.dp if len(x) else np.zeros(0, bool)
            if touch.any():
                cut.append(np.interp(f["time"], self.h["time"], self.h["cut"]))
                hot.append(f["T"][touch].max() - 273.15)
        return np.array(cut), np.array(hot)

    def chip_thickness(self, f=None):
        f = f or self.final
        x, y = f["x"] - self.tool_x(f["time"]), f["y"]
        up = x * TOOL.up[0] + y * TOOL.up[1]
        out = x * TOOL.rake_normal[0] + y * TOOL.rake_normal[1]
        middle = np.abs(f["z"]) < 0.25 * self.width
        band = (up > 1.2 * self.depth) & (up < 1.8 * self.depth) & middle & (out > -self.dp)
        return float(out[band].max() - out[band].min() + self.dp) if band.any() else 0.0

    def curve(self, window_mm=0.2):
        """Cut length (mm) and forces, smoothed by a moving mean over window_mm of cut."""
        cut = 1e3 * self.h["cut"]
        out = []
        for name in ("fx", "fy"):
            c = np.concatenate([[0.0], np.cumsum(self.h[name])])
            lo, hi = np.searchsorted(cut, cut - window_mm / 2), np.searchsorted(cut, cut + window_mm / 2)
            out.append((c[hi] - c[lo]) / np.maximum(hi - lo, 1))
        return cut, out[0], out[1]

    def numbers(self):
        fx, sx = self.mean("fx", STEADY_MM)
        fy, sy = self.mean("fy", STEADY_MM)
        h, f = self.h, self.final
        cut, hot = self.interface()
        sizes = clusters(f["x"], f["y"], f["z"], BOND_DP * self.dp)
        error = abs(h["energy_sum"][-1] - h["energy_sum"][0]) / abs(h["external"][-1])
        sweep = np.diff(h["cut"], prepend=h["cut"][0])
        out = {
            "particles": self.created[0], "tool_particles": self.created[1], "steps": self.steps, "ranks": self.ranks,
            "wall_seconds": round(self.wall, 1),
            "microseconds_per_particle_step": 1e6 * self.wall * self.ranks / self.steps / sum(self.created),
            "cut_mm": 1e3 * h["cut"][-1],
            "mean_normal_force_N": fx, "std_normal_force_N": sx,
            "mean_tangential_force_N": fy, "std_tangential_force_N": sy,
            "mean_normal_force_to_1.75_mm_N": self.mean("fx", 0.0, 1.75)[0],
            "mean_tangential_force_to_1.75_mm_N": self.mean("fy", 0.0, 1.75)[0],
            "specific_cutting_force_N_per_mm2": fx / (self.depth * self.width) * 1e-6,
            "friction_power_W": self.mean("friction_power", STEADY_MM)[0],
            "power_into_tool_W": self.mean("tool_heat", STEADY_MM)[0],
            "max_interface_temperature_C": float(hot.mean()) if len(hot) else 20.0,
            "max_interface_temperature_steady_C": float(hot[cut >= 1e-3 * STEADY_MM].mean()) if len(hot) else 20.0,
            "energy_error_fraction": float(error),
            "work_of_force_over_external_work": float((h["fx"] * sweep).sum() / -h["external"][-1]),
            "energy_shares": {k: float("%.4g" % (-h[k][-1] / h["external"][-1])) for k in COLUMNS[11:18]},
            "chip_thickness_mm": 1e3 * self.chip_thickness(),
            "chip_top_mm": 1e3 * float(f["y"].max()),
            "clusters": int(len(sizes)), "largest_cluster": int(sizes[0]),
            "particles_lost": self.created[0] - len(f["x"]),
            "contacts_mean": self.mean("contacts", STEADY_MM)[0],
            "deepest_penetration_dp": float(h["penetration"].max()),
            "mean_penetration_dp": self.mean("penetration", STEADY_MM)[0],
        }
        return {k: (float("%.6g" % v) if isinstance(v, float) else v) for k, v in out.items()}


def summary(runs):
    s = {v: r.numbers() for v, r in runs.items()}
    h, n = s["heat"], s["no_heat"]
    ratio = lambda key: float("%.4g" % (h[key] / n[key])) if n[key] else 0.0
    s.update({
        "particles": h["particles"], "steps": h["steps"],
        "wall_seconds": {"heat": h["wall_seconds"], "no_heat": n["wall_seconds"]},
        "mean_normal_force_N": {v: s[v]["mean_normal_force_N"] for v in runs},
        "mean_tangential_force_N": {v: s[v]["mean_tangential_force_N"] for v in runs},
        "force_ratio_heat_over_no_heat": ratio("mean_normal_force_N"),
        "force_ratio_to_1.75_mm": ratio("mean_normal_force_to_1.75_mm_N"),
        "tangential_force_heat_minus_no_heat_N":
            float("%.4g" % (h["mean_tangential_force_N"] - n["mean_tangential_force_N"])),
        "chip_thickness_ratio_heat_over_no_heat": ratio("chip_thickness_mm"),
        "max_interface_temperature_C": h["max_interface_temperature_C"],
        "energy_error_fraction": max(h["energy_error_fraction"], n["energy_error_fraction"]),
        "F15": F15,
        "definitions": {"steady_from_mm": STEADY_MM, "bond_over_dp": BOND_DP, "interface_over_dp": INTERFACE_DP}})
    return s


def write_forces(path, runs):
    """Raw and smoothed forces of both runs on the cut lengths of the run with heat."""
    with open(path, "w") as f:
        f.write("run,cut_mm,time_us,normal_N,tangential_N,normal_smoothed_N,tangential_smoothed_N\n")
        for v, r in runs.items():
            cut, fx, fy = r.curve()
            for row in zip(cut, 1e6 * r.h["time"], r.h["fx"], r.h["fy"], fx, fy):
                f.write(v + "," + ",".join("%.6g" % w for w in row) + "\n")
