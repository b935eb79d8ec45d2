"""Random genomes like those of evolution, with planted redundancies."""
from count import PRIME
from formulas import E, decimal

SIMILARITY = 'xC yC zC xD yD xS yS zS'.split()


def value(tree, at):
    """Of a nested tuple, modulo PRIME; None where it divides by 0."""
    if isinstance(tree, str):
        if tree in at:
            return at[tree]
        n = round(float(tree) * 20)
        return n * pow(20, -1, PRIME) % PRIME
    a, b = value(tree[1], at), value(tree[2], at)
    if a is None or b is None or (tree[0] == '/' and b == 0):
        return None
    return {'+': lambda: a + b, '-': lambda: a - b, '*': lambda: a * b,
            '/': lambda: a * pow(b, -1, PRIME)}[tree[0]]() % PRIME


def size(tree):
    return 1 if isinstance(tree, str) else 1 + size(tree[1]) + size(tree[2])


def formula(tree):
    if isinstance(tree, str):
        return E(tree)
    a, b = formula(tree[1]), formula(tree[2])
    return {'+': lambda: a + b, '-': lambda: a - b, '*': lambda: a * b, '/': lambda: a / b}[tree[0]]()


def paths(tree, path=()):
    yield path, tree
    if not isinstance(tree, str):
        yield from paths(tree[1], path + (1,))
        yield from paths(tree[2], path + (2,))


def replace(tree, path, new):
    if not path:
        return new
    parts = list(tree)
    parts[path[0]] = replace(tree[path[0]], path[1:], new)
    return tuple(parts)


def grow(rng, operators, depth, full):
    """As evolution's trees: a leaf is a constant one time in four, a branch ends early four times in ten."""
    if depth == 0:
        return decimal(rng.below(201) - 100, 20) if rng.chance(0.25) else rng.choice(SIMILARITY)
    return (rng.choice(operators),) + tuple(
        grow(rng, operators, 0 if not full and rng.chance(0.4) else depth - 1, full) for _ in range(2))


def commuted(rng, tree):
    """An equal tree with operands exchanged and sums and products associated otherwise."""
    if isinstance(tree, str):
        return tree
    op, a, b = tree[0], commuted(rng, tree[1]), commuted(rng, tree[2])
    if op in '+*':
        if not isinstance(a, str) and a[0] == op and rng.chance(0.5):
            return (op, a[1], (op, b, a[2]))
        return (op, b, a)
    return (op, a, b)


def redundant(rng, tree, rational):
    """`tree` in other words."""
    x, y = rng.choice(SIMILARITY), rng.choice(SIMILARITY)
    ways = [lambda: ('-', ('+', tree, x), x), lambda: ('*', tree, '1'), lambda: ('+', tree, ('-', x, x)),
            lambda: ('-', ('+', tree, tree), commuted(rng, tree)), lambda: ('+', ('*', x, y), ('-', tree, ('*', y, x)))]
    if rational:
        ways += [lambda: ('*', tree, ('/', x, x)), lambda: ('/', ('*', tree, x), x), lambda: ('/', tree, ('/', '1', x))]
    return rng.choice(ways)()


def random_genome(rng, genes, rational):
    """`genes` or a few less; built by inserting branches, as crossover does, some of them copies or redundant."""
    operators = ['+', '-', '*', '/'] if rational else ['+', '-', '*']
    at = {v: rng.below(PRIME) for v in SIMILARITY}
    tree = grow(rng, operators, 5, True)
    for _ in range(100000):
        n = size(tree)
        if genes - 4 <= n <= genes:
            return tree
        path, old = rng.choice(list(paths(tree)))
        kind = rng.below(8)
        if kind < 4:
            new = grow(rng, operators, rng.below(5), False)
        elif kind < 6:
            new = commuted(rng, rng.choice([t for _, t in paths(tree) if size(t) <= 25]))
        else:
            new = redundant(rng, old, rational)
        child = replace(tree, path, new)
        if size(child) <= genes and size(child) >= min(n, genes // 2) and value(child, at) not in (None, 0):
            tree = child
    raise RuntimeError('no genome of that size')
