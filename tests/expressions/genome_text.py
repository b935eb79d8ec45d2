"""Reads genome files (codegen/genome.h) into trees: a name, a Fraction, or (operator, tree, ...)."""
import os
import re
from fractions import Fraction

BINARY = {'+', '-', '*', '/', '%', 'min', 'max'}
UNARY = {'neg', 'sqrt', 'abs'}
KEYWORDS = {'footpoint-genome', 'note', 'segment', 'input', 'range', 'let', 'genome', 'end'}


class Genome:
    """Lets and outputs are [(name, tree)]; only lets that the outputs read are kept."""

    def __init__(self, label, inputs, lets, outputs):
        self.label, self.inputs, self.outputs, self.lets = label, inputs, outputs, []
        need = set().union(*(names_in(t) for _, t in outputs))
        for name, tree in reversed(lets):
            if name in need:
                need |= names_in(tree)
                self.lets.insert(0, (name, tree))

    def trees(self):
        return [t for _, t in self.lets + self.outputs]

    def is_arithmetic(self):
        """+ - * / and neg only, which the rivals can treat."""
        return not any(op in ('min', 'max', 'sqrt', 'abs') for t in self.trees() for op in operators_in(t))

    def divides(self):
        return any(op == '/' for t in self.trees() for op in operators_in(t))


def names_in(tree):
    if isinstance(tree, tuple):
        return set().union(*(names_in(t) for t in tree[1:]))
    return {tree} if isinstance(tree, str) else set()


def operators_in(tree):
    if isinstance(tree, tuple):
        yield tree[0]
        for t in tree[1:]:
            yield from operators_in(t)


def parse_prefix(words):
    def one(i):
        word = words[i]
        if word in BINARY:
            a, i = one(i + 1)
            b, i = one(i)
            return ('/' if word == '%' else word, a, b), i  # no denominator is 0 at random points
        if word in UNARY:
            a, i = one(i + 1)
            return (word, a), i
        return (Fraction(word) if re.fullmatch(r'[-+]?[0-9.]+(e[-+]?[0-9]+)?', word) else word), i + 1
    return one(0)[0]


def read_genomes(path):
    """The genomes of a well-formed file; a genome `g` is labelled with the file's name, another FILE/NAME."""
    inputs, lets, genomes, outputs, statement = [], [], [], None, []

    def finish():
        if statement:
            (lets if outputs is None else outputs).append((statement[0], parse_prefix(statement[1:])))
            statement.clear()
    base = os.path.basename(path)[:-len('.gen')]
    with open(path, encoding='ascii') as text:
        for line in text:
            words = line.split('#')[0].replace('_', 'Z').split()  # FORM has no _ in names
            if not words:
                continue
            begins = words[0] in KEYWORDS or len(words) > 1 and words[1] == '='
            if begins:
                finish()
            if words[0] == 'input':
                inputs += words[1:]
            elif words[0] == 'genome':
                outputs = []
                genomes.append((base if words[1] == 'g' else f'{base}/{words[1]}', outputs))
            elif words[0] == 'let':
                statement[:] = [words[1]] + words[3:]
            elif len(words) > 1 and words[1] == '=':
                statement[:] = [words[0]] + words[2:]
            elif not begins:
                statement.extend(words)
    return [Genome(label, inputs, lets, outputs) for label, outputs in genomes]


def infix(tree):
    """Text that SymPy and Maxima read."""
    if isinstance(tree, tuple):
        if tree[0] == 'neg':
            return f'(-{infix(tree[1])})'
        return f'({infix(tree[1])}{tree[0]}{infix(tree[2])})'
    return tree if isinstance(tree, str) else f'({tree})'
