"""A copper bar hits a rigid wall at 300 m/s."""
from taylor import taylor

CASE = taylor(300, 2300)
