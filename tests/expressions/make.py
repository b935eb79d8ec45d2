#!/usr/bin/env python3
"""Writes the genome files beside it: the expressions on which footpoint-codegen is counted against algebra tools.
Random ones come from a fixed generator, so the files are always the same; search-quad4.gen alone is not from here.

    tests/expressions/make.py [FOLDER]
"""
import os
import sys

sys.dont_write_bytecode = True
from formulas import E, P, Random, cofactor, determinant, monomials, names, product, terms_text, total, variables
from random_genome import SIMILARITY, formula, random_genome


def write(folder, name, inputs, outputs, about, lets=()):
    """outputs, lets: (name, formula) pairs."""
    with open(os.path.join(folder, name + '.gen'), 'w', encoding='ascii') as out:
        out.write(f'footpoint-genome 3\n# {about}\ninput {inputs}\n')
        for let, formula in lets:
            out.write(wrapped(f'let {let} = {formula}'))
        out.write('genome g\n')
        for output, formula in outputs:
            out.write(wrapped(f'{output} = {formula}'))
        out.write('end\n')


def wrapped(text):
    """Lines end with the operator of a sum, as far outside parentheses as there is one in their second half."""
    lines, indent = [], ''
    while len(indent + text) > 118:
        depth, best = 0, (len(text), 0)
        for i, c in enumerate(text[:118 - len(indent)]):
            depth += (c == '(') - (c == ')')
            if c in '+-' and text[i + 1] == ' ' and i > 50:
                best = min(best, (depth, -i))
        lines.append(indent + text[:1 - best[1]])
        text, indent = text[1 - best[1]:].lstrip(), '    '
    return '\n'.join(lines + [indent + text]) + '\n'


def paper_pair(folder):
    rng = Random(41)
    xi = 'yD xS yS xC*yS yC*yS xC*yC*yS xC*xS*yS xC*xC*yD xD*xD*yS yD*xS*xS'
    eta = '1 xC yD yS xC*yS yC*yD*yD yC*yS*yS xC*yD*yS yC*xS*yS yD*xS*yS'

    def polynomial(text):
        return terms_text([(rng.generic(), [] if m == '1' else m.split('*')) for m in text.split()])
    write(folder, 'paper-pair', ' '.join(SIMILARITY), [('xi', polynomial(xi)), ('eta', polynomial(eta))],
          'equations (41) and (42) of the paper, coefficients made up')


def cubics(folder):
    every = list(monomials(SIMILARITY, 3))
    for kind in 'generic', 'grid':
        rng = Random(165)
        write(folder, f'cubic-full-{kind}', ' '.join(SIMILARITY),
              [('r', terms_text([(getattr(rng, kind)(), m) for m in every]))], 'all 165 terms of a cubic in 8 inputs')
        for n in 20, 40, 60, 80, 120:
            rng = Random(n)
            chosen = rng.sample(every, n)
            write(folder, f'cubic-{n}-{kind}', ' '.join(SIMILARITY),
                  [('r', terms_text([(getattr(rng, kind)(), m) for m in chosen]))], f'{n} terms of a cubic in 8 inputs')
    rng = Random(7)
    chosen = rng.sample(every, 45)
    write(folder, 'cubic-pair-grid', ' '.join(SIMILARITY),
          [(name, terms_text([(rng.grid(), m) for m in rng.sample(chosen, 30)])) for name in ('xi', 'eta')],
          'two cubics of 30 terms each that share monomials')


def sparse(folder):
    for name, inputs, degree, n, kind in (('sparse-degree6', 'x y z w', 6, 30, 'grid'),
                                          ('sparse-degree10', 'x y', 10, 25, 'generic'),
                                          ('sparse-degree5', 'a b c d e f', 5, 50, 'grid'),
                                          ('sparse-degree12', 'x y z', 12, 20, 'generic')):
        rng = Random(degree)
        chosen = rng.sample(monomials(inputs.split(), degree), n)
        write(folder, name, inputs, [('r', terms_text([(getattr(rng, kind)(), m) for m in chosen]))],
              f'{n} terms of degree up to {degree}')
    rng = Random(3)
    write(folder, 'dense-degree4', 'x y z', [('r', terms_text([(rng.grid(), m) for m in monomials('xyz', 4)]))],
          'all terms of degree up to 4 in 3 inputs')


