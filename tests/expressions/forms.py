"""The forms in which an expression is given to the rivals: polynomials in the inputs and in symbols for what is kept
apart (quotients, reciprocals, sums inside of products, named values, factors), and statements that join them."""
import itertools
import os
import signal
from collections import Counter
from fractions import Fraction

from sympy import QQ
from sympy.polys.fields import field
from sympy.polys.polyerrors import BasePolynomialError
from sympy.polys.rings import ring

from count import Rejected
from genome_text import operators_in

TIME_LIMIT = int(os.environ.get('TIME_LIMIT', '20'))  # seconds a candidate
MOST_TERMS = 1000


def with_limit(function):
    """Result of the call; TimeoutError after TIME_LIMIT."""
    def stop(*_):
        raise TimeoutError
    signal.signal(signal.SIGALRM, stop)
    signal.alarm(TIME_LIMIT)
    try:
        return function()
    finally:
        signal.alarm(0)


class System:
    """polynomials: [(name, ring element)]; joints: text of further statements in Python's syntax.  Outputs are named
    Zo0, Zo1, ..."""

    def __init__(self, name, polynomials, joints):
        self.name, self.polynomials, self.joints = name, polynomials, joints
        self.terms = sum(len(p) for _, p in polynomials)

    def same(self, other):
        return self.joints == other.joints and [str(p) for p in self.polynomials] == [str(p) for p in other.polynomials]

    def coefficients(self):
        """Positive ones other than 1."""
        return sorted({abs(fraction(c)) for _, p in self.polynomials for c in p.itercoeffs()} - {1})

    def variables(self):
        """Names that occur, most frequent first."""
        count = Counter()
        for _, p in self.polynomials:
            names = [str(s) for s in p.ring.symbols]
            for monomial in p.itermonoms():
                count.update(n for n, k in zip(names, monomial) if k)
        return sorted(count, key=lambda n: (-count[n], n))

    def texts(self, coefficients):
        """[(name, infix text)]; coefficients: {Fraction: text}."""
        return [(name, polynomial_text(p, coefficients)) for name, p in self.polynomials]


def fraction(c):
    return Fraction(int(c.numerator), int(c.denominator))


def polynomial_text(p, coefficients):
    names = [str(s) for s in p.ring.symbols]
    text = ''
    for monomial, c in p.terms():
        c = fraction(c)
        factors = [n if k == 1 else f'{n}^{k}' for n, k in zip(names, monomial) if k]
        if abs(c) != 1 or not factors:
            factors.insert(0, coefficients.get(abs(c), str(abs(c))))
        text += (' - ' if c < 0 else ' + ') + '*'.join(factors)
    return text or '0'


def orders_of(variables, most):
    """Orders of variables to try for nested forms: every one if few; else by frequency, backwards, and at random, half
    of them near the one by frequency."""
    if len(variables) <= 4:
        return [list(o) for o in itertools.permutations(variables)][:most]
    orders, state = [variables, variables[::-1]], 12345
    while len(orders) < most:
        order = list(variables)
        for i in range(len(order) - 1):
            state = (state * 6364136223846793005 + 1442695040888963407) % (1 << 64)
            k = i + (state >> 33) % (len(order) - i)
            if len(orders) % 2:
                k = i + (k - i) % min(3, len(order) - i)
            order[i], order[k] = order[k], order[i]
        orders.append(order)
    return orders


class Atoms:
    """Trees to polynomials over inputs and symbols: Zq for a quotient (or a reciprocal), Zs for a sum in a product if
    `nested`; otherwise products are expanded."""

    def __init__(self, genome, reciprocals, nested, keep_lets):
        operators = Counter(op for t in genome.trees() for op in operators_in(t))
        symbols = [f'Zq{k}' for k in range(operators['/'])] + \
            [f'Zs{k}' for k in range(2 * operators['*'] + 1 if nested else 0)]
        names = list(genome.inputs) + ([n for n, _ in genome.lets] if keep_lets else []) + symbols
        self.ring = ring(names, QQ)[0]
        self.generator = dict(zip(names, self.ring.gens))
        self.reciprocals, self.nested = reciprocals, nested
        self.quotients, self.sums, self.polynomials, self.joints = {}, {}, [], ''

    def quotient(self, a, b):
        if not b:
            raise Rejected('division by 0')
        if b.is_ground or not a:
            return a * (1 / b.LC)
        exact, rest = a.div(b)
        if not rest:
            return exact
        if not self.reciprocals and len(a) + len(b) < 60:
            a, b = a.cancel(b)
            if b.is_ground:
                return a * (1 / b.LC)
        top = self.ring.one if self.reciprocals else a
        key = (top.monic(), b.monic())
        size = top.LC / b.LC
        if key not in self.quotients:
            k = len(self.quotients)
            self.quotients[key] = (self.generator[f'Zq{k}'], size)
            numerator = '1' if top == 1 else str(fraction(top.LC)) if top.is_ground else f'Zn{k}'
            if not top.is_ground:
                self.polynomials.append((f'Zn{k}', top))
            self.polynomials.append((f'Zd{k}', b))
            self.joints += f'Zq{k} = {numerator}/Zd{k}\n'
        symbol, size_of_symbol = self.quotients[key]
        return (a if self.reciprocals else 1) * symbol * (size / size_of_symbol)

    def factor(self, p):
        """An operand of a product: a sum gets a name."""
        if not self.nested or len(p) < 2:
            return p
        key = p.monic()
        if key not in self.sums:
            name = f'Zs{len(self.sums)}'
            self.sums[key] = (self.generator[name], p.LC)
            self.polynomials.append((name, p))
        symbol, size = self.sums[key]
        return symbol * (p.LC / size)

    def tree(self, t, names):
        if isinstance(t, Fraction):
            return self.ring.ground_new(QQ(t.numerator, t.denominator))
        if isinstance(t, str):
            return names[t] if t in names else self.generator[t]
        a = [self.tree(s, names) for s in t[1:]]
        if t[0] == 'neg':
            return -a[0]
        if t[0] == '/':
            return self.quotient(*a)
        if t[0] == '*':
            a = [self.factor(p) for p in a]
            if len(a[0]) * len(a[1]) > 100 * MOST_TERMS:
                raise Rejected('too many terms')
        p = a[0] + a[1] if t[0] == '+' else a[0] - a[1] if t[0] == '-' else a[0] * a[1]
        if len(p) > MOST_TERMS:
            raise Rejected('too many terms')
        return p


