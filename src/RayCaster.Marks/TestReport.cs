using System.Text.RegularExpressions;
using System.Xml;
using System.Xml.Linq;

namespace RayCaster.Marks;

/// <summary>How a test ended. If a report says several things, the greatest counts.</summary>
internal enum TestOutcome
{
    Passed,
    NotRun,
    Failed,
}

/// <summary>A test of a report. Where the report says that it was tried several times, the last attempt that ran counts.</summary>
/// <param name="Key">What it is called in other runs, too: its step, class, name and place.</param>
/// <param name="Begun">When its run began; null if the report does not say so.</param>
/// <param name="Step">The step that it tests; 0 if it names none.</param>
/// <param name="Word">What the report calls its end, such as <c>suppressed</c>; empty if it says nothing.</param>
/// <param name="IsFlaky">Whether its attempts ended in different ways.</param>
/// <param name="IsStopped">Whether the run was stopped in it, so that others may not have run.</param>
internal sealed record ReportedTest(string Key, DateTimeOffset? Begun, int Step, string Name, TestOutcome Outcome, string Word,
    bool IsFlaky = false, bool IsStopped = false)
{
    /// <summary>Whether tests of its name end in different ways, and nothing says which of them counts.</summary>
    public bool IsDisputed { get; init; }
}

/// <summary>Reads a file of test results: JUnit, of which each runner writes a dialect of its own, or TRX.</summary>
internal static partial class TestReport
{
    /// <summary>The longest file, in bytes.</summary>
    internal const int MaxBytes = 1 << 24;

    private const int MaxText = 80, MaxDepth = 100;

    /// <summary>Begins the hand-out's message of a test that did not end.</summary>
    private const string Stopped = "The run was stopped";

    private const string GetJUnit =
        "write JUnit, in the hand-out with dotnet test --logger \"steps;junit=FILE\", in Python with pytest --junit-xml=FILE";

    /// <param name="Element">What a test is called.</param>
    /// <param name="Name">The attribute of its name. That of its class is <c>classname</c>.</param>
    /// <param name="Ends">The attributes that say how it ended.</param>
    /// <param name="Others">The attributes by which two tests of one name, which are no attempts, may differ.</param>
    private sealed record Dialect(string Element, string Name, string[] Ends, string[] Others);

    private static readonly Dialect[] dialects =
    [
        new("testcase", "name", ["result", "status"], ["file", "line"]), // JUnit
        new("UnitTestResult", "testName", ["outcome"], ["executionId"]), // TRX
    ];

    /// <summary>What elements of a test, such as &lt;skipped/&gt;, and its attributes say. Another word of an attribute is no result.</summary>
    private static readonly Dictionary<string, TestOutcome> words = new[]
    {
        (TestOutcome.Passed, "run pass passed success successful succeeded ok completed executed"),
        (TestOutcome.NotRun, "skip skipped disabled suppressed ignore ignored notrun notexecuted pending todo inconclusive incomplete aborted"),
        (TestOutcome.Failed, "fail failed failure error errored broken crashed timeout timedout"),
    }.SelectMany(row => row.Item2.Split(' ').Select(word => KeyValuePair.Create(word, row.Item1))).ToDictionary();

    /// <summary>The elements of earlier attempts of a test.</summary>
    private static readonly string[] attempts = ["flakyFailure", "flakyError", "rerunFailure", "rerunError", "rerun"];

    /// <summary>What the names of properties contain that number the attempts of a test.</summary>
    private static readonly string[] repetitions = ["repetition", "rerun", "retry", "attempt"];

    /// <summary>What files without a test are, by their outermost elements, and how to get JUnit instead.</summary>
    private static readonly Dictionary<string, string> others = new()
    {
        ["testsuites"] = "is JUnit without a test: did the build fail?",
        ["test-run"] = "is NUnit's own format: write JUnit, with nunit3-console --result=\"FILE;transform=nunit3-junit.xslt\", or with dotnet " +
            "test --logger junit and the package JunitXml.TestLogger",
        ["assemblies"] = "is xUnit's own format: write JUnit, with the runner's -junit FILE, or with dotnet test --logger junit and the package " +
            "JunitXml.TestLogger",
        ["Site"] = "is CTest's own format: write JUnit, with ctest --output-junit FILE",
    };

    /// <exception cref="ProblemException">What is wrong with the file, as a sentence that begins with "it".</exception>
    public static IReadOnlyList<ReportedTest> Read(string path) =>
        Parse(new FileInfo(path).Length == 0 ? [] // a pipe has no length either
            : [.. InputFile.Read(path, "file", MaxBytes, ": do the tests print too much?")]);