def random_genomes(folder):
    for kind in 'polynomial', 'rational':
        for genes in 50, 100, 150, 200, 250:
            rng = Random(genes + (kind == 'rational'))
            write(folder, f'random-{kind}-{genes}', ' '.join(SIMILARITY),
                  [('xi', formula(random_genome(rng, genes, kind == 'rational')))],
                  f'a genome as evolution makes them, {genes} genes, with redundancies')


def expanded(folder):
    a, b, c, d, e, f = variables('a b c d e f')
    x, y, z = variables('x y z')
    write(folder, 'expanded-binomials', 'a b c d e f', [('r', (a + b) * (c + d) * (e + f))], '(a + b)(c + d)(e + f)')
    write(folder, 'expanded-power', 'x y z', [('r', (x + 2 * y + 3 * z) ** 4)], '(x + 2 y + 3 z)^4')
    p = x * y + 3 * a * z - 2 * b * b + x - 5
    q = a * y - 2 * x * x + b * z + 7 * a + 1
    write(folder, 'expanded-product', 'a b x y z', [('r', p * q)], 'the product of two sparse quadratics')
    s, t = c * z - 3 * x * y + 2 * a - 1, y * y + 4 * b * c - x + 3
    write(folder, 'expanded-products', 'a b c x y z', [('r', p * q + s * t)], 'the sum of two products of quadratics')
    write(folder, 'expanded-square', 'a b c d e f', [('r', (a * b + c * d - e * f) ** 2 + (a - f) ** 2)],
          '(a b + c d - e f)^2 + (a - f)^2')
    write(folder, 'expanded-norms', 'a b c x y z',
          [('r', (a * a + b * b + c * c) * (x * x + y * y + z * z) - (a * x + b * y + c * z) ** 2)],
          'Lagrange: |a|^2 |x|^2 - (a.x)^2')
    t, = variables('t')
    write(folder, 'expanded-powers', 'x y z t', [('r', (x + 3 * y) ** 4 + 7 * (z - t) ** 3)],
          '(x + 3 y)^4 + 7 (z - t)^3')
    write(folder, 'expanded-shifted', 'a b c d x y z', [('r', (a + b + c) ** 2 + (x - y + 2) ** 5 + (d - 2 * z + 1) ** 2)],
          '(a + b + c)^2 + (x - y + 2)^5 + (d - 2 z + 1)^2')
    write(folder, 'expanded-parts', 'a b c d e f x y',
          [('r', (a + 2 * b - 3) * (a - b + 1) + (c + d) * (c - d + 2) + (e * f + 1) * (e - f) + (x + y) ** 3)],
          'products and a power without common variables')
    write(folder, 'expanded-composed', 'x y', [('r', ((x * x + y) ** 2 - 3) ** 2 + y)], '((x^2 + y)^2 - 3)^2 + y')
    four = variables('a b c d')
    for n in 3, 4:
        v = four[:n]
        write(folder, f'vandermonde{n}', 'a b c d'[:2 * n - 1],
              [('r', product(v[j] - v[i] for i in range(n) for j in range(i + 1, n)))],
              'Vandermonde determinant, expanded')
        m = [[f'm{i}{j}' for j in range(1, n + 1)] for i in range(1, n + 1)]
        inputs = ' '.join(sum(m, []))
        write(folder, f'determinant{n}', inputs, [('r', determinant([variables(' '.join(row)) for row in m]))],
              f'general {n}x{n} determinant, expanded')
    sides = variables('a b c d e f')
    one, zero = P.of(1), P({})
    cm = [[zero, one, one, one, one]] + [
        [one] + [zero if i == j else sides[{(0, 1): 0, (0, 2): 1, (0, 3): 2, (1, 2): 3, (1, 3): 4, (2, 3): 5}[
            min(i, j), max(i, j)]] for j in range(4)] for i in range(4)]
    write(folder, 'cayley-menger', 'a b c d e f', [('r', determinant(cm))],
          'Cayley-Menger determinant of a tetrahedron in the squares of its edges, expanded')
    sq = [v * v for v in variables('a b c')]
    write(folder, 'heron', 'a b c',
          [('r', 2 * (sq[0] * sq[1] + sq[1] * sq[2] + sq[2] * sq[0]) - (sq[0] ** 2 + sq[1] ** 2 + sq[2] ** 2))],
          '16 area^2 of a triangle in its edges, expanded')


