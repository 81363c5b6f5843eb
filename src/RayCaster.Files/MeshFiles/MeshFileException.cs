namespace RayCaster.Files;

/// <summary>
/// A mesh file that cannot be read; the message names the file, the place and the reason: <c>cube.obj(12): face index 9 is …</c>
/// </summary>
public sealed class MeshFileException : Exception
{
    /// <summary>Names a place in a text file, in a binary one, or, with neither, the file as a whole.</summary>
    internal MeshFileException(string path, string reason, int? line = null, long? offset = null, Exception? inner = null)
        : base($"{path}{(line is null ? null : $"({line})")}{(offset is null ? null : $"(byte {offset})")}: {reason}", inner) =>
        (Path, Reason, Line, Offset) = (path, reason, line, offset);

    /// <summary>The file, as the caller named it.</summary>
    public string Path { get; }

    /// <summary>What is wrong and what is allowed, without the place.</summary>
    public string Reason { get; }

    /// <summary>The line, from 1, where the file is text and the mistake has a place; lines end with LF, CRLF or CR.</summary>
    public int? Line { get; }

    /// <summary>The byte, from 0, where the file is binary and the mistake has a place.</summary>
    public long? Offset { get; }
}
