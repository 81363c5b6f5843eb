"""Judges a job of .ci/run by its exit code, time, memory and reports (JUnit, by xunit): a line of counts, words, and a line for each failure."""
import glob, os, re, subprocess, sys, xml.etree.ElementTree as xml

folder, job, (minutes, megabytes, reports, code) = sys.argv[1], sys.argv[2], (float(value) for value in sys.argv[3:])
passed, skipped, failed, words, suites = 0, [], [], [], 0


def allowed(what):
    """Whether tests/allowed-skips.txt lets something be skipped: a condition for bash, two blanks or more, a pattern."""
    for line in open('tests/allowed-skips.txt'):
        condition, _, pattern = re.sub('  +', '\t', line.strip()).partition('\t')
        found = not line.startswith('#') and pattern and re.search(pattern, what)
        if found and (condition == 'always' or os.environ.get('REQUIRE') != 'all' and subprocess.run(
                ['bash', '-c', condition, '-', *found.groups()], stdin=subprocess.DEVNULL, capture_output=True).returncode == 0):
            return True


for file in sorted(glob.glob(folder + '/reports/*.xml')):
    for suite in xml.parse(file).iter('testsuite'):
        suites += 1
        cases = suite.findall('testcase') + suite.findall('system-err') * (suite.get('errors', '0') != '0') # these outside of tests
        if not cases: failed.append(f'no test has run: {suite.get("name")}')
        for case in cases:
            name = case.get('name', 'outside of a test')
            said = {part.tag: f'{part.get("message", "")}\n{part.text or ""}' for part in [case, *case]}
            if 'skipped' in said: skipped.append(f'{name}: {said["skipped"].strip()}')
            elif {'failure', 'error', 'system-err'} & {*said}:
                failed.append(' '.join(name.split()))
                words += [name, *'\n'.join(said.values()).split('\n')[:30]]
            else: passed += 1

output = open(folder + '/output', errors='replace').read().rstrip().split('\n')
if code in (124, 137): failed.append(f'it was not done after {minutes:g} minutes, or was killed')
elif code == 77 and suites == 0: skipped.append(f'all: {output[-1]}')
elif code and not (code == 2 and failed): failed.append(f'its exit code is {code:g}')
elif code == 0 and suites != reports: failed.append(f'{suites} test programs left a report, not {reports:g}')
elif code == 0 and reports == 0: passed += 1
seconds, user, system, kilobytes = map(float, open(folder + '/time').read().split()[-4:])
if kilobytes / 1024 > megabytes: failed.append(f'one of its processes took {kilobytes / 1024:.0f} MB; at most {megabytes:g} MB are allowed')
failed += [f'skipped without leave: {what}' for what in skipped if not allowed(f'{job}: {what}')]
print(f'-- {job}: {passed} passed, {len(failed)} failed, {len(skipped)} skipped;',
      f'{seconds:.0f} s, {user + system:.0f} s of a core, {kilobytes / 1024:.0f} MB')
for word in words + (output[-60:] if failed else []): print('   ' + word)
for what in failed: print(f'failed: {job}: {what}')
