using System.IO.Compression;

namespace RayCaster.Teaching.Tests.Marks;

/// <summary>Files of test results as runners write them: the folder Reports has what each wrote for tests of steps 3 and 8, shortened.</summary>
public class TestReportTests
{
    private static readonly string folder = ProjectFolder.PathOf("tests/RayCaster.Teaching.Tests/Marks/Reports");

    private const string Two = "<testsuites><testsuite name='lab'><testcase classname='Step03Plane' name='hit'/>" +
        "<testcase classname='Step08Sphere' name='near'><failure message='expected 1'/></testcase></testsuite></testsuites>";

    private static string Counts(byte[] report) => Counts(TestReport.Parse(report));

    private static string Counts(IReadOnlyList<ReportedTest> tests) =>
        string.Join("; ", TestResults.ByStep(tests).Values.OrderBy(step => step.Step).Select(step => $"{step.Step}: {step.Passed} of {step.Count}"));

    private static List<ReportedTest> Joined(IEnumerable<ReportedTest> tests) => TestResults.Joined([.. tests.Select(test => ("a.xml", test))], []);

    private static string Notes(IReadOnlyList<ReportedTest> tests) => string.Join("; ", TestResults.NotesOn(tests, [3, 8]));

    private static IReadOnlyList<ReportedTest> Tests(string cases) => TestReport.Parse(Encoding.UTF8.GetBytes($"<testsuite>{cases}</testsuite>"));

    [Fact]
    public void ThePageOfLimitsHasTheMostBytesOfAFile() => Assert.Contains(
        FormattableString.Invariant($"| file of test results | {TestReport.MaxBytes:N0} bytes |"),
        File.ReadAllText(ProjectFolder.PathOf("docs/limits.md")));

    [Theory]
    [InlineData("pytest.xml", "3: 1 of 1; 8: 3 of 7", "2 of 9 tests of step 8 did not run (skipped)")]
    [InlineData("pytest-rerunfailures.xml", "3: 1 of 1; 8: 1 of 3", "flaky tests of step 8, whose last attempt counts: test_near")]
    [InlineData("surefire.xml", "3: 1 of 1; 8: 2 of 3", "1 of 4 tests of step 8 did not run (skipped); " +
        "flaky tests of step 8, whose last attempt counts: nearSide, behind")]
    [InlineData("googletest.xml", "3: 1 of 1; 8: 1 of 2", "2 of 4 tests of step 8 did not run (suppressed, skipped)")]
    [InlineData("xunit-v3.xml", "3: 0 of 1; 8: 3 of 6",
        "the test results count tests that did not run, but do not list them; 2 of 8 tests of step 8 did not run (skipped)")]
    [InlineData("jest.xml", "3: 1 of 1; 8: 2 of 3", "2 of 5 tests of step 8 did not run (skipped, todo)")]
    [InlineData("nextest.xml", "3: 1 of 1; 8: 1 of 2",
        "1 of 3 tests of step 8 did not run (skipped); flaky tests of step 8, whose last attempt counts: near")]
    [InlineData("xcode.xml", "3: 1 of 1; 8: 1 of 2", "flaky tests of step 8, whose last attempt counts: near side")]
    [InlineData("ctest.xml", "3: 1 of 1; 8: 1 of 3", "3 of 6 tests of step 8 did not run (disabled, skipped)")]
    [InlineData("node.xml", "3: 1 of 1; 8: 1 of 3", "2 of 5 tests of step 8 did not run (skipped)")]
    [InlineData("dotnet.trx", "3: 0 of 1; 8: 3 of 6", "3 of 9 tests of step 8 did not run (NotRunnable, NotExecuted)")]
    public void EachDialectIsReadAsItsRunnerMeansIt(string file, string counts, string notes)
    {
        var tests = TestReport.Read(Path.Combine(folder, file));
        Assert.Equal((counts, notes), (Counts(tests), Notes(tests)));
    }

