# Genomes in the eight inputs alone, without the preprocessing that computes them from the nodes; a network's values,
# lets named hidden_..., stay, and those of a front's programs, ..._both_c123_1.  -v only=xi: that output alone.  -v inputs='x y': other inputs.
BEGIN { if (inputs == "") inputs = "xc yc zc xd yd xs ys zs" }
/^footpoint-genome/ { print; print "input " inputs; next }
/^(note|input|segment|range|require|let) / { if (!inside) kept = /^let (hidden_|[a-z0-9]*_both_c[0-9]+_[0-9]+ )/ }
/^genome / { inside = 1 }
/^(xi|eta) = / { skip = only != "" && $1 != only }
/^end/ { skip = 0 }
inside ? !skip : kept
