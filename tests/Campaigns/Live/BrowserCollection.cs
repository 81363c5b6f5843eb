using PuppeteerSharp;

namespace RayCaster.Live.Tests;

/// <summary>The tests in a browser, which take turns with the one that there is.</summary>
[CollectionDefinition("browser")]
public class BrowserCollection : ICollectionFixture<Chromium>;

/// <summary>Opens a page of a server that a test has started.</summary>
internal static class ChromiumExtensions
{
    extension(Chromium chromium)
    {
        public Task<(IPage Page, List<string> Complaints)> OpenAsync(LivePage live, ViewPortOptions? size = null, bool isDark = false) =>
            chromium.OpenAsync(live.Server.Address, size, isDark);
    }
}
