namespace RayCaster.Files;

/// <summary>
/// A mesh file that cannot be read; the message names the file, the place and the reason: <c>cube.obj(12): face index 9 is …</c> in a text,
/// <c>cube.stl(byte 80): …</c> in a binary file.
/// </summary>
public sealed class MeshFileException : Exception
{
    /// <summary>Names a line, a byte, or, with neither, the file as a whole. Lines count from 1 and end with LF, CRLF or CR; bytes count from
    /// 0.</summary>
    internal MeshFileException(string path, string reason, int? line = null, long? offset = null, Exception? inner = null)
        : base($"{path}{(line is null ? null : $"({line})")}{(offset is null ? null : $"(byte {offset})")}: {reason}", inner)
    {
    }
}
