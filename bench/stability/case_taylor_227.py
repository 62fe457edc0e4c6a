"""A copper bar hits a rigid wall at 227 m/s."""
from taylor import taylor

CASE = taylor(227, 2200)
