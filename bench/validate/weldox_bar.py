"""What is read off a run of in.weldox_bar: the curve of engineering stress over strain, and where and how it breaks."""
import os

import numpy as np

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "in.weldox_bar")
# finite elements (published): engineering strain, stress in MPa
STRAIN = [0.002, 0.005, 0.01, 0.02, 0.05, 0.08, 0.10, 0.15]
STRESS = [420.2, 522.5, 536.1, 549.5, 566.1, 571.0, 571.5, 522.3]
LARGEST, AT, HALF = 571.6, 0.0987, 0.192      # largest stress, its strain, the strain at half of it after that
HALF_LENGTH = 10e-3


class Drawn:
    """The curve is averaged over 0.002 of strain. place: of the failed particles, mean distance from the middle over half the
    length, in the material; None where nothing failed."""

    def __init__(self, result):
        self.result = result
        curve = result.columns("curve.dat")
        width = max(1, int(round(len(curve) * 0.002 / curve[-1, 1])))
        strain, stress = (np.convolve(curve[:, k], np.ones(width) / width, "valid") for k in (1, 2))
        stress = stress / 1e6
        top = stress.argmax()
        gone = np.flatnonzero(stress[top:] < 0.5 * stress[top])
        self.largest, self.at = stress[top], strain[top]
        self.half = strain[top + gone[0]] if len(gone) else None
        self.last = stress[-1] / stress[top]
        self.stress = lambda e: np.interp(e, strain, stress)
        self.off = dict(zip(STRAIN, [self.stress(e) / s - 1 for e, s in zip(STRAIN, STRESS)]))
        self.damage, self.pstrain = curve[:, 3].max(), curve[:, 4].max()
        self.t, self.end = result.thermo[-1], result.dump("end.dump")[-1]
        failed = self.end["c_p[1]"] >= 1.0
        self.failed, self.torn = failed.sum(), self.t["f_body[15]"][-1]
        self.first = strain[np.searchsorted(curve[:, 3], 1.0)] if self.damage >= 1.0 else None
        start = result.dump("start.dump")[-1]
        self.place = start["x"][np.isin(start["id"], self.end["id"][failed])].mean() / HALF_LENGTH if self.failed else None