def sylvester(p, q):
    """Coefficients, highest power first."""
    m, n, zero = len(p) - 1, len(q) - 1, P({})
    return [[zero] * i + p + [zero] * (n - 1 - i) for i in range(n)] + \
           [[zero] * i + q + [zero] * (m - 1 - i) for i in range(m)]


def resultants(folder):
    p, q = variables('a b c d'), variables('e f g h')
    write(folder, 'resultant-quadratics', 'a b c e f g', [('r', determinant(sylvester(p[:3], q[:3])))],
          'resultant of two quadratics, expanded')
    write(folder, 'resultant-cubics', 'a b c d e f g h', [('r', determinant(sylvester(p, q)))],
          'resultant of two cubics, expanded')
    c = variables('a b c d e')
    for n, name in ((3, 'cubic'), (4, 'quartic')):
        derivative = [(n - k) * c[k] for k in range(n)]
        write(folder, f'discriminant-{name}', 'a b c d e'[:2 * n + 1],
              [('r', determinant(sylvester(c[:n + 1], derivative)).over('a'))], f'discriminant of a {name} up to sign')


def newton(folder):
    """One Newton step for the local coordinates (xi, eta) of a point of a plane bilinear quad, as FE codes write it."""
    xi, eta = names('xi eta')
    m, p, n, q = 1 - xi, 1 + xi, 1 - eta, 1 + eta
    shape = [0.25 * m * n, 0.25 * p * n, 0.25 * p * q, 0.25 * m * q]
    dxi = [-0.25 * n, 0.25 * n, 0.25 * q, -0.25 * q]
    deta = [-0.25 * m, -0.25 * p, 0.25 * p, 0.25 * m]

    def at(weights, axis):
        return total(w * E(axis + corner) for w, corner in zip(weights, 'ABCD'))
    rx, ry = E('xS') - at(shape, 'x'), E('yS') - at(shape, 'y')
    jacobian = [('a', at(dxi, 'x')), ('b', at(deta, 'x')), ('c', at(dxi, 'y')), ('d', at(deta, 'y'))]
    inputs = 'xA yA xB yB xC yC xD yD xS yS xi eta'
    write(folder, 'newton-quad', inputs,
          [('xi1', 'xi + (rx*d - ry*b)/det'), ('eta1', 'eta + (ry*a - rx*c)/det')],
          'a Newton step on a plane bilinear quad',
          [('rx', rx), ('ry', ry)] + jacobian + [('det', 'a*d - b*c')])
    write(folder, 'isoparametric-quad', inputs,
          [('x', at(shape, 'x')), ('y', at(shape, 'y')), ('det', 'a*d - b*c')],
          'position and Jacobian determinant of a plane bilinear quad', jacobian)


