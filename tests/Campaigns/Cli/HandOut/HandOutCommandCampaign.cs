namespace RayCaster.Cli.Tests.HandOut;

public sealed class HandOutCommandCampaign : IDisposable
{
    private readonly RayCasterProcess app = new();

    public void Dispose() => app.Dispose();

    [Fact]
    public void AKilledRunLeavesNoHandOut()
    {
        using (var process = app.Start("handout", "lab1"))
        {
            while (!app.Files.Any(name => name.EndsWith(".tmp")) && !process.HasExited) Thread.Sleep(10);
            process.Kill(); // SIGKILL: it has no time to tidy
            process.WaitForExit();
        }
        Assert.Matches(@"^lab1\.([0-9a-f]{8})\.tmp$", Assert.Single(app.Files));
        app.Run("handout", "lab1", "-q");
        Assert.Equal((ExitCode.Done, ""), (app.ExitCode, app.Error));
        Assert.Contains("lab1", app.Files);
    }
}
