using System.Runtime.Versioning;

namespace RayCaster.Files.Tests.Meshes;

public sealed class MeshFileTests : IDisposable
{
    private readonly TemporaryFolder folder = new();

    [Theory]
    [InlineData("teapot.fbx", "a mesh file must be .obj, .ply or .stl, but this one is .fbx")]
    [InlineData("teapot", "a mesh file's name must end with .obj, .ply or .stl, but this one has no extension")]
    [InlineData("", "a mesh file's name must end with .obj, .ply or .stl, but this one has no extension")]
    [InlineData("a\0b.obj", "cannot be read: Null character in path. (Parameter 'path')")]
    public void NameThatIsNoMeshFileIsRefused(string path, string reason) =>
        Assert.Equal($"{path}: {reason}", Assert.Throws<ProblemException>(() => MeshFile.Read(path)).Message);

    [Fact]
    public void FileThatIsNotThereIsNamedWithTheFullPathThatWasTried() =>
        Assert.Equal(
            $"no-folder/box.obj: file not found; looked for {Path.GetFullPath("no-folder/box.obj")}; " +
            $"there is no folder {Path.GetFullPath("no-folder")}",
            Assert.Throws<ProblemException>(() => MeshFile.Read("no-folder/box.obj")).Message);

    [Fact]
    public void NearestNameInTheFolderIsProposed()
    {
        folder.Write("teapot.obj", "");
        Assert.EndsWith("; did you mean \"teapot.obj\"?", Assert.Throws<ProblemException>(() => MeshFile.Read(folder["taepot.obj"])).Message);
    }

    [Fact]
    public void FolderIsNoFile()
    {
        var path = Directory.CreateDirectory(folder["box.obj"]).FullName;
        Assert.Equal($"{path}: is a folder, not a mesh file", Assert.Throws<ProblemException>(() => MeshFile.Read(path)).Message);
    }

    [SkippableFact]
    [UnsupportedOSPlatform("windows")] // rights are others there
    public void FileWithoutPermissionIsNamed()
    {
        var path = folder.Write("box.obj", "");
        File.SetUnixFileMode(path, UnixFileMode.None);
        Skip.If(Environment.IsPrivilegedProcess, "may read everything");
        Assert.Equal($"{path}: no permission to read it", Assert.Throws<ProblemException>(() => MeshFile.Read(path)).Message);
    }

    [Theory]
    [InlineData("a.obj")]
    [InlineData("a.ply")]
    [InlineData("a.stl")]
    public void AGitLfsPointerIsNamed(string name)
    {
        using var folder = new TemporaryFolder();
        var path = folder.Write(name, "version https://git-lfs.github.com/spec/v1\noid sha256:12\nsize 9\n"u8);
        Assert.Equal($"{path}: this is only a Git LFS pointer to the file; fetch the file itself: git lfs pull",
            Assert.Throws<ProblemException>(() => MeshFile.Read(path)).Message);
    }

    public void Dispose() => folder.Dispose();
}