def shared(folder):
    rng = Random(4)
    chosen = rng.sample(monomials('xyzw', 4), 18)
    p = P({})
    for m in chosen:
        p = p + (1 + rng.below(9)) * product([P.of(1)] + variables(' '.join(m)))
    write(folder, 'gradient', 'x y z w', [('g' + v, p.diff(v)) for v in 'xyzw'], 'gradient of a quartic of 18 terms')
    write(folder, 'value-gradient', 'x y z w', [('v', p)] + [('g' + v, p.diff(v)) for v in 'xyzw'],
          'a quartic of 18 terms and its gradient')
    m = [names(f'm{i}1 m{i}2 m{i}3') for i in (1, 2, 3)]
    nine = 'm11 m12 m13 m21 m22 m23 m31 m32 m33'
    write(folder, 'adjugate3', nine, [(f'a{j + 1}{i + 1}', cofactor(m, i, j)) for i in range(3) for j in range(3)] +
          [('det', determinant(m))], 'adjugate and determinant of a 3x3 matrix')
    write(folder, 'inverse3', nine, [(f'i{j + 1}{i + 1}', cofactor(m, i, j) / determinant(m)) for i in range(3)
                                     for j in range(3)], 'inverse of a 3x3 matrix, each entry a quotient')
    q = variables('a b c d')
    a, b, c, d = (v * v for v in q)
    write(folder, 'rotation', 'a b c d',
          [('r11', a + b - c - d), ('r22', a - b + c - d), ('r33', a - b - c + d)] +
          [(f'r{i}{j}', 2 * (q[i] * q[j] + q[0] * q[k] if (j - i) % 3 == 2 else q[i] * q[j] - q[0] * q[k]))
           for i in (1, 2, 3) for j in (1, 2, 3) if i != j for k in (6 - i - j,)], 'the rotation matrix of a quaternion, expanded')
    four = [names(' '.join(f'm{i}{j}' for j in range(1, 5))) for i in range(1, 5)]
    write(folder, 'cofactors4', ' '.join(str(e) for row in four for e in row),
          [(f'c{i + 1}{j + 1}', cofactor(four, i, j)) for i in range(4) for j in range(4)], 'cofactors of a 4x4 matrix')
    s = [[E(f's{min(i, j)}{max(i, j)}') for j in (1, 2, 3)] for i in (1, 2, 3)]
    write(folder, 'inverse3-symmetric', 's11 s12 s13 s22 s23 s33',
          [(f'i{i + 1}{j + 1}', cofactor(s, i, j) / determinant(s)) for i in range(3) for j in range(i, 3)],
          'inverse of a symmetric 3x3 matrix')


