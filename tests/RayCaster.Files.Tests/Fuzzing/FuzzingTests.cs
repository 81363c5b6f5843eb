using RayCaster.Testing.Fuzzing;

namespace RayCaster.Files.Tests.Fuzzing;

/// <summary>Whatever a file holds, it is read or refused in words: no crash, no hang, no memory beyond what is stated.</summary>
public class FuzzingTests
{
    public static TheoryData<string> KeptFiles =>
        [.. Corpus.KeptFiles(".json", ".obj", ".ply", ".stl", ".png", ".pgm", ".ppm").Select(file => file.Name)];

    /// <summary>The files that broke a promise before, and some that are made for it.</summary>
    [Theory]
    [MemberData(nameof(KeptFiles))]
    public void AKeptFileDoesNoHarm(string name) => Reading.OfFile(new(name, File.ReadAllBytes(Path.Combine(Corpus.Kept, name))));

    [Fact(Explicit = true)]
    public void SpoiltScenesDoNoHarm() => Campaign.Run("scene", 3000, random => new Mutation(random, Corpus.Scenes).Next(), Reading.OfScene);

    [Fact(Explicit = true)]
    public void SpoiltMeshesDoNoHarm() => Campaign.Run("mesh", 5000, random => new Mutation(random, Corpus.Meshes).Next(), Reading.OfMesh);

    [Fact(Explicit = true)]
    public void SpoiltPicturesDoNoHarm() => Campaign.Run("picture", 5000, random => new Mutation(random, Corpus.Pictures).Next(), Reading.OfPicture);

    /// <summary>A file that is always refused at its first byte tests nothing.</summary>
    [Fact(Explicit = true)]
    public void ManySpoiltFilesAreStillRead()
    {
        Assert.InRange(Read(Corpus.Scenes, file => SceneReader.Parse(file.Bytes, "x", Corpus.SceneFolder).Scene is not null), 50, 950);
        Assert.InRange(Read(Corpus.Meshes, file => MeshBytes.Read(file.Name, file.Bytes).Indices.Length > 0), 50, 950);
        Assert.InRange(Read(Corpus.Pictures, file => PictureFile.Read(new MemoryStream(file.Bytes)).Width > 0), 50, 950);

        static int Read(SeedFile[] seeds, Func<SeedFile, bool> read) => Enumerable.Range(0, 1000).Count(seed =>
        {
            try
            {
                return read(new Mutation(new Random(seed), seeds).Next());
            }
            catch (ProblemException)
            {
                return false;
            }
        });
    }
}
