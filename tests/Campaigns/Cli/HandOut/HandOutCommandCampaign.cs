namespace RayCaster.Cli.Tests.HandOut;

[Trait("waits", "yes")]
public sealed class HandOutCommandCampaign : CommandTests
{
    [Fact]
    public void AKilledRunLeavesNoHandOut()
    {
        using (var process = raycaster.Start("handout", "lab1"))
        {
            while (!raycaster.Files.Any(name => name.EndsWith(".tmp")) && !process.HasExited) Thread.Sleep(10);
            process.Kill(); // SIGKILL: it has no time to tidy
            process.WaitForExit();
        }
        Assert.Matches(@"^lab1\.([0-9a-f]{8})\.tmp$", Assert.Single(raycaster.Files));
        raycaster.Run("handout", "lab1", "-q");
        Assert.Equal((ExitCode.Done, ""), (raycaster.ExitCode, raycaster.Error));
        Assert.Contains("lab1", raycaster.Files);
    }
}
