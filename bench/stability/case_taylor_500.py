"""A copper bar hits a rigid wall at 500 m/s: pairs of the foot are drawn as close as a thousandth of the spacing, and its rim,
8 times the radius of the bar, comes apart."""
from taylor import taylor

CASE = taylor(500, 2400, box=3)
