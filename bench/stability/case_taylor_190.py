"""A copper bar hits a rigid wall at 190 m/s."""
from taylor import taylor

CASE = taylor(190, 2200)
