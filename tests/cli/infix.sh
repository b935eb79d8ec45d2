# Checks infix expressions, version 3 of genome text: a frame and its prefix twin make the same header, and codegen reads back the
# formulas that it prints.  Precedence and refusals are in tests/codegen/test_infix.c.
. tests/cli/expect.inc
BIN=$(realpath "$BIN")
codegen() { "$BIN/footpoint-codegen" --effort 0 --quiet --allow-poles "$@"; }

# ---- the parallelogram frame, as it is and in version 2 ----
mkdir "$work/infix" "$work/prefix" "$work/other"
{
    cat evolve/frames/parallelogram.gen
    printf '%s\n' 'genome quick' 'xi = xi0 + uq, eta = eta0 +' '    vq' 'end' \
        'genome exact' 'xi = xi0 + u3' 'eta = eta0 + v3' 'end'
} > "$work/infix/twin.gen"
cat > "$work/prefix/twin.gen" <<'GENOME'
footpoint-genome 2
segment quad4 any
let xi0 = 0, eta0 = 0
let x1 = + 1 xi0, y1 = + 1 eta0
let ab = - B A, ad = - D A, as = - S A, m3 = - - C D ab, e1 = + * 2 ab * y1 m3, e2 = + * 2 ad * x1 m3
let d = - * 2 - * 2 as * x1 ab * y1 e2
let e11 = dot e1 e1, e12 = dot e1 e2, e22 = dot e2 e2, d1 = dot d e1, d2 = dot d e2, c1 = dot m3 e1, c2 = dot m3 e2
let cd = dot m3 d, cc = dot m3 m3
let det = - * e11 e22 * e12 e12
let dp = - * e22 d1 * e12 d2, dq = - * e11 d2 * e12 d1, da = - * e22 c1 * e12 c2, db = - * e11 c2 * e12 c1
let inv = / 1 det, p = * dp inv, q = * dq inv, a = * da inv, b = * db inv
let u1 = - p * a * p q, v1 = - q * b * p q
let dw = + * det det + * da dq * db dp, r2 = / 1 * det dw, w = * * dp dq * r2 det, i2 = * r2 dw
let u2 = * - dp * da w i2, v2 = * - dq * db w i2
let dpq = * dp dq, dw2 = - * dw dw * * da db dpq, rz = / 1 * det dw2, wz = * * dpq dw * rz det
let iz = * rz dw2, uz = * - dp * da wz iz, vz = * - dq * db wz iz
function newton u v -> un vn t s r11 r12 r22 i j
    let t = + c1 * v cc, s = + c2 * u cc, y = + * u c1 * v s, w = * u v
    let r11 = + e11 * v + c1 t, r22 = + e22 * u + c2 s, r12 = - + e12 + y y cd
    let f1 = + + d1 * v y * w t, f2 = + + d2 * u y * w s, j = - * r11 r22 * r12 r12, i = / 1 j
    let un = * - * r22 f1 * r12 f2 i, vn = * - * r11 f2 * r12 f1 i
end
let u3 v3 t3 s3 r11_3 r12_3 r22_3 i_3 j_3 = newton uz vz, u4 v4 t4 s4 r11_4 r12_4 r22_4 i_4 j_4 = newton u3 v3
let u5 v5 t5 s5 r11_5 r12_5 r22_5 i_5 j_5 = newton u4 v4, u6 v6 t6 s6 r11_6 r12_6 r22_6 i_6 j_6 = newton u5 v5
function gauss_newton u v -> un vn j
    let t = + c1 * v cc, s = + c2 * u cc, y = + * u c1 * v s, w = * u v
    let r11 = + e11 * v + c1 t, r22 = + e22 * u + c2 s, r12 = + e12 y
    let f1 = + + d1 * v cd * w t, f2 = + + d2 * u cd * w s, j = - * r11 r22 * r12 r12, i = / 1 j
    let un = * - * r22 f1 * r12 f2 i, vn = * - * r11 f2 * r12 f1 i
