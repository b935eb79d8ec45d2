"""Reads genome files (codegen/genome/genome.h), version 3 without vectors and functions, into trees: a name, a Fraction, or (operator, tree, ...)."""
import os
import re
from fractions import Fraction

WORD = re.compile(r'[0-9.]+(?:[eE][-+]?[0-9]+)?|\w+|[-+*/%(),]')
BINDING = {'+': 1, '-': 1, '*': 2, '/': 2, '%': 2}
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


def parse(text):
    """By precedence climbing; a minus directly before a number is its sign."""
    words = [(w.group(), w.start(), w.end()) for w in WORD.finditer(text)]
    words.append((')', len(text), len(text)))
    at = 0

    def number(k):
        return words[k][0][0] in '0123456789.'

    def operand():
        nonlocal at
        word, _, end = words[at]
        at += 1
        if word == '-' and number(at) and words[at][1] == end:
            at += 1
            return -Fraction(words[at - 1][0])
        if word == '-':
            return ('neg', operand())
        if word == '(':
            tree = expression(1)
            at += 1
            return tree
        if number(at - 1):
            return Fraction(word)
        if words[at][0] != '(':
            return word
        tree = (word,)
        while words[at][0] != ')':
            at += 1
            tree += (expression(1),)
        at += 1
        return tree

    def expression(least):
        nonlocal at
        tree = operand()
        while BINDING.get(words[at][0], 0) >= least:
            op = words[at][0]
            at += 1
            tree = ('/' if op == '%' else op, tree, expression(BINDING[op] + 1))  # no denominator is 0 at random points
        return tree
    return expression(1)


def read_genomes(path):
    """The genomes of a well-formed file; a genome `g` is labelled with the file's name, another FILE/NAME."""
    inputs, lets, genomes, outputs, statement = [], [], [], None, []

    def finish():
        if statement:
            (lets if outputs is None else outputs).append((statement[0], parse(' '.join(statement[1:]))))
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
            elif words[0] == 'segment':  # quad4
                inputs += [axis + node for node in 'ABCDS' for axis in 'xyz']
            elif words[0] == 'genome':
                outputs = []
                genomes.append((base if words[1] == 'g' else f'{base}/{words[1]}', outputs))
            elif words[0] == 'let':
                statement[:] = [words[1]] + words[3:]
            elif len(words) > 1 and words[1] == '=':
                statement[:] = [words[0]] + words[2:]
            elif not begins:
                statement += words
    return [Genome(label, inputs, lets, outputs) for label, outputs in genomes]


def infix(tree):
    """Text that SymPy and Maxima read."""
    if isinstance(tree, tuple):
        if tree[0] == 'neg':
            return f'(-{infix(tree[1])})'
        return f'({infix(tree[1])}{tree[0]}{infix(tree[2])})'
    return tree if isinstance(tree, str) else f'({tree})'
