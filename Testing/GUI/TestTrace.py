"""Tools > Start Trace records a journey with a drawn loop, a dragged handle, filters of several inputs and
second outputs; the script runs unchanged in pvpython and gives the same numbers to the bit."""
import json
import os
import subprocess
import tempfile

import window

RESULTS = '''
import json
import states
states.update_all()
with open(%r, 'w') as file:
    json.dump(states.results(), file)
'''
folder = tempfile.TemporaryDirectory()
script, seen, repeated = (os.path.join(folder.name, name) for name in ('trace.py', 'seen.json', 'repeated.json'))

w = window.Window()
w.menu('menuTools', 'actionToolsStartStopTrace')
w.accept('TraceOptionsDialog')
w.open('DentedSphere600.vtp')
w.filter('Shape Cut Feature')
w.wait(100)
w.event(window.PROPERTIES + 'ShapeLoop/DrawLoop', 'set_boolean', 'true')
for place in [(0.5, 0.4), (0.45, 0.45), (0.46, 0.52), (0.53, 0.55)]:
    w.drag([place])
w.key(window.ENTER)
w.apply()
w.wait(100)
w.open('PhantomHeadSmall.vtp')
w.filter('Shape Paste Feature')
w.choose_inputs(Feature='ShapeCutFeature1: Feature', Target='PhantomHeadSmall.vtp')
w.wait(100)
w.apply()
w.wait(100)
w.drag([(0.5, 0.5), (0.53, 0.5), (0.56, 0.49)])
w.wait(100)
w.select('/0/0|0')
w.filter('Shape Parameterize')
w.apply()
w.open('BallSmall.vtu')
w.filter('Shape Harmonic Volume Map')
w.choose_inputs(Domain='BallSmall.vtu', Boundary='ShapeParameterize1: Image')
w.choose(window.PROPERTIES + 'MapArray/ComboBox', 'SourcePosition')
w.choose(window.PROPERTIES + 'Method/ComboBox', 'Single Shot')
w.apply()
# What Tools > Stop Trace calls. The editor that it opens would ask at the end whether to save the script.
w.python('''
    from paraview import smtrace
    with open(%r, 'w') as file:
        file.write(smtrace.stop_trace())''' % script)
w.python(RESULTS % seen)
w.run()

text = open(script).read()
assert 'LoopPoints' in text and 'Seed' in text and 'Dragging' not in text, text
with open(script, 'a') as file:
    file.write(RESULTS % repeated)
subprocess.run(['pvpython', script], check=True, timeout=200)
seen, repeated = (json.load(open(path)) for path in (seen, repeated))
assert len(seen) == 7, sorted(seen)
assert seen == repeated, '%s\n%s' % (seen, repeated)
print('%d sources and filters with %d outputs give the same numbers' % (len(seen), sum(map(len, seen.values()))))