    /// <exception cref="ProblemException">The same.</exception>
    internal static IReadOnlyList<ReportedTest> Parse(byte[] report)
    {
        if (!report.AsSpan().ContainsAnyExcept("\0 \r\n"u8)) throw new ProblemException($"it is empty: {GetJUnit}");
        if (report is [0x1F, 0x8B, ..] or [(byte)'P', (byte)'K', ..]) throw new ProblemException("it is packed: unpack it");
        var all = Parsed(ForeignText.Decode(report));
        var classes = Named(all, "TestMethod").ToLookup(method => Text(method.Parent!, "id"), method => Text(method, "className"));
        foreach (var rows in Named(all, "InnerResults").Where(rows => Named(rows, "UnitTestResult").Any()).ToArray())
            rows.Parent!.Name = "SumOfRows"; // is no test
        var starts = Named(all, "Times").ToLookup(times => times.Parent!, times => Text(times, "start")); // of whole runs
        foreach (var result in Named(all, "UnitTestResult")) result.SetAttributeValue("classname", classes[Text(result, "testId")].FirstOrDefault());

        ReportedTest[] tests =
        [
            .. from dialect in dialects
               from suite in Named(all, dialect.Element).GroupBy(test => test.Parent!)
               from test in TestsOf(suite.Key, suite, dialect, starts)
               select test,
        ];
        var root = all.Elements().FirstOrDefault()?.Name.LocalName ?? "";
        return tests.Length > 0 ? tests : throw new ProblemException($"it {others.GetValueOrDefault(root, $"holds no tests: {GetJUnit}")}");
    }

    private static IEnumerable<ReportedTest> TestsOf(
        XElement suite, IEnumerable<XElement> listed, Dialect dialect, ILookup<XElement, string> starts)
    {
        XElement[][] tests =
        [
            .. listed.GroupBy(test => string.Join('\n', dialect.Others.Prepend("classname").Append(dialect.Name).Select(part => Text(test, part))))
                .SelectMany(same => AreAttempts([.. same]) ? [[.. same.OrderBy(AttemptOf)]] : same.Select(test => (XElement[])[test])),
        ];
        var hasTodo = Number(suite, "tests", int.MaxValue) < tests.Length; // jest lists what is to do as if it passed, but does not count it
        var begun = BegunOf(suite, starts);
        foreach (var test in tests) yield return Last([.. test.Select(attempt => Read(attempt, dialect, hasTodo, begun))]);
        var idle = tests.Count(test => test.Any(attempt => Said(attempt, dialect).Any(said => said.Outcome == TestOutcome.NotRun)));
        if (Number(suite, "disabled", 0) + Number(suite, "skipped", 0) > idle) // xunit does not list explicit tests, but counts them
            yield return new("", null, 0, "", TestOutcome.NotRun, "");
    }

    /// <summary>Whether tests of one name are attempts of one test: properties number them, perhaps all but the first. The same number of all is
    /// no attempt's, but how many are allowed.</summary>
    private static bool AreAttempts(XElement[] same)
    {
        string[] numbers = [.. same.Select(NumberOf).OfType<string>()];
        return numbers.Length == same.Length - 1 || numbers.Length == same.Length && numbers.Distinct().Count() > 1;
    }

    private static string? NumberOf(XElement test) => Named(test, "property")
        .Where(property => repetitions.Any(word => Text(property, "name").Contains(word, StringComparison.OrdinalIgnoreCase)))
        .Select(property => Text(property, "value")).FirstOrDefault();

    private static int AttemptOf(XElement test) =>
        int.TryParse(NumberOf(test), NumberStyles.None, CultureInfo.InvariantCulture, out var number) ? number : 0;

    /// <summary>When the run of a suite's tests began, as it, a suite around it or the run says.</summary>
    private static DateTimeOffset? BegunOf(XElement suite, ILookup<XElement, string> starts) =>
        suite.AncestorsAndSelf().Select(around => Text(around, "timestamp")).Concat(suite.AncestorsAndSelf().SelectMany(around => starts[around]))
            .Select(Time).FirstOrDefault(time => time is not null);

    /// <summary>A time as ISO 8601 writes it. Of 12.11.2026 nobody knows the month.</summary>
    private static DateTimeOffset? Time(string text) => text.IndexOf('-') == 4
        && DateTimeOffset.TryParse(text, CultureInfo.InvariantCulture, DateTimeStyles.AssumeUniversal, out var time) ? time : null;

    private static ReportedTest Last(ReportedTest[] attempts) =>
        (attempts.LastOrDefault(attempt => attempt.Outcome != TestOutcome.NotRun) ?? attempts[^1]) with
        {
            IsFlaky = attempts.Any(attempt => attempt.IsFlaky)
                || attempts.Select(attempt => attempt.Outcome).Except([TestOutcome.NotRun]).Count() > 1,
        };

