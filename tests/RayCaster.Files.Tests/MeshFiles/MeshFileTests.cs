namespace RayCaster.Files.Tests.MeshFiles;

public sealed class MeshFileTests : IDisposable
{
    private readonly TemporaryFolder folder = new();

    [Theory]
    [InlineData("teapot.fbx", "a mesh file must be .obj, .ply or .stl, but this one is .fbx")]
    [InlineData("teapot", "a mesh file's name must end with .obj, .ply or .stl, but this one has no extension")]
    [InlineData("", "a mesh file's name must end with .obj, .ply or .stl, but this one has no extension")]
    [InlineData("a\0b.obj", "cannot be read: Null character in path. (Parameter 'path')")]
    public void NameThatIsNoMeshFileIsRefused(string path, string reason)
    {
        var refused = Assert.Throws<MeshFileException>(() => MeshFile.Read(path));
        Assert.Equal((path, reason, $"{path}: {reason}"), (refused.Path, refused.Reason, refused.Message));
        Assert.Equal((null, null), (refused.Line, refused.Offset));
    }

    [Fact]
    public void FileThatIsNotThereIsNamedWithTheFullPathThatWasTried() =>
        Assert.Equal(
            $"no-folder/box.obj: file not found; looked for {Path.GetFullPath("no-folder/box.obj")}; " +
            $"there is no folder {Path.GetFullPath("no-folder")}",
            Assert.Throws<MeshFileException>(() => MeshFile.Read("no-folder/box.obj")).Message);

    [Fact]
    public void NearestNameInTheFolderIsProposed()
    {
        folder.Write("teapot.obj", "");
        Assert.Contains("teapot.obj", Assert.Throws<MeshFileException>(() => MeshFile.Read(folder["taepot.obj"])).Reason);
    }

    [Fact]
    public void FolderIsNoFile()
    {
        var path = Directory.CreateDirectory(folder["box.obj"]).FullName;
        Assert.Equal($"{path}: is a folder, not a mesh file", Assert.Throws<MeshFileException>(() => MeshFile.Read(path)).Message);
    }

    [Fact]
    public void FileWithoutPermissionIsNamed()
    {
        var path = folder.Write("box.obj", "");
        if (OperatingSystem.IsWindows()) return;
        File.SetUnixFileMode(path, UnixFileMode.None);
        if (Environment.IsPrivilegedProcess) return; // may read everything
        Assert.Equal($"{path}: no permission to read it", Assert.Throws<MeshFileException>(() => MeshFile.Read(path)).Message);
    }

    [Fact]
    public void PlaceIsALineOfTextOrAByteOfBinaryData()
    {
        var text = Assert.Throws<MeshFileException>(() => MeshBytes.Read("a/box.obj", "v 0 0 0\nf 1 1"u8.ToArray()));
        Assert.Equal(("a/box.obj", 2, null), (text.Path, text.Line, text.Offset));
        Assert.Equal($"a/box.obj(2): {text.Reason}", text.Message);
        var binary = Assert.Throws<MeshFileException>(() => MeshBytes.Read("a/box.stl", new byte[85]));
        Assert.Equal(("a/box.stl", null, 80), (binary.Path, binary.Line, binary.Offset));
        Assert.Equal($"a/box.stl(byte 80): {binary.Reason}", binary.Message);
    }

    public void Dispose() => folder.Dispose();
}
