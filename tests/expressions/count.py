"""One counter for everybody's straight-line text, lenient to the rivals: equal operations count once, powers of one
base share a shortest chain, signs and constant folding are free, 2 * x is an addition (4 * x and so on are some in the
paper's model), and quotients of one denominator become one division and products where the cost model likes that.

    >>> operations('Zo0 = (a + b)*c - (b + a)*d')           # (mul, add, div)
    (2, 2, 0)
    >>> operations('Zo0 = x**5 + x**3\\nZo1 = y**(-2)')      # x^2, x^3, x^5; y^2
    (4, 1, 1)
    >>> operations('t = 2*x\\nt = t - 3*2*y\\nZo0 = -t/4')    # 2*x is x + x, constants fold, signs are free
    (2, 2, 0)
    >>> operations('Zo0 = 4*x - 1', 'paper')
    (0, 3, 0)
    >>> operations('Zo0 = a/d\\nZo1 = 3*b/d'), operations('Zo0 = a/d\\nZo1 = 3*b/d', 'paper')
    ((3, 0, 1), (1, 0, 2))
"""
import ast
import hashlib
from fractions import Fraction

PRIME = (1 << 61) - 1
POINTS = 3
MODELS = ('throughput', 'paper')


class Rejected(Exception):
    """A candidate that gives no usable result."""


def cost(counts, model):
    """Of (mul, add, div)."""
    mul, add, div = counts
    return mul + add + 8 * div if model == 'throughput' else mul + div


class Graph:
    """Operations, equal ones merged.  A value is (coefficient, node): +-1 and a node, or a constant and node 0, which
    is the number 1.  Each node keeps its exact value modulo PRIME at random points, so results can be checked."""

    def __init__(self):
        self.keys = [('one',)]
        self.residues = [(1,) * POINTS]
        self.index = {}

    def node(self, key, residues):
        if key not in self.index:
            self.index[key] = len(self.keys)
            self.keys.append(key)
            self.residues.append(tuple(v % PRIME for v in residues))
        return self.index[key]

    def residues_of(self, a):
        c = a[0].numerator * pow(a[0].denominator, -1, PRIME)
        return tuple(c * v % PRIME for v in self.residues[a[1]])

    def input(self, name):
        digests = [hashlib.sha256(f'{name} {k}'.encode()).digest() for k in range(POINTS)]
        return Fraction(1), self.node(('input', name), [int.from_bytes(d[:7], 'big') for d in digests])

    def scale(self, c, a):
        if c == 0:
            return Fraction(0), 0
        if a[1] == 0 or abs(c) == 1:
            return c * a[0], a[1]
        size = abs(c)
        return a[0] * c / size, self.node(('scale', size, a[1]), self.residues_of((size, a[1])))

    def mul(self, a, b):
        if a[1] == 0 or b[1] == 0:
            return self.scale(a[0], b) if a[1] == 0 else self.scale(b[0], a)
        if a[1] == b[1]:
            return a[0] * b[0], self.power((Fraction(1), a[1]), 2)[1]
        return a[0] * b[0], self.node(('mul',) + tuple(sorted((a[1], b[1]))),
                                      [x * y for x, y in zip(self.residues[a[1]], self.residues[b[1]])])

    def power(self, a, n):
        if n < 0:
            return self.div((Fraction(1), 0), self.power(a, -n))
        if n == 1 or a[1] == 0 or n == 0:
            return a if n == 1 else (a[0] ** n, 0)
        return a[0] ** n, self.node(('power', a[1], n), [pow(x, n, PRIME) for x in self.residues[a[1]]])

    def add(self, a, b):
        if a[0] == 0 or b[0] == 0:
            return b if a[0] == 0 else a
        if a[1] == b[1]:
            return self.scale(a[0] + b[0], (Fraction(1), a[1]))
        if b[1] < a[1]:
            a, b = b, a
        sign = b[0] if a[1] == 0 else a[0]  # taken out, so that b - a and a - b are one
        first, second = self.residues_of((a[0] * sign, a[1])), self.residues_of((b[0] * sign, b[1]))
        return sign, self.node(('add', a[0] * sign, b[0] * sign, a[1], b[1]), [x + y for x, y in zip(first, second)])

    def div(self, a, b):
        if 0 in self.residues_of(b):
            raise Rejected('division by 0')
        if b[1] == 0:
            return self.scale(1 / b[0], a)
        if a[0] == 0 or a[1] == b[1]:
            return a[0] * b[0], 0
        top = abs(a[0])  # 1, or a constant
        residues = [x * pow(y, -1, PRIME) for x, y in zip(self.residues_of((top, a[1])), self.residues[b[1]])]
        return a[0] * b[0] / top, self.node(('div', top, a[1], b[1]), residues)

    def operands(self, n):
        key = self.keys[n]
        first = {'one': 1, 'input': 2, 'scale': 2, 'mul': 1, 'power': 1, 'add': 3, 'div': 2}[key[0]]
        return key[1:2] if key[0] == 'power' else key[first:]

    def counts(self, outputs, model):
        """(mul, add, div) of what the outputs need."""
        live, stack = set(), [n for _, n in outputs]
        while stack:
            n = stack.pop()
            if n not in live:
                live.add(n)
                stack.extend(self.operands(n))
        mul = add = div = 0
        powers, quotients = {}, {}
        for key in (self.keys[n] for n in live):
            if key[0] == 'add' or key[0] == 'scale' and key[1] == 2:
                add += 1
            elif key[0] == 'scale' and model == 'paper' and is_power_of_two(key[1]):
                add += key[1].numerator.bit_length() - 1
            elif key[0] in ('mul', 'scale'):
                mul += 1
            elif key[0] == 'power':
                powers.setdefault(key[1], set()).add(key[2])
            elif key[0] == 'div':
                quotients.setdefault(key[3], []).append(key[1:3])
        for exponents in powers.values():
            mul += chain_length(frozenset(exponents))
        for tops in quotients.values():
            products = sum(1 for top in tops if top != (1, 0))
            by_reciprocal = cost((products, 0, 1), model) < cost((0, 0, len(tops)), model)
            mul, div = (mul + products, div + 1) if by_reciprocal else (mul, div + len(tops))
        return mul, add, div


