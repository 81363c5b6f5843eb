namespace RayCaster.Browser.Tests;

/// <summary>The page without a server is as any other; what follows from its being a folder of files is in the other classes.</summary>
[Collection("folder")]
public class FolderTests(Chromium chromium, Site site) : PageTests
{
    private protected override async Task<HostedPage> OpenAsync(string script) =>
        await FolderPage.OpenAsync(chromium, site, FolderPage.Link(HostedPage.Ball), script: script);
}