def shape_functions(folder):
    x, y, z = names('x y z')
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]

    def sided(v, s):
        return 1 + v if s > 0 else 1 - v
    quad8 = [0.25 * sided(x, i) * sided(y, j) * ((x if i > 0 else -x) + (y if j > 0 else -y) - 1) for i, j in corners]
    quad8 += [0.5 * (1 - x * x) * sided(y, -1), 0.5 * sided(x, 1) * (1 - y * y),
              0.5 * (1 - x * x) * sided(y, 1), 0.5 * sided(x, -1) * (1 - y * y)]
    write(folder, 'quad8-shape', 'x y', [(f'n{i + 1}', n) for i, n in enumerate(quad8)], 'shape functions of quad8')
    derivatives = []
    for k, (i, j) in enumerate(corners):
        sx, sy = (x if i > 0 else -x), (y if j > 0 else -y)
        derivatives += [(f'dx{k + 1}', 0.25 * i * sided(y, j) * (2 * sx + sy)),
                        (f'dy{k + 1}', 0.25 * j * sided(x, i) * (2 * sy + sx))]
    for k, s in ((5, -1), (7, 1)):
        derivatives += [(f'dx{k}', -x * sided(y, s)), (f'dy{k}', 0.5 * s * (1 - x * x))]
    for k, s in ((6, 1), (8, -1)):
        derivatives += [(f'dx{k}', 0.5 * s * (1 - y * y)), (f'dy{k}', -y * sided(x, s))]
    write(folder, 'quad8-derivatives', 'x y', derivatives, 'derivatives of the shape functions of quad8')
    cube = [(i, j, k) for k in (-1, 1) for i, j in corners]
    write(folder, 'hex8-shape', 'x y z',
          [(f'n{m + 1}', 0.125 * sided(x, i) * sided(y, j) * sided(z, k)) for m, (i, j, k) in enumerate(cube)],
          'shape functions of hex8')
    write(folder, 'hex8-derivatives', 'x y z',
          [(f'd{v}{m + 1}', 0.125 * s * sided(p, a) * sided(q, b)) for m, (i, j, k) in enumerate(cube)
           for v, s, p, a, q, b in (('x', i, y, j, z, k), ('y', j, x, i, z, k), ('z', k, x, i, y, j))],
          'derivatives of the shape functions of hex8')
    r, s = names('r s')
    t = 1 - r - s
    write(folder, 'tri6-shape', 'r s',
          [('n1', t * (2 * t - 1)), ('n2', r * (2 * r - 1)), ('n3', s * (2 * s - 1)),
           ('n4', 4 * r * t), ('n5', 4 * r * s), ('n6', 4 * s * t)], 'shape functions of tri6')

    def bernstein(v):
        w = 1 - v
        return [w * w * w, 3 * v * w * w, 3 * v * v * w, v * v * v]
    u, v = names('u v')
    write(folder, 'bernstein-cubic', 'u', [(f'b{i}', b) for i, b in enumerate(bernstein(u))],
          'cubic Bernstein polynomials')
    write(folder, 'bernstein-tensor', 'u v', [(f'b{i}{j}', p * q) for i, p in enumerate(bernstein(u))
                                              for j, q in enumerate(bernstein(v))], 'bicubic Bernstein polynomials')
    control = [f'p{i}{j}' for i in range(3) for j in range(3)]

    def quadratic(v):
        w = 1 - v
        return [w * w, 2 * v * w, v * v]
    write(folder, 'bezier-patch', 'u v ' + ' '.join(control),
          [('r', total(p * q * E(f'p{i}{j}') for i, p in enumerate(quadratic(u)) for j, q in enumerate(quadratic(v))))],
          'a biquadratic Bezier patch')
    hex_nodes = [f'x{m + 1}' for m in range(8)]
    write(folder, 'trilinear', 'x y z ' + ' '.join(hex_nodes),
          [('r', total(0.125 * sided(x, i) * sided(y, j) * sided(z, k) * E(hex_nodes[m])
                       for m, (i, j, k) in enumerate(cube)))], 'trilinear interpolation from eight nodes')


