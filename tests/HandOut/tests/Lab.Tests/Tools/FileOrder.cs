using Xunit.Abstractions;
using Xunit.Sdk;

namespace Lab.Tests;

/// <summary>Tests run as their file has them: simple examples first, then random rays, at last pictures.</summary>
public sealed class FileOrder : ITestCaseOrderer
{
    /// <summary>xunit finds this class by its name.</summary>
    public const string Name = "Lab.Tests.FileOrder", Assembly = "Lab.Tests";

    public IEnumerable<T> OrderTestCases<T>(IEnumerable<T> tests) where T : ITestCase =>
        tests.OrderBy(test => test.TestMethod.Method.ToRuntimeMethod().MetadataToken);
}
