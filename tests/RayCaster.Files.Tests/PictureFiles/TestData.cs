namespace RayCaster.Files.Tests.PictureFiles;

/// <summary>Pictures that other programs wrote, by Data/make.sh.</summary>
internal static class TestData
{
    public static string Folder { get; } = ProjectFolder.PathOf("tests/RayCaster.Files.Tests/PictureFiles/Data");

    public static byte[] Bytes(string name) => File.ReadAllBytes(Path.Combine(Folder, name));
}
