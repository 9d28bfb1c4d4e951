"""From a file to hexahedra for a solver: open, remesh, look inside, write the input file of a solver. The saved
state and the recorded script give the same numbers.

With the path of another model as argument, it ends when one looks inside."""
import json
import os
import subprocess
import sys
import tempfile

import journey
import window

MODEL = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.environ['SHAPEMAP_MODELS'], 'sphere966.off')
RESULTS = '''
import json
import states
states.update_all()
with open(%r, 'w') as file:
    json.dump(states.results(), file)
'''
folder = tempfile.TemporaryDirectory()


def path(name):
    return os.path.join(folder.name, name)


def load(name):
    with open(path(name)) as file:
        return json.load(file)


w = journey.Journey('Hexahedra' + (os.path.splitext(os.path.basename(MODEL))[0] if len(sys.argv) > 1 else ''))
if len(sys.argv) == 1:
    w.menu('menuTools', 'actionToolsStartStopTrace')
    w.accept('TraceOptionsDialog')
w.open_path(MODEL)
w.step('opened')

before = w.clicks
w.filter('Shape Hex Remesh')
w.apply()
remesh = w.clicks - before
w.step('hexahedra')
w.python('''
    made = GetActiveSource()
    assert GetDisplayProperties(made).ColorArrayName[1] == 'ScaledJacobian'
    cells = made.GetDataInformation().GetNumberOfCells()''')
w.event('menubar', 'activate', 'menu_View')
w.event('menubar/menu_View/ShapeMapViews', 'activate', 'hexahedra')
look = w.clicks
w.step('inside')
w.python('''
    assert GetActiveSource() == made and GetActiveSource().Port == 0, 'Save Data would write a part only'
    cut = FindSource('Clip1')
    assert 0 < cut.GetDataInformation().GetNumberOfCells() < cells
    assert GetDisplayProperties(cut).ColorArrayName[1] == 'ScaledJacobian' ''')
assert remesh + look <= 8, '%d clicks from the opened file to a coloured cut' % (remesh + look)
if len(sys.argv) > 1:
    w.run(560)
    sys.exit()

w.menu('menu_File', 'actionFileSaveData')
w.event('FileSaveDialog', 'filesSelected', path('mesh.inp'))
w.click('WriterSettingsDialog/widget/OKButton')
w.step('input file written')
w.python('''
    import re
    elements = re.search('TYPE=C3D8.*?\\n(.*?)\\n[*]', open(%r).read(), re.DOTALL).group(1)
    assert len(elements.splitlines()) == cells, (len(elements.splitlines()), cells)''' % path('mesh.inp'))
w.menu('menu_File', 'actionFileSaveServerState')
w.event('FileSaveServerStateDialog', 'filesSelected', path('state.pvsm'))
w.step('state saved')
# What Tools > Stop Trace calls. The editor that it opens would ask at the end whether to save the script.
w.python('''
    from paraview import smtrace
    with open(%r, 'w') as file:
        file.write(smtrace.stop_trace())''' % path('trace.py'))
w.python(RESULTS % path('seen.json'))
w.run()

w = journey.Journey('HexahedraReopened')
w.menu('menu_File', 'actionFileLoadServerState')
w.event('FileLoadServerStateDialog', 'filesSelected', path('state.pvsm'))
w.accept('LoadStateOptionsDialog')
w.step('state opened')
w.python(RESULTS % path('reopened.json'))
w.run()

with open(path('trace.py'), 'a') as file:
    file.write(RESULTS % path('repeated.json'))
subprocess.run(['pvpython', path('trace.py')], check=True, timeout=200)
seen = load('seen.json')
assert {'sphere966.off', 'ShapeHexRemesh1', 'Clip1', 'Histogram1'} <= set(seen), sorted(seen)
assert seen == load('reopened.json'), 'the state differs'
assert seen == load('repeated.json'), 'the script differs'
