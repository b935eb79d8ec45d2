"""Runs one of sfepy's contact models with a contact search out of a shared library:

    contact.py MODEL RESULT LIBRARY...

A library has evaluateContactConstraints, be it sfepy's own extension or another; "-" is what sfepy calls by itself.  Prints Newton's iterations, the calls of
the search and its seconds, and the run's; RESULT (.npz) gets displacements, contact forces, gaps and those in contact.
Of each further library, called on what the last call was given, a line: its seconds, least of some, and how many local
searches that were, where it counts them.
"""
import ctypes
import sys
import time

import numpy as np
import sfepy.discrete  # before sfepy.mechanics: their imports run in a circle
import sfepy.mechanics.extmods.ccontres as contact
from sfepy.base.base import IndexedStruct, output
from sfepy.base.conf import ProblemConf, get_standard_keywords
from sfepy.discrete import Problem

model, result, library, *others = sys.argv[1:]
seen = dict(calls=0, seconds=0.0)


def pointer(array):
    return array.ctypes.data_as(ctypes.c_void_p)


def search_of(name):
    loaded = ctypes.CDLL(name)
    loaded.evaluateContactConstraints.restype = None
    return loaded


def seconds_of(loaded):
    start = time.perf_counter()
    loaded.evaluateContactConstraints(*map(pointer, seen["arrays"]), *seen["numbers"])
    return time.perf_counter() - start


def evaluate(points, sides, cells, counts, low, high, head, following, nodes, element, segment, parameters, unknowns, edge):
    """In place of contact.evaluate_contact_constraints, both searches are called in this way."""
    seen["arrays"] = points, sides, cells, counts, low, high, head, following, nodes, element, segment
    sizes = (len(element), sides.shape[0], nodes.shape[1], parameters, points.shape[0] // len(element), cells.shape[1],
             sides.shape[1], unknowns)
    seen["numbers"] = *map(ctypes.c_int, sizes), ctypes.c_double(edge)
    if library == "-":
        start = time.perf_counter()
        evaluate_own(*seen["arrays"], parameters, unknowns, edge)
        seen["seconds"] += time.perf_counter() - start
    else:
        seen["seconds"] += seconds_of(first)
    seen["calls"] += 1
    return points


def assemble(forces, *rest):
    answer = assemble_own(forces, *rest)
    seen["forces"] = answer[0].copy()
    return answer


first = search_of(library) if library != "-" else None
evaluate_own = contact.evaluate_contact_constraints
assemble_own = contact.assemble_contact_residual_and_stiffness
contact.evaluate_contact_constraints = evaluate
contact.assemble_contact_residual_and_stiffness = assemble
output.set_output(quiet=True)
problem = Problem.from_conf(ProblemConf.from_file(model, *get_standard_keywords()))
status = IndexedStruct()
start = time.perf_counter()
variables = problem.solve(status=status, save_results=False)
total = time.perf_counter() - start
dimensions = problem.domain.shape.dim
points = seen["arrays"][0]
touching = points[:, 2 * dimensions + 3] > 0
np.savez(result, displacement=variables(), force=seen["forces"],
         touching=touching, gap=np.where(touching, points[:, dimensions + 2], 0.0))
print(status["nls_status"]["n_iter"], seen["calls"], "%.6f" % seen["seconds"], "%.6f" % total)
for name in others:
    other = search_of(name)
    least = min(seconds_of(other) for _ in range(20))
    count = ctypes.c_long.in_dll(other, "searches").value // 20 if hasattr(other, "searches") else 0
    print(name, "%.6f" % least, count)