def rational(folder):
    x, y, z, w = names('x y z w')
    write(folder, 'quotients-equal', 'x y z', [('r', x / (1 + y) + z / (1 + y))], 'two quotients of one denominator')
    write(folder, 'quotients-related', 'x y z', [('r', 1 / (x + y) + z / (x * x - y * y) + y / (x - y))],
          'denominators that divide one another')
    write(folder, 'quotients-independent', 'x y z w', [('r', x / (1 + y) + z / (1 + w) + w / (2 + x))],
          'three quotients of unlike denominators')
    fraction = x + 4 / (y + 0.5)
    for k, v in enumerate((z, w, x, y)):
        fraction = v + (k + 1) / fraction
    write(folder, 'continued-fraction', 'x y z w', [('r', fraction)], 'a continued fraction of depth 5')
    fraction = E('2.75')
    for k in ('1.15', '3.5', '0.65', '2.2'):
        fraction = E(k) + x / fraction
    write(folder, 'continued-fraction-x', 'x', [('r', fraction)], 'a continued fraction in one variable')
    p, q = 120 + 60 * x + 12 * x * x + x * x * x, 120 - 60 * x + 12 * x * x - x * x * x
    write(folder, 'pade', 'x', [('r', p / q)], 'Pade approximant of exp, degree 3 over 3')
    write(folder, 'pade-pair', 'x y', [('s', (x * (1 - 0.1167 * y * y)) / (1 + 0.05 * y * y + 0.25 * x)),
                                       ('c', (1 - 0.45 * y * y + x) / (1 + 0.05 * y * y + 0.25 * x))],
          'two rational functions of one denominator')
    nodes = ['0.1', '0.35', '0.6', '0.85']
    weights = names('a b c d')
    poles = [k / (x - E(node)) for k, node in zip(('1', '-3', '3', '-1'), nodes)]
    write(folder, 'barycentric', 'x a b c d', [('r', total(p * v for p, v in zip(poles, weights)) / total(poles))],
          'barycentric Lagrange interpolation')
    nodes = names('p q r')
    write(folder, 'lagrange', 'x p q r f g h',
          [('v', total(value * (x - s) * (x - t) / ((at - s) * (at - t)) for value, at, s, t in zip(
              names('f g h'), nodes, nodes[1:] + nodes[:1], nodes[2:] + nodes[:2])))],
          'the parabola through three points')
    u = E('u')
    b = [(1 - u) * (1 - u), 2 * u * (1 - u), u * u]
    den = total(h * E(f'w{i}') for i, h in enumerate(b))
    write(folder, 'nurbs', 'u w0 w1 w2 x0 x1 x2 y0 y1 y2',
          [(v, total(h * E(f'w{i}') * E(f'{v}{i}') for i, h in enumerate(b)) / den) for v in 'xy'],
          'a rational quadratic curve in the plane')
    a, b, c, d, e, f = names('a b c d e f')
    det = a * d - b * c
    write(folder, 'cramer2', 'a b c d e f', [('x', (e * d - b * f) / det), ('y', (a * f - e * c) / det)],
          'a linear system of two equations')
    write(folder, 'lens', 'x y z w', [('r', 1 / (1 / x + 1 / y + 1 / z + 1 / w))], 'resistors in parallel')
    once = (a * x + b) / (c * x + d)
    write(folder, 'moebius', 'x a b c d', [('r', (a * once + b) / (c * once + d))], 'a Moebius map applied twice')
    rng = Random(28)
    chosen = rng.sample(monomials(SIMILARITY, 2), 24)
    write(folder, 'rational-quadratics', ' '.join(SIMILARITY),
          [('xi', '(' + terms_text([(rng.grid(), m) for m in chosen[:14]]) + ')/(' +
            terms_text([(rng.grid(), m) for m in [()] + chosen[14:]]) + ')')], 'a quotient of two sparse quadratics')


def univariate(folder):
    x = E('x')
    rng = Random(10)
    nested = E(rng.generic())
    for _ in range(10):
        nested = E(rng.generic()) + x * nested
    write(folder, 'horner', 'x', [('r', nested)], 'degree 10, given in Horner form')
    t = [E('1'), x]
    for _ in range(7):
        t.append(2 * x * t[-1] - t[-2])
    write(folder, 'chebyshev', 'x c0 c1 c2 c3 c4 c5 c6 c7 c8', [('r', total(E(f'c{k}') * t[k] for k in range(9)))],
          'a Chebyshev series of degree 8, by the recurrence')
    y, = variables('y')
    c = [P.of(1), y]
    for _ in range(7):
        c.append(2 * y * c[-1] - c[-2])
    write(folder, 'chebyshev-all', 'y', [(f't{k}', c[k]) for k in range(2, 9)],
          'Chebyshev polynomials to degree 8, expanded')
    write(folder, 'geometric', 'x', [('r', total(variables('x')[0] ** k for k in range(1, 16)))],
          'x + x^2 + ... + x^15')


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
    for part in (paper_pair, cubics, sparse, random_genomes, expanded, resultants, newton, shared, shape_functions,
                 rational, univariate):
        part(folder)


if __name__ == '__main__':
    main()