end
let uq vq j_q = gauss_newton p q, ug vg j_g = gauss_newton u1 v1
function chebyshev u v -> un vn
    let u1 v1 t s r11 r12 r22 i j = newton u v, du = - u1 u, dv = - v1 v
    let a = * t du, b = * s dv
    let g1 = * dv + + a a b, g2 = * du + + b b a
    let un = - u1 * - * r22 g1 * r12 g2 i, vn = - v1 * - * r11 g2 * r12 g1 i
end
function solve_u u v -> us v
    let us = / + d1 * v - - cd e12 * v c2 + e11 * v + c1 + c1 * v cc
end
function solve_v u v -> u vs
    let vs = / + d2 * u - - cd e12 * u c1 + e22 * u + c2 + c2 * u cc
end
function along_newton u v -> us vn
    let t = + c1 * v cc, s = + c2 * u cc, y = + * u c1 * v s
    let r11 = + e11 * v + c1 t, r22 = + e22 * u + c2 s, r12 = - + e12 + y y cd
    let f = - + d2 * u - - cd e12 * u c1 * v r22, vn = + v / * r11 f - * r11 r22 * r12 r12
    let us vk = solve_u u vn
end
function along_chebyshev u v -> us vn
    let t = + c1 * v cc, s = + c2 * u cc, y = + * u c1 * v s
    let r11 = + e11 * v + c1 t, r22 = + e22 * u + c2 s, r12 = - + e12 + y y cd
    let f = - + d2 * u - - cd e12 * u c1 * v r22, i = / 1 - * r11 r22 * r12 r12, w = * f i
    let vn = + v * * r11 w + 1 * 3 * * w r12 * i - * s r11 * t r12, us vk = solve_u u vn
end
let vt = / - * e11 d2 * e12 d1 + - * e11 e22 * e12 + e12 cd * d1 c2
let ut = / + d1 * vt - - cd e12 * vt c2 + e11 * vt + c1 + c1 * vt cc
exchange d1 d2, c1 c2, e11 e22
least - * xC yD * yC - xD xB, det, / dw * det det, / dw2 * * det det * det det, - 2 abs uz, - 2 abs vz, - 2 abs u2
least - 2 abs v2, / j_3 det, - 2 abs u3, - 2 abs v3, / j_4 det, - 2 abs u4, - 2 abs v4, - 2 abs u5, - 2 abs v5
least / j_5 det, / j_6 det, / j_q det, / j_g det
genome quick
xi = + xi0 uq
eta = + eta0 vq
end
genome exact
xi = + xi0 u3, eta = + eta0 v3
end
GENOME
sed 's/r12 = e12 + (y + y) - cd/r12 = e12 + (y + y - cd)/' "$work/infix/twin.gen" > "$work/other/twin.gen"
for folder in infix prefix other; do
    (cd "$work/$folder" && codegen twin.gen -o twin.h) > "$work/log" 2>&1 || sed 's/^/# /' "$work/log"
done
same() { diff "$work/infix/twin.h" "$work/$1/twin.h" | grep '^[<>]' | sed 's/sha256: .*/sha256/' | sort -u; }
expect 'a frame and its prefix twin give the same header but for the hash of the file' 0 '<  * sha256
>  * sha256' '' same prefix
[ "$(same other | grep -c 'genome_sha256')" = 2 ]; report $((! $?)) 'the hash of a genome tells other parentheses'

# ---- formulas that codegen prints are read back as infix ----
cat > "$work/once.gen" <<'GENOME'
footpoint-genome 3
input x y z
genome g
r = (x - y/(1 + z*z))*min(x, -2.5e-1*abs(y)) - max(z, 1)/sqrt(1 + x*x)
s = -x*y/(1 + z*z) - (x*z - (y - 0.75))
end
GENOME
codegen --language infix "$work/once.gen" -o "$work/once.txt"
{
    printf '%s\n' 'footpoint-genome 3' 'input x y z'
    sed -n '/^[rs] = /!{ /./s/^/let /p; }' "$work/once.txt"
    echo 'genome g'
    grep '^[rs] = ' "$work/once.txt"
    echo end
} > "$work/again.gen"
codegen --language infix "$work/again.gen" -o "$work/again.txt" && cmp "$work/once.txt" "$work/again.txt"
report $((! $?)) 'formulas read back'
