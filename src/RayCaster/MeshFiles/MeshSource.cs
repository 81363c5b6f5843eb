namespace RayCaster;

/// <summary>The bytes of a mesh file, and what to say about a place in them.</summary>
/// <param name="path">The file, as the caller named it.</param>
/// <param name="bytes">All that it holds.</param>
internal sealed class MeshSource(string path, byte[] bytes)
{
    public byte[] Bytes { get; } = bytes;

    /// <summary>A mistake of the whole file.</summary>
    public MeshFileException Error(string reason) => new(path, reason);

    /// <summary>A mistake in a binary part of the file.</summary>
    public MeshFileException ErrorAtByte(int offset, string reason) => new(path, reason, offset: offset);

    /// <summary>A mistake in a text part of the file. Only now are its lines counted, so that readers need to know nothing but bytes.</summary>
    public MeshFileException ErrorAtLine(int offset, string reason)
    {
        var line = 1;
        for (var i = 0; i < offset; i++)
            if (Bytes[i] == '\n' || (Bytes[i] == '\r' && !(i + 1 < Bytes.Length && Bytes[i + 1] == '\n')))
                line++;
        return new(path, reason, line);
    }
}
