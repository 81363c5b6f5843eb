namespace RayCaster.Browser.Tests;

/// <summary>Tests of the ball's page, each in a tab of its own.</summary>
public abstract class HostTests : IAsyncLifetime
{
    private protected HostedPage Host { get; private set; } = null!;

    private protected IPage Page => Host.Page;

    public async ValueTask InitializeAsync() => Host = await OpenAsync();

    public async ValueTask DisposeAsync()
    {
        if (Host is null) return; // it is skipped
        await Host.DisposeAsync();
        Assert.Empty(Host.Complaints);
    }

    private protected abstract Task<HostedPage> OpenAsync();
}
