#!/usr/bin/env python3
"""Operation counts of footpoint-codegen beside the best that FORM, Maxima and SymPy can be made to give.

Every rival gets each expression in several forms (forms.py) and with many settings (rivals.py).  What it prints is
checked against the genome and counted by one lenient counter (count.py), as is the genome as written, so that nobody is
judged by its defaults.  Raw output is cached.  Exit status: 0 no rival is better anywhere (with --tap: but for the
known misses of misses.csv), 1 some are, 2 a tool is missing.
"""
import argparse
import csv
import itertools
import multiprocessing
import os
import subprocess
import sys

sys.dont_write_bytecode = True
try:
    import rivals
    from forms import systems_of
except ImportError as missing:
    print(f'skipped: {missing}')
    sys.exit(2)
from count import MODELS, Graph, Program, Rejected, cost, genome_values
from genome_text import read_genomes

PROMISING = 1.3  # a form whose quick results cost more than this many times the best is given up
HOPELESS = 10 ** 9
HERE = os.path.dirname(os.path.abspath(__file__))


class Best:
    """The cheapest results by model, and by model and tool."""

    def __init__(self, goal):
        self.goal, self.found, self.rejected = goal, {}, []

    def offer(self, graph, values, tool, settings, text):
        if [graph.residues_of(v) for v in values] != self.goal:
            self.rejected.append(f'{tool} {settings}: not equal to the genome')
            return
        for model in MODELS:
            counts = graph.counts(values, model)
            result = (cost(counts, model), sum(counts), counts, tool, settings, text)
            for key in model, (model, tool):
                if key not in self.found or result[:2] < self.found[key][:2]:
                    self.found[key] = result


def best_of(arguments):
    """Runs in a process of its own."""
    genome, folder, tools = arguments
    sys.setrecursionlimit(20000)
    graph = Graph()
    values = genome_values(graph, genome)
    best = Best([graph.residues_of(v) for v in values])
    best.offer(graph, values, 'as written', '', '')
    cache = rivals.Cache(folder)
    costs = {}  # least by system and model

    def judge(candidate):
        text, system, settings = cache.get(candidate.key, candidate.make), candidate.system, candidate.settings
        if text is None:
            return
        text, settings = (text + system.joints, f'{system.name}: {settings}') if system else (text, settings)
        graph = Graph()
        try:
            outputs = Program(graph, candidate.numbers, text).outputs()
            best.offer(graph, outputs, candidate.tool, settings, text)
            for model in MODELS:
                key = id(system), model
                costs[key] = min(costs.get(key, HOPELESS), cost(graph.counts(outputs, model), model))
        except (Rejected, SyntaxError, KeyError, RecursionError) as reason:
            best.rejected.append(f'{candidate.tool} {settings}: {reason!r}')
    candidates = list(rivals.candidates(genome, systems_of(genome), tools))
    for candidate in candidates:
        if candidate.probe:
            judge(candidate)
    promising = {id(c.system) for c in candidates if any(
        costs.get((id(c.system), model), HOPELESS) <= PROMISING * best.found[model][0] for model in MODELS)}
    for candidate in candidates:
        if not candidate.probe and id(candidate.system) in promising:
            judge(candidate)
    return genome.label, best.found, best.rejected


def our_counts(codegen, path, model):
    """{label: (mul, add, div)}"""
    base = os.path.basename(path)[:-len('.gen')]
    has_models = '--cost' in subprocess.run([codegen, '--help'], capture_output=True, text=True, check=True).stdout
    command = [codegen, '--count'] + (['--cost', model] if has_models else []) + [path]
    rows = csv.DictReader(subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines())
    return {base if r['genome'] == 'g' else f'{base}/{r["genome"]}': (int(r['mul']), int(r['add']), int(r['div']))
            for r in rows}


def known_misses():
    """{(label, model): our cost}, which must not grow"""
    with open(os.path.join(HERE, 'misses.csv'), encoding='ascii') as lines:
        rows = csv.DictReader(line for line in lines if not line.startswith('#'))
        return {(row['expression'], row['model']): int(row['ours']) for row in rows}


