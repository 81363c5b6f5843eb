namespace RayCaster.Page;

/// <summary>The way to a page in a browser.</summary>
internal interface IConnection
{
    /// <summary>Sends a message of <see cref="Messages"/>.</summary>
    Task SendAsync(byte[] message, CancellationToken cancellation);

    Task SendAsync(byte[] header, CanvasImage frame, CancellationToken cancellation);
}
