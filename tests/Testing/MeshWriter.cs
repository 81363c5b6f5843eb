using System.Buffers.Binary;
using System.Globalization;
using System.Text;

namespace RayCaster.Testing;

/// <summary>The bytes of mesh files, for tests and for the files in scenes/meshes.</summary>
internal static class MeshWriter
{
    /// <summary>OBJ.</summary>
    /// <param name="mesh">What to write.</param>
    /// <param name="format">"R" writes every digit that reading back needs; "F6" six places.</param>
    public static byte[] Obj(MeshData mesh, string format = "R")
    {
        var text = new StringBuilder();
        foreach (var v in mesh.Vertices) text.Append("v ").Append(Words(v, format)).Append('\n');
        foreach (var (a, b, c) in Triangles(mesh)) text.Append(CultureInfo.InvariantCulture, $"f {a + 1} {b + 1} {c + 1}\n");
        return Encoding.ASCII.GetBytes(text.ToString());
    }

    public static byte[] PlyAscii(MeshData mesh)
    {
        var text = new StringBuilder(PlyHeader(mesh, "ascii", "double"));
        foreach (var v in mesh.Vertices) text.Append(Words(v)).Append('\n');
        foreach (var (a, b, c) in Triangles(mesh)) text.Append(CultureInfo.InvariantCulture, $"3 {a} {b} {c}\n");
        return Encoding.ASCII.GetBytes(text.ToString());
    }

    /// <summary>PLY with doubles, in which every number survives.</summary>
    public static byte[] PlyBinary(MeshData mesh, bool bigEndian)
    {
        var (number, index) = (new byte[8], new byte[4]);
        var bytes = new MemoryStream();
        bytes.Write(Encoding.ASCII.GetBytes(PlyHeader(mesh, bigEndian ? "binary_big_endian" : "binary_little_endian", "double")));
        foreach (var v in mesh.Vertices)
            foreach (var coordinate in new[] { v.X, v.Y, v.Z })
            {
                if (bigEndian) BinaryPrimitives.WriteDoubleBigEndian(number, coordinate);
                else BinaryPrimitives.WriteDoubleLittleEndian(number, coordinate);
                bytes.Write(number);
            }
        for (var i = 0; i < mesh.Indices.Length; i++)
        {
            if (i % 3 == 0) bytes.WriteByte(3);
            if (bigEndian) BinaryPrimitives.WriteInt32BigEndian(index, mesh.Indices[i]);
            else BinaryPrimitives.WriteInt32LittleEndian(index, mesh.Indices[i]);
            bytes.Write(index);
        }
        return bytes.ToArray();
    }

    /// <summary>Little-endian PLY with floats, which halves the size.</summary>
    public static byte[] PlyFloat(MeshData mesh)
    {
        var bytes = new MemoryStream();
        var writer = new BinaryWriter(bytes); // little-endian everywhere
        writer.Write(Encoding.ASCII.GetBytes(PlyHeader(mesh, "binary_little_endian", "float")));
        foreach (var v in mesh.Vertices) WriteFloats(writer, v);
        foreach (var (a, b, c) in Triangles(mesh))
        {
            writer.Write((byte)3);
            foreach (var index in new[] { a, b, c }) writer.Write(index);
        }
        return bytes.ToArray();
    }

    public static byte[] StlAscii(MeshData mesh, string name = "mesh")
    {
        var text = new StringBuilder($"solid {name}\n");
        foreach (var (a, b, c) in Triangles(mesh))
        {
            text.Append($"  facet normal {Words(Normal(mesh, a, b, c), "0.######")}\n    outer loop\n");
            foreach (var corner in new[] { a, b, c }) text.Append($"      vertex {Words(mesh.Vertices[corner])}\n");
            text.Append("    endloop\n  endfacet\n");
        }
        return Encoding.ASCII.GetBytes(text.Append($"endsolid {name}\n").ToString());
    }

    /// <summary>STL with floats; its coordinates are rounded to them.</summary>
    public static byte[] StlBinary(MeshData mesh, string header = "")
    {
        var bytes = new MemoryStream();
        var writer = new BinaryWriter(bytes);
        writer.Write(Encoding.ASCII.GetBytes(header.PadRight(80, '\0')));
        writer.Write(mesh.Indices.Length / 3);
        foreach (var (a, b, c) in Triangles(mesh))
        {
            WriteFloats(writer, Normal(mesh, a, b, c));
            foreach (var corner in new[] { a, b, c }) WriteFloats(writer, mesh.Vertices[corner]);
            writer.Write((short)0);
        }
        return bytes.ToArray();
    }

    /// <summary>The three places of each triangle.</summary>
    public static IEnumerable<(int A, int B, int C)> Triangles(MeshData mesh)
    {
        for (var i = 0; i < mesh.Indices.Length; i += 3) yield return (mesh.Indices[i], mesh.Indices[i + 1], mesh.Indices[i + 2]);
    }

    private static string PlyHeader(MeshData mesh, string format, string type) =>
        $"ply\nformat {format} 1.0\nelement vertex {mesh.Vertices.Length}\n"
        + $"property {type} x\nproperty {type} y\nproperty {type} z\n"
        + $"element face {mesh.Indices.Length / 3}\nproperty list uchar int vertex_indices\nend_header\n";

    private static string Words(Vector3 v, string format = "R") =>
        string.Join(' ', new[] { v.X, v.Y, v.Z }.Select(number => (number + 0.0).ToString(format, CultureInfo.InvariantCulture)));

    private static Vector3 Normal(MeshData mesh, int a, int b, int c) =>
        ((mesh.Vertices[b] - mesh.Vertices[a]) % (mesh.Vertices[c] - mesh.Vertices[a])).Normalized;

    private static void WriteFloats(BinaryWriter writer, Vector3 v)
    {
        foreach (var number in new[] { v.X, v.Y, v.Z }) writer.Write((float)number);
    }
}
