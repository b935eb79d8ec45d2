"""FORM, Maxima and SymPy at their best: each form of an expression with many settings."""
import ast
import hashlib
import itertools
import os
import re
import subprocess
import tempfile
from typing import Callable, NamedTuple

import sympy

from count import Rejected
from forms import TIME_LIMIT, System, orders_of, with_limit
from genome_text import infix

NO_RESULT = (Rejected, RecursionError, MemoryError, NotImplementedError, ArithmeticError, ValueError, TypeError,
             AttributeError, KeyError)


class Candidate(NamedTuple):
    tool: str
    settings: str
    system: System | None  # None: the genome as written
    key: str               # for the cache
    make: Callable         # gives straight-line text in Python's syntax
    numbers: dict          # what its symbols and numbers stand for
    probe: bool = False    # cheap: tells whether the form is worth the rest


class Cache:
    """A folder of raw results."""

    def __init__(self, folder):
        self.folder = folder
        os.makedirs(folder, exist_ok=True)

    def get(self, key, make):
        """Text of make(), or None where it fails; remembered by key.  What ran out of time is tried again with more."""
        path = os.path.join(self.folder, hashlib.sha256(key.encode()).hexdigest()[:32])
        known = None
        if os.path.exists(path):
            with open(path, encoding='ascii') as text:
                known = text.read()
        if known is None or known.startswith('failed') and int(known.split()[1]) < TIME_LIMIT:
            try:
                known = make()
            except TimeoutError:
                known = f'failed {TIME_LIMIT}'
            except NO_RESULT:
                known = 'failed 1000000'
            with open(f'{path}.{os.getpid()}', 'w', encoding='ascii') as out:
                out.write(known)
            os.replace(f'{path}.{os.getpid()}', path)
        return None if known.startswith('failed') else known


def run(command, text=None, folder=None):
    try:
        return subprocess.run(command, input=text, cwd=folder, capture_output=True, text=True, timeout=TIME_LIMIT,
                              check=False).stdout
    except subprocess.TimeoutExpired:
        raise TimeoutError from None


def coefficient_modes(system, modes):
    """(mode, {coefficient: text}, {symbol or number: coefficient})"""
    values = system.coefficients()
    for mode in modes if len(values) > 2 else modes[:1]:
        if mode == 'numbers':
            yield mode, {c: str(c) for c in values}, {}
        elif mode == 'symbols':
            yield mode, {c: f'Zc{k}' for k, c in enumerate(values)}, {f'Zc{k}': c for k, c in enumerate(values)}
        else:
            primes = list(itertools.islice(filter(sympy.isprime, itertools.count(1009)), len(values)))
            yield mode, {c: str(n) for c, n in zip(values, primes)}, dict(zip(primes, values))


# ---- FORM ------------------------------------------------------------------------------------------------------------


def form_settings(large, orders):
    """Format options and the seed of FORM's generator.  O3 searches orders of variables by tree search, O4 by simulated
    annealing; a given order leaves only the search for common subexpressions."""
    for o in 'O1', 'O2', 'O3', 'O4':
        yield o, 1
    for method in ('greedy', 'csegreedy') if large else ('greedy', 'csegreedy', 'cse', 'none'):
        for direction in 'forward', 'backward', 'forwardorbackward', 'forwardandbackward':
            yield f'O3,Method={method},HornerDirection={direction}', 1
    for constant in '0.1', '10':
        for seed in (1,) if large else (1, 2, 3):
            yield f'O3,Method=greedy,MCTSConstant={constant},MCTSNumExpand={300 if large else 3000}', seed
    yield f'O3,Method=greedy,MCTSNumExpand=300,MCTSNumRepeat={2 if large else 10}', 1
    for method in 'greedy', 'csegreedy':
        for seed in (1,) if large else (1, 2, 3):
            yield f'O4,Method={method},saIter={1000 if large else 5000}', seed
    yield 'O4,Method=greedy,saIter=200,saMaxT=20,saMinT=0.1', 1
    for order in orders:
        for method in ('greedy',) if large else ('greedy', 'csegreedy'):
            yield f'O3,Method={method},Scheme=({",".join(order)})', 1


