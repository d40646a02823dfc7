"""Single changes of a Fortran source in free form: signs, comparisons, constants, dropped
statements. Comments, texts and declarations stay, but for the values of named constants."""

import hashlib
import re
from collections import Counter
from dataclasses import dataclass

KINDS = ('sign', 'comparison', 'constant', 'statement')

NUMBER = re.compile(r'(?<![\w.%])(\d+\.\d*|\.\d+|\d+)([ed][+-]?\d+)?(_\w+)?', re.IGNORECASE)
COMPARISON = re.compile(r'=>|<=|>=|==|/=|<|>')
# the limit moved, and the answer turned round
OTHERS = {'<': ('<=', '>='), '<=': ('<', '>'), '>': ('>=', '<='), '>=': ('>', '<'),
          '==': ('/=',), '/=': ('==',)}
# Numbers with an exponent of this size are tolerances and stand-ins, which a tenth more or less
# leaves what they are
TOLERANCE = 6

STRUCTURE = re.compile(
    r'(use|implicit|private|public|module|submodule|program|subroutine|function|end|contains|'
    r'interface|abstract|procedure|generic|import|enum|enumerator|pure|elemental|impure|recursive)'
    r'\b(?!\s*[%(=])|(real|integer|logical|character|type)\s*(\([^)]*\))?\s+function\b|'
    r'type\s*(,|\w)', re.IGNORECASE)
BLOCK = re.compile(
    r'(\w+\s*:\s*)?(if\b.*\bthen|else\b.*|end\s*\w*.*|do\b.*|select\b.*|case\b.*|where\b.*|'
    r'forall\b.*|associate\b.*|block\b.*|type\s+is\b.*|class\s+(is|default)\b.*)$',
    re.IGNORECASE | re.DOTALL)


@dataclass(frozen=True)
class Mutant:
    """One change: the lines first..last (from 0) of a file become `lines`."""
    id: str
    kind: str
    file: str
    first: int
    last: int
    lines: tuple
    before: str
    after: str


def code_of(line):
    """The line with blanks in place of texts and of its comment."""
    code = []
    quote = ''
    for character in line:
        if quote:
            quote = '' if character == quote else quote
            code.append(' ')
        elif character == '!':
            break
        else:
            quote = character if character in '\'"' else ''
            code.append(' ' if quote else character)
    return ''.join(code).ljust(len(line))


def statements(codes):
    """First and last line of each statement."""
    first = None
    for i, code in enumerate(codes):
        text = code.strip()
        if not text:
            continue
        if first is None:
            first = i
        if not text.endswith('&'):
            yield first, i
            first = None


def without_brackets(text):
    """What stands outside all brackets."""
    depth = 0
    outside = []
    for character in text:
        depth += (character in '([') - (character in ')]')
        outside.append(character if depth == 0 else ' ')
    return ''.join(outside)


def changed_numbers(match):
    """A whole number by one up and down, another by a tenth."""
    digits, exponent, kind = match.group(1), match.group(2) or '', match.group(3) or ''
    if '.' not in digits and not exponent:
        return [f'{int(digits) + 1}{kind}', f'{int(digits) - 1}{kind}']
    if exponent and abs(int(exponent[1:])) >= TOLERANCE:
        return []
    value = float(digits)
    if value == 0.0:
        return [f'1.0{kind}']
    return [f'{value * factor:#.12g}'.rstrip('0') + exponent + kind for factor in (1.1, 0.9)]


def changes(code, constants_from):
    """(kind, place, length, new text) of all changes within a line; of constants alone, from a
    place on, if that is given."""
    numbers = list(NUMBER.finditer(code))
    for match in numbers:
        if match.start() >= (constants_from or 0):
            for new in changed_numbers(match):
                yield 'constant', match.start(), len(match.group()), new
    if constants_from is not None:
        return
    for match in COMPARISON.finditer(code):
        for new in OTHERS.get(match.group(), ()):
            yield 'comparison', match.start(), len(match.group()), new
    in_numbers = {i for match in numbers for i in range(*match.span())}
    for i, character in enumerate(code):
        if character in '+-' and i not in in_numbers:
            yield 'sign', i, 1, '-' if character == '+' else '+'


def short(text):
    """On one line, without its margin."""
    return re.sub(r'\s*&\s*', ' ', ' '.join(text.split()))


def mutants_of(path, source):
    """All single changes of a source."""
    lines = source.split('\n')
    codes = [code_of(line) for line in lines]
    seen = Counter()

    def mutant(kind, first, new):
        last = first + len(new) - 1
        before = short(' '.join(lines[first:last + 1]))
        after = short(' '.join(new)) or '(dropped)'
        seen[before, after] += 1
        # neither the line's number nor what stands elsewhere: a result holds while they change
        text = '\n'.join([path, before, after, str(seen[before, after])])
        return Mutant(hashlib.sha256(text.encode()).hexdigest()[:12], kind, path, first, last,
                      tuple(new), before, after)

    for first, last in statements(codes):
        whole = ' '.join(codes[first:last + 1]).strip()
        outside = without_brackets(whole)
        constants_from = None
        if '::' in outside:
            if not re.search(r'\bparameter\b', outside, re.IGNORECASE):
                continue
            constants_from = codes[first].find('=', codes[first].index('::')) + 1 or 10**6
        elif STRUCTURE.match(whole):
            continue
        for i in range(first, last + 1):
            for kind, place, length, new in changes(codes[i], constants_from):
                yield mutant(kind, i, [lines[i][:place] + new + lines[i][place + length:]])
            constants_from = 0 if constants_from is not None else None
        if constants_from is None and not BLOCK.match(whole):
            yield mutant('statement', first, [''] * (last - first + 1))
