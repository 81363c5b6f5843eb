namespace RayCaster.Tests.Fuzzing;

/// <summary>
/// Reads any bytes as the file that they pretend to be, and holds the reader to its promises: it answers or refuses in words, and takes no more
/// memory than docs/limits.md says. What is read is drawn, too.
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
        Within(MemoryLimit.OfScene(file.Bytes.Length) + meshes * MemoryLimit.OfMesh(1000), () =>
            reading = SceneReader.Parse(file.Bytes, "scene.json", Corpus.SceneFolder));
        Assert.Equal(reading.Scene is null, reading.Problems.Any(problem => problem.IsError));
        foreach (var problem in reading.Problems)
        {
            Assert.True(problem is { Line: > 0, Column: > 0 });
            Wholesome(problem.ToString());
        }
        Wholesome(reading.Report());
        if (reading.Scene is { } scene) Draw(scene);
    }

    public static void OfMesh(SeedFile file)
    {
        var (mesh, refusal) = default((MeshData?, string?));
        Within(MemoryLimit.OfMesh(file.Bytes.Length), () => (mesh, refusal) = Parsed(file, MeshSource.UsualBlockSize));
        var (inBlocks, refusalInBlocks) = Parsed(file, blockSize: 100);
        Assert.Equal(refusal, refusalInBlocks);
        if (mesh is null)
        {
            Wholesome(refusal!);
            return;
        }
        Assert.Equal(mesh.Indices, inBlocks!.Indices);
        Assert.NotEmpty(mesh.Indices);
        Assert.All(mesh.Indices, index => Assert.InRange(index, 0, mesh.Vertices.Length - 1));
        try
        {
            var model = new MeshPlacement(new(1, 1, 1), Vector3.Zero, Vector3.Zero).Place(mesh, out _);
            Draw(new(new Camera(new(3, 2, 1), Vector3.Zero), [model]));
        }
        catch (OverflowException)
        {
            // Vertices whose turning overflows are refused in words by the scene's reader.
        }
    }

    private static (MeshData?, string?) Parsed(SeedFile file, int blockSize)
    {
        try
        {
            return (MeshFile.Parse(file.Name, file.Bytes, blockSize), null);
        }
        catch (MeshFileException e)
        {
            return (null, e.Message);
        }
    }

    public static void OfPicture(SeedFile file)
    {
        try
        {
            if (file.Extension == ".pfm")
            {
                Within(MemoryLimit.OfPicture(file.Bytes.Length, 0), () => PfmFile.Read(new MemoryStream(file.Bytes)));
                return;
            }
            Picture? picture = null;
            // A picture may be large in a small file; it is then what the limit is for, and is measured from its own size.
            var most = MemoryLimit.OfPicture(file.Bytes.Length, 1 << 26);
            Within(most, () => picture = PictureFile.Read(new MemoryStream(file.Bytes)));
            Assert.Equal(3L * picture!.Width * picture.Height, picture.Rgb.Length);
        }
        catch (PictureFileException e)
        {
            Wholesome(e.Message);
        }
    }

    /// <summary>A message is for people: short, without what moves a cursor, and no stack trace.</summary>
    public static void Wholesome(string text)
    {
        Assert.InRange(text.Length, 0, 60_000);
        Assert.DoesNotContain("   at RayCaster", text);
        Assert.DoesNotContain("Exception", text);
        foreach (var c in text) Assert.False(char.IsControl(c) && c is not ('\n' or '\t'), $"U+{(int)c:X4} in {text}");
    }

    private static void Within(long bytes, Action read)
    {
        var before = GC.GetAllocatedBytesForCurrentThread();
        try
        {
            read();
        }
        finally
        {
            var taken = GC.GetAllocatedBytesForCurrentThread() - before;
            Assert.True(taken <= bytes, $"it took {taken:N0} bytes of memory; docs/limits.md allows {bytes:N0}");
        }
    }

    /// <summary>Small, and where there is little in it also by the definition, which must give the same.</summary>
    private static void Draw(Scene scene)
    {
        if (scene.Models.Count > 2000) return;
        scene = scene with { Camera = scene.Camera.WithSize(24, 16) };
        var picture = Renderer.Render(scene, threads: 1);
        var triangles = scene.Models.Sum(model => model is Mesh mesh ? mesh.TriangleCount : 1);
        if (triangles < 200) Assert.Equal(ScalarRenderer.Render(scene).Rgb, picture.Rgb);
    }
}