    [Theory]
    [InlineData("<testcase name='step8' status='notrun'/>", "notrun")]
    [InlineData("<testcase name='step8' status='run' result='suppressed'/>", "suppressed")]
    [InlineData("<testcase name='step8' result='skipped'/>", "skipped")]
    [InlineData("<testcase name='step8' status='disabled'/>", "disabled")]
    [InlineData("<testcase name='step8' status='Inconclusive'/>", "Inconclusive")] // nunit3-junit.xslt
    [InlineData("<testcase name='step8' status='untested'/>", "untested")] // behave
    [InlineData("<testcase name='step8' status='NOT RUN'/>", "NOT RUN")]
    [InlineData("<testcase name='step8' status='?'/>", "?")]
    [InlineData("<testcase name='step8'><disabled/></testcase>", "disabled")]
    [InlineData("<testcase name='step8'><ignored/></testcase>", "ignored")]
    [InlineData("<testcase name='step8'><not-run/></testcase>", "not-run")]
    [InlineData("<testcase name='step8'><skipped type='todo' message='true'/></testcase>", "skipped")] // node
    [InlineData("<t:testcase xmlns:t='x' name='step8'><t:skipped/></t:testcase>", "skipped")]
    public void ATestThatDidNotRunIsNoResult(string test, string word)
    {
        Assert.Equal("", Counts(Tests(test)));
        Assert.Equal($"the test results have no test of step 3; 1 of 1 tests of step 8 did not run ({word})", Notes(Tests(test)));
    }

    [Theory]
    [InlineData("<testcase name='step8' status='fail'/>", 0)]
    [InlineData("<testcase name='step8' status='Failed'/>", 0)]
    [InlineData("<testcase name='step8' status='run' result='error'/>", 0)]
    [InlineData("<testcase name='step8' status='run'><error/></testcase>", 0)]
    [InlineData("<testcase name='step8'><skipped/><error message='failed on teardown'/></testcase>", 0)] // pytest
    [InlineData("<testcase name='step8' status='passed'><failure/></testcase>", 0)]
    [InlineData("<testcase name='step8' status='run' result='completed'/>", 1)]
    [InlineData("<testcase name='step8' status='Passed'/>", 1)]
    [InlineData("<testcase name='step8'><system-out>error</system-out><properties/></testcase>", 1)]
    [InlineData("<testcase name='step8'><flakyError/></testcase>", 1)]
    public void ATestThatRanPassesUnlessSomethingSaysThatItFailed(string test, int passed) =>
        Assert.Equal($"8: {passed} of 1", Counts(Tests(test)));

    [Theory]
    [InlineData("fail pass", "8: 1 of 1")]
    [InlineData("pass fail", "8: 0 of 1")]
    [InlineData("fail fail pass", "8: 1 of 1")]
    [InlineData("pass notrun fail notrun", "8: 0 of 1")]
    public void OfAttemptsTheLastThatRanCountsAndFlakyIsTold(string attempts, string counts)
    {
        var tests = Tests(string.Concat(attempts.Split(' ').Select((end, i) => $"<testcase classname='step8' name='near' status='{end}'>" +
            $"<properties><property name='repetition' value='Repetition {i + 1}'/></properties></testcase>")));
        Assert.Equal(counts, Counts(tests));
        Assert.Contains("flaky tests of step 8, whose last attempt counts: near", Notes(tests));
    }

    [Theory]
    [InlineData("<testcase name='step8' status='pass'>{2}</testcase><testcase name='step8' status='fail'>{1}</testcase>", "8: 1 of 1")]
    [InlineData("<testcase name='step8' status='fail'/><testcase name='step8' status='pass'>{2}</testcase>", "8: 1 of 1")]
    [InlineData("<testcase name='step8' status='fail'>{2}</testcase><testcase name='step8' status='pass'>{2}</testcase>", "8: 1 of 2")]
    public void AttemptsAreThoseThatAPropertyNumbersInTheirOrder(string tests, string counts) => Assert.Equal(counts,
        Counts(Tests(string.Format(tests, "", Attempt(1), Attempt(2)))));

    private static string Attempt(int number) => $"<properties><property name='attempt' value='{number}'/></properties>";

