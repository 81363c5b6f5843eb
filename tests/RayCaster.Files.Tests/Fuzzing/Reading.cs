using RayCaster.Testing.Fuzzing;

namespace RayCaster.Files.Tests.Fuzzing;

/// <summary>
/// Reads any bytes as a file of some type, and checks the promises of the reader: it reads or refuses them in words, and takes no more
/// memory than docs/limits.md says.
/// </summary>
internal static class Reading
{
    /// <summary>Any file, by its extension.</summary>
    public static void OfFile(SeedFile file)
    {
        switch (file.Extension)
        {
            case ".json": OfScene(file); break;
            case ".obj" or ".ply" or ".stl": OfMesh(file); break;
            default: OfPicture(file); break;
        }
    }

    public static void OfScene(SeedFile file)
    {
        var reading = default(SceneReading)!;
        // What the named meshes take comes on top: at most once for each model, and those in reach here are small.
        var meshes = 1 + file.Bytes.AsSpan().Count("\"mesh\""u8);
        Promise.Within(MemoryLimit.OfScene(file.Bytes.Length) + meshes * MemoryLimit.OfMesh(1000), () =>
            reading = SceneReader.Parse(file.Bytes, "scene.json", Corpus.SceneFolder));
        Assert.Equal(reading.Scene is null, reading.Problems.Any(problem => problem.IsError));
        foreach (var problem in reading.Problems)
        {
            Assert.True(problem is { Line: > 0, Column: > 0 });
            Promise.Wholesome(problem.ToString());
        }
        Promise.Wholesome(reading.Report());
    }

    public static void OfMesh(SeedFile file)
    {
        var (mesh, refusal) = default((MeshData?, string?));
        Promise.Within(MemoryLimit.OfMesh(file.Bytes.Length), () => (mesh, refusal) = Parsed(file, pieceSize: 1 << 20));
        var (inPieces, refusalInPieces) = Parsed(file, pieceSize: 100);
        Assert.Equal(refusal, refusalInPieces);
        if (mesh is null)
        {
            Promise.Wholesome(refusal!);
            return;
        }
        Assert.Equal(mesh.Indices, inPieces!.Indices);
        Assert.NotEmpty(mesh.Indices);
        Assert.All(mesh.Indices, index => Assert.InRange(index, 0, mesh.Vertices.Length - 1));
        try
        {
            new MeshPlacement(new(1, 1, 1), Vector3.Zero, Vector3.Zero).Place(mesh, out _);
        }
        catch (OverflowException)
        {
            // Vertices whose turning overflows are refused in words by the scene's reader.
        }
    }

    private static (MeshData?, string?) Parsed(SeedFile file, int pieceSize)
    {
        try
        {
            return (MeshBytes.Read(file.Name, file.Bytes, pieceSize), null);
        }
        catch (ProblemException e)
        {
            return (null, e.Message);
        }
    }

    public static void OfPicture(SeedFile file)
    {
        try
        {
            Picture? picture = null;
            // What a picture takes is known when it has been read; one that is refused may have said the most that there can be.
            var before = GC.GetAllocatedBytesForCurrentThread();
            Promise.Within(
                MemoryLimit.OfPicture(file.Bytes.Length, 1 << 10, 1 << 18), () => picture = PictureFile.Read(new MemoryStream(file.Bytes)));
            var taken = GC.GetAllocatedBytesForCurrentThread() - before;
            Assert.InRange(taken, 0, MemoryLimit.OfPicture(file.Bytes.Length, picture!.Width, picture.Height));
            Assert.Equal(3L * picture!.Width * picture.Height, picture.Rgb.Length);
        }
        catch (ProblemException e)
        {
            Promise.Wholesome(e.Message);
        }
    }
}
