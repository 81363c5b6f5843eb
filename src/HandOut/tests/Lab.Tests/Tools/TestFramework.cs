using System.Reflection;
using Lab.TestLogger;
using Xunit.Abstractions;
using Xunit.Sdk;

[assembly: TestFramework("Lab.Tests.TestFramework", "Lab.Tests")]

namespace Lab.Tests;

/// <summary>xunit, and a list of the tests that have begun: the table of steps reads it after a run that was stopped.</summary>
public sealed class TestFramework(IMessageSink messages) : XunitTestFramework(messages)
{
    protected override ITestFrameworkExecutor CreateExecutor(AssemblyName assembly) =>
        new Executor(assembly, SourceInformationProvider, DiagnosticMessageSink);

    private sealed class Executor(AssemblyName assembly, ISourceInformationProvider sources, IMessageSink messages)
        : XunitTestFrameworkExecutor(assembly, sources, messages)
    {
        protected override void RunTestCases(IEnumerable<IXunitTestCase> tests, IMessageSink results, ITestFrameworkExecutionOptions options) =>
            base.RunTestCases(tests, new Watched(results, new TestsBegun(TestsBegun.Path)), options);
    }

    private sealed class Watched(IMessageSink results, TestsBegun begun) : LongLivedMarshalByRefObject, IMessageSink
    {
        public bool OnMessage(IMessageSinkMessage message)
        {
            if (message is ITestStarting { Test: var test }) begun.Begin(NameOf(test), test.DisplayName);
            var goesOn = results.OnMessage(message);
            if (message is ITestFinished { Test: var ended }) begun.End(NameOf(ended), ended.DisplayName);
            if (message is ITestAssemblyFinished) begun.Dispose();
            return goesOn;
        }

        private static string NameOf(ITest test)
        {
            var method = test.TestCase.TestMethod;
            return $"{method.TestClass.Class.Name}.{method.Method.Name}";
        }
    }
}
