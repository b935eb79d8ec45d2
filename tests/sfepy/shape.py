"""Derivatives of sfepy's shape functions beside differences of them: shape.py EXTENSION

A line for each kind of segment: its nodes whose derivative by r, then by s, is wrong.
"""
import ctypes
import sys

extension = ctypes.CDLL(sys.argv[1])
STEP = 1e-6


def shape(nodes, *at):
    values, derivatives = (ctypes.c_double * nodes)(), (ctypes.c_double * (2 * nodes))()
    getattr(extension, "sfd%d" % nodes)(values, derivatives, *map(ctypes.c_double, at))
    return values, derivatives


for nodes, dimensions in (2, 1), (4, 2), (6, 2), (8, 2):
    at = [0.3, 0.2][:dimensions]
    told = shape(nodes, *at)[1]
    wrong = []
    for k in range(dimensions):
        back, on = ([x + sign * STEP * (j == k) for j, x in enumerate(at)] for sign in (-1, 1))
        low, high = shape(nodes, *back)[0], shape(nodes, *on)[0]
        wrong.append([i + 1 for i in range(nodes) if abs((high[i] - low[i]) / (2 * STEP) - told[k * nodes + i]) > 1e-6])
    print("sfd%d:" % nodes, *wrong)