def form_candidates(system):
    """All polynomials in one go: they are the coefficients of powers of the separator Zs."""
    several = len(system.polynomials) > 1
    for mode, texts, numbers in coefficient_modes(system, ('numbers', 'symbols', 'primes')):
        coefficients = list(texts.values()) if mode == 'symbols' else []
        variables = system.variables()
        large = system.terms > 100 or len(variables) > 20
        orders = [['sep_'] * several + order + coefficients for order in orders_of(variables, 6 if large else 24)]
        body = ''
        for k, (_, text) in enumerate(system.texts(texts)):
            text = text.replace(' + ', '\n + ').replace(' - ', '\n - ')
            body += f' + Zs^{k + 1}*({text})\n' if several else text + '\n'
        names = [name for name, _ in system.polynomials]
        tail = '.sort\n#optimize G\n#write <OUT> "%O"\n'
        if several:
            tail += 'B Zs;\n.sort\n' + ''.join(f'L F{k} = G[Zs^{k + 1}];\n' for k in range(len(names))) + '.sort\n'
            tail += ''.join(f'#write <OUT> "{name}=%e",F{k}\n' for k, name in enumerate(names))
        else:
            tail += f'#write <OUT> "{names[0]}=%e",G\n'
        for settings, seed in form_settings(large, orders):
            program = '#-\nOff statistics;\nS Zs,' + ','.join(sorted(set(variables + coefficients))) + ';\n' + \
                f'ExtraSymbols,array,Zw;\n#setrandom {seed}\nL G =\n{body};\n' + ('B Zs;\n' if several else '') + \
                f'Format {settings};\n{tail}.end\n'
            yield Candidate('FORM', f'{settings} seed {seed}, {mode}', system, 'FORM\n' + program,
                            lambda p=program: run_form(p), numbers, settings in ('O1', 'O2'))


def run_form(program):
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, 'a.frm'), 'w', encoding='ascii') as out:
            out.write(program.replace('<OUT>', f'<{folder}/out>'))
        run(['form', '-q', 'a.frm'], folder=folder)
        if not os.path.exists(os.path.join(folder, 'out')):
            raise Rejected('no output')
        with open(os.path.join(folder, 'out'), encoding='ascii') as text:
            raw = text.read()
    statements = [re.sub(r'\s+', ' ', s).replace('^', '**').strip() for s in raw.split(';')]
    return re.sub(r'Zw\((\d+)\)', r'Zw\1', '\n'.join(filter(None, statements))) + '\n'


# ---- Maxima ----------------------------------------------------------------------------------------------------------

MAXIMA_BEGIN = '''display2d: false$ load("facexp")$ load("scifac")$ keepfloat: false$
nest(e,l) := if l = [] then e else block([v: first(l), p: expand(e), h: hipow(expand(e), first(l)), r],
  r: nest(coeff(p, v, h), rest(l)),
  for k: h - 1 step -1 thru 0 do r: r*v + nest(coeff(p, v, k), rest(l)), r)$
'''


def maxima_candidates(genome, systems):
    for system in systems:
        large = system.terms > 60 or len(system.variables()) > 20
        variables = system.variables()
        calls = ['{}', 'factor({})', 'ratsimp({})', 'factorsum({})', 'gcfac({})', 'factor(ratsimp({}))']
        for order in orders_of(variables, 8 if large else 24):
            calls += [f'nest({{}},[{",".join(order)}])', f'ratdisrep(rat({{}},{",".join(order[::-1])}))']
        calls += [f'facsum({{}},{",".join(order)})' for order in orders_of(variables, 2 if large else 6)]
        names = [name for name, _ in system.polynomials]
        for mode, texts, numbers in coefficient_modes(system, ('numbers', 'symbols')):
            sources = [text for _, text in system.texts(texts)]
            for call in calls:
                program = maxima_program('', [call.format(text) for text in sources], names)
                yield Candidate('Maxima', f'{call.replace("{}", "_")}, {mode}', system, program,
                                lambda p=program, n=names: run_maxima(p, n), numbers, call == 'factor({})')
    outputs = [f'Zo{k}' for k in range(len(genome.outputs))]
    for call in '{}', 'factor({})', 'ratsimp({})':
        lets = ''.join(f'{n}: {call.format(infix(t))}$\n' for n, t in genome.lets)
        program = maxima_program(lets, [call.format(infix(t)) for _, t in genome.outputs], outputs)
        yield Candidate('Maxima', f'{call.replace("{}", "_")}, as written', None, program,
                        lambda p=program: run_maxima(p, outputs), {}, True)


def maxima_program(lets, expressions, names):
    return f'/* {" ".join(names)} */ ' + MAXIMA_BEGIN + lets + \
        'Zresult: optimize([' + ',\n'.join(expressions) + '])$\n' + 'print("ZBEGIN", string(Zresult), "ZEND")$\n'


def run_maxima(program, names):
    """The text of block([%1, ...], %1: ..., [result, ...]) or [result, ...]."""
    found = re.search(r'ZBEGIN\s*(.*?)\s*ZEND', re.sub(r'\\\n', '', run(['maxima', '--very-quiet'], program)), re.S)
    if not found:
        raise Rejected('no output')
    text = re.sub(r'\s+', '', found.group(1)).replace('^', '**').replace('%', 'Zt')
    parts = split_commas(text[len('block('):-1])[1:] if text.startswith('block(') else [text]
    results = split_commas(parts[-1][1:-1])
    if len(results) != len(names):
        raise Rejected('outputs')
    return ''.join(p.replace(':', ' = ', 1) + '\n' for p in parts[:-1]) + assignments(zip(names, results))


def assignments(pairs):
    return ''.join(f'{name} = {value}\n' for name, value in pairs)


