"""A surface that Shape Parameterize refuses: the window tells why, and goes on."""
import window

w = window.Window()
w.open('TwoTorusSmall.vtp')
w.filter('Shape Parameterize')
w.apply()
w.check('outputWidgetDock', 'visible', 'true')
w.click(window.MESSAGES + 'saveButton')
w.event('pqFileDialog', 'filesSelected', w.file('messages.txt'))
w.python('''
    messages = open(%r).read()
    assert 'Euler number -2' in messages, messages
    assert 'Shape Parameterize' in messages, messages''' % w.file('messages.txt'))
w.run()
