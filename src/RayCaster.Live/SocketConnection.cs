using System.Net.WebSockets;

namespace RayCaster.Live;

/// <summary>A page at the other end of a WebSocket.</summary>
internal sealed class SocketConnection(WebSocket socket) : IConnection
{
    private const int MaxBytes = 1 << 16; // of a message; the page's have some hundred

    /// <summary>Gives the page's requests to its tab, until the page closes or breaks the rules.</summary>
    public async Task ReadAsync(PageSession session, CancellationToken cancellation)
    {
        var bytes = new byte[MaxBytes];
        int length;
        do
        {
            using var stream = WebSocketStream.CreateReadableMessageStream(socket);
            length = await stream.ReadAtLeastAsync(bytes, MaxBytes, throwOnEndOfStream: false, cancellation);
        }
        while (length < MaxBytes && session.Take(bytes.AsMemory(0, length)));
    }

    public Task SendAsync(byte[] message, CancellationToken cancellation) =>
        socket.SendAsync(message.AsMemory(), WebSocketMessageType.Text, true, cancellation).AsTask();

    public async Task SendAsync(byte[] header, CanvasImage frame, CancellationToken cancellation)
    {
        await socket.SendAsync(header.AsMemory(), WebSocketMessageType.Binary, false, cancellation);
        await socket.SendAsync(frame.Pixels, WebSocketMessageType.Binary, true, cancellation);
    }
}
