using RayCaster.Testing.Fuzzing;

namespace RayCaster.Files.Tests.Fuzzing;

/// <summary>Whatever a file holds, it is read or refused in words: no crash, no hang, no memory beyond what is stated.</summary>
public class FuzzingTests
{
    public static TheoryData<string> KeptFiles =>
        [.. Corpus.KeptFiles(".json", ".obj", ".ply", ".stl", ".png", ".pbm", ".pgm", ".ppm").Select(file => file.Name)];

    /// <summary>The files that broke a promise before, and some that are made for it.</summary>
    [Theory]
    [MemberData(nameof(KeptFiles))]
    public void AKeptFileDoesNoHarm(string name) => Reading.OfFile(new(name, File.ReadAllBytes(Path.Combine(Corpus.Kept, name))));
}