    [Theory]
    [InlineData("pass fail pass", "1 of 3 tests called near fails, in step 8")]
    [InlineData("fail pass", "1 of 2 tests called near fails, in step 8")]
    public void WhereTestsOfOneNameEndDifferentlyTheStepIsOpen(string ends, string note)
    {
        var tests = Joined(Tests(string.Concat(ends.Split(' ').Select(end => $"<testcase classname='step8' name='near' status='{end}'/>"))));
        Assert.True(TestResults.ByStep(tests)[8].IsOpen);
        Assert.Contains(note, Notes(tests));
        tests = Joined([.. tests, .. Tests("<testcase classname='step8' name='far' status='fail'/>")]);
        Assert.False(TestResults.ByStep(tests)[8].IsOpen, "another test fails");
    }

    [Theory]
    [InlineData("8:00", "pass", "9:00", "fail", "8: 0 of 1", "")]
    [InlineData("9:00", "pass", "8:00", "fail", "8: 1 of 1", "")]
    [InlineData("", "fail", "8:00", "fail", "8: 0 of 1", "")]
    [InlineData("", "pass", "8:00", "fail", "8: 1 of 2",
        "a.xml and b.xml disagree about a test of step 8, near, and no time says which run is the last")]
    public void ATestOfTwoFilesCountsOnceByTheLaterRun(string begun, string end, string otherBegun, string otherEnd, string counts, string told)
    {
        var notes = new List<string>();
        var tests = TestResults.Joined([("a.xml", Run(begun, end)), ("b.xml", Run(otherBegun, otherEnd))], notes);
        Assert.Equal((counts, told), (Counts(tests), string.Concat(notes)));
        Assert.Equal(told != "", TestResults.ByStep(tests)[8].IsOpen);

        static ReportedTest Run(string time, string end) => Assert.Single(Tests(
            $"<testsuite{(time == "" ? "" : $" timestamp='2026-11-20T0{time}:00'")}>" +
            $"<testcase classname='step8' name='near' status='{end}'/></testsuite>"));
    }

    [Fact]
    public void AResultThatSumsUpDataRowsIsNoTest() => Assert.Equal("8: 1 of 2", Counts(Tests(
        "<UnitTestResult testName='Step8 At' outcome='Failed'><InnerResults><UnitTestResult testName='Step8 At (1)' outcome='Passed'/>" +
        "<UnitTestResult testName='Step8 At (2)' outcome='Failed'/></InnerResults></UnitTestResult>")));

    [Fact]
    public void AResultWhoseDataRowsAreNotListedIsATest() => Assert.Equal("8: 0 of 1",
        Counts(Tests("<UnitTestResult testName='Step8 At' outcome='Failed'><InnerResults/></UnitTestResult>")));

    [Theory]
    [InlineData("2026-11-20T10:00:00", "8: 1 of 1")]
    [InlineData("20.11.2026 10:00", "8: 1 of 2")] // no time: others write the month first
    public void ATestOfJUnitAndOfTrxIsOne(string begun, string counts) => Assert.Equal(counts, Counts(TestResults.Joined(
    [
        ("a.xml", Tests($"<testsuite timestamp='{begun}'>" +
            "<testcase classname='Lab.Step8' name='Lab.Step8.Near'><failure/></testcase></testsuite>")[0]),
        ("b.trx", Tests("<UnitTestResult testName='Lab.Step8.Near' outcome='Passed' startTime='2026-11-20T11:00:00' testId='1'/>" +
            "<UnitTest id='1'><TestMethod className='Lab.Step8'/></UnitTest>")[0]),
    ], [])));

    [Theory]
    [InlineData("<testsuite name='debug'>{0}</testsuite><testsuite name='release'>{1}</testsuite>")]
    [InlineData("<testsuite name='pytest'>{0}</testsuite><testsuite name='pytest'>{1}</testsuite>")]
    [InlineData("<testsuite name='all'>{0}<testsuite name='inner'>{1}</testsuite></testsuite>")]
    public void TwoSuitesThatHoldTheSameTestsStayTwo(string suites)
    {
        var tests = Tests(string.Format(suites, "<testcase name='step8'><failure/></testcase>", "<testcase name='step8'/>"));
        Assert.Equal("8: 1 of 2", Counts(tests));
        Assert.DoesNotContain("flaky", Notes(tests));
    }

