using System.Runtime.CompilerServices;

namespace RayCaster.Tests.PictureFiles;

/// <summary>Pictures that other programs wrote; Data/make.sh tells how.</summary>
internal static class TestData
{
    public static string Folder { get; } = Path.Combine(Path.GetDirectoryName(ThisFile())!, "Data");

    public static byte[] Bytes(string name) => File.ReadAllBytes(Path.Combine(Folder, name));

    private static string ThisFile([CallerFilePath] string path = "") => path;
}
