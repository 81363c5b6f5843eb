using System.Globalization;
using System.Runtime.CompilerServices;

namespace RayCaster.Files.Tests;

/// <summary>The figures of docs/limits.md on meshes and rubrics are those of the code.</summary>
public class LimitsTests
{
    [Fact]
    public void AHeaderOfPly() => Promised("a PLY header of {0:N0} bytes", PlyHeader.MaxBytes);

    [Fact]
    public void Triangles() => Promised("{0:N0} triangles", MeshBuilder.MaxTriangles);

    [Fact]
    public void BytesOfAVertex() => Promised("its own vertices, {0} bytes each", Unsafe.SizeOf<Vector3>());

    [Fact]
    public void ARubric() => Promised("| rubric | {0:N0} bytes |", SceneReader.MaxShortBytes);

    [Fact]
    public void AHeaderOfPlyThatIsLongerIsRefused() => Assert.Equal(
        "a.ply(3): end_header is missing in the first 1048576 bytes; a header must not be longer",
        Assert.Throws<ProblemException>(() => MeshBytes.Read("a.ply",
            [.. "ply\ncomment "u8, .. new byte[PlyHeader.MaxBytes], .. "\n\n"u8])).Message);

    private static void Promised(string text, int limit) =>
        Assert.Contains(string.Format(CultureInfo.InvariantCulture, text, limit), File.ReadAllText(ProjectFolder.PathOf("docs/limits.md")));
}