def is_power_of_two(c):
    return c.denominator == 1 and c.numerator.bit_count() == 1


CHAINS = {}


def chain_length(exponents):
    """Length of the shortest addition chain that holds them all."""
    goal = sorted(exponents)

    def search(chain, left):
        missing = sum(1 for e in goal if e not in chain)
        if missing == 0:
            return True
        if missing > left or chain[-1] << left < goal[-1]:
            return False
        sums = sorted({a + b for a in chain for b in chain if chain[-1] < a + b <= goal[-1]}, reverse=True)
        return any(search(chain + (s,), left - 1) for s in sums)
    if exponents not in CHAINS:
        length = len(goal)
        while not search((1,), length):
            length += 1
        CHAINS[exponents] = length
    return CHAINS[exponents]


def genome_values(graph, genome):
    """Values of the outputs as the genome writes them."""
    names = {}

    def build(tree):
        if isinstance(tree, Fraction):
            return tree, 0
        if isinstance(tree, str):
            return names[tree] if tree in names else graph.input(tree)
        a = [build(t) for t in tree[1:]]
        if tree[0] in ('neg', '-'):
            a[-1] = (-a[-1][0], a[-1][1])
        operation = {'+': graph.add, '-': graph.add, '*': graph.mul, '/': graph.div, 'neg': lambda a: a}[tree[0]]
        return operation(*a)

    for name, tree in genome.lets:
        names[name] = build(tree)
    return [build(tree) for _, tree in genome.outputs]


class Program:
    """Straight-line text, 'name = expression' by line, in the syntax of Python.  A name that is assigned again means
    the later value in later lines; one that is read before it is assigned (no cycle, though) means the first value.
    numbers: {name or integer: Fraction} for what stands for a coefficient."""

    def __init__(self, graph, numbers, text):
        self.graph, self.numbers, self.trees, self.done, self.last = graph, numbers, {}, {}, {}
        for line in filter(str.strip, text.split('\n')):
            name, expression = (part.strip() for part in line.split('=', 1))
            tree = ast.parse(expression, mode='eval').body
            for n in ast.walk(tree):
                if isinstance(n, ast.Name):
                    n.id = self.last.get(n.id, n.id)
            self.last[name] = f'{name}@{len(self.trees)}' if name in self.trees else name
            self.trees[self.last[name]] = tree

    def resolve(self, name):
        if name not in self.done:
            self.done[name] = None
            if name in self.trees:
                self.done[name] = self.build(self.trees[name])
            else:
                self.done[name] = (self.numbers[name], 0) if name in self.numbers else self.graph.input(name)
        if self.done[name] is None:
            raise Rejected('cycle')
        return self.done[name]

    def build(self, t):
        if isinstance(t, ast.Constant):
            return self.numbers.get(t.value, Fraction(t.value)), 0
        if isinstance(t, ast.Name):
            return self.resolve(t.id)
        if isinstance(t, ast.UnaryOp):
            a = self.build(t.operand)
            return (-a[0], a[1]) if isinstance(t.op, ast.USub) else a
        if not isinstance(t, ast.BinOp):
            raise Rejected(ast.unparse(t))
        if isinstance(t.op, ast.Pow):
            return self.graph.power(self.build(t.left), self.exponent(t))
        if isinstance(t.op, (ast.Add, ast.Sub)):
            a, b = self.build(t.left), self.build(t.right)
            return self.graph.add(a, b if isinstance(t.op, ast.Add) else (-b[0], b[1]))
        return self.build_product(t)

    def exponent(self, t):
        n = self.build(t.right)
        if n[1] or n[0].denominator != 1:
            raise Rejected('power')
        return int(n[0])

    def build_product(self, t):
        """Products and quotients of many factors: one division, and the constants together, multiplied last."""
        g = self.graph
        constant, above, below = Fraction(1), None, None
        for tree, power in self.factors(t, 1):
            a = g.power(self.build(tree), abs(power))
            if a[1] == 0:
                if a[0] == 0 and power < 0:
                    raise Rejected('division by 0')
                constant *= a[0] if power > 0 else 1 / a[0]
            elif power > 0:
                above = a if above is None else g.mul(above, a)
            else:
                below = a if below is None else g.mul(below, a)
        if below is None or above is None:
            return g.scale(constant, above or (Fraction(1), 0)) if below is None else g.div((constant, 0), below)
        return g.scale(constant, g.div(above, below))

    def outputs(self):
        """Values of Zo0, Zo1, ... after the last line."""
        return [self.resolve(self.last[f'Zo{k}']) for k in range(sum(name.startswith('Zo') for name in self.last))]

    def factors(self, t, power):
        """(tree, power)"""
        if isinstance(t, ast.BinOp) and isinstance(t.op, (ast.Mult, ast.Div)):
            yield from self.factors(t.left, power)
            yield from self.factors(t.right, power if isinstance(t.op, ast.Mult) else -power)
        elif isinstance(t, ast.BinOp) and isinstance(t.op, ast.Pow):
            yield t.left, power * self.exponent(t)
        else:
            yield t, power


def operations(text, model='throughput'):
    """(mul, add, div) of straight-line text."""
    graph = Graph()
    return graph.counts(Program(graph, {}, text).outputs(), model)