def expand(genome, reciprocals=False, nested=False, keep_lets=False):
    a = Atoms(genome, reciprocals, nested, keep_lets)
    names = {}
    for name, tree in genome.lets:
        p = a.tree(tree, names)
        if keep_lets and not p.is_ground and not p.is_generator:
            a.polynomials.append((name, p))
        else:
            names[name] = p
    outputs = [(f'Zo{k}', a.tree(tree, names)) for k, (_, tree) in enumerate(genome.outputs)]
    kind = ['products kept' if nested else 'expanded'] + ['named values'] * keep_lets
    if a.joints:
        kind.append('reciprocals' if reciprocals else 'quotients')
    return System(', '.join(kind), a.polynomials + outputs, a.joints)


def fractions(genome, common):
    """One quotient of polynomials an output; `common`: of one denominator for all."""
    f = field(list(genome.inputs), QQ)[0]
    names = dict(zip(genome.inputs, f.gens))

    def build(t):
        if isinstance(t, Fraction):
            return f.ground_new(QQ(t.numerator, t.denominator))
        if isinstance(t, str):
            return names[t]
        a = [build(s) for s in t[1:]]
        r = -a[0] if t[0] == 'neg' else a[0] / a[1] if t[0] == '/' else a[0] + a[1] if t[0] == '+' else \
            a[0] - a[1] if t[0] == '-' else a[0] * a[1]
        if len(r.numer) + len(r.denom) > MOST_TERMS:
            raise Rejected('too many terms')
        return r
    for name, t in genome.lets:
        names[name] = build(t)
    parts = [(r.numer, r.denom) for r in (build(t) for _, t in genome.outputs)]
    if common:
        lcm = f.one.denom
        for _, bottom in parts:
            lcm = lcm.lcm(bottom)
        parts = [(top * lcm.exquo(bottom), lcm) for top, bottom in parts]
    polynomials, joints, denominators = [], '', {}
    for k, (top, bottom) in enumerate(parts):
        key = bottom.monic()
        if key not in denominators:  # scaled so that most coefficients are 1
            often = Counter(abs(c) for p in (top, bottom) for c in p.itercoeffs()).most_common(1)[0][0]
            denominators[key] = (f'Zd{len(denominators)}', bottom.LC / often)
            polynomials.append((denominators[key][0], bottom * (1 / often)))
        name, lead = denominators[key]
        polynomials.append((f'Zn{k}', top * (lead / bottom.LC)))
        joints += f'Zo{k} = Zn{k}/{name}\n'
    return System('one denominator for all' if common else 'one quotient', polynomials, joints)


def factored(system):
    """Each polynomial in factors, equal ones once; None where nothing factors."""
    polynomials, joints, known, some = [], '', {}, False
    for name, p in system.polynomials:
        content, factors = p.factor_list()
        if len(factors) < 2 and (not factors or factors[0][1] == 1):
            polynomials.append((name, p))
            continue
        some, words = True, [f'({fraction(content)})'] if content != 1 else []
        for q, power in factors:
            if q not in known:
                known[q] = str(q) if q.is_generator else f'Zf{len(known)}'
                if not q.is_generator:
                    polynomials.append((known[q], q))
            words.append(known[q] + (f'**{power}' if power > 1 else ''))
        joints += f'{name} = {"*".join(words)}\n'
    return System(system.name + ', factored', polynomials, joints + system.joints) if some and polynomials else None


def systems_of(genome):
    """Every form that can be made within the time limit; none twice."""
    found = []

    def attempt(make, *arguments):
        try:
            system = with_limit(lambda: make(*arguments))
            if system and not any(system.same(other) for other in found):
                found.append(system)
        except (Rejected, ArithmeticError, RecursionError, NotImplementedError, TimeoutError, BasePolynomialError):
            pass
    divides = genome.divides()
    attempt(expand, genome)
    if divides:
        attempt(expand, genome, True)
        attempt(fractions, genome, False)
        if len(genome.outputs) > 1:
            attempt(fractions, genome, True)
    for system in list(found):
        attempt(factored, system)
    attempt(expand, genome, False, True)
    if genome.lets:
        attempt(expand, genome, False, False, True)
        attempt(expand, genome, False, True, True)
        if divides:
            attempt(expand, genome, True, False, True)
    return found
