namespace RayCaster.Cli.Tests.Fuzzing;

/// <summary>A scene that never ends is refused at the limit, through the real process.</summary>
public class EndlessSceneTests
{
    [Theory]
    [InlineData("-")]
    [InlineData("/dev/zero")]
    public void AnEndlessSceneIsReadUpToTheLimit(string scene)
    {
        Assert.SkipWhen(!File.Exists("/dev/zero"), "no /dev/zero here");
        using var raycaster = new RayCasterProcess();
        raycaster.RunInShell($"raycaster {scene} </dev/zero");
        Assert.Equal(2, raycaster.ExitCode);
        Assert.EndsWith(
            ": error: the scene file has more than 67,108,864 bytes, which is the limit; put large meshes into mesh files\n", raycaster.Error);
        Assert.Empty(raycaster.Files);
    }
}
