# Counts the operations of the functions of scalars, or of a segment, in the text of a generated header. Prints a line
# mul,div,add,sqrt,compare for each: for a segment NAME_detail, otherwise the first body after the banner. A minus that
# begins an expression is a sign, and a quotient of two numbers a number.
/^ \*   operations:/ { told = 1 }
/^FOOTPOINT_(FN|PART)/ { body = ""; reading = 0; bare = / [a-z0-9_]+_detail\(/; searches = searches || bare }
/^FOOTPOINT_PART void/ { helper = 1 } # gives xi and eta back in the order of the corners
/^}/ { if (body != "" && !helper && (searches ? bare : told)) { count(body); told = 0; bare = 0 } body = ""; reading = 0; helper = 0 }
/^    (const (double|float) [tu][0-9]+ = |\*(out_[A-Za-z0-9_]+|xi|eta) = )/ { reading = 1; sub(/^[^=]*= /, "= ") }
reading { body = body $0 " "; if (/;$/) reading = 0 }

function count(text,  mul, div, add, root, compare) {
    gsub(/ +/, " ", text)
    gsub(/\([0-9.]+ \/ [0-9.]+\)/, "1.0", text)
    root = gsub(/sqrtf?\(/, "(", text)
    compare = gsub(/fabsf?\(/, "(", text) + gsub(/ (<|>|==) /, " ", text)
    gsub(/[=(?:] *-/, "=", text)
    mul = gsub(/ \* /, " ", text)
    div = gsub(/ \/ /, " ", text)
    add = gsub(/ [-+] /, " ", text)
    print mul "," div "," add "," root "," compare
}
