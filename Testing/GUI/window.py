"""Drives the real ParaView window as a user does: menus, buttons, dialogs, and questions put to its
Python shell. Steps are collected, then run() plays them in a fresh window that knows no settings of
any user unless it is given a home, and raises if a widget is missing, a check differs, a step raises or the window hangs.

Widgets are named by their path of Qt object names; a missing one is reported with those that exist."""
import os
import shutil
import signal
import subprocess
import tempfile
import textwrap
from xml.etree import ElementTree

from paraview.servermanager import vtkSMProxyManager

import shapetesting

MAIN = 'pqClientMainWindow/'
PANEL = 'propertiesDock/propertiesPanel/'
PROPERTIES = PANEL + ('scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/'
                      'PropertiesFrame/ProxyPanel/')
INPUTS = PROPERTIES + 'ShapeInputs/'
MESSAGES = 'outputWidgetDock/outputWidget/'
BROWSER = 'pipelineBrowserDock/pipelineBrowser'
VIEW = ('centralwidget/MultiViewWidget/CoreWidget/qt_tabwidget_stackedwidget/MultiViewWidget1/Container/Frame.0/'
        'CentralWidgetFrame/Viewport')
SHIFT, CONTROL = 0x02000000, 0x04000000  # Qt's numbers, as those of the keys
ESCAPE, ENTER, BACKSPACE, DELETE = 0x01000000, 0x01000004, 0x01000003, 0x01000007
# What a user clicks or presses for a command: a file is clicked and accepted, a list unfolded and its entry clicked.
CLICKS = {'activate': 1, 'set_boolean': 1, 'set_string': 2, 'editAccepted': 2, 'currentChanged': 1,
          'filesSelected': 2, 'mousePress': 1, 'mouseDblClick': 1}


