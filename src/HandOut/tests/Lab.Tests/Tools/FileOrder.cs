using Xunit.Abstractions;
using Xunit.Sdk;

[assembly: TestCaseOrderer("Lab.Tests.FileOrder", "Lab.Tests")]

namespace Lab.Tests;

/// <summary>Tests run as their file has them: simple examples first, then random rays, at last pictures.</summary>
public sealed class FileOrder : ITestCaseOrderer
{
    public IEnumerable<T> OrderTestCases<T>(IEnumerable<T> tests) where T : ITestCase =>
        tests.OrderBy(test => test.TestMethod.Method.ToRuntimeMethod().MetadataToken);
}
