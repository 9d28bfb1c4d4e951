"""Facts with what they must be: claims of benchmarks and of reproduced pictures."""
import sys


class Claims:
    """Collects what was measured; finish() prints it and ends the script with 1 if a claim fails."""

    def __init__(self):
        self.rows = []  # subject, what, measured value, claim, whether it holds

    def check(self, subject, what, value, holds, claim=''):
        self.rows.append((str(subject), what, str(value), claim, bool(holds)))

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
        return [row for row in self.rows if not row[-1]]

    def write(self, path):
        """Writes a Markdown table of all rows."""
        lines = ['| figure | what | measured | claim | held |', '|---|---|---|---|---|']
        lines += ['| %s | %s | %s | %s | %s |' % (
            *row[:4], ('yes' if row[-1] else 'NO') if row[3] else '') for row in self.rows]
        with open(path, 'w') as file:
            file.write('\n'.join(lines) + '\n')

    def finish(self):
        widths = [max(map(len, column), default=0) for column in zip(*(row[:3] for row in self.rows))]
        print()
        for row in self.rows:
            cells = [cell.ljust(width) for cell, width in zip(row, widths)]
            print(('FAILS ' if not row[-1] else 'holds ' if row[3] else '      '), *cells, row[3])
        failed = self.failed()
        if failed:
            sys.stdout.flush()
            sys.exit('%d of %d claims fail: %s' % (len(failed), len(self.rows), '; '.join(
                ': '.join(filter(None, row[:2])) for row in failed)))
        print('all claims hold', flush=True)
