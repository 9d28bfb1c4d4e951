#!/usr/bin/env python3
"""Checks the names in the C++ of Filters/ and Plugin/ with clang-tidy: Utilities/lint.py [build folder]

Reads the compiler's commands, so that what is compiled together (CMAKE_UNITY_BUILD) is checked
together. A translation unit is checked again only if a file of ours that it includes or its flags have
changed: what passed is noted in $XDG_CACHE_HOME/shapemap (~/.cache) for all clones, as the compiler's
cache is."""
import concurrent.futures
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
BUILD = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, 'build'))
PASSED = os.path.join(os.environ.get('XDG_CACHE_HOME') or os.path.expanduser('~/.cache'),
                      'shapemap', 'checked-names.json')
REMEMBERED = 5000  # units, the latest ones
TIDY = 'clang-tidy-14'
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def our_files():
    """Our sources by their paths, and the paths of a header by its name."""
    sources, headers = {}, {}
    for part in ('Filters', 'Plugin'):
        for folder, _, names in os.walk(os.path.join(ROOT, part)):
            for name in names:
                if name.endswith(('.h', '.cxx')):
                    path = os.path.join(folder, name)
                    sources[path] = open(path).read()
                    headers.setdefault(name, []).append(path)
    return sources, headers


SOURCES, HEADERS = our_files()


def closure(path, seen):
    """All files of ours that a file includes. Several of one name count all."""
    text = SOURCES.get(path) or open(path).read()
    if path in SOURCES:
        seen.add(path)
    for include in INCLUDE.findall(text):
        for other in HEADERS.get(os.path.basename(include), []):
            if other not in seen:
                closure(other, seen)
    return seen


def readable(word):
    """A precompiled header under another name: clang would take the compiler's binary beside it."""
    if not word.endswith('/cmake_pch.hxx'):
        return word
    name = hashlib.sha256(word.encode()).hexdigest()[:16] + '.hxx'
    link = os.path.join(BUILD, 'lint', name)
    os.makedirs(os.path.dirname(link), exist_ok=True)
    if not os.path.lexists(link):
        os.symlink(word, link)
    return link


def units():
    """(file, its command, the folder it runs in, key) of each translation unit of ours."""
    config = open(os.path.join(ROOT, '.clang-tidy')).read()
    for entry in json.load(open(os.path.join(BUILD, 'compile_commands.json'))):
        path = entry['file']
        if not path.endswith('.cxx'):
            continue
        ours = closure(path, set())
        own = any(p in SOURCES for p in [path] + [
            p for p in INCLUDE.findall(open(path).read()) if p.endswith('.cxx')])
        if not own:
            continue
        words = shlex.split(entry['command'])
        words = words[next(i for i, word in enumerate(words) if re.search(r'\+\+(-\d+)?$', word)):]
        facts = json.dumps([config, words] + [[p, SOURCES[p]] for p in sorted(ours)])
        key = hashlib.sha256(  # the same in every clone
            facts.replace(BUILD, 'BUILD').replace(ROOT, 'ROOT').encode()).hexdigest()
        kept = [readable(word) for word in words[1:] if word not in ('-Winvalid-pch', path)]
        yield path, kept, entry['directory'], key


def check(unit):
    path, words, folder, key = unit
    command = [TIDY, '--quiet', '--config-file', os.path.join(ROOT, '.clang-tidy'),
               '--header-filter', '^%s/(Filters|Plugin)/' % re.escape(ROOT), path, '--']
    result = subprocess.run(command + words, cwd=folder, capture_output=True, text=True)
    return key, path, result.returncode, result.stdout + (
        result.stderr if result.returncode else '')


def main():
    passed = dict.fromkeys(json.load(open(PASSED)) if os.path.exists(PASSED) else [])
    todo = list(units())
    assert todo, 'no command compiles a file of Filters/ or Plugin/: configure ' + BUILD
    fresh = [unit for unit in todo if unit[3] not in passed]
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for key, path, status, text in pool.map(check, fresh):
            if status:
                failed += 1
                print(path)
                print(text)
            else:
                passed[key] = None
    os.makedirs(os.path.dirname(PASSED), exist_ok=True)
    with open(PASSED, 'w') as file:
        json.dump(list(passed)[-REMEMBERED:], file)
    print('%d of %d translation units checked, %d with faults' % (len(fresh), len(todo), failed))
    sys.exit(1 if failed else 0)


main()
