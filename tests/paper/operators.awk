# Multiplications and divisions of the output xi as it was bred: genome,mul,div.
/^genome / { genome = $2 }
/^[a-z]+ = / { on = $1 == "xi"; mul = on ? 0 : mul; div = on ? 0 : div }
on { for (i = 1; i <= NF; i++) { mul += $i == "*"; div += $i == "%" || $i == "/" } }
/^end/ { print genome "," mul + 0 "," div + 0; on = 0 }
