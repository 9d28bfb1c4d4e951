"""The plugin is loaded in each way that ParaView offers, and then its menu and a filter work: into a window
that is open, by Tools > Manage Plugins > Load New or by LoadPlugin in its Python shell, before or after data
are opened; at the next start, by Auto Load; by --plugins; on a client whose server has it. The window then
finds the Python package shapemap, too, and prints no error and no warning.

TestLoadPlugin.py WAY: the name of a function below."""
import os
import sys
import tempfile

import shapetesting
import window

FOLDER = os.environ['PV_PLUGIN_PATH'].split(os.pathsep)[0]
PLUGIN = os.path.join(FOLDER, 'ShapeMap.so')


def load_new(w):
    """Tools > Manage Plugins > Load New."""
    w.event('menubar', 'activate', 'menuTools')
    w.event('menubar/menuTools', 'activate', 'actionManage_Plugins')
    w.click('PluginManagerDialog/splitter/localGroup/loadLocal')
    w.event('PluginManagerDialog/pqFileDialog', 'filesSelected', PLUGIN)


def use(w, opened=False):
    """The menu is arranged, a filter is applied with the button on its panel, a layout is shown and the
    package is imported."""
    if not opened:
        w.open('DentedSphere600.vtp')
    w.filter('Shape Cut Feature')
    w.check(window.PROPERTIES + 'ShapeLoop/DrawLoop', 'checked', 'false')
    w.click(window.PANEL + 'Delete')
    w.filter('Shape Parameterize')
    w.apply()
    w.python('''
        made = GetActiveSource()
        assert made.GetXMLName() == 'ShapeParameterize', made.GetXMLName()
        assert made.PointData.GetArray('TargetPosition').GetNumberOfComponents() == 3''')
    w.event('menubar', 'activate', 'menu_View')
    w.event('menubar/menu_View/ShapeMapViews', 'activate', 'map_quality')
    w.python('''
        assert sorted(view.GetXMLName() for view in GetViewsInLayout()) == 2 * ['RenderView'], GetViewsInLayout()
        import shapemap
        assert shapemap.vtkShapeMorph().GetClassName() == 'vtkShapeMorph\'''')
    printed = w.run()
    assert not any(word in printed.lower() for word in ('error', 'warning', 'critical')), printed


def without_path(**options):
    """A window that finds neither the plugin nor the package by itself."""
    return window.Window(finds_plugin=False, **options)


def manage_plugins():
    home = tempfile.TemporaryDirectory(prefix='shapemap-home-')
    w = without_path(home=home.name)
    load_new(w)
    # The plugin is the second in the list, and Auto Load, in column 1, is the sixth of its rows.
    w.event('PluginManagerDialog/splitter/localGroup/localPlugins', 'setTreeItemCheckState', '1.5,1,2')
    w.click('PluginManagerDialog/buttonBox/1QPushButton0')
    use(w)
    use(without_path(home=home.name))
    home.cleanup()


def manage_plugins_with_data():
    w = without_path()
    w.open('DentedSphere600.vtp')
    w.python('assert len(GetSources()) == 1') # the shell's functions are those before the plugin
    load_new(w)
    w.click('PluginManagerDialog/buttonBox/1QPushButton0')
    use(w, opened=True)


def shell():
    """The window makes its menus and lists of readers anew once, not for each of the filters."""
    w = without_path()
    w.python('''
        from paraview import servermanager
        definitions = servermanager.ActiveConnection.Session.GetProxyDefinitionManager()
        updates = []
        observer = definitions.AddObserver(definitions.ProxyDefinitionsUpdated, lambda *arguments: updates.append(1))
        LoadPlugin(%r, remote=False, ns=globals())
        definitions.RemoveObserver(observer)
        assert len(updates) == 1, len(updates)''' % PLUGIN)
    use(w)


def shell_with_data():
    w = without_path()
    w.open('DentedSphere600.vtp')
    w.python('LoadPlugin(%r, remote=False, ns=globals())' % PLUGIN)
    use(w, opened=True)


def option():
    use(without_path(options=['--plugin-search-paths=' + FOLDER, '--plugins=ShapeMap']))


def path():
    use(window.Window())


def server():
    """PV_PLUGIN_PATH on both sides."""
    with shapetesting.server(['pvserver']) as port:
        use(window.Window(port=port))


globals()[sys.argv[1]]()
