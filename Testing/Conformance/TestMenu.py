"""Each filter of the menu says in its XML where it is in Filters > ShapeMap and what it needs, has an icon, and
has search words of its own: TestMenu.py SOURCE_FOLDER. Runs without ParaView."""
import glob
import os
import sys
from xml.etree import ElementTree

root = sys.argv[1]
TASKS = {'Prepare', 'Map surfaces', 'Map solids', 'Hexahedra', 'Deform and compose', 'Measure'}
menu = open(os.path.join(root, 'Plugin', 'pqShapeMenu.cxx')).read()
assert all('"%s"' % task in menu for task in TASKS), 'the plugin arranges other tasks than %s' % sorted(TASKS)
resources = {file.get('alias') for file in ElementTree.parse(os.path.join(root, 'Plugin', 'Icons.qrc')).iter('file')}

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
print('%d filters, %d search words' % (len(places), len(words)))
