namespace RayCaster.Page;

/// <summary>The way to a page in a browser.</summary>
internal interface IConnection
{
    Task SendAsync(byte[] message, CancellationToken cancellation);

    Task SendAsync(byte[] header, CanvasImage frame, CancellationToken cancellation);
}
