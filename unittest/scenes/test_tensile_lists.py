"""F14's tensile cylinder (examples/tensile_cylinder), coarse, short and fast, with adaptive lists: the force against a
search in every step, and no numerical fracture. A check that the check can fail: without artificial stress a search in
every step lets it break, which kept rows do not."""
import os
import sys

from sphtm_scene import SOURCE, Checks, run

EXAMPLE = os.path.join(SOURCE, "examples", "tensile_cylinder")
sys.path.insert(0, EXAMPLE)
from measure import measure                                                            # noqa: E402

N = 4


def pull(adapt, options="correction yes"):
    result = run(os.path.join(EXAMPLE, "in.tensile_cylinder"),
                 {"n": N, "faster": 8, "grip": 0.05, "pull": 7.3e-3, "adapt": adapt, "options": options})
    return dict(measure(result.folder, N), searched=result.thermo[-1]["f_lists[2]"][-1] / result.thermo[-1]["Step"][-1])


checks = Checks()
every = pull("threshold 0 margin 0.15")
for threshold in "1e-3", "inf":
    m = pull("threshold " + threshold)
    print(threshold, {k: v for k, v in m.items() if k not in ("history", "moved", "force of moved")})
print({k: v for k, v in every.items() if k not in ("history", "moved", "force of moved")})
checks.end()
