namespace RayCaster.Files;

/// <summary>Binary STL: after the header a normal, three vertices and two more bytes for each triangle.</summary>
internal sealed class BinaryStlFile(MeshSource source) : MeshFormat(source, Header)
{
    /// <summary>The bytes before the first triangle.</summary>
    public const int Header = 84;

    public const int BytesPerTriangle = 50;

    private const int normal = 12;

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public override void Read(MeshBlock block, MeshBuilder mesh)
    {
        for (var triangle = 0; triangle < block.Length; triangle += BytesPerTriangle)
        {
            mesh.BeginFace();
            for (var (corner, at) = (0, triangle + normal); corner < 3; corner++, at += 12)
            {
                mesh.AddVertex(new(Float(block, at), Float(block, at + 4), Float(block, at + 8)));
                mesh.AddCornerBack(-1);
            }
        }
    }

    public override int Cut(ReadOnlySpan<byte> bytes, bool isEnd) => bytes.Length / BytesPerTriangle * BytesPerTriangle;

    private static double Float(MeshBlock block, int at)
    {
        var value = BinaryPrimitives.ReadSingleLittleEndian(block.Buffer.AsSpan(at));
        return float.IsFinite(value)
            ? value
            : throw block.Source.ErrorAtByte(block.Start + at, $"a coordinate must be a finite number, but is {value}");
    }
}
