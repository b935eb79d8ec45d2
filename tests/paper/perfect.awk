# Table 2, counted: monomials of each order in eight variables, and their multiplications term by term, coefficient
# times variables.
function extend(first, degree, left,    i) {
    terms[degree]++
    for (i = first; left > 0 && i <= 8; i++) extend(i, degree + 1, left - 1)
}
BEGIN {
    extend(1, 0, 5)
    print "order,terms (paper),terms,multiplications (paper),multiplications"
    split("1 9 45 165 495 1287", paper_terms, " ")
    split("0 8 80 440 1760 5720", paper_mul, " ")
    for (order = 0; order <= 5; order++) {
        all += terms[order]
        mul += order * terms[order]
        print order "," paper_terms[order + 1] "," all "," paper_mul[order + 1] "," mul
    }
}
