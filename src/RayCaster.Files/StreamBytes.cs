namespace RayCaster.Files;

/// <summary>Reads all bytes of a stream, which may be a pipe that never ends.</summary>
internal static class StreamBytes
{
    /// <summary>Reads up to the end of the stream; false if there are more than <paramref name="most"/> bytes.</summary>
    /// <param name="stream">The stream; if it can seek, its length is known.</param>
    /// <param name="begun">Bytes that were read before; they come first.</param>
    public static bool TryReadToEnd(Stream stream, long most, out ArraySegment<byte> all, ReadOnlySpan<byte> begun = default)
    {
        all = default;
        var known = stream.CanSeek ? begun.Length + stream.Length - stream.Position : 0;
        if (known > most) return false;
        var bytes = new byte[known > 0 ? known + 1 : 1 << 16]; // one byte more, so that the end is found without growing
        begun.CopyTo(bytes);
        var length = begun.Length;
        while (stream.Read(bytes.AsSpan(length)) is > 0 and var count)
        {
            length += count;
            if (length > most) return false;
            if (length == bytes.Length) Array.Resize(ref bytes, (int)Math.Min(2L * length, most + 1));
        }
        all = new(bytes, 0, length);
        return true;
    }
}