    [Theory]
    [InlineData("<testcase name='step8 At(\"aaa\"···)'><failure/></testcase><testcase name='step8 At(\"aaa\"···)'/>")] // xunit's cut names
    [InlineData("<testcase name='step8' line='4'><failure/></testcase><testcase name='step8' line='9'/>")]
    public void TestsOfOneNameThatAreNotAttemptsStayTwo(string tests) => Assert.Equal("8: 1 of 2", Counts(Tests(tests)));

    [Theory]
    [InlineData("<testsuite name='step 8'><testsuite name='near'><testcase name='a' classname='test'/></testsuite></testsuite>", 8)] // node
    [InlineData("<testcase name='a'><properties><property name='step' value='8'/></properties></testcase>", 8)]
    [InlineData("<testcase name='a' classname='Step03'><properties><property name='step' value='8'/></properties></testcase>", 3)]
    [InlineData("<testsuite name='/home/ann/lab-step8/tests'><testcase name='a'/></testsuite>", 0)]
    public void AStepIsAlsoNamedByAPropertyOrASuite(string test, int step) => Assert.Equal(step, Assert.Single(Tests(test)).Step);

    [Fact] // tests of step 3 may be missing
    public void OfARunThatWasStoppedOnlyFailuresCount() => Assert.Equal("8: 0 of 1", Counts(Tests(
        "<testcase classname='Step03' name='a'/><testcase classname='Step08' name='b'>" +
        "<error message='The run was stopped in this test.'/></testcase>")));

    [Fact] // xunit's names begin with the class
    public void TestsOfWholePicturesDoNotCountWhateverWritesTheirNames() => Assert.Equal("8: 1 of 1",
        Counts(Tests("<testcase classname='Lab.Step08' name='Lab.Step08.ThePictures'><failure/></testcase>" +
            "<testcase classname='Lab.Step08' name='a'/>")));

    [Theory]
    [InlineData("\n")]
    [InlineData("  \r\n\r\n")]
    [InlineData("Restored lab.csproj & 2 < 3 others (in 2 s).\n> test -> results\n")]
    [InlineData("\u001b[32mok\u001b[0m\n")]
    public void WhatALogHasWrittenAroundItIsLeftOut(string log)
    {
        const string declaration = "<?xml version='1.0' encoding='UTF-8'?>\n";
        Assert.All([log + declaration + Two, log + Two, declaration + Two + log.Replace(">", ""), declaration + "<!-- a test -->" + Two],
            text => Assert.Equal("3: 1 of 1; 8: 0 of 1", Counts(Encoding.UTF8.GetBytes(text))));
    }

    [Fact] // cat debug.xml release.xml
    public void TwoReportsBehindEachOtherAreRead() =>
        Assert.Equal("3: 2 of 2; 8: 0 of 2", Counts(Encoding.UTF8.GetBytes($"<?xml version='1.0'?>\n{Two}\n<?xml version='1.0'?>\n{Two}\n")));

    public static TheoryData<string, string> Encodings => new MatrixTheoryData<string, string>(
        ["", "utf-8", "utf-16", "UTF-16BE", "iso-8859-1", "us-ascii", "windows-1251", "no-such"],
        ["utf-8", "utf-8 mark", "utf-16", "utf-16 mark", "utf-16BE", "utf-16BE mark", "latin1"]) is var all
        ? [.. all.Select(row => row.Data)] : [];

    [Theory]
    [MemberData(nameof(Encodings))]
    public void TheBytesSayInWhichEncodingTheyAre(string declared, string used)
    {
        var encoding = Encoding.GetEncoding(used.Split(' ')[0]);
        var text = (declared == "" ? "" : $"<?xml version=\"1.0\" encoding=\"{declared}\"?>\n") + Two.Replace("near", "n\u00E4her");
        byte[] bytes = [.. used.EndsWith("mark") ? encoding.Preamble : [], .. encoding.GetBytes(text)];
        Assert.Equal("3: 1 of 1; 8: 0 of 1", Counts(bytes));
        Assert.Equal("n\u00E4her", TestReport.Parse(bytes)[1].Name);
    }