    private static ReportedTest Read(XElement test, Dialect dialect, bool hasTodo, DateTimeOffset? begun)
    {
        var (outcome, word) = Said(test, dialect).Append((Outcome: TestOutcome.Passed, Word: "")).MaxBy(said => said.Outcome);
        if (hasTodo && !test.HasElements && Text(test, "time") == "0") (outcome, word) = (TestOutcome.NotRun, "todo");
        var (type, name) = (Text(test, "classname"), Text(test, dialect.Name));
        var step = StepOf(test, type, name);
        if (type != "" && name.StartsWith(type + ".", StringComparison.Ordinal)) name = name[(type.Length + 1)..];
        var places = dialect.Others.Where(other => other != "executionId").Select(place => Text(test, place)).Where(place => place != "");
        var key = string.Join('\n', [$"{step}", type == "" ? Text(test.Parent!, "name") : type, name, .. places]); // the same in JUnit and TRX
        return new(key, begun ?? Time(Text(test, "startTime")), step, Cut(name), outcome, Cut(word),
            outcome == TestOutcome.Passed && test.Elements().Any(element => attempts.Contains(element.Name.LocalName)),
            test.Elements().Any(error => Text(error, "message").StartsWith(Stopped, StringComparison.Ordinal)));
    }

    private static IEnumerable<(TestOutcome Outcome, string Word)> Said(XElement test, Dialect dialect) =>
        test.Elements().Select(element => element.Name.LocalName).Where(name => words.ContainsKey(Plain(name)))
            .Concat(dialect.Ends.Select(end => Text(test, end)).Where(end => end != ""))
            .Select(word => (words.GetValueOrDefault(Plain(word), TestOutcome.NotRun), word));

    /// <summary>The number after <c>step</c> in its class or name, such as <c>Lab.Tests.Step08Sphere</c> and <c>test_step_8</c>, in a property of
    /// it, or at the start of a suite's name.</summary>
    private static int StepOf(XElement test, string type, string name) =>
        new[] { type, name }
            .Concat(Named(test, "property").Where(property => Text(property, "name").Equals("step", StringComparison.OrdinalIgnoreCase))
                .Select(property => "step" + Text(property, "value")))
            .Concat(test.Ancestors().Select(suite => Text(suite, "name"))
                .Where(suite => suite.StartsWith("step", StringComparison.OrdinalIgnoreCase)))
            .Select(text => StepNumber().Match(text)).FirstOrDefault(match => match.Success)
            is { } match ? int.Parse(match.Groups[1].Value, CultureInfo.InvariantCulture) : 0;

    /// <summary>The elements of a text without a log's lines around them, and without declarations, which may name another encoding.</summary>
    private static XElement Parsed(string text)
    {
        var start = Markup().Match(text) is { Success: true } markup ? markup.Index : throw new ProblemException($"it is no XML: {GetJUnit}");
        var lines = text.AsSpan(0, start).Count('\n');
        var xml = $"<all>{NoContent().Replace(text[start..Math.Max(start, text.LastIndexOf('>') + 1)], " ")}</all>";
        var settings = new XmlReaderSettings { DtdProcessing = DtdProcessing.Prohibit, XmlResolver = null, CheckCharacters = false };
        try
        {
            using var reader = XmlReader.Create(new StringReader(xml), settings);
            while (reader.Read()) // a tree takes time that grows with the square of its depth
                if (reader.Depth > MaxDepth) throw new ProblemException($"its elements are nested more than {MaxDepth} deep");
            using var again = XmlReader.Create(new StringReader(xml), settings);
            return XElement.Load(again);
        }
        catch (XmlException e)
        {
            throw new ProblemException(xml.Contains("<!DOCTYPE", StringComparison.OrdinalIgnoreCase) ? "it has a DTD that may name other files"
                : $"it breaks off or is spoilt at line {lines + e.LineNumber}: run the tests again", e);
        }
    }

    private static IEnumerable<XElement> Named(XElement all, string name) => all.Descendants().Where(element => element.Name.LocalName == name);

    private static string Text(XElement element, string attribute) => element.Attribute(attribute)?.Value ?? "";

    private static int Number(XElement element, string attribute, int otherwise) =>
        int.TryParse(Text(element, attribute), NumberStyles.None, CultureInfo.InvariantCulture, out var number) ? number : otherwise;

    private static string Plain(string word) => NoLetters().Replace(word, "").ToLowerInvariant();

    private static string Cut(string text) => text.Length <= MaxText ? text : text[..MaxText] + "…";

    [GeneratedRegex(@"step[ _-]?0{0,9}(\d{1,2})", RegexOptions.IgnoreCase | RegexOptions.RightToLeft | RegexOptions.CultureInvariant)]
    private static partial Regex StepNumber();

    /// <summary>Where XML begins behind the lines of a log.</summary>
    [GeneratedRegex(@"<\?xml\s|<!DOCTYPE|<!--|<(\w+:)?(testsuites?|testcase|TestRun|test-run|assemblies|Site)[\s/>]|^\s*<\w")]
    private static partial Regex Markup();

    /// <summary>A declaration, or a character that XML does not allow, such as those that colour a terminal.</summary>
    [GeneratedRegex(@"<\?xml\s[^>]{0,200}\?>|[\0-\x08\x0B\x0C\x0E-\x1F\uFFFE\uFFFF]")]
    private static partial Regex NoContent();

    [GeneratedRegex("[^A-Za-z]")]
    private static partial Regex NoLetters();
}
