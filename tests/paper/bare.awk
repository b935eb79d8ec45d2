# Genomes in the eight inputs alone, without the preprocessing that computes them from the nodes.
# -v only=xi: that output alone.
/^footpoint-genome/ { print; print "input xc yc zc xd yd xs ys zs"; next }
/^genome / { inside = 1 }
/^(xi|eta) = / { skip = only != "" && $1 != only }
/^end/ { skip = 0 }
inside && !skip
