"""The plugin is loaded in each way that ParaView offers, and then a filter works: into a window that
is open, by Tools > Manage Plugins > Load New; at the next start, by Auto Load; by --plugins."""
import os
import tempfile

import window

FOLDER = os.environ['PV_PLUGIN_PATH'].split(os.pathsep)[0]


def use(w):
    """A filter of the plugin is applied."""
    w.open('DentedSphere600.vtp')
    w.filter('Shape Parameterize')
    w.apply()
    w.python('''
        made = GetActiveSource()
        assert made.GetXMLName() == 'ShapeParameterize', made.GetXMLName()
        assert made.PointData.GetArray('TargetPosition').GetNumberOfComponents() == 3''')
    w.run()


home = tempfile.TemporaryDirectory(prefix='shapemap-home-')
w = window.Window(finds_plugin=False, home=home.name)
w.event('menubar', 'activate', 'menuTools')
w.event('menubar/menuTools', 'activate', 'actionManage_Plugins')
w.click('PluginManagerDialog/splitter/localGroup/loadLocal')
w.event('PluginManagerDialog/pqFileDialog', 'filesSelected', os.path.join(FOLDER, 'ShapeMap.so'))
# The plugin is the second in the list, and Auto Load, in column 1, is the sixth of its rows.
w.event('PluginManagerDialog/splitter/localGroup/localPlugins', 'setTreeItemCheckState', '1.5,1,2')
w.click('PluginManagerDialog/buttonBox/1QPushButton0')
use(w)
use(window.Window(finds_plugin=False, home=home.name))
home.cleanup()
use(window.Window(finds_plugin=False, options=['--plugin-search-paths=' + FOLDER, '--plugins=ShapeMap']))
