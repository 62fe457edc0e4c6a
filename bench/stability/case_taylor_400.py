"""A copper bar hits a rigid wall at 400 m/s."""
from taylor import taylor

CASE = taylor(400, 2400)
