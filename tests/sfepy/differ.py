"""How far two results of contact.py are apart: differ.py ONE OTHER

For displacements, contact forces and gaps a line: the name, the largest difference, as a part of the largest value.  Fails
where not the same Gauss points are in contact.
"""
import sys

import numpy as np

one, other = map(np.load, sys.argv[1:])
for name in "displacement", "force", "gap":
    print(name, "%.1e" % (abs(one[name] - other[name]).max() / abs(one[name]).max()))
sys.exit(not (one["touching"] == other["touching"]).all())
