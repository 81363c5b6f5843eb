using RayCaster.Cli;

namespace RayCaster.Tests.Fuzzing;

/// <summary>Whatever a file or a command line holds, it is read or refused in words: no crash, no hang, no memory beyond what is stated.</summary>
public class FuzzingTests
{
    public static TheoryData<string> KeptFiles => [.. Directory.GetFiles(Corpus.Kept).Select(path => Path.GetFileName(path)).Where(IsKept)];

    [Fact]
    public void SpoiltScenesDoNoHarm() => Campaign.Run("scene", 3000, random => new Mutation(random, Corpus.Scenes).Next(), Reading.OfScene);

    [Fact]
    public void SpoiltMeshesDoNoHarm() => Campaign.Run("mesh", 5000, random => new Mutation(random, Corpus.Meshes).Next(), Reading.OfMesh);

    [Fact]
    public void SpoiltPicturesDoNoHarm() => Campaign.Run("picture", 5000, random => new Mutation(random, Corpus.Pictures).Next(), Reading.OfPicture);

    [Fact]
    public void OddCommandLinesDoNoHarm() => Campaign.Run("command-line", 5000, OddCommandLine.Next, input => Understand(OddCommandLine.Words(input)));

    /// <summary>What is always refused at its first byte tries nothing.</summary>
    [Fact]
    public void ManySpoiltFilesAreStillRead()
    {
        Assert.InRange(Read(Corpus.Scenes, file => SceneReader.Parse(file.Bytes, "x", Corpus.SceneFolder).Scene is not null), 50, 950);
        Assert.InRange(Read(Corpus.Meshes, file => MeshFile.Parse(file.Name, file.Bytes).Indices.Length > 0), 50, 950);
        Assert.InRange(Read(Corpus.Pictures, file => PictureFile.Read(new MemoryStream(file.Bytes)).Width > 0), 50, 950); // no PFM among them

        static int Read(SeedFile[] seeds, Func<SeedFile, bool> read) => Enumerable.Range(0, 1000).Count(seed =>
        {
            try
            {
                return read(new Mutation(new Random(seed), seeds).Next());
            }
            catch (Exception e) when (e is MeshFileException or PictureFileException)
            {
                return false;
            }
        });
    }

    /// <summary>The files that once did harm, and some that are made to.</summary>
    [Theory]
    [MemberData(nameof(KeptFiles))]
    public void AKeptFileDoesNoHarm(string name) => Reading.OfFile(new(name, File.ReadAllBytes(Path.Combine(Corpus.Kept, name))));

    private static bool IsKept(string name) => !name.Contains(".received.") && !name.EndsWith(".md");

    private static void Understand(string[] words)
    {
        try
        {
            var line = CommandLine.Parse(words);
            line.PictureSize();
            line.ThreadCount();
            line.Exactly("<one>", "<other>");
        }
        catch (ProblemException e)
        {
            Assert.StartsWith("raycaster: ", e.Message);
            Assert.DoesNotContain("   at RayCaster", e.Message);
        }
    }
}
