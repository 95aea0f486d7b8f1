"""Numbers, words and lines of text files."""
import math
import re

NUMBER = re.compile(r'[+-]?((\d+\.?\d*|\.\d+)(e[+-]?\d+)?|inf|infinity|nan(\([a-z0-9_]*\))?)', re.I)
INTEGER = re.compile(r'-?\d+')


class Refused(Exception):
    pass


def need(condition):
    if not condition:
        raise Refused


def number(text):
    need(NUMBER.fullmatch(text))
    value = float(text.split('(')[0])
    need(not math.isinf(value) or 'inf' in text.lower())
    return value


def integer(text):
    need(INTEGER.fullmatch(text))
    value = int(text)
    need(-2**63 <= value < 2**63)
    return value


def count(text):
    value = integer(text)
    need(0 <= value < 2**32)
    return value


def words(line):
    return [word for word in re.split('[ \t\v\f]+', line) if word]


def lines_of(data, comments=False, joins=False):
    """Lists of words. A comment begins with a word that begins with '#'."""
    text = data.decode('latin-1')
    if text.startswith('\xef\xbb\xbf'):
        text = text[3:]
    physical = re.split('\r\n|\r|\n', text.rstrip('\0'))
    lines, open_line = [], []
    for at, line in enumerate(physical):
        if comments:
            found = re.search('(^|[ \t\v\f])#', line)
            line, cut = (line[:found.start()], True) if found else (line, False)
        joined = joins and not cut and line.endswith('\\') and at + 1 < len(physical)
        open_line += words(line[:-1] if joined else line)
        if not joined:
            lines.append(open_line)
            open_line = []
    return lines