def print_row(label, model, mine, found, options, number):
    best, each = found[model], ' '.join(f'{key[1]} {result[0]}' for key, result in found.items() if key[0] == model)
    lost = cost(mine, model) > best[0]
    slashes = ['/'.join(map(str, counts)) for counts in (mine, best[2])]
    if options.tap:
        known = lost and cost(mine, model) <= known_misses().get((label, model), 0)
        lost = lost and not known
        print(f'{"not " * lost}ok {number} - {label}, {model}: {slashes[0]} = {cost(mine, model)}; '
              f'{best[3]} {slashes[1]} = {best[0]}{" (a known miss)" * known}', flush=True)
    else:
        verdict = 'LOST' if lost else 'equal' if cost(mine, model) == best[0] else 'won'
        print(f'{label:24s} {model:10s} {slashes[0]:>10s} {cost(mine, model):4d} {slashes[1]:>10s} {best[0]:4d} '
              f'{verdict:5s} {best[3]} {best[4]} [{each}]', flush=True)
    return lost


def write_text(folder, label, model, result):
    with open(os.path.join(folder, f'{label.replace("/", "-")}.{model}.best.txt'), 'w', encoding='ascii') as out:
        out.write(f'# {result[3]} {result[4]}: {result[2]}\n{result[5]}')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--tap', action='store_true', help='TAP instead of a table')
    parser.add_argument('--record', help='write the best counts of the rivals to this CSV file')
    parser.add_argument('--texts', help='write the best texts of the rivals to this folder')
    parser.add_argument('--codegen', default='build/footpoint-codegen')
    parser.add_argument('--cache', default='build/algebra')
    parser.add_argument('--jobs', type=int, default=2)
    parser.add_argument('files', nargs='*', metavar='FILE.gen')
    options = parser.parse_args()
    if os.environ.get('PYTHONHASHSEED') != '0':  # SymPy's results depend on it
        os.execve(sys.executable, [sys.executable] + sys.argv, dict(os.environ, PYTHONHASHSEED='0'))
    tools = rivals.versions()
    if len(tools) < 3:
        print(f'skipped: of FORM, Maxima and SymPy only {", ".join(tools)} is installed')
        return 2
    versions = ', '.join(f'{tool} {version}' for tool, version in sorted(tools.items()))
    files = options.files or sorted(os.path.join(HERE, f) for f in os.listdir(HERE) if f.endswith('.gen'))
    genomes = [g for path in files for g in read_genomes(path) if g.is_arithmetic()]
    ours = {model: {} for model in MODELS}
    for model, path in itertools.product(MODELS, files):
        ours[model].update(our_counts(options.codegen, path, model))
    print(f'# {versions}; mul/add/div and cost: ours, best rival', flush=True)
    lost, number, rows = 0, 0, []
    with multiprocessing.Pool(options.jobs, maxtasksperchild=1) as pool:
        cache = os.path.join(options.cache, '_'.join(f'{tool}-{version}' for tool, version in sorted(tools.items())))
        jobs = [(g, cache, sorted(tools)) for g in genomes]
        for label, found, rejected in pool.imap(best_of, jobs, chunksize=1):
            for model in MODELS:
                number += 1
                lost += print_row(label, model, ours[model][label], found, options, number)
                best = found[model]
                rows.append([label, model, *best[2], best[0], best[3], best[4].replace(',', ';')])
                if options.texts:
                    write_text(options.texts, label, model, best)
            if rejected:
                print(f'#   {len(rejected)} rejected: {rejected[0]}'[:300], flush=True)
    if options.record:
        with open(options.record, 'w', encoding='ascii', newline='') as out:
            out.write(f'# {versions}\n')
            csv.writer(out, lineterminator='\n').writerows(
                [['expression', 'model', 'mul', 'add', 'div', 'cost', 'tool', 'settings']] + rows)
    return 1 if lost else 0


if __name__ == '__main__':
    sys.exit(main())
