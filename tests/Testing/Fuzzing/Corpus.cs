namespace RayCaster.Testing.Fuzzing;

/// <summary>The files that are corrupted: every good and broken file of the tests, and files that broke a promise before.</summary>
internal static class Corpus
{
    private const string KeptFolder = "tests/RayCaster.Files.Tests/Fuzzing/Kept";

    /// <summary>The folder for files that broke a promise; they are tests from then on.</summary>
    public static string Kept { get; } = ProjectFolder.PathOf(KeptFolder);

    /// <summary>Scene files; the meshes that they name are found from <see cref="SceneFolder"/>.</summary>
    public static SeedFile[] Scenes { get; } =
    [
        // The good ones many times over: what starts broken is rarely read to its end.
        .. Enumerable.Repeat(FilesIn("scenes", ".json").Concat(FilesIn("tests/RayCaster.Files.Tests/Good", ".json")).ToArray(), 10)
            .SelectMany(files => files),
        .. FilesIn("tests/RayCaster.Files.Tests/Broken", ".json"), .. KeptFiles(".json"),
    ];

    public static SeedFile[] Meshes { get; } =
    [
        .. MadeMeshes(), .. FilesIn("scenes/meshes", ".obj", ".stl"), .. FilesIn("tests/RayCaster.Files.Tests/Good", ".obj"),
        .. FilesIn("tests/RayCaster.Files.Tests/Broken", ".obj"), .. KeptFiles(".obj", ".ply", ".stl"),
    ];

    public static SeedFile[] Pictures { get; } =
    [
        .. FilesIn("tests/RayCaster.Files.Tests/Pictures/Data", ".png", ".pgm", ".ppm").Where(file => file.Bytes.Length < 20_000),
        .. KeptFiles(".png", ".pgm", ".ppm"),
    ];

    public static string SceneFolder { get; } = ProjectFolder.PathOf("tests/RayCaster.Files.Tests/Good");

    /// <summary>The files with some extensions that broke a promise before, and some that are made for it.</summary>
    public static IEnumerable<SeedFile> KeptFiles(params string[] extensions) => FilesIn(KeptFolder, extensions);

    /// <summary>All forms of a small mesh, with what writers of other programs add.</summary>
    private static IEnumerable<SeedFile> MadeMeshes()
    {
        var mesh = MeshGenerator.Icosphere(1);
        yield return new("a.obj", MeshWriter.Obj(mesh));
        yield return new("a.obj",
            "o cube\r\nv 0 0 0 1\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nvt 0 0\r\nvn 0 0 1\r\nf 1/1/1 2//1 3/1 \\\r\n 4\r\nf -1 -2 -3\r\n"u8.ToArray());
        yield return new("a.ply", MeshWriter.PlyAscii(mesh));
        yield return new("a.ply", MeshWriter.PlyBinary(mesh, bigEndian: false));
        yield return new("a.ply", MeshWriter.PlyBinary(mesh, bigEndian: true));
        yield return new("a.ply", MeshWriter.PlyFloat(mesh));
        yield return new("a.ply", """
            ply
            format ascii 1.0
            comment with a table that is skipped
            element vertex 3
            property float x
            property float y
            property float z
            property uchar red
            element edge 1
            property list uint8 int32 ends
            property double length
            element face 1
            property list uchar int vertex_indices
            property short flags
            end_header
            0 0 0 255
            1 0 0 255
            0 1 0 255
            2 0 1 1.5
            3 0 1 2 7

            """u8.ToArray());
        yield return new("a.stl", MeshWriter.StlAscii(mesh));
        yield return new("a.stl", MeshWriter.StlBinary(mesh));
    }

    private static IEnumerable<SeedFile> FilesIn(string folder, params string[] extensions) =>
        Directory.EnumerateFiles(ProjectFolder.PathOf(folder), "*", SearchOption.AllDirectories)
            .Where(path => extensions.Contains(Path.GetExtension(path)) && !path.Contains(".received.") && !ProjectFolder.IsOwnScene(path))
            .Order(StringComparer.Ordinal)
            .Select(path => new SeedFile(Path.GetFileName(path), File.ReadAllBytes(path)));
}

/// <param name="Name">Only the extension matters.</param>
/// <param name="Bytes">What the file holds.</param>
internal readonly record struct SeedFile(string Name, byte[] Bytes)
{
    public string Extension => Path.GetExtension(Name);
}
