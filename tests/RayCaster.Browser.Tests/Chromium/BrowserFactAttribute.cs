using System.Runtime.CompilerServices;

namespace RayCaster.Browser.Tests;

/// <summary>A test that needs Chromium (Debian: apt-get install chromium). Without it the test is skipped, and the run says so.</summary>
public sealed class BrowserFactAttribute : FactAttribute
{
    public BrowserFactAttribute([CallerFilePath] string? file = null, [CallerLineNumber] int line = -1) : base(file, line)
    {
        if (!File.Exists(Chromium.Program)) Skip = "chromium is missing";
    }
}

/// <inheritdoc cref="BrowserFactAttribute"/>
public sealed class BrowserTheoryAttribute : TheoryAttribute
{
    public BrowserTheoryAttribute([CallerFilePath] string? file = null, [CallerLineNumber] int line = -1) : base(file, line)
    {
        if (!File.Exists(Chromium.Program)) Skip = "chromium is missing";
    }
}
