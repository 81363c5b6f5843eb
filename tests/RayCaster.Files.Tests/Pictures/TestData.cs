namespace RayCaster.Files.Tests.Pictures;

/// <summary>Pictures that other programs wrote, by Data/make.sh.</summary>
internal static class TestData
{
    public static string Folder { get; } = ProjectFolder.PathOf("tests/RayCaster.Files.Tests/Pictures/Data");

    public static byte[] Bytes(string name) => File.ReadAllBytes(Path.Combine(Folder, name));
}
