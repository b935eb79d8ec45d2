# The errors of a genome file's outputs, a line each: PREFIX,genome,output,terms,training,heldout,heldout_random, and of
# both samples held out the 99 % and the worst: heldout_p99,heldout_max,random_p99,random_max.  -v prefix=...
# Notes as footpoint-evolve and footpoint-pga write them; those of a front's members name no output.
/^genome / { genome = $2 }
/^note terms_/ { terms[substr($2, 7)] = $3 }
/^note training/ { training[substr($2, 10)] = $NF }
/^note heldout_both/ { heldout["xi"] = $6; heldout["eta"] = $7; tail["xi"] = $9 "," $12; tail["eta"] = $10 "," $13; next }
/^note heldout_random_both/ { random["xi"] = $6; random["eta"] = $7; random_tail["xi"] = $9 "," $12; random_tail["eta"] = $10 "," $13; next }
/^note heldout(_xi|_eta)? / { o = substr($2, 9); heldout[o] = $6; tail[o] = $8 "," $10 }
/^note heldout_random/ { o = substr($2, 16); random[o] = $6; random_tail[o] = $8 "," $10 }
/^(xi|eta) = / {
    o = $1 in heldout ? $1 : ""
    printf "%s,%s,%s,%s,%s,%s,%s,%s,%s\n", prefix, genome, $1, terms[$1], training[o], heldout[o], random[o], tail[o],
        random_tail[o]
    delete terms[$1]
}
