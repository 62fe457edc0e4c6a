"""What is compared of a run of in.orthogonal_ti6al4v: forces per width, chip ratio, each with the error of its mean."""
import re

import numpy as np

RAKE = 15.0       # degrees
WINDOW = 0.5      # the mean is taken over the last half of the cut
BLOCKS = 5        # whose means give the error of the mean


def mean_of(way, values, cut):
    """Mean over the window, and the standard error from the means of its blocks."""
    inside = values[way > WINDOW * cut]
    blocks = [b.mean() for b in np.array_split(inside, BLOCKS)]
    return float(inside.mean()), float(np.std(blocks, ddof=1) / np.sqrt(BLOCKS))


def of_rake(frame, tip, h, rake):
    """Places along the rake face from the edge, and distances from it into the chip."""
    x, y, a = frame["x"] - tip, frame["y"] + h, np.radians(rake)
    return x * np.sin(a) + y * np.cos(a), -x * np.cos(a) + y * np.sin(a)


def chip_ratio(frame, tip, run, h, rake=RAKE):
    """Thickness of the chip over that of the uncut chip, in plane strain the speed of the tool over that of the chip along the
    rake face, and again as area over length; of the chip between 1.5 and 2.5 uncut thicknesses along the face from the edge, and
    at most 4 from it. None where the chip is not so long yet."""
    y, a = frame["y"] + h, np.radians(rake)
    along, off = of_rake(frame, tip, h, rake)
    chip = (along > 1.5 * h) & (along < 2.5 * h) & (off < 4 * h) & (y > 1.05 * h)
    if chip.sum() < 10 or along[(off < 4 * h) & (y > 1.05 * h)].max() < 2.5 * h:
        return None
    speed = np.median((frame["vx"][chip] + run) * np.sin(a) + frame["vy"][chip] * np.cos(a))    # some cling to the tool
    return run / speed, chip.sum() * frame["area"] / h ** 2


def rake_temperature(frame, tip, h, dx, rake):
    """Mean and largest temperature of the particles nearest to the rake face, one for each spacing along it, from a tenth of the
    uncut thickness to all of it from the edge."""
    along, off = of_rake(frame, tip, h, rake)
    near = (along > 0.1 * h) & (along < h) & (off > -dx) & (off < 4 * dx)
    place, off, T = np.floor(along[near] / dx), off[near], frame["c_p[1]"][near]
    touch = [T[place == k][off[place == k].argmin()] for k in np.unique(place)]
    return (np.mean(touch), np.max(touch)) if touch else (np.nan, np.nan)


def measure(result, variables, rake=RAKE):
    """Of a finished run: quantity -> (value, error of the mean). variables: of the script, um and m/s."""
    h, run, dx = 1e-6 * float(variables["chip"]), float(variables["run"]), 1e-6 * float(variables["dx"])
    length = dx * np.ceil(round((float(variables["length"]) + 3) * h / dx, 6)) + 1e-7 + 1e-6 * float(variables.get("lead", 0))
    forces = result.columns("force.dat")
    way, cut = forces[:, 1], forces[-1, 1]
    found = {"cutting force": mean_of(way, forces[:, 2], cut), "feed force": mean_of(way, forces[:, 3], cut)}
    frames = result.dump("cut.dump")
    tips = [(dict(f, area=dx * dx), length - w) for f, w in zip(frames, np.interp([f["step"] for f in frames], forces[:, 0], way)) if w > WINDOW * cut]
    ratios = [chip_ratio(f, tip, run, h, rake) for f, tip in tips]
    touched = np.array([rake_temperature(f, tip, h, dx, rake) for f, tip in tips])
    for name, k in (("rake face, mean temperature", 0), ("rake face, largest temperature", 1)):
        found[name] = (float(np.nanmean(touched[:, k])), float(np.nanstd(touched[:, k], ddof=1) / np.sqrt(len(touched))))
    ratios = np.array([r for r in ratios if r is not None])
    if len(ratios):
        found["chip ratio"] = (float(ratios[:, 0].mean()), float(ratios[:, 0].std(ddof=1) / np.sqrt(len(ratios))))
        found["chip ratio by area"] = (float(ratios[:, 1].mean()), float(ratios[:, 1].std(ddof=1) / np.sqrt(len(ratios))))
    found["hottest particle"] = (float(frames[-1]["c_p[1]"].max()), 0.0)
    for name, pattern in (("drift of the energy sum", r"the sum drifted by (\S+) %"), ("artificial share", r"artificial terms took (\S+) %")):
        value = re.findall(pattern, result.output)
        found[name] = (float(value[-1]) / 100 if value else 0.0, 0.0)
    torn = re.findall(r"numerical fracture: (\d+) of (\d+) particles", result.output)
    found["particles torn off numerically"] = (int(torn[-1][0]) / int(torn[-1][1]) if torn else 0.0, 0.0)
    found["cut, um"] = (1e6 * float(cut), 0.0)
    return found