    [Theory]
    [InlineData("\u001b[31m")]
    [InlineData("\0\u0001\u001f")]
    [InlineData("\uFFFE")]
    [InlineData("&#x1B;&#1;")]
    public void ACharacterThatXmlDoesNotAllowIsNoError(string odd) =>
        Assert.Equal("3: 1 of 1; 8: 0 of 1", Counts(Encoding.UTF8.GetBytes(Two.Replace("near", odd).Replace("expected", odd))));

    [Theory]
    [InlineData("", "it is empty: write JUnit, in the hand-out")]
    [InlineData("\n \0", "it is empty: write JUnit, in the hand-out")]
    [InlineData("All tests passed.", "it is no XML: write JUnit, in the hand-out")]
    [InlineData("{\"results\": {}}", "it is no XML: write JUnit, in the hand-out")]
    [InlineData("<html><body>1 &amp; 2</body></html>", "it holds no tests: write JUnit, in the hand-out")]
    [InlineData("<testsuite tests='0'/>", "it holds no tests: write JUnit, in the hand-out")]
    [InlineData("<testsuites tests='0'/>", "it is JUnit without a test: did the build fail?")]
    [InlineData("<test-run id='2' testcasecount='1'><test-suite><test-case name='Step08'/></test-suite></test-run>",
        "it is NUnit's own format: write JUnit, with nunit3-console")]
    [InlineData("<assemblies><assembly><collection><test name='Step08.Near' result='Pass'/></collection></assembly></assemblies>",
        "it is xUnit's own format: write JUnit, with the runner's -junit")]
    [InlineData("<Site><Testing><Test Status='passed'><Name>step8</Name></Test></Testing></Site>",
        "it is CTest's own format: write JUnit, with ctest --output-junit")]
    [InlineData("\n<testsuites>\n<testcase", "it breaks off or is spoilt at line 2: run the tests again")]
    [InlineData("<testsuites><testcase></testsuites>", "it breaks off or is spoilt at line 1: run the tests again")]
    [InlineData("<?xml <?xml ", "it holds no tests: write JUnit")]
    [InlineData("<!doctype html><html><p></html>", "it is no XML: write JUnit, in the hand-out")]
    [InlineData("<!-- -->", "it holds no tests: write JUnit")]
    [InlineData("<!DOCTYPE a [<!ENTITY b 'c'>]><a>&b;</a>", "it has a DTD that may name other files")]
    [InlineData("\n<?xml version='1.0'?><!-- --> <!DOCTYPE testsuites SYSTEM 'file:///etc/passwd'><testsuites/>", "it has a DTD")]
    public void AFileThatIsNotReadSaysWhatItIsAndWhatToDo(string text, string problem) =>
        Assert.StartsWith(problem, Assert.Throws<ProblemException>(() => TestReport.Parse(Encoding.UTF8.GetBytes(text))).Message);

    [Fact]
    public void APackedFileIsToldAsSuch()
    {
        using var packed = new MemoryStream();
        using (var gzip = new GZipStream(packed, CompressionLevel.Fastest)) gzip.Write(Encoding.UTF8.GetBytes(Two));
        Assert.Equal("it is packed: unpack it", Assert.Throws<ProblemException>(() => TestReport.Parse(packed.ToArray())).Message);
    }

    [Theory(Timeout = 60_000)] // each took time that grows with the square of its length, or more
    [InlineData("<?xml ", "", "")]
    [InlineData("<!---->", "", "<a/>")]
    [InlineData("<testsuite><testcase name='a'/>", "</testsuite>", "")]
    [InlineData("", "0", "<testcase name='step{0}'/>")]
    public async Task AForgedFileCostsLittle(string opening, string closing, string around)
    {
        var many = string.Concat(Enumerable.Repeat(opening, 50_000)) + string.Concat(Enumerable.Repeat(closing, 50_000));
        var text = around.Contains("{0}") ? string.Format(around, many) : many + around;
        await Task.Run(() =>
        {
            try { TestReport.Parse(Encoding.UTF8.GetBytes(text)); }
            catch (ProblemException) { } // or is refused
        }, TestContext.Current.CancellationToken);
    }
}
