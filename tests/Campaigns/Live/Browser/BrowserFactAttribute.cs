namespace RayCaster.Live.Tests;

/// <summary>A test that needs Chromium (Debian: apt-get install chromium). Without it the test is skipped, and the run says so.</summary>
public sealed class BrowserFactAttribute : FactAttribute
{
    public const string Path = "/usr/bin/chromium";

    public BrowserFactAttribute()
    {
        if (!File.Exists(Path)) Skip = "chromium is missing";
    }
}
