using System.Text;

namespace RayCaster.Files.Tests.Meshes;

/// <summary>A mesh that is written in any format is read back unchanged.</summary>
public class FormatsCampaign
{
    /// <summary>A download may stop at any byte: what is left is refused, or is read where only the end of a number or of the last line is
    /// missing.</summary>
    [Fact]
    public void EveryPrefixOfAFileIsReadOrRefused()
    {
        var cube = MeshGenerator.Cube(1.25);
        (string Path, byte[] Bytes)[] files =
        [
            ("cube.obj", MeshWriter.Obj(cube)),
            ("cube.ply", MeshWriter.PlyAscii(cube)),
            ("cube.ply", MeshWriter.PlyBinary(cube, bigEndian: false)),
            ("cube.ply", MeshWriter.PlyBinary(cube, bigEndian: true)),
            ("cube.stl", MeshWriter.StlAscii(cube)),
            ("cube.stl", MeshWriter.StlBinary(cube)),
            ("cube.stl", MeshWriter.StlBinary(cube, "solid")),
        ];
        foreach (var (path, bytes) in files)
            for (var length = 0; length < bytes.Length; length++)
            {
                var refused = Record.Exception(() => MeshBytes.Read(path, bytes[..length])); // any other exception fails here
                Assert.True(refused is null or ProblemException, $"{path} cut at {length}: {refused}");
                // Only a cut text can still be right: OBJ has no end mark, and the other two can lose their last line end.
                if (path != "cube.obj" && length < bytes.Length - 1 && refused is null)
                    Assert.EndsWith("endsolid mesh\n", Encoding.ASCII.GetString(bytes));
            }
    }
}
