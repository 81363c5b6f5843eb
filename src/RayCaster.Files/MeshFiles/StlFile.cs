namespace RayCaster.Files;

/// <summary>STL, binary or ascii. Each triangle has its own three vertices; the normals are not needed.</summary>
internal static class StlFile
{
    /// <summary>The size decides: a binary file may begin with "solid" too.</summary>
    public static MeshData Read(MeshSource source)
    {
        if (source.Length >= BinaryStlFile.Header)
        {
            Span<byte> header = stackalloc byte[BinaryStlFile.Header];
            source.Read(0, header);
            const int countAt = BinaryStlFile.Header - 4;
            var count = BinaryPrimitives.ReadUInt32LittleEndian(header[countAt..]);
            var size = BinaryStlFile.Header + BinaryStlFile.BytesPerTriangle * (long)count;
            if (size == source.Length) return MeshReader.Read(source, () => new BinaryStlFile(source));
            // A text has no zero bytes, so this is a binary file that was cut; the ascii reader's message would mislead.
            if (header.Contains((byte)0))
                throw source.ErrorAtByte(
                    countAt, $"the header promises {count} triangles, which take {size} bytes, but the file has {source.Length}");
        }
        return MeshReader.Read(source, () => new AsciiStlFile(source));
    }
}
