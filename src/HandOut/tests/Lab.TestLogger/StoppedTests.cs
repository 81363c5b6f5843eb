using System.Text.RegularExpressions;
using Microsoft.VisualStudio.TestPlatform.ObjectModel;

namespace Lab.TestLogger;

/// <summary>The tests that were running when a run was stopped. They have no results.</summary>
internal static partial class StoppedTests
{
    /// <summary>At least one; if none is known, the run itself.</summary>
    /// <param name="running">The tests that have begun and not ended.</param>
    /// <param name="messages">The run's. One of them is the call stack of a stack overflow, with the test that has caused it.</param>
    public static List<TestResult> Of((string Name, string DisplayName)[] running, IReadOnlyList<string> messages)
    {
        var said = string.Join('\n', messages); // before the overflow also the stacks of tests that have failed
        List<TestResult> onTheStack = said.IndexOf("Stack overflow.") is >= 0 and var start ? [.. TestsIn(said[start..])] : [];
        if (onTheStack.Count > 0) return onTheStack;
        return running.Length > 0
            ? [.. running.Select(test => Stopped(test.Name, test.DisplayName))]
            : [Stopped("Lab.Tests.UnknownTest", "Lab.Tests.UnknownTest")];
    }

    /// <summary>A message up to the test in its call stack: xunit's and the runtime's calls help nobody.</summary>
    public static string WithoutForeignCalls(string message) =>
        TestName().Match(message) is { Success: true } test && message.IndexOf('\n', test.Index) is >= 0 and var end ? message[..end] : message;

    /// <summary>The lines of a call stack that are in the lab's files or its tests'.</summary>
    public static string OwnCalls(string stack) =>
        string.Join('\n', stack.Split('\n').Where(line => line.TrimStart().StartsWith("at Lab.") && line.Contains(".cs:line ")));

    private static IEnumerable<TestResult> TestsIn(string stack) =>
        from name in TestName().Matches(stack).Select(test => test.Value).Distinct()
        select Stopped(name, name);

    private static TestResult Stopped(string name, string displayName)
    {
        var test = new TestCase(name, new("executor://lab"), "Lab.Tests") { DisplayName = displayName };
        if (Step().Match(name) is { Success: true } step) test.Traits.Add("step", step.Groups[1].Value);
        return new(test)
        {
            DisplayName = displayName,
            ErrorMessage = "The run was stopped in this test. Probably your code has an endless loop, or methods that call each other without end.",
        };
    }

    [GeneratedRegex(@"(?<= at )Lab\.Tests\.Step\d\d\w*\.\w+(?=\()")]
    private static partial Regex TestName();

    [GeneratedRegex(@"\.Step(\d\d)")]
    private static partial Regex Step();
}
