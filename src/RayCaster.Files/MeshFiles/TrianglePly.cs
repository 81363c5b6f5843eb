using System.Buffers;

namespace RayCaster.Files;

/// <summary>
/// PLY as most programs write it: little-endian, coordinates in floats, faces of three 32-bit corners. All rows of an element then have one
/// length, so each row's place is known, and its numbers go straight into the final arrays. Any other file, and any file with a mistake, is read
/// by <see cref="PlyFile"/>, which takes five times as long and reports mistakes.
/// </summary>
internal sealed class TrianglePly
{
    private const int Corners = 3, FaceSize = 1 + Corners * sizeof(int);

    private readonly MeshSource source;
    private readonly long vertexCount, faceCount;
    private readonly long verticesAt, facesAt;
    private readonly int vertexSize, xAt, yAt, zAt;

    private TrianglePly(MeshSource source, PlyHeader header)
    {
        this.source = source;
        var at = (long)header.BodyAt;
        foreach (var element in header.Elements)
        {
            var isFace = element.Name == "face";
            var size = 0;
            foreach (var property in element.Properties)
            {
                if (isFace ? property is not { Role: PlyRole.Corners, CountType: PlyType.UInt8, Size: sizeof(int), Type: not PlyType.Float32 }
                    : property.CountType is not null || (property.Role != PlyRole.Skipped && property.Type != PlyType.Float32))
                    return;
                if (property.Role == PlyRole.X) xAt = size;
                if (property.Role == PlyRole.Y) yAt = size;
                if (property.Role == PlyRole.Z) zAt = size;
                size += isFace ? FaceSize : property.Size;
            }
            if (isFace && size != FaceSize) return;
            if (size > 0 && element.Count > (source.Length - at) / size) return;
            if (isFace) (facesAt, faceCount) = (at, element.Count);
            if (element.Name == "vertex") (verticesAt, vertexCount, vertexSize) = (at, element.Count, size);
            at += element.Count * size;
        }
        Fits = header.Format == "binary_little_endian" && faceCount > 0 && vertexCount > 0
            && Math.Max(vertexCount, Corners * faceCount) <= Array.MaxLength && vertexSize <= source.BlockSize
            && source.FirstNotBlank(at) is null;
    }

    private bool Fits { get; }

    /// <summary>Reads the file; null where it is of another kind or has a mistake.</summary>
    public static MeshData? Read(MeshSource source, PlyHeader header) => new TrianglePly(source, header) is { Fits: true } file ? file.Read() : null;

    private MeshData? Read()
    {
        var vertices = GC.AllocateUninitializedArray<Vector3>((int)vertexCount);
        var indices = GC.AllocateUninitializedArray<int>(Corners * (int)faceCount);
        return ReadRows(verticesAt, vertexSize, vertices.Length, (rows, first, count) => ReadVertices(rows, vertices.AsSpan(first, count)))
            && ReadRows(facesAt, FaceSize, (int)faceCount, (rows, first, count) => ReadFaces(rows, indices.AsSpan(Corners * first, Corners * count)))
            ? new(vertices, indices)
            : null;
    }

    /// <summary>Reads all rows of an element, some at a time; false where one has a mistake.</summary>
    private bool ReadRows(long at, int size, int rowCount, Func<ReadOnlySpan<byte>, int, int, bool> read)
    {
        var rowsAtOnce = Math.Max(1, source.BlockSize / size);
        var areRight = true;
        Ranges.EachPiece((int)((rowCount - 1L) / rowsAtOnce) + 1, source.Threads, i =>
        {
            if (!Volatile.Read(ref areRight)) return;
            var first = i * rowsAtOnce;
            var count = Math.Min(rowsAtOnce, rowCount - first);
            var buffer = ArrayPool<byte>.Shared.Rent(count * size);
            var rows = buffer.AsSpan(0, count * size);
            source.Read(at + (long)first * size, rows);
            if (!read(rows, first, count)) Volatile.Write(ref areRight, false);
            ArrayPool<byte>.Shared.Return(buffer);
        });
        return areRight;
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // called a few times, for many rows each
    private bool ReadVertices(ReadOnlySpan<byte> rows, Span<Vector3> vertices)
    {
        var zero = 0f; // NaN as soon as a coordinate is not finite
        for (var i = 0; i < vertices.Length; i++)
        {
            var row = rows.Slice(i * vertexSize, vertexSize);
            var x = BinaryPrimitives.ReadSingleLittleEndian(row[xAt..]);
            var y = BinaryPrimitives.ReadSingleLittleEndian(row[yAt..]);
            var z = BinaryPrimitives.ReadSingleLittleEndian(row[zAt..]);
            vertices[i] = new(x, y, z);
            zero += 0 * x + 0 * y + 0 * z;
        }
        return zero == 0;
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private bool ReadFaces(ReadOnlySpan<byte> rows, Span<int> indices)
    {
        var limit = (uint)vertexCount;
        for (var i = 0; i < indices.Length; i += Corners)
        {
            var row = rows.Slice(i / Corners * FaceSize, FaceSize);
            var a = BinaryPrimitives.ReadUInt32LittleEndian(row[1..]);
            var b = BinaryPrimitives.ReadUInt32LittleEndian(row[5..]);
            var c = BinaryPrimitives.ReadUInt32LittleEndian(row[9..]);
            if (row[0] != Corners || Math.Max(a, Math.Max(b, c)) >= limit) return false;
            (indices[i], indices[i + 1], indices[i + 2]) = ((int)a, (int)b, (int)c);
        }
        return true;
    }
}
