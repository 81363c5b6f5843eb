namespace RayCaster.Browser.Tests;

/// <summary>The page of a host, in a tab of the browser.</summary>
internal abstract class HostedPage(Tab tab) : IAsyncDisposable
{
    /// <summary>A small scene, whose text and whose names must be told as they are.</summary>
    public const string Ball = """
        {
          // a ball; "ü" has two bytes, "😀" four
          "camera": { "position": [6, 0, 2.5], "target": [-6, 0, 0], "width": 40, "height": 30 },
          "models": [ { "type": "sphere", "name": "<img src=x onerror=alert(1)>", "center": [0, 0, 1], "radius": 1, "color": [1, 0.5, 0.1] } ]
        }
        """;

    public Tab Tab => tab;

    public IPage Page => tab.Page;

    public List<string> Complaints => tab.Complaints;

    /// <summary>The scene's text where the user has it.</summary>
    public abstract Task<string> SceneTextAsync();

    /// <summary>Changes the scene's text there.</summary>
    public abstract Task WriteSceneAsync(string text);

    public virtual ValueTask DisposeAsync() => tab.DisposeAsync();
}
