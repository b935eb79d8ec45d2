# The errors of a genome file's outputs, a line each: PREFIX,genome,output,terms,training,heldout,heldout_random.
# -v prefix=...  Notes as footpoint-evolve and footpoint-pga write them.
/^genome / { genome = $2 }
/^note terms_/ { terms[substr($2, 7)] = $3 }
/^note training_/ { training[substr($2, 10)] = $NF }
/^note heldout_(xi|eta)/ { heldout[substr($2, 9)] = $6 }
/^note heldout_random_/ { random[substr($2, 16)] = $6 }
/^(xi|eta) = / {
    printf "%s,%s,%s,%s,%s,%s,%s\n", prefix, genome, $1, terms[$1], training[$1], heldout[$1], random[$1]
    delete terms[$1]
}
