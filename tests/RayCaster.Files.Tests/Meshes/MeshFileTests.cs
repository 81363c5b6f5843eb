using System.Runtime.Versioning;

namespace RayCaster.Files.Tests.Meshes;

public sealed class MeshFileTests : InTemporaryFolder
{
    [Theory]
    [InlineData("teapot.fbx", "a mesh file must be .obj, .ply or .stl, but this one is .fbx")]
    [InlineData("teapot", "a mesh file's name must end with .obj, .ply or .stl, but this one has no extension")]
    [InlineData("", "a mesh file's name must end with .obj, .ply or .stl, but this one has no extension")]
    public void NameThatIsNoMeshFileIsRefused(string path, string reason) =>
        Assert.Equal($"{path}: {reason}", Assert.Throws<ProblemException>(() => MeshFile.Read(path)).Message);

    [Fact]
    public void FileThatIsNotThereIsNamedWithTheFullPathThatWasTried() =>
        Assert.Equal(
            $"no-folder/box.obj: file not found; looked for {Path.GetFullPath("no-folder/box.obj")}; " +
            $"there is no folder {Path.GetFullPath("no-folder")}",
            Assert.Throws<ProblemException>(() => MeshFile.Read("no-folder/box.obj")).Message);

    [Fact]
    public void FolderIsNoFile()
    {
        var path = Directory.CreateDirectory(folder["box.obj"]).FullName;
        Assert.Equal($"{path}: it is a folder, not a mesh file", Assert.Throws<ProblemException>(() => MeshFile.Read(path)).Message);
    }

    [Fact(Skip = "has other rights", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    [UnsupportedOSPlatform("windows")]
    public void FileWithoutPermissionIsNamed()
    {
        Assert.SkipWhen(Here.ReadsEverything, "this user may read everything");
        var path = folder.Write("box.obj", "");
        File.SetUnixFileMode(path, UnixFileMode.None);
        Assert.Equal($"{path}: access is denied", Assert.Throws<ProblemException>(() => MeshFile.Read(path)).Message);
    }

    [Theory]
    [InlineData("a.obj")]
    [InlineData("a.ply")]
    [InlineData("a.stl")]
    public void AnEmptyFileAndAGitLfsPointerAreNamed(string name)
    {
        Refused("", "the file is empty");
        Refused("version https://git-lfs.github.com/spec/v1\noid sha256:12\nsize 9\n",
            "it is only a Git LFS pointer to the file (fetch the file itself: git lfs pull)");

        void Refused(string text, string reason) => Assert.StartsWith($"{folder[name]}: {reason}",
            Assert.Throws<ProblemException>(() => MeshFile.Read(folder.Write(name, text))).Message);
    }

    [Theory(Skip = "the disk ignores case", SkipWhen = nameof(Here.IgnoresCase), SkipType = typeof(Here))]
    [InlineData("meshes/a.obj", "meshes", "Meshes")]
    [InlineData("meshes/Deep/a.obj", "meshes/Deep", "Meshes")]
    [InlineData("Meshes/deep/a.obj", "Meshes/deep", "Deep")]
    public void AFolderOfOtherCaseIsNamed(string file, string missing, string meant)
    {
        Directory.CreateDirectory(folder["Meshes/Deep"]);
        Assert.EndsWith($"there is no folder {folder[missing]}; did you mean \"{meant}\"? (case matters)",
            Assert.Throws<ProblemException>(() => MeshFile.Read(folder[file])).Message);
    }

}
