"""Formulas, polynomials and random numbers from which make.py writes genomes."""
import itertools


class Random:
    """64-bit linear congruential generator (Knuth's MMIX constants), upper bits only."""

    def __init__(self, seed):
        self.state = seed
        for _ in range(4):
            self.below(2)

    def below(self, n):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % (1 << 64)
        return (self.state >> 33) * n >> 31

    def chance(self, p):
        return self.below(1 << 20) < p * (1 << 20)

    def choice(self, items):
        return items[self.below(len(items))]

    def sample(self, items, n):
        items = list(items)
        for i in range(n):
            k = i + self.below(len(items) - i)
            items[i], items[k] = items[k], items[i]
        return items[:n]

    def generic(self):
        """A coefficient that no other shares: four digits."""
        return f'{self.choice(["", "-"])}{1 + self.below(4)}.{1000 + self.below(9000)}'

    def grid(self):
        """One of the paper's constants, -5..5 by 0.05, but not 0."""
        k = 1 + self.below(100)
        return decimal(self.choice([k, -k]), 20)


def decimal(n, d):
    """n/d as an exact decimal; d divides a power of ten."""
    text = f'{n * (10 ** 6 // d) / 10 ** 6:.6f}'.rstrip('0').rstrip('.')
    return text


# ---- formulas as written ---------------------------------------------------------------------------------------------


SUM, PRODUCT, OPERAND = range(3)


class E:
    """A formula; str() is its infix text."""

    def __init__(self, text, kind=OPERAND):
        self.text, self.kind = str(text), kind

    def __str__(self):
        return self.text

    def __add__(self, o):
        return combined(self, ' + ', o, SUM)

    def __radd__(self, o):
        return combined(o, ' + ', self, SUM)

    def __sub__(self, o):
        return combined(self, ' - ', o, SUM)

    def __rsub__(self, o):
        return combined(o, ' - ', self, SUM)

    def __mul__(self, o):
        return combined(self, '*', o, PRODUCT)

    def __rmul__(self, o):
        return combined(o, '*', self, PRODUCT)

    def __truediv__(self, o):
        return combined(self, '/', o, PRODUCT)

    def __rtruediv__(self, o):
        return combined(o, '/', self, PRODUCT)

    def __neg__(self):
        return E(f'-{within(self, PRODUCT)}', PRODUCT)


def within(formula, kind, first=True):
    """As an operand, in parentheses where the text would group otherwise."""
    f = formula if isinstance(formula, E) else E(formula)
    needed = f.kind < kind or not first and (f.kind == kind or f.text.startswith('-'))
    return f'({f})' if needed else f.text


def combined(a, operator, b, kind):
    return E(within(a, kind) + operator + within(b, kind, False), kind)


def names(text):
    return [E(name) for name in text.split()]


def total(items):
    items = list(items)
    result = items[0]
    for item in items[1:]:
        result = result + item
    return result


def product(items):
    items = list(items)
    result = items[0]
    for item in items[1:]:
        result = result * item
    return result


def determinant(m):
    """By cofactors of the first row; works on formulas and on polynomials."""
    if len(m) == 1:
        return m[0][0]
    result = None
    for j, head in enumerate(m[0]):
        if head is None:
            continue
        minor = determinant([row[:j] + row[j + 1:] for row in m[1:]])
        if minor is None:
            continue
        term = head * minor
        result = term if result is None and j % 2 == 0 else -term if result is None else \
            result + term if j % 2 == 0 else result - term
    return result


def cofactor(m, i, j):
    minor = determinant([row[:j] + row[j + 1:] for k, row in enumerate(m) if k != i])
    return minor if (i + j) % 2 == 0 else -minor


# ---- polynomials, expanded -------------------------------------------------------------------------------------------


class P:
    """Integer polynomial: {((variable, power), ...): coefficient}."""

    def __init__(self, terms):
        self.terms = {m: c for m, c in terms.items() if c}

    @staticmethod
    def of(value):
        return value if isinstance(value, P) else P({(): value})

    def __add__(self, o):
        terms = dict(self.terms)
        for m, c in P.of(o).terms.items():
            terms[m] = terms.get(m, 0) + c
        return P(terms)

    def __neg__(self):
        return P({m: -c for m, c in self.terms.items()})

    def __sub__(self, o):
        return self + -P.of(o)

    def __mul__(self, o):
        terms = {}
        for a, c in self.terms.items():
            for b, d in P.of(o).terms.items():
                powers = dict(a)
                for v, k in b:
                    powers[v] = powers.get(v, 0) + k
                m = tuple(sorted(powers.items()))
                terms[m] = terms.get(m, 0) + c * d
        return P(terms)

    __radd__ = __add__
    __rmul__ = __mul__

    def __pow__(self, n):
        return product([self] * n)

    def diff(self, v):
        terms = {}
        for m, c in self.terms.items():
            powers = dict(m)
            if v in powers:
                c *= powers[v]
                powers[v] -= 1
                terms[tuple((w, k) for w, k in sorted(powers.items()) if k)] = c
        return P(terms)

    def over(self, v):
        """Divided by the variable v."""
        return P({tuple((w, k - (w == v)) for w, k in m if k - (w == v)): c for m, c in self.terms.items()})

    def __str__(self):
        terms = sorted(self.terms.items(), key=lambda t: (-sum(k for _, k in t[0]), t[0]))
        return terms_text([(str(c), [v for v, k in m for _ in range(k)]) for m, c in terms])


def variables(text):
    return [P({((name, 1),): 1}) for name in text.split()]


def term_text(coefficient, monomial):
    return '*'.join(([] if coefficient == '1' and monomial else [coefficient]) + list(monomial))


def terms_text(terms):
    """A sum of (coefficient text, [variable, ...]), negative terms subtracted."""
    text = None
    for coefficient, monomial in terms:
        negative = coefficient.startswith('-')
        if text is None:
            text = term_text(coefficient[1:] if negative and monomial else coefficient, monomial)
            text = '-' + text if negative and monomial else text
        else:
            text += f' {"-" if negative else "+"} {term_text(coefficient.lstrip("-"), monomial)}'
    return text


def monomials(inputs, degree):
    for d in range(degree + 1):
        yield from itertools.combinations_with_replacement(inputs, d)
