"""A copper bar hits a rigid wall at 400 m/s. The outermost ring of its foot comes loose and flies off."""
from taylor import taylor

CASE = taylor(400, 2400, box=2)
