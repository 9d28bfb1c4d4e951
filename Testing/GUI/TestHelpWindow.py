"""The '?' of the panel opens the filter's own page in the help window."""
import window

BROWSER = 'pqHelpWindow/1QTextBrowser0'

shown = window.Window()
shown.open('DentedSphere600.vtp')
for label in ('Shape Hex Remesh', 'Shape Parameterize', 'Shape Morph'):
    shown.filter(label)
    shown.wait(300)
    shown.click(window.PANEL + 'Help')
    shown.wait(500)
    shown.check(BROWSER, 'documentTitle', label)
    shown.click(window.PANEL + 'Delete')
shown.run()
print("the panel's help opens three pages")
