"""Facts with what they must be: claims of benchmarks and of reproduced pictures."""
import sys

WORDS = {True: 'yes', None: 'not met', False: 'NO'}


class Claims:
    """Collects what was measured; finish() prints it and ends the script with 1 if a claim fails. What a
    paper claims of its own data is wanted here, too, and named where it is not met."""

    def __init__(self):
        self.rows = []  # subject, what, measured value, claim, whether it holds; None: wanted, not met

    def check(self, subject, what, value, holds, claim=''):
        self.rows.append((str(subject), what, str(value), claim, bool(holds)))

    def want(self, subject, what, value, holds, claim):
        """A claim of a paper, which is no claim of ours."""
        self.rows.append((str(subject), what, str(value), claim, True if holds else None))

    def note(self, subject, what, value):
        """A fact of which nothing is claimed."""
        self.check(subject, what, value, True)

    def at_most(self, subject, what, value, limit):
        self.check(subject, what, '%.4g' % value, value <= limit, 'at most %g' % limit)

    def at_least(self, subject, what, value, limit):
        self.check(subject, what, '%.4g' % value, value >= limit, 'at least %g' % limit)

    def none(self, subject, what, found):
        """Nothing may be in the list."""
        self.check(subject, what, ', '.join(map(str, found)) or 'none', not found, 'none')

    def failed(self):
        return [row for row in self.rows if row[-1] is False]

    def unmet(self):
        return [row for row in self.rows if row[-1] is None]

    def write(self, path):
        """Writes a Markdown table of all rows."""
        lines = ['| figure | what | measured | claim | held |', '|---|---|---|---|---|']
        lines += ['| %s | %s | %s | %s | %s |' % (
            *row[:4], WORDS[row[-1]] if row[3] else '') for row in self.rows]
        with open(path, 'w') as file:
            file.write('\n'.join(lines) + '\n')

    def finish(self):
        widths = [max(map(len, column), default=0) for column in zip(*(row[:3] for row in self.rows))]
        print()
        for row in self.rows:
            cells = [cell.ljust(width) for cell, width in zip(row, widths)]
            print({True: 'holds ', None: 'UNMET ', False: 'FAILS '}[row[-1]] if row[3] else '      ', *cells, row[3])
        failed = self.failed()
        if failed:
            sys.stdout.flush()
            sys.exit('%d of %d claims fail: %s' % (len(failed), len(self.rows), '; '.join(
                ': '.join(filter(None, row[:2])) for row in failed)))
        unmet = self.unmet()
        print('all claims hold' + (', but %d of the paper are not met' % len(unmet) if unmet else ''), flush=True)
