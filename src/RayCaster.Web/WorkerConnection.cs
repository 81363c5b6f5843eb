using System.Runtime.InteropServices.JavaScript;

namespace RayCaster.Web;

/// <summary>The page of this Web Worker.</summary>
internal sealed partial class WorkerConnection : IConnection
{
    public Task SendAsync(byte[] message, CancellationToken cancellation)
    {
        Post(Encoding.UTF8.GetString(message));
        return Task.CompletedTask;
    }

    public Task SendAsync(byte[] header, Frame frame, CancellationToken cancellation)
    {
        PostFrame(header, frame.Pixels.Span);
        return Task.CompletedTask;
    }

    [JSImport("post", "worker")]
    private static partial void Post(string message);

    [JSImport("postFrame", "worker")]
    private static partial void PostFrame([JSMarshalAs<JSType.MemoryView>] Span<byte> header, [JSMarshalAs<JSType.MemoryView>] Span<byte> pixels);
}
