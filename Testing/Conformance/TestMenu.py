"""Each filter of the menu says in its XML where it is in Filters > ShapeMap and what it needs, has an icon,
search words of its own and a first view, and a long panel has headings: TestMenu.py SOURCE_FOLDER. Runs
without ParaView."""
import glob
import os
import sys
from xml.etree import ElementTree

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.abspath(sys.argv[1]), 'Utilities'))
import proxies

root = sys.argv[1]
TASKS = {'Prepare', 'Map surfaces', 'Map solids', 'Hexahedra', 'Deform and compose', 'Measure'}
menu = open(os.path.join(root, 'Plugin', 'pqShapeMenu.cxx')).read()
assert all('"%s"' % task in menu for task in TASKS), 'the plugin arranges other tasks than %s' % sorted(TASKS)
resources = {file.get('alias') for file in ElementTree.parse(os.path.join(root, 'Plugin', 'Icons.qrc')).iter('file')}

ROWS = 6  # A panel with more rows has headings.

places, words = {}, {}
for path in sorted(glob.glob(os.path.join(root, 'Filters', 'VTK', '*', '*.xml'))):
    # Sources are in Sources > ShapeMap, which ParaView makes.
    for proxy in ElementTree.parse(path).iterfind("ProxyGroup[@name='filters']/SourceProxy"):
        entry = proxy.find('Hints/ShowInMenu')
        if entry is None or entry.get('category') != 'ShapeMap':
            continue
        name, hint = proxy.get('name'), proxy.find('Hints/ShapeMap')
        assert hint is not None, '%s has no hint ShapeMap, so that the menu lists it under More' % name
        icon = entry.get('icon', '')
        assert icon == ':/ShapeMap/%s.svg' % name[len('Shape'):] and os.path.basename(icon) in resources, \
            '%s has no icon: %s' % (name, icon)
        # A chart has no colours of a surface.
        assert proxy.find('Hints/FirstApply') is not None or any(
            view.get('type') == 'XYChartView' for view in proxy.findall('Hints/View')), '%s has no first view' % name
        assert hint.get('task') in TASKS, '%s has the task %s' % (name, hint.get('task'))
        assert hint.get('needs'), '%s does not say what it needs' % name
        place = hint.get('task'), int(hint.get('order'))
        assert place not in places, '%s and %s have the same place %s' % (name, places[place], place)
        places[place] = name
        found = [word.strip() for word in hint.get('keywords').lower().split(',')]
        assert len(found) >= 2 and all(found), '%s has less than two search words' % name
        for word in found:
            # The dialog of the quick search takes letters, digits and spaces only.
            assert word.replace(' ', '').isalnum(), '%s has a search word that cannot be typed: %s' % (name, word)
            assert word not in words, '%s and %s have the same search word %s' % (name, words[word], word)
            words[word] = name
assert len(places) >= 20, places

for name, proxy in proxies.proxies().items():
    # Readers and writers are in no menu.
    assert proxy.icon is None or os.path.basename(proxy.icon) in resources, '%s has no icon' % name
    loose = [row.name for row in proxy.properties if row.name not in proxy.grouped]
    assert len(proxy.properties) <= ROWS or not loose, '%s shows %s without a heading' % (name, ', '.join(loose))
print('%d filters, %d search words' % (len(places), len(words)))
