namespace RayCaster.Browser.Tests;

/// <summary>The tests of the page with a server.</summary>
[CollectionDefinition("server")]
public class ServerCollection : ICollectionFixture<Chromium>;

/// <summary>The page of RayCaster.Live, which follows a scene file.</summary>
internal sealed class ServedPage(Tab tab, LivePage live) : HostedPage(tab)
{
    public string Scene => live.Scene;

    public static async Task<ServedPage> OpenAsync(Chromium chromium, string scene = Ball, string script = "")
    {
        var live = await LivePage.OpenAsync(scene);
        var tab = await chromium.OpenAsUsualAsync(script);
        await tab.ShowAsync(live.Server.Address);
        return new(tab, live);
    }

    public override Task<string> SceneTextAsync() => File.ReadAllTextAsync(Scene);

    public override Task WriteSceneAsync(string text) => File.WriteAllTextAsync(Scene, text);

    public override async ValueTask DisposeAsync()
    {
        await base.DisposeAsync();
        await live.DisposeAsync();
    }
}
