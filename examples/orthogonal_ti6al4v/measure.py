"""What is compared of a run of in.orthogonal_ti6al4v: forces per width, chip ratio, each with the error of its mean."""
import re

import numpy as np

RAKE = np.radians(15.0)
WINDOW = 0.5      # the mean is taken over the last half of the cut
BLOCKS = 5        # whose means give the error of the mean


def mean_of(way, values, cut):
    """Mean over the window, and the standard error from the means of its blocks."""
    inside = values[way > WINDOW * cut]
    blocks = [b.mean() for b in np.array_split(inside, BLOCKS)]
    return float(inside.mean()), float(np.std(blocks, ddof=1) / np.sqrt(BLOCKS))


def chip_ratio(frame, tip, run, h):
    """Thickness of the chip over that of the uncut chip, in plane strain the speed of the tool over that of the chip along the
    rake face, and again as area over length; of the chip between 1.5 and 2.5 uncut thicknesses along the face from the edge, and
    at most 4 from it. None where the chip is not so long yet."""
    x, y = frame["x"] - tip, frame["y"] + h
    along, off = x * np.sin(RAKE) + y * np.cos(RAKE), -x * np.cos(RAKE) + y * np.sin(RAKE)
    chip = (along > 1.5 * h) & (along < 2.5 * h) & (off < 4 * h) & (y > 1.05 * h)
    if chip.sum() < 10 or along[(off < 4 * h) & (y > 1.05 * h)].max() < 2.5 * h:
        return None
    speed = np.median((frame["vx"][chip] + run) * np.sin(RAKE) + frame["vy"][chip] * np.cos(RAKE))    # some cling to the tool
    return run / speed, chip.sum() * frame["area"] / h ** 2


def measure(result, variables):
    """Of a finished run: quantity -> (value, error of the mean). variables: of the script, um and m/s."""
    h, run, dx = 1e-6 * float(variables["chip"]), float(variables["run"]), 1e-6 * float(variables["dx"])
    length = dx * np.ceil(round((float(variables["length"]) + 3) * h / dx, 6)) + 1e-7
    forces = result.columns("force.dat")
    way, cut = forces[:, 1], forces[-1, 1]
    found = {"cutting force": mean_of(way, forces[:, 2], cut), "feed force": mean_of(way, forces[:, 3], cut)}
    at = np.interp([f["step"] for f in result.dump("cut.dump")], forces[:, 0], way)
    ratios = [chip_ratio(dict(f, area=dx * dx), length - w, run, h) for f, w in zip(result.dump("cut.dump"), at) if w > WINDOW * cut]
    ratios = np.array([r for r in ratios if r is not None])
    if len(ratios):
        found["chip ratio"] = (float(ratios[:, 0].mean()), float(ratios[:, 0].std(ddof=1) / np.sqrt(len(ratios))))
        found["chip ratio by area"] = (float(ratios[:, 1].mean()), float(ratios[:, 1].std(ddof=1) / np.sqrt(len(ratios))))
    last = result.dump("cut.dump")[-1]
    found["hottest particle"] = (float(last["c_p[1]"].max()), 0.0)
    for name, pattern in (("drift of the energy sum", r"the sum drifted by (\S+) %"), ("artificial share", r"artificial terms took (\S+) %")):
        value = re.findall(pattern, result.output)
        found[name] = (float(value[-1]) / 100 if value else 0.0, 0.0)
    torn = re.findall(r"numerical fracture: (\d+) of (\d+) particles", result.output)
    found["particles torn off numerically"] = (int(torn[-1][0]) / int(torn[-1][1]) if torn else 0.0, 0.0)
    found["cut, um"] = (1e6 * float(cut), 0.0)
    return found
