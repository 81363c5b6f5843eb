namespace RayCaster.Files;

/// <summary>Reads all bytes of a stream, which may be a pipe that never ends.</summary>
internal static class StreamBytes
{
    /// <summary>The bytes up to the end of the stream; null if there are more than <paramref name="most"/>.</summary>
    /// <param name="stream">The stream; one that can seek says how much memory it needs.</param>
    /// <param name="most">The most bytes.</param>
    /// <param name="begun">Bytes that were read before; they come first.</param>
    public static ArraySegment<byte>? ReadToEnd(Stream stream, long most, ReadOnlySpan<byte> begun = default)
    {
        var known = stream.CanSeek ? begun.Length + stream.Length - stream.Position : 0;
        if (known > most) return null;
        var bytes = new byte[known > 0 ? known + 1 : 1 << 16]; // one byte more, so that the end is found without growing
        begun.CopyTo(bytes);
        for (var length = begun.Length; ;)
        {
            var count = stream.Read(bytes.AsSpan(length));
            if (count == 0) return new(bytes, 0, length);
            length += count;
            if (length > most) return null;
            if (length == bytes.Length) Array.Resize(ref bytes, (int)Math.Min(2L * length, most + 1));
        }
    }
}