class Window:
    def __init__(self, port=None, options=(), finds_plugin=True, home=None):
        """port: of the server to connect to; None is the built-in one. options: more of them for the
        command. finds_plugin: whether PV_PLUGIN_PATH names the plugin's folder, and PYTHONPATH that of shapemap. home: the user's folder,
        whose settings are read and written; None is an empty one, and settings are not used."""
        self.folder = tempfile.mkdtemp(prefix='shapemap-window-')
        self.command = ['paraview', *options]
        if port is not None:
            self.command.append('--server-url=cs://localhost:%d' % port)
        if home is None:
            self.command.append('--dr')
            home = self.folder
        else:
            # The welcome dialog would have to be closed before the window can be.
            version = [getattr(vtkSMProxyManager, 'GetVersion' + part)() for part in ('Major', 'Minor', 'Patch')]
            settings = os.path.join(home, 'ParaView', 'ParaView%d.%d.%d.ini' % tuple(version))
            if not os.path.exists(settings):
                os.makedirs(os.path.dirname(settings), exist_ok=True)
                with open(settings, 'w') as file:
                    file.write('[General]\nGeneralSettings.ShowWelcomeDialog=false\n')
        self.finds_plugin = finds_plugin
        self.home = home
        self.events = ElementTree.Element('pqevents')
        self.steps = 0
        self.clicks = 0  # and keys, of the user so far

    def file(self, name):
        """A path in the window's own folder, which run() empties at its end."""
        return os.path.join(self.folder, name)

    def accept(self, dialog):
        """Clicks OK of a dialog of the application, which is not a child of the main window."""
        self.clicks += 1
        ElementTree.SubElement(self.events, 'pqevent', object=dialog + '/widget/OKButton', command='activate',
                               arguments='')

    def event(self, widget, command, argument=''):
        submenus = widget.count('/') - 1 if widget.startswith('menubar/') else 0
        self.clicks += CLICKS.get(command, 0) + submenus
        ElementTree.SubElement(self.events, 'pqevent', object=MAIN + widget, command=command,
                               arguments=argument)

    def check(self, widget, attribute, value):
        """The widget has this value of this Qt property."""
        ElementTree.SubElement(self.events, 'pqcheck', object=MAIN + widget, property=attribute,
                               arguments=value)

    def click(self, widget):
        self.event(widget, 'activate')

    def choose(self, widget, word):
        """Picks an entry of a combo box and makes sure that it is there."""
        self.event(widget, 'set_string', word)
        self.check(widget, 'currentText', word)

    def open(self, name):
        """Opens a file of Data/ through the dialog of File > Open, and applies."""
        self.open_path(shapetesting.data_file(name))

    def open_path(self, path):
        self.click('MainControlsToolbar/actionOpenData')
        self.event('FileOpenDialog', 'filesSelected', path)
        self.apply()

    def menu(self, name, action):
        """An entry of a menu of the menu bar, by their object names."""
        self.event('menubar', 'activate', name)
        self.event('menubar/' + name, 'activate', action)

    def filter(self, label):
        """Filters > ShapeMap > label."""
        self.event('menubar', 'activate', 'menuFilters')
        self.event('menubar/menuFilters/ShapeMap', 'activate', label)

    def open_with(self, name, label):
        """Opens a file and applies a filter to it, whose handle is shown then."""
        self.open(name)
        self.filter(label)
        self.wait(100)
        self.apply()
        self.wait(100)

    def apply(self):
        self.click(PANEL + 'Accept')

    def select(self, item):
        """Makes an item of the pipeline browser the active one: '/0/1|0' is the second
        child of the first row, in column 0."""
        self.event(BROWSER, 'currentChanged', item)

    def eye(self, item):
        """Clicks the eye of an item of the pipeline browser, '/0/1', which shows or hides it."""
        path = item.replace('/', ':0/')[2:] + ':1'
        self.event(BROWSER, 'mousePress', '1,1,0,9,8,' + path)
        self.event(BROWSER, 'mouseRelease', '1,0,0,9,8,' + path)
        self.wait(100)

    def choose_inputs(self, **names):
        """Chooses inputs of the filter in its panel, by the names of their outputs in the pipeline."""
        for property, name in names.items():
            self.choose(INPUTS + property + '/List0', name)

    def wait(self, milliseconds):
        """The window goes on with what it has begun."""
        self.event('menubar', 'process_events', str(milliseconds))

    def undo(self):
        self.event('menubar/menu_Edit', 'activate', 'actionEditUndo')
        self.wait(100)

    def redo(self):
        self.event('menubar/menu_Edit', 'activate', 'actionEditRedo')
        self.wait(100)

    def mouse(self, command, place, button=0, buttons=0, modifiers=0):
        """Move, Press, Release or DblClick at a place in the view, in parts of its width and of its
        height from the top."""
        self.event(VIEW, 'mouse' + command, '(%r,%r,%d,%d,%d)' % (*place, button, buttons, modifiers))

    def press(self, place, modifiers=0):
        self.mouse('Move', place, 0, 0, modifiers)
        self.mouse('Press', place, 1, 1, modifiers)

    def drag(self, places, modifiers=0):
        """The left button is pressed at the first place, moved over the others and released."""
        self.press(places[0], modifiers)
        for place in places[1:]:
            self.mouse('Move', place, 0, 1, modifiers)
        self.mouse('Release', places[-1], 1, 0, modifiers)
        self.wait(100)

    def key(self, code, text=''):
        """A key is pressed and released while the mouse is in the view."""
        self.clicks += 1
        for command in (6, 7):
            self.event(VIEW + '/1QVTKOpenGLNativeWidget0', 'keyEvent', '%d:%d:0:%s:0:1' % (command, code, text))

    def python(self, source):
        """Runs Python in the window's shell, which knows the names of the steps before; what it
        raises, run() raises. It empties the undo stack, as ParaView's shell does."""
        self.steps += 1
        with open(self.file('step%d.py' % self.steps), 'w') as script:
            script.write('from paraview.simple import *\n' + textwrap.dedent(source))
        self.event('pythonShellDock/pythonShell/consoleWidget', 'executeCommand', textwrap.dedent('''
            names = globals().setdefault('shapemap_names', {})

            def shapemap_step(path):
                import traceback
                result = 'done'
                try:
                    exec(compile(open(path + '.py').read(), path, 'exec'), names)
                except BaseException:
                    result = traceback.format_exc()
                with open(path + '.txt', 'w') as file:
                    file.write(result)

            shapemap_step(%r)''' % self.file('step%d' % self.steps)))

    def fill_screen(self):
        """The window covers the screen, so that the screen's pixels are its own."""
        self.python('''
            import subprocess
            subprocess.check_call(['xdotool', 'search', '--onlyvisible', '--name', 'ParaView',
                                   'windowmove', '0', '0', 'windowsize', '1600', '1000'])''')
        self.wait(1000)

    def screenshot(self, path):
        """Writes a PNG file of the screen: the window, with its menus and dialogs."""
        self.wait(1000)
        self.python('''
            import subprocess
            subprocess.check_call(['import', '-window', 'root', %r])''' % path)

    def picture(self, baseline):
        """The active view looks like Testing/Baselines/`baseline`."""
        picture = os.path.join(shapetesting.BUILD, 'Testing', 'Temporary', baseline)
        os.makedirs(os.path.dirname(picture), exist_ok=True)
        self.python('''
            import shapetesting
            SaveScreenshot(%r, GetActiveView(), ImageResolution=[400, 300])
            shapetesting.compare_picture(%r, %r)''' % (picture, picture, baseline))

    def run(self, seconds=120):
        """Plays the steps and returns what the window printed."""
        script = self.file('events.xml')
        ElementTree.ElementTree(self.events).write(script)
        modules = os.environ.get('PYTHONPATH', '').split(os.pathsep)
        if not self.finds_plugin: # nor the package shapemap, which lies beside the plugin
            modules = [folder for folder in modules if not os.path.exists(os.path.join(folder, 'shapemap'))]
        environment = dict(
            os.environ, PYTHONPATH=os.pathsep.join([os.path.dirname(__file__), *modules]),
            HOME=self.home, XDG_CONFIG_HOME=self.home, XDG_RUNTIME_DIR=self.folder)
        if not self.finds_plugin:
            environment.pop('PV_PLUGIN_PATH')
        with open(self.file('output.txt'), 'w+') as output:
            window = subprocess.Popen(
                [*self.command, '--test-script=' + script, '--exit'], env=environment,
                stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT,
                start_new_session=True)
            try:
                status = 'ended with %d' % window.wait(seconds)
            except subprocess.TimeoutExpired:
                os.killpg(window.pid, signal.SIGKILL)
                window.wait()
                status = 'hung'
            output.seek(0)
            printed = output.read()
        results = []
        for step in range(1, self.steps + 1):
            path = self.file('step%d.txt' % step)
            results.append(open(path).read() if os.path.exists(path) else 'step %d did not run' % step)
        shutil.rmtree(self.folder)
        for result in results:
            assert result == 'done', '%s\nThe window %s and printed:\n%s' % (result, status, printed)
        assert status == 'ended with 0', 'the window %s and printed:\n%s' % (status, printed)
        return printed