def split_commas(text):
    parts, depth, start = [], 0, 0
    for i, c in enumerate(text):
        depth += (c in '([') - (c in ')]')
        if c == ',' and depth == 0:
            parts.append(text[start:i])
            start = i + 1
    return parts + [text[start:]]


# ---- SymPy -----------------------------------------------------------------------------------------------------------


def sympy_candidates(genome, systems):
    for system in systems:
        large = system.terms > 60 or len(system.variables()) > 20
        variables = system.variables()
        forms = [(form, None) for form in ('expand', 'factor', 'factor_terms', 'collect_const')]
        forms += [('horner', order) for order in orders_of(variables, 8 if large else 24)]
        forms += [('rcollect', order) for order in orders_of(variables, 4 if large else 12)]
        for mode, texts, numbers in coefficient_modes(system, ('numbers', 'symbols')):
            sources = [(name, text.replace('^', '**')) for name, text in system.texts(texts)]
            for (form, order), basic in itertools.product(forms, (False, True)):
                label = form + (' ' + ' '.join(order) if order else '') + (' basic' if basic else '') + f', {mode}'
                yield Candidate('SymPy', label, system, f'SymPy\n{form} {order} {basic}\n{sources}',
                                lambda s=sources, f=form, o=order, b=basic: run_sympy([], s, f, o, b), numbers,
                                form == 'factor' or order == variables)
    lets = [(n, infix(t)) for n, t in genome.lets]
    sources = [(f'Zo{k}', infix(t)) for k, (_, t) in enumerate(genome.outputs)]
    forms = ('as written', 'factor', 'factor_terms', 'together', 'cancel', 'apart', 'simplify')
    for form, basic in itertools.product(forms, (False, True)):
        yield Candidate('SymPy', f'{form} of the genome' + (' basic' if basic else ''), None,
                        f'SymPy\n{form} {basic}\n{lets}\n{sources}',
                        lambda f=form, b=basic: run_sympy(lets, sources, f, None, b), {}, True)


def run_sympy(lets, sources, form, order, basic):
    """Each source in the form, then common subexpression elimination over all."""
    def apply(p, symbols):
        if form in ('horner', 'rcollect'):
            return getattr(sympy, form)(sympy.expand(p), *[symbols[v] for v in order])
        if form == 'apart':
            return sympy.apart(p, min(p.free_symbols, key=str))
        return p if form == 'as written' else getattr(sympy, form)(p)

    def work():
        symbols = {n: sympy.Symbol(n) for _, t in lets + sources for n in re.findall(r'[A-Za-z_]\w*', t)}
        for name, text in lets:
            symbols[name] = read(text, symbols)
        e = [apply(read(text, symbols), symbols) for _, text in sources]
        steps, results = sympy.cse(e, symbols=sympy.numbered_symbols('Zt'), optimizations='basic' if basic else None)
        return assignments(steps) + assignments((name, result) for (name, _), result in zip(sources, results))
    return with_limit(work)


def read(text, symbols):
    """Text to a SymPy expression with exact numbers."""
    operations = {ast.Add: lambda a, b: a + b, ast.Sub: lambda a, b: a - b, ast.Mult: lambda a, b: a * b,
                  ast.Div: lambda a, b: a / b, ast.Pow: lambda a, b: a ** b}

    def build(t):
        if isinstance(t, ast.Constant):
            return sympy.Integer(t.value)
        if isinstance(t, ast.Name):
            return symbols[t.id]
        if isinstance(t, ast.UnaryOp):
            return -build(t.operand) if isinstance(t.op, ast.USub) else build(t.operand)
        if isinstance(t.op, (ast.Add, ast.Sub)):  # a long sum at once
            terms = []
            while isinstance(t, ast.BinOp) and isinstance(t.op, (ast.Add, ast.Sub)):
                terms.append(build(t.right) if isinstance(t.op, ast.Add) else -build(t.right))
                t = t.left
            return sympy.Add(build(t), *terms[::-1])
        return operations[type(t.op)](build(t.left), build(t.right))
    return build(ast.parse(text.strip(), mode='eval').body)


# ---- all -------------------------------------------------------------------------------------------------------------


def versions():
    """{tool: version} of what is installed."""
    found = {'SymPy': sympy.__version__}
    for tool, command, pattern in (('FORM', ['form', '-v'], r'FORM ([0-9.]+)'),
                                   ('Maxima', ['maxima', '--version'], r'Maxima ([0-9.]+)')):
        try:
            match = re.search(pattern, subprocess.run(command, capture_output=True, text=True, check=False).stdout)
            found.update({tool: match.group(1)} if match else {})
        except OSError:
            pass
    return found


def candidates(genome, systems, tools):
    for system in systems:
        if 'FORM' in tools:
            yield from form_candidates(system)
    if 'Maxima' in tools:
        yield from maxima_candidates(genome, systems)
    yield from sympy_candidates(genome, systems)
